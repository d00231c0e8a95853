use ancf_solver::equations::{
    Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights, correct_work,
};
use nalgebra::{Matrix3, Vector3};

use crate::constraints::{Wrench, add_outer};
use crate::kinematics::BodyVector;

/// Spring and parallel damper between two points, d = r_a − r_b, of free length L₀. The tensile force is
///
/// N = k e + c dl/dt, e = l − l₀ − s (L₀ − l₀), l = |d|,
///
/// where l₀ is the reference distance. The load factor s, which differs from 1 in statics only, scales the preload. A
/// rope has no compression: N = 0 for e ≤ 0, and N ≥ 0 otherwise.
///
/// U = ½ k e² minus its reference value; the damper dissipates c (dl/dt)². The derivative of the damper force by q is
/// not symmetric, and the tangent contains its symmetric part. For coincident points the direction of the force is
/// undefined, so the state is inadmissible.
///
/// Units: k force/length, c force × time/length.
#[derive(Clone, Debug)]
pub struct Strut {
    global: BodyVector,
    distance_vector: BodyVector,
    coordinates: Vec<usize>,
    stiffness: f64,
    damping: f64,
    /// Preload length L₀ − l₀.
    preload_length: f64,
    rope: bool,
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
        let global = BodyVector::combined([(1.0, &a.into()), (-1.0, &b.into())]);
        let coordinates = BodyVector::union_coordinates([&global]);
        let distance_vector = global.within(&coordinates);
        let preload_length = free_length - distance_vector.reference().norm();
        Self { global, distance_vector, coordinates, stiffness, damping, preload_length, rope: false }
    }

    /// Sets the free length to the reference distance, which gives zero force in the reference state.
    #[must_use]
    pub fn unstressed(self) -> Self {
        Self { preload_length: 0.0, ..self }
    }

    /// Restricts the force to tension.
    #[must_use]
    pub fn tension_only(self) -> Self {
        Self { rope: true, ..self }
    }

    fn distance(&self, vector: &BodyVector, q: &[f64]) -> StrutLength {
        let (d0, u) = (vector.reference(), vector.change(q));
        let d = d0 + u;
        let length = d.norm();
        let change = (2.0 * d0.dot(&u) + u.dot(&u)) / (length + d0.norm());
        StrutLength { length, change, unit: d / length }
    }

    /// Returns e at a change of length and a load factor. It is 0 for a slack rope.
    fn stretch(&self, change: f64, load: f64) -> f64 {
        let stretch = change - load * self.preload_length;
        if self.rope { stretch.max(0.0) } else { stretch }
    }

    /// Returns N, and true if N depends on e and dl/dt.
    fn force(&self, change: f64, load: f64, rate: f64) -> (f64, bool) {
        let stretch = self.stretch(change, load);
        let force = self.stiffness * stretch + self.damping * rate;
        let acts = !self.rope || (stretch > 0.0 && force > 0.0);
        (if acts { force } else { 0.0 }, acts)
    }

    /// Returns the force on the first body, at its point.
    pub fn reaction(&self, s: &State) -> Wrench {
        let StrutLength { change, unit, .. } = self.distance(&self.global, &s.q);
        let (force, _) = self.force(change, s.load, unit.dot(&self.global.velocity(s)));
        Wrench { force: unit * -force, ..Wrench::default() }
    }
}

