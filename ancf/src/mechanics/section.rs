use nalgebra::{Matrix3, Vector3};

/// Lamé's constants of an isotropic material, force/area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lame {
    /// First constant λ.
    pub lambda: f64,
    /// Shear modulus G.
    pub shear: f64,
}

/// Moments ∫ yⁱ zʲ dA of a cross-section about its principal axes; odd ones vanish by symmetry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Area A.
    pub area: f64,
    /// ∫ y² dA.
    pub yy: f64,
    /// ∫ z² dA.
    pub zz: f64,
    /// ∫ y⁴ dA.
    pub yyyy: f64,
    /// ∫ y² z² dA.
    pub yyzz: f64,
    /// ∫ z⁴ dA.
    pub zzzz: f64,
}

/// The five vectors that make up the deformation gradient of a cross-section, or increments of them.
///
/// J(y, z) = [a + y b + z c, d, e] with a = r_x on the axis, b = ∂r_y/∂x, c = ∂r_z/∂x, d = r_y, e = r_z.
pub type Directors = [Vector3<f64>; 5];

/// Pairs of different directors, in the order of the mixed strains.
const MIXED: [(usize, usize); 10] =
    [(0, 1), (0, 2), (1, 2), (0, 3), (1, 3), (2, 3), (0, 4), (1, 4), (2, 4), (3, 4)];

/// St. Venant-Kirchhoff elasticity integrated over a cross-section: a quadratic form in the products of directors.
///
/// With g = (a, b, c, d, e), the Green-Lagrange strains are combinations of the *section strains*
/// ε_αα = ½(g_α·g_α − g⁰_α·g⁰_α) and ε_αβ = g_α·g_β − g⁰_α·g⁰_β:
///
/// E₁₁ = ε_aa + y ε_ab + z ε_ac + y² ε_bb + yz ε_bc + z² ε_cc,  E₂₂ = ε_dd,  E₃₃ = ε_ee,
/// 2E₁₂ = ε_ad + y ε_bd + z ε_cd,  2E₁₃ = ε_ae + y ε_be + z ε_ce,  2E₂₃ = ε_de,
///
/// so that ½∫(λ tr² E + 2G E:E) dA is exactly ½ εᵀ D ε with D made of moments of area up to the fourth degree.
/// D couples the five equal pairs with one another and leaves the ten mixed pairs uncoupled.
///
/// Units: D force·lengthᵏ; energies per length of the axis.
/// Source: the energy of Kim et al. (2017), eqs (26)-(31), with the factors missing in (27), (28) restored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionLaw {
    equal: [[f64; 5]; 5],
    mixed: [f64; 10],
}

/// Stress resultants: the derivative of the energy by the section strains.
struct Resultants {
    equal: [f64; 5],
    mixed: [f64; 10],
}

impl SectionLaw {
    /// The law of a full section of one material.
    pub fn new(material: Lame, m: Moments) -> Self {
        let Lame { lambda: l, shear: g } = material;
        let p = l + 2.0 * g;
        let equal = [
            [p * m.area, p * m.yy, p * m.zz, l * m.area, l * m.area],
            [p * m.yy, p * m.yyyy, p * m.yyzz, l * m.yy, l * m.yy],
            [p * m.zz, p * m.yyzz, p * m.zzzz, l * m.zz, l * m.zz],
            [l * m.area, l * m.yy, l * m.zz, p * m.area, l * m.area],
            [l * m.area, l * m.yy, l * m.zz, l * m.area, p * m.area],
        ];
        let (axial, shear) = ([p * m.yy, p * m.zz, p * m.yyzz], [g * m.area, g * m.yy, g * m.zz]);
        let [ab, ac, bc] = axial;
        let [ad, bd, cd] = shear;
        Self { equal, mixed: [ab, ac, bc, ad, bd, cd, ad, bd, cd, ad] }
    }

    /// Section strains of the increment u from the reference directors g0, without cancellation:
    /// g_α·g_β − g⁰_α·g⁰_β = g⁰_α·u_β + u_α·g⁰_β + u_α·u_β.
    fn strains(g0: &Directors, u: &Directors) -> ([f64; 5], [f64; 10]) {
        let equal = std::array::from_fn(|i| g0[i].dot(&u[i]) + 0.5 * u[i].dot(&u[i]));
        let mut mixed = [0.0; 10];
        for (strain, (i, j)) in mixed.iter_mut().zip(MIXED) {
            *strain = g0[i].dot(&u[j]) + u[i].dot(&g0[j]) + u[i].dot(&u[j]);
        }
        (equal, mixed)
    }

