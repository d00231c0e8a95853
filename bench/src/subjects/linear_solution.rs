use std::hint::black_box;

use ancf::solver::equations::{EquationsOfMotion, State};
use ancf::solver::factor::Factor;
use ancf::solver::sparse::SparseMatrix;

use super::cantilever::CantileverKind;
use super::plant::Plant;
use super::subject::{REPEATS, Subject};
use crate::Result;

/// Factorisation and one solution of the linear equations of a step.
#[derive(Debug)]
pub struct LinearSolution {
    matrix: SparseMatrix,
    factor: Factor,
    b: Vec<f64>,
    x: Vec<f64>,
    elements: u32,
    repeats: usize,
}

impl LinearSolution {
    /// Equations of a cantilever after a number of steps.
    ///
    /// # Errors
    /// If the model cannot be assembled or stepped, or memory does not suffice.
    pub fn new(kind: CantileverKind, elements: u32, steps: u32) -> Result<Self> {
        let plant = Plant::new(kind, elements)?;
        let state = plant.after(steps)?;
        let matrix = plant.tangent(&state);
        let factor = Factor::new(matrix.pattern()).map_err(|_| "no memory for the factors")?;
        let size = state.q.len() + state.lambda.len();
        let mut b = vec![0.0; size];
        // Right-hand side as in a Newton iteration: a residual that is out of balance by a load increment.
        plant.system().residual(&State { load: 1.01 * state.load, ..state }, &mut b);
        Ok(Self { matrix, factor, x: b.clone(), b, elements, repeats: REPEATS.div_ceil(elements as usize) })
    }
}

impl Subject for LinearSolution {
    fn count(&self) -> f64 {
        f64::from(self.elements) * self.repeats as f64
    }

    fn run(&mut self) -> Result<()> {
        for _ in 0..self.repeats {
            self.factor.factorise(&self.matrix).map_err(|_| "the matrix of a step is singular")?;
            self.x.copy_from_slice(&self.b);
            self.factor.solve(&self.matrix, &mut self.x).map_err(|_| "the equations have no solution")?;
        }
        black_box(&self.x);
        Ok(())
    }
}