impl Term for Strut {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let StrutLength { change, unit, .. } = self.distance(&self.distance_vector, at.q);
        let (force, _) = self.force(change, at.load, unit.dot(&self.distance_vector.rate(at.q, at.v)));
        self.distance_vector.add(at.q, unit * force, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let StrutLength { length, change, unit } = self.distance(&self.distance_vector, at.q);
        let (speed, zeros) = (self.distance_vector.rate(at.q, at.v), [0.0; LOCAL]);
        let (force, acts) = self.force(change, at.load, unit.dot(&speed));
        // The displacement determines the rounding error of the length change, and the position that of the direction.
        let moved = self.distance_vector.size(at.q) - self.distance_vector.size(&zeros[..at.q.len()]);
        let turned = 2.0 * self.distance_vector.size(at.q) / length;
        let of_force = if acts {
            self.stiffness * (moved + change.abs() + (at.load * self.preload_length).abs())
                + self.damping * (turned * speed.norm() + self.distance_vector.rate_size(at.q, at.v))
        } else {
            0.0
        };
        let bound = 2.0 * f64::EPSILON * (of_force + turned * force.abs());
        let Some(marker) = self.distance_vector.marker() else {
            let [_, turned] = self.distance_vector.errors(at.q);
            let error = bound + self.stiffness * turned;
            return self.distance_vector.add_errors(at.q, force.abs(), error, floor);
        };
        for &(first, w) in marker.parts() {
            floor[first..first + 3].iter_mut().for_each(|row| *row += bound * w.abs());
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let distance = self.distance(&self.distance_vector, at.q);
        let rate = distance.unit.dot(&self.distance_vector.rate(at.q, at.v));
        let (force, acts) = self.force(distance.change, at.load, rate);
        if acts {
            self.add_tangent(at, &distance, w, force, k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let (force, mean) = self.of_step(step);
        let (vector, middle) = (&self.distance_vector, &step.middle);
        vector.add(middle.q, mean.unit * force, r);
        if self.damping > 0.0 {
            let StrutLength { change, unit, .. } = self.distance(vector, middle.q);
            let rate = unit.dot(&vector.rate(middle.q, middle.v));
            let [moving, still] = [rate, 0.0].map(|rate| self.force(change, middle.load, rate).0);
            vector.add(middle.q, unit * (moving - still), r);
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
        if force != 0.0 || !self.rope {
            let mean = StrutLength { unit: mean.unit.normalize(), ..mean };
            self.add_tangent(&step.middle, &mean, w, force, k);
        }
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let StrutLength { length, change, unit } = self.distance(&self.distance_vector, at.q);
        if self.rope && self.stretch(change, at.load) <= 0.0 {
            return;
        }
        let force = self.stiffness
            * (unit.dot(&self.distance_vector.rate(at.q, by.q)) - by.load * self.preload_length);
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
        let [now, first] = [change, 0.0].map(|change| self.stretch(change, at.load));
        Energy { strain: 0.5 * self.stiffness * (now - first) * (now + first), ..Energy::default() }
    }
}

impl Strut {
    /// Returns the elastic force of a step, ΔU/Δl for χ = 0, and the distance with the mean length and the direction
    /// (d₀ + d₁)/(l₀ + l₁), which gives exactly Δl for Δd.
    fn of_step(&self, step: &LocalStep<'_>) -> (f64, StrutLength) {
        let vector = &self.distance_vector;
        let [from, to] = [step.from.q, step.to.q].map(|q| self.distance(vector, q));
        let [before, now] = [&from, &to].map(|end| self.stretch(end.change, step.middle.load));
        let moved = to.change - from.change;
        // Part of the step in which a rope is tight.
        let tight = if before > 0.0 && now > 0.0 || !self.rope {
            1.0
        } else {
            ((now - before) / moved).clamp(0.0, 1.0)
        };
        let [start, end] = step.shares();
        let force = if before == 0.0 && now == 0.0 {
            0.0
        } else {
            self.stiffness * tight * (start * before + end * now).max(if self.rope { 0.0 } else { f64::MIN })
        };
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
        force: f64,
        k: &mut LocalMatrix<'_>,
    ) {
        let speed = self.distance_vector.rate(at.q, at.v);
        let (unit, length) = (*unit, *length);
        let along = unit * unit.transpose();
        let transverse = (Matrix3::identity() - along) / length;
        // ∂(dl/dt)/∂d is the transverse velocity over l.
        let turning = unit * (transverse * speed).transpose() * (0.5 * self.damping);
        let stiffness = along * self.stiffness + transverse * force + turning + turning.transpose();
        self.distance_vector.add_quadratic(at.q, &(stiffness * w.q + along * (w.v * self.damping)), k);
        if !self.distance_vector.is_linear() {
            let (n, mut gradient, mut turned) = (at.q.len(), [0.0; LOCAL], [0.0; LOCAL]);
            self.distance_vector.add_curvature(at.q, unit * (force * w.q), k);
            self.distance_vector.add(at.q, unit, &mut gradient[..n]);
            self.distance_vector.add_slope(at.q, at.v, unit, &mut turned[..n]);
            add_outer(&gradient, &turned, w.q * self.damping, n, k);
        }
    }
}
