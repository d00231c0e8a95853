use ancf_solver::equations::{Energy, LOCAL, Local, LocalMatrix, LocalStep, Term, Weights};
use nalgebra::{SMatrix, SVector, Vector3};
use num_dual::DualSVec64;

use super::obstacle::{Obstacle, ObstacleShape, combine, components};
use crate::contact::parts::ContactPoint;
use crate::kinematics::{Marker, Real, add_symmetric};
use crate::laws::ContactLaw;

/// Contact between points of a body and an [`Obstacle`], for the length of beam or the area of shell that each point represents.
///
/// With d = p − c, the directions X = [x y z] of the carrier, a = X α and the gap g(d, a) minus the radius of the body,
/// N acts along ∂g/∂d on d and αₖ ∂g/∂a on xₖ. The friction f acts at p on the beam. On the carrier it acts as if the
/// carrier extended to p: −f on c and −ρₖ f on xₖ, ρ = X⁻¹d, with the relative velocity w = ḋ − Ẋ ρ. Momentum and
/// angular momentum of both bodies are therefore conserved. The friction of a rope on a pulley has the same lever as
/// its tension. The tangent is the symmetric part of the derivative, with constant N in the friction. It is exact
/// without friction and damping.
#[derive(Clone, Debug)]
pub struct ObstacleContact {
    shape: ObstacleShape,
    axis: Vector3<f64>,
    /// Points with their vectors d.
    points: Vec<ContactPoint>,
    /// Directions of the carrier.
    directions: [Marker; 3],
    coordinates: Vec<usize>,
    radius: f64,
    law: ContactLaw,
}

/// Vectors d, x, y, z, or their velocities.
pub(super) type MarkerValues<D> = SVector<D, 12>;

impl ObstacleContact {
    /// Creates the contact of a point of a body with a radius.
    ///
    /// Returns `None` if the point and the carrier of the obstacle have more than [`LOCAL`] coordinates.
    pub fn new(obstacle: &Obstacle, point: &ContactPoint, radius: f64, law: ContactLaw) -> Option<Self> {
        let contact = Self::of_points(obstacle, (std::slice::from_ref(point), &[]), radius, law);
        (contact.coordinates.len() <= LOCAL).then_some(contact)
    }

    /// Creates the contact of several points. Its coordinates include those of other markers.
    pub(super) fn of_points(
        obstacle: &Obstacle,
        (points, others): (&[ContactPoint], &[Marker]),
        radius: f64,
        law: ContactLaw,
    ) -> Self {
        let Obstacle { shape, centre, directions, axis } = obstacle;
        let from_centre = |point: &ContactPoint| Marker::combined([(1.0, &point.place), (-1.0, centre)]);
        let vectors: Vec<Marker> = points.iter().map(from_centre).collect();
        let coordinates = Marker::union_coordinates(vectors.iter().chain(directions).chain(others));
        let vectors = vectors.iter().map(|vector| vector.within(&coordinates)).zip(points);
        let points = vectors.map(|(vector, point)| point.at(vector)).collect();
        let directions = directions.each_ref().map(|direction| direction.within(&coordinates));
        Self { shape: *shape, axis: *axis, points, directions, coordinates, radius, law }
    }

