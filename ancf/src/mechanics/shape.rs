/// Shape functions of the two-node fully parameterised beam element at one cross-section.
///
/// r(x, y, z) = Σₐ Sₐ eₐ with the eight vectors e = (r, ℓ r_x, ℓ r_y, ℓ r_z) of node 1, then of node 2;
/// with ξ = x/l, η = y/l, ζ = z/l and s = l/ℓ
///
/// S₁ = 1 − 3ξ² + 2ξ³   S₂ = s(ξ − 2ξ² + ξ³)   S₃ = s(η − ξη)   S₄ = s(ζ − ξζ)
/// S₅ = 3ξ² − 2ξ³       S₆ = s(ξ³ − ξ²)        S₇ = s ξη        S₈ = s ξζ
///
/// ℓ = 1 gives eq. (5), ℓ = l eq. (12). The paper prints 3ξ³ in S₂ and a stray l in Ŝ₆; with those, S₂ would have a slope
/// at the far end and Ŝ₆ a dimension (see `docs/paper.md`).
///
/// Units: l, ℓ and x lengths; values as the powers of s and l say.
/// Source: Kim et al. (2017), eqs (5), (12); Yakoub & Shabana (2001).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamShape {
    /// Length l of the element.
    pub length: f64,
    /// Slope length ℓ.
    pub slope: f64,
}

impl BeamShape {
    /// S₁, S₂, S₅, S₆ on the axis at ξ: weights of r₁, ℓ r_x₁, r₂, ℓ r_x₂.
    pub fn axis(&self, xi: f64) -> [f64; 4] {
        let s = self.length / self.slope;
        let (xi2, xi3) = (xi * xi, xi * xi * xi);
        [1.0 - 3.0 * xi2 + 2.0 * xi3, s * (xi - 2.0 * xi2 + xi3), 3.0 * xi2 - 2.0 * xi3, s * (xi3 - xi2)]
    }

    /// Derivatives by x of [`axis`](Self::axis).
    pub fn axis_gradient(&self, xi: f64) -> [f64; 4] {
        let xi2 = xi * xi;
        let bend = 6.0 * (xi2 - xi) / self.length;
        [bend, (1.0 - 4.0 * xi + 3.0 * xi2) / self.slope, -bend, (3.0 * xi2 - 2.0 * xi) / self.slope]
    }

    /// Second derivatives by x of [`axis`](Self::axis).
    pub fn axis_curvature(&self, xi: f64) -> [f64; 4] {
        let bend = 6.0 * (2.0 * xi - 1.0) / (self.length * self.length);
        let rate = 1.0 / (self.slope * self.length);
        [bend, (6.0 * xi - 4.0) * rate, -bend, (6.0 * xi - 2.0) * rate]
    }

    /// ∂S₃/∂y = ∂S₄/∂z and ∂S₇/∂y = ∂S₈/∂z at ξ: weights of the section vectors of both nodes.
    pub fn section(&self, xi: f64) -> [f64; 2] {
        [(1.0 - xi) / self.slope, xi / self.slope]
    }

    /// Derivatives by x of [`section`](Self::section).
    pub fn section_gradient(&self) -> [f64; 2] {
        let rate = 1.0 / (self.slope * self.length);
        [-rate, rate]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPE: BeamShape = BeamShape { length: 0.7, slope: 0.3 };

    /// r and ℓ r_x at the ends are the coordinates themselves. The printed S₂ has slope 6 at ξ = 1, not 0.
    #[test]
    fn nodal_values_and_slopes() {
        let l = SHAPE.slope;
        assert_eq!(SHAPE.axis(0.0), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(SHAPE.axis(1.0), [0.0, 0.0, 1.0, 0.0]);
        assert_eq!(SHAPE.axis_gradient(0.0).map(|s| s * l), [0.0, 1.0, 0.0, 0.0]);
        assert_eq!(SHAPE.axis_gradient(1.0).map(|s| s * l), [0.0, 0.0, 0.0, 1.0]);
    }

    /// The derivative of a cubic by central differences with Richardson's correction is exact.
    #[test]
    fn gradient_is_derivative_of_value() {
        let difference = |xi: f64, h: f64| {
            let (right, left) = (SHAPE.axis(xi + h), SHAPE.axis(xi - h));
            std::array::from_fn::<f64, 4, _>(|i| (right[i] - left[i]) / (2.0 * h * SHAPE.length))
        };
        for xi in [0.0, 0.3, 0.8, 1.0] {
            let (coarse, fine) = (difference(xi, 0.5), difference(xi, 0.25));
            for (i, exact) in SHAPE.axis_gradient(xi).into_iter().enumerate() {
                assert!((exact - (4.0 * fine[i] - coarse[i]) / 3.0).abs() < 1e-13);
            }
        }
    }

    /// The central difference of a parabola is exact.
    #[test]
    fn curvature_is_derivative_of_gradient() {
        for xi in [0.0, 0.3, 0.8, 1.0] {
            let (right, left) = (SHAPE.axis_gradient(xi + 0.5), SHAPE.axis_gradient(xi - 0.5));
            for (i, exact) in SHAPE.axis_curvature(xi).into_iter().enumerate() {
                assert!((exact - (right[i] - left[i]) / SHAPE.length).abs() < 1e-13);
            }
        }
    }

    /// The hat functions of eq. (12) have no dimension: in other units of length they are the same numbers.
    /// The printed Ŝ₆ = l (ξ³ − ξ²) is not.
    #[test]
    fn hat_functions_are_dimensionless() {
        let in_metres = BeamShape { length: 0.7, slope: 0.7 };
        let in_millimetres = BeamShape { length: 700.0, slope: 700.0 };
        assert_eq!(in_metres.axis(0.3), in_millimetres.axis(0.3));
    }
}
