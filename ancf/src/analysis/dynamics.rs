use super::{Failure, Newmark, Newton, SolveError};
use crate::system::{Energy, EquationsOfMotion, Factor, SparseMatrix, State, Weights};

/// How a step went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Newton iterations, those of failed attempts included.
    pub iterations: u32,
    /// Steps that were taken, 1 unless the step had to be divided.
    pub substeps: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// Whether the rounding error of the residual ended an iteration.
    pub floor: bool,
}

/// Integration of equations of motion in time.
#[derive(Debug)]
pub struct Dynamics<'a, E: EquationsOfMotion + ?Sized> {
    eom: &'a E,
    scheme: Newmark,
    newton: Newton,
    max_halvings: u32,
    state: State,
    /// The state before the current attempt.
    before: State,
}

impl<'a, E: EquationsOfMotion> Dynamics<'a, E> {
    /// Starts from a state; a step whose iteration fails is halved up to `max_halvings` times.
    pub fn new(eom: &'a E, scheme: Newmark, newton: Newton, max_halvings: u32, start: State) -> Self {
        Self { eom, scheme, newton, max_halvings, before: start.clone(), state: start }
    }

    /// The current state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The energies of the current state.
    pub fn energy(&self) -> Energy {
        self.eom.energy(&self.state)
    }

    /// Moves on to the time `to`, in one step if Newton's method converges, in 2, 4, 8, ... equal ones if it does not.
    ///
    /// # Errors
    /// If the smallest permitted step fails; the state is then that of the last converged step.
    pub fn advance(&mut self, to: f64) -> Result<StepReport, SolveError> {
        let mut report = StepReport::default();
        let (mut h, mut left, mut halvings) = (to - self.state.t, 1_u64, 0);
        while left > 0 {
            self.before.copy_from(&self.state);
            match self.attempt(h, to - (left - 1) as f64 * h, &mut report) {
                Ok(()) => left -= 1,
                Err(error) => {
                    self.state.copy_from(&self.before);
                    report.iterations += error.iterations;
                    if halvings == self.max_halvings {
                        return Err(error);
                    }
                    (h, left, halvings) = (0.5 * h, 2 * left, halvings + 1);
                }
            }
        }
        Ok(report)
    }

    fn attempt(&mut self, h: f64, to: f64, report: &mut StepReport) -> Result<(), SolveError> {
        self.scheme.predict(&mut self.state, h);
        self.state.t = to;
        let done = self.newton.solve(self.eom, &mut self.state, self.scheme.weights(h))?;
        if let Some(worst) = self.eom.inadmissible(&self.state) {
            let (iterations, residual, increment) = (done.iterations, done.residual, done.increment);
            let (failure, t) = (Failure::Inverted, to);
            return Err(SolveError { failure, t, iterations, residual, increment, worst });
        }
        self.newton.met(self.eom.energy(&self.state).largest());
        report.iterations += done.iterations;
        report.substeps += 1;
        report.residual = done.residual;
        report.increment = done.increment;
        report.floor |= done.floor;
        Ok(())
    }
}

/// Sets the accelerations and multipliers that satisfy the equations of motion at given q and v.
///
/// [M, Φ_qᵀ; Φ_q, 0] (a, λ) = −(f, (Φ_q v)_q v). The constraints are at most quadratic, so that the last term is exactly
/// their second difference along v.
///
/// # Errors
/// If the matrix is singular.
pub fn consistent_start<E: EquationsOfMotion>(
    eom: &E,
    matrix: &mut SparseMatrix,
    s: &mut State,
) -> Result<(), SolveError> {
    let n = s.q.len();
    s.a.fill(0.0);
    s.lambda.fill(0.0);
    let mut rhs = vec![0.0; matrix.pattern().size()];
    eom.residual(s, &mut rhs);
    rhs[n..].copy_from_slice(&curvature(eom, s));
    rhs.iter_mut().for_each(|x| *x = -*x);
    eom.tangent(s, Weights::MASS, matrix);
    let solved = Factor::new(matrix.pattern()).and_then(|mut factor| {
        factor.factorise(matrix)?;
        factor.solve(matrix, &mut rhs)
    });
    solved.map_err(|_| SolveError::at_start(Failure::Singular))?;
    s.a.copy_from_slice(&rhs[..n]);
    s.lambda.copy_from_slice(&rhs[n..]);
    Ok(())
}

/// (Φ_q v)_q v = Φ(q + v) − 2Φ(q) + Φ(q − v) for constraints of degree two.
fn curvature<E: EquationsOfMotion>(eom: &E, s: &State) -> Vec<f64> {
    let n = s.q.len();
    let constraints = |sign: f64| {
        let mut moved = s.clone();
        moved.q.iter_mut().zip(&s.v).for_each(|(q, v)| *q += sign * v);
        let mut r = vec![0.0; n + s.lambda.len()];
        eom.residual(&moved, &mut r);
        r.split_off(n)
    };
    let (ahead, here, back) = (constraints(1.0), constraints(0.0), constraints(-1.0));
    ahead.iter().zip(&here).zip(&back).map(|((ahead, here), back)| ahead - 2.0 * here + back).collect()
}
