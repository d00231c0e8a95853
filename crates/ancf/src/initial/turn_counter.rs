use ancf_solver::equations::{State, System};
use ancf_solver::newton::SolveError;
use ancf_solver::statics::LoadRates;

use crate::results::{AngleRates, Rows};

/// Counter of the turns of joint angles in statics.
pub(crate) struct TurnCounter<'a> {
    system: &'a System,
    /// Rates with respect to the load factor; `None` if no turns are counted.
    rates: Option<LoadRates>,
}

impl<'a> TurnCounter<'a> {
    /// Counter along the equilibria of equations from a state.
    pub(crate) fn new(system: &'a System, start: &State, rows: &Rows) -> Result<Self, SolveError> {
        let rates = rows.counts_turns().then(|| LoadRates::new(system.matrix(), start));
        Ok(Self { system, rates: rates.transpose()? })
    }

    /// Counts the turns up to an equilibrium. Rates are those without contacts, or differences where the stiffness without contacts is
    /// singular.
    pub(crate) fn count(&mut self, rows: &mut Rows, s: &State) {
        if let Some(rates) = &mut self.rates {
            match rates.evaluate(self.system, s) {
                Some(moving) => rows.count_turns(s.load, moving, AngleRates::Velocities),
                None => rows.count_turns(s.load, s, AngleRates::Differences),
            }
        }
    }
}
