use std::fmt::Debug;

use crate::dynamics::start::solve;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::newton::{SolveError, SolveFailure};
use crate::sparse::SparseMatrix;

/// Functions of time in the equations of motion, such as those of loads and prescribed motions.
///
/// A step evaluates them at its ends only. A pulse between the ends has no effect on the step and on its error estimate.
pub trait TimeFunctions: Debug + Send + Sync {
    /// Adds the variations within a step that the values and rates at its ends do not show.
    fn unseen(&self, from: f64, to: f64, found: &mut Vec<UnseenVariation>);
}

/// Variation of a function of time within a step: its deviation D from the straight line between the ends of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnseenVariation {
    /// Time of a large deviation.
    pub at: f64,
    /// Width of the deviation: ∫|D| dt over the step, divided by |D| at this time.
    pub width: f64,
}

/// Computes the errors of a step due to a variation, as vectors over the coordinates.
///
/// With the deviation d = (ΔF, ΔΦ) of the residual from its straight line, and the iteration matrix S of a step of the
/// width w:
///
/// [S, Φ_qᵀ; Φ_q, 0] (x, ·) = (h w ΔF, 0),   [S, Φ_qᵀ; Φ_q, 0] (y, ·) = (0, ΔΦ h/w).
///
/// x is the displacement after a step h due to the impulse of the forces, y that due to the velocity ΔΦ/w of prescribed
/// positions.
pub(super) fn displacements<E: EquationsOfMotion>(
    eom: &E,
    [from, to]: [&State; 2],
    w: Weights,
    variation: UnseenVariation,
    matrix: &mut SparseMatrix,
) -> Result<[Vec<f64>; 2], SolveError> {
    let (n, h) = (to.q.len(), to.t - from.t);
    let part = (variation.at - from.t) / h;
    let mut s = to.clone();
    let mut residual = |t: f64| {
        let mut r = vec![0.0; n + to.lambda.len()];
        s.t = t;
        eom.residual(&s, &mut r);
        r
    };
    let [start, here, end] = [from.t, variation.at, to.t].map(&mut residual);
    let mut forces: Vec<f64> =
        (0..here.len()).map(|i| here[i] - start[i] - part * (end[i] - start[i])).collect();
    let mut positions = forces.clone();
    forces[n..].fill(0.0);
    forces.iter_mut().for_each(|force| *force *= h * variation.width);
    positions[..n].fill(0.0);
    let scale = (h / variation.width).max(1.0);
    positions.iter_mut().for_each(|position| *position *= scale);
    let failed = |_| SolveError::at(to.t, SolveFailure::Memory);
    let mut factor = Factor::new(matrix.pattern()).map_err(failed)?;
    for x in [&mut forces, &mut positions] {
        if x.iter().any(|x| *x != 0.0) {
            solve(eom, matrix, &mut factor, to, w, x)?;
        }
        x.truncate(n);
    }
    Ok([forces, positions])
}
