use std::ops::ControlFlow;

use ancf_mechanics::bodies::BodyTerms;
use ancf_solver::equations::{EquationsOfMotion, State, System};
use ancf_solver::newton::{
    EquilibriumError, Interrupt, Newton, NewtonReport, SolveError, SolveFailure, StopRule,
};
use ancf_solver::statics::{
    Equilibrium, LoadIncrements, LoadStepper, Stability, load_rate, solve_regularised,
};

use super::start_state::{StartState, require_alignment};
use super::static_start::StaticStart;
use crate::assembly::Assembly;
use crate::failure::{RunFailure, find_cause, require_support};
use crate::model::{Model, Statics};
use crate::units::{ScaleChoice, Scales};

/// Search for the equilibrium of a model under all its loads.
pub(crate) struct EquilibriumSearch<'a> {
    /// Model in solver units, and its scales.
    pub(crate) model: &'a Model,
    pub(crate) scales: Scales,
    pub(crate) assembly: &'a Assembly,
    pub(crate) settings: &'a Statics,
    pub(crate) interrupt: &'a Interrupt,
    /// State from which the search starts; the undeformed state by default.
    pub(crate) given: Option<&'a StartState>,
}

impl EquilibriumSearch<'_> {
    /// Returns the equilibrium. `each` receives the start of the load increments and every equilibrium.
    ///
    /// A model without support may be supported by its loads, such as a hanging rope.
    ///
    /// # Errors
    /// If a motion is unsupported, or the equilibrium is not found.
    pub(crate) fn run(&self, each: &mut Each<'_>) -> Result<State, RunFailure> {
        let StaticStart { state, system } =
            StaticStart::new((self.model, self.settings.load), self.assembly, self.given)?;
        match require_support(self.assembly, &state, self.scales) {
            Ok(()) => self.loaded(&system, state, each),
            Err(free) if self.given.is_some() => Err(free),
            Err(free) => self.supported_by_loads(state, free, each),
        }
    }

    /// Returns the equilibrium by load increments from a state.
    fn loaded(&self, system: &System, start: State, each: &mut Each<'_>) -> Result<State, RunFailure> {
        each(&start, None);
        let mut statics = load_stepper(system, self.settings, start, self.interrupt)?;
        let ended = statics.advance(self.settings.load, |s, found| {
            each(s, Some(found));
            ControlFlow::Continue(())
        });
        let state = statics.state();
        ended.map_err(|error| equilibrium_failure(self.assembly, state, error))?;
        require_alignment(self.assembly, state)?;
        Ok(state.clone())
    }

    /// Returns the equilibrium of a model without support. `free` is the failure if loads do not support it either.
    fn supported_by_loads(
        &self,
        start: State,
        free: RunFailure,
        each: &mut Each<'_>,
    ) -> Result<State, RunFailure> {
        let rate = self.rate(&start);
        let mut best: Option<Candidate> = None;
        for factor in RATES {
            let (settled, report) = match self.regularised(start.clone(), factor * rate) {
                Ok(found) => found,
                Err(error) if error.failure == SolveFailure::Interrupted => return Err(error.into()),
                Err(_) => continue,
            };
            require_support(self.assembly, &settled, self.scales)?;
            let unstable =
                Stability::new(&self.assembly.system, &settled).map(|stability| stability.unstable);
            let energy = self.assembly.system.energy(&settled).total();
            // Of positions with the same or an unknown stability, that with less energy is more stable.
            let rank = (unstable.unwrap_or(1), energy);
            if best.as_ref().is_none_or(|(.., least)| rank < *least) {
                best = Some((settled, report, unstable, rank));
            }
            if unstable == Some(0) {
                break;
            }
        }
        let Some((settled, NewtonReport { iterations, residual, increment, floor }, unstable, _)) = best
        else {
            return Err(free);
        };
        let energy = self.assembly.system.energy(&settled);
        let found = Equilibrium { iterations, attempts: 1, residual, increment, floor, unstable, energy };
        each(&settled, Some(&found));
        match self.assembly.system.with_active_terms(&settled) {
            Some(_) => self.loaded(&self.assembly.system, settled, each),
            None => Ok(settled),
        }
    }

    /// Circular frequency of motions under the loads over the length of the model. A body of length L under gravity has the rate
    /// √(g/L), the inverse time of the automatic scales.
    fn rate(&self, start: &State) -> f64 {
        let (system, length) = (&self.assembly.system, self.model.length());
        let loaded = State { load: self.settings.load, ..start.clone() };
        let coordinates = |body: &BodyTerms| {
            body.vectors(start).iter().flat_map(|vector| vector.first..vector.first + 3).collect()
        };
        let bodies = self.assembly.bodies().map(|(_, body)| coordinates(body));
        let of_loads = load_rate(system, &mut system.matrix(), &loaded, length, bodies);
        let automatic =
            Model { scales: ScaleChoice::Auto, ..self.model.clone() }.scales().scales.time.recip();
        let has_gravity = self.model.gravity != [0.0; 3];
        if of_loads.is_normal() && (!has_gravity || of_loads > GRAVITY * automatic) {
            of_loads
        } else {
            automatic
        }
    }

    /// Returns the equilibrium of a model that is supported by its loads only, without contacts.
    fn regularised(&self, mut s: State, rate: f64) -> Result<(State, NewtonReport), SolveError> {
        s.load = self.settings.load;
        let newton = Newton::new(self.assembly.system.matrix(), REGULARISED_STOP, REGULARISED_ITERATIONS)?;
        let mut newton = newton.with_interrupt(self.interrupt.clone());
        let mut solve = |rate| solve_regularised(&self.assembly.system, &mut newton, &mut s, rate);
        let report = match solve(rate) {
            // Loads in balance, such as the pretension of a line, can give a frequency far above that of the slow motions.
            Err(SolveError { failure: SolveFailure::NotConverged | SolveFailure::Stagnated, .. }) => {
                solve(SLOWER * rate)?
            }
            other => other?,
        };
        Ok((s, report))
    }
}

