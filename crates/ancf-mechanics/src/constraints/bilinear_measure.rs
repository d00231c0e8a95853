use ancf_solver::equations::{LOCAL, LocalMatrix, State};
use nalgebra::{Matrix3, Vector3};

use super::coincidence::Wrench;
use crate::kinematics::Marker;

/// Bilinear scalar g(q) = Σ cᵢ aᵢ·bᵢ + Σ cⱼ qⱼ of markers and coordinates, used by constraints and springs.
///
/// Angles of directions, distances of points along directions, squared distances, joint coordinates and their sums have
/// this form. It is at most quadratic in q: the gradient is linear and the second derivative H constant. Changes g − g₀
/// from the reference state are evaluated without cancellation.
#[derive(Clone, Debug, Default)]
pub struct BilinearMeasure {
    products: Vec<Product>,
    /// Coordinate and factor.
    coordinates: Vec<(usize, f64)>,
}

/// Product c a·b.
#[derive(Clone, Debug)]
struct Product {
    factor: f64,
    markers: [Marker; 2],
    roles: [MarkerMotion; 2],
}

/// Effect of the first body of a joint on a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum MarkerMotion {
    Translates,
    Rotates,
    Fixed,
}

/// Factor of a product, with its relation to the first body of a joint.
#[derive(Clone, Copy, Debug)]
pub enum MeasureFactor<'a> {
    /// Point of the first body relative to another point. It moves with the first point.
    Point(&'a Marker),
    /// Direction of the first body. It rotates with the body.
    Direction(&'a Marker),
    /// Point or direction of the other body or of the ground.
    Other(&'a Marker),
}

impl<'a> MeasureFactor<'a> {
    const fn parts(self) -> (&'a Marker, MarkerMotion) {
        match self {
            Self::Point(marker) => (marker, MarkerMotion::Translates),
            Self::Direction(marker) => (marker, MarkerMotion::Rotates),
            Self::Other(marker) => (marker, MarkerMotion::Fixed),
        }
    }
}

impl BilinearMeasure {
    /// Creates a sum of products c a·b.
    pub fn new<'a>(products: impl IntoIterator<Item = (f64, MeasureFactor<'a>, MeasureFactor<'a>)>) -> Self {
        let product = |(factor, a, b): (f64, MeasureFactor<'a>, MeasureFactor<'a>)| {
            let ((a, first), (b, second)) = (a.parts(), b.parts());
            Product { factor, markers: [a.clone(), b.clone()], roles: [first, second] }
        };
        Self { products: products.into_iter().map(product).collect(), coordinates: Vec::new() }
    }

    /// Creates the measure of a single coordinate.
    pub fn coordinate(coordinate: usize) -> Self {
        Self::default().plus(coordinate, 1.0)
    }

    /// Adds a coordinate times a factor.
    #[must_use]
    pub fn plus(mut self, coordinate: usize, factor: f64) -> Self {
        self.coordinates.push((coordinate, factor));
        self
    }

    /// Returns the sorted coordinates without repetition.
    pub fn coordinates(&self) -> Vec<usize> {
        let markers = self.products.iter().flat_map(|product| &product.markers);
        let mut all: Vec<usize> = markers.flat_map(Marker::coordinates).collect();
        all.extend(self.coordinates.iter().map(|(coordinate, _)| coordinate));
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Renumbers the coordinates for a term with the given coordinate list.
    pub(crate) fn within(&self, coordinates: &[usize]) -> Self {
        let local = |c: &usize| {
            coordinates
                .iter()
                .position(|other| other == c)
                .expect("the coordinate list contains all coordinates")
        };
        let product = |product: &Product| Product {
            markers: product.markers.each_ref().map(|marker| marker.within(coordinates)),
            ..*product
        };
        Self {
            products: self.products.iter().map(product).collect(),
            coordinates: self.coordinates.iter().map(|(c, factor)| (local(c), *factor)).collect(),
        }
    }

    /// Returns the reference value g₀.
    pub fn reference(&self) -> f64 {
        let of = |p: &Product| p.factor * p.markers[0].reference().dot(&p.markers[1].reference());
        self.products.iter().map(of).sum()
    }

    /// Returns the value in a state.
    pub fn value(&self, s: &State) -> f64 {
        self.reference() + self.change(&s.q)
    }

    /// Returns the rate in a state.
    pub fn rate(&self, s: &State) -> f64 {
        self.slope(&s.q, &s.v)
    }

    /// Returns g − g₀.
    pub(crate) fn change(&self, q: &[f64]) -> f64 {
        let of = |p: &Product| {
            let [a, b] = &p.markers;
            let (ua, ub) = (a.sum(q), b.sum(q));
            p.factor * (a.reference().dot(&ub) + ua.dot(&b.reference()) + ua.dot(&ub))
        };
        self.products.iter().map(of).sum::<f64>()
            + self.coordinates.iter().map(|&(c, k)| k * q[c]).sum::<f64>()
    }

    /// Returns the derivative along x: ∂g/∂q·x.
    pub(crate) fn slope(&self, q: &[f64], x: &[f64]) -> f64 {
        let of = |p: &Product| {
            let ([a, b], [u, v]) = (p.values(q), p.markers.each_ref().map(|marker| marker.sum(x)));
            p.factor * (u.dot(&b) + a.dot(&v))
        };
        self.products.iter().map(of).sum::<f64>()
            + self.coordinates.iter().map(|&(c, k)| k * x[c]).sum::<f64>()
    }

    /// Adds f ∂g/∂q.
    pub(crate) fn add_gradient(&self, q: &[f64], f: f64, rows: &mut [f64]) {
        for p in &self.products {
            let ([a, b], f) = (p.values(q), f * p.factor);
            p.markers[0].add(b * f, rows);
            p.markers[1].add(a * f, rows);
        }
        self.coordinates.iter().for_each(|&(c, k)| rows[c] += f * k);
    }

    /// Adds f H x, the derivative of f ∂g/∂q along x.
    pub(crate) fn add_gradient_slope(&self, x: &[f64], f: f64, rows: &mut [f64]) {
        for p in &self.products {
            let ([u, v], f) = (p.markers.each_ref().map(|marker| marker.sum(x)), f * p.factor);
            p.markers[0].add(v * f, rows);
            p.markers[1].add(u * f, rows);
        }
    }

    /// Adds f H to a matrix.
    pub(crate) fn add_curvature(&self, f: f64, k: &mut LocalMatrix<'_>) {
        let mut add = |i: usize, j: usize, value: f64| {
            if i >= j {
                k.add(i, j, value);
            }
        };
        for p in &self.products {
            let (curvature, [a, b]) = (Matrix3::from_diagonal_element(f * p.factor), &p.markers);
            a.product(b, &curvature, &mut add);
            b.product(a, &curvature, &mut add);
        }
    }

    /// Adds a bound of the rounding error of f ∂g/∂q. Returns the bound for g − g₀.
    pub(crate) fn add_rounding(&self, q: &[f64], f: f64, floor: &mut [f64]) -> f64 {
        let mut of_change = 0.0;
        for p in &self.products {
            let sizes = p.markers.each_ref().map(|marker| marker.size(q) * p.factor.abs());
            for (marker, other) in p.markers.iter().zip([sizes[1], sizes[0]]) {
                for &(first, w) in marker.parts() {
                    for row in first..first + 3 {
                        floor[row] += f64::EPSILON * (w * f).abs() * other;
                        of_change += f64::EPSILON * (w * q[row]).abs() * other;
                    }
                }
            }
        }
        for &(c, k) in &self.coordinates {
            floor[c] += f64::EPSILON * (k * f).abs();
            of_change += f64::EPSILON * (k * q[c]).abs();
        }
        of_change
    }

    /// Returns force and moment on the first body, about its point, for a generalised force f: f ∂g/∂q on its markers.
    pub fn wrench(&self, s: &State, f: f64) -> Wrench {
        let mut wrench = Wrench::default();
        for p in &self.products {
            let [a, b] = p.values(&s.q);
            for (role, x, y) in [(p.roles[0], a, b), (p.roles[1], b, a)] {
                match role {
                    MarkerMotion::Translates => wrench.force += y * (f * p.factor),
                    MarkerMotion::Rotates => wrench.moment += x.cross(&y) * (f * p.factor),
                    MarkerMotion::Fixed => {}
                }
            }
        }
        wrench
    }
}

impl Product {
    /// Returns a and b.
    fn values(&self, q: &[f64]) -> [Vector3<f64>; 2] {
        self.markers.each_ref().map(|marker| marker.reference() + marker.sum(q))
    }
}

/// Adds f (x yᵀ + y xᵀ)/2 to a matrix.
pub(crate) fn add_outer(x: &[f64; LOCAL], y: &[f64; LOCAL], f: f64, n: usize, k: &mut LocalMatrix<'_>) {
    for j in 0..n {
        for i in j..n {
            k.add(i, j, 0.5 * f * (x[i] * y[j] + x[j] * y[i]));
        }
    }
}
