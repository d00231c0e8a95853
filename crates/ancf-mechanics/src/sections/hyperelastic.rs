use nalgebra::{Matrix3, Vector3};

use super::section_law::{DIRECTORS, Directors, Lame, Stiffness};

/// Quadrature point of a cross-section with its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPoint {
    /// Material coordinate y, length.
    pub y: f64,
    /// Material coordinate z, length.
    pub z: f64,
    /// Area, length².
    pub weight: f64,
}

/// Compressible neo-Hookean elasticity, integrated over a cross-section by points.
///
/// With J(y, z) = [a + y b + z c, d, e], J₀ for the reference directors, F = J J₀⁻¹ and C = FᵀF, the energy per
/// length of the axis is Σ weight · det J₀ · W with
///
/// W = ½G (tr C − 3) − G ln det F + ½λ (ln det F)².
///
/// Its linearisation at F = I is that of [`SectionLaw`](super::section_law::SectionLaw). All quantities are computed
/// from the increments through H = F − I and E = ½(H + Hᵀ + HᵀH). The energy of small strains therefore has the
/// relative accuracy of E.
///
/// States with det F ≤ 0 at any point are inadmissible ([`is_admissible`](Self::is_admissible)). Their energy is
/// infinite, and the derivatives are not a number. The same holds for det J₀ ≤ 0, where the radius of curvature of the
/// reference is smaller than the section.
///
/// Units: energies per length of the axis.
/// Source: Simo & Pister (1984); Bonet & Wood (2008), eqs (6.27), (6.28).
#[derive(Clone, Debug, PartialEq)]
pub struct NeoHookean {
    lame: Lame,
    points: Vec<SectionPoint>,
}

/// Column of J that depends on a director.
const COLUMN: [usize; 5] = [0, 0, 0, 1, 2];

impl SectionPoint {
    /// Returns the factors of the directors in their columns of J.
    fn factors(&self) -> [f64; 5] {
        [1.0, self.y, self.z, 1.0, 1.0]
    }

    /// Computes J(y, z) of directors, or its increment.
    fn gradient(&self, g: &Directors) -> Matrix3<f64> {
        Matrix3::from_columns(&[g[0] + g[1] * self.y + g[2] * self.z, g[3], g[4]])
    }
}

/// Deformation at a point.
struct Deformation {
    /// Volume weight · det J₀.
    volume: f64,
    /// Inverse J₀⁻¹.
    inverse: Matrix3<f64>,
    /// Deformation gradient F.
    gradient: Matrix3<f64>,
    /// F⁻ᵀ.
    dual: Matrix3<f64>,
    /// Green-Lagrange strain E.
    strain: Matrix3<f64>,
    /// ln det F.
    log: f64,
    /// tr E − ln det F = ½(tr C − 3) − ln det F.
    distortion: f64,
}

impl Deformation {
    /// Returns `None` unless det F and det J₀ are positive.
    fn new(point: &SectionPoint, g0: &Directors, u: &Directors) -> Option<Self> {
        let reference = point.gradient(g0);
        let (inverse, volume) = (reference.try_inverse()?, point.weight * reference.determinant());
        let h = point.gradient(u) * inverse;
        let gradient = h + Matrix3::identity();
        let det = gradient.determinant();
        let dual = gradient.try_inverse()?.transpose();
        let strain = (h + h.transpose() + h.transpose() * h) * 0.5;
        let (log, distortion) = logarithm(&strain, det);
        (det > 0.0 && volume > 0.0).then_some(Self {
            volume,
            inverse,
            gradient,
            dual,
            strain,
            log,
            distortion,
        })
    }

    /// Returns 2G E + λ ln det F I = C S, with the second Piola-Kirchhoff stress S.
    fn stress(&self, lame: Lame) -> Matrix3<f64> {
        self.strain * (2.0 * lame.shear) + Matrix3::from_diagonal_element(lame.lambda * self.log)
    }

