use ancf::solver::dynamics::TimeStepper;
use ancf::solver::equations::System;

use super::cantilever::CantileverKind;
use super::plant::{Plant, step};
use super::subject::Subject;
use crate::Result;

/// Implicit time steps from rest, each iterated to convergence.
#[derive(Debug)]
pub struct TimeSteps {
    plant: Plant,
    motion: Option<TimeStepper<'static, System>>,
    elements: u32,
    steps: u32,
    iterations: u32,
}

impl TimeSteps {
    /// A number of steps of a cantilever.
    ///
    /// # Errors
    /// If the model cannot be assembled.
    pub fn new(kind: CantileverKind, elements: u32, steps: u32) -> Result<Self> {
        Ok(Self { plant: Plant::new(kind, elements)?, motion: None, elements, steps, iterations: 0 })
    }

    /// Newton iterations per step in the last run.
    pub fn iterations(&self) -> f64 {
        f64::from(self.iterations) / f64::from(self.steps)
    }
}

impl Subject for TimeSteps {
    fn count(&self) -> f64 {
        f64::from(self.elements) * f64::from(self.steps)
    }

    fn prepare(&mut self) -> Result<()> {
        self.motion = None;
        self.motion = Some(self.plant.motion()?);
        Ok(())
    }

    fn run(&mut self) -> Result<()> {
        let motion = self.motion.as_mut().ok_or("a run is prepared first")?;
        self.iterations = 0;
        for _ in 0..self.steps {
            self.iterations += step(motion)?.iterations;
        }
        Ok(())
    }
}
