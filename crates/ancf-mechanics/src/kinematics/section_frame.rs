//! Rotation of a cross-section: one definition for joints, loads and results.

use nalgebra::{Matrix2, Matrix3, SMatrix, Vector3, Vector6};

use super::marker::Marker;

/// Frame of a cross-section as a function of its directors d = r_y and e = r_z.
///
/// With weights w_y + w_z = 1:
///
/// c = d × e, J = |c|, x = c/J; p = w_y d + w_z e × x, t = |p|, y = p/t, z = x × y.
///
/// x is the normal of the section, not the tangent of the axis. In the plane of the section w_y z·d = w_z y·e. A moment
/// on this frame loads r_y and r_z by the shares of the stresses of bending and torsion, and r_x not at all. Any other
/// share adds self-equilibrated couples at one node, against which the element has little stiffness.
///
/// The weights are ½ for a rod law. For a continuum they are I_y/(I_y + I_z) and I_z/(I_y + I_z), I_y = ∫ y² dA.
/// Directors that are not orthonormal in the reference state are replaced by combinations that are.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionFrame {
    directors: [Marker; 2],
    weights: [f64; 2],
    /// x, y and z in the reference state.
    axes: [Vector3<f64>; 3],
}

/// Deviation from orthonormal directors that counts as rounding.
const ORTHONORMAL: f64 = 1e-12;

impl SectionFrame {
    /// Creates the frame of the directors r_y and r_z with the weight w_y of r_y.
    pub fn new([d, e]: [&Marker; 2], weight: f64) -> Self {
        let weights = [weight, 1.0 - weight];
        let (d0, e0) = (d.reference(), e.reference());
        let [_, y, z] = FrameValues::axes(d0, e0, weights);
        let shape = Matrix2::new(y.dot(&d0), y.dot(&e0), z.dot(&d0), z.dot(&e0));
        let regular = (shape - Matrix2::identity()).amax() < ORTHONORMAL;
        let directors = match shape.try_inverse().filter(|_| !regular) {
            Some(inverse) => [0, 1].map(|k| Marker::combined([(inverse[(0, k)], d), (inverse[(1, k)], e)])),
            None => [d.clone(), e.clone()],
        };
        let [d0, e0] = directors.each_ref().map(Marker::reference);
        Self { directors, weights, axes: FrameValues::axes(d0, e0, weights) }
    }

    /// Returns the directors, orthonormal in the reference state.
    pub fn directors(&self) -> &[Marker; 2] {
        &self.directors
    }

    /// Returns w_y and w_z.
    pub const fn weights(&self) -> [f64; 2] {
        self.weights
    }

    /// Returns x, y and z in the reference state.
    pub const fn reference(&self) -> &[Vector3<f64>; 3] {
        &self.axes
    }

    /// Returns all coordinates of the directors.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> {
        self.directors.iter().flat_map(Marker::coordinates)
    }

    /// Renumbers the coordinates for a term with the given coordinate list.
    pub(crate) fn within(&self, coordinates: &[usize]) -> Self {
        Self { directors: self.directors.each_ref().map(|d| d.within(coordinates)), ..self.clone() }
    }

    /// Returns the rates of d and e for rates of the coordinates.
    pub fn rates(&self, x: &[f64]) -> [Vector3<f64>; 2] {
        self.directors.each_ref().map(|director| director.sum(x))
    }

    /// Evaluates the frame.
    pub fn at(&self, q: &[f64]) -> FrameValues {
        FrameValues::new(self, q)
    }

    /// Adds forces on d and e to the rows of the coordinates.
    pub(crate) fn add(&self, [d, e]: [Vector3<f64>; 2], rows: &mut [f64]) {
        self.directors[0].add(d, rows);
        self.directors[1].add(e, rows);
    }

    /// Returns the vector with the given components along x, y and z in the reference state.
    pub fn composed(&self, components: &Vector3<f64>) -> Vector3<f64> {
        (0..3).map(|k| self.axes[k] * components[k]).sum()
    }

    /// Adds bounds of the rounding errors of the forces of a moment of size `moment` with the error `error`.
    pub(crate) fn add_errors(&self, q: &[f64], moment: f64, error: f64, floor: &mut [f64]) {
        let [relative, _] = self.errors(q);
        let bound = self.at(q).magnification() * (error + 4.0 * (f64::EPSILON + relative) * moment);
        for (first, w) in self.directors.iter().flat_map(|director| director.parts()) {
            floor[*first..first + 3].iter_mut().for_each(|row| *row += bound * w.abs());
        }
    }

    /// Returns a bound of the relative rounding errors of the axes: in a state, and of their changes from the reference.
    pub(crate) fn errors(&self, q: &[f64]) -> [f64; 2] {
        let values = self.at(q);
        let [d, e] = &self.directors;
        let amplified = |of_d: f64, of_e: f64| {
            let (ld, le) = (values.d.norm(), values.e.norm());
            let normal = (of_d * le + of_e * ld) / values.area;
            let plane = (self.weights[0] * of_d + self.weights[1] * of_e) / values.length;
            4.0 * f64::EPSILON * (plane + normal * (1.0 + le / values.length))
        };
        [amplified(d.size(q), e.size(q)), amplified(d.sum_of_sizes(q), e.sum_of_sizes(q))]
    }
}