    /// Returns J₀⁻¹ S J₀⁻ᵀ times the volume, with S = C⁻¹ (C S).
    fn material_stress(&self, lame: Lame) -> Matrix3<f64> {
        let stress = self.inverse * (self.dual.transpose() * self.dual * self.stress(lame));
        stress * self.inverse.transpose() * self.volume
    }
}

/// Square of the change of JᵀJ below which the work of the mean stress is exact to rounding.
const SMALLEST_CHANGE: f64 = 1e-14;
/// Size of E up to which logarithms are computed from E instead of det F.
const NEAR: f64 = 0.0625;

/// Computes ln det F and tr E − ln det F.
///
/// With the invariants of E, det C = 1 + x, x = 2 I + 4 II + 8 III. Then tr E − ½ ln(1 + x) =
/// −2 II − 4 III + ½(x − ln(1 + x)), where the first-order terms have cancelled.
fn logarithm(strain: &Matrix3<f64>, det: f64) -> (f64, f64) {
    let trace = strain.trace();
    if strain.norm() < NEAR {
        let (second, third) = (0.5 * (trace * trace - strain.norm_squared()), strain.determinant());
        let x = 2.0 * trace + 4.0 * second + 8.0 * third;
        (0.5 * x.ln_1p(), 0.5 * log_excess(x) - 2.0 * second - 4.0 * third)
    } else {
        (det.ln(), trace - det.ln())
    }
}

/// Computes x − ln(1 + x) for small x: with s = x/(2 + x), ln(1 + x) = 2 artanh s and x − 2s = x s.
fn log_excess(x: f64) -> f64 {
    let s = x / (2.0 + x);
    let square = s * s;
    let tail = (0..8).rev().fold(0.0, |sum, k| sum * square + 1.0 / f64::from(2 * k + 3));
    s * (x - 2.0 * square * tail)
}

impl NeoHookean {
    /// Creates the law of a homogeneous section from quadrature points.
    pub fn new(lame: Lame, points: Vec<SectionPoint>) -> Self {
        Self { lame, points }
    }

    /// Returns true if det F > 0 at all points.
    pub fn is_admissible(&self, g0: &Directors, u: &Directors) -> bool {
        self.points.iter().all(|point| Deformation::new(point, g0, u).is_some())
    }

    /// Returns the strain energy per length of the increment u from the reference directors g0, infinite for det F ≤ 0.
    pub fn energy(&self, g0: &Directors, u: &Directors) -> f64 {
        let energy = |point| Deformation::new(point, g0, u).map(|d| d.volume * self.density(&d));
        self.points.iter().map(energy).sum::<Option<f64>>().unwrap_or(f64::INFINITY)
    }

    /// Returns the derivatives p_α of the energy by the directors, not a number for det F ≤ 0.
    ///
    /// ∂W/∂F = G(F − F⁻ᵀ) + λ ln det F F⁻ᵀ = F⁻ᵀ (2G E + λ ln det F I), and ∂W/∂J = ∂W/∂F J₀⁻ᵀ.
    pub fn forces(&self, g0: &Directors, u: &Directors) -> Directors {
        let mut p = [Vector3::zeros(); DIRECTORS];
        for point in &self.points {
            let Some(d) = Deformation::new(point, g0, u) else {
                return [Vector3::repeat(f64::NAN); DIRECTORS];
            };
            let stress = d.dual * d.stress(self.lame) * d.inverse.transpose() * d.volume;
            for ((p, column), factor) in p.iter_mut().zip(COLUMN).zip(point.factors()) {
                *p += stress.column(column) * factor;
            }
        }
        p
    }

