use crate::analysis::{Adaptive, Control, Dynamics, Interrupt, Newton, SolveError, StepReport};
use crate::model::{self, Assembly, Model, NewtonMethod, Start, Step};
use crate::system::System;

/// Steps through a dynamic analysis from one recorded instant to the next.
pub(super) struct Pace<'a> {
    dynamics: Dynamics<'a, System>,
    duration: f64,
    /// Recorded instants are the multiples of this, if not all steps, and the end.
    interval: Option<f64>,
    /// Number of instants so far.
    count: u64,
    steps: Steps,
    /// Times at which loads jump, the next one last.
    jumps: Vec<f64>,
    /// Times closer than this are one.
    sliver: f64,
}

enum Steps {
    /// At most of this size.
    Fixed(f64),
    Adaptive(Box<Adaptive>),
}

/// Of a step, what is left of the duration at its end and still counts as nothing.
const SLIVER: f64 = 1e-9;

impl<'a> Pace<'a> {
    /// The start of an assembly from rest; it may be interrupted.
    pub(super) fn new(
        model: &Model,
        settings: &model::Dynamics,
        assembly: &'a Assembly,
        interrupt: Interrupt,
    ) -> Result<Self, SolveError> {
        let duration = settings.duration;
        let newton = Newton::new(assembly.system.matrix(), settings.stop.into(), settings.max_iterations)?;
        let newton = newton.heeding(interrupt);
        let newton = if settings.newton == NewtonMethod::Full { newton.full() } else { newton };
        let (system, scheme) = (&assembly.system, settings.scheme.numbers());
        let mut dynamics =
            Dynamics::new(system, scheme, newton, settings.max_halvings, assembly.start(model));
        dynamics.take_in()?;
        match settings.start {
            Start::Consistent => dynamics.restart(0.0)?,
            Start::Zero => dynamics.project_velocities()?,
        }
        let (steps, every) = match settings.step {
            Step::Fixed(step) => (Steps::Fixed(step), Some(step)),
            Step::Adaptive { tolerance, initial, largest } => {
                let control = Control {
                    tolerance,
                    length: model.length(),
                    mass: model.mass(),
                    duration,
                    initial,
                    largest: largest.unwrap_or(duration),
                    smallest: Control::SMALLEST * duration,
                };
                (Steps::Adaptive(Box::new(Adaptive::new(&dynamics, control))), None)
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
            steps,
            jumps,
            sliver,
        })
    }

    pub(super) fn dynamics(&self) -> &Dynamics<'a, System> {
        &self.dynamics
    }

    /// The time of the next recorded instant, if there is one; with all steps recorded, the end.
    fn next(&self) -> Option<f64> {
        let now = self.dynamics.state().t;
        let Some(interval) = self.interval else { return Some(self.duration).filter(|end| now < *end) };
        let whole = (self.duration / interval * (1.0 + 1e-12)).floor();
        let next = (self.count + 1) as f64;
        if next <= whole {
            return Some(next * interval);
        }
        Some(self.duration).filter(|end| *end - now > SLIVER * interval)
    }

    /// Whether the duration is over.
    pub(super) fn is_over(&self) -> bool {
        self.next().is_none()
    }

    /// Moves on to the next recorded instant, telling `count` of every step; nothing if the duration is over.
    pub(super) fn advance(
        &mut self,
        mut count: impl FnMut(&StepReport),
    ) -> Result<Option<StepReport>, SolveError> {
        let Some(to) = self.next() else { return Ok(None) };
        let mut report = StepReport::default();
        loop {
            let jump = self.jumps.last().copied().filter(|jump| *jump <= to + self.sliver);
            // Just before the jump; a jump that but for rounding is at the recorded instant is taken to be there.
            let end = jump.map_or(to, |jump| jump.min(to).next_down());
            let step = self.step(end)?;
            count(&step);
            report = report.then(&step);
            if let Some(jump) = jump.filter(|_| self.dynamics.state().t == end) {
                let near = (to - jump).abs() <= self.sliver;
                self.dynamics.restart(if near { jump.max(to) } else { jump })?;
                self.jumps.pop();
            }
            if self.interval.is_none() || self.dynamics.state().t >= to {
                self.count += 1;
                return Ok(Some(report));
            }
        }
    }

    /// One step towards a time.
    fn step(&mut self, to: f64) -> Result<StepReport, SolveError> {
        match &mut self.steps {
            Steps::Adaptive(adaptive) => adaptive.step(&mut self.dynamics, to),
            Steps::Fixed(h) => {
                let (now, left) = (self.dynamics.state().t, to - self.dynamics.state().t);
                let parts = (left / *h * (1.0 - SLIVER)).ceil();
                self.dynamics.advance(if parts > 1.0 { now + left / parts } else { to })
            }
        }
    }
}
