use super::local::{LOCAL, LocalMatrix};

/// Column x of a product with the stiffness matrix K of a term.
#[derive(Clone, Copy, Debug)]
pub struct ProductColumn {
    /// Entries of x at the coordinates of the term.
    pub x: [f64; LOCAL],
    /// Entries of K x.
    pub product: [f64; LOCAL],
    /// Bound of the rounding error of xᵀ K x, including that of x.
    pub rounding: f64,
}

impl ProductColumn {
    /// Empty column.
    pub const ZERO: Self = Self { x: [0.0; LOCAL], product: [0.0; LOCAL], rounding: 0.0 };

    /// Adds the product with the first `n` rows of a matrix.
    pub fn add_matrix(&mut self, k: &LocalMatrix<'_>, n: usize) {
        let Self { x, product, rounding } = self;
        let mut magnitude = [0.0; LOCAL];
        for j in 0..n {
            for i in j..n {
                let entry = k.get(i, j);
                product[i] += entry * x[j];
                magnitude[i] += (entry * x[j]).abs();
                if i != j {
                    product[j] += entry * x[i];
                    magnitude[j] += (entry * x[i]).abs();
                }
            }
        }
        // Two for the errors of x, one for those of the products.
        *rounding += 3.0
            * f64::EPSILON
            * x[..n].iter().zip(magnitude).map(|(x, magnitude)| x.abs() * magnitude).sum::<f64>();
    }
}
