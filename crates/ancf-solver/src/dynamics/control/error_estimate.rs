use serde::{Deserialize, Serialize};

use crate::dynamics::start::solve;
use crate::dynamics::time_stepper::TimeStepper;
use crate::equations::{EquationsOfMotion, Level, Weights};
use crate::factor::Products;
use crate::newton::{NewtonReport, SolveError, SolveFailure};
use crate::sparse::SparseMatrix;
use crate::vectors::dot;

/// Error estimate of a step of a second-order scheme, as a mass-weighted root mean square displacement.
///
/// A step shifts the phase of a vibration by κ ω³h³. With ε = κ v̈ from the accelerations of the scheme, the error is
///
/// [S, Φ_qᵀ; Φ_q, 0] (ε, ·) = (κ M (aₙ₊₁ − aₙ)/h, 0),   h³ √(‖ε‖² + τ²‖ε̇‖²),   ‖x‖² = xᵀ M x / m.
///
/// The iteration matrix S filters vibrations that the step does not resolve and need not resolve. The second term is
/// the error in v. The factor τ² = ∫‖ε‖²/∫‖ε̇‖² makes both terms equal on average. The sum then does not vanish twice
/// in every period. For a harmonic motion it is the exact phase error.
///
/// Source: Shampine & Baca (1984) for the filter; κ by inserting exp(iωt) into the scheme.
#[derive(Debug)]
pub(crate) struct ErrorEstimate {
    /// Constant mass matrix M, its products, and the total mass m.
    matrix: SparseMatrix,
    products: Products,
    mass: f64,
    /// Error ε of the attempt, and M ε of the attempt and of the last accepted step.
    now: Vec<f64>,
    force: Vec<f64>,
    force_before: Vec<f64>,
    /// Another vector, such as a correction of the velocities, and its product with M.
    other: Vec<f64>,
    product: Vec<f64>,
    /// Squares ‖ε‖² and ‖ε̇‖² of the attempt.
    squares: [f64; 2],
    pub(crate) history: ErrorHistory,
}

/// Error history of the accepted steps.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct ErrorHistory {
    /// Error ε and step size of the last accepted step.
    error: Vec<f64>,
    h: Option<f64>,
    /// Integrals of ‖ε‖² and ‖ε̇‖².
    integrals: [f64; 2],
}

impl ErrorHistory {
    /// Returns the number of unknowns.
    pub(crate) fn size(&self) -> usize {
        self.error.len()
    }

    /// Returns true if the history has the given number of unknowns and is finite.
    pub(crate) fn is_valid(&self, size: usize) -> bool {
        let mut numbers = self.error.iter().chain(&self.h).chain(&self.integrals);
        self.error.len() == size && numbers.all(|x| x.is_finite())
    }
}

impl ErrorEstimate {
    pub(crate) fn new<E: EquationsOfMotion>(dynamics: &TimeStepper<'_, E>, mass: f64) -> Self {
        let mut matrix = dynamics.newton.tangent.matrix.clone();
        dynamics.eom.tangent(dynamics.state(), Weights::MASS, &mut matrix);
        let zeros = vec![0.0; matrix.pattern().size()];
        let history = ErrorHistory { error: zeros.clone(), h: None, integrals: [0.0; 2] };
        let products = Products::new(matrix.pattern());
        let [now, force, force_before, other, product] = std::array::from_fn(|_| zeros.clone());
        Self { matrix, products, mass, now, force, force_before, other, product, squares: [0.0; 2], history }
    }

    /// Clears the history.
    pub(crate) fn restart(&mut self) {
        (self.history.h, self.history.integrals) = (None, [0.0; 2]);
    }

    /// Resumes from a saved history.
    pub(crate) fn restore(&mut self, history: &ErrorHistory) {
        self.history = history.clone();
        self.products.multiply(&self.matrix, &self.history.error, &mut self.force_before);
    }

    /// Computes the norm ‖x‖ of a vector over the coordinates.
    pub(crate) fn norm(&mut self, x: &[f64]) -> f64 {
        self.other[..x.len()].copy_from_slice(x);
        self.norm_of_other(x.len())
    }

