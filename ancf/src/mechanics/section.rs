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
/// J(y, z) = [a + y b + z c, d, e] with a = r_x on the axis, b = ∂r_y/∂x, c = ∂r_z/∂x, d = r_y, e = r_z. The others say
/// how a varies along an element, whatever the section: h is the coefficient of its highest power of ξ, and
/// k = a(1) − a(0). Strains that vary along an element more than they should are mended by them
/// ([`Formulation`](super::Formulation)).
pub type Directors = [Vector3<f64>; DIRECTORS];

/// Number of directors.
pub(super) const DIRECTORS: usize = 7;

/// Number of section strains.
pub(super) const STRAINS: usize = 20;

/// Pairs of directors whose products make the section strains; ½ of the product for the equal ones.
const PAIRS: [(usize, usize); STRAINS] = [
    (0, 0),
    (1, 1),
    (2, 2),
    (3, 3),
    (4, 4),
    (5, 5), // aa bb cc dd ee hh
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
    (4, 5),
    (1, 6),
    (2, 6), // dh eh bk ck
];
/// How many of the pairs are equal ones.
const EQUAL: usize = 6;

/// Section strains by the pair of directors that they belong to.
pub(super) type Strains = [f64; STRAINS];

/// Names of the places in [`Strains`].
pub(super) mod strain {
    pub(in crate::mechanics) const AA: usize = 0;
    pub(in crate::mechanics) const BB: usize = 1;
    pub(in crate::mechanics) const CC: usize = 2;
    pub(in crate::mechanics) const DD: usize = 3;
    pub(in crate::mechanics) const EE: usize = 4;
    pub(in crate::mechanics) const HH: usize = 5;
    pub(in crate::mechanics) const AB: usize = 6;
    pub(in crate::mechanics) const AC: usize = 7;
    pub(in crate::mechanics) const BC: usize = 8;
    pub(in crate::mechanics) const AD: usize = 9;
    pub(in crate::mechanics) const BD: usize = 10;
    pub(in crate::mechanics) const CD: usize = 11;
    pub(in crate::mechanics) const AE: usize = 12;
    pub(in crate::mechanics) const BE: usize = 13;
    pub(in crate::mechanics) const CE: usize = 14;
    pub(in crate::mechanics) const DE: usize = 15;
    pub(in crate::mechanics) const DH: usize = 16;
    pub(in crate::mechanics) const EH: usize = 17;
    pub(in crate::mechanics) const BK: usize = 18;
    pub(in crate::mechanics) const CK: usize = 19;
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
    /// The strains that have entries.
    used: Vec<usize>,
}

/// D over the section strains.
pub(super) type Form = [[f64; STRAINS]; STRAINS];

impl SectionLaw {
    /// The law of a symmetric matrix D; entries that are rounding errors of zero are left out.
    pub(super) fn new(d: &Form) -> Self {
        let lower = (0..STRAINS).flat_map(|k| (0..=k).map(move |l| (k, l, d[k][l])));
        let counts = |&(k, l, entry): &(usize, usize, f64)| {
            entry.abs() > 1e-14 * (d[k][k] * d[l][l]).abs().sqrt() && entry != 0.0
        };
        let entries: Vec<_> = lower.filter(counts).collect();
        let used = (0..STRAINS).filter(|&strain| entries.iter().any(|&(k, l, _)| k == strain || l == strain));
        Self { used: used.collect(), entries }
    }

    /// D.
    pub(super) fn form(&self) -> Form {
        let mut d = [[0.0; STRAINS]; STRAINS];
        for &(k, l, entry) in &self.entries {
            d[k][l] = entry;
            d[l][k] = entry;
        }
        d
    }

