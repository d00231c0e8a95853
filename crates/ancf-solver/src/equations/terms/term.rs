use std::any::Any;
use std::ops::Range;

use super::energy::{Energy, Level, Power};
use super::local::{LOCAL, Local, LocalMatrix, LocalStep};
use super::product_column::ProductColumn;
use super::state::{Inadmissibility, Weights};

/// Local contribution to the equations of motion, such as an element, the equations of a joint or a load.
///
/// A term is immutable. Its contribution depends only on its own coordinates and multipliers. The tests of the
/// library `ancf` check the laws of every term: tangent = ∂residual, residual = ∂energy.
///
/// Complete example of a spring between coordinate 3 and the ground:
///
/// ```
/// use ancf_solver::equations::{Energy, Local, LocalMatrix, Term, Weights};
///
/// struct Spring {
///     stiffness: f64,
/// }
///
/// impl Term for Spring {
///     fn coordinates(&self) -> &[usize] {
///         &[3]
///     }
///     fn residual(&self, at: &Local, r: &mut [f64]) {
///         r[0] += self.stiffness * at.q[0];
///     }
///     fn rounding(&self, at: &Local, floor: &mut [f64]) {
///         floor[0] += f64::EPSILON * (self.stiffness * at.q[0]).abs();
///     }
///     fn tangent(&self, _: &Local, w: Weights, k: &mut LocalMatrix) {
///         k.add(0, 0, w.q * self.stiffness);
///     }
///     fn energy(&self, at: &Local) -> Energy {
///         Energy { strain: 0.5 * self.stiffness * at.q[0].powi(2), ..Energy::default() }
///     }
/// }
/// ```
pub trait Term: Any + Send + Sync {
    /// Returns the coordinates of the term without repetition.
    fn coordinates(&self) -> &[usize];

    /// Returns the multipliers of the term.
    fn multipliers(&self) -> Range<usize> {
        0..0
    }

    /// Returns multipliers of other terms on which the forces depend, such as the reaction of a joint on which its friction depends.
    ///
    /// They follow the own multipliers in [`Local::lambda`]. Where only masses or constraints are evaluated they are missing there. The
    /// tangent lacks the derivatives by them.
    fn observed_multipliers(&self) -> &[usize] {
        &[]
    }

    /// Adds the residual of the term: rows of its coordinates, then of its multipliers.
    fn residual(&self, at: &Local<'_>, r: &mut [f64]);

    /// Adds a bound of the rounding error of the residual.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]);

    /// Adds the lower triangle of the tangent.
    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>);

