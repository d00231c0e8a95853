/// Shape functions of the two-node fully parameterised beam element at one cross-section.
///
/// r(x, y, z) = Σₐ Sₐ eₐ with the eight vectors e = (r, ℓ r_x, ℓ r_y, ℓ r_z) of node 1, then of node 2;
/// with ξ = x/l, η = y/l, ζ = z/l and s = l/ℓ
///
/// S₁ = 1 − 3ξ² + 2ξ³   S₂ = s(ξ − 2ξ² + ξ³)   S₃ = s(η − ξη)   S₄ = s(ζ − ξζ)
/// S₅ = 3ξ² − 2ξ³       S₆ = s(ξ³ − ξ²)        S₇ = s ξη        S₈ = s ξζ
///
/// ℓ = 1 gives eq. (5), ℓ = l eq. (12). The paper prints 3ξ³ in S₂ and an extra factor l in Ŝ₆. With these, S₂ would
/// have a slope at the far end and Ŝ₆ a dimension (see `docs/paper.md`).
///
/// Units: l, ℓ and x lengths; values according to the powers of s and l.
/// Source: Kim et al. (2017), eqs (5), (12); Yakoub & Shabana (2001).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamShape {
    /// Length l of the element.
    pub length: f64,
    /// Slope length ℓ.
    pub slope: f64,
}

impl BeamShape {
    /// Returns S₁, S₂, S₅, S₆ on the axis at ξ: the weights of r₁, ℓ r_x₁, r₂, ℓ r_x₂.
    pub fn axis(&self, xi: f64) -> [f64; 4] {
        let s = self.length / self.slope;
        let (xi2, xi3) = (xi * xi, xi * xi * xi);
        [1.0 - 3.0 * xi2 + 2.0 * xi3, s * (xi - 2.0 * xi2 + xi3), 3.0 * xi2 - 2.0 * xi3, s * (xi3 - xi2)]
    }

    /// Returns the derivatives of [`axis`](Self::axis) by x.
    pub fn axis_gradient(&self, xi: f64) -> [f64; 4] {
        let xi2 = xi * xi;
        let bend = 6.0 * (xi2 - xi) / self.length;
        [bend, (1.0 - 4.0 * xi + 3.0 * xi2) / self.slope, -bend, (3.0 * xi2 - 2.0 * xi) / self.slope]
    }

    /// Returns the second derivatives of [`axis`](Self::axis) by x.
    pub fn axis_curvature(&self, xi: f64) -> [f64; 4] {
        let bend = 6.0 * (2.0 * xi - 1.0) / (self.length * self.length);
        let rate = 1.0 / (self.slope * self.length);
        [bend, (6.0 * xi - 4.0) * rate, -bend, (6.0 * xi - 2.0) * rate]
    }

    /// Returns ∂S₃/∂y = ∂S₄/∂z and ∂S₇/∂y = ∂S₈/∂z at ξ: the weights of the section vectors of both nodes.
    pub fn section(&self, xi: f64) -> [f64; 2] {
        [(1.0 - xi) / self.slope, xi / self.slope]
    }

    /// Returns the derivatives of [`section`](Self::section) by x.
    pub fn section_gradient(&self) -> [f64; 2] {
        let rate = 1.0 / (self.slope * self.length);
        [-rate, rate]
    }
}

/// Kind of a nodal vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorKind {
    /// Position r of the axis.
    Position,
    /// Axial slope ℓ r_x.
    Slope,
    /// Section vector ℓ r_y.
    Y,
    /// Section vector ℓ r_z.
    Z,
    /// Mixed derivative r_ξη of a surface, whose tangents r_ξ and r_η have the kinds `Slope` and `Y`.
    Twist,
}

impl VectorKind {
    /// Returns the directors that depend on the vector: a, h and k, or d and b, or e and c. Only the axis has a third
    /// one.
    pub(crate) const fn directors(self) -> [usize; 3] {
        match self {
            Self::Position | Self::Slope | Self::Twist => [0, 5, 6],
            Self::Y => [3, 1, 1],
            Self::Z => [4, 2, 2],
        }
    }
}

/// Interpolation of axis and sections from N vectors of an element.
pub trait Interpolation<const N: usize>: 'static {
    /// Kind of each vector.
    const KINDS: [VectorKind; N];

    /// Returns the length of the element.
    fn length(&self) -> f64;

    /// Returns the weights of the vectors at ξ, in r, r_y or r_z according to their kind.
    fn values(&self, xi: f64) -> [f64; N];

    /// Returns the weights of the vectors in their directors ([`VectorKind`]) at ξ: a, h and k, or d and b, or e and c.
    fn directors(&self, xi: f64) -> [[f64; 3]; N];
}

impl Interpolation<8> for BeamShape {
    const KINDS: [VectorKind; 8] = [
        VectorKind::Position,
        VectorKind::Slope,
        VectorKind::Y,
        VectorKind::Z,
        VectorKind::Position,
        VectorKind::Slope,
        VectorKind::Y,
        VectorKind::Z,
    ];

    fn length(&self) -> f64 {
        self.length
    }