/// Equilibrium with the report of its iteration, its number of unstable directions if known, and its rank: lower is more stable.
type Candidate = (State, NewtonReport, Option<usize>, (usize, f64));

/// Receiver of the start of load increments, and of every equilibrium with its report.
pub(crate) type Each<'a> = dyn FnMut(&State, Option<&Equilibrium>) + 'a;

/// Stopping rule of the regularised iteration, close to rounding. Residual forces would appear as stiffness.
const REGULARISED_STOP: StopRule = StopRule::Energy(1e-14);
/// Frequencies of the regularisation relative to that of the loads. A larger one is slower, and less likely to reach an unstable
/// equilibrium.
const RATES: [f64; 7] = [1.0, 1.5, 2.5, 4.0, 8.0, 16.0, 32.0];
/// Ratio of the frequencies of a second iteration, from the end of one that converged too slowly, and of the first.
const SLOWER: f64 = 0.1;
/// Ratio of the rate of all loads to that of gravity up to which gravity is the load.
const GRAVITY: f64 = 2.0;
/// Maximum number of regularised iterations. Their convergence is slow.
const REGULARISED_ITERATIONS: u32 = 1000;

/// Load increments of an analysis from a state.
pub(crate) fn load_stepper<'a>(
    system: &'a System,
    settings: &Statics,
    start: State,
    interrupt: &Interrupt,
) -> Result<LoadStepper<'a, System>, SolveError> {
    let Statics { first, largest, unstable, stop, max_iterations, .. } = *settings;
    let increments =
        LoadIncrements { first, largest, unstable: unstable.into(), ..LoadIncrements::default() };
    let newton = Newton::new(system.matrix(), stop.into(), max_iterations)?;
    Ok(LoadStepper::new(system, newton.with_interrupt(interrupt.clone()), increments, start))
}

/// Failure beyond the last equilibrium `s`, with its cause.
pub(crate) fn equilibrium_failure(assembly: &Assembly, s: &State, error: EquilibriumError) -> RunFailure {
    let cause = find_cause(assembly, s, error.load, &error.cause);
    RunFailure::Equilibrium(error, cause)
}
