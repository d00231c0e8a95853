use ancf_solver::equations::State;
use ancf_solver::newton::SolveError;
use ancf_solver::statics::LoadRates;

use crate::assembly::Assembly;
use crate::results::{AngleRates, Rows};

/// Counter of the turns of joint angles in statics.
pub(crate) struct TurnCounter<'a> {
    assembly: &'a Assembly,
    /// Rates with respect to the load factor; `None` if no turns are counted.
    rates: Option<LoadRates>,
}

impl<'a> TurnCounter<'a> {
    pub(crate) fn new(assembly: &'a Assembly, rows: &Rows) -> Result<Self, SolveError> {
        let rates = rows.counts_turns().then(|| LoadRates::new(assembly.system.matrix(), &assembly.rest()));
        Ok(Self { assembly, rates: rates.transpose()? })
    }

    /// Counts the turns up to an equilibrium. Rates are those without contacts.
    pub(crate) fn count(&mut self, rows: &mut Rows, s: &State) {
        if let Some(rates) = &mut self.rates {
            let s = rates.evaluate(&self.assembly.system, s);
            rows.count_turns(s.load, s, AngleRates::Velocities);
        }
    }
}
