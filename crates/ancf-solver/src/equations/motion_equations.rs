use nalgebra::DVector;

use super::contact_pairs::{ActiveGroup, ActivePair};
use super::law_changes::LawChanges;
use super::stiffness_products::StiffnessProducts;
use super::term_sums::Rotation;
use super::terms::{Energy, Inadmissibility, Level, Power, State, StepStates, Weights};
use crate::sparse::{Pattern, SparseMatrix};

/// Large change of the load factor.
const FAR: f64 = 1e6;
/// Small change of the load factor.
const NEAR: f64 = 1e-4;
/// Multiple of the rounding error of a residual up to which differences are equal.
const ROUNDING: f64 = 8.0;

/// Index-3 equations of motion M a + f(q, v, t) + Φ_qᵀ λ = 0, Φ(q, t) = 0 with symmetric derivatives.
///
/// This trait separates mechanics from numerics. Elements and joints do not depend on schemes, and schemes do not
/// depend on elements.
///
/// Shapes: with n coordinates and m multipliers, residuals have n + m entries and tangents are (n + m) × (n + m).
pub trait EquationsOfMotion {
    /// Returns the number n of coordinates.
    fn coordinates(&self) -> usize;

    /// Returns the number m of multipliers.
    fn multipliers(&self) -> usize;

    /// Assembles the residual r = [M a + f + Φ_qᵀ λ; Φ].
    fn residual(&self, s: &State, r: &mut [f64]);

    /// Evaluates the constraints, one entry for each multiplier, at a cost proportional to their number.
    fn constraints(&self, s: &State, level: Level, phi: &mut [f64]);

    /// Bounds the rounding error of each residual entry by ε times the sum of the magnitudes of its summands.
    fn rounding(&self, s: &State, floor: &mut [f64]);

    /// Returns the sparsity pattern of the tangents.
    fn pattern(&self) -> &Pattern;

    /// Assembles the symmetric matrix [w_q ∂(f + Φ_qᵀ λ)/∂q + w_v ∂f/∂v + w_a M, Φ_qᵀ; Φ_q, 0].
    fn tangent(&self, s: &State, w: Weights, k: &mut SparseMatrix);

    /// Computes the force −∂r/∂s of the loads and drives for the load factor s.
    ///
    /// Loads are affine in s, and the difference over a large change has little rounding error. Prescribed rotations are not: where
    /// the difference over a small change deviates by more than its rounding error, it is the derivative.
    fn load_force(&self, s: &State) -> Vec<f64> {
        let size = self.coordinates() + self.multipliers();
        let (mut moved, mut floor) = (s.clone(), vec![0.0; size]);
        let mut residual = |load: f64| {
            let mut r = vec![0.0; size];
            moved.load = load;
            self.residual(&moved, &mut r);
            r
        };
        let [here, far] = [s.load, s.load + FAR].map(&mut residual);
        let [before, after] = [s.load - NEAR, s.load + NEAR].map(&mut residual);
        self.rounding(s, &mut floor);
        let force = |i: usize| {
            let (far, near) = ((here[i] - far[i]) / FAR, (before[i] - after[i]) / (2.0 * NEAR));
            let error = ROUNDING * floor[i] / NEAR;
            if (near - far).abs() <= error { far } else { near }
        };
        (0..size).map(force).collect()
    }

    /// Computes K X and Xᵀ K X for columns X over the coordinates, K = ∂(f + Φ_qᵀ λ)/∂q, with less rounding error than
    /// products with the assembled matrix.
    fn stiffness_products(&self, s: &State, x: &[DVector<f64>]) -> StiffnessProducts;

    /// Assembles the residual of a step of the energy-momentum scheme ([`Term::average_residual`]).
    ///
    /// [`Term::average_residual`]: super::terms::Term::average_residual
    fn average_residual(&self, step: &StepStates<'_>, r: &mut [f64]) {
        self.residual(step.middle, r);
        self.constraints(step.to, Level::Position, &mut r[step.to.q.len()..]);
    }

    /// Assembles a symmetric tangent of the step for weights of its end ([`Term::average_tangent`]).
    ///
    /// [`Term::average_tangent`]: super::terms::Term::average_tangent
    fn average_tangent(&self, step: &StepStates<'_>, w: Weights, k: &mut SparseMatrix) {
        self.tangent(step.middle, w.of_middle(), k);
    }

    /// Assembles the stiffness at a state with the stresses that the linear system at the state `from` predicts
    /// ([`Term::stress_prediction`]). Equations without strains have the stiffness of the state.
    ///
    /// [`Term::stress_prediction`]: super::terms::Term::stress_prediction
    fn predicted_stiffness(&self, s: &State, _from: &State, k: &mut SparseMatrix) {
        self.tangent(s, Weights::STIFFNESS, k);
    }

    /// Returns true if there are cables, which have a least tension ([`Term::least_tension`]).
    ///
    /// [`Term::least_tension`]: super::terms::Term::least_tension
    fn has_cables(&self) -> bool {
        false
    }

    /// Adds the change of the stiffness if the predicted axial strains of cables are at least `least` ([`Term::least_tension`]).
    ///
    /// [`Term::least_tension`]: super::terms::Term::least_tension
    fn add_least_tension(&self, _s: &State, _from: &State, _least: f64, _k: &mut SparseMatrix) {}

    /// Assembles the initial stress stiffness at the configuration of a state.
    ///
    /// The stresses, multipliers and loads are the first-order response to the increment `by` of q, λ and the load
    /// factor ([`Term::stress_stiffness`]).
    ///
    /// [`Term::stress_stiffness`]: super::terms::Term::stress_stiffness
    fn stress_stiffness(&self, s: &State, by: &State, k: &mut SparseMatrix);