    /// Adds the products of the stiffness ∂(f + Φ_qᵀ λ)/∂q with columns, and bounds of their rounding errors.
    ///
    /// By default these are products with the tangent. The entries of a bending element of length h grow as 1/h³, its share of
    /// xᵀ K x as h, so that the rounding error of the default is ε (L/h)⁴ relative to the lowest ω². Elements override this method
    /// by products with the strains of x, which are free of cancellation.
    fn stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let mut storage = [0.0; LOCAL * (LOCAL + 1) / 2];
        let mut k = LocalMatrix::zero(at.q.len() + at.lambda.len(), &mut storage);
        self.tangent(at, Weights::STIFFNESS, &mut k);
        columns.iter_mut().for_each(|column| column.add_matrix(&k, at.q.len()));
    }

    /// Adds the residual of a step of the energy-momentum scheme: forces of the step, and the constraints at its end.
    ///
    /// By default the forces and Φ_qᵀ λ are those of the middle. They do the work Φ(q₁) − Φ(q₀) of constraints that are at
    /// most quadratic, and that of potentials that are quadratic in q. Terms with other potentials or constraints override
    /// this method, at least by [`discrete_residual`].
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        middle_residual(self, step, r);
    }

    /// Adds the lower triangle of a symmetric tangent of [`average_residual`](Self::average_residual).
    ///
    /// `w` are the weights of the middle, half of those of the end for q and v. The tangent determines the convergence
    /// only. Stresses are those of the step, and derivatives of strains those of the middle.
    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.tangent(&step.middle, w, k);
    }

    /// Returns the massless coordinates that the multipliers determine, such as the position of a slider.
    ///
    /// They are eliminated after these multipliers. The other coordinates of the multipliers must have mass or
    /// stiffness.
    fn massless(&self) -> &[usize] {
        &[]
    }

    /// Adds ċ(t) and c̈(t) of rheonomic constraints A(q) + c(t), one entry for each multiplier.
    ///
    /// The residual contains c(t) itself.
    fn drive(&self, _t: f64, _rates: &mut [f64], _accelerations: &mut [f64]) {}

    /// Adds the constraints Φ = A(q) + c(t) at a level, one entry for each multiplier.
    ///
    /// The default implementation is valid for A that is at most quadratic. Its derivatives along v are then exact
    /// differences: A_q v = ½ [A(q + v) − A(q − v)], (A_q v)_q v = A(q + v) − 2A(q) + A(q − v).
    /// Terms with other constraints override this method.
    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        quadratic_constraints(self, at, level, phi);
    }

    /// Returns the entries (k, i) of Φ_q that can differ from zero: k-th multiplier and i-th coordinate. By default all.
    fn constraint_entries(&self) -> Vec<[usize; 2]> {
        let n = self.coordinates().len();
        (0..self.multipliers().len()).flat_map(|k| (0..n).map(move |i| [k, i])).collect()
    }

    /// Returns a description of the k-th constraint, such as "position along x".
    fn constraint_name(&self, k: usize) -> String {
        format!("equation {}", k + 1)
    }

    /// Returns the reason why a state is inadmissible; `None` for an admissible state.
    fn inadmissibility(&self, _at: &Local<'_>) -> Option<Inadmissibility> {
        None
    }

    /// True for terms with a rotation that is unique below half a turn ([`passes_half_turn`](Self::passes_half_turn)).
    fn has_half_turn(&self) -> bool {
        false
    }

    /// Returns true if such a rotation passes half a turn between two states, where it changes its sign.
    fn passes_half_turn(&self, _from: &Local<'_>, _to: &Local<'_>) -> bool {
        false
    }

    /// Visits the lower entries (i, j), i > j, of the skew part of ∂f/∂q. The tangent contains the symmetric part.
    ///
    /// Forces without a potential have a skew part, such as follower forces. It determines flutter.
    fn skew_stiffness(&self, _at: &Local<'_>, _visit: &mut dyn FnMut(usize, usize, f64)) {}

    /// Visits the lower entries (i, j), i > j, of the skew part of ∂f/∂v. The tangent contains the symmetric part.
    ///
    /// Gyroscopic forces have a skew part, such as the Coriolis forces of a rotating frame.
    fn skew_damping(&self, _at: &Local<'_>, _visit: &mut dyn FnMut(usize, usize, f64)) {}

    /// Visits entries (i, j) of ∂f/∂q that the tangent and its skew part lack, such as those of controllers.
    ///
    /// Linear models of motions need them. Terms with such entries belong to motions only.
    fn omitted_stiffness(&self, _at: &Local<'_>, _visit: &mut dyn FnMut(usize, usize, f64)) {}

    /// Visits entries (i, j) of ∂f/∂v that the tangent and its skew part lack.
    fn omitted_damping(&self, _at: &Local<'_>, _visit: &mut dyn FnMut(usize, usize, f64)) {}

    /// Returns the rotation between two states, relative to the largest rotation of one load increment.
    ///
    /// Larger rotations are ambiguous: a section that turns by 2π has its initial directions.
    fn rotation(&self, _from: &Local<'_>, _to: &Local<'_>) -> f64 {
        0.0
    }

    /// True if the term implements [`stress_prediction`](Self::stress_prediction).
    fn has_stress_prediction(&self) -> bool {
        false
    }

    /// Adds the lower triangle of −Σ (n(q) − n(q₀) − ∂n/∂q(q₀) (q − q₀)) ∂²ε/∂q² with the coordinates q₀ of the state `from`.
    ///
    /// The sum of the tangent at q and of this matrix has the stresses that the linear system at q₀ predicts for q, in place of
    /// those at q. Both differ by the second order of q − q₀, which is large in slender elements: an increment along straight
    /// tangents stretches the axis.
    fn stress_prediction(&self, _at: &Local<'_>, _from: &Local<'_>, _k: &mut LocalMatrix<'_>) {}

    /// True if the term implements [`least_tension`](Self::least_tension).
    fn is_cable(&self) -> bool {
        false
    }

    /// Adds the lower triangle of Σ (n₀ − n)⁺ ∂²ε/∂q² of the axial force: with [`stress_prediction`](Self::stress_prediction) the
    /// predicted force n is then at least that of the strain `least`, n₀.
    ///
    /// Slack cables have no stiffness but that of bending. Terms without axial forces have none.
    fn least_tension(&self, _at: &Local<'_>, _from: &Local<'_>, _least: f64, _k: &mut LocalMatrix<'_>) {}

    /// Adds the lower triangle of the initial stress stiffness at the configuration of the state.
    ///
    /// The stresses, multipliers and loads are the first-order response to the increment `by` of q, λ and the load
    /// factor. With stresses n = ∂U/∂ε of strains ε(q) the entries are Σ n₁ ∂²ε/∂q², n₁ = ∂n/∂ε ∂ε/∂q q₁.
    /// Multipliers add Σ λ₁ ∂²Φ/∂q². Loads add their own stiffness, multiplied by the increment of the load factor.
    /// The displacement term Σ ∂ε/∂q ∂n/∂ε ∂²ε/∂q² q₁ is not included.
    ///
    /// A term whose strains are nonlinear in q overrides this method. The default implementation covers multipliers and
    /// loads: the tangent is affine in them, and the part without them is subtracted.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (zeros, mut storage) = ([0.0; LOCAL], [0.0; LOCAL * LOCAL]);
        let mut rest = LocalMatrix::zero(at.q.len() + at.lambda.len(), &mut storage);
        let lambda = &zeros[..at.lambda.len()];
        self.tangent(&Local { lambda, load: 0.0, ..*at }, Weights::STIFFNESS, &mut rest);
        self.tangent(&Local { lambda: by.lambda, load: by.load, ..*at }, Weights::STIFFNESS, k);
        k.subtract(&rest);
    }

    /// Returns the energies of the term.
    fn energy(&self, _at: &Local<'_>) -> Energy {
        Energy::default()
    }

    /// Returns true if the force can have kinks or jumps, such as that of a stop. Steps with error control resolve them.
    fn has_kinks(&self) -> bool {
        false
    }

    /// Returns the coordinate that is an angle with counted turns, if there is one.
    fn counted_angle(&self) -> Option<usize> {
        None
    }

    /// Returns the power supplied without a potential. By default prescribed motions supply λ·ċ(t).
    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        driving_power(self, at)
    }

    /// Returns true if damping forces can act. Terms that return false are skipped in the sum of damping forces.
    fn is_damped(&self) -> bool {
        true
    }

    /// Adds the damping forces. By default these are the velocity-dependent forces f(q, v) − f(q, 0).
    ///
    /// Their power is dissipated. Loads without a potential have no damping forces.
    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        if self.is_damped() {
            velocity_forces(self, at, r);
        }
    }

    /// Returns the power that a moving medium supplies and the damping forces dissipate, in addition to v·F.
    fn flow_power(&self, _at: &Local<'_>) -> f64 {
        0.0
    }
}

impl dyn Term + '_ {
    /// Returns the power supplied without a potential, and the dissipated power.
    pub fn power(&self, at: &Local<'_>) -> Power {
        let mut forces = [0.0; LOCAL];
        self.damping_forces(at, &mut forces[..at.q.len() + at.lambda.len()]);
        let (damping, flow): (f64, _) =
            (at.v.iter().zip(forces).map(|(v, f)| v * f).sum(), self.flow_power(at));
        Power { work: self.supplied_power(at) + flow, dissipation: damping + flow }
    }
}

/// Adds forces of the middle and constraints of the end of a step: the default of [`Term::average_residual`].
pub fn middle_residual<T: Term + ?Sized>(term: &T, step: &LocalStep<'_>, r: &mut [f64]) {
    let (n, m) = (step.to.q.len(), step.to.lambda.len());
    if m == 0 {
        return term.residual(&step.middle, r);
    }
    for (at, own) in [(&step.middle, 0..n), (&step.to, n..n + m)] {
        let mut rows = [0.0; LOCAL];
        term.residual(at, &mut rows[..n + m]);
        own.for_each(|i| r[i] += rows[i]);
    }
}

/// Adds the residual of a step with the discrete derivative of the potential and of the constraints of a term.
///
/// The forces of the middle are corrected along Δq = q₁ − q₀ so that they do exactly the work ΔU + λ·ΔΦ:
/// [ΔU + λ·ΔΦ − (∂U/∂q + Φ_qᵀ λ)·Δq] Δq/|Δq|². Potential and constraints are those at the time of the middle. Forces at
/// zero velocity must be those of the potential.
///
/// Source: Gonzalez (1996), discrete derivatives.
pub fn discrete_residual<T: Term + ?Sized>(term: &T, step: &LocalStep<'_>, r: &mut [f64]) {
    middle_residual(term, step, r);
    let LocalStep { from, middle, to, .. } = step;
    let (n, m, zeros) = (to.q.len(), to.lambda.len(), [0.0; LOCAL]);
    let middle = Local { v: &zeros[..n], a: &zeros[..n], ..*middle };
    let (mut missed, mut bound) = (0.0, 0.0);
    for (at, sign) in [(from, -1.0), (to, 1.0)] {
        let (mut rows, mut floor) = ([0.0; LOCAL], [0.0; LOCAL]);
        let at = Local { q: at.q, ..middle };
        term.residual(&at, &mut rows[..n + m]);
        term.rounding(&at, &mut floor[..n + m]);
        let Energy { strain, potential, .. } = term.energy(&at);
        missed += sign * (strain + potential);
        bound += f64::EPSILON * (strain.abs() + potential.abs());
        for (k, lambda) in at.lambda.iter().enumerate() {
            missed += sign * lambda * rows[n + k];
            bound += lambda.abs() * floor[n + k];
        }
    }
    let (mut forces, mut floor) = ([0.0; LOCAL], [0.0; LOCAL]);
    term.residual(&middle, &mut forces[..n + m]);
    term.rounding(&middle, &mut floor[..n + m]);
    for i in 0..n {
        let moved = to.q[i] - from.q[i];
        missed -= forces[i] * moved;
        bound += (floor[i] + f64::EPSILON * forces[i].abs()) * moved.abs();
    }
    correct_work(step, [missed, bound], r);
}

/// Adds the force along Δq = q₁ − q₀ with a given work. Nothing is added up to the rounding error of this work.
pub fn correct_work(step: &LocalStep<'_>, [work, bound]: [f64; 2], r: &mut [f64]) {
    let moved = |i: usize| step.to.q[i] - step.from.q[i];
    let n = step.to.q.len();
    if work.abs() > DISCRETE_ROUNDING * bound {
        let square: f64 = (0..n).map(|i| moved(i).powi(2)).sum();
        (0..n).for_each(|i| r[i] += work / square * moved(i));
    }
}

/// Multiple of the rounding bound below which a discrete derivative equals that of the middle.
const DISCRETE_ROUNDING: f64 = 4.0;

/// Returns the power of prescribed motions: Φ_qᵀ λ does the work −λ·Φ_q v = λ·ċ on the bodies.
fn driving_power<T: Term + ?Sized>(term: &T, at: &Local<'_>) -> f64 {
    let (mut rates, mut accelerations) = ([0.0; LOCAL], [0.0; LOCAL]);
    let m = at.lambda.len();
    term.drive(at.t, &mut rates[..m], &mut accelerations[..m]);
    at.lambda.iter().zip(rates).map(|(lambda, rate)| lambda * rate).sum()
}

/// Adds the velocity-dependent forces f(q, v) − f(q, 0).
pub fn velocity_forces<T: Term + ?Sized>(term: &T, at: &Local<'_>, r: &mut [f64]) {
    let (zeros, n, m) = ([0.0; LOCAL], at.q.len(), at.lambda.len());
    let (mut moving, mut still) = ([0.0; LOCAL], [0.0; LOCAL]);
    term.residual(&Local { a: &zeros[..n], ..*at }, &mut moving[..n + m]);
    term.residual(&Local { v: &zeros[..n], a: &zeros[..n], ..*at }, &mut still[..n + m]);
    (0..n).for_each(|i| r[i] += moving[i] - still[i]);
}

/// Returns the power −v·f of a load without a potential.
pub fn load_power<T: Term + ?Sized>(load: &T, at: &Local<'_>) -> f64 {
    let (zeros, mut r, n) = ([0.0; LOCAL], [0.0; LOCAL], at.q.len());
    load.residual(&Local { a: &zeros[..n], ..*at }, &mut r[..n]);
    -at.v.iter().zip(r).map(|(v, r)| v * r).sum::<f64>()
}

/// Adds constraints that are at most quadratic in q: the default of [`Term::constraints`].
pub fn quadratic_constraints<T: Term + ?Sized>(term: &T, at: &Local<'_>, level: Level, phi: &mut [f64]) {
    let m = at.lambda.len();
    let (mut rates, mut accelerations) = ([0.0; LOCAL], [0.0; LOCAL]);
    term.drive(at.t, &mut rates[..m], &mut accelerations[..m]);
    let here = |sign| shifted_constraints(term, at, sign);
    match level {
        Level::Position => {
            let here = here(0.0);
            (0..m).for_each(|k| phi[k] += here[k]);
        }
        Level::Velocity => {
            let (ahead, back) = (here(1.0), here(-1.0));
            (0..m).for_each(|k| phi[k] += 0.5 * (ahead[k] - back[k]) + rates[k]);
        }
        Level::Acceleration => {
            let (ahead, here, back) = (here(1.0), here(0.0), here(-1.0));
            (0..m).for_each(|k| phi[k] += ahead[k] - 2.0 * here[k] + back[k] + accelerations[k]);
        }
    }
}

/// Evaluates the constraint rows of a term at q + sign × v.
fn shifted_constraints<T: Term + ?Sized>(term: &T, at: &Local<'_>, sign: f64) -> [f64; LOCAL] {
    let (mut q, mut rows) = ([0.0; LOCAL], [0.0; LOCAL]);
    let (n, m) = (at.q.len(), at.lambda.len());
    for i in 0..n {
        q[i] = at.q[i] + sign * at.v[i];
    }
    term.residual(&Local { q: &q[..n], ..*at }, &mut rows[..n + m]);
    rows.copy_within(n..n + m, 0);
    rows
}
