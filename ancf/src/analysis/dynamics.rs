use super::consistent::{accelerations, velocities};
use super::current::Current;
use super::launch::launch;
use super::trend::Trend;
use super::{Failure, Newton, Report, Scheme, SolveError};
use crate::system::{Energy, EquationsOfMotion, Level, Power, SparseMatrix, State};

/// How a step went.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// Newton iterations, those of failed attempts included.
    pub iterations: u32,
    /// Steps that were taken, 1 unless the step had to be divided.
    pub substeps: u32,
    /// Steps that were tried but found too inaccurate; none without error control.
    pub rejected: u32,
    /// Euclidean norm of the last residual that was evaluated.
    pub residual: f64,
    /// Euclidean norm of the last increment of the coordinates.
    pub increment: f64,
    /// The largest |Φ_q v + Φ_t| of a constraint: what the velocities violate, while Φ = 0 is solved for. In the numbers of
    /// the solver, length/time for points and 1/time for directions. Second order in h, it need not grow.
    pub drift: f64,
    /// The largest |Φ| of a constraint, in the numbers of the solver, length for points and 1 for directions.
    pub violation: f64,
    /// Whether the rounding error of the residual ended an iteration.
    pub floor: bool,
}

impl StepReport {
    /// This report and that of the step after it, as one: counts of both, norms of the later.
    #[must_use]
    pub fn then(self, next: &Self) -> Self {
        Self {
            iterations: self.iterations + next.iterations,
            substeps: self.substeps + next.substeps,
            rejected: self.rejected + next.rejected,
            floor: self.floor || next.floor,
            ..*next
        }
    }
}

/// Integration of equations of motion in time.
#[derive(Debug)]
pub struct Dynamics<'a, E: EquationsOfMotion + ?Sized> {
    pub(super) eom: Current<'a, E>,
    pub(super) scheme: Scheme,
    pub(super) newton: Newton,
    max_halvings: u32,
    /// By how many halvings the next step begins: one less than the last one needed.
    halvings: u32,
    pub(super) state: State,
    /// The state before the current attempt.
    before: State,
    /// The scheme's auxiliary acceleration aₙ, for the step `h` that led here.
    auxiliary: Vec<f64>,
    h: f64,
    /// Whether accelerations are consistent and there is no step before.
    pub(super) fresh: bool,
    /// aₙ and aₙ₊₁ of the current attempt.
    pub(super) attempted: [Vec<f64>; 2],
    trend: Trend,
    phi: Vec<f64>,
    /// Energy and power of the current state.
    energy: Energy,
    power: Power,
    exchanged: Power,
}

impl<'a, E: EquationsOfMotion> Dynamics<'a, E> {
    /// Starts from a state, accelerations as they are (see [`restart`](Self::restart)); a step whose iteration fails is halved
    /// up to `max_halvings` times.
    pub fn new(eom: &'a E, scheme: Scheme, mut newton: Newton, max_halvings: u32, start: State) -> Self {
        newton.reuse();
        let auxiliary = start.a.clone();
        Self {
            eom: Current::new(eom),
            scheme,
            newton,
            max_halvings,
            halvings: 0,
            before: start.clone(),
            attempted: [auxiliary.clone(), auxiliary.clone()],
            auxiliary,
            trend: Trend::new(start.q.len() + start.lambda.len()),
            h: 0.0,
            fresh: false,
            phi: vec![0.0; start.lambda.len()],
            energy: eom.energy(&start),
            power: eom.power(&start),
            exchanged: Power::default(),
            state: start,
        }
    }

    /// The current state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The energies of the current state.
    pub fn energy(&self) -> Energy {
        self.energy
    }

    /// Work supplied and energy dissipated since the start, by the trapezoidal rule over the steps.
    pub fn exchanged(&self) -> Power {
        self.exchanged
    }

    /// Begins anew at a time t, at q and v as they are: at the start, and where loads or prescribed motions jump.
    ///
    /// Velocities are projected onto Φ_q v + Φ_t = 0, accelerations and multipliers follow from the equations of motion, and
    /// the scheme gets start values of its own. At a jump take the last step to `t.next_down()`, where loads are still those before it.
    ///
    /// # Errors
    /// If the mass matrix with the constraints is singular.
    pub fn restart(&mut self, t: f64) -> Result<(), SolveError> {
        self.state.t = t;
        self.take_in()?;
        let Newton { tangent, z, .. } = &mut self.newton;
        let (matrix, factor) = tangent.lend();
        let before = self.energy.kinetic;
        velocities(&*self.eom, matrix, factor, &mut self.state, z)?;
        self.energy = self.eom.energy(&self.state);
        if self.h > 0.0 {
            // A blow: prescribed motions whose rates jump do the work of impulses on the mean of both rates.
            self.exchanged.work += self.energy.kinetic - before;
        }
        accelerations(&*self.eom, matrix, factor, &mut self.state, z)?;
        self.auxiliary.copy_from_slice(&self.state.a);
        self.power = self.eom.power(&self.state);
        self.h = 0.0;
        self.fresh = true;
        self.trend.restart();
        Ok(())
    }

    /// Projects velocities onto Φ_q v + Φ_t = 0, and leaves accelerations and multipliers as they are.
    ///
    /// # Errors
    /// If the mass matrix with the constraints is singular.
    pub fn project_velocities(&mut self) -> Result<(), SolveError> {
        let Newton { tangent, z, .. } = &mut self.newton;
        let (matrix, factor) = tangent.lend();
        velocities(&*self.eom, matrix, factor, &mut self.state, z)?;
        self.energy = self.eom.energy(&self.state);
        self.power = self.eom.power(&self.state);
        Ok(())
    }

