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
    /// Returns Young's modulus E = G (3λ + 2G)/(λ + G).
    pub fn young(&self) -> f64 {
        self.shear * (3.0 * self.lambda + 2.0 * self.shear) / (self.lambda + self.shear)
    }
}

/// Vectors that describe the deformation of a cross-section, or increments of them.
///
/// J(y, z) = [a + y b + z c, d, e] with a = r_x on the axis, b = ∂r_y/∂x, c = ∂r_z/∂x, d = r_y, e = r_z. The other
/// directors describe the variation of a along an element: h is the coefficient of its highest power of ξ, and k = a(1)
/// − a(0). They reduce the variation of strains that would cause locking
/// ([`TwoNodeLaw`](crate::elements::TwoNodeLaw)).
pub type Directors = [Vector3<f64>; DIRECTORS];

/// Number of directors.
pub(crate) const DIRECTORS: usize = 7;

/// Number of section strains.
pub(crate) const STRAINS: usize = 22;

/// Pairs of directors whose products are the section strains; ½ of the product for equal directors.
pub(crate) const PAIRS: [(usize, usize); STRAINS] = [
    (0, 0),
    (1, 1),
    (2, 2),
    (3, 3),
    (4, 4),
    (5, 5),
    (6, 6), // aa bb cc dd ee hh kk
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
    (2, 6),
    (0, 5), // dh eh bk ck ah
];

/// Section strains, indexed by pair of directors.
pub(crate) type Strains = [f64; STRAINS];

/// Elasticity of a cross-section as a quadratic form ½ εᵀ D ε in the products of directors.
///
/// With g = (a, b, c, d, e, h), the Green-Lagrange strains are combinations of the *section strains*
/// ε_αα = ½(g_α·g_α − g⁰_α·g⁰_α) and ε_αβ = g_α·g_β − g⁰_α·g⁰_β:
///
/// E₁₁ = ε_aa + y ε_ab + z ε_ac + y² ε_bb + yz ε_bc + z² ε_cc,  E₂₂ = ε_dd,  E₃₃ = ε_ee,
/// 2E₁₂ = ε_ad + y ε_bd + z ε_cd,  2E₁₃ = ε_ae + y ε_be + z ε_ce,  2E₂₃ = ε_de.
///
/// Any energy quadratic in them, integrated over the section, is therefore ½ εᵀ D ε. The formulations define D
/// ([`SectionLaw::continuum`], [`SectionLaw::enhanced`]).
///
/// Units: D force·lengthᵏ; energies per length of the axis.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionLaw {
    /// Nonzero entries (k, l, D_kl) with k > l.
    coupled: Vec<(usize, usize, f64)>,
    /// Strains with stiffness, each with its pair of directors and D_kk.
    used: Vec<(usize, (usize, usize), f64)>,
    /// Number of directors that the law depends on.
    reach: usize,
}

/// Matrix D over the section strains.
pub(crate) type SectionMatrix = [[f64; STRAINS]; STRAINS];

impl SectionLaw {
    /// Creates the law of a symmetric positive semidefinite matrix D. Entries within rounding of zero are dropped.
    pub(crate) fn new(d: &SectionMatrix) -> Self {
        let counts = |k: usize, l: usize| d[k][l].abs() > 1e-14 * (d[k][k] * d[l][l]).abs().sqrt();
        let used: Vec<_> = (0..STRAINS).filter(|&k| counts(k, k)).map(|k| (k, PAIRS[k], d[k][k])).collect();
        let lower = (0..STRAINS).flat_map(|k| (0..k).map(move |l| (k, l)));
        let coupled = lower.filter(|&(k, l)| counts(k, l)).map(|(k, l)| (k, l, d[k][l]));
        let reach = used.iter().map(|(_, (i, j), _)| i.max(j) + 1).max().unwrap_or(0);
        Self { coupled: coupled.collect(), used, reach }
    }

    /// Returns D.
    pub(crate) fn form(&self) -> SectionMatrix {
        let mut d = [[0.0; STRAINS]; STRAINS];
        for &(k, _, entry) in &self.used {
            d[k][k] = entry;
        }
        for &(k, l, entry) in &self.coupled {
            d[k][l] = entry;
            d[l][k] = entry;
        }
        d
    }

