use ancf_solver::equations::{Local, LocalMatrix, State, Term, Weights};
use nalgebra::{Vector2, Vector3};

use crate::constraints::Wrench;
use crate::kinematics::BodyVector;
use crate::laws::FrictionCurve;

/// Dry friction along a joint coordinate that is proportional to the reaction of the joint: Q = −μ ρ N(λ) g(v).
///
/// The factor ρ is 1 for a displacement and the radius of a pin for an angle. N is the sum of normal forces of the bearing
/// ([`Bearing`]), g the [`FrictionCurve`]. The friction of step ends depends on the multipliers of the same step ends.
///
/// The tangent lacks the derivatives by multipliers and directions, which are not symmetric. Newton's method converges linearly, by a
/// factor of the order of μ times a ratio of lengths. Where it is 1 the joint is self-locking and the iterations fail.
#[derive(Clone, Debug)]
pub struct ReactionFriction {
    /// Joint coordinate, then those of the directions of the bearing.
    coordinates: Vec<usize>,
    /// Multipliers of the joint that N depends on.
    multipliers: Vec<usize>,
    bearing: Bearing,
    coefficient: f64,
    curve: FrictionCurve,
}

/// Normal forces of a joint by its multipliers.
#[derive(Clone, Debug)]
pub enum Bearing {
    /// Pin: multipliers of the force along the global axes, and of the moments across the axis.
    Pin {
        /// Directions n₁ and n₂ across the axis.
        normals: Box<[BodyVector; 2]>,
        /// Radius of the pin.
        radius: f64,
        /// Distance of two bearings that carry the moments; `None` without friction by moments.
        span: Option<f64>,
        /// Radius of the collar that carries the axial force; 0 without friction by this force.
        collar: f64,
    },
    /// Straight guide: multipliers of the forces and of the moments across the axis, and of the moment about it.
    Guide {
        /// Distance of two shoes that carry the moments across the axis; `None` without friction by these moments.
        span: Option<f64>,
        /// Lever arm at which the guide carries the moment about the axis; `None` without friction by this moment.
        arm: Option<f64>,
    },
    /// Curve: multipliers of the force, whose part along the curve is the friction itself.
    Curve,
}

impl Bearing {
    /// Number of multipliers of the joint.
    const fn multipliers(&self) -> usize {
        match self {
            Self::Pin { .. } | Self::Guide { .. } => 5,
            Self::Curve => 3,
        }
    }
}

/// Sum of the normal forces of two bearings at a distance under a force and a moment, m = M × e.
fn normal_force(f: Vector2<f64>, m: Vector2<f64>, span: Option<f64>) -> f64 {
    match span {
        Some(span) => (f * 0.5 + m / span).norm() + (f * 0.5 - m / span).norm(),
        None => f.norm(),
    }
}

impl ReactionFriction {
    /// Creates the friction along a joint coordinate, with the first of the multipliers of the joint.
    pub fn new(
        coordinate: usize,
        first: usize,
        bearing: Bearing,
        coefficient: f64,
        curve: FrictionCurve,
    ) -> Self {
        let mut coordinates = vec![coordinate];
        let mut bearing = bearing;
        if let Bearing::Pin { normals, .. } = &mut bearing {
            coordinates.extend(BodyVector::union_coordinates(normals.iter()));
            **normals = normals.each_ref().map(|normal| normal.within(&coordinates));
        }
        let multipliers = (first..first + bearing.multipliers()).collect();
        Self { coordinates, multipliers, bearing, coefficient, curve }
    }

    /// Returns ρ N; 0 without multipliers, as in the evaluation of masses.
    fn normal(&self, at: &Local<'_>) -> f64 {
        let l = at.lambda;
        if l.len() < self.multipliers.len() {
            return 0.0;
        }
        match &self.bearing {
            Bearing::Pin { normals, radius, span, collar } => {
                let force = Vector3::from_column_slice(&l[..3]);
                let [n1, n2] = normals.each_ref().map(|normal| normal.at(at.q));
                let across = Vector2::new(force.dot(&n1), force.dot(&n2));
                let axial = force.dot(&n1.cross(&n2)).abs();
                radius * normal_force(across, Vector2::new(l[3], l[4]), *span) + collar * axial
            }
            Bearing::Guide { span, arm } => {
                let across = normal_force(Vector2::new(l[0], l[1]), Vector2::new(l[2], l[3]), *span);
                across + arm.map_or(0.0, |arm| l[4].abs() / arm)
            }
            Bearing::Curve => {
                let along = self.coefficient * self.curve.at(at.v[0]);
                Vector3::from_column_slice(l).norm() / (1.0 + along * along).sqrt()
            }
        }
    }

    /// Returns zero: the equation that defines the coordinate has the reaction.
    pub fn reaction(&self, _: &State) -> Wrench {
        Wrench::default()
    }
}

impl Term for ReactionFriction {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn observed_multipliers(&self) -> &[usize] {
        &self.multipliers
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += self.coefficient * self.normal(at) * self.curve.at(at.v[0]);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (v, amount) = (at.v[0], self.coefficient * self.normal(at));
        let of_rate = (self.curve.slope(v) * v).abs();
        floor[0] += 32.0 * f64::EPSILON * amount * (self.curve.at(v).abs() + of_rate);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.v * self.coefficient * self.normal(at) * self.curve.slope(at.v[0]));
    }
}
