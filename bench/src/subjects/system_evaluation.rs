use std::hint::black_box;

use ancf::solver::equations::{EquationsOfMotion, State, System, Weights};
use ancf::solver::sparse::SparseMatrix;

use super::cantilever::CantileverKind;
use super::plant::Plant;
use super::subject::{ESTABLISHED, Evaluation, REPEATS, Subject};
use crate::Result;

/// Evaluation of the residual or the tangent of a system, with gathering and scattering.
#[derive(Debug)]
pub struct SystemEvaluation {
    system: &'static System,
    state: State,
    weights: Weights,
    evaluation: Evaluation,
    matrix: SparseMatrix,
    residual: Vec<f64>,
    elements: u32,
    repeats: usize,
}

impl SystemEvaluation {
    /// System of a cantilever in motion.
    ///
    /// # Errors
    /// If the model cannot be assembled or stepped.
    pub fn new(kind: CantileverKind, elements: u32, evaluation: Evaluation) -> Result<Self> {
        let plant = Plant::new(kind, elements)?;
        let (system, state) = (plant.system(), plant.after(ESTABLISHED)?);
        let (matrix, size) = (system.matrix(), system.coordinates() + system.multipliers());
        let repeats = REPEATS.div_ceil(elements as usize);
        let (weights, residual) = (plant.weights(), vec![0.0; size]);
        Ok(Self { system, state, weights, evaluation, matrix, residual, elements, repeats })
    }
}

impl Subject for SystemEvaluation {
    fn count(&self) -> f64 {
        f64::from(self.elements) * self.repeats as f64
    }

    fn run(&mut self) -> Result<()> {
        for _ in 0..self.repeats {
            if self.evaluation != Evaluation::Tangent {
                self.system.residual(&self.state, &mut self.residual);
                black_box(&self.residual);
            }
            if self.evaluation != Evaluation::Residual {
                self.system.tangent(&self.state, self.weights, &mut self.matrix);
                black_box(self.matrix.values());
            }
        }
        Ok(())
    }
}