    /// Multiplies the stiffness by `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        let mut law = self.clone();
        law.used.iter_mut().for_each(|(_, _, d)| *d *= factor);
        law.coupled.iter_mut().for_each(|(_, _, d)| *d *= factor);
        law
    }

    /// Returns the sum of two laws.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (mut d, more) = (self.form(), other.form());
        d.iter_mut().flatten().zip(more.iter().flatten()).for_each(|(d, more)| *d += more);
        Self::new(&d)
    }

    /// Returns the number of directors that the law depends on.
    pub(crate) fn reach(&self) -> usize {
        self.reach
    }

    /// Computes section strains of the increment u from the reference directors g0, without cancellation.
    ///
    /// g_α·g_β − g⁰_α·g⁰_β = g⁰_α·u_β + u_α·g⁰_β + u_α·u_β. Strains without stiffness remain zero.
    fn strains(&self, g0: &Directors, u: &Directors) -> Strains {
        let mut strains = [0.0; STRAINS];
        for &(k, pair, _) in &self.used {
            strains[k] = strain_of(pair, g0, u);
        }
        strains
    }

    /// Computes the rates of the section strains of the directors g with rates v.
    fn rates(&self, g: &Directors, v: &Directors) -> Strains {
        let mut rates = [0.0; STRAINS];
        for &(k, pair, _) in &self.used {
            rates[k] = rate_of(pair, g, v);
        }
        rates
    }

    /// Computes the stress resultants n = D ε.
    pub(crate) fn resultants(&self, strains: &Strains) -> Strains {
        let mut n = [0.0; STRAINS];
        for &(k, _, d) in &self.used {
            n[k] = d * strains[k];
        }
        for &(k, l, d) in &self.coupled {
            n[k] += d * strains[l];
            n[l] += d * strains[k];
        }
        n
    }

    /// Computes the resultants of weighted strains of two increments.
    pub(crate) fn average_resultants(
        &self,
        g0: &Directors,
        ends: [&Directors; 2],
        shares: [f64; 2],
    ) -> Strains {
        let [from, to] = ends.map(|u| self.strains(g0, u));
        self.resultants(&std::array::from_fn(|k| shares[0] * from[k] + shares[1] * to[k]))
    }

    /// Computes the viscous resultants of the strain rates.
    pub(crate) fn viscous(&self, g: &Directors, v: &Directors) -> Strains {
        self.resultants(&self.rates(g, v))
    }

    /// Returns the strain energy per length of the increment u from the reference directors g0.
    pub fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        let strains = self.strains(g0, u);
        0.5 * self.resultants(&strains).iter().zip(&strains).map(|(n, e)| n * e).sum::<f64>()
    }

    /// Returns the derivatives of the energy by the directors: p_α = Σ_β N_αβ g_β.
    pub fn forces(&self, g0: &Directors, u: &Directors) -> Directors {
        self.of_resultants(&self.resultants(&self.strains(g0, u)), &sum(g0, u))
    }

    /// Computes Σ_k n_k ∂ε_k/∂g_α.
    pub(crate) fn of_resultants(&self, n: &Strains, g: &Directors) -> Directors {
        let mut p = [Vector3::zeros(); DIRECTORS];
        for &(k, (i, j), _) in &self.used {
            p[i] += g[j] * n[k];
            if i != j {
                p[j] += g[i] * n[k];
            }
        }
        p
    }

    /// Adds `factor` times the second derivative of the energy by the directors, in blocks H_αβ with α ≥ β.
    pub fn add_stiffness(&self, g0: &Directors, u: &Directors, factor: f64, h: &mut Stiffness) {
        let (n, g) = (self.resultants(&self.strains(g0, u)), sum(g0, u));
        self.add_geometric(&n, factor, h);
        self.add_squares(&g, factor, h);
    }

    /// Adds the initial stress stiffness Σ_k n_k ∂²ε_k of the first-order stresses n = D ∂ε/∂g `du` of an increment
    /// `du`.
    pub fn add_stress_stiffness(&self, g0: &Directors, u: &Directors, du: &Directors, h: &mut Stiffness) {
        self.add_geometric(&self.resultants(&self.rates(&sum(g0, u), du)), 1.0, h);
    }

    /// Adds −Σ_k n_k ∂²ε_k for the part n of the resultants that is of second order in an increment `du` of the directors.
    pub fn add_stress_prediction(&self, du: &Directors, h: &mut Stiffness) {
        let second_order = self.strains(&[Vector3::zeros(); DIRECTORS], du);
        self.add_geometric(&self.resultants(&second_order), -1.0, h);
    }

    /// Returns the strain energy per length of each section strain. Coupling terms are divided equally.
    pub(crate) fn shares(&self, g0: &Directors, u: &Directors) -> Strains {
        let strains = self.strains(g0, u);
        let n = self.resultants(&strains);
        std::array::from_fn(|k| 0.5 * n[k] * strains[k])
    }

    /// Adds `factor` Σ_k n_k ∂²ε_k.
    pub(crate) fn add_geometric(&self, n: &Strains, factor: f64, h: &mut Stiffness) {
        for &(k, (i, j), _) in &self.used {
            for axis in 0..3 {
                h[j][i][(axis, axis)] += factor * n[k];
            }
        }
    }

    /// Adds `factor` B(g)ᵀ D B(g), where B(g) are the derivatives ∂ε_k/∂g_α at directors g.
    pub(crate) fn add_squares(&self, g: &Directors, factor: f64, h: &mut Stiffness) {
        let mut p = NO_STIFFNESS;
        for i in 0..self.reach {
            let x = g[i] * factor;
            for j in 0..=i {
                p[i][j] = x * g[j].transpose();
                p[j][i] = p[i][j].transpose();
            }
        }
        self.add_form(&p, h);
    }

    /// Adds the contraction of D with the products P_ij = g_i g_jᵀ.
    ///
    /// D_kl of the pairs k = (i, j) and l = (m, n) adds P_jn at (i, m), for each order of each pair.
    fn add_form(&self, p: &Stiffness, h: &mut Stiffness) {
        for &(_, (i, j), d) in &self.used {
            add(&mut h[i][i], &p[j][j], d);
            if i != j {
                add(&mut h[j][j], &p[i][i], d);
                add(&mut h[j][i], &p[i][j], d);
            }
        }
        for &(k, l, d) in &self.coupled {
            if let ((i, j), (m, n)) = (PAIRS[k], PAIRS[l])
                && i == j
                && m == n
            {
                // For equal pairs, k > l means i > m.
                add(&mut h[i][m], &p[i][m], d);
                continue;
            }
            for (row, x) in orders(PAIRS[k]) {
                for (column, y) in orders(PAIRS[l]) {
                    if row >= column {
                        add(&mut h[row][column], &p[x][y], d);
                    }
                    if row <= column {
                        add(&mut h[column][row], &p[y][x], d);
                    }
                }
            }
        }
    }

    /// Bounds the rounding error of [`forces`](Self::forces), given bounds `du` of the errors in u.
    ///
    /// Returns one number per director, which applies to each of its components.
    pub fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; DIRECTORS]) -> [f64; DIRECTORS] {
        let [mut size, mut moved, mut p] = [[0.0; DIRECTORS]; 3];
        for i in 0..self.reach {
            size[i] = (g0[i] + u[i]).norm();
            moved[i] = du[i] + f64::EPSILON * u[i].norm();
        }
        let n = self.resultants(&self.strains(g0, u));
        let [mut error, mut dn] = [[0.0; STRAINS]; 2];
        for &(k, (i, j), d) in &self.used {
            error[k] = if i == j { size[i] * moved[i] } else { size[i] * moved[j] + moved[i] * size[j] };
            dn[k] = d.abs() * error[k];
        }
        for &(k, l, d) in &self.coupled {
            dn[k] += d.abs() * error[l];
            dn[l] += d.abs() * error[k];
        }
        for &(k, (i, j), _) in &self.used {
            p[i] += dn[k] * size[j] + n[k].abs() * (moved[j] + f64::EPSILON * size[j]);
            if i != j {
                p[j] += dn[k] * size[i] + n[k].abs() * (moved[i] + f64::EPSILON * size[i]);
            }
        }
        p
    }
}

