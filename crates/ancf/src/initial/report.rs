use serde::{Deserialize, Serialize};

/// Report of the state from which a motion starts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "from", rename_all = "snake_case")]
pub enum InitialReport {
    /// Equilibrium at t = 0.
    Equilibrium {
        /// Number of load increments.
        increments: u64,
        /// Number of Newton iterations, including failed attempts.
        iterations: u64,
        /// Number of unstable directions; `None` if it was not determined.
        unstable: Option<usize>,
    },
}

impl InitialReport {
    /// Description, such as "equilibrium at t = 0, 2 load increments, 9 Newton iterations".
    pub fn sentence(&self) -> String {
        let counted = |count: u64, what: &str| match count {
            1 => format!("1 {what}"),
            _ => format!("{count} {what}s"),
        };
        match self {
            Self::Equilibrium { increments, iterations, unstable } => {
                let kind = if unstable.is_some_and(|count| count > 0) {
                    "unstable equilibrium"
                } else {
                    "equilibrium"
                };
                format!(
                    "{kind} at t = 0, {}, {}",
                    counted(*increments, "load increment"),
                    counted(*iterations, "Newton iteration")
                )
            }
        }
    }
}
