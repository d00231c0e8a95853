use ancf_solver::equations::{Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::{Matrix3, Vector3};

use crate::functions::Function;
use crate::kinematics::BodyVector;

/// Follower force on a point: a vector of the body, with a magnitude scaled by f(t).
///
/// On a section the vector is constant in the [`SectionFrame`](crate::kinematics::SectionFrame). The force has no
/// potential. The derivative is not symmetric, and the tangent contains its symmetric part, as for a
/// [`Moment`](super::moment::Moment).
#[derive(Clone, Debug)]
pub struct FollowerForce {
    point: BodyVector,
    force: BodyVector,
    coordinates: Vec<usize>,
    function: Function,
}

impl FollowerForce {
    /// Creates the follower force on a point, times a function of time.
    pub fn new(point: impl Into<BodyVector>, force: impl Into<BodyVector>, function: Function) -> Self {
        let (point, force) = (point.into(), force.into());
        let coordinates = BodyVector::union_coordinates([&point, &force]);
        let (point, force) = (point.within(&coordinates), force.within(&coordinates));
        Self { point, force, coordinates, function }
    }

    /// Returns the force without the factor.
    fn force(&self, at: &Local<'_>) -> Vector3<f64> {
        self.force.at(at.q)
    }

    fn factor(&self, at: &Local<'_>) -> f64 {
        at.load * self.function.value(at.t)
    }
}

impl Term for FollowerForce {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.point.add(at.q, self.force(at) * -self.factor(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let factor = self.factor(at).abs();
        let [error, _] = self.force.errors(at.q);
        self.point.add_errors(at.q, factor * self.force.size(at.q), factor * error, floor);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let factor = -w.q * self.factor(at);
        self.point.add_product(&self.force, at.q, 0.5 * factor, k);
        if !self.point.is_linear() {
            self.point.add_curvature(at.q, self.force(at) * factor, k);
        }
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let h = Matrix3::from_diagonal_element(-self.factor(at));
        self.point.visit_skew(&self.force, at.q, &h, visit);
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        load_power(self, at)
    }

    fn is_damped(&self) -> bool {
        false
    }
}