    fn resultants(&self, (equal, mixed): ([f64; 5], [f64; 10])) -> Resultants {
        let mut n = Resultants { equal: [0.0; 5], mixed: [0.0; 10] };
        for i in 0..5 {
            for j in 0..5 {
                n.equal[i] += self.equal[i][j] * equal[j];
            }
        }
        for k in 0..10 {
            n.mixed[k] = self.mixed[k] * mixed[k];
        }
        n
    }

    /// Strain energy per length of the increment u from the reference directors g0.
    pub fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        let strains = Self::strains(g0, u);
        let n = self.resultants(strains);
        let equal: f64 = n.equal.iter().zip(&strains.0).map(|(n, e)| n * e).sum();
        let mixed: f64 = n.mixed.iter().zip(&strains.1).map(|(n, e)| n * e).sum();
        0.5 * (equal + mixed)
    }

    /// Derivative of the energy by the directors: p_α = Σ_β N_αβ g_β.
    pub fn forces(&self, g0: &Directors, u: &Directors) -> Directors {
        let n = self.resultants(Self::strains(g0, u));
        let g: Directors = std::array::from_fn(|i| g0[i] + u[i]);
        let mut p: Directors = std::array::from_fn(|i| g[i] * n.equal[i]);
        for (&(i, j), n) in MIXED.iter().zip(n.mixed) {
            p[i] += g[j] * n;
            p[j] += g[i] * n;
        }
        p
    }

    /// Second derivative of the energy by the directors: blocks H_αβ, of which those with α ≥ β are computed.
    ///
    /// H_αβ = N_αβ I + D_αβ g_α g_βᵀ from the equal pairs; a mixed pair (α, β) adds D g_β g_βᵀ to H_αα,
    /// D g_α g_αᵀ to H_ββ and D g_α g_βᵀ to H_βα.
    pub fn stiffness(&self, g0: &Directors, u: &Directors) -> [[Matrix3<f64>; 5]; 5] {
        let n = self.resultants(Self::strains(g0, u));
        let g: Directors = std::array::from_fn(|i| g0[i] + u[i]);
        let squares: [Matrix3<f64>; 5] = std::array::from_fn(|i| g[i] * g[i].transpose());
        let mut h = [[Matrix3::zeros(); 5]; 5];
        for i in 0..5 {
            h[i][i] = Matrix3::from_diagonal_element(n.equal[i]) + squares[i] * self.equal[i][i];
            for j in 0..i {
                h[i][j] = g[i] * (g[j] * self.equal[i][j]).transpose();
            }
        }
        for (k, &(i, j)) in MIXED.iter().enumerate() {
            let d = self.mixed[k];
            h[i][i] += squares[j] * d;
            h[j][j] += squares[i] * d;
            h[j][i] += g[i] * (g[j] * d).transpose() + Matrix3::from_diagonal_element(n.mixed[k]);
        }
        h
    }

    /// A bound of the rounding error of [`forces`](Self::forces), given bounds `du` of the errors in u.
    ///
    /// Returns one number per director, for each of its components.
    pub fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; 5]) -> [f64; 5] {
        let size: [f64; 5] = std::array::from_fn(|i| (g0[i] + u[i]).norm());
        let moved: [f64; 5] = std::array::from_fn(|i| du[i] + f64::EPSILON * u[i].norm());
        let n = self.resultants(Self::strains(g0, u));
        let error = |i: usize, j: usize| size[i] * moved[j] + moved[i] * size[j];
        let equal: [f64; 5] = std::array::from_fn(|i| error(i, i));
        let mut p = [0.0; 5];
        for i in 0..5 {
            let dn: f64 = (0..5).map(|j| self.equal[i][j].abs() * equal[j]).sum();
            p[i] += dn * size[i] + n.equal[i].abs() * (moved[i] + f64::EPSILON * size[i]);
        }
        for (k, &(i, j)) in MIXED.iter().enumerate() {
            let (dn, n) = (self.mixed[k].abs() * error(i, j), n.mixed[k].abs());
            p[i] += dn * size[j] + n * (moved[j] + f64::EPSILON * size[j]);
            p[j] += dn * size[i] + n * (moved[i] + f64::EPSILON * size[i]);
        }
        p
    }
}
