use super::connections::Connections;
use super::contacts::contact_warnings;
use super::corners::corner_warnings;
use super::locking::locking_warnings;
use super::plausibility::unit_warnings;
use super::prestrained_modes::prestrain_warning;
use super::shells::{gap_warnings, thickness_warnings};
use super::time_resolution::time_warnings;
use crate::assembly::gas_warnings;
use crate::model::Model;

/// Warnings that follow from a valid model without its analysis, one sentence each.
pub(crate) fn model_warnings(model: &Model) -> Vec<String> {
    let mut warnings = unit_warnings(model);
    warnings.extend(Connections::new(model).falling());
    warnings.extend(locking_warnings(model));
    warnings.extend(corner_warnings(model));
    warnings.extend(thickness_warnings(model));
    warnings.extend(gap_warnings(model));
    warnings.extend(time_warnings(model));
    warnings.extend(prestrain_warning(model));
    warnings.extend(gas_warnings(model));
    warnings.extend(contact_warnings(model));
    warnings
}
