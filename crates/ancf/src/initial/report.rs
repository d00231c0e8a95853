use serde::{Deserialize, Serialize};

use crate::errors::short;

/// Report of the state from which an analysis starts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
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
    /// Given state, such as that of another run.
    Given {
        /// Description of its origin.
        source: String,
        /// Largest displacement by the projection of the positions onto the constraints, in the user's units.
        moved: f64,
        /// Kinetic energy of the correction of the velocities, relative to that of the given velocities.
        corrected: f64,
    },
    /// Given state that statics releases to an equilibrium.
    Released {
        /// Description of its origin.
        source: String,
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
            Self::Given { source, moved, corrected } => format!(
                "{source}, positions moved by up to {} and velocities changed by {} % of the kinetic energy to satisfy the \
                 constraints",
                short(*moved),
                short(100.0 * corrected)
            ),
            Self::Released { source } => {
                format!("{source}, from which the load factor releases the model to its equilibrium")
            }
        }
    }
}
