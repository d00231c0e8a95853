//! Comparison of residuals, gaps and increments of an iteration with rounding errors.

use super::rounding_floor::{FLOOR, raise_to_achievable};
use super::tangent::NewtonTangent;
use crate::equations::{EquationsOfMotion, Level, State, Weights};

/// Multiple of the rounding bound below which a gap counts as closed: a relative error of 1e-12. The iteration converges
/// quadratically, and one increment more would change the state by less.
const CLOSED: f64 = 1e4;
/// Gap that is closed in a model of any size. Where joints carry all loads, displacements are rounding errors of rounding errors, and so
/// are the gaps. The linear solution, with errors relative to the largest multiplier, does not close them further.
const NO_GAP: f64 = f64::EPSILON * f64::EPSILON;

/// Iterate with its last residual, increment and tangent.
pub(super) struct Iterate<'a> {
    pub(super) eom: &'a dyn EquationsOfMotion,
    pub(super) s: &'a State,
    pub(super) r: &'a [f64],
    pub(super) z: &'a [f64],
    pub(super) weights: Weights,
    pub(super) tangent: &'a mut NewtonTangent,
    /// Storage of the rounding bounds.
    pub(super) floor: &'a mut [f64],
}

impl Iterate<'_> {
    /// Computes the bounds of the evaluation and of the linear solution.
    fn bound(&mut self) {
        self.eom.rounding(self.s, self.floor);
        let NewtonTangent { matrix, factor, .. } = &*self.tangent;
        raise_to_achievable(matrix, self.s, self.z, self.weights, self.floor);
        factor.raise_to_compliance(&self.s.lambda, &mut self.floor[self.s.q.len()..]);
    }

    /// Returns true if the gaps of the constraints after the last increment are near their rounding errors.
    pub(super) fn has_closed_gaps(mut self) -> bool {
        self.bound();
        let mut gaps = vec![0.0; self.eom.multipliers()];
        self.eom.constraints(self.s, Level::Position, &mut gaps);
        gaps.iter()
            .zip(&self.floor[self.s.q.len()..])
            .all(|(gap, floor)| gap.abs() <= CLOSED * floor.max(NO_GAP))
    }

    /// Returns the equation with the largest ratio of residual to achievable accuracy, and this ratio.
    pub(super) fn excess(mut self) -> (usize, f64) {
        self.bound();
        let mut worst = (0, 0.0);
        for (i, (r, floor)) in self.r.iter().zip(&*self.floor).enumerate() {
            let excess = if *r == 0.0 { 0.0 } else { r.abs() / floor };
            if excess > worst.1 || excess.is_nan() {
                worst = (i, excess);
            }
        }
        worst
    }

    /// Returns true in statics if a state without energy satisfies the equations to their rounding errors. `largest` is the largest
    /// energy of the states so far.
    ///
    /// Without strain and loads all multipliers are rounding errors of the linear solution, which exceed those of the
    /// residual. An arm on a driven hinge is an example. The work of the residual on the last increment decides, since
    /// there is no energy that the other rule could compare it with.
    pub(super) fn is_rounding(&mut self, largest: f64) -> bool {
        if !self.weights.is_static() {
            return false;
        }
        let Self { eom, s, r, z, floor, .. } = self;
        // The bounds of the evaluation alone, without those of the linear solution.
        eom.rounding(s, floor);
        let energy = largest.max(eom.energy(s).largest());
        let bound: f64 = floor.iter().zip(&s.q).map(|(floor, q)| floor * q.abs()).sum();
        let floor: &[f64] = floor;
        let work = |x: &[f64]| z.iter().zip(x).map(|(z, x)| (z * x).abs()).sum::<f64>();
        energy <= bound && work(r) <= FLOOR * work(floor)
    }

    /// Returns true in statics if the state and the last increments, the largest one of an energy, have the energy of an increment that
    /// rounding errors cause.
    ///
    /// Where joints carry all loads, the displacements are rounding errors of the linear solution, of no common size with the
    /// residual. The increment that the factors give for a residual at its rounding bounds has the same errors, which
    /// measures them. In slender bodies this increment may have more energy than the state, so several increments
    /// decide.
    pub(super) fn is_increment_of_rounding(&mut self, energy: Option<f64>) -> bool {
        let Some(energy) = energy.filter(|_| self.weights.is_static()) else { return false };
        let Self { eom, s, r, floor, tangent, .. } = self;
        eom.rounding(s, floor);
        let floor: &[f64] = floor;
        let mut z: Vec<f64> = r.iter().zip(floor).map(|(r, floor)| floor.copysign(-r)).collect();
        let NewtonTangent { matrix, factor, .. } = &mut **tangent;
        if factor.solve_increment(matrix, &mut z, &[]).is_err() {
            return false;
        }
        let work: f64 = z.iter().zip(floor).map(|(z, floor)| (z * floor).abs()).sum();
        // A state with more strain energy has displacements of a motion, and an ill-conditioned structure would stop before its
        // equilibrium.
        eom.energy(s).strain.abs().max(energy) <= FLOOR * FLOOR * work
    }
}
