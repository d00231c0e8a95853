//! All tables of the report.

use super::table::PaperTable;
use super::{comparison, printed};
use crate::results::PaperResults;

/// All tables, each under the name of its file.
#[derive(Clone, Debug)]
pub struct PaperTables {
    /// Comparison with the printed numbers.
    pub verdict: PaperTable,
    /// T_ND.
    pub table3: PaperTable,
    /// Analysis time of the cantilever.
    pub table4: PaperTable,
    /// Analysis time of the cantilever, other programs.
    pub peers: PaperTable,
    /// Mean deflection of the cantilever.
    pub table5: PaperTable,
    /// Revolute pendulum.
    pub table6: PaperTable,
    /// Analysis time of the spherical pendulum.
    pub table7: PaperTable,
    /// Factors of the gain.
    pub gain: PaperTable,
    /// Both forms with the same physical step.
    pub same_step: PaperTable,
    /// Iterations under each stopping rule.
    pub tolerances: PaperTable,
    /// Condition numbers, both moduli.
    pub conditioning: PaperTable,
    /// Consequences of the candidates for g.
    pub gravity: PaperTable,
    /// Table 5 with two values of g.
    pub table5_gravity: PaperTable,
}

impl PaperTables {
    /// Creates the tables of the results.
    pub fn new(results: &PaperResults) -> Self {
        Self {
            verdict: comparison::verdict(&results.verdict),
            table3: printed::table3(&results.table3),
            table4: printed::table4(&results.table4),
            peers: printed::other_programs(&results.table4),
            table5: printed::table5(&results.table5),
            table6: printed::table6(&results.table6),
            table7: printed::table7(&results.table7.seconds),
            gain: comparison::gain(&results.gain),
            same_step: comparison::same_step(&results.gain),
            tolerances: comparison::tolerances(&results.tolerances),
            conditioning: comparison::conditioning(results),
            gravity: comparison::gravity(results),
            table5_gravity: comparison::table5_gravity(&results.table5, &results.gravity.table5_with_981),
        }
    }

    /// Returns all tables.
    pub fn iter(&self) -> impl Iterator<Item = &PaperTable> {
        [
            &self.verdict,
            &self.table3,
            &self.table4,
            &self.peers,
            &self.table5,
            &self.table6,
            &self.table7,
            &self.gain,
            &self.same_step,
            &self.tolerances,
            &self.conditioning,
            &self.gravity,
            &self.table5_gravity,
        ]
        .into_iter()
    }
}
