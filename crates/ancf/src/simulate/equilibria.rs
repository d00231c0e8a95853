use std::io;
use std::ops::ControlFlow;

use ancf_solver::equations::State;
use ancf_solver::newton::{EquilibriumError, Interrupt, Newton, SolveError, StopRule};
use ancf_solver::statics::{
    ArcLengthSteps, EndConditions, Equilibrium, LimitPoint, LoadIncrements, PathPoint, solve_regularised,
};

use super::outcome::mechanism;
use super::run::{Ended, Reason, Run};
use crate::assembly::Assembly;
use crate::failure::{blame, unloaded};
use crate::model::{Model, Path, Statics};
use crate::results::{LOAD, Rows};
use crate::units::ScaleChoice;

/// The columns of an equilibrium; those of a path besides.
pub(crate) const OWN: [&str; 4] = ["iterations", "residual", "increment", "unstable"];
pub(crate) const PATH: [&str; 3] = ["length", "slope", "limit"];

/// The values of [`OWN`]. `unstable` is not a number where the factors do not tell.
fn own(found: &Equilibrium) -> [f64; 4] {
    let unstable = found.unstable.map_or(f64::NAN, |count| count as f64);
    [f64::from(found.iterations), found.residual, found.increment, unstable]
}

/// The equilibrium under all loads by the default settings, from a state on.
pub(crate) fn equilibrium(assembly: &Assembly, start: State, interrupt: &Interrupt) -> Result<State, Reason> {
    let Statics { stop, max_iterations, .. } = Statics::default();
    let newton = Newton::new(assembly.system.matrix(), stop.into(), max_iterations)?;
    let newton = newton.with_interrupt(interrupt.clone());
    let mut statics =
        ancf_solver::statics::LoadStepper::new(&assembly.system, newton, LoadIncrements::default(), start);
    statics.advance(1.0, |_, _| ControlFlow::Continue(()))?;
    Ok(statics.state().clone())
}

/// Down to rounding: what is left of the loads would be taken for stiffness.
const SETTLED: StopRule = StopRule::Energy(1e-14);
/// Iterations until then, of which each may gain little.
const SETTLING: u32 = 1000;

/// The equilibrium of a model that nothing may hold but its loads, without contacts.
pub(crate) fn settled(
    assembly: &Assembly,
    model: &Model,
    mut s: State,
    interrupt: &Interrupt,
) -> Result<State, SolveError> {
    // Weight swings a body of length L by the rate √(g/L), which is that of the automatic scales.
    let own = Model { scales: ScaleChoice::Auto, ..model.clone() }.scales().scales;
    s.load = 1.0;
    let newton = Newton::new(assembly.system.matrix(), SETTLED, SETTLING)?;
    let mut newton = newton.with_interrupt(interrupt.clone());
    solve_regularised(&assembly.system, &mut newton, &mut s, own.time.recip())?;
    Ok(s)
}

