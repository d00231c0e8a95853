//! Bicubic Hermite functions of the Bogner-Fox-Schmit rectangle.

use nalgebra::Vector3;

/// Number of nodal vectors of an element: r, r_ξ, r_η, r_ξη at four nodes.
pub const VECTORS: usize = 16;

/// Values of the shape functions, one for each nodal vector.
pub(crate) type Shape = [f64; VECTORS];

/// Computes the cubic Hermite functions of value and slope at both ends, and their derivatives, at ξ in [0, 1].
///
/// The order is (value, slope) at ξ = 0, then at ξ = 1. `derivative` is 0, 1 or 2.
pub(crate) const fn hermite(x: f64, derivative: usize) -> [f64; 4] {
    match derivative {
        0 => {
            let (s, c) = (x * x, x * x * x);
            [1.0 - 3.0 * s + 2.0 * c, x - 2.0 * s + c, 3.0 * s - 2.0 * c, c - s]
        }
        1 => {
            let s = x * x;
            [6.0 * (s - x), 1.0 - 4.0 * x + 3.0 * s, 6.0 * (x - s), 3.0 * s - 2.0 * x]
        }
        _ => [12.0 * x - 6.0, 6.0 * x - 4.0, 6.0 - 12.0 * x, 6.0 * x - 2.0],
    }
}

/// Computes the shape functions or their derivatives ∂^i/∂ξ^i ∂^j/∂η^j at a point of the unit square.
///
/// Nodes are (0, 0), (1, 0), (0, 1), (1, 1). The vectors of a node are r, r_ξ, r_η, r_ξη.
///
/// Source: Bogner, Fox & Schmit (1965).
pub(crate) fn bicubic([x, y]: [f64; 2], [i, j]: [usize; 2]) -> Shape {
    let (along, across) = (hermite(x, i), hermite(y, j));
    std::array::from_fn(|a| {
        let (node, kind) = (a / 4, a % 4);
        along[2 * (node % 2) + kind % 2] * across[2 * (node / 2) + kind / 2]
    })
}

/// Orders of the derivatives of a surface: r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
pub(crate) const DERIVATIVES: [[usize; 2]; 5] = [[1, 0], [0, 1], [2, 0], [0, 2], [1, 1]];

/// Computes the derivatives of the shape functions in the order of [`DERIVATIVES`].
pub(crate) fn surface_derivatives(at: [f64; 2]) -> [Shape; 5] {
    DERIVATIVES.map(|order| bicubic(at, order))
}

/// Returns the nodal vectors of a slice of coordinates.
pub(crate) fn vectors(x: &[f64]) -> [Vector3<f64>; VECTORS] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The functions interpolate every bicubic polynomial exactly, with its derivatives.
    #[test]
    fn bicubic_polynomials_are_exact() {
        let power = |x: f64, n: i32, d: usize| match d {
            0 => x.powi(n),
            1 if n == 0 => 0.0,
            1 => f64::from(n) * x.powi(n - 1),
            _ if n < 2 => 0.0,
            _ => f64::from(n * (n - 1)) * x.powi(n - 2),
        };
        let nodes = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let at = [0.3, 0.8];
        for (m, n) in (0..4).flat_map(|m| (0..4).map(move |n| (m, n))) {
            for order @ [i, j] in [[0, 0], [1, 0], [0, 1], [2, 0], [0, 2], [1, 1]] {
                let nodal = |a: usize| {
                    let ([x, y], kind) = (nodes[a / 4], a % 4);
                    power(x, m, kind % 2) * power(y, n, kind / 2)
                };
                let sum: f64 = bicubic(at, order).iter().enumerate().map(|(a, shape)| shape * nodal(a)).sum();
                let exact = power(at[0], m, i) * power(at[1], n, j);
                assert!((sum - exact).abs() < 1e-14, "x^{m} y^{n}, {order:?}: {sum} for {exact}");
            }
        }
    }
}