    /// Returns forces of the directors in the middle of a step, which do the work of the energy between its ends.
    ///
    /// ∂W/∂J = J T with T = J₀⁻¹ S J₀⁻ᵀ and the second Piola-Kirchhoff stress S. The mean of T of both ends is corrected
    /// along the change of JᵀJ: T̄ + α Δ(JᵀJ), with the work ½ (T̄ + α Δ(JᵀJ)) : Δ(JᵀJ) = ΔW. Rotations do no work.
    pub(crate) fn average_forces(&self, g0: &Directors, [from, to]: [&Directors; 2]) -> Directors {
        let mut p = [Vector3::zeros(); DIRECTORS];
        let middle: Directors = std::array::from_fn(|i| g0[i] + (from[i] + to[i]) * 0.5);
        for point in &self.points {
            let ends = [from, to].map(|u| Deformation::new(point, g0, u));
            let [Some(a), Some(b)] = &ends else { return [Vector3::repeat(f64::NAN); DIRECTORS] };
            let [of_a, of_b] = [a, b].map(|d| d.material_stress(self.lame));
            let mut stress = (of_a + of_b) * 0.5;
            let gradient = point.gradient(&middle);
            let product = gradient.transpose() * point.gradient(&std::array::from_fn(|i| to[i] - from[i]));
            let change = product + product.transpose();
            let square = change.norm_squared();
            if square > SMALLEST_CHANGE {
                let work = b.volume * (self.density(b) - self.density(a)) - 0.5 * stress.dot(&change);
                stress += change * (2.0 * work / square);
            }
            let stress = gradient * stress;
            for ((p, column), factor) in p.iter_mut().zip(COLUMN).zip(point.factors()) {
                *p += stress.column(column) * factor;
            }
        }
        p
    }

    /// Returns the energy density W at a point.
    fn density(&self, d: &Deformation) -> f64 {
        self.lame.shear * d.distortion + 0.5 * self.lame.lambda * d.log * d.log
    }

