use super::{Dynamics, Failure, SolveError, StepReport};
use crate::system::{EquationsOfMotion, SparseMatrix, Weights};

/// What steps of variable size are to achieve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// The error that the motion may have at the end of the duration, as a root mean square displacement over the mass,
    /// relative to `length`.
    pub tolerance: f64,
    /// A length of the model, such as that of its longest body.
    pub length: f64,
    /// The mass of the model.
    pub mass: f64,
    /// The time over which the error gathers.
    pub duration: f64,
    /// The first step; chosen by the first acceleration if left out.
    pub initial: Option<f64>,
    /// The largest step.
    pub largest: f64,
    /// The smallest step.
    pub smallest: f64,
}

impl Control {
    /// The smallest step as a part of the duration, unless something else is wanted.
    pub const SMALLEST: f64 = 1e-9;
}

/// Steps as large as a tolerance permits.
///
/// A second-order scheme leaves the error C h³ v̈ in q, estimated by the scheme's own accelerations and filtered by the matrix of
/// the iteration, so that vibrations which the step does not resolve, and does not have to, do not count:
///
/// [S, Φ_qᵀ; Φ_q, 0] (e, ·) = (C h² M (aₙ₊₁ − aₙ), 0),   ‖e‖ = √(eᵀ M e / m).
///
/// Errors gather, so each step may have its share of the tolerance, ‖e‖/h ≤ tolerance × length / duration. Step sizes follow
/// from the errors of two steps, smoothly, since each change of the step disturbs the multipliers.
///
/// Source: Shampine & Baca (1984) for the filter; Söderlind (2003), the digital filter H211b with b = 4.
#[derive(Debug)]
pub struct Adaptive {
    control: Control,
    /// The mass matrix, which is constant.
    mass: SparseMatrix,
    /// The step that is to come.
    h: f64,
    /// The quotient of permitted and estimated error, and the size, of the last accepted step.
    last: Option<(f64, f64)>,
    /// Whether the last attempt failed, so that the step must not grow at once.
    failed: bool,
    error: Vec<f64>,
    force: Vec<f64>,
}

/// The part of its share at which a step aims.
const AIM: f64 = 0.5;
/// b k of the filter, where errors per step go with hᵏ, k = 2.
const FILTER: f64 = 8.0;
/// 1/b of the filter.
const DAMPING: f64 = 0.25;
/// The part of itself to which a step falls when Newton's method fails.
const FALL: f64 = 0.25;

impl Adaptive {
    /// A control for the dynamics; its scheme must be of second order.
    pub fn new<E: EquationsOfMotion>(dynamics: &Dynamics<'_, E>, control: Control) -> Self {
        let mut mass = dynamics.newton.matrix.clone();
        dynamics.eom.tangent(dynamics.state(), Weights::MASS, &mut mass);
        let zeros = vec![0.0; mass.pattern().size()];
        let (error, force) = (zeros.clone(), zeros);
        let mut own = Self { control, mass, h: 0.0, last: None, failed: false, error, force };
        own.h = control.initial.unwrap_or_else(|| own.first(&dynamics.state().a));
        own
    }

    /// A first step in which the acceleration moves the system by a part of the tolerance.
    fn first(&mut self, a: &[f64]) -> f64 {
        self.error[..a.len()].copy_from_slice(a);
        let a = self.norm();
        let distance = self.control.tolerance * self.control.length;
        let h = if a > 0.0 { (distance / a).sqrt() } else { self.control.duration };
        0.1 * h.min(self.control.duration)
    }

    /// √(eᵀ M e / m) of the vector `error`.
    fn norm(&mut self) -> f64 {
        self.mass.multiply(&self.error, &mut self.force);
        let square: f64 = self.error.iter().zip(&self.force).map(|(e, f)| e * f).sum();
        (square.abs() / self.control.mass).sqrt()
    }

    /// Does one step of a size that the tolerance permits, at most to the time `to`; several such end there exactly.
    ///
    /// # Errors
    /// If the smallest step fails or is too inaccurate; the state is then that of the last accepted step.
    pub fn step<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut Dynamics<'_, E>,
        to: f64,
    ) -> Result<StepReport, SolveError> {
        let mut report = StepReport::default();
        if dynamics.fresh {
            self.last = None;
        }
        loop {
            let from = dynamics.state().t;
            let parts = ((to - from) / self.h.min(self.control.largest) * (1.0 - 1e-9)).ceil().max(1.0);
            let h = (to - from) / parts;
            let end = if parts == 1.0 { to } else { from + h };
            match dynamics.attempt(h, end) {
                Ok(done) => {
                    let error = self.estimate(dynamics, h)?;
                    let permitted = self.control.tolerance * self.control.length / self.control.duration * h;
                    if error <= permitted {
                        self.plan(AIM * permitted / error.max(f64::MIN_POSITIVE), h);
                        dynamics.accept(&done, &mut report);
                        return Ok(report);
                    }
                    dynamics.take_back();
                    report.iterations += done.iterations;
                    report.rejected += 1;
                    self.h = h * (AIM * permitted / error).sqrt().max(0.1);
                    if self.h < self.control.smallest {
                        return Err(SolveError::at(end, Failure::StepTooSmall));
                    }
                }
                Err(failure) => {
                    report.iterations += failure.iterations;
                    self.h = FALL * h;
                    if self.h < self.control.smallest {
                        return Err(failure);
                    }
                }
            }
            self.failed = true;
        }
    }

    /// The size of the next step after one of size h, whose error was 1/`quotient` of what it aims at.
    fn plan(&mut self, quotient: f64, h: f64) {
        let (before, h_before) = self.last.unwrap_or((quotient, h));
        let factor = (quotient * before).powf(1.0 / FILTER) * (h / h_before).powf(-DAMPING);
        let smooth = 1.0 + (factor - 1.0).atan(); // at most 2.6
        self.h = h * if self.failed { smooth.min(1.0) } else { smooth };
        self.last = Some((quotient, h));
        self.failed = false;
    }

    /// ‖e‖ of the attempted step.
    fn estimate<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut Dynamics<'_, E>,
        h: f64,
    ) -> Result<f64, SolveError> {
        let n = dynamics.state.q.len();
        let [before, now] = &dynamics.attempted;
        let factor = dynamics.scheme.error_constant() * h * h;
        for i in 0..n {
            self.force[i] = factor * (now[i] - before[i]);
        }
        self.force[n..].fill(0.0);
        self.mass.multiply(&self.force, &mut self.error);
        self.error[n..].fill(0.0);
        let newton = &mut dynamics.newton;
        let solved = newton.factor.solve(&newton.matrix, &mut self.error);
        solved.map_err(|_| SolveError::at(dynamics.state.t, Failure::Singular))?;
        self.error[n..].fill(0.0);
        Ok(self.norm())
    }
}
