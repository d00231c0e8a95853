use ancf_solver::equations::{Local, LocalMatrix, Power, Term, Weights, supplied};
use nalgebra::{SMatrix, SVector, Vector3, Vector6};

use crate::functions::Function;
use crate::kinematics::{Marker, Real, add_symmetric, components, turned, visit_skew};

/// Follower force on a point, with constant direction in the section frame and a magnitude scaled by f(t).
///
/// The frame is that of [`BeamMesh::section_frame`](crate::bodies::BeamMesh::section_frame). The force has no
/// potential. The derivative is not symmetric, and the tangent contains its symmetric part, as for a
/// [`Moment`](super::moment::Moment).
#[derive(Clone, Debug)]
pub struct FollowerForce {
    /// Point, and directors r_y and r_z.
    markers: [Marker; 3],
    coordinates: Vec<usize>,
    components: Vector3<f64>,
    function: Function,
}

impl FollowerForce {
    /// Creates the follower force with the value `force` in the reference state, times a function of time.
    pub fn new(point: &Marker, directors: [&Marker; 2], force: Vector3<f64>, function: Function) -> Self {
        let [d, e] = directors;
        let markers = [point, d, e];
        let coordinates = Marker::union_coordinates(markers);
        let components = components(d.reference(), e.reference(), &force);
        Self { markers: markers.map(|marker| marker.within(&coordinates)), coordinates, components, function }
    }

    /// Creates the follower force with the given components in the section frame, times a function of time.
    pub fn in_section(
        point: &Marker,
        directors: [&Marker; 2],
        components: Vector3<f64>,
        function: Function,
    ) -> Self {
        Self { components, ..Self::new(point, directors, Vector3::zeros(), function) }
    }

    /// Returns d and e.
    fn values(&self, q: &[f64]) -> Vector6<f64> {
        let value = |marker: &Marker| marker.reference() + marker.sum(q);
        let (d, e) = (value(&self.markers[1]), value(&self.markers[2]));
        Vector6::new(d.x, d.y, d.z, e.x, e.y, e.z)
    }

    /// Returns the force at d and e.
    fn force<D: Real>(&self, x: &SVector<D, 6>) -> Vector3<D> {
        turned(x.fixed_rows::<3>(0).into_owned(), x.fixed_rows::<3>(3).into_owned(), &self.components)
    }

    /// Returns the derivative of the force on the point by the three markers.
    fn slope(&self, at: &Local<'_>) -> SMatrix<f64, 9, 9> {
        let (_, slope) = num_dual::jacobian(|x| self.force(&x), &self.values(at.q));
        let mut h = SMatrix::<f64, 9, 9>::zeros();
        h.fixed_view_mut::<3, 6>(0, 3).copy_from(&slope);
        h
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
        self.markers[0].add(self.force(&self.values(at.q)) * -self.factor(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let x = self.values(at.q);
        let [d, e] = [0, 3].map(|i| x.fixed_rows::<3>(i).into_owned());
        let (ld, le) = (d.norm(), e.norm());
        let skew = ld * le / d.cross(&e).norm();
        let error = self.markers[1].size(at.q) / ld + self.markers[2].size(at.q) / le;
        let bound =
            4.0 * f64::EPSILON * (self.factor(at) * self.components.norm()).abs() * skew.powi(2) * error;
        for &(first, w) in self.markers[0].parts() {
            for row in &mut floor[first..first + 3] {
                *row += bound * w.abs();
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        add_symmetric(&self.markers.each_ref(), &self.slope(at), -w.q * self.factor(at), k);
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        visit_skew(&self.markers.each_ref(), &self.slope(at), -self.factor(at), visit);
    }

    fn power(&self, at: &Local<'_>) -> Power {
        supplied(self, at)
    }
}
