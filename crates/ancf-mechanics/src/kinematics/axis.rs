use std::ops::Range;

use nalgebra::Vector3;

use super::shape::{BeamShape, QuadraticShape};

/// Axis of one element as a curve r(s) = Σᵢ Nᵢ(s) rᵢ of the undeformed arc length s.
///
/// It provides r at variable positions for sliding joints and contact. A [`Marker`](super::marker::Marker) has a fixed
/// position.
#[derive(Clone, Debug)]
pub struct ElementAxis {
    /// First coordinate of each vector rᵢ, three or four of them.
    vectors: Vec<usize>,
    reference: Vec<Vector3<f64>>,
    shape: AxisInterpolation,
    start: f64,
}

#[derive(Clone, Copy, Debug)]
enum AxisInterpolation {
    Cubic(BeamShape),
    Quadratic(QuadraticShape),
}

impl ElementAxis {
    /// Creates an axis that starts at an arc length, from coordinates and reference values of its positions and slopes.
    ///
    /// Three vectors are interpolated by quadratic polynomials, and four by cubic polynomials.
    pub fn new(
        vectors: Vec<usize>,
        reference: Vec<Vector3<f64>>,
        [length, slope]: [f64; 2],
        start: f64,
    ) -> Self {
        let shape = match vectors.len() {
            3 => AxisInterpolation::Quadratic(QuadraticShape { length, slope }),
            _ => AxisInterpolation::Cubic(BeamShape { length, slope }),
        };
        Self { vectors, reference, shape, start }
    }

    /// Returns the arc lengths of the start and the end of the element.
    pub fn span(&self) -> Range<f64> {
        self.start..self.start + self.length()
    }

    /// Returns the length of the element.
    pub fn length(&self) -> f64 {
        match self.shape {
            AxisInterpolation::Cubic(shape) => shape.length,
            AxisInterpolation::Quadratic(shape) => shape.length,
        }
    }

    /// Returns the first coordinate of each vector.
    pub fn vectors(&self) -> &[usize] {
        &self.vectors
    }

    /// Returns all coordinates of the axis.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> {
        self.vectors.iter().flat_map(|&first| first..first + 3)
    }

    /// Renumbers the coordinates for a term with the given coordinate list.
    pub(crate) fn within(&self, coordinates: &[usize]) -> Self {
        let local = |first: &usize| {
            coordinates.iter().position(|c| c == first).expect("the coordinate list contains all coordinates")
        };
        Self { vectors: self.vectors.iter().map(local).collect(), ..self.clone() }
    }

    /// Returns the sum of magnitudes in vector i.
    pub(crate) fn size(&self, i: usize, q: &[f64]) -> f64 {
        self.reference[i].norm() + vector(q, self.vectors[i]).norm()
    }

    /// Returns the weights of the vectors in r, dr/ds and d²r/ds² at an arc length. The fourth of three vectors is 0.
    pub fn weights(&self, s: f64) -> [[f64; 4]; 3] {
        self.weights_at((s - self.start) / self.length())
    }

    /// Returns the weights of the vectors in r, dr/ds and d²r/ds² at ξ.
    pub(crate) fn weights_at(&self, xi: f64) -> [[f64; 4]; 3] {
        match self.shape {
            AxisInterpolation::Cubic(shape) => {
                [shape.axis(xi), shape.axis_gradient(xi), shape.axis_curvature(xi)]
            }
            AxisInterpolation::Quadratic(QuadraticShape { length: l, .. }) => {
                let four = |[a, b, c]: [f64; 3]| [a, b, c, 0.0];
                let curvature = [4.0, -8.0, 4.0].map(|weight| weight / (l * l));
                let slopes = QuadraticShape::slopes(xi).map(|weight| weight / l);
                [four(QuadraticShape::values(xi)), four(slopes), four(curvature)]
            }
        }
    }

    /// Returns the position of the start, given the coordinates q.
    pub(crate) fn start_point(&self, q: &[f64]) -> Vector3<f64> {
        self.reference[0] + vector(q, self.vectors[0])
    }

    /// Returns cₖ in r = c₀ + c₁ ξ + c₂ ξ² + c₃ ξ³ relative to an origin, given the coordinates q.
    pub(crate) fn polynomial(&self, q: &[f64], origin: &Vector3<f64>) -> [Vector3<f64>; 4] {
        let value = |i: usize| self.reference[i] + vector(q, self.vectors[i]);
        match self.shape {
            AxisInterpolation::Cubic(BeamShape { length, slope }) => {
                let (a, b) = (value(0) - origin, value(2) - origin);
                let (from, to) = (value(1) * (length / slope), value(3) * (length / slope));
                let chord = b - a;
                [a, from, (chord - from) * 3.0 + (from - to), from + to - chord * 2.0]
            }
            AxisInterpolation::Quadratic(_) => {
                let [a, b, c] = [0, 1, 2].map(|i| value(i) - origin);
                [a, (b - a) * 4.0 - (c - a), (a - b + (c - b)) * 2.0, Vector3::zeros()]
            }
        }
    }

    /// Returns r, dr/ds and d²r/ds² at an arc length, given the coordinates q.
    pub fn at(&self, q: &[f64], s: f64) -> [Vector3<f64>; 3] {
        let moved = |i: usize| self.reference[i] + vector(q, self.vectors[i]);
        self.weights(s).map(|weights| (0..self.vectors.len()).map(|i| moved(i) * weights[i]).sum())
    }

    /// Returns Σᵢ |Nᵢ| (|rᵢ⁰| + |qᵢ|) for r and dr/ds at ξ. ε times these bounds the rounding errors.
    pub(crate) fn sizes(&self, q: &[f64], xi: f64) -> [f64; 2] {
        let [values, slopes, _] = self.weights_at(xi);
        let sum =
            |weights: [f64; 4]| (0..self.vectors.len()).map(|i| weights[i].abs() * self.size(i, q)).sum();
        [values, slopes].map(sum)
    }

    /// Returns Σᵢ Nᵢ x[vᵢ..vᵢ+3] and its two derivatives by s, for a vector x such as the velocities.
    pub fn sum(&self, x: &[f64], s: f64) -> [Vector3<f64>; 3] {
        let of = |weights: [f64; 4]| {
            (0..self.vectors.len()).map(|i| vector(x, self.vectors[i]) * weights[i]).sum()
        };
        self.weights(s).map(of)
    }
}

fn vector(x: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(x[first], x[first + 1], x[first + 2])
}
