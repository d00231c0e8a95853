use ancf_solver::equations::{Energy, Local, LocalMatrix, LocalStep, Term, Weights};
use nalgebra::{SMatrix, SVector, Vector3};
use num_dual::DualSVec64;

use super::obstacle::{Obstacle, components};
use super::obstacle_contact::ObstacleContact;
use crate::contact::parts::ContactPoint;
use crate::kinematics::{Marker, Real, add_symmetric};
use crate::laws::ContactLaw;

/// Contact between balls of a rigid body and an [`Obstacle`] with friction at the surface of the balls, on which they roll.
///
/// The normal force is that of [`ObstacleContact`]. The friction f acts on both bodies at d − R n, with the gradient n of the gap and the
/// radius R. With the directions Y of the body and X of the carrier, σ = −R Y⁻¹ n and ρ = X⁻¹(d − R n), it acts by f on d, σₖ f on yₖ
/// and −ρₖ f on xₖ, with the relative velocity w = ḋ + Ẏ σ − Ẋ ρ. It does no work in rolling, w = 0, and conserves momentum and angular
/// momentum. The tangent of the friction is the symmetric part of its derivative with constant normal force.
#[derive(Clone, Debug)]
pub struct BallContact {
    /// Contact without friction.
    contact: ObstacleContact,
    /// Directions Y of the body.
    turning: [Marker; 3],
    friction: ContactLaw,
}

/// Vectors d, x, y and z of the carrier and those of the body, or their velocities.
type BallValues<D> = SVector<D, 21>;

impl BallContact {
    /// Creates the contact of balls, given by their centres, of a body with the directions `turning`.
    pub fn new(
        obstacle: &Obstacle,
        (points, turning): (&[ContactPoint], &[Marker; 3]),
        radius: f64,
        law: ContactLaw,
    ) -> Self {
        let smooth = ContactLaw { friction: 0.0, ..law };
        let contact = ObstacleContact::of_points(obstacle, (points, turning), radius, smooth);
        let turning = turning.each_ref().map(|marker| marker.within(contact.coordinates()));
        Self { contact, turning, friction: law }
    }

    fn markers<'a>(&'a self, point: &'a ContactPoint) -> [&'a Marker; 7] {
        let [d, x, y, z] = self.contact.markers(point);
        let [a, b, c] = &self.turning;
        [d, x, y, z, a, b, c]
    }

    /// Calls `visit` with each ball that touches the obstacle, its normal force, and the values and velocities of its markers.
    fn visit(&self, at: &Local<'_>, mut visit: impl FnMut(&ContactPoint, f64, [&BallValues<f64>; 2])) {
        self.contact.visit(at.q, |point, x| {
            let (normal, ..) = self.contact.normal_force(point, [x, &self.contact.sums(point, at.v)]);
            let markers = self.markers(point);
            let values = markers.map(|marker| marker.reference() + marker.sum(at.q));
            let rates = markers.map(|marker| marker.sum(at.v));
            visit(point, normal, [&stacked(&values), &stacked(&rates)]);
        });
    }

    /// Computes the generalised forces of friction on all vectors.
    fn forces<D: Real>(
        &self,
        (point, normal): (&ContactPoint, f64),
        x: &BallValues<D>,
        v: &BallValues<D>,
    ) -> BallValues<D> {
        let vector = |of: &BallValues<D>, k: usize| of.fixed_rows::<3>(3 * k).into_owned();
        let three = |of: &BallValues<D>, first: usize| [0, 1, 2].map(|k| vector(of, first + k));
        let (d, axes, turning) = (vector(x, 0), three(x, 1), three(x, 4));
        let n = self.contact.normal(&d, &axes);
        let arm = n.map(|n| n * -self.contact.radius(point));
        let (reach, share) = (components(&axes, &(d + arm)), components(&turning, &arm));
        let mut w = vector(v, 0);
        for k in 0..3 {
            let moved = |k: usize, factor: D| vector(v, k).map(|rate| rate * factor);
            w += moved(4 + k, share[k]) - moved(1 + k, reach[k]);
        }
        let force = self.friction.tangential(D::from(normal), &n, &w);
        let mut forces = BallValues::from_element(D::from(0.0));
        let mut set = |k: usize, factor: D| {
            forces.fixed_rows_mut::<3>(3 * k).copy_from(&force.map(|f| f * factor));
        };
        set(0, D::from(1.0));
        for k in 0..3 {
            set(1 + k, -reach[k]);
            set(4 + k, share[k]);
        }
        forces
    }

    /// Adds the friction of a state to the rows of a residual.
    fn add_friction(&self, at: &Local<'_>, rows: &mut [f64]) {
        self.visit(at, |point, normal, [x, v]| {
            let forces = self.forces((point, normal), x, v);
            for (k, marker) in self.markers(point).into_iter().enumerate() {
                marker.add(-forces.fixed_rows::<3>(3 * k), rows);
            }
        });
    }

    /// Computes ∂(forces)/∂z along dx = w_q z, dv = w_v z.
    fn slope(
        &self,
        of: (&ContactPoint, f64),
        [x, v]: [&BallValues<f64>; 2],
        w: Weights,
    ) -> SMatrix<f64, 21, 21> {
        let moved = |x: &BallValues<f64>, z: &BallValues<DualSVec64<21>>, w: f64| {
            BallValues::from_fn(|i, _| z[i] * w + x[i])
        };
        num_dual::jacobian(|z| self.forces(of, &moved(x, &z, w.q), &moved(v, &z, w.v)), &BallValues::zeros())
            .1
    }
}

fn stacked(vectors: &[Vector3<f64>; 7]) -> BallValues<f64> {
    BallValues::from_fn(|i, _| vectors[i / 3][i % 3])
}

impl Term for BallContact {
    fn coordinates(&self) -> &[usize] {
        self.contact.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.contact.residual(at, r);
        self.add_friction(at, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.contact.rounding(at, floor);
        self.visit(at, |point, _, [x, v]| {
            let values = x.fixed_rows::<12>(0).into_owned();
            let radius = self.contact.radius(point);
            let spin: f64 = (4..7).map(|k| v.fixed_rows::<3>(3 * k).norm()).sum();
            let own = self.turning.iter().map(|marker| marker.sum_of_sizes(at.v)).sum::<f64>();
            let (bound, reach, _) =
                self.contact.rounding_bound(&self.friction, point, &values, (at, radius * (own + spin)));
            for (k, marker) in self.markers(point).into_iter().enumerate() {
                let arm = match k {
                    0 => 1.0,
                    1..4 => reach[k - 1].abs() + radius,
                    _ => radius,
                };
                for &(first, w) in marker.parts() {
                    floor[first..first + 3].iter_mut().for_each(|row| *row += bound * w.abs() * arm);
                }
            }
        });
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.contact.tangent(at, w, k);
        self.visit(at, |point, normal, values| {
            add_symmetric(&self.markers(point), &self.slope((point, normal), values, w), -1.0, k);
        });
    }

    /// Friction is that of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.contact.average_residual(step, r);
        self.add_friction(&step.middle, r);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        self.contact.energy(at)
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        self.contact.damping_forces(at, r);
        self.add_friction(at, r);
    }
}
