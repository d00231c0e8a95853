use ancf_solver::equations::{Energy, LOCAL, Local, LocalMatrix, LocalStep, Term, Weights};
use nalgebra::{SMatrix, SVector, Vector3};

use super::contact_law::ContactLaw;
use crate::kinematics::{Attachment, Marker, Real, add_symmetric, constant};

/// Shape of an obstacle about its point c with an axis a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObstacleShape {
    /// Half space behind the plane through c with the normal a.
    Plane,
    /// Ball with the centre c, or its exterior.
    Sphere {
        /// Radius.
        radius: f64,
        /// True if bodies are inside.
        inside: bool,
    },
    /// Infinite cylinder about the line through c along a, or its exterior.
    Cylinder {
        /// Radius.
        radius: f64,
        /// True if bodies are inside.
        inside: bool,
    },
}

/// Obstacle fixed to the ground or to a body.
#[derive(Clone, Debug)]
pub struct Obstacle {
    shape: ObstacleShape,
    place: Attachment,
    /// Axis, as components in the directions of the carrier.
    axis: Vector3<f64>,
}

impl Obstacle {
    /// Creates an obstacle at the point of an attachment, with the axis `axis` in the reference state.
    ///
    /// Returns `None` if the attachment does not have three directions.
    pub fn new(shape: ObstacleShape, place: Attachment, axis: Vector3<f64>) -> Option<Self> {
        let reference = place.axes()?.each_ref().map(Marker::reference);
        let axis = SMatrix::<f64, 3, 3>::from_columns(&reference).try_inverse()? * axis;
        Some(Self { shape, place, axis })
    }
}

impl ObstacleShape {
    /// Computes the gap of a point at d from c, and the gradients of the gap by d and by a.
    fn gap<D: Real>(self, d: &Vector3<D>, a: &Vector3<D>) -> (D, Vector3<D>, Vector3<D>) {
        let unit = |x: &Vector3<D>| {
            let length = x.dot(x).sqrt();
            (length, x.map(|x| x / length))
        };
        let sign = |inside| if inside { -1.0 } else { 1.0 };
        match self {
            Self::Plane => {
                let (length, n) = unit(a);
                let gap = n.dot(d);
                (gap, n, (d - n.map(|x| x * gap)).map(|x| x / length))
            }
            Self::Sphere { radius, inside } => {
                let (distance, n) = unit(d);
                let gap = (distance - radius) * sign(inside);
                (gap, n.map(|x| x * sign(inside)), constant(&Vector3::zeros()))
            }
            Self::Cylinder { radius, inside } => {
                let (length, u) = unit(a);
                let along = u.dot(d);
                let (distance, n) = unit(&(d - u.map(|x| x * along)));
                let (gap, n) = ((distance - radius) * sign(inside), n.map(|x| x * sign(inside)));
                (gap, n, n.map(|x| -(x * along / length)))
            }
        }
    }
}

/// Contact between a point of a beam axis and an [`Obstacle`], for the length of beam that the point represents.
///
/// With d = p − c, the directions X = [x y z] of the carrier, a = X α and the gap g(d, a) minus the radius of the beam,
/// N acts along ∂g/∂d on d and αₖ ∂g/∂a on xₖ. The friction f acts at p on the beam. On the carrier it acts as if the
/// carrier extended to p: −f on c and −ρₖ f on xₖ, ρ = X⁻¹d, with the relative velocity w = ḋ − Ẋ ρ. Momentum and
/// angular momentum of both bodies are therefore conserved. The friction of a rope on a pulley has the same lever as
/// its tension. The tangent is the symmetric part of the derivative, with constant N in the friction. It is exact
/// without friction and damping.
#[derive(Clone, Debug)]
pub struct ObstacleContact {
    shape: ObstacleShape,
    axis: Vector3<f64>,
    /// Vector d and the directions of the carrier.
    markers: [Marker; 4],
    coordinates: Vec<usize>,
    /// Vector d and the directions over all coordinates.
    global: [Marker; 4],
    radius: f64,
    length: f64,
    law: ContactLaw,
}

/// Vectors d, x, y, z, or their velocities.
type MarkerValues<D> = SVector<D, 12>;

impl ObstacleContact {
    /// Creates the contact of a point of a beam with a radius. The point represents a length of the beam.
    pub fn new(
        obstacle: &Obstacle,
        point: &Marker,
        radius: f64,
        length: f64,
        law: ContactLaw,
    ) -> Option<Self> {
        let [x, y, z] = obstacle.place.axes()?;
        let d = Marker::combined([(1.0, point), (-1.0, &obstacle.place.material_point())]);
        let global = [d, x.clone(), y.clone(), z.clone()];
        let coordinates = Marker::union_coordinates(&global);
        let markers = global.each_ref().map(|marker| marker.within(&coordinates));
        let Obstacle { shape, axis, .. } = *obstacle;
        Some(Self { shape, axis, markers, coordinates, global, radius, length, law })
    }