    /// Returns a vector with the directions of the carrier.
    pub(super) fn markers<'a>(&'a self, point: &'a ContactPoint) -> [&'a Marker; 4] {
        let [x, y, z] = &self.directions;
        [&point.place, x, y, z]
    }

    /// Returns the sums of the markers over a vector q or v.
    pub(super) fn sums(&self, point: &ContactPoint, of: &[f64]) -> MarkerValues<f64> {
        stacked(self.markers(point).map(|marker| marker.sum(of)))
    }

    /// Returns the values of the markers.
    fn values(&self, point: &ContactPoint, q: &[f64]) -> MarkerValues<f64> {
        stacked(self.markers(point).map(|marker| marker.reference() + marker.sum(q)))
    }

    /// Returns the radius of the body at a point.
    pub(super) fn radius(&self, point: &ContactPoint) -> f64 {
        self.radius + point.excess
    }

    fn gap(&self, point: &ContactPoint, x: &MarkerValues<f64>) -> f64 {
        let [d, axes @ ..] = parts(x);
        self.shape.gap(&d, &combine(&axes, &self.axis)).0 - self.radius(point)
    }

    /// Calls `visit` with each point that touches the obstacle, and the values of its markers.
    pub(super) fn visit(&self, q: &[f64], mut visit: impl FnMut(&ContactPoint, &MarkerValues<f64>)) {
        let value = |marker: &Marker| marker.reference() + marker.sum(q);
        let directions = self.directions.each_ref().map(value);
        let a = combine(&directions, &self.axis);
        for point in &self.points {
            let d = value(&point.place);
            if self.shape.gap(&d, &a).0 < self.radius(point) {
                let [x, y, z] = directions;
                visit(point, &stacked([d, x, y, z]));
            }
        }
    }

    /// Computes the gradient of the gap by d, given the directions of the carrier.
    pub(super) fn normal<D: Real>(&self, d: &Vector3<D>, axes: &[Vector3<D>; 3]) -> Vector3<D> {
        self.shape.gap(d, &combine(axes, &self.axis)).1
    }

    /// Computes the normal force of a point and the gradients of the gap by d and by a, given the values and the velocities of its
    /// markers.
    pub(super) fn normal_force<D: Real>(
        &self,
        point: &ContactPoint,
        [x, v]: [&MarkerValues<D>; 2],
    ) -> (D, Vector3<D>, Vector3<D>) {
        let ([d, axes @ ..], [rate, spins @ ..]) = (parts(x), parts(v));
        let (gap, n, b) = self.shape.gap(&d, &combine(&axes, &self.axis));
        let closing = n.dot(&rate) + b.dot(&combine(&spins, &self.axis));
        (self.law.normal(gap - self.radius(point), closing) * point.extent, n, b)
    }

    /// Computes the generalised forces on d, x, y and z of a point.
    fn forces<D: Real>(
        &self,
        point: &ContactPoint,
        x: &MarkerValues<D>,
        v: &MarkerValues<D>,
    ) -> MarkerValues<D> {
        let ([d, axes @ ..], [rate, spins @ ..]) = (parts(x), parts(v));
        let (normal, n, b) = self.normal_force(point, [x, v]);
        let reach = components(&axes, &d);
        let relative_velocity: Vector3<D> =
            spins.iter().zip(&reach).map(|(spin, r)| spin.map(|x| x * *r)).fold(rate, |w, part| w - part);
        let friction = self.law.tangential(D::from(normal.re()), &n, &relative_velocity);
        let mut forces = MarkerValues::from_element(D::from(0.0));
        forces.fixed_rows_mut::<3>(0).copy_from(&(n.map(|x| x * normal) + friction));
        for k in 0..3 {
            let share = b.map(|x| x * normal * self.axis[k]) - friction.map(|x| x * reach[k]);
            forces.fixed_rows_mut::<3>(3 * k + 3).copy_from(&share);
        }
        forces
    }

    /// Returns true if the obstacle is fixed to the ground. Only d depends on the state then.
    fn is_fixed(&self) -> bool {
        self.directions.iter().all(|direction| direction.parts().is_empty())
    }

    /// Adds forces on the vectors to the rows of a residual.
    fn add_forces(&self, point: &ContactPoint, forces: &MarkerValues<f64>, rows: &mut [f64]) {
        let markers = self.markers(point);
        markers.into_iter().zip(parts(forces)).for_each(|(marker, force)| marker.add(-force, rows));
    }

    /// Computes the derivative by d of the force on d from a fixed obstacle, along dx = w_q z, dv = w_v z.
    fn fixed_slope(
        &self,
        point: &ContactPoint,
        [x, v]: [&MarkerValues<f64>; 2],
        w: Weights,
    ) -> SMatrix<f64, 3, 3> {
        let ([d, axes @ ..], [rate, ..]) = (parts(x), parts(v));
        let a = combine(&axes, &self.axis);
        let (gap, n, _) = self.shape.gap(&d, &a);
        let gap = gap - self.radius(point);
        let [by_place, by_rate] = self.law.slopes(gap, &n, &self.shape.bend(&d, &a), &rate);
        (by_place * w.q + by_rate * w.v) * point.extent
    }

    /// Computes ∂(forces)/∂z of a point along dx = w_q z, dv = w_v z.
    fn slope(
        &self,
        point: &ContactPoint,
        [x, v]: [&MarkerValues<f64>; 2],
        w: Weights,
    ) -> SMatrix<f64, 12, 12> {
        let moved = |x: &MarkerValues<f64>, z: &MarkerValues<DualSVec64<12>>, w: f64| {
            MarkerValues::from_fn(|i, _| z[i] * w + x[i])
        };
        let forces = |z| self.forces(point, &moved(x, &z, w.q), &moved(v, &z, w.v));
        num_dual::jacobian(forces, &MarkerValues::zeros()).1
    }

    /// Returns the multiple of ε that bounds the errors of the force by a law, and ρ and |∂g/∂a| for those on the carrier.
    ///
    /// `other` is a multiple of ε that bounds further errors of velocities.
    pub(super) fn rounding_bound(
        &self,
        law: &ContactLaw,
        point: &ContactPoint,
        x: &MarkerValues<f64>,
        (at, other): (&Local<'_>, f64),
    ) -> (f64, [f64; 3], f64) {
        let [d, axes @ ..] = parts(x);
        let gap = self.gap(point, x);
        let tilt: f64 =
            self.directions.iter().zip(&axes).map(|(own, axis)| own.size(at.q) / axis.norm()).sum();
        // Radius of the obstacle, and lever of the errors of the normal.
        let (round, distance) = match self.shape {
            ObstacleShape::Plane => (0.0, f64::INFINITY),
            ObstacleShape::Sphere { radius, inside } | ObstacleShape::Cylinder { radius, inside } => {
                let reach = gap + self.radius(point);
                (radius, if inside { radius - reach } else { radius + reach })
            }
        };
        let place = point.place.size(at.q) + d.norm() * tilt;
        let reach = components(&axes, &d);
        let [rate, spins @ ..] = parts(&self.sums(point, at.v));
        let velocity_error = other
            + point.place.sum_of_sizes(at.v)
            + (0..3).map(|k| reach[k].abs() * self.directions[k].sum_of_sizes(at.v)).sum::<f64>()
            + spins.iter().map(|spin| spin.norm()).sum::<f64>() * place;
        let turned = tilt + place / distance;
        let (_, _, b) = self.shape.gap(&d, &combine(&axes, &self.axis));
        let speed = rate.norm() + b.norm() * combine(&spins, &self.axis).norm();
        let errors = [place + self.radius(point) + round, turned, velocity_error];
        (law.rounding(gap, speed, errors) * point.extent, reach, b.norm())
    }
}

