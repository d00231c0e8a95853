use nalgebra::Vector3;

use super::thin::{VECTORS, bicubic};

/// Middle surface of an element as r(ξ, η) = Σ_a N_a e_a, 0 ≤ ξ, η ≤ 1, for closest points at variable positions.
#[derive(Clone, Debug)]
pub struct ElementSurface {
    /// First coordinate of each nodal vector.
    vectors: [usize; VECTORS],
    /// Reference values of the vectors.
    reference: [Vector3<f64>; VECTORS],
}

impl ElementSurface {
    /// Creates a surface from first coordinates and reference values of its nodal vectors.
    pub const fn new(vectors: [usize; VECTORS], reference: [Vector3<f64>; VECTORS]) -> Self {
        Self { vectors, reference }
    }

    /// Returns the first coordinate of each nodal vector.
    pub fn vectors(&self) -> &[usize; VECTORS] {
        &self.vectors
    }

    /// Returns all coordinates of the surface.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> {
        self.vectors.into_iter().flat_map(|first| first..first + 3)
    }

    /// Renumbers the coordinates for a term with the given coordinate list.
    pub(crate) fn within(&self, coordinates: &[usize]) -> Self {
        let local = |first: usize| {
            coordinates
                .iter()
                .position(|c| *c == first)
                .expect("the coordinate list contains all coordinates")
        };
        Self { vectors: self.vectors.map(local), reference: self.reference }
    }

    /// Returns the position of the first node, given the coordinates q.
    pub(crate) fn first_node(&self, q: &[f64]) -> Vector3<f64> {
        self.reference[0] + vector(q, self.vectors[0])
    }

    /// Returns the nodal vectors, given the coordinates q, with positions relative to an origin.
    pub(crate) fn values(&self, q: &[f64], origin: &Vector3<f64>) -> [Vector3<f64>; VECTORS] {
        std::array::from_fn(|a| {
            let reference = if a % 4 == 0 { self.reference[a] - origin } else { self.reference[a] };
            reference + vector(q, self.vectors[a])
        })
    }

    /// Returns Σ_a |N_a| (|e_a⁰| + |q_a|) for r, r_ξ and r_η. ε times these bounds the rounding errors.
    pub(crate) fn sizes(&self, q: &[f64], at: [f64; 2]) -> [f64; 3] {
        [[0, 0], [1, 0], [0, 1]].map(|order| {
            let size = |a: usize| self.reference[a].norm() + vector(q, self.vectors[a]).norm();
            bicubic(at, order).iter().enumerate().map(|(a, weight)| weight.abs() * size(a)).sum()
        })
    }

    /// Returns the weights of the vectors in r, r_ξ and r_η.
    pub(crate) fn weights(at: [f64; 2]) -> [[f64; VECTORS]; 3] {
        [[0, 0], [1, 0], [0, 1]].map(|order| bicubic(at, order))
    }
}

fn vector(x: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(x[first], x[first + 1], x[first + 2])
}
