use super::fast_motions::FastMotions;
use super::initial_conditions::{Factors, Projected, accelerations, project, solve};
use super::products::{difference, magnitudes, multiply};
use crate::dynamics::scheme::SchemeCoefficients;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::{Newton, SolveError};

/// Difference interval for the rate of the acceleration, relative to the step size.
const DIFFERENCE_INTERVAL: f64 = 1.0 / 16.0;
/// Second difference of accelerations, relative to the first one, up to which the rate is accepted at once.
const SMOOTH: f64 = 0.25;
/// Factor between intervals, and largest number of smaller ones.
const REFINEMENT: f64 = 1.0 / 16.0;
const REFINEMENTS: i32 = 5;
/// Change of the velocities in a step by the difference of two rates, relative to the velocities, at which a rate is accepted, and above
/// which no rate is used.
const ACCEPTED: f64 = 1e-3;
const REJECTED: f64 = 1e-2;
/// Projections of a state onto the constraints. Three steps with one Jacobian reduce their small violation ε to ε⁴.
const PROJECTIONS: [Projected; 4] = [
    Projected::Positions,
    Projected::PositionsByLastFactors,
    Projected::PositionsByLastFactors,
    Projected::Velocities,
];

/// Rates of accelerations and damping forces at the start.
pub(super) struct Rates {
    pub(super) acceleration: Vec<f64>,
    pub(super) damping: Vec<f64>,
    /// First and second differences of the accelerations.
    differences: [Vec<f64>; 2],
}

/// Computes the rates of accelerations and damping forces for a first step h.
///
/// A stiff body that starts to rotate without strain is an example of large second differences: along the straight lines of its
/// points it is stretched by ½(ωδ)², and its elastic accelerations exceed all others. Their error in v̈, of the order (c/l)² ω³ δ² with the speed of
/// sound c, is a rigid rotation, which no filter removes. Smaller intervals remove it; the rates of two intervals are compared in
/// the norm of the kinetic energy. Without agreement the rates are zero, which leaves an error of the first order in the auxiliary
/// acceleration.
pub(super) fn start_rates<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    at_start: (&FastMotions, &[f64]),
    (scheme, h): (SchemeCoefficients, f64),
) -> Result<Rates, SolveError> {
    let rates_for = |newton: &mut Newton, k: i32| {
        let delta = h * DIFFERENCE_INTERVAL * REFINEMENT.powi(k);
        rates(eom, newton, s, at_start, (delta, h, scheme.weights(h)))
    };
    let mut last = rates_for(newton, 0)?;
    let [first, second] = magnitudes(eom, newton, s, last.differences.each_ref().map(|x| &x[..]));
    if second <= SMOOTH * first {
        return Ok(last);
    }
    let [speed, acceleration] = magnitudes(eom, newton, s, [&s.v, &s.a]);
    let (speed, n) = (speed + h * acceleration, s.q.len());
    let filtered_rate = |newton: &mut Newton, rates: &Rates| {
        filter(eom, newton, s, &rates.acceleration, scheme.weights(h)).map(|()| newton.z[..n].to_vec())
    };
    let mut filtered = filtered_rate(newton, &last)?;
    let mut least = f64::INFINITY;
    let mut best = None;
    for k in 1..=REFINEMENTS {
        let next = rates_for(newton, k)?;
        let other = filtered_rate(newton, &next)?;
        let apart = difference(&filtered, &other);
        let [change] = magnitudes(eom, newton, s, [&apart]).map(|apart| h * h * apart);
        if change <= ACCEPTED * speed {
            return Ok(next);
        }
        if change < least {
            (least, best) = (change, Some(next));
        }
        filtered = other;
    }
    match best {
        Some(rates) if least <= REJECTED * speed => Ok(rates),
        _ => {
            last.acceleration.fill(0.0);
            last.damping.fill(0.0);
            Ok(last)
        }
    }
}

