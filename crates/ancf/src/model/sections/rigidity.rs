//! What a section contributes to the stiffness of a beam in torsion and shear, by the theory of elasticity.

use std::f64::consts::PI;

use super::section::Section;

impl Section {
    /// St. Venant's torsion constant J, length⁴: a torque M twists by M/(G J) per length.
    ///
    /// Circle and tube: ∫y² + ∫z². Ellipse of semi-axes a, b: πa³b³/(a² + b²). Rectangle: a series. A general section says it, or has
    /// iy + iz.
    ///
    /// Source: Timoshenko & Goodier (1970), section 105 (ellipse), eq. (160) (rectangle).
    pub fn torsion_constant(&self) -> f64 {
        match *self {
            Self::Circle { .. } | Self::Tube { .. } => 2.0 * self.moments().yy,
            Self::Rectangle { height, width } => rectangle_torsion(height.max(width), height.min(width)),
            Self::Ellipse { height, width } => {
                let (a, b) = (0.5 * height, 0.5 * width);
                PI * (a * b).powi(3) / (a * a + b * b)
            }
            Self::General { iy, iz, j, .. } => j.unwrap_or(iy + iz),
        }
    }

    /// Shear factors [k_y, k_z] of a material with Poisson's ratio ν: a force along y meets the stiffness k_y G A.
    ///
    /// Circle: 6(1+ν)/(7+6ν). Tube, m = inner/outer: 6(1+ν)(1+m²)²/((7+6ν)(1+m²)² + (20+12ν)m²). Rectangle:
    /// 10(1+ν)/(12+11ν) both ways. Ellipse, a the semi-axis along the force and b the other:
    /// 12(1+ν)a²(3a²+b²)/((40+37ν)a⁴ + (16+10ν)a²b² + νb⁴). General: as the section says, whatever ν.
    ///
    /// For ν < 0 the factor of a flat ellipse across its length is large, infinite or negative: there the formula ends.
    ///
    /// Source: Cowper (1966).
    pub fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        match *self {
            Self::Circle { .. } => [tube_shear(poisson, 0.0); 2],
            Self::Tube { outer, inner } => [tube_shear(poisson, inner / outer); 2],
            Self::Rectangle { .. } => [10.0 * (1.0 + poisson) / (12.0 + 11.0 * poisson); 2],
            Self::Ellipse { height, width } => {
                [ellipse_shear(poisson, width / height), ellipse_shear(poisson, height / width)]
            }
            Self::General { ky, kz, .. } => [ky, kz],
        }
    }
}

/// (31/32) ζ(5) = Σ 1/n⁵ over the odd n.
const ODD_FIFTHS: f64 = 1.004_523_762_795_139_6;

/// J = a b³ (1/3 − 64 b/(π⁵ a) Σ tanh(nπa/2b)/n⁵), over odd n, of sides a ≥ b.
///
/// The sum is that of 1/n⁵ less Σ 2/((exp(nπa/b) + 1) n⁵), whose terms fall by exp(2π) and more each.
fn rectangle_torsion(a: f64, b: f64) -> f64 {
    let rest: f64 = (0..7)
        .map(|k| f64::from(2 * k + 1))
        .map(|n| 2.0 / (((n * PI * a / b).exp() + 1.0) * n.powi(5)))
        .sum();
    a * b.powi(3) * (1.0 / 3.0 - 64.0 * b / (PI.powi(5) * a) * (ODD_FIFTHS - rest))
}

/// Of a tube with the ratio m of its diameters.
fn tube_shear(poisson: f64, m: f64) -> f64 {
    let square = (1.0 + m * m).powi(2);
    6.0 * (1.0 + poisson) * square / ((7.0 + 6.0 * poisson) * square + (20.0 + 12.0 * poisson) * m * m)
}

/// Of an ellipse whose axis across the force is so many times that along it.
fn ellipse_shear(poisson: f64, ratio: f64) -> f64 {
    let square = ratio * ratio;
    12.0 * (1.0 + poisson) * (3.0 + square)
        / ((40.0 + 37.0 * poisson) + (16.0 + 10.0 * poisson) * square + poisson * square * square)
}