    /// Adds `factor` times the second derivative of the energy by the directors, in blocks H_αβ with α ≥ β.
    ///
    /// The blocks are not a number for det F ≤ 0. With the columns gⁱ of J⁻ᵀ = F⁻ᵀ J₀⁻ᵀ, the columns i and j of J have
    /// the block G (J₀ᵀJ₀)⁻¹_ij I + (G − λ ln det F) gʲ gⁱᵀ + λ gⁱ gʲᵀ.
    pub fn add_stiffness(&self, g0: &Directors, u: &Directors, factor: f64, h: &mut Stiffness) {
        let Lame { lambda, shear } = self.lame;
        for point in &self.points {
            let Some(d) = Deformation::new(point, g0, u) else {
                *h = [[Matrix3::repeat(f64::NAN); DIRECTORS]; DIRECTORS];
                return;
            };
            let (metric, basis) = (d.inverse * d.inverse.transpose(), d.dual * d.inverse.transpose());
            let block = |i: usize, j: usize| {
                let product = basis.column(i) * basis.column(j).transpose();
                let crossed = product.transpose() * (shear - lambda * d.log);
                (Matrix3::from_diagonal_element(shear * metric[(i, j)]) + crossed + product * lambda)
                    * (d.volume * factor)
            };
            let blocks: [[Matrix3<f64>; 3]; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|j| if i >= j { block(i, j) } else { Matrix3::zeros() })
            });
            let factors = point.factors();
            for i in 0..5 {
                for j in 0..=i {
                    h[i][j] += blocks[COLUMN[i]][COLUMN[j]] * (factors[i] * factors[j]);
                }
            }
        }
    }

    /// Adds the initial stress stiffness of the first-order stresses of an increment `du` of the directors.
    ///
    /// The blocks are not a number for det F ≤ 0. With the second Piola-Kirchhoff stress S = G (I − C⁻¹) + λ ln det F
    /// C⁻¹ and dE = sym(Fᵀ dF), dS = λ (C⁻¹:dE) C⁻¹ + 2 (G − λ ln det F) C⁻¹ dE C⁻¹. The columns i and j of J have the
    /// block (J₀⁻¹ dS J₀⁻ᵀ)_ij I.
    pub fn add_stress_stiffness(&self, g0: &Directors, u: &Directors, du: &Directors, h: &mut Stiffness) {
        let Lame { lambda, shear } = self.lame;
        for point in &self.points {
            let Some(d) = Deformation::new(point, g0, u) else {
                *h = [[Matrix3::repeat(f64::NAN); DIRECTORS]; DIRECTORS];
                return;
            };
            let (inverse, rate) = (d.dual.transpose() * d.dual, point.gradient(du) * d.inverse);
            let product = d.gradient.transpose() * rate;
            let strain = (product + product.transpose()) * 0.5;
            let stress = inverse * (lambda * inverse.dot(&strain))
                + inverse * strain * inverse * (2.0 * (shear - lambda * d.log));
            let blocks = d.inverse * stress * d.inverse.transpose() * d.volume;
            let factors = point.factors();
            for i in 0..5 {
                for j in 0..=i {
                    let entry = blocks[(COLUMN[i], COLUMN[j])] * (factors[i] * factors[j]);
                    h[i][j] += Matrix3::from_diagonal_element(entry);
                }
            }
        }
    }

    /// Bounds the rounding error of [`forces`](Self::forces), given bounds `du` of the errors in u. Infinite for det F
    /// ≤ 0.
    ///
    /// Returns one number per director, which applies to each of its components. The bounds use norms: dH = dJ J₀⁻¹,
    /// dE = Fᵀ dH, d ln det F = C⁻¹:dE, dF⁻¹ = −F⁻¹ dF F⁻¹.
    pub fn rounding(&self, g0: &Directors, u: &Directors, du: &[f64; DIRECTORS]) -> [f64; DIRECTORS] {
        let moved: [f64; DIRECTORS] = std::array::from_fn(|i| du[i] + 2.0 * f64::EPSILON * u[i].norm());
        let mut p = [0.0; DIRECTORS];
        for point in &self.points {
            let Some(d) = Deformation::new(point, g0, u) else {
                return [f64::INFINITY; DIRECTORS];
            };
            let factors = point.factors().map(f64::abs);
            let mut columns = Vector3::<f64>::zeros();
            for i in 0..5 {
                columns[COLUMN[i]] += moved[i] * factors[i];
            }
            let [inverse, gradient, dual] = [d.inverse, d.gradient, d.dual].map(|m| norm(&m));
            let increment = columns.norm() * inverse;
            let strain = increment * gradient;
            let near = d.strain.norm() < NEAR;
            let det = if near { d.log.abs() } else { 4.0 * (gradient * dual).powi(2) };
            let log = 3.0_f64.sqrt() * strain * dual * dual + f64::EPSILON * det;
            let stress = 2.0 * self.lame.shear * strain + self.lame.lambda.abs() * log;
            let turned = dual * increment + 4.0 * f64::EPSILON;
            let error = d.volume * inverse * dual * (stress + norm(&d.stress(self.lame)) * turned);
            for (p, factor) in p.iter_mut().zip(factors) {
                *p += error * factor;
            }
        }
        p
    }
}

/// Bounds the spectral norm by √(‖m‖₁ ‖m‖∞), exact for multiples of the identity.
fn norm(m: &Matrix3<f64>) -> f64 {
    let size = m.abs();
    (size.row_sum().max() * size.column_sum().max()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with the series Σ (−x)ᵏ/k, k ≥ 2, and with the direct difference for larger x.
    #[test]
    fn log_excess_is_exact() {
        for x in [1e-12_f64, -1e-9, 1e-5, -3e-3, 0.02, -0.1, 0.24, -0.24] {
            let series: f64 = (2..60).rev().map(|k| (-x).powi(k) / f64::from(k)).sum();
            assert!((log_excess(x) / series - 1.0).abs() < 1e-15, "{x}: {} and {series}", log_excess(x));
        }
        let x = 0.25_f64;
        assert!((log_excess(x) / (x - x.ln_1p()) - 1.0).abs() < 1e-14);
    }
}
