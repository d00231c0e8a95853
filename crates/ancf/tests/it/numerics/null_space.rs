//! The basis of a null space satisfies all rows, and its dimension is the number of unknowns less the rank.

use ancf::solver::factor::{NullSpace, SparseVector};

/// Number of unknowns of each body of the chain.
const OWN: usize = 3;

/// Rows of a chain: body k relative to body k − 1, with coefficients without symmetry. The last row of each body is the sum of the
/// others, hence dependent.
fn rows(bodies: usize) -> Vec<SparseVector> {
    let entry = |i: usize| (1.7 * (i + 1) as f64).sin() + 1.5;
    let row = |k: usize, r: usize| -> SparseVector {
        let own = (0..OWN).map(|j| (OWN * k + j, entry(7 * k + 3 * r + j)));
        let before = (0..OWN).filter(|_| k > 0).map(|j| (OWN * (k - 1) + j, -entry(5 * k + r + j)));
        own.chain(before.collect::<Vec<_>>()).collect()
    };
    let of_body = |k: usize| {
        let [first, second] = [row(k, 0), row(k, 1)];
        let mut sum = first.clone();
        second.iter().for_each(|(&j, x)| *sum.entry(j).or_default() += x);
        [first, second, sum]
    };
    // From the end of the chain: later rows contain earlier pivots.
    (0..bodies).rev().flat_map(of_body).collect()
}

#[test]
fn basis_vectors_satisfy_all_rows() {
    let (bodies, mut space) = (12, NullSpace::default());
    let rows = rows(bodies);
    rows.iter().for_each(|row| space.add_row(row.clone().into_iter().collect(), 1e-9, |_| true));
    let basis = space.basis(OWN * bodies);
    assert_eq!(basis.len(), OWN * bodies - 2 * bodies);
    for (free, vector) in &basis {
        assert_eq!(vector[free], 1.0);
        assert!(basis.keys().all(|other| other == free || !vector.contains_key(other)));
        for row in &rows {
            let products = || row.iter().map(|(j, x)| x * vector.get(j).copied().unwrap_or_default());
            let size: f64 = products().map(f64::abs).sum();
            assert!(products().sum::<f64>().abs() <= 1e-9 * (size + 1.0), "{free}: {row:?}");
        }
    }
    let coefficients: usize = basis.values().map(|vector| vector.len() - 1).sum();
    assert_eq!(space.entries(), coefficients);
}
