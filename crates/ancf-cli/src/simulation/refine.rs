//! Refinement of the mesh of a model file to a requested error.

use std::io;
use std::ops::ControlFlow;

use ancf::estimate::{MeshStep, Refinement, RefinementStep};
use ancf::record::Sink;
use ancf::solver::newton::Interrupt;
use ancf::{Error, Model, Outcome, Simulation};

use crate::terminal::print_status;

/// Parses a relative error: `1%` or `0.01`.
pub fn wanted_error(text: &str) -> Result<f64, String> {
    let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 0.01));
    match number.trim().parse::<f64>().map(|number| number * unit) {
        Ok(requested) if (1e-9..1.0).contains(&requested) => Ok(requested),
        _ => Err("expected a relative error between 1e-7 % and 100 %, such as 1% or 0.01".into()),
    }
}

/// Model on the last mesh of a refinement.
pub struct Refined {
    pub model: Model,
    pub simulation: Simulation,
    /// Meshes so far.
    pub meshes: Vec<MeshStep>,
    /// Reason for which the error is larger than requested.
    pub reason: Option<String>,
}

/// Runs a model on finer meshes until the estimated error is as small as requested, or cannot be reduced. `simulation` is that of the
/// model.
///
/// # Errors
/// If a refined model is not valid or the run is interrupted.
pub fn refine(
    mut model: Model,
    mut simulation: Simulation,
    requested: f64,
    interrupt: &Interrupt,
) -> anyhow::Result<Refined> {
    let mut refinement = Refinement::new(requested);
    loop {
        simulation = simulation.with_interrupt(interrupt.clone());
        let summary = simulation.run(&mut (&mut Discard as &mut dyn Sink)).map_err(Error::from)?;
        let step = if summary.outcome.is_finished() {
            refinement.advance(&model, summary.errors.as_ref())
        } else if summary.outcome == Outcome::Stopped {
            RefinementStep::Ended("the run was stopped".into())
        } else {
            refinement.advance_failed(&model)
        };
        let number = refinement.meshes().len();
        if let Some(mesh) = refinement.meshes().last().filter(|_| summary.outcome != Outcome::Stopped) {
            print_status(&format!("mesh {number}: {mesh}"));
        }
        let reason = match step {
            RefinementStep::Next(next) => {
                model = *next;
                simulation = Simulation::new(&model)?;
                continue;
            }
            RefinementStep::Reached => None,
            RefinementStep::Ended(reason) => Some(reason),
        };
        let meshes = refinement.meshes().to_vec();
        return Ok(Refined { model, simulation, meshes, reason });
    }
}

/// Sink without a record.
struct Discard;

impl Sink for Discard {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64]) -> io::Result<ControlFlow<()>> {
        Ok(ControlFlow::Continue(()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_percentages_or_numbers() {
        assert_eq!(wanted_error("1%"), Ok(0.01));
        assert_eq!(wanted_error("0.5 %"), Ok(0.005));
        assert_eq!(wanted_error("1e-3"), Ok(1e-3));
        for wrong in ["", "0", "%", "100%", "-1%", "nan", "1 percent"] {
            assert!(wanted_error(wrong).is_err(), "{wrong}");
        }
    }
}
