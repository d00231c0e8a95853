use nalgebra::Vector3;

use super::beam::Profile;
use super::station::{BeamStation, DirectorWeights, RelativeVectors, StationLaw};
use crate::kinematics::{BeamShape, Interpolation, QuadraticShape, VectorKind, gauss, gauss2, lobatto3};
use crate::sections::{
    CrossSection, DIRECTORS, DeformationFactors, Directors, Lame, Moments, NeoHookean, SectionLaw, straight,
};

/// Material, damping and gravity of a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamMaterial {
    /// Lamé's constants.
    pub lame: Lame,
    /// True for the neo-Hookean law, false for St. Venant-Kirchhoff. Applies to the continuum formulation.
    pub neo_hookean: bool,
    /// Density ρ.
    pub density: f64,
    /// Retardation times τ of the Kelvin-Voigt model.
    pub retardation: DeformationFactors,
    /// Rate α of the mass-proportional damping α M v.
    pub mass_damping: f64,
    /// Acceleration of gravity.
    pub gravity: Vector3<f64>,
}

/// Elastic law of the two-node element: stiffness of the strains and their quadrature points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TwoNodeLaw {
    /// Full three-dimensional elasticity at five points. The quadrature is exact, so the element has all kinds of
    /// locking.
    Continuum,
    /// [`SectionLaw::enhanced`] at five points.
    Enhanced,
    /// [`SectionLaw::rod`] under linked strains ([`SectionLaw::linked`]), with [`SectionLaw::transverse`] at the nodes.
    ///
    /// The rod law is integrated by Simpson's rule at the nodes and the middle. At the nodes r_x, r_y and r_z are
    /// independent coordinates. Neither the axial strain nor the deformation of the section locks in bending.
    Linked,
}

/// Quadrature point with its law.
type LawPoint<'a> = (f64, f64, &'a SectionLawFn<'a>);
/// Law as a function of ξ, reference directors, section and factors of its parts.
type SectionLawFn<'a> = dyn Fn(f64, &Directors, &CrossSection, &DeformationFactors) -> SectionLaw + 'a;

fn at<'a>(rule: &[(f64, f64)], law: &'a SectionLawFn<'a>) -> Vec<LawPoint<'a>> {
    rule.iter().map(|&(xi, w)| (xi, w, law)).collect()
}

impl Profile<8> {
    /// Creates the profile of a straight prismatic beam in the continuum formulation.
    pub fn new(shape: BeamShape, lame: Lame, density: f64, moments: Moments, gravity: Vector3<f64>) -> Self {
        let medium = BeamMaterial {
            lame,
            neo_hookean: false,
            density,
            retardation: DeformationFactors::default(),
            mass_damping: 0.0,
            gravity,
        };
        let section = CrossSection {
            moments,
            inertia: [moments.yy, moments.zz],
            torsion: moments.yy + moments.zz,
            shear: [1.0; 2],
            points: Vec::new(),
        };
        let (l, zero) = (shape.slope, Vector3::zeros());
        let node = |x: f64| [Vector3::x() * x, Vector3::x() * l, Vector3::y() * l, Vector3::z() * l];
        let [near, far] = [node(0.0), node(shape.length)];
        let mut reference = [zero; 8];
        reference[..4].copy_from_slice(&near);
        reference[4..].copy_from_slice(&far);
        Self::two_node(shape, &reference, &|_| section.clone(), &medium, TwoNodeLaw::Continuum)
    }

    /// Creates the profile of two-node elements. The reference vectors are in any frame; `section` is the section at ξ.
    pub fn two_node(
        shape: BeamShape,
        reference: &[Vector3<f64>; 8],
        section: &dyn Fn(f64) -> CrossSection,
        medium: &BeamMaterial,
        formulation: TwoNodeLaw,
    ) -> Self {
        let (lame, length) = (medium.lame, shape.length);
        let continuum =
            |_: f64, g0: &Directors, section: &CrossSection, factors: &DeformationFactors| match is_straight(
                g0,
            ) {
                true => SectionLaw::continuum(lame, section.moments).times(factors.section),
                false => SectionLaw::curved(lame, section, g0).times(factors.section),
            };
        let middle = gauss().into_iter().find(|&(xi, _)| xi == 0.5).map_or(1.0, |(_, weight)| weight);
        let enhanced = |xi: f64, g0: &Directors, section: &CrossSection, factors: &DeformationFactors| {
            let law = SectionLaw::enhanced(lame, section, g0, factors);
            if xi != 0.5 {
                return law;
            }
            law.plus(&SectionLaw::gradient(lame, section, g0).times(factors.section / middle))
        };
        let linked = |xi: f64, g0: &Directors, section: &CrossSection, factors: &DeformationFactors| {
            let rod = SectionLaw::rod(lame, section, g0, factors).linked(xi, length);
            // Simpson's weights at the nodes are 1/6, and those of the trapezoidal rule 1/2. The weight in the middle is 2/3.
            if xi == 0.5 {
                let variation = SectionLaw::axial_variation(lame, section).times(1.5 * factors.stretch);
                rod.plus(&SectionLaw::gradient(lame, section, g0).times(1.5 * factors.section))
                    .plus(&variation)
            } else {
                let shear = SectionLaw::shear(lame, section, g0).times(3.0 * factors.shear);
                rod.plus(&shear).plus(&SectionLaw::transverse(lame, section, g0).times(3.0 * factors.section))
            }
        };
        let rule = match formulation {
            TwoNodeLaw::Continuum => at(&gauss(), &continuum),
            TwoNodeLaw::Enhanced => at(&gauss(), &enhanced),
            TwoNodeLaw::Linked => at(&lobatto3(), &linked),
        };
        Self::build(&shape, reference, section, medium, &rule)
    }
}

