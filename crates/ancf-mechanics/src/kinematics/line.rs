use nalgebra::{Matrix3, Vector3};

/// Stretch of a material line at one point.
///
/// With a = r′ = a₀ + u, |a₀| = 1: ε = |a| − 1 = (2 a₀·u + u·u) / (|a| + 1), without cancellation for small u;
/// ∂ε/∂a = t = a/|a|, ∂²ε/∂a² = (I − t tᵀ)/|a|.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxialStretch {
    /// Axial strain ε.
    pub strain: f64,
    /// Length |a|.
    pub length: f64,
    /// Tangent t.
    pub tangent: Vector3<f64>,
}

impl AxialStretch {
    /// Creates the stretch from the reference direction a₀, a unit vector, and the displacement gradient u.
    pub fn new(reference: &Vector3<f64>, u: &Vector3<f64>) -> Self {
        let a = reference + u;
        let length = a.norm();
        let strain = (2.0 * reference.dot(u) + u.dot(u)) / (length + 1.0);
        Self { strain, length, tangent: a / length }
    }

    /// Computes c ∂ε/∂a (∂ε/∂a)ᵀ + n ∂²ε/∂a².
    pub fn stiffness(&self, c: f64, n: f64) -> Matrix3<f64> {
        let n = n / self.length;
        self.tangent * self.tangent.transpose() * (c - n) + Matrix3::from_diagonal_element(n)
    }
}

/// Bending of a material line at one point: the material measure of curvature with its derivatives.
///
/// With a = r′, b = r″, A = a·a, B = b·b, C = a·b, t = a/|a| and n = b − (C/A) a:
///
/// β = n/|a| = κ × t,  κ = a × b/A = t × β,  K = |κ| = |β|, the rotation of the tangent per *reference* length,
///
/// all smooth for a ≠ 0. In a frame that follows the tangent without spin about it, β has the rate
///
/// β° = (ḃ − a (a·ḃ)/A − C ȧ/A − b (a·ȧ)/A + 2C (a·ȧ) a/A²)/|a| = L (ȧ, ḃ).
///
/// A moment with the components m normal to t thus has the power m·β° and the forces Lᵀm on a and b,
///
/// Lᵀm = (−(C m + (b·m) a)/|a|³, m/|a|).
///
/// Source: Gerstmayr & Irschik (2008), the material measure of curvature.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    a: Vector3<f64>,
    b: Vector3<f64>,
    /// Products A and C.
    aa: f64,
    ab: f64,
    length: f64,
}

impl Bend {
    /// Creates the bending from a = r′ and b = r″.
    pub fn new(a: Vector3<f64>, b: Vector3<f64>) -> Self {
        let aa = a.dot(&a);
        Self { a, b, aa, ab: a.dot(&b), length: aa.sqrt() }
    }

    /// Returns β.
    pub fn strain(&self) -> Vector3<f64> {
        (self.b - self.a * (self.ab / self.aa)) / self.length
    }

    /// Returns β° for the rates of a and b.
    pub fn rate(&self, [da, db]: &[Vector3<f64>; 2]) -> Vector3<f64> {
        let (along_a, along_b) = (self.a.dot(da) / self.aa, self.a.dot(db) / self.aa);
        let part = self.ab / self.aa;
        (db - da * part - self.b * along_a - self.a * (along_b - 2.0 * part * along_a)) / self.length
    }

    /// Returns t × x, which maps normal components to a moment or a curvature vector.
    pub fn turned(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.a.cross(x) / self.length
    }

    /// Returns Lᵀm for m normal to t.
    pub fn force(&self, m: &Vector3<f64>) -> [Vector3<f64>; 2] {
        [-(m * self.ab + self.a * self.b.dot(m)) / (self.aa * self.length), m / self.length]
    }

    /// Returns the second derivative of ½K² = ½ (AB − C²)/A², the derivative of Lᵀβ:
    ///
    /// by b, b: (I − a aᵀ/A)/A;  by b, a: −(2 b aᵀ + a bᵀ + C I)/A² + 4C a aᵀ/A³;
    ///
    /// by a, a: −(B I + b bᵀ)/A² + (4B a aᵀ + 4C (a bᵀ + b aᵀ) + 2C² I)/A³ − 12 C² a aᵀ/A⁴.
    pub fn hessian(&self) -> BendBlocks {
        let (a, b, aa, ab) = (&self.a, &self.b, self.aa, self.ab);
        let bb = b.dot(b);
        let (a_a, a_b, b_b) = (a * a.transpose(), a * b.transpose(), b * b.transpose());
        let b_a = a_b.transpose();
        let (aa2, aa3) = (aa * aa, aa * aa * aa);
        let identity = Matrix3::identity();
        BendBlocks {
            aa: -(identity * (bb - 2.0 * ab * ab / aa) + b_b) / aa2
                + (a_a * (4.0 * bb - 12.0 * ab * ab / aa) + (a_b + b_a) * (4.0 * ab)) / aa3,
            ba: (a_a * (4.0 * ab / aa) - b_a * 2.0 - a_b - identity * ab) / aa2,
            bb: (identity - a_a / aa) / aa,
        }
    }

    /// Returns the second derivative of m·β at constant m normal to the tangent, m·a = 0:
    ///
    /// by b, a: −(m aᵀ + a mᵀ)/|a|³;
    ///
    /// by a, a: −((m·b) I + b mᵀ + m bᵀ)/|a|³ + 3 ((m·b) a aᵀ + C (m aᵀ + a mᵀ))/|a|⁵.
    pub fn stress_stiffness(&self, m: &Vector3<f64>) -> BendBlocks {
        let (a, b, cube) = (&self.a, &self.b, self.aa * self.length);
        let (m_a, m_b, work) = (m * a.transpose(), m * b.transpose(), m.dot(b));
        let m_a = m_a + m_a.transpose();
        BendBlocks {
            aa: -(Matrix3::from_diagonal_element(work) + m_b + m_b.transpose()) / cube
                + (a * a.transpose() * work + m_a * self.ab) * (3.0 / (self.aa * cube)),
            ba: -m_a / cube,
            bb: Matrix3::zeros(),
        }
    }

    /// Returns LᵀL.
    pub fn damping(&self) -> BendBlocks {
        let [of_a, of_b] = self.operator();
        BendBlocks { aa: of_a.transpose() * of_a, ba: of_b.transpose() * of_a, bb: of_b.transpose() * of_b }
    }

    /// Returns the blocks of L for a and for b.
    fn operator(&self) -> [Matrix3<f64>; 2] {
        let (a, aa) = (&self.a, self.aa);
        let part = self.ab / aa;
        let of_a = (a * (2.0 * part) - self.b) * a.transpose() / aa - Matrix3::from_diagonal_element(part);
        let of_b = Matrix3::identity() - a * a.transpose() / aa;
        [of_a / self.length, of_b / self.length]
    }
}

/// Symmetric matrix over the vectors a and b. Block ba has the rows of b.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BendBlocks {
    pub aa: Matrix3<f64>,
    pub ba: Matrix3<f64>,
    pub bb: Matrix3<f64>,
}

impl BendBlocks {
    /// Multiplies the blocks by a number.
    pub fn scaled(self, factor: f64) -> Self {
        Self { aa: self.aa * factor, ba: self.ba * factor, bb: self.bb * factor }
    }

    /// Adds a multiple of other blocks.
    pub fn plus(self, other: Self, factor: f64) -> Self {
        Self {
            aa: self.aa + other.aa * factor,
            ba: self.ba + other.ba * factor,
            bb: self.bb + other.bb * factor,
        }
    }
}
