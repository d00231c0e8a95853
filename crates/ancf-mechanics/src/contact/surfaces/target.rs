use std::fmt::Debug;
use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use crate::contact::parts::{AlignedBox, ContactGeometry, ContactPoint};
use crate::laws::ContactLaw;

/// Element of a shell that points of bodies touch.
pub trait SurfaceTarget: Clone + Debug + Send + Sync + 'static {
    /// Middle surface in a state.
    type Surface: TargetSurface;

    /// Returns the elements of a shell; none of a body of another kind.
    fn of(shell: &ContactGeometry) -> &[Self];

    /// Evaluates the middle surface.
    fn surface(&self, s: &State) -> Self::Surface;

    /// Calls `visit` with each point nearer than twice the sum of the radii in whose contact the element may have a share, and with its
    /// distance relative to this sum.
    ///
    /// Points have a number, a position and the sum of their radius and the smallest one of the shell, at most `reach`. `is_joined` is true for points and elements of the same shell that have no contact with each other.
    fn visit_near(
        &self,
        surface: &Self::Surface,
        reach: f64,
        points: &mut dyn Iterator<Item = (usize, Vector3<f64>, f64)>,
        is_joined: &dyn Fn(usize, usize) -> bool,
        visit: &mut dyn FnMut(usize, f64),
    );

    /// Creates the contact of some points. `radius` is the sum of the smallest radii of both bodies.
    ///
    /// `is_joined` is true for points, by their position in `points`, and elements of the same shell that have no contact with each other.
    fn contact(
        &self,
        points: &[ContactPoint],
        is_joined: &dyn Fn(usize, usize) -> bool,
        radius: f64,
        law: ContactLaw,
    ) -> Arc<dyn Term>;

    /// Returns the number of the element in its shell.
    fn number(&self) -> usize;
}

/// Middle surface of an element in a state, in the convex hull of some points.
pub trait TargetSurface: Sized {
    /// Returns points whose convex hull contains the surface.
    fn hull_points(&self) -> &[Vector3<f64>];

    /// Returns the surface between two states at a part of the straight line.
    fn between(&self, to: &Self, part: f64) -> Self;

    /// Returns the largest radius of the surface, half the thickness, less the smallest one of its shell.
    fn largest_excess(&self) -> f64;

    /// Returns the distance of a point relative to the sum of the radii. `radius` is that of the point and the smallest one of the shell.
    fn relative_distance(&self, point: &Vector3<f64>, radius: f64) -> f64;
}

/// Returns the box around a surface, enlarged by a part of the largest sum of the radii. `radius` is the sum with the smallest one of the
/// shell.
pub(super) fn hull<S: TargetSurface>(surface: &S, part: f64, radius: f64) -> AlignedBox {
    AlignedBox::around(surface.hull_points(), part * (radius + surface.largest_excess()))
}
