use nalgebra::{Matrix3, Vector3};

/// Lamé's constants of an isotropic material, force/area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lame {
    /// First constant λ.
    pub lambda: f64,
    /// Shear modulus G.
    pub shear: f64,
}

impl Lame {
    /// Young's modulus E = G (3λ + 2G)/(λ + G).
    pub fn young(&self) -> f64 {
        self.shear * (3.0 * self.lambda + 2.0 * self.shear) / (self.lambda + self.shear)
    }
}

/// The vectors that make up the deformation of a cross-section, or increments of them.
///
/// J(y, z) = [a + y b + z c, d, e] with a = r_x on the axis, b = ∂r_y/∂x, c = ∂r_z/∂x, d = r_y, e = r_z. The sixth, h, is
/// the quadratic part of a within an element, which only the linked formulation reads (see [`BeamShape`](super::BeamShape)).
pub type Directors = [Vector3<f64>; 6];

/// Pairs of directors whose products make the section strains; ½ of the product for the first five.
const PAIRS: [(usize, usize); 17] = [
    (0, 0),
    (1, 1),
    (2, 2),
    (3, 3),
    (4, 4), // aa bb cc dd ee
    (0, 1),
    (0, 2),
    (1, 2),
    (0, 3),
    (1, 3),
    (2, 3),
    (0, 4),
    (1, 4),
    (2, 4),
    (3, 4), // ab ac bc ad bd cd ae be ce de
    (3, 5),
    (4, 5), // dh eh
];
/// How many of the pairs are equal ones.
const EQUAL: usize = 5;

/// Section strains by the pair of directors that they belong to.
pub(super) type Strains = [f64; 17];

/// Names of the places in [`Strains`].
pub(super) mod strain {
    pub(in crate::mechanics) const AA: usize = 0;
    pub(in crate::mechanics) const BB: usize = 1;
    pub(in crate::mechanics) const CC: usize = 2;
    pub(in crate::mechanics) const DD: usize = 3;
    pub(in crate::mechanics) const EE: usize = 4;
    pub(in crate::mechanics) const AB: usize = 5;
    pub(in crate::mechanics) const AC: usize = 6;
    pub(in crate::mechanics) const BC: usize = 7;
    pub(in crate::mechanics) const AD: usize = 8;
    pub(in crate::mechanics) const BD: usize = 9;
    pub(in crate::mechanics) const CD: usize = 10;
    pub(in crate::mechanics) const AE: usize = 11;
    pub(in crate::mechanics) const BE: usize = 12;
    pub(in crate::mechanics) const CE: usize = 13;
    pub(in crate::mechanics) const DE: usize = 14;
    pub(in crate::mechanics) const DH: usize = 15;
    pub(in crate::mechanics) const EH: usize = 16;
}

/// Elasticity of a cross-section as a quadratic form ½ εᵀ D ε in the products of directors.
///
/// With g = (a, b, c, d, e, h), the Green-Lagrange strains are combinations of the *section strains*
/// ε_αα = ½(g_α·g_α − g⁰_α·g⁰_α) and ε_αβ = g_α·g_β − g⁰_α·g⁰_β:
///
/// E₁₁ = ε_aa + y ε_ab + z ε_ac + y² ε_bb + yz ε_bc + z² ε_cc,  E₂₂ = ε_dd,  E₃₃ = ε_ee,
/// 2E₁₂ = ε_ad + y ε_bd + z ε_cd,  2E₁₃ = ε_ae + y ε_be + z ε_ce,  2E₂₃ = ε_de,
///
/// so that any energy quadratic in them, integrated over the section, is ½ εᵀ D ε; what D is, the formulations say
/// ([`SectionLaw::continuum`], [`SectionLaw::enhanced`]).
///
/// Units: D force·lengthᵏ; energies per length of the axis.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionLaw {
    /// Entries (k, l, D_kl) that are not zero, with k ≥ l.
    entries: Vec<(usize, usize, f64)>,
}