/// Computes all section strains of the increment u from the reference directors g0.
pub(crate) fn all_strains(g0: &Directors, u: &Directors) -> Strains {
    PAIRS.map(|pair| strain_of(pair, g0, u))
}

/// Computes the rates of all section strains of the directors g with rates v.
pub(crate) fn all_rates(g: &Directors, v: &Directors) -> Strains {
    PAIRS.map(|pair| rate_of(pair, g, v))
}

/// Computes the rate of the section strain of a pair of directors.
#[inline]
fn rate_of((i, j): (usize, usize), g: &Directors, v: &Directors) -> f64 {
    if i == j { g[i].dot(&v[i]) } else { g[i].dot(&v[j]) + v[i].dot(&g[j]) }
}

/// Computes the section strain of a pair of directors.
#[inline]
fn strain_of((i, j): (usize, usize), g0: &Directors, u: &Directors) -> f64 {
    if i == j { (g0[i] + u[i] * 0.5).dot(&u[i]) } else { (g0[i] + u[i]).dot(&u[j]) + u[i].dot(&g0[j]) }
}

/// Returns a pair of directors in both orders, or once if they are equal.
fn orders((i, j): (usize, usize)) -> impl Iterator<Item = (usize, usize)> {
    [(i, j), (j, i)].into_iter().take(if i == j { 1 } else { 2 })
}

/// Second derivatives by the directors: blocks H_αβ, used for α ≥ β.
pub type Stiffness = [[Matrix3<f64>; DIRECTORS]; DIRECTORS];

/// Zero stiffness.
pub(crate) const NO_STIFFNESS: Stiffness =
    [[Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0); DIRECTORS]; DIRECTORS];

/// Adds `factor` times a matrix.
#[inline]
pub(crate) fn add(sum: &mut Matrix3<f64>, matrix: &Matrix3<f64>, factor: f64) {
    for (sum, x) in sum.as_mut_slice().iter_mut().zip(matrix.as_slice()) {
        *sum += factor * x;
    }
}

/// Returns reference directors plus increments.
pub(crate) fn sum(g0: &Directors, u: &Directors) -> Directors {
    std::array::from_fn(|i| g0[i] + u[i])
}
