//! Products with the stiffness matrix, term by term.

use std::sync::Arc;

use nalgebra::DVector;

use super::term_sums::LocalState;
use super::terms::{ProductColumn, State, Term};

/// Products of the stiffness matrix K with the columns of X.
#[derive(Clone, Debug)]
pub struct StiffnessProducts {
    /// Columns of K X. They have the size of the columns of X and zeros instead of multipliers.
    pub products: Vec<DVector<f64>>,
    /// Diagonal entries xᵀ K x.
    pub squares: Vec<f64>,
    /// Bounds of their rounding errors.
    pub rounding: Vec<f64>,
}

/// Computes K X and the diagonal of Xᵀ K X over the coordinates ([`Term::stiffness_products`]).
///
/// The sum of the products is almost zero where neighbouring elements balance each other. The sum of the energies of the elements
/// has no such cancellation.
pub(super) fn stiffness_products(
    terms: &[Arc<dyn Term>],
    s: &State,
    x: &[DVector<f64>],
) -> StiffnessProducts {
    let mut sum = StiffnessProducts {
        products: x.iter().map(|x| DVector::zeros(x.len())).collect(),
        squares: vec![0.0; x.len()],
        rounding: vec![0.0; x.len()],
    };
    let (mut gathered, mut columns) = (LocalState::EMPTY, vec![ProductColumn::ZERO; x.len()]);
    for term in terms {
        let (at, coordinates) = (gathered.gather(s, term.as_ref()), term.coordinates());
        for (column, x) in columns.iter_mut().zip(x) {
            column.x.iter_mut().zip(coordinates).for_each(|(local, &c)| *local = x[c]);
            column.product[..coordinates.len()].fill(0.0);
            column.rounding = 0.0;
        }
        term.stiffness_products(&at, &mut columns);
        for (k, column) in columns.iter().enumerate() {
            sum.add(k, coordinates, column);
        }
    }
    sum
}

/// Multiple of the rounding error of xᵀ K x below which it is zero.
const ZERO: f64 = 8.0;

impl StiffnessProducts {
    /// Returns all xᵀ K x, zero within the rounding error.
    pub fn values(&self) -> Vec<f64> {
        let value =
            |(value, rounding): (&f64, &f64)| if value.abs() > ZERO * rounding { *value } else { 0.0 };
        self.squares.iter().zip(&self.rounding).map(value).collect()
    }

    /// Adds the product of a term with column `k`.
    fn add(&mut self, k: usize, coordinates: &[usize], column: &ProductColumn) {
        let rows = coordinates.iter().zip(column.x.iter().zip(&column.product));
        let (product, mut square) = (&mut self.products[k], 0.0);
        for (&c, (x, own)) in rows {
            product[c] += own;
            square += x * own;
        }
        self.squares[k] += square;
        self.rounding[k] += column.rounding;
    }
}
