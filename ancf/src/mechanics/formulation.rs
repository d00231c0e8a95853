use nalgebra::{Matrix3, SMatrix, Vector3};

use super::SectionPoint;
use super::section::{Directors, Lame, SectionLaw, strain::*};

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

/// A cross-section as the elements see it.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSection {
    /// Moments of area.
    pub moments: Moments,
    /// ∫ y² dA and ∫ z² dA by which the section resists rotation with its mass.
    pub inertia: [f64; 2],
    /// Torsion constant J of St. Venant.
    pub torsion: f64,
    /// Shear factors k_y and k_z.
    pub shear: [f64; 2],
    /// A quadrature rule over the section that is exact for the moments.
    pub points: Vec<SectionPoint>,
}

/// D over the section strains, before and while it is built.
type Form = [[f64; 17]; 17];

impl SectionLaw {
    /// Three-dimensional St. Venant-Kirchhoff elasticity ½∫(λ tr² E + 2G E:E) dA of a straight beam, exactly.
    ///
    /// Locks: bending is resisted by (λ+2G) I, torsion by the polar moment of area.
    ///
    /// Source: the energy of Kim et al. (2017), eqs (26)-(31), with the factors missing in (27), (28) restored.
    pub fn continuum(material: Lame, m: Moments) -> Self {
        Self::new(&full(material, m))
    }

    /// Elasticity of a rod in the strains of the continuum: the remedy of Poisson, shear and torsion locking.
    ///
    /// Over the section each normal strain has modulus E and each shear strain G; what Poisson's ratio adds, λ and λ+2G−E
    /// among the normal strains, acts on the axis only, so that bending is resisted by E I. Mean shear strains have the
    /// stiffnesses k G A, and of the section's shear strains the part that is a twist,
    /// κ = (I_y ε_be − I_z ε_cd)/(I_y + I_z) with I_z = ∫z² dA, I_y = ∫y² dA here, has the stiffness G J.
    /// Fibres stretch by Green's strain: at finite thickness, bending and twist stretch them too.
    ///
    /// Source: Gerstmayr, Matikainen & Mikkola (2008), Nachbagauer, Gruber & Gerstmayr (2013) for the split of Poisson's
    /// effect and the shear factors; the projection on the twist is the energy-orthogonal one.
    pub fn enhanced(material: Lame, section: &CrossSection) -> Self {
        let (young, m) = (material.young(), section.moments);
        // E and G without coupling: Lamé's constants λ = 0, 2G' = E for normal strains, G for shear strains.
        let mut d = full(Lame { lambda: 0.0, shear: 0.5 * young }, m);
        let ratio = material.shear / (0.5 * young);
        for k in [AD, BD, CD, AE, BE, CE, DE] {
            d[k][k] *= ratio;
        }
        add_poisson(material, m.area, &mut d);
        let shear = |k: usize| unit(k);
        let polar = m.yy + m.zz;
        let mut twist = [0.0; 17];
        twist[BE] = m.yy / polar;
        twist[CD] = -m.zz / polar;
        correct(material, section, [&shear(AD), &shear(AE), &twist], &mut d);
        Self::new(&d)
    }

    /// The part of [`SectionLaw::enhanced`] that is Poisson's effect on the axis, for reference directors g0.
    pub(super) fn poisson(material: Lame, section: &CrossSection, g0: &Directors) -> Self {
        let mut d = [[0.0; 17]; 17];
        let (axis, volume) = local_strains(g0, 0.0, 0.0);
        add_poisson_rows(material, section.moments.area * volume, &axis, &mut d);
        Self::new(&d)
    }

    /// Either of them for a beam that is curved or twisted in its reference state, with directors g0 in the local frame.
    ///
    /// The strains that have energy are those in the orthonormal frame of the reference section, E = F₀⁻ᵀ Ẽ F₀⁻¹ with
    /// F₀ = [g₁ g₂ g₃], which varies over the section; integrated by points.
    pub fn curved(material: Lame, section: &CrossSection, g0: &Directors, enhanced: bool) -> Self {
        let mut d = [[0.0; 17]; 17];
        let lambda = if enhanced { 0.0 } else { material.lambda };
        let normal = if enhanced { material.young() } else { material.lambda + 2.0 * material.shear };
        let (mut area, mut shear, mut twist) = (0.0, [[0.0; 17]; 2], [0.0; 17]);
        for point in &section.points {
            let (rows, volume) = local_strains(g0, point.y, point.z);
            let weight = point.weight * volume;
            for i in 0..3 {
                for j in 0..3 {
                    add_product(&rows[i], &rows[j], weight * if i == j { normal } else { lambda }, &mut d);
                }
                add_product(&rows[3 + i], &rows[3 + i], weight * material.shear, &mut d);
            }
            area += weight;
            let polar = section.moments.yy + section.moments.zz;
            for k in 0..17 {
                shear[0][k] += weight * rows[3][k];
                shear[1][k] += weight * rows[4][k];
                twist[k] += weight / polar * (point.y * rows[4][k] - point.z * rows[3][k]);
            }
        }
        if enhanced {
            let (axis, volume) = local_strains(g0, 0.0, 0.0);
            add_poisson_rows(material, section.moments.area * volume, &axis, &mut d);
            let [y, z] = shear.map(|row| row.map(|x| x / area));
            correct(material, section, [&y, &z, &twist], &mut d);
        }
        Self::new(&d)
    }