/// Frame of a section in a state, with its derivatives by d and e.
#[derive(Clone, Copy, Debug)]
pub struct FrameValues {
    d: Vector3<f64>,
    e: Vector3<f64>,
    weights: [f64; 2],
    /// J and t.
    area: f64,
    length: f64,
    reference: [Vector3<f64>; 3],
    /// Changes of x, y and z from the reference state.
    changes: [Vector3<f64>; 3],
    /// x, y and z.
    pub axes: [Vector3<f64>; 3],
}

impl FrameValues {
    /// Computes x, y and z of the directors d and e.
    pub(crate) fn axes(d: Vector3<f64>, e: Vector3<f64>, [w_y, w_z]: [f64; 2]) -> [Vector3<f64>; 3] {
        let x = d.cross(&e).normalize();
        let y = (d * w_y + e.cross(&x) * w_z).normalize();
        [x, y, x.cross(&y)]
    }

    /// Evaluates the frame by its changes from the reference state, without cancellation.
    fn new(frame: &SectionFrame, q: &[f64]) -> Self {
        let [w_y, w_z] = frame.weights;
        let ([d0, e0], [u, v]) = (frame.directors.each_ref().map(Marker::reference), frame.rates(q));
        let (d, e, [x0, y0, _]) = (d0 + u, e0 + v, frame.axes);
        let normalised = |a0: Vector3<f64>, unit: Vector3<f64>, change: Vector3<f64>| {
            let (before, length) = (a0.norm(), (a0 + change).norm());
            let stretch = (2.0 * a0.dot(&change) + change.dot(&change)) / (length + before);
            (length, (change - unit * stretch) / length)
        };
        let (area, of_x) = normalised(d0.cross(&e0), x0, u.cross(&e0) + d0.cross(&v) + u.cross(&v));
        let x = x0 + of_x;
        let p0 = d0 * w_y + e0.cross(&x0) * w_z;
        let (length, of_y) = normalised(p0, y0, u * w_y + (v.cross(&x) + e0.cross(&of_x)) * w_z);
        let y = y0 + of_y;
        let of_z = of_x.cross(&y) + x0.cross(&of_y);
        let axes = [x, y, frame.axes[2] + of_z];
        let (weights, changes) = (frame.weights, [of_x, of_y, of_z]);
        Self { d, e, weights, area, length, reference: frame.axes, changes, axes }
    }

    fn combined(&self, of: &[Vector3<f64>; 3], reference: &Vector3<f64>) -> Vector3<f64> {
        (0..3).map(|k| of[k] * self.reference[k].dot(reference)).sum()
    }

    /// Returns R X for a vector of the reference state.
    pub fn turned(&self, reference: &Vector3<f64>) -> Vector3<f64> {
        self.combined(&self.axes, reference)
    }

    /// Returns R X − X without cancellation.
    pub fn change(&self, reference: &Vector3<f64>) -> Vector3<f64> {
        self.combined(&self.changes, reference)
    }

    /// Returns the rotation R from the reference state.
    pub fn rotation(&self) -> Matrix3<f64> {
        Matrix3::from_columns(&self.axes) * Matrix3::from_columns(&self.reference).transpose()
    }

    /// Returns the angular velocity ω = T (ḋ, ė).
    pub fn spin(&self, [d, e]: [Vector3<f64>; 2]) -> Vector3<f64> {
        let ([x, y, z], [w_y, w_z]) = (self.axes, self.weights);
        (self.d * x.dot(&e) - self.e * x.dot(&d)) / self.area
            + x * ((w_y * z.dot(&d) - w_z * y.dot(&e)) / self.length)
    }

    /// Returns dω/dt for constant rates of d and e.
    pub fn spin_rate(&self, rates: [Vector3<f64>; 2]) -> Vector3<f64> {
        let ([x, y, z], [w_y, w_z], [d, e]) = (self.axes, self.weights, rates);
        let spin = self.spin(rates);
        let [dx, dy, dz] = self.axes.map(|axis| spin.cross(&axis));
        let [area, length] = self.stretches(rates);
        let along = (w_y * z.dot(&d) - w_z * y.dot(&e)) / self.length;
        let of_along = (w_y * dz.dot(&d) - w_z * dy.dot(&e)) / self.length - along * length / self.length;
        let transverse = d * x.dot(&e) - e * x.dot(&d) + self.d * dx.dot(&e)
            - self.e * dx.dot(&d)
            - (self.d * x.dot(&e) - self.e * x.dot(&d)) * (area / self.area);
        transverse / self.area + dx * along + x * of_along
    }

