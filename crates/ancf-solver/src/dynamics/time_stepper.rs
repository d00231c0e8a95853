use super::damping_work::DampingAttempt;
use super::energy_guard::{EnergyAttempt, EnergyGuard, EnergyRecord, POSITION_ROUNDING, fastest_change};
use super::energy_momentum::StepMiddle;
use super::integration_state::IntegrationState;
use super::scheme::SchemeCoefficients;
use super::start::{StartValues, start_values};
use super::step_change::SavedMemory;
use super::step_report::StepReport;
use crate::equations::{ActiveGroup, Energy, EquationsOfMotion, Inadmissibility, Level, Power, State};
use crate::newton::{ActiveSet, Newton, NewtonReport, SolveError, SolveFailure};
use crate::sparse::SparseMatrix;
use crate::vectors::for_each_chunk;

/// Ratio of the rounding errors of positions to those of the equations: joints with short levers amplify them.
const LEVERAGE: f64 = 1e3;

/// Time integration of the equations of motion.
#[derive(Debug)]
pub struct TimeStepper<'a, E: EquationsOfMotion + ?Sized> {
    pub(crate) eom: ActiveSet<'a, E>,
    pub(crate) scheme: SchemeCoefficients,
    pub(crate) newton: Newton,
    pub(crate) max_halvings: u32,
    pub(crate) motion: IntegrationState,
    /// Contact groups at the last accepted step, if they have changed since.
    pub(crate) active: Option<Vec<ActiveGroup>>,
    /// State before the current attempt, and the middle of a step.
    pub(crate) before: State,
    pub(crate) middle: StepMiddle,
    /// Auxiliary accelerations aₙ and aₙ₊₁ of the current attempt.
    pub(crate) attempted: [Vec<f64>; 2],
    /// Memory of the scheme before it was adapted to the size of the current attempt.
    pub(crate) last_memory: Option<Box<SavedMemory>>,
    phi: Vec<f64>,
    /// Values at the start of the attempt after a restart.
    start: StartValues,
    /// Damping forces at the end of the attempt.
    pub(crate) damping: DampingAttempt,
    pub(crate) energies: EnergyAttempt,
    pub(crate) guard: EnergyGuard,
}

impl<'a, E: EquationsOfMotion> TimeStepper<'a, E> {
    /// Starts from a state with its accelerations (see [`restart`](Self::restart)).
    ///
    /// A step whose iteration fails is halved up to `max_halvings` times.
    pub fn new(
        eom: &'a E,
        scheme: SchemeCoefficients,
        newton: Newton,
        max_halvings: u32,
        start: State,
    ) -> Self {
        Self::with_equations(ActiveSet::new(eom), scheme, newton, max_halvings, start)
    }

    pub(crate) fn with_equations(
        eom: ActiveSet<'a, E>,
        scheme: SchemeCoefficients,
        mut newton: Newton,
        max_halvings: u32,
        start: State,
    ) -> Self {
        newton.permit_reuse(&start);
        if scheme.averaging.is_some() {
            newton.expect_linear_convergence();
        }
        let auxiliary = start.a.clone();
        Self {
            scheme,
            newton,
            max_halvings,
            active: None,
            before: start.clone(),
            middle: StepMiddle::new(&start),
            attempted: [auxiliary.clone(), auxiliary],
            phi: vec![0.0; start.lambda.len()],
            start: StartValues::new(start.q.len(), start.lambda.len()),
            damping: DampingAttempt::new(start.q.len(), start.lambda.len()),
            energies: EnergyAttempt::default(),
            last_memory: None,
            guard: EnergyGuard::default(),
            motion: IntegrationState::new(start, &*eom),
            eom,
        }
    }

    /// Sets the limits of the energy that steps may make.
    #[must_use]
    pub fn with_energy_guard(self, guard: EnergyGuard) -> Self {
        Self { guard, ..self }
    }

    /// Returns the current state.
    pub fn state(&self) -> &State {
        &self.motion.state
    }

    /// Returns the energies of the current state.
    pub fn energy(&self) -> Energy {
        self.motion.energy
    }

    /// Returns the work supplied and the energy dissipated since the start.
    ///
    /// The dissipated energy is the work of the damping forces with the impulses and mean velocities of the scheme.
    pub fn energy_exchange(&self) -> Power {
        self.motion.exchanged
    }

    /// Returns the energy that the integration itself made or lost since the start, and the energy of rounding errors.
    pub fn energy_record(&self) -> (EnergyRecord, f64) {
        (self.motion.record, self.rounding_energy() + self.motion.record.rounding())
    }