fn stacked([d, x, y, z]: [Vector3<f64>; 4]) -> MarkerValues<f64> {
    let mut stacked = MarkerValues::zeros();
    for (i, vector) in [d, x, y, z].iter().enumerate() {
        stacked.fixed_rows_mut::<3>(3 * i).copy_from(vector);
    }
    stacked
}

/// Splits a column into four vectors.
fn parts<D: Real>(x: &MarkerValues<D>) -> [Vector3<D>; 4] {
    [0, 3, 6, 9].map(|i| x.fixed_rows::<3>(i).into_owned())
}

impl Term for ObstacleContact {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.visit(at.q, |point, x| {
            self.add_forces(point, &self.forces(point, x, &self.sums(point, at.v)), r);
        });
    }

    /// Relative errors of d and the directions affect the normal. Errors of the gap and the velocities affect the
    /// force.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.visit(at.q, |point, x| {
            let (bound, reach, b) = self.rounding_bound(&self.law, point, x, (at, 0.0));
            for (k, marker) in self.markers(point).into_iter().enumerate() {
                let arm = if k == 0 { 1.0 } else { reach[k - 1].abs() + self.axis[k - 1].abs() * b };
                for &(first, w) in marker.parts() {
                    floor[first..first + 3].iter_mut().for_each(|row| *row += bound * w.abs() * arm);
                }
            }
        });
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let is_fixed = self.is_fixed();
        self.visit(at.q, |point, x| {
            let v = self.sums(point, at.v);
            if is_fixed {
                add_symmetric(&[&point.place], &self.fixed_slope(point, [x, &v], w), -1.0, k);
            } else {
                add_symmetric(&self.markers(point), &self.slope(point, [x, &v], w), -1.0, k);
            }
        });
    }

    /// The normal force does the work of the potential between both ends. Damping and friction are those of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.residual(&step.middle, r);
        let (mut moved, n) = ([0.0; LOCAL], step.to.q.len());
        (0..n).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
        for point in &self.points {
            let gaps = [step.from, step.middle, step.to].map(|at| self.gap(point, &self.values(point, at.q)));
            if gaps[0] >= 0.0 && gaps[2] >= 0.0 {
                continue;
            }
            let [d, axes @ ..] = parts(&self.values(point, step.middle.q));
            let [apart, turned @ ..] = parts(&self.sums(point, &moved));
            let (_, normal, b) = self.shape.gap(&d, &combine(&axes, &self.axis));
            let change = normal.dot(&apart) + b.dot(&combine(&turned, &self.axis));
            let energies = [gaps[0], gaps[2]].map(|gap| self.law.energy(gap));
            let pressures = gaps.map(|gap| self.law.pressure(gap));
            let size = point.place.size(step.middle.q) + self.radius(point);
            let excess = ContactLaw::discrete_excess(energies, change, pressures, size) * point.extent;
            let [x, y, z] = [0, 1, 2].map(|k| b * (excess * self.axis[k]));
            self.add_forces(point, &stacked([normal * excess, x, y, z]), r);
        }
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let mut strain = 0.0;
        self.visit(at.q, |point, x| strain += point.extent * self.law.energy(self.gap(point, x)));
        Energy { strain, ..Energy::default() }
    }

    fn is_damped(&self) -> bool {
        self.law.is_damped()
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        self.visit(at.q, |point, x| {
            let [moving, still] =
                [self.sums(point, at.v), MarkerValues::zeros()].map(|v| self.forces(point, x, &v));
            self.add_forces(point, &(moving - still), r);
        });
    }
}
