use nalgebra::{DMatrix, DVector, Dyn, LU};

use super::arnoldi::ArnoldiOperator;
use crate::eigen::operator::EigenError;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Largest number of numbers in the correction W of [`SkewOperator`].
const LARGEST: usize = 50_000_000;

/// Operator T = (K + A − σM)⁻¹ M on the x with Φ_q x = 0, for a skew A of a few coordinates.
///
/// With P = K − σM, bordered by the constraints, and A = E S Eᵀ over the coordinates of A, the inverse is
/// P⁻¹ − W (I + S Eᵀ W)⁻¹ S Eᵀ P⁻¹, W = P⁻¹ E.
///
/// Source: Woodbury (1950).
pub(super) struct SkewOperator<'a> {
    coordinates: usize,
    mass: SparseMatrix,
    left: SparseMatrix,
    factor: Factor,
    /// Coordinates of A.
    places: Vec<usize>,
    /// S, W and the factors of I + S Eᵀ W.
    skew: DMatrix<f64>,
    correction: DMatrix<f64>,
    small: LU<f64, Dyn, Dyn>,
    interrupt: &'a Interrupt,
}

impl<'a> SkewOperator<'a> {
    pub(super) fn new(
        eom: &dyn EquationsOfMotion,
        matrix: SparseMatrix,
        s: &State,
        shift: f64,
        interrupt: &'a Interrupt,
    ) -> Result<Self, EigenError> {
        let coordinates = eom.coordinates();
        let (mut mass, mut left) = (matrix.clone(), matrix);
        eom.tangent(s, Weights::MASS, &mut mass);
        eom.tangent(s, Weights { q: 1.0, v: 0.0, a: -shift }, &mut left);
        let mut factor = Factor::new(left.pattern())?;
        factor.factorise(&left)?;
        let entries = eom.skew_stiffness(s);
        let mut places: Vec<usize> = entries.iter().flat_map(|&(i, j, _)| [i, j]).collect();
        places.sort_unstable();
        places.dedup();
        let count = places.len();
        if count * coordinates > LARGEST {
            return Err(EigenError::Nonconservative);
        }
        let mut skew = DMatrix::zeros(count, count);
        for (i, j, value) in entries {
            let at = |coordinate| places.partition_point(|place| *place < coordinate);
            skew[(at(i), at(j))] += value;
            skew[(at(j), at(i))] -= value;
        }
        let mut correction = DMatrix::zeros(coordinates, count);
        for (k, &place) in places.iter().enumerate() {
            let mut column = vec![0.0; left.pattern().size()];
            column[place] = 1.0;
            factor.solve(&left, &mut column)?;
            correction.column_mut(k).copy_from_slice(&column[..coordinates]);
        }
        let picked = DMatrix::from_fn(count, count, |i, j| correction[(places[i], j)]);
        let product: DMatrix<f64> = &skew * picked;
        let small = (DMatrix::identity(count, count) + product).lu();
        Ok(Self { coordinates, mass, left, factor, places, skew, correction, small, interrupt })
    }

    /// Returns T applied to a pseudo-random vector.
    pub(super) fn start(&mut self, random: &mut PseudoRandom) -> Result<DVector<f64>, EigenError> {
        let root = |i: usize| self.mass.diagonal_of(i).abs().sqrt();
        let force = DVector::from_fn(self.coordinates, |i, _| root(i) * random.number());
        self.solve(force)
    }

    fn solve(&mut self, force: DVector<f64>) -> Result<DVector<f64>, EigenError> {
        if self.interrupt.is_set() {
            return Err(EigenError::Interrupted);
        }
        let mut y = force.as_slice().to_vec();
        y.resize(self.left.pattern().size(), 0.0);
        self.factor.solve(&self.left, &mut y)?;
        let mut y = DVector::from_column_slice(&y[..self.coordinates]);
        let picked = DVector::from_iterator(self.places.len(), self.places.iter().map(|&place| y[place]));
        let part = self.small.solve(&(&self.skew * picked)).ok_or(EigenError::Singular)?;
        y -= &self.correction * part;
        Ok(y)
    }
}

impl ArnoldiOperator for SkewOperator<'_> {
    fn apply(&mut self, x: &DVector<f64>) -> Result<DVector<f64>, EigenError> {
        self.solve(self.inner_image(x))
    }

    /// Computes M x.
    fn inner_image(&self, x: &DVector<f64>) -> DVector<f64> {
        let mut whole = x.as_slice().to_vec();
        whole.resize(self.mass.pattern().size(), 0.0);
        let mut product = self.mass.times(&whole);
        product.truncate(self.coordinates);
        product.into()
    }
}
