use ancf::model::{PointMass, Rigid};
use nalgebra::Matrix3;

/// Maximum edge of the box drawn for a rigid body, relative to the size of the model.
pub const BOX_EDGE: f64 = 0.12;
/// Radius of the sphere drawn for a point mass without contact surface, relative to the size of the model.
pub const POINT_MASS_RADIUS: f64 = 0.02;
/// Minimum ratio of the shortest to the longest edge, which keeps needles and plates visible.
const MIN_ASPECT: f64 = 0.15;

/// Box with the inertia of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InertiaBox {
    /// Edges along the principal axes, in the unit of length of the body.
    pub edges: [f64; 3],
    /// Principal axes as unit vectors in the axes of the body, a right-handed triad.
    pub axes: [[f64; 3]; 3],
}

/// Radius of the sphere drawn for a point mass in a model of some size: that of its contact surface, if it has one.
pub fn point_mass_radius(mass: &PointMass, size: f64) -> f64 {
    let radius = mass.surface.as_ref().map(|surface| surface.radius);
    radius.filter(|radius| *radius > 0.0).unwrap_or(POINT_MASS_RADIUS * size)
}

/// Returns the box with the inertia of a rigid body, shrunk to edges of at most `max_edge`.
///
/// A box of mass m with edges a, b, c has I_a = m (b² + c²)/12, so that a² = 6 (I_b + I_c − I_a)/m.
/// Without a finite positive edge, the result is a cube with edges `max_edge`.
pub fn inertia_box(body: &Rigid, max_edge: f64) -> InertiaBox {
    let tensor = body.tensor();
    let is_diagonal = tensor == Matrix3::from_diagonal(&tensor.diagonal());
    let (moments, mut axes) = if is_diagonal {
        (tensor.diagonal(), Matrix3::identity())
    } else {
        let eigen = tensor.symmetric_eigen();
        (eigen.eigenvalues, eigen.eigenvectors)
    };
    if axes.determinant() < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    let edge = |moment: f64| (6.0 * (moments.sum() - 2.0 * moment) / body.mass).max(0.0).sqrt();
    let edges: [f64; 3] = moments.map(edge).into();
    let longest = edges.iter().copied().fold(0.0, f64::max);
    if longest == 0.0 || !longest.is_finite() {
        return InertiaBox { edges: [max_edge; 3], axes: Matrix3::identity().into() };
    }
    let factor = (max_edge / longest).min(1.0);
    // An array of a matrix is that of its columns.
    InertiaBox { edges: edges.map(|edge| edge.max(MIN_ASPECT * longest) * factor), axes: axes.into() }
}
