use ancf_solver::equations::Term;

use crate::kinematics::Marker;

/// Constraint that is at most quadratic in the coordinates and does not depend on time.
pub(crate) trait QuadraticConstraint: Term {
    /// Returns the rows over the coordinates of the constraint, one for each multiplier. `None` if it is not quadratic.
    fn rows(&self) -> Option<Vec<BilinearRow>>;
}

/// Equation between vectors that are linear in the coordinates of a term, for the evaluation of several terms side by side:
///
/// Φ = Σ c (a·b − a₀·b₀) + Σ k q − g − s h with the load factor s. Its second derivative is constant.
#[derive(Clone, Debug, Default)]
pub(crate) struct BilinearRow {
    /// Factors c and vectors a, b.
    pub products: Vec<(f64, [Marker; 2])>,
    /// Coordinates and their factors k.
    pub linear: Vec<(usize, f64)>,
    /// Constants g and h.
    pub offset: [f64; 2],
}

impl BilinearRow {
    /// Returns the row of a term with more coordinates, in which coordinate i has the index `places[i]`.
    ///
    /// The three coordinates of a vector are consecutive in both terms.
    pub(super) fn within(&self, places: &[usize]) -> Self {
        let vector = |marker: &Marker| {
            Marker::new(marker.parts().iter().map(|&(first, w)| (places[first], w)), marker.reference())
        };
        Self {
            products: self.products.iter().map(|(c, vectors)| (*c, vectors.each_ref().map(vector))).collect(),
            linear: self.linear.iter().map(|&(c, k)| (places[c], k)).collect(),
            offset: self.offset,
        }
    }

    /// Returns the coordinates with entries in the row, with repetitions.
    pub(super) fn coordinates(&self) -> impl Iterator<Item = usize> {
        let vectors = self.products.iter().flat_map(|(_, vectors)| vectors).flat_map(Marker::coordinates);
        vectors.chain(self.linear.iter().map(|(c, _)| *c))
    }

    /// Returns the numbers that terms must have in common to be evaluated side by side: the coordinates of all vectors.
    pub(crate) fn structure(&self) -> Vec<usize> {
        let mut structure = vec![self.products.len(), self.linear.len()];
        for parts in self.products.iter().flat_map(|(_, vectors)| vectors).map(Marker::parts) {
            structure.push(parts.len());
            structure.extend(parts.iter().map(|(first, _)| first));
        }
        structure.extend(self.linear.iter().map(|(c, _)| c));
        structure
    }
}