    /// The same law, `factor` times as stiff.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        let entries = self.entries.iter().map(|&(k, l, d)| (k, l, factor * d)).collect();
        Self { entries, used: self.used.clone() }
    }

    /// The sum of two laws.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (mut d, more) = (self.form(), other.form());
        d.iter_mut().flatten().zip(more.iter().flatten()).for_each(|(d, more)| *d += more);
        Self::new(&d)
    }

    /// Whether it depends on a director.
    pub(super) fn reads(&self, director: usize) -> bool {
        self.used.iter().any(|&k| PAIRS[k].0 == director || PAIRS[k].1 == director)
    }

    /// Section strains of the increment u from the reference directors g0, without cancellation:
    /// g_α·g_β − g⁰_α·g⁰_β = g⁰_α·u_β + u_α·g⁰_β + u_α·u_β. Those without stiffness are left at zero.
    fn strains(&self, g0: &Directors, u: &Directors) -> Strains {
        let mut strains = [0.0; STRAINS];
        for &k in &self.used {
            let (i, j) = PAIRS[k];
            strains[k] = if k < EQUAL {
                (g0[i] + u[i] * 0.5).dot(&u[i])
            } else {
                (g0[i] + u[i]).dot(&u[j]) + u[i].dot(&g0[j])
            };
        }
        strains
    }

    /// Rates of the section strains of the directors g moving with v.
    fn rates(&self, g: &Directors, v: &Directors) -> Strains {
        let mut rates = [0.0; STRAINS];
        for &k in &self.used {
            let (i, j) = PAIRS[k];
            rates[k] = if k < EQUAL { g[i].dot(&v[i]) } else { g[i].dot(&v[j]) + v[i].dot(&g[j]) };
        }
        rates
    }

    /// Stress resultants n = D ε.
    fn resultants(&self, strains: &Strains) -> Strains {
        let mut n = [0.0; STRAINS];
        for &(k, l, d) in &self.entries {
            n[k] += d * strains[l];
            if k != l {
                n[l] += d * strains[k];
            }
        }
        n
    }

    /// Resultants of the rates of strain, for a law of viscosity.
    pub(super) fn viscous(&self, g: &Directors, v: &Directors) -> Strains {
        self.resultants(&self.rates(g, v))
    }

    /// Strain energy per length of the increment u from the reference directors g0.
    pub fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        let strains = self.strains(g0, u);
        0.5 * self.resultants(&strains).iter().zip(&strains).map(|(n, e)| n * e).sum::<f64>()
    }

    /// Derivative of the energy by the directors: p_α = Σ_β N_αβ g_β.
    pub fn forces(&self, g0: &Directors, u: &Directors) -> Directors {
        self.of_resultants(&self.resultants(&self.strains(g0, u)), &sum(g0, u))
    }

    /// Σ_k n_k ∂ε_k/∂g_α.
    pub(super) fn of_resultants(&self, n: &Strains, g: &Directors) -> Directors {
        let mut p = [Vector3::zeros(); DIRECTORS];
        for &k in &self.used {
            let (i, j) = PAIRS[k];
            p[i] += g[j] * n[k];
            if k >= EQUAL {
                p[j] += g[i] * n[k];
            }
        }
        p
    }

    /// Adds `factor` times the second derivative of the energy by the directors, blocks H_αβ with α ≥ β.
    pub fn add_stiffness(&self, g0: &Directors, u: &Directors, factor: f64, h: &mut Stiffness) {
        let (n, g) = (self.resultants(&self.strains(g0, u)), sum(g0, u));
        self.add_geometric(&n, factor, h);
        self.add_products(&g, &g, factor, h);
    }

    /// Adds `factor` Σ_k n_k ∂²ε_k.
    pub(super) fn add_geometric(&self, n: &Strains, factor: f64, h: &mut Stiffness) {
        for &k in &self.used {
            let (i, j) = PAIRS[k];
            for axis in 0..3 {
                h[j][i][(axis, axis)] += factor * n[k];
            }
        }
    }

    /// Adds `factor` times the symmetric part of B(g)ᵀ D B(f), where B(g) are the derivatives ∂ε_k/∂g_α at directors g.
    ///
    /// With P_ij = ½(g_i f_jᵀ + f_i g_jᵀ), D_kl of the pairs k = (i, j) and l = (m, n) adds P_jn at (i, m), and so on for each
    /// order of each pair.
    pub(super) fn add_products(&self, g: &Directors, f: &Directors, factor: f64, h: &mut Stiffness) {
        let half = |i: usize, j: usize| g[i] * f[j].transpose() + f[i] * g[j].transpose();
        let p: Stiffness = std::array::from_fn(|i| std::array::from_fn(|j| half(i, j) * (0.5 * factor)));
        for &(k, l, d) in &self.entries {
            let ((i, j), (m, n)) = (PAIRS[k], PAIRS[l]);
            if k == l && k < EQUAL {
                h[i][i] += p[i][i] * d;
            } else if k == l {
                h[i][i] += p[j][j] * d;
                h[j][j] += p[i][i] * d;
                h[j][i] += p[i][j] * d;
            } else {
                let orders =
                    |k: usize, (i, j)| [(i, j), (j, i)].into_iter().take(if k < EQUAL { 1 } else { 2 });
                for (row, x) in orders(k, (i, j)) {
                    for (column, y) in orders(l, (m, n)) {
                        if row == column {
                            h[row][row] += (p[x][y] + p[y][x]) * d;
                        } else if row > column {
                            h[row][column] += p[x][y] * d;
                        } else {
                            h[column][row] += p[y][x] * d;
                        }
                    }
                }
            }
        }
    }

    /// A bound of the rounding error of [`forces`](Self::forces), given bounds `du` of the errors in u.
    ///
    /// Returns one number per director, for each of its components.
    pub fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; DIRECTORS]) -> [f64; DIRECTORS] {
        let size: [f64; DIRECTORS] = std::array::from_fn(|i| (g0[i] + u[i]).norm());
        let moved: [f64; DIRECTORS] = std::array::from_fn(|i| du[i] + f64::EPSILON * u[i].norm());
        let n = self.resultants(&self.strains(g0, u));
        let mut dn = [0.0; STRAINS];
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
        let mut p = [0.0; DIRECTORS];
        for &k in &self.used {
            let (i, j) = PAIRS[k];
            p[i] += dn[k] * size[j] + n[k].abs() * (moved[j] + f64::EPSILON * size[j]);
            if k >= EQUAL {
                p[j] += dn[k] * size[i] + n[k].abs() * (moved[i] + f64::EPSILON * size[i]);
            }
        }
        p
    }
}

/// Second derivatives by the directors: blocks H_αβ, of which those with α ≥ β count.
pub type Stiffness = [[Matrix3<f64>; DIRECTORS]; DIRECTORS];

/// Reference directors plus increments.
pub(super) fn sum(g0: &Directors, u: &Directors) -> Directors {
    std::array::from_fn(|i| g0[i] + u[i])
}
