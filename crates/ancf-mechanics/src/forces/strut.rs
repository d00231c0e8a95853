use ancf_solver::equations::{
    Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights, correct_work,
};
use nalgebra::{Matrix3, Vector3};

use super::strut_law::{LinearStrut, StrutLaw};
use crate::constraints::{Wrench, add_outer};
use crate::kinematics::BodyVector;
use crate::laws::LawValue;

/// Force between two points, d = r_a − r_b, by the law of a [spring with a damper](LinearStrut) or by a general law of the
/// distance and its rate. The tensile force is N(x, dl/dt), x = l − l₀, l = |d|, where l₀ is the reference distance.
///
/// U = ∫ N dx at zero rate; the rest of the force dissipates (N(x, v) − N(x, 0)) v. The derivative of this part by q is
/// not symmetric, and the tangent contains its symmetric part. For coincident points the direction of the force is
/// undefined, so the state is inadmissible.
///
/// Units: k force/length, c force × time/length.
#[derive(Clone, Debug)]
pub struct Strut {
    global: BodyVector,
    distance_vector: BodyVector,
    coordinates: Vec<usize>,
    law: StrutLaw,
}

/// Distance below which points count as coincident, relative to the reference distance.
const COINCIDENT: f64 = 1e-9;

/// Distance in a state.
struct StrutLength {
    length: f64,
    /// Change of length l − l₀.
    change: f64,
    /// Unit vector d/l.
    unit: Vector3<f64>,
}

impl Strut {
    /// Creates a spring and a damper between two points that are distinct in the reference state.
    pub fn new(
        a: impl Into<BodyVector>,
        b: impl Into<BodyVector>,
        stiffness: f64,
        damping: f64,
        free_length: f64,
    ) -> Self {
        let strut = Self::with_law(a, b, LinearStrut::default());
        let preload_length = free_length - strut.distance_vector.reference().norm();
        Self { law: LinearStrut { stiffness, damping, preload_length, rope: false }.into(), ..strut }
    }

    /// Creates a force by a law of the change of length x, between two points that are distinct in the reference state.
    pub fn with_law(a: impl Into<BodyVector>, b: impl Into<BodyVector>, law: impl Into<StrutLaw>) -> Self {
        let global = BodyVector::combined([(1.0, &a.into()), (-1.0, &b.into())]);
        let coordinates = BodyVector::union_coordinates([&global]);
        let distance_vector = global.within(&coordinates);
        Self { global, distance_vector, coordinates, law: law.into() }
    }

    /// Sets the free length to the reference distance, which gives zero force in the reference state.
    #[must_use]
    pub fn unstressed(self) -> Self {
        Self { law: self.law.unstressed(), ..self }
    }

    /// Restricts the force of a spring and damper to tension.
    #[must_use]
    pub fn tension_only(self) -> Self {
        Self { law: self.law.tension_only(), ..self }
    }

    fn distance(&self, vector: &BodyVector, q: &[f64]) -> StrutLength {
        let (d0, u) = (vector.reference(), vector.change(q));
        let d = d0 + u;
        let length = d.norm();
        let change = (2.0 * d0.dot(&u) + u.dot(&u)) / (length + d0.norm());
        StrutLength { length, change, unit: d / length }
    }

    /// Returns N with its derivatives in a local state.
    fn value(&self, at: &Local<'_>, &StrutLength { change, unit, .. }: &StrutLength) -> LawValue {
        self.law.at(at.t, change, unit.dot(&self.distance_vector.rate(at.q, at.v)), at.load)
    }

    /// Returns the force on the first body, at its point.
    pub fn reaction(&self, s: &State) -> Wrench {
        let StrutLength { change, unit, .. } = self.distance(&self.global, &s.q);
        let value = self.law.at(s.t, change, unit.dot(&self.global.velocity(s)), s.load);
        Wrench { force: unit * -value.force, ..Wrench::default() }
    }
}

