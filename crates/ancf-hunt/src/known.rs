//! Known defects, by which findings are sorted.

use ancf::Model;

use crate::compare::Finding;

/// Known defect: findings for which the predicate is true are counted, but do not fail a hunt.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// Name of the defect.
    pub name: &'static str,
    /// True for findings of the defect.
    pub is_cause: fn(&Model, &Finding) -> bool,
}

/// Known defects. An entry without findings in the test is an error: remove it when the defect is corrected.
pub const KNOWN: &[Known] = &[];

/// Known defect of a finding.
pub fn cause(model: &Model, finding: &Finding) -> Option<&'static str> {
    KNOWN.iter().find(|known| (known.is_cause)(model, finding)).map(|known| known.name)
}
