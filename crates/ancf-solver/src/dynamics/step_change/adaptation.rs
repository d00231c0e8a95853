use super::LARGEST_RATIO;
use super::auxiliary::Auxiliary;
use super::memory::StepMemory;
use super::reference::StepReference;
use crate::dynamics::scheme::SchemeCoefficients;
use crate::dynamics::start::solve_again;
use crate::equations::{EquationsOfMotion, Level, State, Weights};
use crate::factor::Factor;
use crate::newton::{Newton, NewtonTangent, SolveError};
use crate::sparse::SparseMatrix;

/// Adapts the memory of a scheme to a step h of another size than the last one, H.
///
/// For a smooth motion, the difference a − v̇ is proportional to the step (Brüls & Arnold 2008). Velocities along constraints,
/// u = Φ_q v + Φ_t, are errors proportional to its square; a step h after a step H would change the accelerations by
/// (H² − h²)/(β h). Both are multiplied by their ratios.
///
/// Vibrations that the step does not resolve have no such limits. Their part of a − v̇ would grow with each change, so the change is
/// filtered by the iteration matrix S of the new step, which leaves motions that are slower than the step:
///
/// [S, Φ_qᵀ; Φ_q, 0] (x, ·) = (M y, Φ_q y),  a ← a + x,  y = (h/H − 1) (a − v̇),
/// [S, Φ_qᵀ; Φ_q, 0] (w, ·) = (0, u),  v ← v + (h²/H² − 1) w.
///
/// A growth after short steps starts from the last longer step ([`StepReference`]) with its mean acceleration ā:
/// y = v̇ + (h/H) (a − v̇) − ā, a ← ā + x, and Φ_q w of that step replaces u. Undamped schemes conserve the energy of all
/// vibrations and scale a − v̇ without a filter.
///
/// The change of the kinetic energy is part of the energy that the next step makes or loses. The factorised S is the tangent of the next
/// step.
///
/// # Errors
/// If S with the constraints is singular.
pub(crate) fn adapt<E: EquationsOfMotion>(
    eom: &E,
    newton: &mut Newton,
    scheme: SchemeCoefficients,
    memory: StepMemory<'_>,
    h: f64,
) -> Result<(), SolveError> {
    let growth = h / *memory.h;
    let (is_filtered, is_constrained) = (!scheme.is_conservative(), !memory.state.lambda.is_empty());
    let StepMemory { state: s, auxiliary, mut damping, h: last, reference } = memory;
    let mut acceleration = Auxiliary { auxiliary, actual: &s.a };
    let is_first = growth < 1.0 && reference.as_ref().is_none_or(|longer| longer.is_replaced_by(*last));
    if is_first {
        *reference = Some(Box::new(StepReference::new(*last, &acceleration, &damping)));
    }
    *last = h;
    let longer = reference.as_deref().and_then(|longer| Some((longer, longer.ratio(h, growth)?)));
    let recent = longer.filter(|(longer, _)| longer.is_recent());
    let own = growth.min(LARGEST_RATIO);
    let ratio = (recent.map_or(own, |(_, ratio)| ratio), recent.is_some());
    let Newton { tangent, r, z, .. } = newton;
    let (matrix, _) = tangent.lend();
    eom.tangent(s, Weights::MASS, matrix);
    let target_velocities = recent.map(|(longer, ratio)| longer.constraint_velocities(matrix, ratio, z, r));
    let mut force = Vec::new();
    if is_filtered {
        acceleration.start(longer.map(|(longer, _)| &longer.acceleration), ratio, z);
        matrix.multiply(z, r);
        z.copy_from_slice(r);
        if damping.actual.iter().chain(&*damping.auxiliary).any(|x| *x != 0.0) {
            force = vec![0.0; z.len()];
            damping.start(longer.map(|(longer, _)| &longer.damping), ratio, &mut force);
        }
    } else {
        acceleration.scale(growth);
        damping.scale(growth);
    }
    tangent.prepare(eom, s, scheme.weights(h)).map_err(|failure| SolveError::at(s.t, failure))?;
    let NewtonTangent { matrix, factor, .. } = tangent;
    if is_filtered {
        solve_again(matrix, factor, s, z)?;
        acceleration.add(z);
    }
    if !force.is_empty() {
        // Before the velocities change, of which the tangent is a function.
        solve_again(matrix, factor, s, &mut force)?;
        eom.tangent(s, Weights::MASS, matrix);
        matrix.multiply(&force, r);
        damping.add(r);
        eom.tangent(s, scheme.weights(h), matrix);
    }
    if is_constrained {
        let kept = own * own;
        let target = |i: usize, u: f64| {
            target_velocities.as_ref().map_or(kept * u, |target_velocities| target_velocities[i])
        };
        change_drift(eom, (matrix, factor), s, target, z)?;
        if let Some(reference) = reference.as_deref_mut().filter(|_| is_first) {
            reference.set_drift(z.iter().map(|change| change / (kept - 1.0)));
        }
    }
    Ok(())
}

/// Changes each velocity along a constraint, u, to `target(i, u)`. `z` receives the change of the velocities.
fn change_drift<E: EquationsOfMotion>(
    eom: &E,
    (matrix, factor): (&SparseMatrix, &mut Factor),
    s: &mut State,
    target: impl Fn(usize, f64) -> f64,
    z: &mut [f64],
) -> Result<(), SolveError> {
    let (change, drift) = z.split_at_mut(s.q.len());
    change.fill(0.0);
    eom.constraints(s, Level::Velocity, drift);
    drift.iter_mut().enumerate().for_each(|(i, u)| *u = target(i, *u) - *u);
    solve_again(matrix, factor, s, z)?;
    s.v.iter_mut().zip(&*z).for_each(|(v, change)| *v += change);
    Ok(())
}
