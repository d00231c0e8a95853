use super::fast_part::{fast_damping, fast_part, linear_forces};
use super::initial_conditions::factorise;
use super::products::{difference, magnitudes};
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Largest difference of the parts of two intervals, relative to the part, and smallest part, relative to all accelerations.
const AGREE: f64 = 0.02;
const NEGLIGIBLE: f64 = 1e-6;
/// First interval of the differences, relative to the step, factor between intervals, and their largest number. Rounding errors grow with
/// the square of the factor.
const FIRST: f64 = 1.0 / 16.0;
const REFINEMENT: f64 = 0.25;
const INTERVALS: i32 = 11;
/// Angle by which a body turns in a step: largest change of the velocities by c in a step, relative to the velocities.
const TURN: f64 = 0.3;

/// Part c of the accelerations v̇ at a start in motions that are much faster than the first step, and of the damping forces.
///
/// With the iteration matrix S of the step and its weights,
///
/// [S, Φ_qᵀ; Φ_q, 0] (e, ·) = (w_q f̈ + w_v Ḟ, 0),   c = (1 − U)² e,   [S, Φ_qᵀ; Φ_q, 0] (U x, ·) = (M x, 0).
///
/// F are the damping forces, and f is the residual without them at the accelerations and multipliers of the state. f̈ and Ḟ are
/// derivatives along a parabola through the state:
///
/// w_q f̈ + w_v Ḟ = (S − M) v̇ + w_q f_qq(v, v) + w_v F_q v.
///
/// The last two terms are differences along the straight line q + v d, since huge accelerations dominate those along the parabola.
/// In a linear mode of frequency ω and decay rate ζω, f̈ = M ω² v̇ and Ḟ = 2ζω M v̇.
/// Hence c = [y/(1 + y)]³ v̇ with y = w_q ω² + 2ζω w_v: all of v̇ if the motion is much faster than the step, and an error of the order
/// h⁶ (h³ with damping) if the step resolves it. In a rotating body f̈ contains the change of the strains only, so its centripetal
/// accelerations are no part of c.
///
/// At a jump within a motion c is the part of the change of the accelerations. Vibrations that the scheme carries remain. There and at
/// rest, w_q f̈ + w_v Ḟ = (S − M) v̇ without differences.
///
/// The interval of the differences is reduced until two results agree. Where the forces are not smooth, as before an impact,
/// none agree, and c is zero. So it is if it exceeds the acceleration and would change the velocities in a step by more than a rotation
/// does.
pub(super) struct FastMotions {
    /// Part c of the accelerations.
    pub(super) acceleration: Vec<f64>,
    /// Part of the damping forces.
    pub(super) damping: Vec<f64>,
    /// Filter of other states near the start.
    pub(super) filter: FastFilter,
}

/// Filter of accelerations of motions that are much faster than the step.
pub(super) struct FastFilter {
    /// Accelerations whose fast motions remain: those before a jump, or zero.
    reference: Vec<f64>,
    /// Interval of the differences along a straight line.
    interval: Option<f64>,
    /// False if the accelerations at the start have no fast part, or none that is known: the filter is then that of their change.
    pub(super) is_active: bool,
}

impl FastFilter {
    /// Computes the fast part of the accelerations of a state.
    fn part<E: EquationsOfMotion>(
        &self,
        eom: &E,
        newton: &mut Newton,
        s: &State,
        w: Weights,
    ) -> Result<Vec<f64>, SolveError> {
        let (matrix, factor) = newton.tangent.lend();
        factorise(eom, matrix, factor, s, w)?;
        let linear = linear_forces(eom, newton, s, &difference(&s.a, &self.reference));
        let forces = match self.interval {
            Some(interval) => force_changes(eom, s, &linear, interval, w),
            None => linear,
        };
        fast_part(eom, newton, s, &forces, w)
    }

    /// Removes the fast parts of the accelerations of a state and of its damping forces.
    pub(super) fn remove<E: EquationsOfMotion>(
        &self,
        eom: &E,
        newton: &mut Newton,
        (s, damping): (&mut State, &mut [f64]),
        w: Weights,
    ) -> Result<(), SolveError> {
        let part = self.part(eom, newton, s, w)?;
        let of_damping = fast_damping(eom, newton, s, (&part, damping), w)?;
        s.a.iter_mut().zip(&part).for_each(|(a, fast)| *a -= fast);
        damping.iter_mut().zip(&of_damping).for_each(|(force, fast)| *force -= fast);
        Ok(())
    }
}