impl SectionLaw {
    /// The law of a symmetric matrix D; entries that are rounding errors of zero are left out.
    pub(super) fn new(d: &[[f64; 17]; 17]) -> Self {
        let lower = (0..17).flat_map(|k| (0..=k).map(move |l| (k, l, d[k][l])));
        let counts = |&(k, l, entry): &(usize, usize, f64)| {
            entry.abs() > 1e-15 * (d[k][k] * d[l][l]).abs().sqrt() && entry != 0.0
        };
        Self { entries: lower.filter(counts).collect() }
    }

    /// D_kl.
    pub(super) fn entry(&self, k: usize, l: usize) -> f64 {
        let (k, l) = (k.max(l), k.min(l));
        self.entries.iter().find(|entry| (entry.0, entry.1) == (k, l)).map_or(0.0, |entry| entry.2)
    }

    /// The same law, `factor` times as stiff.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self { entries: self.entries.iter().map(|&(k, l, d)| (k, l, factor * d)).collect() }
    }

    /// The entries between the given strains.
    pub(super) fn among(&self, strains: &[usize]) -> Self {
        let inside = |(k, l, _): &(usize, usize, f64)| strains.contains(k) && strains.contains(l);
        Self { entries: self.entries.iter().copied().filter(inside).collect() }
    }

    /// The sum of two laws.
    pub(super) fn plus(&self, other: &Self) -> Self {
        Self::new(&std::array::from_fn(|k| std::array::from_fn(|l| self.entry(k, l) + other.entry(k, l))))
    }

    /// The difference of two laws.
    pub(super) fn minus(&self, other: &Self) -> Self {
        Self::new(&std::array::from_fn(|k| std::array::from_fn(|l| self.entry(k, l) - other.entry(k, l))))
    }

    /// Section strains of the increment u from the reference directors g0, without cancellation:
    /// g_α·g_β − g⁰_α·g⁰_β = g⁰_α·u_β + u_α·g⁰_β + u_α·u_β.
    pub(super) fn strains(g0: &Directors, u: &Directors) -> Strains {
        let mut strains = [0.0; 17];
        for (k, (strain, (i, j))) in strains.iter_mut().zip(PAIRS).enumerate() {
            *strain = if k < EQUAL {
                g0[i].dot(&u[i]) + 0.5 * u[i].dot(&u[i])
            } else {
                g0[i].dot(&u[j]) + u[i].dot(&g0[j]) + u[i].dot(&u[j])
            };
        }
        strains
    }

    /// Rates of the section strains of the directors g moving with v.
    pub(super) fn rates(g: &Directors, v: &Directors) -> Strains {
        std::array::from_fn(|k| {
            let (i, j) = PAIRS[k];
            if k < EQUAL { g[i].dot(&v[i]) } else { g[i].dot(&v[j]) + v[i].dot(&g[j]) }
        })
    }

    /// Stress resultants n = D ε.
    pub(super) fn resultants(&self, strains: &Strains) -> Strains {
        let mut n = [0.0; 17];
        for &(k, l, d) in &self.entries {
            n[k] += d * strains[l];
            if k != l {
                n[l] += d * strains[k];
            }
        }
        n
    }

    /// Strain energy per length of the increment u from the reference directors g0.
    pub fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        let strains = Self::strains(g0, u);
        0.5 * self.resultants(&strains).iter().zip(&strains).map(|(n, e)| n * e).sum::<f64>()
    }

    /// Derivative of the energy by the directors: p_α = Σ_β N_αβ g_β.
    pub fn forces(&self, g0: &Directors, u: &Directors) -> Directors {
        Self::of_resultants(&self.resultants(&Self::strains(g0, u)), &sum(g0, u))
    }

    /// Σ_k n_k ∂ε_k/∂g_α.
    pub(super) fn of_resultants(n: &Strains, g: &Directors) -> Directors {
        let mut p = [Vector3::zeros(); 6];
        for (k, &(i, j)) in PAIRS.iter().enumerate() {
            p[i] += g[j] * n[k];
            if k >= EQUAL {
                p[j] += g[i] * n[k];
            }
        }
        p
    }

    /// Adds `factor` times the second derivative of the energy by the directors, blocks H_αβ with α ≥ β.
    pub fn add_stiffness(&self, g0: &Directors, u: &Directors, factor: f64, h: &mut Stiffness) {
        let (n, g) = (self.resultants(&Self::strains(g0, u)), sum(g0, u));
        Self::add_geometric(&n, factor, h);
        self.add_products(&g, &g, factor, h);
    }

    /// Adds the stiffness Σ_k n_k ∂²ε_k of the stresses n = D ∂ε/∂g `du` that an increment of the directors causes in first
    /// order.
    pub fn add_stress_stiffness(&self, g0: &Directors, u: &Directors, du: &Directors, h: &mut Stiffness) {
        Self::add_geometric(&self.resultants(&Self::rates(&sum(g0, u), du)), 1.0, h);
    }

    /// Adds `factor` Σ_k n_k ∂²ε_k.
    pub(super) fn add_geometric(n: &Strains, factor: f64, h: &mut Stiffness) {
        for (n, &(i, j)) in n.iter().zip(&PAIRS) {
            for axis in 0..3 {
                h[j][i][(axis, axis)] += factor * n;
            }
        }
    }

    /// Adds `factor` Σ_k≥l D_kl ∂ε_k(g) ⊗ ∂ε_l(f), made symmetric, where ∂ε(g) are the derivatives at directors g.
    ///
    /// With f = g this is Bᵀ D B; half of it and half of it with f and g exchanged is the symmetric part of B(g)ᵀ D B(f).
    pub(super) fn add_products(&self, g: &Directors, f: &Directors, factor: f64, h: &mut Stiffness) {
        for &(k, l, d) in &self.entries {
            // Both orders of (α, β) are added, so that equal strains come twice.
            let d = if k == l { 0.5 * factor * d } else { factor * d };
            for (i, x) in gradient(k, g) {
                let x = x * d;
                for (j, y) in gradient(l, f) {
                    add_symmetric(i, j, &x, &y, h);
                }
            }
        }
    }

    /// A bound of the rounding error of [`forces`](Self::forces), given bounds `du` of the errors in u.
    ///
    /// Returns one number per director, for each of its components.
    pub fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; 6]) -> [f64; 6] {
        let size: [f64; 6] = std::array::from_fn(|i| (g0[i] + u[i]).norm());
        let moved: [f64; 6] = std::array::from_fn(|i| du[i] + f64::EPSILON * u[i].norm());
        let n = self.resultants(&Self::strains(g0, u));
        let mut dn = [0.0; 17];
        let error: Strains = std::array::from_fn(|k| {
            let (i, j) = PAIRS[k];
            if k < EQUAL { size[i] * moved[i] } else { size[i] * moved[j] + moved[i] * size[j] }
        });
        for &(k, l, d) in &self.entries {
            dn[k] += d.abs() * error[l];
            if k != l {
                dn[l] += d.abs() * error[k];
            }
        }
        let mut p = [0.0; 6];
        for (k, &(i, j)) in PAIRS.iter().enumerate() {
            p[i] += dn[k] * size[j] + n[k].abs() * (moved[j] + f64::EPSILON * size[j]);
            if k >= EQUAL {
                p[j] += dn[k] * size[i] + n[k].abs() * (moved[i] + f64::EPSILON * size[i]);
            }
        }
        p
    }
}

/// Second derivatives by the directors: blocks H_αβ, of which those with α ≥ β count.
pub type Stiffness = [[Matrix3<f64>; 6]; 6];

/// The derivatives ∂ε_k/∂g_α that are not zero.
fn gradient(k: usize, g: &Directors) -> impl Iterator<Item = (usize, Vector3<f64>)> {
    let (i, j) = PAIRS[k];
    [(i, g[j]), (j, g[i])].into_iter().take(if k < EQUAL { 1 } else { 2 })
}

/// Adds x yᵀ at (i, j) and y xᵀ at (j, i), of which the lower blocks are kept; both, if i = j.
fn add_symmetric(i: usize, j: usize, x: &Vector3<f64>, y: &Vector3<f64>, h: &mut Stiffness) {
    if i == j {
        h[i][i] += x * y.transpose() + y * x.transpose();
    } else if i > j {
        h[i][j] += x * y.transpose();
    } else {
        h[j][i] += y * x.transpose();
    }
}

/// Reference directors plus increments.
pub(super) fn sum(g0: &Directors, u: &Directors) -> Directors {
    std::array::from_fn(|i| g0[i] + u[i])
}