/// Computes the rate of the acceleration without motions that are faster than the step into `newton.z`, and its forces (M v̈, Φ_q v̈)
/// into `newton.r`: [S, Φ_qᵀ; Φ_q, 0] (x, ·) = (M v̈, Φ_q v̈), S with the weights `w`.
pub(super) fn filter<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    rate: &[f64],
    w: Weights,
) -> Result<(), SolveError> {
    eom.tangent(s, Weights::MASS, newton.tangent.lend().0);
    multiply(newton, rate);
    let Newton { tangent, r, z, .. } = newton;
    let (matrix, factor) = tangent.lend();
    z.copy_from_slice(r);
    solve(eom, matrix, factor, s, w, z)
}

/// Returns the state at a time d later on a parabola through a state.
pub(super) fn ahead(s: &State, d: f64) -> State {
    let mut ahead = s.clone();
    for i in 0..s.q.len() {
        ahead.q[i] += d * (s.v[i] + 0.5 * d * s.a[i]);
        ahead.v[i] += d * s.a[i];
    }
    ahead.t += d;
    ahead
}

/// Computes v̈ from consistent accelerations along a parabola through a state: [−3v̇(0) + 4v̇(δ) − v̇(2δ)]/(2δ), and the
/// rate of the damping forces in the same way.
///
/// The states on the parabola are projected onto the constraints of positions and velocities. The differences are
/// one-sided, since loads may jump at the start. Quadratic terms cancel, including the error of the parabola in v.
///
/// In a moving system, large accelerations of [motions much faster](FastMotions) than the step are removed at each point of the parabola, as they are
/// from the state. They turn with a body that rotates, so that their rates have a moment about its center, which no filter removes from
/// a rate.
fn rates<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    (fast, damping): (&FastMotions, &[f64]),
    (delta, h, w): (f64, f64, Weights),
) -> Result<Rates, SolveError> {
    let (mut near, mut near_damping) = state_ahead(eom, newton, s, delta)?;
    let (mut far, mut far_damping) = state_ahead(eom, newton, s, 2.0 * delta)?;
    let mut start = sum(&s.a, &fast.acceleration);
    let mut start_damping = sum(damping, &fast.damping);
    let change = difference(&near.a, &start);
    let [change, speed, acceleration] = magnitudes(eom, newton, s, [&change, &s.v, &s.a]);
    let is_large = h * h / delta * change > ACCEPTED * (speed + h * acceleration);
    if speed > 0.0 && (is_large || fast.filter.is_active) {
        fast.filter.remove(eom, newton, (&mut near, &mut near_damping), w)?;
        fast.filter.remove(eom, newton, (&mut far, &mut far_damping), w)?;
        start.copy_from_slice(&s.a);
        start_damping.copy_from_slice(damping);
    }
    let rate = |start: &[f64], near: &[f64], far: &[f64]| -> Vec<f64> {
        let values = start.iter().zip(near).zip(far);
        values.map(|((start, near), far)| (-1.5 * start + 2.0 * near - 0.5 * far) / delta).collect()
    };
    let first = difference(&near.a, &start);
    let second = difference(&difference(&far.a, &near.a), &first);
    Ok(Rates {
        acceleration: rate(&start, &near.a, &far.a),
        damping: rate(&start_damping, &near_damping, &far_damping),
        differences: [first, second],
    })
}

fn sum(x: &[f64], y: &[f64]) -> Vec<f64> {
    x.iter().zip(y).map(|(x, y)| x + y).collect()
}

/// Returns the state at a time d later on a parabola through a state, with consistent velocities and accelerations, and its damping
/// forces.
fn state_ahead<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    d: f64,
) -> Result<(State, Vec<f64>), SolveError> {
    let mut ahead = ahead(s, d);
    let Newton { tangent, z, r, .. } = newton;
    let (matrix, factor) = tangent.lend();
    // Beside the constraints, accelerations depend on the form of their equations.
    let (mut projected, mut factors) = (ahead.clone(), Factors::OfOtherState);
    let mut is_projected = |part| {
        let done = project(eom, matrix, factor, &mut projected, part, z);
        done.is_ok_and(|of| {
            factors = of;
            true
        })
    };
    if PROJECTIONS.into_iter().all(&mut is_projected) {
        ahead = projected;
    } else {
        factors = Factors::OfOtherState;
    }
    accelerations(eom, matrix, factor, &mut ahead, z, factors)?;
    eom.exchange(&ahead, r);
    let damping = r[..s.q.len()].to_vec();
    Ok((ahead, damping))
}
