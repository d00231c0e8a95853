//! The non-dimensional form of Kim et al. (2017).

use ancf::Model;
use ancf::model::{ScaleChoice, Slopes, Step};

use crate::common::models::rod;

/// The non-dimensional form of Kim et al. (2017): units of table 3, length-valued slopes.
pub(super) fn non_dimensional(mut model: Model) -> Model {
    model.scales = ScaleChoice::Paper;
    rod::beam(&mut model).slopes = Slopes::Length;
    model
}

/// The non-dimensional form with the step that the paper gives it: 0.001 of its own unit of time, and as many as fit into the
/// duration.
pub(super) fn non_dimensional_step(model: Model) -> Model {
    let mut model = non_dimensional(model);
    let step = 1e-3 * model.scales().scales.time;
    let settings = rod::settings(&mut model);
    (settings.step, settings.duration) = (Step::Fixed(step), (settings.duration / step).floor() * step);
    model
}