    /// Returns a coordinate of a term that does not admit this state, and the reason, if there is one.
    ///
    /// The equations of motion also have inadmissible solutions.
    fn inadmissible(&self, _s: &State) -> Option<(usize, Inadmissibility)> {
        None
    }

    /// Returns a coordinate of a term whose rotation passes half a turn between two states; `None` without one.
    fn half_turn(&self, _from: &State, _to: &State) -> Option<usize> {
        None
    }

    /// Returns the coordinates that are angles with counted turns.
    ///
    /// The equations determine such an angle up to whole turns.
    fn counted_angles(&self) -> &[usize] {
        &[]
    }

    /// Returns the lower entries (i, j, value), i > j, of the skew part of ∂f/∂q in ascending order.
    ///
    /// It is empty if all forces of the state have a potential ([`Term::skew_stiffness`]).
    ///
    /// [`Term::skew_stiffness`]: super::terms::Term::skew_stiffness
    fn skew_stiffness(&self, _s: &State) -> Vec<(usize, usize, f64)> {
        Vec::new()
    }

    /// Returns the lower entries (i, j, value), i > j, of the skew part of ∂f/∂v in ascending order.
    ///
    /// It is empty without gyroscopic forces ([`Term::skew_damping`]).
    ///
    /// [`Term::skew_damping`]: super::terms::Term::skew_damping
    fn skew_damping(&self, _s: &State) -> Vec<(usize, usize, f64)> {
        Vec::new()
    }

    /// Returns true if forces depend on multipliers of other terms ([`Term::observed_multipliers`]).
    ///
    /// [`Term::observed_multipliers`]: super::terms::Term::observed_multipliers
    fn observes_multipliers(&self) -> bool {
        false
    }

    /// Returns the entries (i, j, value) of ∂f/∂q that the tangent and its skew part lack ([`Term::omitted_stiffness`]).
    ///
    /// [`Term::omitted_stiffness`]: super::terms::Term::omitted_stiffness
    fn omitted_stiffness(&self, _s: &State) -> Vec<(usize, usize, f64)> {
        Vec::new()
    }

    /// Returns the entries (i, j, value) of ∂f/∂v that the tangent and its skew part lack.
    fn omitted_damping(&self, _s: &State) -> Vec<(usize, usize, f64)> {
        Vec::new()
    }

    /// Returns a coordinate of a body that passes through its contact partner between two states, if there is one.
    fn crossing(&self, _from: &State, _to: &State) -> Option<usize> {
        None
    }

    /// Returns a position on the straight line between two states, from 0 to 1, at which a pair acts that does not act at
    /// the ends.
    fn passing(&self, _from: &State, _to: &State) -> Option<f64> {
        None
    }

    /// Returns the pairs that have a force in a state, in ascending order; `None` if there are no searches.
    fn acting_pairs(&self, _s: &State) -> Option<Vec<ActivePair>> {
        None
    }

    /// True if a law can have kinks ([`Term::has_kinks`](super::terms::Term::has_kinks)).
    fn has_kinks(&self) -> bool {
        false
    }

    /// Returns the force changes of laws with kinks in a step, given its start, middle and end; `None` if there are none.
    fn law_changes(&self, _from: &State, _middle: &State, _to: &State) -> Option<LawChanges> {
        None
    }

    /// Adds the tangents of some terms, by their numbers in [`LawChanges`], to a matrix of the pattern.
    fn add_tangents(&self, _terms: &[usize], _s: &State, _w: Weights, _k: &mut SparseMatrix) {}

    /// Returns the largest rotation between two states, which limits load increments.
    fn rotation(&self, _from: &State, _to: &State) -> Rotation {
        Rotation::default()
    }

    /// Extends the equations by the terms that may become active soon, before a step.
    ///
    /// Returns the extended equations and a matrix of their pattern, or `None` if all near terms are included. Terms
    /// such as contacts are active in some states only ([`ContactSearch`](super::contact_pairs::ContactSearch)).
    fn with_near_terms(&self, _s: &State) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// Extends the equations by all terms that are active in this state, after a step.
    ///
    /// Returns the extended equations and a matrix of their pattern, or `None` if all active terms are included. The
    /// step is then repeated with the extended equations.
    fn with_active_terms(&self, _s: &State) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// Returns the groups of the included pairs in ascending order.
    fn active_groups(&self) -> Vec<ActiveGroup> {
        Vec::new()
    }

    /// Returns the equations with exactly these groups and a matrix of their pattern, or `None` if a group does not
    /// exist.
    fn with_groups(&self, _groups: &[ActiveGroup]) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// Returns the equations with exactly these pairs and a matrix of their pattern, or `None` if there are no searches.
    fn with_pairs(&self, _pairs: &[ActivePair]) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// Returns the number of degrees of freedom in a state: n minus the rank of the constraints.
    fn degrees_of_freedom(&self, _s: &State) -> usize {
        self.coordinates().saturating_sub(self.multipliers())
    }

    /// Returns the kinetic, strain and potential energy.
    fn energy(&self, s: &State) -> Energy;

    /// Returns the sum of the magnitudes of the energies of parts of the equations, which may cancel in their sum. Its rounding error bounds
    /// that of the energy.
    fn energy_size(&self, s: &State) -> f64;

    /// Sets the damping forces F, and returns the power supplied by loads and prescribed motions.
    ///
    /// `dissipation` is the dissipated power without v·F: the power of a flow on the damping forces. The forces have
    /// n + m entries, of which the last m are zero.
    fn exchange(&self, _s: &State, damping: &mut [f64]) -> Power {
        damping.fill(0.0);
        Power::default()
    }

    /// Returns the sum of the magnitudes of the forces that supply work, by coordinate.
    fn supplied_forces(&self, _s: &State) -> f64 {
        0.0
    }
}
