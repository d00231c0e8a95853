use nalgebra::{Matrix3, SMatrix, Vector3};

use super::deformation_factors::DeformationFactors;
use super::hyperelastic::SectionPoint;
use super::section_law::{Directors, Lame, STRAINS, SectionLaw, SectionMatrix, Strains};
use super::section_strains::*;

/// Area moments ∫ yⁱ zʲ dA of a cross-section about its principal axes. Odd moments vanish by symmetry.
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

/// Cross-section properties used by the elements.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSection {
    /// Area moments.
    pub moments: Moments,
    /// ∫ y² dA and ∫ z² dA for the rotary inertia.
    pub inertia: [f64; 2],
    /// St. Venant torsion constant J.
    pub torsion: f64,
    /// Shear correction factors k_y and k_z.
    pub shear: [f64; 2],
    /// Quadrature points that integrate the moments exactly.
    pub points: Vec<SectionPoint>,
}

impl SectionLaw {
    /// Creates the exact three-dimensional St. Venant-Kirchhoff law ½∫(λ tr² E + 2G E:E) dA of a straight beam.
    ///
    /// The law locks: the bending stiffness is (λ+2G) I, and the torsional stiffness uses the polar moment of area.
    ///
    /// Source: the energy of Kim et al. (2017), eqs (26)-(31), with the factors missing in (27), (28) restored.
    pub fn continuum(material: Lame, m: Moments) -> Self {
        Self::new(&full(material, m))
    }

