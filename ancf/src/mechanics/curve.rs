use nalgebra::{Matrix3, Vector3};

/// Stretch of a material line at one point.
///
/// With a = r′ = a₀ + u, |a₀| = 1: ε = |a| − 1 = (2 a₀·u + u·u) / (|a| + 1), without cancellation for small u;
/// ∂ε/∂a = t = a/|a|, ∂²ε/∂a² = (I − t tᵀ)/|a|.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    /// ε.
    pub strain: f64,
    /// |a|.
    pub length: f64,
    /// t.
    pub tangent: Vector3<f64>,
}

impl Stretch {
    /// From the reference direction a₀, a unit vector, and the displacement gradient u.
    pub fn new(reference: &Vector3<f64>, u: &Vector3<f64>) -> Self {
        let a = reference + u;
        let length = a.norm();
        let strain = (2.0 * reference.dot(u) + u.dot(u)) / (length + 1.0);
        Self { strain, length, tangent: a / length }
    }

    /// What of a vector is across the tangent.
    pub fn across(&self, x: &Vector3<f64>) -> Vector3<f64> {
        x - self.tangent * self.tangent.dot(x)
    }

    /// c ∂ε/∂a (∂ε/∂a)ᵀ + n ∂²ε/∂a².
    pub fn stiffness(&self, c: f64, n: f64) -> Matrix3<f64> {
        let n = n / self.length;
        self.tangent * self.tangent.transpose() * (c - n) + Matrix3::from_diagonal_element(n)
    }
}

/// Bending of a material line at one point: the material measure of curvature and the derivatives of H = ½K².
///
/// With a = r′ and b = r″: κ = a × b / |a|², K = |κ|, the rotation of the tangent per *reference* length. With
/// A = a·a, B = b·b, C = a·b and n = b − (C/A) a, H = ½ (AB − C²)/A² = ½ n·n/A is a smooth function of a ≠ 0 and b,
///
/// ∂H/∂b = n/A,  ∂H/∂a = −(n·n a + C n)/A²,
///
/// ∂²H/∂b² = (I − a aᵀ/A)/A,  ∂²H/∂b∂a = −(2 b aᵀ + a bᵀ + C I)/A² + 4C a aᵀ/A³,
///
/// ∂²H/∂a² = −(B I + b bᵀ)/A² + (4B a aᵀ + 4C (a bᵀ + b aᵀ) + 2C² I)/A³ − 12 C² a aᵀ/A⁴.
///
/// Source: Gerstmayr & Irschik (2008), the material measure of curvature.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bend {
    a: Vector3<f64>,
    b: Vector3<f64>,
    /// ∂H/∂a, ∂H/∂b.
    pub gradient: [Vector3<f64>; 2],
}

impl Bend {
    /// From a = r′ and b = r″.
    pub fn new(a: Vector3<f64>, b: Vector3<f64>) -> Self {
        let (aa, ab) = (a.dot(&a), a.dot(&b));
        let n = b - a * (ab / aa);
        let gradient = [-(a * n.dot(&n) + n * ab) / (aa * aa), n / aa];
        Self { a, b, gradient }
    }

    /// κ.
    pub fn curvature(&self) -> Vector3<f64> {
        self.a.cross(&self.b) / self.a.dot(&self.a)
    }

    /// K².
    pub fn square(&self) -> f64 {
        self.curvature().norm_squared()
    }

    /// dH/dt for the rates of a and b.
    pub fn rate(&self, rates: &[Vector3<f64>; 2]) -> f64 {
        self.gradient[0].dot(&rates[0]) + self.gradient[1].dot(&rates[1])
    }

    /// ∂²H.
    pub fn hessian(&self) -> Blocks {
        let (a, b) = (&self.a, &self.b);
        let (aa, bb, ab) = (a.dot(a), b.dot(b), a.dot(b));
        let (a_a, a_b, b_b) = (a * a.transpose(), a * b.transpose(), b * b.transpose());
        let b_a = a_b.transpose();
        let (aa2, aa3) = (aa * aa, aa * aa * aa);
        let identity = Matrix3::identity();
        Blocks {
            aa: -(identity * (bb - 2.0 * ab * ab / aa) + b_b) / aa2
                + (a_a * (4.0 * bb - 12.0 * ab * ab / aa) + (a_b + b_a) * (4.0 * ab)) / aa3,
            ba: (a_a * (4.0 * ab / aa) - b_a * 2.0 - a_b - identity * ab) / aa2,
            bb: (identity - a_a / aa) / aa,
        }
    }
}

/// A symmetric matrix over the vectors a and b: block ba has the rows of b.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blocks {
    pub aa: Matrix3<f64>,
    pub ba: Matrix3<f64>,
    pub bb: Matrix3<f64>,
}

impl Blocks {
    /// Times a number.
    pub fn scaled(self, factor: f64) -> Self {
        Self { aa: self.aa * factor, ba: self.ba * factor, bb: self.bb * factor }
    }

    /// Times vectors.
    pub fn times(&self, x: &[Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
        [self.aa * x[0] + self.ba.transpose() * x[1], self.ba * x[0] + self.bb * x[1]]
    }

    /// Plus x yᵀ + y xᵀ.
    pub fn plus_products(self, x: &[Vector3<f64>; 2], y: &[Vector3<f64>; 2]) -> Self {
        let both = |i: usize, j: usize| x[i] * y[j].transpose() + y[i] * x[j].transpose();
        Self { aa: self.aa + both(0, 0), ba: self.ba + both(1, 0), bb: self.bb + both(1, 1) }
    }
}
