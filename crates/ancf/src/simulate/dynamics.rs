use std::cell::OnceCell;
use std::io;
use std::ops::ControlFlow;

use ancf_solver::dynamics::StepReport;
use ancf_solver::newton::SolveError;

use super::checkpoint::{Checkpoint, Mismatch, fingerprint};
use super::error::Error;
use super::run::{Ended, Reason, Run};
use super::simulation::Simulation;
use super::step_control::Pace;
use super::summary::Summary;
use crate::failure::{Watch, blame};
use crate::model::Dynamics;
use crate::results::{Rows, TIME};

/// The columns of a motion.
pub(crate) const OWN: [&str; 5] = ["iterations", "residual", "increment", "drift", "violation"];

/// A motion under way.
pub(crate) struct Motion<'a> {
    simulation: &'a Simulation,
    rows: Rows,
    pace: Pace<'a>,
    /// Once it is asked for.
    fingerprint: OnceCell<u64>,
}

impl<'a> Motion<'a> {
    fn new(simulation: &'a Simulation, settings: &Dynamics, rows: Rows) -> Result<Self, SolveError> {
        let Simulation { scaled, assembly, interrupt, .. } = simulation;
        let pace = Pace::new(scaled, settings, assembly, interrupt.clone())?;
        Ok(Self { simulation, rows, pace, fingerprint: OnceCell::new() })
    }

    fn checkpoint(&self, summary: &Summary, watch: &Watch) -> Checkpoint {
        let model = *self.fingerprint.get_or_init(|| fingerprint(self.simulation));
        Checkpoint::new(model, summary, watch, &self.rows, &self.pace)
    }
}

fn rows(simulation: &Simulation) -> Rows {
    Rows::new(&simulation.assembly, simulation.scales(), TIME, &OWN)
}

impl<'a> Run<'a> {
    /// Steps through a motion, recording its instants.
    pub(crate) fn dynamics(&mut self, simulation: &'a Simulation, settings: &Dynamics) -> Ended {
        let rows = rows(simulation);
        self.observer.begin(&rows.columns())?;
        match Motion::new(simulation, settings, rows) {
            Ok(motion) => self.follow(motion),
            Err(error) => {
                let blame = blame(self.assembly, &self.assembly.initial(), 1.0, &error);
                Ok(Err(Reason::Motion(error, blame)))
            }
        }
    }

    /// The motion of a checkpoint, which begins as it did, and is then put where it was.
    pub(crate) fn restored(
        &mut self,
        simulation: &'a Simulation,
        settings: &Dynamics,
        from: &Checkpoint,
    ) -> Result<Motion<'a>, Error> {
        from.check(simulation)?;
        let motion = Motion::new(simulation, settings, rows(simulation));
        let mut motion = motion.map_err(|_| Mismatch::Damaged)?;
        from.restore(&mut self.summary, &mut self.watch, &mut motion.rows, &mut motion.pace)?;
        Ok(motion)
    }

    /// Goes on with a motion.
    pub(crate) fn go_on(&mut self, motion: Motion<'a>) -> Ended {
        self.observer.begin(&motion.rows.columns())?;
        self.follow(motion)
    }

    fn follow(&mut self, mut motion: Motion<'a>) -> Ended {
        let ended = self.steps(&mut motion)?;
        if !matches!(ended, Ok(ControlFlow::Continue(()))) {
            let Self { observer, summary, watch, .. } = self;
            observer.last_checkpoint(&|| motion.checkpoint(summary, watch))?;
        }
        Ok(ended)
    }

    fn steps(&mut self, motion: &mut Motion<'a>) -> Ended {
        loop {
            let flow = match motion.pace.due() {
                Some(report) => {
                    let flow = self.record(motion, &report)?;
                    let steps = self.summary.steps;
                    self.watch.look(self.assembly, motion.pace.dynamics().state(), steps);
                    flow
                }
                None => ControlFlow::Continue(()),
            };
            let Self { observer, summary, watch, .. } = self;
            observer.checkpoint(&|| motion.checkpoint(summary, watch))?;
            let pace = &mut motion.pace;
            if flow.is_break() {
                // A sink that breaks on the last instant has stopped nothing.
                return Ok(Ok(if pace.is_over() { ControlFlow::Continue(()) } else { flow }));
            }
            let advanced = pace.advance(|step| summary.count(step));
            summary.time = pace.dynamics().state().t;
            match advanced {
                Ok(true) => {}
                Ok(false) => return Ok(Ok(ControlFlow::Continue(()))),
                Err(error) => {
                    let s = pace.dynamics().state();
                    let blame = blame(self.assembly, s, s.load, &error);
                    return Ok(Err(Reason::Motion(error, blame)));
                }
            }
        }
    }

    fn record(&mut self, motion: &mut Motion<'a>, report: &StepReport) -> io::Result<ControlFlow<()>> {
        let Motion { rows, pace, .. } = motion;
        let StepReport { iterations, residual, increment, drift, violation, .. } = *report;
        let own = [f64::from(iterations), residual, increment, drift, violation];
        let dynamics = pace.dynamics();
        let s = dynamics.state();
        let (t, energy) = (s.t * self.summary.scales.time, dynamics.energy());
        let row = rows.fill(self.assembly, s, t, &own, energy, Some(dynamics.energy_exchange()));
        let flow = self.observer.record(row, s)?;
        pace.recorded();
        Ok(flow)
    }
}
