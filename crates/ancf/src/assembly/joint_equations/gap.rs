use ancf_solver::equations::State;

use crate::model::{End, Joint, Model};

/// A model whose gaps were closed, in the units of the assembly.
#[derive(Clone, Debug)]
pub struct Closed {
    /// The closed state, at rest and without loads.
    pub state: State,
    /// Name and distance of the places of each joint that was open.
    pub gaps: Vec<(String, f64)>,
    /// Name of each body that moved, and the largest displacement of its nodes.
    pub moved: Vec<(String, f64)>,
}

/// What a joint does with the gap between its places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Gap {
    /// It stays.
    Kept,
    /// It closes with the load factor.
    Drawn,
    /// It is closed.
    Closed,
}

impl Model {
    /// What a joint does with its gap in the analysis.
    pub(crate) fn gap(&self, joint: &Joint) -> Gap {
        let moves = self.analysis.dynamics().is_some();
        let is_drawn = matches!(joint.ends().1, End::Point(_)) && !(moves && self.assemble);
        match () {
            () if is_drawn => Gap::Drawn,
            () if self.assemble => Gap::Closed,
            () => Gap::Kept,
        }
    }
}
