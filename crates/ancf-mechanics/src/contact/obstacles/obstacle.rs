use nalgebra::{Matrix3, Vector3};

use crate::kinematics::{Attachment, Marker, Real, constant};

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
    pub(super) shape: ObstacleShape,
    /// Point c and the directions of the carrier.
    pub(super) centre: Marker,
    pub(super) directions: [Marker; 3],
    /// Axis, as components in the directions of the carrier.
    pub(super) axis: Vector3<f64>,
}

impl Obstacle {
    /// Creates an obstacle at the point of an attachment, with the axis `axis` in the reference state.
    ///
    /// Returns `None` if the attachment does not have three directions.
    pub fn new(shape: ObstacleShape, place: Attachment, axis: Vector3<f64>) -> Option<Self> {
        let directions = place.axes()?.clone();
        let reference = directions.each_ref().map(Marker::reference);
        let axis = Matrix3::from_columns(&reference).try_inverse()? * axis;
        Some(Self { shape, centre: place.material_point(), directions, axis })
    }

    /// Returns the place of the obstacle, given the coordinates q of all bodies.
    pub(super) fn pose(&self, q: &[f64]) -> ObstaclePose {
        let value = |marker: &Marker| marker.reference() + marker.sum(q);
        let (centre, directions) = (value(&self.centre), self.directions.each_ref().map(value));
        let axis = combine(&directions, &self.axis);
        ObstaclePose { shape: self.shape, centre, directions, axis, components: self.axis }
    }

    /// Returns the coordinates of a point and of the obstacle in ascending order.
    pub(super) fn coordinates(&self, point: &Marker) -> impl Iterator<Item = usize> {
        let [x, y, z] = &self.directions;
        Marker::union_coordinates([point, &self.centre, x, y, z]).into_iter()
    }
}

/// Place of an obstacle in a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct ObstaclePose {
    shape: ObstacleShape,
    centre: Vector3<f64>,
    directions: [Vector3<f64>; 3],
    /// Axis, and its components in the directions.
    axis: Vector3<f64>,
    components: Vector3<f64>,
}

impl ObstaclePose {
    /// Returns the gap of a point.
    pub(super) fn gap(&self, point: &Vector3<f64>) -> f64 {
        self.shape.gap(&(point - self.centre), &self.axis).0
    }

    /// Returns false for planes and hollow obstacles, which have no second side.
    pub(super) const fn is_convex(&self) -> bool {
        matches!(
            self.shape,
            ObstacleShape::Sphere { inside: false, .. } | ObstacleShape::Cylinder { inside: false, .. }
        )
    }

    /// Returns the vector from the centre or the axis of a convex obstacle to a point with a radius, in the frame of the
    /// carrier, over the sum of the radii.
    pub(super) fn radial(&self, point: &Vector3<f64>, own: f64) -> Option<Vector3<f64>> {
        let d = Vector3::from(components(&self.directions, &(point - self.centre)));
        let (radius, radial) = match self.shape {
            ObstacleShape::Sphere { radius, inside: false } => (radius, d),
            ObstacleShape::Cylinder { radius, inside: false } => {
                let axis = self.components.normalize();
                (radius, d - axis * axis.dot(&d))
            }
            _ => return None,
        };
        Some(radial / (radius + own))
    }
}

impl ObstacleShape {
    /// Computes the gap of a point at d from c, and the gradients of the gap by d and by a.
    pub(super) fn gap<D: Real>(self, d: &Vector3<D>, a: &Vector3<D>) -> (D, Vector3<D>, Vector3<D>) {
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

    /// Computes the derivative of the gradient of the gap by d.
    pub(super) fn bend(self, d: &Vector3<f64>, a: &Vector3<f64>) -> Matrix3<f64> {
        let (_, n, _) = self.gap(d, a);
        let across = Matrix3::identity() - n * n.transpose();
        let sign = |inside| if inside { -1.0 } else { 1.0 };
        match self {
            Self::Plane => Matrix3::zeros(),
            Self::Sphere { inside, .. } => across * (sign(inside) / d.norm()),
            Self::Cylinder { inside, .. } => {
                let u = a.normalize();
                (across - u * u.transpose()) * (sign(inside) / (d - u * u.dot(d)).norm())
            }
        }
    }
}

/// Computes X α.
pub(super) fn combine<D: Real>([x, y, z]: &[Vector3<D>; 3], components: &Vector3<f64>) -> Vector3<D> {
    x.map(|x| x * components.x) + y.map(|x| x * components.y) + z.map(|x| x * components.z)
}

/// Computes X⁻¹ d.
pub(super) fn components<D: Real>([x, y, z]: &[Vector3<D>; 3], d: &Vector3<D>) -> [D; 3] {
    let cofactors = [y.cross(z), z.cross(x), x.cross(y)];
    let volume = cofactors[0].dot(x);
    cofactors.map(|cofactor| cofactor.dot(d) / volume)
}