    /// Returns the energy of rounding errors: that of the stiffness and inertia, and the work of all forces over the rounding errors of
    /// a unit size of the coordinates.
    ///
    /// A body that joints hold under its weight has no other energy.
    fn rounding_energy(&self) -> f64 {
        let mut floor = vec![0.0; self.eom.coordinates() + self.eom.multipliers()];
        self.eom.rounding(&self.motion.state, &mut floor);
        self.newton.rounding_energy() + LEVERAGE * floor[..self.eom.coordinates()].iter().sum::<f64>()
    }

    /// Returns the work of loads over the rounding error of a length.
    pub fn rounding_work(&self, length: f64) -> f64 {
        POSITION_ROUNDING * length * self.eom.supplied_forces(&self.motion.state)
    }

    /// Attempts a step h that ends at the time `to`.
    ///
    /// The caller accepts or reverts the result. A failed attempt has already been reverted.
    pub(crate) fn attempt(&mut self, h: f64, to: f64) -> Result<NewtonReport, SolveError> {
        self.include_near_terms()?;
        self.before.copy_from(&self.motion.state);
        let mut spent = 0;
        loop {
            let done = match self.solve(h, to) {
                Ok(done) => done,
                Err(error) => {
                    self.revert();
                    if error.is_final() || !self.newton.tangent.request_newer() {
                        return Err(error);
                    }
                    spent += error.iterations;
                    continue;
                }
            };
            let Some((eom, matrix)) = self.eom.with_active_terms(&self.motion.state) else {
                if let Some(at) = self.eom.crossing(&self.before, &self.motion.state) {
                    self.revert();
                    return Err(SolveError::after(done, to, SolveFailure::Crossed, at));
                }
                let done = NewtonReport { iterations: spent + done.iterations, ..done };
                return self.check_energy(done, to);
            };
            // A term that is active at the end was not included.
            self.revert();
            self.replace_equations(eom, matrix)?;
            spent += done.iterations;
        }
    }

    /// Includes the terms that may become active soon. Must be called before the first evaluation of the energy.
    ///
    /// Steps call it automatically.
    ///
    /// # Errors
    /// If the memory does not suffice.
    pub fn include_near_terms(&mut self) -> Result<(), SolveError> {
        match self.eom.with_near_terms(&self.motion.state) {
            Some((eom, matrix)) => {
                self.replace_equations(eom, matrix)?;
                self.motion.energy = self.eom.energy(&self.motion.state);
                Ok(())
            }
            None => Ok(()),
        }
    }

    pub(crate) fn replace_equations(&mut self, eom: E, matrix: SparseMatrix) -> Result<(), SolveError> {
        if self.active.is_none() {
            self.active = Some(self.eom.active_groups());
        }
        self.eom.replace(eom);
        self.newton.replace_matrix(matrix)
    }

    fn solve(&mut self, h: f64, to: f64) -> Result<NewtonReport, SolveError> {
        let [auxiliary, _] = &mut self.attempted;
        if self.motion.at_start && !self.scheme.is_newmark() {
            let IntegrationState { state, before_jump, .. } = &mut self.motion;
            let start = (&mut auxiliary[..], &mut self.start);
            start_values(
                &*self.eom,
                self.scheme,
                &mut self.newton,
                (state, before_jump.as_deref()),
                start,
                h,
            )?;
        } else {
            self.motion.scale_auxiliary(h, auxiliary);
        }
        self.scheme.predict(&mut self.motion.state, auxiliary, h);
        self.motion.state.t = to;
        let weights = self.scheme.weights(h);
        if self.newton.has_energy_rule() {
            let is_extrapolated = self.newton.tangent.is_reusable();
            let IntegrationState { predictor, state, .. } = &mut self.motion;
            predictor.add_to(&*self.eom, (&self.before, state), (h, weights), is_extrapolated);
        }
        let done = match self.scheme.averaging {
            None => self.newton.solve(&*self.eom, &mut self.motion.state, weights)?,
            Some(damping) => {
                let (newton, ends) = (&mut self.newton, (&self.before, &mut self.motion.state));
                self.middle.solve(&*self.eom, newton, ends, damping, weights)?
            }
        };
        let [auxiliary, next] = &mut self.attempted;
        let half_turn =
            || Some((self.eom.half_turn(&self.before, &self.motion.state)?, Inadmissibility::HalfTurn));
        if let Some((worst, reason)) = self.eom.inadmissible(&self.motion.state).or_else(half_turn) {
            return Err(SolveError::after(done, to, SolveFailure::Inadmissible(reason), worst));
        }
        if let Some(angle) = self.motion.ambiguous_angle(&self.before, self.eom.counted_angles()) {
            return Err(SolveError::after(done, to, SolveFailure::AmbiguousTurns, angle));
        }
        let is_started = self.motion.at_start && !self.scheme.is_newmark();
        let before = if is_started { &self.start.acceleration } else { &self.before.a };
        for_each_chunk(next, |range, next| {
            for (next, i) in next.iter_mut().zip(range) {
                *next = self.scheme.auxiliary(auxiliary[i], before[i], self.motion.state.a[i]);
            }
        });
        Ok(done)
    }