impl Profile<9> {
    /// Creates the profile of three-node elements. The reference vectors are in any frame; `section` is the section at
    /// ξ.
    ///
    /// [`SectionLaw::rod`] is integrated at two Gauss points, which avoids shear and membrane locking.
    /// [`SectionLaw::transverse`] is integrated by Simpson's rule, with the axial strain of the Gauss points
    /// ([`SectionLaw::reduced`]).
    ///
    /// Source: Nachbagauer, Gruber & Gerstmayr (2013) for the element and the two points. The deformation of the
    /// section at the nodes is specific to this implementation. At the Gauss points, modes with zero or negative energy
    /// would remain, and at more points the element would lock.
    pub fn three_node(
        shape: QuadraticShape,
        reference: &[Vector3<f64>; 9],
        section: &dyn Fn(f64) -> CrossSection,
        medium: &BeamMaterial,
    ) -> Self {
        let lame = medium.lame;
        let rod = |_: f64, g0: &Directors, section: &CrossSection, factors: &DeformationFactors| {
            SectionLaw::rod(lame, section, g0, factors)
                .plus(&SectionLaw::shear(lame, section, g0).times(factors.shear))
                .plus(&SectionLaw::gradient(lame, section, g0).times(factors.section))
        };
        let transverse = |xi: f64, g0: &Directors, section: &CrossSection, factors: &DeformationFactors| {
            SectionLaw::transverse(lame, section, g0).times(factors.section).reduced(xi)
        };
        let mut rule = at(&gauss2(), &rod);
        rule.extend(at(&lobatto3(), &transverse));
        Self::build(&shape, reference, section, medium, &rule)
    }
}

fn is_straight(g0: &Directors) -> bool {
    g0.iter().zip(straight()).take(5).all(|(g0, straight)| *g0 == straight)
}

impl<const N: usize> Profile<N> {
    fn build<S: Interpolation<N>>(
        shape: &S,
        reference: &[Vector3<f64>; N],
        section: &dyn Fn(f64) -> CrossSection,
        medium: &BeamMaterial,
        rule: &[LawPoint<'_>],
    ) -> Self {
        let relative = RelativeVectors::new::<S>(reference);
        let stations = rule.iter().map(|&(xi, w, law)| {
            let weights = shape.directors(xi);
            let parts = |reach: usize| -> [DirectorWeights; N] {
                std::array::from_fn(|i| DirectorWeights::new(S::KINDS[i].directors(), weights[i], reach))
            };
            let mut g0 = snapped_straight(relative.directors::<S>(&parts(DIRECTORS)), shape.length());
            let section = section(xi);
            let quadratic = law(xi, &g0, &section, &DeformationFactors::ELASTIC);
            // Unused directors are set to zero.
            let reach = quadratic.reach().max(5);
            g0[reach..].fill(Vector3::zeros());
            let viscosity = match medium.retardation.common() {
                Some(time) => (time != 0.0).then(|| quadratic.times(time)),
                None => Some(law(xi, &g0, &section, &medium.retardation)),
            };
            let law = if medium.neo_hookean {
                StationLaw::Hyperelastic(NeoHookean::new(medium.lame, section.points))
            } else {
                StationLaw::Quadratic(quadratic)
            };
            BeamStation { xi, weight: w * shape.length(), parts: parts(reach), reference: g0, law, viscosity }
        });
        let (mut mass, mut first) = ([[0.0; N]; N], [0.0; N]);
        for (xi, w) in gauss() {
            let (section, values) = (section(xi), shape.values(xi));
            let weight = w * shape.length() * medium.density;
            for a in 0..N {
                if matches!(S::KINDS[a], VectorKind::Position | VectorKind::Slope) {
                    first[a] += weight * section.moments.area * values[a];
                }
                for b in 0..N {
                    let moment = match (S::KINDS[a], S::KINDS[b]) {
                        (VectorKind::Y, VectorKind::Y) => section.inertia[0],
                        (VectorKind::Z, VectorKind::Z) => section.inertia[1],
                        (VectorKind::Y | VectorKind::Z, _) | (_, VectorKind::Y | VectorKind::Z) => continue,
                        _ => section.moments.area,
                    };
                    mass[a][b] += weight * moment * values[a] * values[b];
                }
            }
        }
        let BeamMaterial { gravity, mass_damping, retardation, .. } = *medium;
        Self { stations: stations.collect(), mass, first, gravity, mass_damping, retardation }
    }
}

/// Replaces directors that are straight within rounding by exactly straight ones.
fn snapped_straight(g0: Directors, length: f64) -> Directors {
    let scales = [1.0, length, length, 1.0, 1.0, 1.0, 1.0];
    let near = g0.iter().zip(straight()).zip(scales).all(|((g, s), scale)| (g - s).amax() * scale < 1e-12);
    if near { straight() } else { g0 }
}
