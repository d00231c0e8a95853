use serde::{Deserialize, Serialize};

/// Second solution from which the errors of a model with shells follow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FinerMesh {
    /// Number of elements of all bodies on the finer mesh: four for each of a shell, two for each of a beam. `None` without a second
    /// solution.
    #[serde(default)]
    pub elements: Option<usize>,
    /// Order of convergence p: error = change · 2^p/(2^p − 1). `None` if it is not known.
    #[serde(default)]
    pub order: Option<f64>,
    /// Reason for which the error is an order of magnitude or not known.
    #[serde(default)]
    pub reason: Option<String>,
}

impl FinerMesh {
    /// End of the sentence on the largest error of a model.
    pub(in crate::estimate) fn ending(&self, is_divided: bool) -> String {
        let elements = self
            .elements
            .map_or_else(String::new, |count| format!("; from a second solution with {count} elements"));
        let reason = self.reason.as_ref().map_or_else(String::new, |reason| format!("; {reason}"));
        let share = if is_divided { "" } else { "; not divided among the bodies" };
        format!("{elements}{reason}{share}")
    }
}
