use pulp::Arch;

use super::multifrontal::{SubtractProduct, SubtreeView};
use crate::sparse::{Pattern, QUAD, Quad, SparseMatrix};

/// Products K x with symmetric matrices of one pattern, by supernodes, with their working storage.
#[derive(Debug)]
pub(crate) struct Products {
    /// Rows of a supernode and their products.
    parts: [Vec<Quad>; 2],
    /// Vector and its product, by position.
    x: Vec<f64>,
    product: Vec<f64>,
}

impl Products {
    pub(crate) fn new(pattern: &Pattern) -> Self {
        let height = pattern.supernodes().list.iter().map(|at| at.shape().height).max().unwrap_or(0);
        let zeros = vec![0.0; pattern.size()];
        Self { parts: [(); 2].map(|()| vec![[0.0; QUAD]; height]), x: zeros.clone(), product: zeros }
    }

    /// Computes y = K x, in the order of the unknowns.
    pub(crate) fn multiply(&mut self, k: &SparseMatrix, x: &[f64], y: &mut [f64]) {
        let (pattern, Self { parts: [part, rows], x: sorted, product }) = (k.pattern(), self);
        for (unknown, &x) in x.iter().enumerate() {
            sorted[pattern.position(unknown)] = x;
        }
        product.fill(0.0);
        let supernodes = pattern.supernodes();
        Arch::new().dispatch(SubtractProduct {
            supernodes,
            range: 0..supernodes.list.len(),
            k: k.values(),
            x: SubtreeView::whole(supernodes, &**sorted),
            r: SubtreeView::whole(supernodes, &mut **product),
            parts: (part, rows),
        });
        for (unknown, y) in y.iter_mut().enumerate() {
            *y = -product[pattern.position(unknown)];
        }
    }
}
