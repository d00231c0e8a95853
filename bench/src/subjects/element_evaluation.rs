use ancf::solver::equations::Weights;

use super::cantilever::CantileverKind;
use super::element_kernels::ElementKernels;
use super::plant::Plant;
use super::subject::{ESTABLISHED, Evaluation, REPEATS, Subject};
use crate::Result;

/// Evaluation of the elements without gathering and scattering.
#[derive(Debug)]
pub struct ElementEvaluation {
    kernels: ElementKernels,
    weights: Weights,
    evaluation: Evaluation,
    repeats: usize,
}

impl ElementEvaluation {
    /// Elements of a cantilever in motion.
    ///
    /// # Errors
    /// If the model cannot be assembled or stepped.
    pub fn new(kind: CantileverKind, elements: u32, evaluation: Evaluation) -> Result<Self> {
        let plant = Plant::new(kind, elements)?;
        let mesh = plant.assembly.mesh("beam").ok_or("a cantilever has a mesh")?;
        let kernels = ElementKernels::new(mesh, &plant.after(ESTABLISHED)?);
        let repeats = REPEATS.div_ceil(kernels.count());
        Ok(Self { kernels, weights: plant.weights(), evaluation, repeats })
    }
}

impl Subject for ElementEvaluation {
    fn count(&self) -> f64 {
        (self.kernels.count() * self.repeats) as f64
    }

    fn run(&mut self) -> Result<()> {
        for _ in 0..self.repeats {
            if self.evaluation != Evaluation::Tangent {
                self.kernels.residual();
            }
            if self.evaluation != Evaluation::Residual {
                self.kernels.tangent(self.weights);
            }
        }
        Ok(())
    }
}
