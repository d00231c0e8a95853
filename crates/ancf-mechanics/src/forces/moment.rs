use ancf_solver::equations::{Local, LocalMatrix, Power, Term, Weights, supplied};
use nalgebra::{SVector, Vector3, Vector6};

use crate::functions::Function;
use crate::kinematics::{Marker, Real, add_symmetric, components, constant, turned, visit_skew};

/// Moment on a section, as a couple of forces on its directors d = r_y and e = r_z.
///
/// With n = d × e/A, A = |d × e|:
///
/// f_d = −(m·e)/A n + ½ (m·n) n × d/(d·d),  f_e = (m·d)/A n + ½ (m·n) n × e/(e·e).
///
/// For any lengths and angle of d and e, d × f_d + e × f_e = m: a spin ω of the section has the power m·ω. The
/// component normal to n does work on the rotation of n. The component along n does work on the mean rotation of both
/// directors about n.
///
/// The moment is constant in the global frame, or as a follower in the section frame
/// ([`BeamMesh::section_frame`](crate::bodies::BeamMesh::section_frame)). In plane rotation, the constant moment has
/// the potential −Mθ. In space neither moment has a potential (Ziegler 1968). The derivative is not symmetric, and the
/// tangent contains its symmetric part. Newton's method then converges linearly, at a rate proportional to the moment.
/// The work counts as supplied work.
#[derive(Clone, Debug)]
pub struct Moment {
    directors: [Marker; 2],
    coordinates: Vec<usize>,
    direction: MomentFrame,
    function: Function,
}

/// Frame in which a moment is constant.
#[derive(Clone, Copy, Debug)]
enum MomentFrame {
    Global(Vector3<f64>),
    Section(Vector3<f64>),
}

impl Moment {
    /// Creates a moment, times a function of time, on the directors r_y and r_z.
    pub fn new(directors: [&Marker; 2], moment: Vector3<f64>, function: Function) -> Self {
        let coordinates = Marker::union_coordinates(directors);
        let directors = directors.map(|director| director.within(&coordinates));
        Self { directors, coordinates, direction: MomentFrame::Global(moment), function }
    }

    /// Creates a follower moment with the value `moment` in the reference state.
    pub fn follower(directors: [&Marker; 2], moment: Vector3<f64>, function: Function) -> Self {
        let [d, e] = directors.map(Marker::reference);
        let direction = MomentFrame::Section(components(d, e, &moment));
        Self { direction, ..Self::new(directors, moment, function) }
    }

    /// Creates a follower moment with the given components in the section frame, times a function of time.
    pub fn in_section(directors: [&Marker; 2], components: Vector3<f64>, function: Function) -> Self {
        let direction = MomentFrame::Section(components);
        Self { direction, ..Self::new(directors, Vector3::zeros(), function) }
    }

    /// Returns d and e.
    fn values(&self, q: &[f64]) -> Vector6<f64> {
        let [d, e] = self.directors.each_ref().map(|director| director.reference() + director.sum(q));
        Vector6::new(d.x, d.y, d.z, e.x, e.y, e.z)
    }

    /// Computes f_d and f_e at d and e.
    fn forces<D: Real>(&self, x: &SVector<D, 6>) -> SVector<D, 6> {
        let (d, e) = (x.fixed_rows::<3>(0).into_owned(), x.fixed_rows::<3>(3).into_owned());
        let m = match self.direction {
            MomentFrame::Global(moment) => constant(&moment),
            MomentFrame::Section(components) => turned(d, e, &components),
        };
        let c = d.cross(&e);
        let square = c.dot(&c);
        let (transverse, along) = ([-(m.dot(&e) / square), m.dot(&d) / square], m.dot(&c) * 0.5 / square);
        let force = |transverse: D, x: &Vector3<D>| {
            let drill = along / x.dot(x);
            c.map(|c| c * transverse) + c.cross(x).map(|y| y * drill)
        };
        let (fd, fe) = (force(transverse[0], &d), force(transverse[1], &e));
        SVector::from([fd.x, fd.y, fd.z, fe.x, fe.y, fe.z])
    }

    fn factor(&self, at: &Local<'_>) -> f64 {
        at.load * self.function.value(at.t)
    }
}

impl Term for Moment {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let forces = self.forces(&self.values(at.q)) * -self.factor(at);
        for (i, director) in self.directors.iter().enumerate() {
            director.add(forces.fixed_rows::<3>(3 * i).into_owned(), r);
        }
    }

    /// The forces are of degree −1 in the directors, whose relative error is that of their parts. Skew directors
    /// amplify it.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let x = self.values(at.q);
        let [d, e] = [0, 3].map(|i| x.fixed_rows::<3>(i).into_owned());
        let (ld, le) = (d.norm(), e.norm());
        let skew = ld * le / d.cross(&e).norm();
        let (MomentFrame::Global(moment) | MomentFrame::Section(moment)) = self.direction;
        let error = self.directors[0].size(at.q) / ld + self.directors[1].size(at.q) / le;
        let bound = 4.0 * f64::EPSILON * (self.factor(at) * moment.norm()).abs() * skew.powi(2) * error;
        for (director, length) in self.directors.iter().zip([ld, le]) {
            for &(first, w) in director.parts() {
                for row in &mut floor[first..first + 3] {
                    *row += bound * w.abs() / length;
                }
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (_, h) = num_dual::jacobian(|x| self.forces(&x), &self.values(at.q));
        add_symmetric(&self.directors.each_ref(), &h, -w.q * self.factor(at), k);
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let (_, h) = num_dual::jacobian(|x| self.forces(&x), &self.values(at.q));
        visit_skew(&self.directors.each_ref(), &h, -self.factor(at), visit);
    }

    fn power(&self, at: &Local<'_>) -> Power {
        supplied(self, at)
    }
}