    /// Returns the rates of J and t.
    fn stretches(&self, [d, e]: [Vector3<f64>; 2]) -> [f64; 2] {
        let ([x, y, z], [w_y, w_z]) = (self.axes, self.weights);
        [x.dot(&(d.cross(&self.e) + self.d.cross(&e))), w_y * y.dot(&d) + w_z * z.dot(&e)]
    }

    /// Returns T as the blocks of d and e.
    pub fn variation(&self) -> [Matrix3<f64>; 2] {
        let ([x, y, z], [w_y, w_z]) = (self.axes, self.weights);
        [
            -self.e * x.transpose() / self.area + x * z.transpose() * (w_y / self.length),
            self.d * x.transpose() / self.area - x * y.transpose() * (w_z / self.length),
        ]
    }

    /// Returns the forces Tᵀ M on d and e of a moment M on the section.
    pub fn forces(&self, moment: &Vector3<f64>) -> [Vector3<f64>; 2] {
        let ([x, y, z], [w_y, w_z]) = (self.axes, self.weights);
        let along = x.dot(moment) / self.length;
        [
            z * (w_y * along) - x * (self.e.dot(moment) / self.area),
            x * (self.d.dot(moment) / self.area) - y * (w_z * along),
        ]
    }

    /// Returns the variation S(M) (δd, δe) of the forces of a constant moment.
    pub fn force_variation(&self, moment: &Vector3<f64>, [d, e]: [Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
        let ([x, y, z], [w_y, w_z]) = (self.axes, self.weights);
        let turn = self.spin([d, e]);
        let [dx, dy, dz] = self.axes.map(|axis| turn.cross(&axis));
        let [area, length] = self.stretches([d, e]);
        let transverse = |own: &Vector3<f64>, change: &Vector3<f64>| {
            let part = own.dot(moment) / self.area;
            dx * part + x * (change.dot(moment) / self.area - part * area / self.area)
        };
        let along = x.dot(moment) / self.length;
        let of_along = dx.dot(moment) / self.length - along * length / self.length;
        [
            (dz * along + z * of_along) * w_y - transverse(&self.e, &e),
            transverse(&self.d, &d) - (dy * along + y * of_along) * w_z,
        ]
    }

    /// Returns S(M): the derivative of the forces of a constant moment by d and e.
    pub fn second_variation(&self, moment: &Vector3<f64>) -> SMatrix<f64, 6, 6> {
        let mut s = SMatrix::<f64, 6, 6>::zeros();
        for k in 0..6 {
            let unit = Vector6::from_fn(|i, _| if i == k { 1.0 } else { 0.0 });
            let rates = [0, 3].map(|i| unit.fixed_rows::<3>(i).into_owned());
            let [d, e] = self.force_variation(moment, rates);
            s.fixed_view_mut::<3, 1>(0, k).copy_from(&d);
            s.fixed_view_mut::<3, 1>(3, k).copy_from(&e);
        }
        s
    }

    /// Returns the second derivative f·∂²(R X)/∂(d, e)² for a vector X of the section and a constant f: with a = R X,
    /// Tᵀ [f]× [a]× T + S(a × f).
    pub(crate) fn curvature(&self, reference: &Vector3<f64>, f: &Vector3<f64>) -> SMatrix<f64, 6, 6> {
        let a = self.turned(reference);
        let t = self.variation_matrix();
        let turning = f.cross_matrix() * a.cross_matrix();
        t.transpose() * turning * t + self.second_variation(&a.cross(f))
    }

    /// Returns Tᵀ [M]× T.
    pub(crate) fn turning(&self, moment: &Vector3<f64>) -> SMatrix<f64, 6, 6> {
        let t = self.variation_matrix();
        t.transpose() * moment.cross_matrix() * t
    }

    /// Returns T by d and e.
    fn variation_matrix(&self) -> SMatrix<f64, 3, 6> {
        let [of_d, of_e] = self.variation();
        let mut t = SMatrix::<f64, 3, 6>::zeros();
        t.fixed_view_mut::<3, 3>(0, 0).copy_from(&of_d);
        t.fixed_view_mut::<3, 3>(0, 3).copy_from(&of_e);
        t
    }

    /// Returns a bound of the magnification of a moment to forces on d and e: 1/J-weighted arms and 1/t.
    pub(crate) fn magnification(&self) -> f64 {
        self.d.norm().max(self.e.norm()) / self.area + 1.0 / self.length
    }
}
