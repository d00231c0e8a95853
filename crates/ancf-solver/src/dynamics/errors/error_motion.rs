use serde::{Deserialize, Serialize};

use super::quadrature::Defect;
use crate::dynamics::scheme::SchemeCoefficients;
use crate::equations::{EquationsOfMotion, State};
use crate::newton::Newton;

/// Scheme of the errors.
///
/// Its damping and its frequencies differ from those of the motion where steps do not resolve a vibration. The error of an
/// unresolved vibration thus remains of the size of the vibration instead of growing in resonance with it. Its iteration matrix
/// differs from that of the other schemes by at most 20 % of the stiffness.
const SCHEME: SchemeCoefficients = SchemeCoefficients::generalized_alpha(0.5);
/// Largest relative movement of the state for a difference of residuals.
const DIFFERENCE: f64 = 1e-6;
/// Ratio of the increments of an iteration to the first one at which it ends.
const REDUCTION: f64 = 1e-3;
/// Largest number of iterations of a step.
const ITERATIONS: u32 = 20;

/// Error of a motion, exact less computed: q, v, v̇, λ of a state.
///
/// It satisfies the linearised equations of motion with additional forces, and the scheme with additional increments, the defects
/// of the steps of the motion. The tangent of the motion serves as iteration matrix.
///
/// Source: Zadunaisky (1976) and Stetter (1978), estimation by defects.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct ErrorMotion {
    pub(super) error: State,
    /// Error of the auxiliary acceleration, and of the acceleration at the start of a step.
    auxiliary: Vec<f64>,
    start: Vec<f64>,
}

/// Accepted step of the computed motion.
pub(super) struct ComputedStep<'a> {
    /// Size and its ratio to that of the last step.
    pub(super) h: f64,
    pub(super) ratio: f64,
    /// State at the end and its residual.
    pub(super) now: &'a State,
    pub(super) residual: &'a [f64],
    /// Size of each coordinate, to which its errors are relative.
    pub(super) sizes: &'a [f64],
}

/// Source of an error in a step.
pub(super) enum ErrorSource<'a> {
    /// Defect of the scheme.
    Step(&'a Defect),
    /// Additional forces.
    Forces(&'a [f64]),
}

impl ErrorMotion {
    pub(super) fn new(coordinates: usize, multipliers: usize) -> Self {
        let zeros = vec![0.0; coordinates];
        Self { error: State::rest(coordinates, multipliers), auxiliary: zeros.clone(), start: zeros }
    }

    /// Advances by a step of the computed motion. `moved` is working storage. Returns false without a solution.
    pub(super) fn advance<E: EquationsOfMotion + ?Sized>(
        &mut self,
        eom: &E,
        newton: &mut Newton,
        step: &ComputedStep<'_>,
        source: &ErrorSource<'_>,
        moved: &mut State,
    ) -> bool {
        let Self { error, auxiliary, start } = self;
        start.copy_from_slice(&error.a);
        for (auxiliary, a) in auxiliary.iter_mut().zip(&*start) {
            *auxiliary = a + step.ratio * (*auxiliary - a);
        }
        SCHEME.predict(error, auxiliary, step.h);
        if let ErrorSource::Step(defect) = source {
            error.q.iter_mut().zip(&defect.q).for_each(|(q, defect)| *q += defect);
            error.v.iter_mut().zip(&defect.v).for_each(|(v, defect)| *v += defect);
        }
        let is_solved = solve(eom, newton, step, source, (error, moved));
        for ((auxiliary, start), a) in auxiliary.iter_mut().zip(&*start).zip(&error.a) {
            *auxiliary = SCHEME.auxiliary(*auxiliary, *start, *a);
        }
        is_solved
    }

    pub(super) fn is_valid(&self, coordinates: usize, multipliers: usize) -> bool {
        let Self { error, auxiliary, start } = self;
        error.is_valid(coordinates, multipliers)
            && [auxiliary, start].iter().all(|x| x.len() == coordinates && x.iter().all(|x| x.is_finite()))
    }
}

/// Iterates the linearised equations of motion at the end of a step. Returns false without a solution.
fn solve<E: EquationsOfMotion + ?Sized>(
    eom: &E,
    newton: &mut Newton,
    step: &ComputedStep<'_>,
    source: &ErrorSource<'_>,
    (error, moved): (&mut State, &mut State),
) -> bool {
    let Newton { tangent, r, z, .. } = newton;
    let (n, w) = (error.q.len(), SCHEME.weights(step.h));
    let (mut first, mut size) = (None, f64::INFINITY);
    for _ in 0..ITERATIONS {
        let relative = error.q.iter().zip(step.sizes).map(|(q, size)| q.abs() / size);
        let largest = relative.fold(0.0, f64::max);
        let factor = if largest > 0.0 { DIFFERENCE / largest } else { 1.0 };
        moved.copy_from(step.now);
        moved.add_multiple(error, factor);
        eom.residual(moved, r);
        for (i, (z, (r, base))) in z.iter_mut().zip(r.iter().zip(step.residual)).enumerate() {
            let change = (r - base) / factor;
            *z = if i < n { -change } else { -change / w.q };
        }
        if let ErrorSource::Forces(forces) = source {
            z[..n].iter_mut().zip(*forces).for_each(|(z, force)| *z += force);
        }
        let is_solved = tangent.factor.solve_increment(&tangent.matrix, z, &error.lambda).is_ok();
        size = z.iter().zip(step.sizes).map(|(z, size)| (z / size).powi(2)).sum::<f64>().sqrt();
        if !is_solved || !z.iter().all(|z| z.is_finite()) {
            return false;
        }
        error.add(z, w);
        if first.is_some_and(|first| size <= REDUCTION * first) {
            return true;
        }
        first.get_or_insert(size);
    }
    first.is_some_and(|first| size <= first)
}
