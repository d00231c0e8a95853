use std::ops::ControlFlow;

use super::blame::blame;
use super::pace::Pace;
use super::{Ended, Observer, Reason, Run};
use crate::analysis::{self, StepReport};
use crate::model::{Dynamics, Model};
use crate::rows::{Rows, TIME};
use crate::system::System;

/// The columns of a motion.
const OWN: [&str; 5] = ["iterations", "residual", "increment", "drift", "violation"];

impl Run<'_> {
    /// Steps through a motion, recording its instants.
    pub(super) fn dynamics(&mut self, model: &Model, settings: &Dynamics) -> Ended {
        let (assembly, scales) = (self.assembly, self.summary.scales);
        let mut rows = Rows::new(assembly, scales, TIME, &OWN);
        self.observer.begin(rows.columns())?;
        let mut pace = match Pace::new(model, settings, assembly, self.interrupt.clone()) {
            Ok(pace) => pace,
            Err(error) => {
                let blame = blame(assembly, &assembly.initial(), 1.0, &error);
                return Ok(Err(Reason::Motion(error, blame)));
            }
        };
        let mut record =
            |observer: &mut dyn Observer, dynamics: &analysis::Dynamics<'_, System>, report: &StepReport| {
                let StepReport { iterations, residual, increment, drift, violation, .. } = *report;
                let own = [f64::from(iterations), residual, increment, drift, violation];
                let s = dynamics.state();
                let (t, energy) = (s.t * scales.time, dynamics.energy());
                observer.record(rows.fill(assembly, s, t, &own, energy, Some(dynamics.exchanged())), s)
            };
        let mut report = StepReport::default();
        loop {
            let flow = record(self.observer, pace.dynamics(), &report)?;
            self.look(pace.dynamics().state());
            if flow.is_break() {
                // A sink that breaks on the last instant has stopped nothing.
                return Ok(Ok(if pace.is_over() { ControlFlow::Continue(()) } else { flow }));
            }
            let summary = &mut self.summary;
            let advanced = pace.advance(|step| summary.count(step));
            summary.time = pace.dynamics().state().t;
            match advanced {
                Ok(Some(done)) => report = done,
                Ok(None) => return Ok(Ok(ControlFlow::Continue(()))),
                Err(error) => {
                    let s = pace.dynamics().state();
                    let blame = blame(assembly, s, s.load, &error);
                    return Ok(Err(Reason::Motion(error, blame)));
                }
            }
        }
    }
}
