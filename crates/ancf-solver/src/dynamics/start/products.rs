use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::Newton;

pub(super) fn difference(x: &[f64], y: &[f64]) -> Vec<f64> {
    x.iter().zip(y).map(|(x, y)| x - y).collect()
}

/// Returns √(xᵀ M x) of several vectors.
pub(super) fn magnitudes<E: EquationsOfMotion, const N: usize>(
    eom: &E,
    newton: &mut Newton,
    s: &State,
    vectors: [&[f64]; N],
) -> [f64; N] {
    eom.tangent(s, Weights::MASS, newton.tangent.lend().0);
    vectors.map(|x| {
        multiply(newton, x);
        x.iter().zip(&newton.r).map(|(x, r)| x * r).sum::<f64>().max(0.0).sqrt()
    })
}

/// Computes the product of the last computed matrix and (x, 0) into `newton.r`.
pub(super) fn multiply(newton: &mut Newton, x: &[f64]) {
    let Newton { tangent, r, z, .. } = newton;
    z.fill(0.0);
    z[..x.len()].copy_from_slice(x);
    tangent.lend().0.multiply(z, r);
}