    /// Creates the three-dimensional law of a beam with a curved or twisted reference, with directors g0 in any frame.
    ///
    /// The strains in the energy refer to the orthonormal frame of the reference section, E = F₀⁻ᵀ Ẽ F₀⁻¹ with
    /// F₀ = [g₁ g₂ g₃]. F₀ varies over the section, so the law is integrated by points.
    pub fn curved(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let Lame { lambda, shear } = material;
        let mut d = NONE;
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            let weight = point.weight * volume;
            for i in 0..3 {
                for j in 0..3 {
                    let stiffness = if i == j { lambda + 2.0 * shear } else { lambda };
                    add_product(&rows[i], &rows[j], weight * stiffness, &mut d);
                }
                add_product(&rows[3 + i], &rows[3 + i], weight * shear, &mut d);
            }
        }
        Self::new(&d)
    }

    /// Creates the rod law in continuum strains, which avoids Poisson and torsion locking.
    ///
    /// It is the sum of [`rod`](Self::rod), [`shear`](Self::shear) and [`transverse`](Self::transverse), for reference
    /// directors g0 in any frame. Elements add [`gradient`](Self::gradient) in their middle, where it does not lock.
    ///
    /// Source: Gerstmayr, Matikainen & Mikkola (2008), Nachbagauer, Gruber & Gerstmayr (2013) for Poisson's effect on
    /// the axis only and the shear factors. The split into parts that are never negative is specific to this
    /// implementation.
    pub fn enhanced(
        material: Lame,
        section: &CrossSection,
        g0: &Directors,
        factors: &DeformationFactors,
    ) -> Self {
        Self::rod(material, section, g0, factors)
            .plus(&Self::shear(material, section, g0).times(factors.shear))
            .plus(&Self::transverse(material, section, g0).times(factors.section))
    }

    /// Creates the law of tension, bending and torsion: ½(∫E E₁₁² dA + GJ κ²).
    ///
    /// The fibres have the modulus E. The twist κ = ½(∫y 2E₁₃ dA/∫y² dA − ∫z 2E₁₂ dA/∫z² dA) is the mean rate of
    /// rotation of both section directions. The factors are those of stretch, bending and torsion.
    pub fn rod(material: Lame, section: &CrossSection, g0: &Directors, factors: &DeformationFactors) -> Self {
        let torsion = Self::torsion(material, section, g0).times(factors.torsion);
        if factors.stretch == factors.bending {
            return Self::fibres(material, section, g0).times(factors.stretch).plus(&torsion);
        }
        let stretch = Self::stretch(material, section, g0).times(factors.stretch);
        stretch.plus(&Self::bending(material, section, g0).times(factors.bending)).plus(&torsion)
    }

    /// Creates the law of tension and bending, ½∫E E₁₁² dA.
    fn fibres(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let mut d = NONE;
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            add_product(&rows[0], &rows[0], point.weight * volume * material.young(), &mut d);
        }
        Self::new(&d)
    }

    /// Creates the law of tension, ½EA ε², where ε is the mean axial strain of the section.
    fn stretch(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let ((mean, area), mut d) = (mean_axial_strain(section, g0), NONE);
        add_product(&mean, &mean, material.young() * area, &mut d);
        Self::new(&d)
    }

    /// Creates the law of bending, ½∫E (E₁₁ − ε)² dA, where ε is the mean axial strain of the section.
    fn bending(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let ((mean, _), mut d) = (mean_axial_strain(section, g0), NONE);
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            let row = std::array::from_fn(|k| rows[0][k] - mean[k]);
            add_product(&row, &row, point.weight * volume * material.young(), &mut d);
        }
        Self::new(&d)
    }

    /// Creates the law of torsion, ½GJ κ², with the twist κ of [`rod`](Self::rod).
    fn torsion(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let (m, mut d, mut area, mut twist) = (section.moments, NONE, 0.0, [0.0; STRAINS]);
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            let weight = point.weight * volume;
            area += weight;
            for k in 0..STRAINS {
                twist[k] += 0.5 * weight * (point.y / m.yy * rows[4][k] - point.z / m.zz * rows[3][k]);
            }
        }
        // Per length of the material coordinate. The factor area/A is its length in the reference state.
        add_product(&twist, &twist, material.shear * section.torsion * m.area / area, &mut d);
        Self::new(&d)
    }

    /// Creates the law of shear forces: ½(k_y GA γ_y² + k_z GA γ_z²), where γ are the mean shear strains of the
    /// section.
    pub fn shear(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let (mut d, mut area, mut means) = (NONE, 0.0, [[0.0; STRAINS]; 2]);
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            area += point.weight * volume;
            for (mean, row) in means.iter_mut().zip(&rows[3..5]) {
                mean.iter_mut().zip(row).for_each(|(mean, x)| *mean += point.weight * volume * x);
            }
        }
        for (mean, factor) in means.iter().zip(section.shear) {
            add_product(mean, mean, factor * material.shear / area, &mut d);
        }
        Self::new(&d)
    }

    /// Creates the law of a deformation of the section that changes along the axis, ½G (I_y p_y² + I_z p_z² + (I_y + I_z) p_s²).
    ///
    /// p_y = ε_bd, p_z = ε_ce and p_s = ½(ε_be + ε_cd) are the parts of the shear strains linear in y and z, without twist and
    /// mean shear. They vanish if the size and the shape of the section are constant along the axis. Without this energy the
    /// second derivative of the energy by (a, b) is indefinite in bending: cos kx waves of the thickness grow for
    /// k > √((λ+2G) kGA²)/(E I κ), that is on fine meshes.
    pub fn gradient(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let (m, mut d, mut area, mut parts) = (section.moments, NONE, 0.0, [[0.0; STRAINS]; 3]);
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            let (weight, y, z) = (point.weight * volume, point.y / m.yy, point.z / m.zz);
            area += weight;
            for k in 0..STRAINS {
                parts[0][k] += weight * y * rows[3][k];
                parts[1][k] += weight * z * rows[4][k];
                parts[2][k] += 0.5 * weight * (y * rows[4][k] + z * rows[3][k]);
            }
        }
        for (part, inertia) in parts.iter().zip([m.yy, m.zz, m.yy + m.zz]) {
            add_product(part, part, material.shear * inertia * m.area / area, &mut d);
        }
        Self::new(&d)
    }

    /// Creates the law of section deformation, ½A ((λ+2G)(y² + z²) + 2λ y z + G (2E₂₃)²).
    ///
    /// y = E₂₂ + ν E₁₁ and z = E₃₃ + ν E₁₁ on the axis, so the energy vanishes for lateral contraction under tension.
    pub fn transverse(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let Lame { lambda, shear } = material;
        let poisson = 0.5 * lambda / (lambda + shear);
        let (rows, volume) = local_strains(g0, 0.0, 0.0);
        let area = section.moments.area * volume;
        let of = |i: usize| std::array::from_fn(|k| rows[i][k] + poisson * rows[0][k]);
        let (y, z, mut d): (StrainRow, StrainRow, SectionMatrix) = (of(1), of(2), NONE);
        for (x, y, stiffness) in [
            (&y, &y, lambda + 2.0 * shear),
            (&z, &z, lambda + 2.0 * shear),
            (&y, &z, lambda),
            (&z, &y, lambda),
            (&rows[5], &rows[5], shear),
        ] {
            add_product(x, y, area * stiffness, &mut d);
        }
        Self::new(&d)
    }

    /// Replaces the curvatures by those of the linked formulation at ξ of a two-node element of length l.
    ///
    /// The curvature ε_ab is replaced by ε_ab + w' (h·d + l k·b), with w = ξ − ξ², and so on for c, e. This corresponds to a
    /// quadratic part w h·d of the section directors. The shear strains are then linear along the element, with their
    /// values at the nodes.
    ///
    /// Source: linked interpolation as in Jelenic & Papa (2011), here for strains of the fully parameterised element.
    #[must_use]
    pub fn linked(&self, xi: f64, length: f64) -> Self {
        self.mapped(&linked_strain_terms(xi, length))
    }

    /// Creates the law EA V² of an axial strain that is not linear along a two-node element, to be used in the middle.
    ///
    /// V = ½(ε_aa(0) + ε_aa(1)) − ε_aa(½) = ¼ε_ah + ¼ε_kk + ε_hh/16. A stretch of the nodes alone reduces their linked
    /// curvatures by 2Vκ, to first order. With Simpson's stiffness EA V²/9 only, such a stretch relieves the bending moment by
    /// the share 2κ²I/A on any mesh. With this law the share is 0.2κ²I/A.
    pub fn axial_variation(material: Lame, section: &CrossSection) -> Self {
        let (mut row, mut d) = ([0.0; STRAINS], NONE);
        [row[AH], row[KK], row[HH]] = [0.25, 0.25, 0.0625];
        add_product(&row, &row, 2.0 * material.young() * section.moments.area, &mut d);
        Self::new(&d)
    }

    /// Replaces the axial strain by a linear one along a three-node element, with its values at the two Gauss points.
    ///
    /// The strain ε_aa is replaced by ε_aa − (η² − 1/12) ε_hh, with η = ξ − ½ and a = a(½) + η h.
    #[must_use]
    pub fn reduced(&self, xi: f64) -> Self {
        let eta = xi - 0.5;
        self.mapped(&[(AA, HH, 1.0 / 12.0 - eta * eta)])
    }

    /// Adds to each strain of the list a multiple of another strain.
    fn mapped(&self, list: &[(usize, usize, f64)]) -> Self {
        let mut map: SMatrix<f64, STRAINS, STRAINS> = SMatrix::identity();
        for &(strain, added, factor) in list {
            map[(strain, added)] = factor;
        }
        let form = self.form();
        let d = map.transpose() * SMatrix::from_fn(|k, l| form[k][l]) * map;
        Self::new(&std::array::from_fn(|k| std::array::from_fn(|l| 0.5 * (d[(k, l)] + d[(l, k)]))))
    }
}

