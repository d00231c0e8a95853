use ancf_solver::equations::{LocalMatrix, State};
use nalgebra::{Matrix3, Vector3};
use smallvec::SmallVec;

/// Vector linear in the coordinates: a material point or direction of a body, or a fixed one.
///
/// x = x₀ + Σᵢ wᵢ q[vᵢ..vᵢ+3]. Joints constrain markers, loads act on them, and probes measure them.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// First coordinate vᵢ and weight wᵢ of each vector. A rigid body has four vectors.
    parts: SmallVec<[(usize, f64); 4]>,
    reference: Vector3<f64>,
}

impl Marker {
    /// Creates a fixed marker: a point or a direction of the ground.
    pub const fn fixed(reference: Vector3<f64>) -> Self {
        Self { parts: SmallVec::new_const(), reference }
    }

    /// Creates a marker from first coordinates and weights of vectors, and its reference value.
    pub fn new(parts: impl IntoIterator<Item = (usize, f64)>, reference: Vector3<f64>) -> Self {
        Self { parts: parts.into_iter().filter(|&(_, w)| w != 0.0).collect(), reference }
    }

    /// Creates a linear combination of markers.
    pub fn combined<'a>(terms: impl IntoIterator<Item = (f64, &'a Self)>) -> Self {
        let (mut parts, mut reference): (Vec<(usize, f64)>, _) = (Vec::new(), Vector3::zeros());
        for (factor, marker) in terms {
            reference += marker.reference * factor;
            for &(first, w) in &marker.parts {
                match parts.iter_mut().find(|(known, _)| *known == first) {
                    Some((_, sum)) => *sum += factor * w,
                    None => parts.push((first, factor * w)),
                }
            }
        }
        parts.sort_unstable_by_key(|(first, _)| *first);
        Self::new(parts, reference)
    }

    /// Returns the first coordinate and the weight of each vector.
    pub fn parts(&self) -> &[(usize, f64)] {
        &self.parts
    }

    /// Returns the reference value x₀.
    pub fn reference(&self) -> Vector3<f64> {
        self.reference
    }

    /// Returns all coordinates of the marker.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> {
        self.parts.iter().flat_map(|&(first, _)| first..first + 3)
    }

    /// Returns the sorted coordinates of several markers without repetition.
    pub fn union_coordinates<'a>(markers: impl IntoIterator<Item = &'a Self>) -> Vec<usize> {
        let mut coordinates: Vec<usize> = markers.into_iter().flat_map(Self::coordinates).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        coordinates
    }

    /// Returns Σᵢ wᵢ x[vᵢ..vᵢ+3]: displacement, velocity or acceleration of the marker.
    pub fn sum(&self, x: &[f64]) -> Vector3<f64> {
        let mut sum = Vector3::zeros();
        for &(i, w) in &self.parts {
            let x = &x[i..i + 3];
            sum += Vector3::new(x[0], x[1], x[2]) * w;
        }
        sum
    }

    /// Returns the value in a state.
    pub fn value(&self, s: &State) -> Vector3<f64> {
        self.reference + self.sum(&s.q)
    }

    /// Returns the sum of magnitudes |x₀| + Σᵢ |wᵢ| |q[vᵢ..vᵢ+3]|. ε times this bounds the rounding error of the value.
    pub fn size(&self, q: &[f64]) -> f64 {
        self.reference.norm() + self.sum_of_sizes(q)
    }

    /// Returns Σᵢ |wᵢ| |x[vᵢ..vᵢ+3]|.
    pub(crate) fn sum_of_sizes(&self, x: &[f64]) -> f64 {
        self.parts.iter().map(|&(i, w)| w.abs() * Vector3::new(x[i], x[i + 1], x[i + 2]).norm()).sum()
    }

    /// Renumbers the coordinates for a term with the given sorted coordinate list.
    pub fn within(&self, coordinates: &[usize]) -> Self {
        let local = |first| {
            coordinates.iter().position(|c| c == first).expect("the coordinate list contains all coordinates")
        };
        let parts = self.parts.iter().map(|(first, w)| (local(first), *w)).collect();
        Self { parts, reference: self.reference }
    }

    /// Adds x to the rows of a vector with weights: rows[vᵢ + k] += wᵢ xₖ.
    pub fn add(&self, x: Vector3<f64>, rows: &mut [f64]) {
        for &(i, w) in &self.parts {
            for (row, x) in rows[i..i + 3].iter_mut().zip(&x) {
                *row += w * x;
            }
        }
    }

    /// Adds the lower triangle of the second derivative of x·H·y of this marker and another one.
    pub(crate) fn add_lower_product(&self, other: &Self, h: &Matrix3<f64>, matrix: &mut LocalMatrix<'_>) {
        for &(i, w) in &self.parts {
            for &(j, u) in &other.parts {
                // Vectors are equal or disjoint.
                if i < j {
                    continue;
                }
                let factor = w * u;
                for l in 0..3 {
                    let start = if i == j { l } else { 0 };
                    (start..3).for_each(|k| matrix.add(i + k, j + l, factor * h[(k, l)]));
                }
            }
        }
    }

    /// Calls `visit(i, j, wᵢ w'ⱼ H_kl)` for the second derivative of x·H·y of this marker and another one.
    pub fn product(&self, other: &Self, h: &Matrix3<f64>, mut visit: impl FnMut(usize, usize, f64)) {
        for &(i, w) in &self.parts {
            for &(j, u) in &other.parts {
                for (k, l) in (0..3).flat_map(|k| (0..3).map(move |l| (k, l))) {
                    visit(i + k, j + l, w * u * h[(k, l)]);
                }
            }
        }
    }
}