impl Term for Strut {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let distance = self.distance(&self.distance_vector, at.q);
        let force = self.value(at, &distance).force;
        self.distance_vector.add(at.q, distance.unit * force, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let distance = self.distance(&self.distance_vector, at.q);
        let StrutLength { length, change, unit } = distance;
        let (speed, zeros) = (self.distance_vector.rate(at.q, at.v), [0.0; LOCAL]);
        let LawValue { force, by_position, .. } = self.value(at, &distance);
        // The displacement determines the rounding error of the length change, and the position that of the direction.
        let moved = self.distance_vector.size(at.q) - self.distance_vector.size(&zeros[..at.q.len()]);
        let turned = 2.0 * self.distance_vector.size(at.q) / length;
        let of_rate = turned * speed.norm() + self.distance_vector.rate_size(at.q, at.v);
        let errors = [moved, of_rate].map(|size| 2.0 * f64::EPSILON * size);
        let of_force = self.law.rounding(at.t, [change, unit.dot(&speed)], errors, at.load);
        let bound = of_force + 2.0 * f64::EPSILON * turned * force.abs();
        let Some(marker) = self.distance_vector.marker() else {
            let [_, turned] = self.distance_vector.errors(at.q);
            let error = bound + by_position.abs() * turned;
            return self.distance_vector.add_errors(at.q, force.abs(), error, floor);
        };
        for &(first, w) in marker.parts() {
            floor[first..first + 3].iter_mut().for_each(|row| *row += bound * w.abs());
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let distance = self.distance(&self.distance_vector, at.q);
        let value = self.value(at, &distance);
        if value != LawValue::default() {
            self.add_tangent(at, &distance, w, value, k);
        }
    }

    fn has_kinks(&self) -> bool {
        self.law.has_kinks()
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let (force, mean) = self.of_step(step);
        let (vector, middle) = (&self.distance_vector, &step.middle);
        vector.add(middle.q, mean.unit * force, r);
        if self.law.is_damped() {
            let StrutLength { change, unit, .. } = self.distance(vector, middle.q);
            let rate = unit.dot(&vector.rate(middle.q, middle.v));
            let force = |rate| self.law.at(middle.t, change, rate, middle.load).force;
            vector.add(middle.q, unit * (force(rate) - force(0.0)), r);
        }
        if !vector.is_linear() {
            let (n, mut moved) = (middle.q.len(), [0.0; LOCAL]);
            (0..n).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
            let changed = vector.change(step.to.q) - vector.change(step.from.q);
            let missed = changed - vector.rate(middle.q, &moved[..n]);
            let [error, turned] = vector.errors(middle.q);
            let bound = force.abs() * (2.0 * turned + error * vector.rate_size(middle.q, &moved[..n]));
            correct_work(step, [force * mean.unit.dot(&missed), bound], r);
        }
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (force, mean) = self.of_step(step);
        let mean = StrutLength { unit: mean.unit.normalize(), ..mean };
        if let Some(slopes) = self.law.slopes_of_step(force, || self.value(&step.middle, &mean)) {
            self.add_tangent(&step.middle, &mean, w, LawValue { force, ..slopes }, k);
        }
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let StrutLength { length, change, unit } = self.distance(&self.distance_vector, at.q);
        let Some(of_load) = self.law.by_load(at.t, change, at.load) else { return };
        let slope = self.law.at(at.t, change, 0.0, at.load).by_position;
        let force = slope * unit.dot(&self.distance_vector.rate(at.q, by.q)) + by.load * of_load;
        let transverse = (Matrix3::identity() - unit * unit.transpose()) * (force / length);
        self.distance_vector.add_quadratic(at.q, &transverse, k);
        self.distance_vector.add_curvature(at.q, unit * force, k);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let is_admissible = self.distance(&self.distance_vector, at.q).length
            > COINCIDENT * self.distance_vector.reference().norm();
        (!is_admissible).then_some(Inadmissibility::CoincidentEnds)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let change = self.distance(&self.distance_vector, at.q).change;
        Energy { strain: self.law.potential(at.t, change, at.load), ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        if self.law.is_autonomous() {
            return 0.0;
        }
        let StrutLength { change, unit, .. } = self.distance(&self.distance_vector, at.q);
        let rate = unit.dot(&self.distance_vector.rate(at.q, at.v));
        -rate * self.law.at(at.t, change, 0.0, at.load).force
    }
}

impl Strut {
    /// Returns the elastic force of a step, ΔU/Δl for χ = 0, and the distance with the mean length and the direction
    /// (d₀ + d₁)/(l₀ + l₁), which gives exactly Δl for Δd.
    fn of_step(&self, step: &LocalStep<'_>) -> (f64, StrutLength) {
        let vector = &self.distance_vector;
        let [from, to] = [step.from.q, step.to.q].map(|q| self.distance(vector, q));
        let force = self.law.of_step([from.change, to.change], step);
        let length = 0.5 * (from.length + to.length);
        let unit = (from.unit * from.length + to.unit * to.length) / (2.0 * length);
        (force, StrutLength { length, change: 0.5 * (from.change + to.change), unit })
    }

    /// Adds the tangent at a distance for a given force.
    fn add_tangent(
        &self,
        at: &Local<'_>,
        StrutLength { length, unit, .. }: &StrutLength,
        w: Weights,
        LawValue { force, by_position, by_rate }: LawValue,
        k: &mut LocalMatrix<'_>,
    ) {
        let speed = self.distance_vector.rate(at.q, at.v);
        let (unit, length) = (*unit, *length);
        let along = unit * unit.transpose();
        let transverse = (Matrix3::identity() - along) / length;
        // ∂(dl/dt)/∂d is the transverse velocity over l.
        let turning = unit * (transverse * speed).transpose() * (0.5 * by_rate);
        let stiffness = along * by_position + transverse * force + turning + turning.transpose();
        self.distance_vector.add_quadratic(at.q, &(stiffness * w.q + along * (w.v * by_rate)), k);
        if !self.distance_vector.is_linear() {
            let (n, mut gradient, mut turned) = (at.q.len(), [0.0; LOCAL], [0.0; LOCAL]);
            self.distance_vector.add_curvature(at.q, unit * (force * w.q), k);
            self.distance_vector.add(at.q, unit, &mut gradient[..n]);
            self.distance_vector.add_slope(at.q, at.v, unit, &mut turned[..n]);
            add_outer(&gradient, &turned, w.q * by_rate, n, k);
        }
    }
}
