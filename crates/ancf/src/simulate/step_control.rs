use ancf_solver::dynamics::{
    AdaptiveCheckpoint, AdaptiveStepper, CheckpointMismatch, ErrorControl, StepReport, StepperCheckpoint,
    TimeStepper,
};
use ancf_solver::equations::System;
use ancf_solver::newton::{Interrupt, Newton, SolveError};
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::model::{Model, NewtonMethod, Start, Step};

/// Steps through a dynamic analysis from one recorded instant to the next.
pub(crate) struct Pace<'a> {
    dynamics: TimeStepper<'a, System>,
    duration: f64,
    /// Recorded instants are the multiples of this, if not all steps, and the end.
    interval: Option<f64>,
    /// Number of instants so far but for the start.
    count: u64,
    /// Whether this is one that has not been recorded yet.
    is_due: bool,
    /// How the steps since the last one went.
    report: StepReport,
    steps: Steps,
    /// Times at which loads jump, the next one last.
    jumps: Vec<f64>,
    /// Times closer than this are one.
    sliver: f64,
}

enum Steps {
    /// At most of this size.
    Fixed(f64),
    Adaptive(Box<AdaptiveStepper>),
}

/// Of a step, what is left of the duration at its end and still counts as nothing.
const SLIVER: f64 = 1e-9;

impl<'a> Pace<'a> {
    /// The start of an assembly from rest; it may be interrupted.
    pub(crate) fn new(
        model: &Model,
        settings: &crate::model::Dynamics,
        assembly: &'a Assembly,
        interrupt: Interrupt,
    ) -> Result<Self, SolveError> {
        let duration = settings.duration;
        let newton = Newton::new(assembly.system.matrix(), settings.stop.into(), settings.max_iterations)?;
        let newton = newton.with_interrupt(interrupt);
        let newton = if settings.newton == NewtonMethod::Full { newton.with_new_tangents() } else { newton };
        let (system, scheme) = (&assembly.system, settings.scheme.numbers());
        let mut dynamics =
            TimeStepper::new(system, scheme, newton, settings.max_halvings, assembly.start(model));
        dynamics.include_near_terms()?;
        match settings.start {
            Start::Consistent => dynamics.restart(0.0)?,
            Start::Zero => dynamics.project_velocities()?,
        }
        let (steps, every) = match settings.step {
            Step::Fixed(step) => (Steps::Fixed(step), Some(step)),
            Step::Adaptive { tolerance, initial, largest } => {
                let control = ErrorControl {
                    tolerance,
                    length: model.length(),
                    mass: model.mass(),
                    duration,
                    initial,
                    largest: largest.unwrap_or(duration),
                    smallest: ErrorControl::SMALLEST * duration,
                };
                (Steps::Adaptive(Box::new(AdaptiveStepper::new(&dynamics, control))), None)
            }
        };
        let sliver = SLIVER * settings.step.fixed().unwrap_or(duration);
        let mut jumps = assembly.breaks().to_vec();
        jumps.retain(|t| *t > sliver && *t < duration - sliver);
        jumps.sort_by(|a, b| b.total_cmp(a));
        jumps.dedup_by(|a, b| (*a - *b).abs() <= sliver);
        Ok(Self {
            dynamics,
            duration,
            interval: model.output.interval.or(every),
            count: 0,
            is_due: true,
            report: StepReport::default(),
            steps,
            jumps,
            sliver,
        })
    }