/// Returns the additional terms of linked curvatures at ξ: the strain, the added strain and its factor.
pub(crate) fn linked_strain_terms(xi: f64, length: f64) -> [(usize, usize, f64); 4] {
    let slope = (1.0 - 2.0 * xi) / length;
    let arm = slope * length;
    [(AB, DH, slope), (AB, BK, arm), (AC, EH, slope), (AC, CK, arm)]
}

/// Strain as a linear combination of section strains.
type StrainRow = [f64; STRAINS];

/// Zero stiffness.
const NONE: SectionMatrix = [[0.0; STRAINS]; STRAINS];

/// Returns D of λ tr² E + 2G E:E over a straight section.
fn full(material: Lame, m: Moments) -> SectionMatrix {
    let Lame { lambda: l, shear: g } = material;
    let p = l + 2.0 * g;
    let mut d = NONE;
    let mut set = |i: usize, j: usize, value: f64| {
        d[i][j] = value;
        d[j][i] = value;
    };
    for (i, j, value) in [
        (AA, AA, p * m.area),
        (AA, BB, p * m.yy),
        (AA, CC, p * m.zz),
        (AA, DD, l * m.area),
        (AA, EE, l * m.area),
        (BB, BB, p * m.yyyy),
        (BB, CC, p * m.yyzz),
        (BB, DD, l * m.yy),
        (BB, EE, l * m.yy),
        (CC, CC, p * m.zzzz),
        (CC, DD, l * m.zz),
        (CC, EE, l * m.zz),
        (DD, DD, p * m.area),
        (DD, EE, l * m.area),
        (EE, EE, p * m.area),
        (AB, AB, p * m.yy),
        (AC, AC, p * m.zz),
        (BC, BC, p * m.yyzz),
        (AD, AD, g * m.area),
        (BD, BD, g * m.yy),
        (CD, CD, g * m.zz),
        (AE, AE, g * m.area),
        (BE, BE, g * m.yy),
        (CE, CE, g * m.zz),
        (DE, DE, g * m.area),
    ] {
        set(i, j, value);
    }
    d
}