    /// Computes energies, work and dissipation at the end of an attempt. Reverts it if it made too much energy.
    fn check_energy(&mut self, done: NewtonReport, to: f64) -> Result<NewtonReport, SolveError> {
        let Self { eom, motion, before, damping, start, scheme, .. } = self;
        let (power, exchange, decrease) = match scheme.averaging {
            None => motion.exchange_of_step(&**eom, *scheme, before, start, damping),
            Some(_) => {
                let (power, exchange) =
                    self.middle.exchange(&**eom, (before, &motion.state), &mut damping.force);
                (power, exchange, 0.0)
            }
        };
        let energy = eom.energy(&motion.state);
        let mut record = motion.record.after((motion.energy, energy), exchange, decrease);
        let mut is_permitted = self.guard.permits(&record, || self.rounding_energy());
        if !is_permitted {
            record.include_size(self.eom.energy_size(&self.motion.state));
            is_permitted = self.guard.permits(&record, || 0.0);
        }
        self.energies = EnergyAttempt { energy, power, exchange, record, ..self.energies };
        if is_permitted {
            return Ok(done);
        }
        self.energies.rejected = self.energies.rejected.saturating_add(1);
        let worst = fastest_change(&self.motion.state, &self.before, &self.newton.tangent.factor);
        self.revert();
        Err(SolveError::after(done, to, SolveFailure::EnergyMade, worst))
    }

    /// Reverts to the state before the attempt.
    pub(crate) fn revert(&mut self) {
        self.motion.state.copy_from(&self.before);
    }

    /// Accepts the end of the attempt as the current state.
    pub(crate) fn accept(&mut self, done: &NewtonReport, report: &mut StepReport) {
        let EnergyAttempt { energy, power, exchange, record, rejected } = std::mem::take(&mut self.energies);
        self.motion.exchanged += exchange;
        (self.motion.energy, self.motion.power, self.motion.record) = (energy, power, record);
        self.motion.record.rejected = record.rejected.saturating_add(rejected);
        self.motion.damping.accept(&self.damping);
        self.motion.h = self.motion.state.t - self.before.t;
        self.motion.adapted_h = self.motion.h;
        let IntegrationState { predictor, state, h, .. } = &mut self.motion;
        predictor.record([&self.before, state], (*h, self.scheme.weights(*h)), &mut self.newton);
        (self.motion.at_start, self.motion.before_jump) = (false, None);
        if let Some(errors) = &mut self.motion.errors {
            errors.advance(&*self.eom, &mut self.newton, (&self.before, &self.motion.state));
        }
        if self.scheme.averaging.is_some() {
            // A tangent belongs to both ends of its step.
            self.newton.tangent.renew();
        }
        std::mem::swap(&mut self.motion.auxiliary, &mut self.attempted[1]);
        self.motion.record_reference();
        self.last_memory = None;
        self.newton.record_energy(self.motion.energy.largest());
        (report.iterations, report.substeps) = (report.iterations + done.iterations, report.substeps + 1);
        (report.residual, report.increment) = (done.residual, done.increment);
        (report.drift, report.violation) = (self.largest(Level::Velocity), self.largest(Level::Position));
        report.floor |= done.floor;
        self.save_restart_point();
    }

    /// Saves the state to which a failed next step returns.
    pub(crate) fn save_restart_point(&mut self) {
        self.active = None;
        self.newton.tangent.save();
    }

    /// Returns the largest magnitude of the constraints at a level.
    fn largest(&mut self, level: Level) -> f64 {
        self.eom.constraints(&self.motion.state, level, &mut self.phi);
        self.phi.iter().fold(0.0, |largest, phi| phi.abs().max(largest))
    }
}