    pub(crate) fn dynamics(&self) -> &TimeStepper<'a, System> {
        &self.dynamics
    }

    /// The time of the next recorded instant, if there is one; with all steps recorded, the end.
    fn next(&self) -> Option<f64> {
        self.after(self.count, self.dynamics.state().t)
    }

    /// The time of the instant after the `count`th, in the present.
    fn after(&self, count: u64, now: f64) -> Option<f64> {
        let Some(interval) = self.interval else { return Some(self.duration).filter(|end| now < *end) };
        let next = (count + 1) as f64;
        if next <= self.whole(interval) {
            return Some(next * interval);
        }
        Some(self.duration).filter(|end| *end - now > SLIVER * interval)
    }

    /// Number of whole intervals in the duration.
    fn whole(&self, interval: f64) -> f64 {
        (self.duration / interval * (1.0 + 1e-12)).floor()
    }

    /// Whether the duration is over.
    pub(crate) fn is_over(&self) -> bool {
        self.next().is_none()
    }

    /// How the steps went that lead to an instant that is to be recorded, if the present one is.
    pub(crate) fn due(&self) -> Option<StepReport> {
        self.is_due.then_some(self.report)
    }

    /// To be told once it is recorded.
    pub(crate) fn recorded(&mut self) {
        (self.is_due, self.report) = (false, StepReport::default());
    }

    /// Does a step towards the next recorded instant, telling `count` of it; returns false if the duration is over.
    pub(crate) fn advance(&mut self, count: impl FnOnce(&StepReport)) -> Result<bool, SolveError> {
        let Some(to) = self.next() else { return Ok(false) };
        let jump = self.jumps.last().copied().filter(|jump| *jump <= to + self.sliver);
        // Just before the jump; a jump that but for rounding is at the recorded instant is taken to be there.
        let end = jump.map_or(to, |jump| jump.min(to).next_down());
        // Unless there was no way to go on from the jump, and this is tried again.
        if self.dynamics.state().t < end {
            let step = self.step(end)?;
            count(&step);
            self.report = self.report.then(&step);
        }
        if let Some(jump) = jump.filter(|_| self.dynamics.state().t == end) {
            let near = (to - jump).abs() <= self.sliver;
            self.dynamics.restart(if near { jump.max(to) } else { jump })?;
            self.jumps.pop();
        }
        if self.interval.is_none() || self.dynamics.state().t >= to {
            self.count += 1;
            self.is_due = true;
        }
        Ok(true)
    }

    /// One step towards a time.
    fn step(&mut self, to: f64) -> Result<StepReport, SolveError> {
        match &mut self.steps {
            Steps::Adaptive(adaptive) => adaptive.step(&mut self.dynamics, to),
            Steps::Fixed(h) => {
                if let Some(to) = self.dynamics.pending_time() {
                    return self.dynamics.advance(to);
                }
                let (now, left) = (self.dynamics.state().t, to - self.dynamics.state().t);
                let parts = (left / *h * (1.0 - SLIVER)).ceil();
                self.dynamics.advance(if parts > 1.0 { now + left / parts } else { to })
            }
        }
    }
}

/// What the further pace depends on; of an instant that is recorded, if it is to be.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct PaceMemory {
    count: u64,
    report: StepReport,
    /// Number of jumps still to come.
    jumps: usize,
    dynamics: StepperCheckpoint,
    adaptive: Option<AdaptiveCheckpoint>,
}

impl PaceMemory {
    /// Number of recorded instants, the start among them.
    pub(crate) fn rows(&self) -> u64 {
        self.count.saturating_add(1)
    }

    pub(crate) fn time(&self) -> f64 {
        self.dynamics.time()
    }
}

/// Counts above this are damaged.
pub(crate) const MOST: u64 = 1 << 53;

impl Pace<'_> {
    /// As of the last accepted step.
    pub(crate) fn memory(&self) -> PaceMemory {
        let adaptive = match &self.steps {
            Steps::Fixed(_) => None,
            Steps::Adaptive(adaptive) => Some(adaptive.checkpoint()),
        };
        PaceMemory {
            count: self.count,
            report: self.report,
            jumps: self.jumps.len(),
            dynamics: self.dynamics.checkpoint(),
            adaptive,
        }
    }

    /// Goes on from a memory.
    pub(crate) fn recall(&mut self, memory: &PaceMemory) -> Result<(), CheckpointMismatch> {
        if !self.knows(memory) {
            return Err(CheckpointMismatch);
        }
        match (&mut self.steps, &memory.adaptive) {
            (Steps::Fixed(_), None) => {}
            (Steps::Adaptive(adaptive), Some(memory)) => adaptive.restore(memory)?,
            _ => return Err(CheckpointMismatch),
        }
        (self.count, self.is_due, self.report) = (memory.count, false, memory.report);
        self.jumps.truncate(memory.jumps);
        self.dynamics.restore(&memory.dynamics)
    }

    /// Whether the instant of a memory is among its own.
    fn knows(&self, memory: &PaceMemory) -> bool {
        let PaceMemory { count, report, jumps, dynamics, .. } = memory;
        let (t, count) = (dynamics.time(), *count);
        if !(0.0..=self.duration + self.sliver).contains(&t) || count > MOST || *jumps > self.jumps.len() {
            return false;
        }
        let is_before = |end: f64| t <= end + self.sliver;
        let is_in_turn = self.interval.is_none_or(|interval| {
            let (now, whole) = (count as f64, self.whole(interval));
            let reached = if now <= whole { now * interval } else { self.duration };
            now <= whole + 1.0 && t >= reached && self.after(count, t).is_none_or(is_before)
        });
        let is_before_jumps = self.jumps[..*jumps].last().is_none_or(|jump| t < *jump);
        is_in_turn
            && is_before_jumps
            && report.is_valid()
            && dynamics.pending_time().is_none_or(|to| to <= self.duration + self.sliver)
    }
}