/// Returns the mean axial strain of a section, as a row over the section strains, and the area ∫det F₀ dA.
fn mean_axial_strain(section: &CrossSection, g0: &Directors) -> (StrainRow, f64) {
    let (mut area, mut mean) = (0.0, [0.0; STRAINS]);
    for point in &section.points {
        let (rows, volume) = local_strains(g0, point.y, point.z);
        area += point.weight * volume;
        mean.iter_mut().zip(&rows[0]).for_each(|(mean, x)| *mean += point.weight * volume * x);
    }
    (mean.map(|x| x / area), area)
}

fn add_product(x: &StrainRow, y: &StrainRow, factor: f64, d: &mut SectionMatrix) {
    for k in 0..STRAINS {
        for l in 0..STRAINS {
            d[k][l] += factor * x[k] * y[l];
        }
    }
}

/// Returns strains at (y, z) in the orthonormal frame of the reference section, and det F₀.
///
/// E₁₁, E₂₂, E₃₃, 2E₁₂, 2E₁₃, 2E₂₃ are given as rows over the section strains.
pub(crate) fn local_strains(g0: &Directors, y: f64, z: f64) -> ([StrainRow; 6], f64) {
    let f0 = reference_gradient(g0, y, z);
    let inverse = f0.try_inverse().unwrap_or_else(Matrix3::identity);
    // Each entry is a linear combination of section strains.
    let strains = director_strains(y, z, |terms| {
        let mut row = [0.0; STRAINS];
        terms.iter().for_each(|&(k, x)| row[k] = x);
        row
    });
    let rotated = |i: usize, j: usize, factor: f64| -> StrainRow {
        let mut row = [0.0; STRAINS];
        for (k, strains) in strains.iter().enumerate() {
            for (l, strain) in strains.iter().enumerate() {
                let weight = factor * inverse[(k, i)] * inverse[(l, j)];
                row.iter_mut().zip(strain).for_each(|(row, x)| *row += weight * x);
            }
        }
        row
    };
    let rows = [
        rotated(0, 0, 1.0),
        rotated(1, 1, 1.0),
        rotated(2, 2, 1.0),
        rotated(0, 1, 2.0),
        rotated(0, 2, 2.0),
        rotated(1, 2, 2.0),
    ];
    (rows, f0.determinant())
}

/// Returns the strain at (y, z) in the orthonormal frame of the reference section, for given section strains.
pub(crate) fn local_strain(g0: &Directors, strains: &Strains, y: f64, z: f64) -> Matrix3<f64> {
    let inverse = reference_gradient(g0, y, z).try_inverse().unwrap_or_else(Matrix3::identity);
    let sum = |terms: &[(usize, f64)]| terms.iter().map(|&(k, x)| x * strains[k]).sum::<f64>();
    // The matrix is symmetric, so rows may be columns.
    inverse.transpose() * Matrix3::from(director_strains(y, z, sum)) * inverse
}

/// Gradient F₀ of the reference placement at (y, z), in the orthonormal frame of the reference section.
fn reference_gradient(g0: &Directors, y: f64, z: f64) -> Matrix3<f64> {
    let n = g0[3].cross(&g0[4]).normalize();
    let second = g0[3].normalize();
    let frame = Matrix3::from_columns(&[n, second, n.cross(&second)]);
    let first = g0[0] + g0[1] * y + g0[2] * z;
    frame.transpose() * Matrix3::from_columns(&[first, g0[3], g0[4]])
}

/// Strain Ẽ at (y, z) in the basis of the reference directors. `of` evaluates a linear combination of section strains.
fn director_strains<T: Copy>(y: f64, z: f64, of: impl Fn(&[(usize, f64)]) -> T) -> [[T; 3]; 3] {
    let half = |terms: [(usize, f64); 3]| of(&terms.map(|(k, x)| (k, 0.5 * x)));
    let e11 = of(&[(AA, 1.0), (AB, y), (AC, z), (BB, y * y), (BC, y * z), (CC, z * z)]);
    let (e22, e33, e23) = (of(&[(DD, 1.0)]), of(&[(EE, 1.0)]), of(&[(DE, 0.5)]));
    let (e12, e13) = (half([(AD, 1.0), (BD, y), (CD, z)]), half([(AE, 1.0), (BE, y), (CE, z)]));
    [[e11, e12, e13], [e12, e22, e23], [e13, e23, e33]]
}

/// Returns the directors of a straight, undistorted reference section in its own frame.
pub(crate) fn straight() -> Directors {
    let zero = Vector3::zeros();
    [Vector3::x(), zero, zero, Vector3::y(), Vector3::z(), zero, zero]
}