    fn values(&self, xi: f64) -> [f64; 8] {
        let (axis, section) = (self.axis(xi), self.section(xi));
        [axis[0], axis[1], section[0], section[0], axis[2], axis[3], section[1], section[1]]
    }

    fn directors(&self, xi: f64) -> [[f64; 3]; 8] {
        let (axis, section, twist) = (self.axis_gradient(xi), self.section(xi), self.section_gradient());
        // Part of a that is quadratic in ξ: 3 (r_x₁ + r_x₂) − 6 (r₂ − r₁)/l.
        let quadratic = [6.0 / self.length, 3.0 / self.slope, -6.0 / self.length, 3.0 / self.slope];
        let change = [0.0, -1.0 / self.slope, 0.0, 1.0 / self.slope];
        let axis: [[f64; 3]; 4] = std::array::from_fn(|i| [axis[i], quadratic[i], change[i]]);
        let section: [[f64; 3]; 2] = std::array::from_fn(|i| [section[i], twist[i], 0.0]);
        [axis[0], axis[1], section[0], section[0], axis[2], axis[3], section[1], section[1]]
    }
}

/// Shape functions of the three-node beam element: r, r_y and r_z are quadratic along the axis.
///
/// N₁ = 1 − 3ξ + 2ξ², N₂ = 4ξ − 4ξ², N₃ = 2ξ² − ξ for the vectors (r, ℓ r_y, ℓ r_z) of the nodes at ξ = 0, ½, 1.
///
/// Source: Nachbagauer, Gruber & Gerstmayr (2013).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadraticShape {
    /// Length l of the element.
    pub length: f64,
    /// Slope length ℓ.
    pub slope: f64,
}

impl QuadraticShape {
    /// Returns N₁, N₂, N₃ at ξ.
    pub fn values(xi: f64) -> [f64; 3] {
        [1.0 - 3.0 * xi + 2.0 * xi * xi, 4.0 * (xi - xi * xi), 2.0 * xi * xi - xi]
    }

    /// Returns the derivatives of N₁, N₂, N₃ by ξ.
    pub fn slopes(xi: f64) -> [f64; 3] {
        [4.0 * xi - 3.0, 4.0 - 8.0 * xi, 4.0 * xi - 1.0]
    }
}

impl Interpolation<9> for QuadraticShape {
    const KINDS: [VectorKind; 9] = [
        VectorKind::Position,
        VectorKind::Y,
        VectorKind::Z,
        VectorKind::Position,
        VectorKind::Y,
        VectorKind::Z,
        VectorKind::Position,
        VectorKind::Y,
        VectorKind::Z,
    ];

    fn length(&self) -> f64 {
        self.length
    }

    fn values(&self, xi: f64) -> [f64; 9] {
        let n = Self::values(xi);
        std::array::from_fn(|i| if i % 3 == 0 { n[i / 3] } else { n[i / 3] / self.slope })
    }

    fn directors(&self, xi: f64) -> [[f64; 3]; 9] {
        let (n, slopes) = (Self::values(xi), Self::slopes(xi).map(|slope| slope / self.length));
        // a is linear in ξ: h = k.
        let change = [4.0, -8.0, 4.0].map(|change| change / self.length);
        std::array::from_fn(|i| match i % 3 {
            0 => [slopes[i / 3], change[i / 3], change[i / 3]],
            _ => [n[i / 3] / self.slope, slopes[i / 3] / self.slope, 0.0],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPE: BeamShape = BeamShape { length: 0.7, slope: 0.3 };

    /// At the ends, r and ℓ r_x are the coordinates. The printed S₂ has slope 6 at ξ = 1 instead of 0.
    #[test]
    fn nodal_values_and_slopes() {
        let l = SHAPE.slope;
        assert_eq!(SHAPE.axis(0.0), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(SHAPE.axis(1.0), [0.0, 0.0, 1.0, 0.0]);
        assert_eq!(SHAPE.axis_gradient(0.0).map(|s| s * l), [0.0, 1.0, 0.0, 0.0]);
        assert_eq!(SHAPE.axis_gradient(1.0).map(|s| s * l), [0.0, 0.0, 0.0, 1.0]);
    }

    /// Central differences with Richardson's correction are exact for a cubic.
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

    /// Central differences are exact for a parabola.
    #[test]
    fn curvature_is_derivative_of_gradient() {
        for xi in [0.0, 0.3, 0.8, 1.0] {
            let (right, left) = (SHAPE.axis_gradient(xi + 0.5), SHAPE.axis_gradient(xi - 0.5));
            for (i, exact) in SHAPE.axis_curvature(xi).into_iter().enumerate() {
                assert!((exact - (right[i] - left[i]) / SHAPE.length).abs() < 1e-13);
            }
        }
    }

    /// The functions Ŝ of eq. (12) are dimensionless: they have the same values in other units of length.
    /// The printed Ŝ₆ = l (ξ³ − ξ²) is not dimensionless.
    #[test]
    fn hat_functions_are_dimensionless() {
        let in_metres = BeamShape { length: 0.7, slope: 0.7 };
        let in_millimetres = BeamShape { length: 700.0, slope: 700.0 };
        assert_eq!(in_metres.axis(0.3), in_millimetres.axis(0.3));
    }
}
