use super::{Simulation, dynamics, eigen, equilibria};
use crate::model::Analysis;
use crate::rows::{Column, LOAD, TIME, columns};

impl Simulation {
    /// The columns of its rows.
    pub fn columns(&self) -> Vec<Column> {
        let assembly = &self.assembly;
        match &self.scaled.analysis {
            Analysis::Dynamics(_) => columns(assembly, TIME, &dynamics::OWN),
            Analysis::Statics(_) => columns(assembly, LOAD, &equilibria::OWN),
            Analysis::Path(_) => {
                columns(assembly, LOAD, &[equilibria::OWN.as_slice(), &equilibria::PATH].concat())
            }
            Analysis::Modes(_) => eigen::columns(assembly, &eigen::MODES),
            Analysis::Buckling(_) => eigen::columns(assembly, &eigen::BUCKLING),
        }
    }
}