    /// Computes the norm of the first `n` components of `other`, which are its coordinates.
    fn norm_of_other(&mut self, n: usize) -> f64 {
        self.other[n..].fill(0.0);
        self.products.multiply(&self.matrix, &self.other, &mut self.product);
        (dot(&self.other, &self.product).max(0.0) / self.mass).sqrt()
    }

    /// Estimates the error of the attempted step h.
    pub(crate) fn error<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut TimeStepper<'_, E>,
        done: &NewtonReport,
        h: f64,
    ) -> Result<f64, SolveError> {
        let n = dynamics.motion.state.q.len();
        let [a, b] = &dynamics.attempted;
        let factor = dynamics.scheme.phase_constant() / h;
        for i in 0..n {
            self.force[i] = factor * (b[i] - a[i]);
        }
        self.force[n..].fill(0.0);
        self.products.multiply(&self.matrix, &self.force, &mut self.now);
        self.now[n..].fill(0.0);
        let (newton, s) = (&mut dynamics.newton, &dynamics.motion.state);
        if done.iterations == 0 {
            let w = dynamics.scheme.weights(h);
            let (matrix, factor) = newton.tangent.lend();
            solve(&*dynamics.eom, matrix, factor, s, w, &mut self.now)?;
        } else {
            let solved = newton.tangent.factor.solve_increment(&newton.tangent.matrix, &mut self.now, &[]);
            solved.map_err(|_| SolveError::at(s.t, SolveFailure::Singular))?;
        }
        self.now[n..].fill(0.0);
        self.products.multiply(&self.matrix, &self.now, &mut self.force);
        self.squares = [dot(&self.now, &self.force).max(0.0) / self.mass, 0.0];
        if let Some(before) = self.history.h {
            let ends =
                self.now.iter().zip(&self.history.error).zip(self.force.iter().zip(&self.force_before));
            let change: f64 =
                ends.map(|((x, x_before), (f, f_before))| (x - x_before) * (f - f_before)).sum();
            self.squares[1] = change.max(0.0) / (0.5 * (h + before)).powi(2) / self.mass;
        }
        let [over, under] = self.integrals(h);
        let second = if under > 0.0 { over / under * self.squares[1] } else { 0.0 };
        Ok(h.powi(3) * (self.squares[0] + second).sqrt())
    }

    /// Computes the norm of the correction u of the velocities of the attempt that restores the constraints on them:
    ///
    /// [S, Φ_qᵀ; Φ_q, 0] (u, ·) = (0, Φ̇).
    ///
    /// The positions of prescribed motions are exact in a step of any size, so the estimated error does not contain it.
    ///
    /// # Errors
    /// If the factors of the attempt do not solve.
    pub(crate) fn velocity_error<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut TimeStepper<'_, E>,
    ) -> Result<f64, SolveError> {
        let (s, tangent, u) = (&dynamics.motion.state, &mut dynamics.newton.tangent, &mut self.other);
        let n = s.q.len();
        u[..n].fill(0.0);
        dynamics.eom.constraints(s, Level::Velocity, &mut u[n..]);
        if u[n..].iter().all(|rate| *rate == 0.0) {
            return Ok(0.0);
        }
        let solved = tangent.factor.solve_increment(&tangent.matrix, u, &[]);
        solved.map_err(|_| SolveError::at(s.t, SolveFailure::Singular))?;
        Ok(self.norm_of_other(n))
    }

    /// Returns the coordinate with the largest contribution to the error of the attempt, measured as energy.
    pub(crate) fn worst(&self) -> Option<usize> {
        let parts = self.now.iter().zip(&self.force).map(|(x, f)| (x * f).abs()).enumerate();
        parts.max_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(i, _)| i)
    }

    /// Returns ∫‖ε‖² and ∫‖ε̇‖² including the attempt.
    fn integrals(&self, h: f64) -> [f64; 2] {
        std::array::from_fn(|i| self.history.integrals[i] + h * self.squares[i])
    }

    /// Adds the attempt to the history.
    pub(crate) fn accept(&mut self, h: f64) {
        self.history.integrals = self.integrals(h);
        std::mem::swap(&mut self.now, &mut self.history.error);
        std::mem::swap(&mut self.force, &mut self.force_before);
        self.history.h = Some(h);
    }
}
