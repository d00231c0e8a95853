use std::collections::BTreeSet;
use std::fmt;

/// Redundant joint equation. Its multiplier is shared with the equations on which it depends.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Redundant {
    /// Name of the joint or coupling: the last one of the dependent equations. Couplings follow joints.
    pub joint: String,
    /// True for a coupling.
    pub coupling: bool,
    /// Equation, such as "hinge axis, second equation".
    pub equation: String,
    /// Names of the joints, then of the couplings, on which the equation depends.
    pub with: Vec<String>,
}

/// Redundancy of the joint equations in the reference state.
#[derive(Clone, Debug, Default)]
pub(crate) struct Redundancy {
    pub(crate) equations: Vec<Redundant>,
    /// Number of constraint equations minus their rank.
    pub(crate) rank_deficiency: usize,
    /// Multipliers that redundant equations do not determine.
    pub(crate) undetermined: BTreeSet<usize>,
}

impl fmt::Display for Redundant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.coupling { "coupling" } else { "joint" };
        match self.coupling {
            true => write!(f, "{kind} `{}`", self.joint)?,
            false => write!(f, "{kind} `{}`: {}", self.joint, self.equation)?,
        }
        // What a coupling follows from may be a coupling too.
        match (self.with.as_slice(), self.coupling) {
            ([], _) => write!(f, ", constrains nothing that can move"),
            ([one], false) => write!(f, ", follows from joint `{one}`"),
            ([one], true) => write!(f, ", follows from `{one}`"),
            ([first @ .., last], _) => {
                let joints = if self.coupling { "" } else { "joints " };
                let first: Vec<String> = first.iter().map(|name| format!("`{name}`")).collect();
                write!(f, ", follows from {joints}{} and `{last}`", first.join(", "))
            }
        }
    }
}