    /// Moves on to the time `to`, in one step if Newton's method converges, in 2, 4, 8, ... equal ones if it does not. After
    /// that, steps grow again by a factor of two each.
    ///
    /// # Errors
    /// If the smallest permitted step fails; the state is then that of the last converged step.
    pub fn advance(&mut self, to: f64) -> Result<StepReport, SolveError> {
        let mut report = StepReport::default();
        let mut halvings = self.halvings.min(self.max_halvings);
        let (mut h, mut left) = ((to - self.state.t) / f64::from(halvings).exp2(), 1_u64 << halvings);
        while left > 0 {
            match self.attempt(h, to - (left - 1) as f64 * h) {
                Ok(done) => {
                    self.accept(&done, &mut report);
                    left -= 1;
                }
                Err(error) => {
                    report.iterations += error.iterations;
                    if halvings == self.max_halvings || error.is_final() {
                        return Err(error);
                    }
                    (h, left, halvings) = (0.5 * h, 2 * left, halvings + 1);
                }
            }
        }
        self.halvings = halvings.saturating_sub(1);
        Ok(report)
    }

    /// Tries a step h that ends at the time `to`. Its end is then to be accepted or taken back; a failed one is taken back already.
    pub(super) fn attempt(&mut self, h: f64, to: f64) -> Result<Report, SolveError> {
        self.take_in()?;
        self.before.copy_from(&self.state);
        let mut spent = 0;
        loop {
            let done = match self.solve(h, to) {
                Ok(done) => done,
                Err(error) => {
                    self.take_back();
                    if error.is_final() || !self.newton.tangent.improve() {
                        return Err(error);
                    }
                    spent += error.iterations;
                    continue;
                }
            };
            let Some((eom, matrix)) = self.eom.completed(&self.state) else {
                return Ok(Report { iterations: spent + done.iterations, ..done });
            };
            // Something acts at the end that was not among the equations.
            self.take_back();
            self.renew(eom, matrix)?;
            spent += done.iterations;
        }
    }

    /// Takes in the terms that may soon act. To be called before the first look at the energy; steps do it by themselves.
    ///
    /// # Errors
    /// If memory does not suffice.
    pub fn take_in(&mut self) -> Result<(), SolveError> {
        match self.eom.ahead(&self.state) {
            Some((eom, matrix)) => {
                self.renew(eom, matrix)?;
                self.energy = self.eom.energy(&self.state);
                Ok(())
            }
            None => Ok(()),
        }
    }

    fn renew(&mut self, eom: E, matrix: SparseMatrix) -> Result<(), SolveError> {
        self.eom.replace(eom);
        self.newton.adopt(matrix)
    }

    fn solve(&mut self, h: f64, to: f64) -> Result<Report, SolveError> {
        let [auxiliary, next] = &mut self.attempted;
        if self.fresh && !self.scheme.is_newmark() {
            launch(&*self.eom, self.scheme, &mut self.newton, &mut self.state, auxiliary, h)?;
        } else {
            // a − v̇ is proportional to h (Brüls & Arnold 2008).
            let ratio = if self.h == 0.0 { 1.0 } else { h / self.h };
            for i in 0..auxiliary.len() {
                auxiliary[i] = self.state.a[i] + ratio * (self.auxiliary[i] - self.state.a[i]);
            }
        }
        self.scheme.predict(&mut self.state, auxiliary, h);
        self.state.t = to;
        let weights = self.scheme.weights(h);
        if self.newton.tangent.is_reusable() {
            self.trend.add_to(&mut self.state, weights, h);
        }
        let done = self.newton.solve(&*self.eom, &mut self.state, weights)?;
        if let Some(worst) = self.eom.inadmissible(&self.state) {
            return Err(SolveError::after(done, to, Failure::Inverted, worst));
        }
        for i in 0..next.len() {
            next[i] = self.scheme.auxiliary(auxiliary[i], self.before.a[i], self.state.a[i]);
        }
        Ok(done)
    }

    /// Returns to the state before the attempt.
    pub(super) fn take_back(&mut self) {
        self.state.copy_from(&self.before);
    }

    /// Makes the end of the attempt the current state.
    pub(super) fn accept(&mut self, done: &Report, report: &mut StepReport) {
        self.h = self.state.t - self.before.t;
        self.trend.note(&self.before, &self.state, self.h, &self.newton.tangent.factor);
        self.fresh = false;
        std::mem::swap(&mut self.auxiliary, &mut self.attempted[1]);
        self.energy = self.eom.energy(&self.state);
        self.newton.met(self.energy.largest());
        let power = self.eom.power(&self.state);
        self.exchanged.work += 0.5 * self.h * (self.power.work + power.work);
        self.exchanged.dissipation += 0.5 * self.h * (self.power.dissipation + power.dissipation);
        self.power = power;
        report.iterations += done.iterations;
        report.substeps += 1;
        report.residual = done.residual;
        report.increment = done.increment;
        report.drift = self.largest(Level::Velocity);
        report.violation = self.largest(Level::Position);
        report.floor |= done.floor;
    }

    /// The largest constraint at a level.
    fn largest(&mut self, level: Level) -> f64 {
        self.eom.constraints(&self.state, level, &mut self.phi);
        self.phi.iter().fold(0.0, |largest, phi| phi.abs().max(largest))
    }
}
