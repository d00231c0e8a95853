use ancf::solver::dynamics::TimeStepper;
use ancf::solver::equations::System;

use super::plant::{Plant, step};
use super::subject::Subject;
use crate::Result;

/// Time steps of a model after a number of steps that are not measured.
#[derive(Debug)]
pub struct ContactSteps {
    plant: Plant,
    motion: Option<TimeStepper<'static, System>>,
    before: u32,
    steps: u32,
    iterations: u32,
}

impl ContactSteps {
    /// Steps of 1 ms of a model file.
    ///
    /// # Errors
    /// If the model cannot be assembled.
    pub fn new(text: &str, before: u32, steps: u32) -> Result<Self> {
        Ok(Self { plant: Plant::of_file(text)?, motion: None, before, steps, iterations: 0 })
    }

    /// Newton iterations per step in the last run.
    pub fn iterations(&self) -> f64 {
        f64::from(self.iterations) / f64::from(self.steps)
    }
}

impl Subject for ContactSteps {
    fn count(&self) -> f64 {
        f64::from(self.steps)
    }

    fn prepare(&mut self) -> Result<()> {
        let mut motion = self.plant.motion()?;
        (0..self.before).try_for_each(|_| step(&mut motion).map(|_| ()))?;
        self.motion = Some(motion);
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
