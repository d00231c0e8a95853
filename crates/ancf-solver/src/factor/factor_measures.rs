use super::factorisation::{COMPLIANCE, Factor};
use crate::sparse::SparseMatrix;

impl Factor {
    /// Raises bounds of the gaps in statics of rigid bodies to the rounding error of the compliance of shared multipliers λ:
    /// ε c max |λ_k|/D_k / D_i with the compliance c/D² on the diagonal. Increments close gaps up to this error.
    pub(crate) fn raise_to_compliance(&self, lambda: &[f64], bounds: &mut [f64]) {
        if !self.shared.as_ref().is_some_and(|shared| shared.is_rigid) {
            return;
        }
        let coordinates = self.b.len() - lambda.len();
        let size = |at: usize| lambda[self.pattern.unknown(at) - coordinates].abs() / self.d[at];
        let largest = self.pattern.shared().iter().map(|&at| size(at)).fold(0.0, f64::max);
        for (i, bound) in bounds.iter_mut().enumerate() {
            let d = self.d[self.pattern.position(coordinates + i)];
            *bound = bound.max(f64::EPSILON * COMPLIANCE * largest / d);
        }
    }

    /// Returns xᵀ K x.
    pub(crate) fn energy(&mut self, k: &SparseMatrix, x: &[f64]) -> f64 {
        let Self { ldlt, pattern, x: sorted, r, .. } = self;
        x.iter().enumerate().for_each(|(unknown, x)| sorted[pattern.position(unknown)] = *x);
        r.fill(0.0);
        ldlt.subtract_product(pattern.supernodes(), k.values(), sorted, r);
        -sorted.iter().zip(&*r).map(|(x, r)| x * r).sum::<f64>()
    }

    /// Returns true if the LU fallback is active.
    pub fn is_lu(&self) -> bool {
        self.lu.is_some()
    }

    /// Returns the scale of a coordinate: the inverse root of its diagonal entry in the last factorised matrix.
    pub fn scale(&self, coordinate: usize) -> f64 {
        self.d[self.pattern.position(coordinate)]
    }

    /// Returns the number of negative entries of D in L D Lᵀ, which is the number of negative eigenvalues of K.
    ///
    /// Returns `None` for LU, whose pivots do not provide the inertia (Sylvester 1852).
    pub fn negative_pivots(&self) -> Option<usize> {
        let negative = || self.ldlt.inverse_pivots().iter().filter(|inverse| **inverse < 0.0).count();
        self.lu.is_none().then(negative)
    }
}