    /// Returns the gap at the coordinates q of all bodies.
    pub(crate) fn gap_of_all(&self, q: &[f64]) -> f64 {
        let [d, axes @ ..] = self.global.each_ref().map(|marker| marker.reference() + marker.sum(q));
        self.shape.gap(&d, &combine(&axes, &self.axis)).0 - self.radius
    }

    /// Returns the vector from the centre or the axis of a convex obstacle to the point, in the frame of the carrier,
    /// over the sum of the radii. `None` for planes and hollow obstacles, which have no second side.
    pub(crate) fn radial(&self, q: &[f64]) -> Option<Vector3<f64>> {
        let [d, axes @ ..] = self.global.each_ref().map(|marker| marker.reference() + marker.sum(q));
        let d = Vector3::from(components(&axes, &d));
        let (radius, radial) = match self.shape {
            ObstacleShape::Sphere { radius, inside: false } => (radius, d),
            ObstacleShape::Cylinder { radius, inside: false } => {
                let axis = self.axis.normalize();
                (radius, d - axis * axis.dot(&d))
            }
            _ => return None,
        };
        Some(radial / (radius + self.radius))
    }

    /// Returns a coordinate of the point, or of the carrier if the point is fixed.
    pub(crate) fn coordinate(&self) -> Option<usize> {
        self.coordinates.first().copied()
    }

    /// Returns the values of the markers and their velocities.
    fn values(&self, at: &Local<'_>) -> [MarkerValues<f64>; 2] {
        let stack = |of: &dyn Fn(&Marker) -> Vector3<f64>| {
            let mut x = MarkerValues::zeros();
            for (i, marker) in self.markers.iter().enumerate() {
                x.fixed_rows_mut::<3>(3 * i).copy_from(&of(marker));
            }
            x
        };
        [stack(&|marker| marker.reference() + marker.sum(at.q)), stack(&|marker| marker.sum(at.v))]
    }

    fn gap(&self, x: &MarkerValues<f64>) -> f64 {
        let [d, axes @ ..] = parts(x);
        self.shape.gap(&d, &combine(&axes, &self.axis)).0 - self.radius
    }

    /// Computes the generalised forces on d, x, y and z.
    fn forces<D: Real>(&self, x: &MarkerValues<D>, v: &MarkerValues<D>) -> MarkerValues<D> {
        let ([d, axes @ ..], [rate, spins @ ..]) = (parts(x), parts(v));
        let (gap, n, b) = self.shape.gap(&d, &combine(&axes, &self.axis));
        let closing = n.dot(&rate) + b.dot(&combine(&spins, &self.axis));
        let normal = self.law.smooth_normal(gap - self.radius, closing) * self.length;
        let reach = components(&axes, &d);
        let relative_velocity: Vector3<D> =
            spins.iter().zip(&reach).map(|(spin, r)| spin.map(|x| x * *r)).fold(rate, |w, part| w - part);
        let friction = self.law.smooth_tangential(D::from(normal.re()), &n, &relative_velocity);
        let mut forces = MarkerValues::from_element(D::from(0.0));
        forces.fixed_rows_mut::<3>(0).copy_from(&(n.map(|x| x * normal) + friction));
        for k in 0..3 {
            let share = b.map(|x| x * normal * self.axis[k]) - friction.map(|x| x * reach[k]);
            forces.fixed_rows_mut::<3>(3 * k + 3).copy_from(&share);
        }
        forces
    }

    /// Computes ∂(forces)/∂z along dx = w_q z, dv = w_v z.
    fn slope(&self, x: &MarkerValues<f64>, v: &MarkerValues<f64>, w: Weights) -> SMatrix<f64, 12, 12> {
        if self.markers[1..].iter().all(|axis| axis.parts().is_empty()) {
            // For an obstacle on the ground, only d depends on the state.
            let f = |z: SVector<num_dual::DualSVec64<3>, 3>| {
                let moved = |x: &MarkerValues<f64>, w: f64| {
                    let mut moved = x.map(num_dual::DualSVec64::<3>::from);
                    (0..3).for_each(|i| moved[i] += z[i] * w);
                    moved
                };
                self.forces(&moved(x, w.q), &moved(v, w.v)).fixed_rows::<3>(0).into_owned()
            };
            let (_, h) = num_dual::jacobian(f, &Vector3::zeros());
            let mut slope = SMatrix::<f64, 12, 12>::zeros();
            slope.fixed_view_mut::<3, 3>(0, 0).copy_from(&h);
            return slope;
        }
        let moved = |x: &MarkerValues<f64>, z: &MarkerValues<num_dual::DualSVec64<12>>, w: f64| {
            MarkerValues::from_fn(|i, _| z[i] * w + x[i])
        };
        num_dual::jacobian(|z| self.forces(&moved(x, &z, w.q), &moved(v, &z, w.v)), &MarkerValues::zeros()).1
    }
}