impl Run<'_> {
    /// Whether nothing is free to move; else why there is no equilibrium.
    pub(crate) fn held(&self, s: &State) -> Result<(), Reason> {
        let motions = mechanism(self.assembly, s, self.summary.scales);
        motions.map_or(Ok(()), |motions| Err(Reason::Mechanism(motions)))
    }

    fn count_equilibrium(&mut self, load: f64, found: &Equilibrium) {
        let summary = &mut self.summary;
        summary.time = load;
        summary.steps += 1;
        summary.divided_steps += u64::from(found.attempts > 1);
        summary.floor_steps += u64::from(found.floor);
        summary.iterations += u64::from(found.iterations);
        summary.most_iterations = summary.most_iterations.max(found.iterations);
    }

    /// Loads a model step by step, recording every equilibrium.
    pub(crate) fn statics(&mut self, settings: &Statics) -> Ended {
        let assembly = self.assembly;
        let mut rows = Rows::new(assembly, self.summary.scales, LOAD, &OWN);
        self.observer.begin(&rows.columns())?;
        let start = unloaded(assembly);
        if let Err(reason) = self.held(&start) {
            return Ok(Err(reason));
        }
        let increments = LoadIncrements { first: settings.first, ..LoadIncrements::default() };
        let matrix = assembly.system.matrix();
        let newton = match Newton::new(matrix, settings.stop.into(), settings.max_iterations) {
            Ok(newton) => newton.with_interrupt(self.interrupt.clone()),
            Err(error) => return Ok(Err(error.into())),
        };
        let mut statics = ancf_solver::statics::LoadStepper::new(&assembly.system, newton, increments, start);
        if let Err(error) = statics.include_near_terms() {
            return Ok(Err(error.into()));
        }
        let (none, energy) = (own(&Equilibrium::default()), statics.energy());
        let first = rows.fill(assembly, statics.state(), 0.0, &none, energy, None);
        let mut written = self.observer.record(first, statics.state());
        if flow(&written).is_break() {
            return conclude(written?, false, Ok::<_, Reason>(()));
        }
        let ended = statics.advance(settings.load, |s, found| {
            self.count_equilibrium(s.load, found);
            written =
                self.observer.record(rows.fill(assembly, s, s.load, &own(found), found.energy, None), s);
            flow(&written)
        });
        let ended = ended.map_err(|error| blamed(assembly, statics.state(), error));
        conclude(written?, settings.load == self.summary.time, ended)
    }

    /// Follows a path of equilibria, recording every point.
    pub(crate) fn path(&mut self, settings: &Path) -> Ended {
        let assembly = self.assembly;
        let mut rows = Rows::new(assembly, self.summary.scales, LOAD, &[OWN.as_slice(), &PATH].concat());
        self.observer.begin(&rows.columns())?;
        let start = unloaded(assembly);
        if let Err(reason) = self.held(&start) {
            return Ok(Err(reason));
        }
        let steps = ArcLengthSteps { largest: settings.largest, ..ArcLengthSteps::from(settings.first) };
        let system = &assembly.system;
        let newton = Newton::new(system.matrix(), settings.stop.into(), settings.max_iterations);
        let begun = newton
            .map_err(Reason::from)
            .map(|newton| newton.with_interrupt(self.interrupt.clone()))
            .and_then(|newton| {
                ancf_solver::statics::ArcLength::new(system, newton, steps, start).map_err(Reason::from)
            });
        let mut path = match begun {
            Ok(path) => path,
            Err(reason) => return Ok(Err(reason)),
        };
        let none = [own(&Equilibrium::default()).as_slice(), &[0.0; 3]].concat();
        let first = rows.fill(assembly, path.state(), 0.0, &none, path.energy(), None);
        let mut written = self.observer.record(first, path.state());
        if flow(&written).is_break() {
            return conclude(written?, false, Ok::<_, Reason>(()));
        }
        let until =
            EndConditions { load: Some(settings.load), points: settings.points, length: f64::INFINITY };
        let ended = path.follow(&until, |s, point| {
            self.count_equilibrium(s.load, &point.equilibrium);
            let (own, energy) = (of_point(point), point.equilibrium.energy);
            written = self.observer.record(rows.fill(assembly, s, s.load, &own, energy, None), s);
            flow(&written)
        });
        let ended = ended.map_err(|error| blamed(assembly, path.state(), error));
        conclude(written?, settings.load == self.summary.time, ended)
    }
}

/// An equilibrium that was not found, beyond a state that was.
fn blamed(assembly: &Assembly, s: &State, error: EquilibriumError) -> Reason {
    let blame = blame(assembly, s, error.load, &error.cause);
    Reason::Equilibrium(error, blame)
}

/// The values of [`OWN`] and [`PATH`]; `limit` is 1 at a maximum of the load, −1 at a minimum, 0 elsewhere.
fn of_point(point: &PathPoint) -> Vec<f64> {
    let limit = match point.limit {
        None => 0.0,
        Some(LimitPoint::Maximum) => 1.0,
        Some(LimitPoint::Minimum) => -1.0,
    };
    [own(&point.equilibrium).as_slice(), &[point.length, point.slope, limit]].concat()
}

fn flow(written: &io::Result<ControlFlow<()>>) -> ControlFlow<()> {
    written.as_ref().map_or(ControlFlow::Break(()), |flow| *flow)
}

/// A sink that breaks on the last equilibrium has stopped nothing.
fn conclude<T, E: Into<Reason>>(written: ControlFlow<()>, done: bool, ended: Result<T, E>) -> Ended {
    Ok(match ended {
        Err(error) => Err(error.into()),
        Ok(_) if done => Ok(ControlFlow::Continue(())),
        Ok(_) => Ok(written),
    })
}
