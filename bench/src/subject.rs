//! What is measured.

use std::hint::black_box;

use ancf::analysis::Dynamics;
use ancf::system::{EquationsOfMotion, Factor, SparseMatrix, State, System, Weights};

use crate::kernels::Kernels;
use crate::measure::Result;
use crate::model::Kind;
use crate::motion::{Plant, step};

/// Steps from rest after which kernels and matrices are measured: by then the beam is bent and moves.
const ESTABLISHED: u32 = 50;
/// Evaluations in one run of a kernel, so that no clock counts.
const REPEATS: usize = 1000;

/// Work that can be repeated: the same each time.
pub trait Subject {
    /// Number of elements, times repetitions within one run: what a time is divided by.
    fn count(&self) -> f64;

    /// What comes before a run and is not measured.
    ///
    /// # Errors
    /// If it fails.
    fn prepare(&mut self) -> Result<()> {
        Ok(())
    }

    /// The work.
    ///
    /// # Errors
    /// If it fails.
    fn run(&mut self) -> Result<()>;
}

/// Which part of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The residuals of the elements.
    Force,
    /// The tangents of the elements.
    Stiffness,
    /// Both.
    Both,
}

/// The elements alone.
#[derive(Debug)]
pub struct OfElements {
    kernels: Kernels,
    weights: Weights,
    part: Part,
    repeats: usize,
}

impl OfElements {
    /// Those of a cantilever in motion.
    ///
    /// # Errors
    /// If it cannot be made.
    pub fn new(kind: Kind, elements: u32, part: Part) -> Result<Self> {
        let plant = Plant::new(kind, elements)?;
        let mesh = plant.assembly.mesh("beam").ok_or("a cantilever has a mesh")?;
        let kernels = Kernels::new(mesh, &plant.after(ESTABLISHED)?);
        let repeats = REPEATS.div_ceil(kernels.count());
        Ok(Self { kernels, weights: plant.weights(), part, repeats })
    }
}

impl Subject for OfElements {
    fn count(&self) -> f64 {
        (self.kernels.count() * self.repeats) as f64
    }

    fn run(&mut self) -> Result<()> {
        for _ in 0..self.repeats {
            if self.part != Part::Stiffness {
                self.kernels.residual();
            }
            if self.part != Part::Force {
                self.kernels.tangent(self.weights);
            }
        }
        Ok(())
    }
}

/// The residual or the tangent of a whole system: gathered, evaluated, scattered.
#[derive(Debug)]
pub struct OfSystem {
    system: &'static System,
    state: State,
    weights: Weights,
    part: Part,
    matrix: SparseMatrix,
    residual: Vec<f64>,
    elements: u32,
    repeats: usize,
}

impl OfSystem {
    /// That of a cantilever in motion.
    ///
    /// # Errors
    /// If it cannot be made.
    pub fn new(kind: Kind, elements: u32, part: Part) -> Result<Self> {
        let plant = Plant::new(kind, elements)?;
        let (system, state) = (plant.system(), plant.after(ESTABLISHED)?);
        let (matrix, size) = (system.matrix(), system.coordinates() + system.multipliers());
        let repeats = REPEATS.div_ceil(elements as usize);
        let (weights, residual) = (plant.weights(), vec![0.0; size]);
        Ok(Self { system, state, weights, part, matrix, residual, elements, repeats })
    }
}

impl Subject for OfSystem {
    fn count(&self) -> f64 {
        f64::from(self.elements) * self.repeats as f64
    }

    fn run(&mut self) -> Result<()> {
        for _ in 0..self.repeats {
            if self.part != Part::Stiffness {
                self.system.residual(&self.state, &mut self.residual);
                black_box(&self.residual);
            }
            if self.part != Part::Force {
                self.system.tangent(&self.state, self.weights, &mut self.matrix);
                black_box(self.matrix.values());
            }
        }
        Ok(())
    }
}

/// The equations of a step: factorisation and one solution.
#[derive(Debug)]
pub struct OfEquations {
    matrix: SparseMatrix,
    factor: Factor,
    b: Vec<f64>,
    x: Vec<f64>,
    elements: u32,
    repeats: usize,
}

impl OfEquations {
    /// Those of a cantilever in motion, after so many steps.
    ///
    /// # Errors
    /// If it cannot be made.
    pub fn new(kind: Kind, elements: u32, after: u32) -> Result<Self> {
        let plant = Plant::new(kind, elements)?;
        let state = plant.after(after)?;
        let matrix = plant.tangent(&state);
        let factor = Factor::new(matrix.pattern()).map_err(|_| "no memory for the factors")?;
        let size = state.q.len() + state.lambda.len();
        let mut b = vec![0.0; size];
        // What a Newton iteration would solve for: the state moved by one more increment, out of balance.
        plant.system().residual(&State { load: 1.01 * state.load, ..state }, &mut b);
        Ok(Self { matrix, factor, x: b.clone(), b, elements, repeats: REPEATS.div_ceil(elements as usize) })
    }
}

impl Subject for OfEquations {
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

/// Whole implicit steps from rest, each iterated to convergence.
#[derive(Debug)]
pub struct OfSteps {
    plant: Plant,
    motion: Option<Dynamics<'static, System>>,
    elements: u32,
    steps: u32,
    iterations: u32,
}

impl OfSteps {
    /// So many steps of a cantilever.
    ///
    /// # Errors
    /// If it cannot be made.
    pub fn new(kind: Kind, elements: u32, steps: u32) -> Result<Self> {
        Ok(Self { plant: Plant::new(kind, elements)?, motion: None, elements, steps, iterations: 0 })
    }

    /// Newton iterations a step in the last run.
    pub fn iterations(&self) -> f64 {
        f64::from(self.iterations) / f64::from(self.steps)
    }
}

impl Subject for OfSteps {
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
