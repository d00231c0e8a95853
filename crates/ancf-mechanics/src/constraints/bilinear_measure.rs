use ancf_solver::equations::{LOCAL, LocalMatrix, State};
use nalgebra::Vector3;

use super::bilinear_row::BilinearRow;
use super::wrench::Wrench;
use crate::kinematics::BodyVector;

/// Magnitude of a joint coordinate, in radians or in the unit of length of the solver, below which its rounding error is that of the
/// positions.
const COORDINATE: f64 = 0.1;

/// Scalar g(q) = Σ cᵢ aᵢ·bᵢ + Σ cⱼ qⱼ, bilinear in vectors of bodies and coordinates, used by constraints and springs.
///
/// Angles of directions, distances of points along directions, squared distances, joint coordinates and their sums have
/// this form. Of markers it is at most quadratic in q: the gradient is linear and the second derivative H constant. Vectors
/// in the frame of a section add their own second derivative. Changes g − g₀ from the reference state are evaluated
/// without cancellation.
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
    vectors: [BodyVector; 2],
    roles: [MarkerMotion; 2],
}

/// Effect of the first body of a joint on a vector.
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
    Point(&'a BodyVector),
    /// Direction of the first body. It rotates with the body.
    Direction(&'a BodyVector),
    /// Point or direction of the other body or of the ground.
    Other(&'a BodyVector),
}

impl<'a> MeasureFactor<'a> {
    const fn parts(self) -> (&'a BodyVector, MarkerMotion) {
        match self {
            Self::Point(vector) => (vector, MarkerMotion::Translates),
            Self::Direction(vector) => (vector, MarkerMotion::Rotates),
            Self::Other(vector) => (vector, MarkerMotion::Fixed),
        }
    }
}

impl BilinearMeasure {
    /// Creates a sum of products c a·b.
    pub fn new<'a>(products: impl IntoIterator<Item = (f64, MeasureFactor<'a>, MeasureFactor<'a>)>) -> Self {
        let product = |(factor, a, b): (f64, MeasureFactor<'a>, MeasureFactor<'a>)| {
            let ((a, first), (b, second)) = (a.parts(), b.parts());
            Product { factor, vectors: [a.clone(), b.clone()], roles: [first, second] }
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
        let vectors = self.products.iter().flat_map(|product| &product.vectors);
        let mut all: Vec<usize> = vectors.flat_map(BodyVector::coordinates).collect();
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
            vectors: product.vectors.each_ref().map(|vector| vector.within(coordinates)),
            ..*product
        };
        Self {
            products: self.products.iter().map(product).collect(),
            coordinates: self.coordinates.iter().map(|(c, factor)| (local(c), *factor)).collect(),
        }
    }

    /// Returns true if the measure is at most quadratic in the coordinates.
    pub(crate) fn is_quadratic(&self) -> bool {
        self.products.iter().all(Product::is_quadratic)
    }

    /// Returns the equation g(q) − g₀ = 0 as a row, if the measure is at most quadratic.
    pub(super) fn row(&self) -> Option<BilinearRow> {
        let product = |p: &Product| {
            let [a, b] = p.vectors.each_ref().map(BodyVector::marker);
            Some((p.factor, [a?.clone(), b?.clone()]))
        };
        let products = self.products.iter().map(product).collect::<Option<_>>()?;
        Some(BilinearRow { products, linear: self.coordinates.clone(), offset: [0.0; 2] })
    }

    /// Returns the reference value g₀.
    pub fn reference(&self) -> f64 {
        let of = |p: &Product| p.factor * p.vectors[0].reference().dot(&p.vectors[1].reference());
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
            let [a, b] = &p.vectors;
            let (ua, ub) = (a.change(q), b.change(q));
            p.factor * (a.reference().dot(&ub) + ua.dot(&b.reference()) + ua.dot(&ub))
        };
        self.products.iter().map(of).sum::<f64>()
            + self.coordinates.iter().map(|&(c, k)| k * q[c]).sum::<f64>()
    }

    /// Returns the derivative along x: ∂g/∂q·x.
    pub(crate) fn slope(&self, q: &[f64], x: &[f64]) -> f64 {
        let of = |p: &Product| {
            let ([a, b], [u, v]) = (p.values(q), p.rates(q, x));
            p.factor * (u.dot(&b) + a.dot(&v))
        };
        self.products.iter().map(of).sum::<f64>()
            + self.coordinates.iter().map(|&(c, k)| k * x[c]).sum::<f64>()
    }

    /// Returns the second derivative along x: x·H x.
    pub(crate) fn second_slope(&self, q: &[f64], x: &[f64]) -> f64 {
        let of = |p: &Product| {
            let ([a, b], [u, v]) = (p.values(q), p.rates(q, x));
            let [of_a, of_b] = p.vectors.each_ref().map(|vector| vector.rate_slope(q, x));
            p.factor * (of_a.dot(&b) + 2.0 * u.dot(&v) + a.dot(&of_b))
        };
        self.products.iter().map(of).sum()
    }

    /// Adds f ∂g/∂q.
    pub(crate) fn add_gradient(&self, q: &[f64], f: f64, rows: &mut [f64]) {
        for p in &self.products {
            let ([a, b], f) = (p.values(q), f * p.factor);
            p.vectors[0].add(q, b * f, rows);
            p.vectors[1].add(q, a * f, rows);
        }
        self.coordinates.iter().for_each(|&(c, k)| rows[c] += f * k);
    }

    /// Adds f H x, the derivative of f ∂g/∂q along x.
    pub(crate) fn add_gradient_slope(&self, q: &[f64], x: &[f64], f: f64, rows: &mut [f64]) {
        for p in &self.products {
            let ([a, b], [u, v], f) = (p.values(q), p.rates(q, x), f * p.factor);
            p.vectors[0].add(q, v * f, rows);
            p.vectors[1].add(q, u * f, rows);
            p.vectors[0].add_slope(q, x, b * f, rows);
            p.vectors[1].add_slope(q, x, a * f, rows);
        }
    }

    /// Adds f H to a matrix.
    pub(crate) fn add_curvature(&self, q: &[f64], f: f64, k: &mut LocalMatrix<'_>) {
        for p in &self.products {
            let [a, b] = &p.vectors;
            a.add_product(b, q, f * p.factor, k);
            if !p.is_quadratic() {
                let values = p.values(q);
                a.add_curvature(q, values[1] * (f * p.factor), k);
                b.add_curvature(q, values[0] * (f * p.factor), k);
            }
        }
    }

    /// Adds a bound of the rounding error of f ∂g/∂q. Returns the bound for g − g₀.
    pub(crate) fn add_rounding(&self, q: &[f64], f: f64, floor: &mut [f64]) -> f64 {
        let mut of_change = 0.0;
        for p in &self.products {
            let sizes = p.vectors.each_ref().map(|vector| vector.size(q) * p.factor.abs());
            let errors = p.vectors.each_ref().map(|vector| vector.errors(q).map(|x| x * p.factor.abs()));
            for (i, vector) in p.vectors.iter().enumerate() {
                let (other, [of_other, _]) = (sizes[1 - i], errors[1 - i]);
                let Some(marker) = vector.marker() else {
                    vector.add_errors(q, other * f.abs(), of_other * f.abs(), floor);
                    of_change += errors[i][1] / p.factor.abs() * other;
                    continue;
                };
                let other = other.max(of_other / f64::EPSILON);
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
            // The coordinate has the error of the equation that defines it, also near zero.
            of_change += f64::EPSILON * k.abs() * q[c].abs().max(COORDINATE);
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
    fn is_quadratic(&self) -> bool {
        self.vectors.iter().all(BodyVector::is_linear)
    }

    /// Returns a and b.
    fn values(&self, q: &[f64]) -> [Vector3<f64>; 2] {
        self.vectors.each_ref().map(|vector| vector.at(q))
    }

    /// Returns the derivatives of a and b along x.
    fn rates(&self, q: &[f64], x: &[f64]) -> [Vector3<f64>; 2] {
        self.vectors.each_ref().map(|vector| vector.rate(q, x))
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