/// Splits a column into four vectors.
fn parts<D: Real>(x: &MarkerValues<D>) -> [Vector3<D>; 4] {
    [0, 3, 6, 9].map(|i| x.fixed_rows::<3>(i).into_owned())
}

/// Computes X α.
fn combine<D: Real>([x, y, z]: &[Vector3<D>; 3], components: &Vector3<f64>) -> Vector3<D> {
    x.map(|x| x * components.x) + y.map(|x| x * components.y) + z.map(|x| x * components.z)
}

/// Computes X⁻¹ d.
fn components<D: Real>([x, y, z]: &[Vector3<D>; 3], d: &Vector3<D>) -> [D; 3] {
    let cofactors = [y.cross(z), z.cross(x), x.cross(y)];
    let volume = cofactors[0].dot(x);
    cofactors.map(|cofactor| cofactor.dot(d) / volume)
}

impl Term for ObstacleContact {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let [x, v] = self.values(at);
        if self.gap(&x) >= 0.0 {
            return;
        }
        let forces = self.forces(&x, &v);
        for (i, marker) in self.markers.iter().enumerate() {
            marker.add(-forces.fixed_rows::<3>(3 * i).into_owned(), r);
        }
    }

    /// Relative errors of d and the directions affect the normal. Errors of the gap and the velocities affect the
    /// force.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let [x, v] = self.values(at);
        let gap = self.gap(&x);
        if gap >= 0.0 {
            return;
        }
        let [d, axes @ ..] = parts(&x);
        let tilt: f64 = (1..4).map(|k| self.markers[k].size(at.q) / axes[k - 1].norm()).sum();
        // Radius of the obstacle, and lever of the errors of the normal.
        let (round, distance) = match self.shape {
            ObstacleShape::Plane => (0.0, f64::INFINITY),
            ObstacleShape::Sphere { radius, inside } | ObstacleShape::Cylinder { radius, inside } => {
                let reach = gap + self.radius;
                (radius, if inside { radius - reach } else { radius + reach })
            }
        };
        let place = self.markers[0].size(at.q) + d.norm() * tilt;
        let reach = components(&axes, &d);
        let [rate, spins @ ..] = parts(&v);
        let velocity_error = self.markers[0].sum_of_sizes(at.v)
            + (0..3).map(|k| reach[k].abs() * self.markers[k + 1].sum_of_sizes(at.v)).sum::<f64>()
            + spins.iter().map(|spin| spin.norm()).sum::<f64>() * place;
        let turned = tilt + place / distance;
        let (_, _, b) = self.shape.gap(&d, &combine(&axes, &self.axis));
        let speed = rate.norm() + b.norm() * combine(&spins, &self.axis).norm();
        let errors = [place + self.radius + round, turned, velocity_error];
        let bound = self.law.rounding(gap, speed, errors) * self.length;
        for (k, marker) in self.markers.iter().enumerate() {
            let arm = if k == 0 { 1.0 } else { reach[k - 1].abs() + self.axis[k - 1].abs() * b.norm() };
            for &(first, w) in marker.parts() {
                floor[first..first + 3].iter_mut().for_each(|row| *row += bound * w.abs() * arm);
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let [x, v] = self.values(at);
        if self.gap(&x) < 0.0 {
            add_symmetric(&self.markers.each_ref(), &self.slope(&x, &v, w), -1.0, k);
        }
    }

    /// The normal force does the work of the potential between both ends. Damping and friction are those of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.residual(&step.middle, r);
        let gaps = [step.from, step.middle, step.to].map(|at| self.gap(&self.values(&at)[0]));
        if gaps[0] >= 0.0 && gaps[2] >= 0.0 {
            return;
        }
        let mut moved = [0.0; LOCAL];
        let n = step.to.q.len();
        (0..n).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
        let [x, moved] = self.values(&Local { v: &moved[..n], ..step.middle });
        let ([d, axes @ ..], [apart, turned @ ..]) = (parts(&x), parts(&moved));
        let (_, normal, b) = self.shape.gap(&d, &combine(&axes, &self.axis));
        let change = normal.dot(&apart) + b.dot(&combine(&turned, &self.axis));
        let energies = [gaps[0], gaps[2]].map(|gap| self.law.energy(gap));
        let pressures = gaps.map(|gap| self.law.pressure(gap));
        let excess = (ContactLaw::discrete_force(energies, change, pressures) - pressures[1]) * self.length;
        self.markers[0].add(-normal * excess, r);
        for (marker, component) in self.markers[1..].iter().zip(&self.axis) {
            marker.add(-b * (excess * component), r);
        }
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let gap = self.gap(&self.values(at)[0]);
        Energy { strain: self.length * self.law.energy(gap), ..Energy::default() }
    }
}