impl FastMotions {
    /// Computes the parts for a first step h with the weights `w`; they are zero if they are negligible or unknown. `before_jump` are the
    /// accelerations before a jump within a motion.
    pub(super) fn at<E: EquationsOfMotion>(
        eom: &E,
        newton: &mut Newton,
        (s, before_jump): (&State, Option<&[f64]>),
        damping: &[f64],
        (h, w): (f64, Weights),
    ) -> Result<Self, SolveError> {
        let n = s.q.len();
        let reference = before_jump.map_or_else(|| vec![0.0; n], <[f64]>::to_vec);
        let change = difference(&s.a, &reference);
        let [whole, all, speed] = magnitudes(eom, newton, s, [&change, &s.a, &s.v]);
        let is_linear = before_jump.is_some() || speed == 0.0;
        if is_linear && whole <= NEGLIGIBLE * all {
            return Ok(Self::none(s));
        }
        let (matrix, factor) = newton.tangent.lend();
        factorise(eom, matrix, factor, s, w)?;
        let linear = linear_forces(eom, newton, s, &change);
        let (part, interval) = if is_linear {
            let part = fast_part(eom, newton, s, &linear, w)?;
            let [size] = magnitudes(eom, newton, s, [&part]);
            ((size > NEGLIGIBLE * all && size <= (1.0 + AGREE) * whole).then_some(part), None)
        } else {
            let limits = [NEGLIGIBLE * whole, ((1.0 + AGREE) * whole).max(TURN * speed / h)];
            part_of_differences(eom, newton, s, &linear, limits, (h, w))?.unzip()
        };
        let Some(acceleration) = part else { return Ok(Self::none(s)) };
        let damping = fast_damping(eom, newton, s, (&acceleration, damping), w)?;
        Ok(Self { acceleration, damping, filter: FastFilter { reference, interval, is_active: true } })
    }

    /// No fast motions in a state.
    fn none(s: &State) -> Self {
        let zeros = vec![0.0; s.q.len()];
        let filter = FastFilter { reference: s.a.clone(), interval: None, is_active: false };
        Self { acceleration: zeros.clone(), damping: zeros, filter }
    }
}

/// Returns c of the accelerations of a moving system for the forces (S − M) v̇ and differences along a straight line, and the interval
/// of the differences; `None` if c is not within limits or the forces are not smooth.
fn part_of_differences<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    linear: &[f64],
    [least, most]: [f64; 2],
    (h, w): (f64, Weights),
) -> Result<Option<(Vec<f64>, f64)>, SolveError> {
    let mut last: Option<Vec<f64>> = None;
    for k in 0..INTERVALS {
        let interval = h * FIRST * REFINEMENT.powi(k);
        let forces = force_changes(eom, s, linear, interval, w);
        if forces.iter().any(|force| !force.is_finite()) {
            continue;
        }
        let part = fast_part(eom, newton, s, &forces, w)?;
        let apart = last.as_ref().map(|last| difference(&part, last)).unwrap_or_default();
        let [size, apart] = magnitudes(eom, newton, s, [&part, &apart]);
        if size <= least {
            return Ok(None);
        }
        if last.is_some() && apart <= AGREE * size && size <= most {
            return Ok(Some((part, interval)));
        }
        last = Some(part);
    }
    Ok(None)
}

/// Computes the sum of `linear`, (S − M) v̇, and of w_q f_qq(v, v) + w_v F_q v from one-sided differences of the interval `delta` along
/// a straight line.
fn force_changes<E: EquationsOfMotion>(
    eom: &E,
    s: &State,
    linear: &[f64],
    delta: f64,
    w: Weights,
) -> Vec<f64> {
    let [mut sum, mut residual, mut damping] = [(); 3].map(|()| vec![0.0; s.q.len() + s.lambda.len()]);
    let [second, first] = [w.q / (delta * delta), w.v / (2.0 * delta)];
    for (steps, of) in [(0.0, [1.0, -3.0]), (1.0, [-2.0, 4.0]), (2.0, [1.0, -1.0])] {
        let mut ahead = s.clone();
        ahead.q.iter_mut().zip(&s.v).for_each(|(q, v)| *q += steps * delta * v);
        ahead.t += steps * delta;
        eom.residual(&ahead, &mut residual);
        eom.exchange(&ahead, &mut damping);
        for (i, sum) in sum[..s.q.len()].iter_mut().enumerate() {
            *sum += of[0] * second * (residual[i] - damping[i]) + of[1] * first * damping[i];
        }
    }
    sum.iter_mut().zip(linear).for_each(|(sum, linear)| *sum += linear);
    sum
}