    /// The same law under the strains of the linked formulation at ξ of an element of length l.
    ///
    /// ε_ad + w ε_hd in the place of ε_ad and ε_ab + w' ε_hd in that of ε_ab, with w = ξ − ξ², and likewise with e, c: what
    /// the sections' directors would add if they were quadratic, so that the shear strain is linear along the element.
    ///
    /// Source: linked interpolation as in Jelenic & Papa (2011), here of strains of the fully parameterised element.
    #[must_use]
    pub fn linked(&self, xi: f64, length: f64) -> Self {
        let (value, slope) = (xi - xi * xi, (1.0 - 2.0 * xi) / length);
        let mut map: SMatrix<f64, 17, 17> = SMatrix::identity();
        map[(AD, DH)] = value;
        map[(AB, DH)] = slope;
        map[(AE, EH)] = value;
        map[(AC, EH)] = slope;
        let d = SMatrix::<f64, 17, 17>::from_fn(|k, l| self.entry(k, l));
        let d = map.transpose() * d * map;
        Self::new(&std::array::from_fn(|k| std::array::from_fn(|l| 0.5 * (d[(k, l)] + d[(l, k)]))))
    }
}

/// D of λ tr² E + 2G E:E over a straight section.
fn full(material: Lame, m: Moments) -> Form {
    let Lame { lambda: l, shear: g } = material;
    let p = l + 2.0 * g;
    let mut d = [[0.0; 17]; 17];
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

/// Adds what Poisson's ratio couples on the axis: λ+2G−E of each normal strain and λ between two.
fn add_poisson(material: Lame, area: f64, d: &mut Form) {
    add_poisson_rows(material, area, &[unit(AA), unit(DD), unit(EE), unit(AD), unit(AE), unit(DE)], d);
}

fn add_poisson_rows(material: Lame, area: f64, rows: &[[f64; 17]; 6], d: &mut Form) {
    let own = material.lambda + 2.0 * material.shear - material.young();
    for i in 0..3 {
        for j in 0..3 {
            add_product(&rows[i], &rows[j], area * if i == j { own } else { material.lambda }, d);
        }
    }
}

/// Brings the mean shear strains and the twist from G A and G (I_y + I_z) to k_y G A, k_z G A and G J.
fn correct(material: Lame, section: &CrossSection, [y, z, twist]: [&[f64; 17]; 3], d: &mut Form) {
    let (g, m) = (material.shear, section.moments);
    add_product(y, y, (section.shear[0] - 1.0) * g * m.area, d);
    add_product(z, z, (section.shear[1] - 1.0) * g * m.area, d);
    add_product(twist, twist, g * (section.torsion - m.yy - m.zz), d);
}

fn unit(k: usize) -> [f64; 17] {
    let mut row = [0.0; 17];
    row[k] = 1.0;
    row
}

fn add_product(x: &[f64; 17], y: &[f64; 17], factor: f64, d: &mut Form) {
    for k in 0..17 {
        for l in 0..17 {
            d[k][l] += factor * x[k] * y[l];
        }
    }
}

/// E₁₁, E₂₂, E₃₃, 2E₁₂, 2E₁₃, 2E₂₃ at (y, z) in the orthonormal frame of the reference section as rows over the section
/// strains, and det F₀.
pub(super) fn local_strains(g0: &Directors, y: f64, z: f64) -> ([[f64; 17]; 6], f64) {
    let n = g0[3].cross(&g0[4]).normalize();
    let second = g0[3].normalize();
    let frame = Matrix3::from_columns(&[n, second, n.cross(&second)]);
    let first = g0[0] + g0[1] * y + g0[2] * z;
    let f0 = frame.transpose() * Matrix3::from_columns(&[first, g0[3], g0[4]]);
    let inverse = f0.try_inverse().unwrap_or_else(Matrix3::identity);
    // Ẽ in the basis of the reference directors: each entry a combination of section strains.
    let of = |terms: &[(usize, f64)]| {
        let mut row = [0.0; 17];
        terms.iter().for_each(|&(k, x)| row[k] = x);
        row
    };
    let half = |terms: [(usize, f64); 3]| of(&terms.map(|(k, x)| (k, 0.5 * x)));
    let e11 = of(&[(AA, 1.0), (AB, y), (AC, z), (BB, y * y), (BC, y * z), (CC, z * z)]);
    let (e22, e33, e23) = (of(&[(DD, 1.0)]), of(&[(EE, 1.0)]), of(&[(DE, 0.5)]));
    let (e12, e13) = (half([(AD, 1.0), (BD, y), (CD, z)]), half([(AE, 1.0), (BE, y), (CE, z)]));
    let strains = [[e11, e12, e13], [e12, e22, e23], [e13, e23, e33]];
    let rotated = |i: usize, j: usize, factor: f64| -> [f64; 17] {
        let mut row = [0.0; 17];
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

/// Directors of a straight, undistorted reference section in its own frame.
pub(super) fn straight() -> Directors {
    let zero = Vector3::zeros();
    [Vector3::x(), zero, zero, Vector3::y(), Vector3::z(), zero]
}
