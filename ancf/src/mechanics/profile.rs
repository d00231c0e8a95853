use nalgebra::Vector3;

use super::element::Profile;
use super::formulation::straight;
use super::section::strain::{AA, BB, BD, CC, CE, DD, DE, EE};
use super::station::{Law, Relative, Station};
use super::{
    BeamShape, CrossSection, Directors, Interpolation, Kind, Lame, Moments, NeoHookean, QuadraticShape,
    SectionLaw, gauss, gauss2, gauss3, quadrature::lobatto3,
};

/// What a beam is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Lamé's constants.
    pub lame: Lame,
    /// Whether the law is neo-Hookean, not St. Venant-Kirchhoff's; for the continuum formulation.
    pub neo_hookean: bool,
    /// Density ρ.
    pub density: f64,
    /// Retardation time τ of Kelvin and Voigt: stresses are those of the strains E + τ dE/dt.
    pub retardation: f64,
    /// Rate α of the mass-proportional damping α M v.
    pub drag: f64,
    /// Acceleration of gravity.
    pub gravity: Vector3<f64>,
}

/// Which strains of the two-node element are how stiff, and where they are integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// Full three-dimensional elasticity at five points: exact for the polynomials, hence with all the locking.
    Continuum,
    /// [`SectionLaw::enhanced`] at five points.
    Enhanced,
    /// [`SectionLaw::enhanced`] under linked strains ([`SectionLaw::linked`]) at three points.
    Linked,
}

/// A quadrature point and its elasticity at the section there.
type Sample<'a> = (f64, f64, &'a dyn Fn(&Directors, &CrossSection) -> SectionLaw);

impl Profile<8> {
    /// Elements of a straight prismatic beam in the continuum formulation.
    pub fn new(shape: BeamShape, lame: Lame, density: f64, moments: Moments, gravity: Vector3<f64>) -> Self {
        let medium = Medium { lame, neo_hookean: false, density, retardation: 0.0, drag: 0.0, gravity };
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
        Self::two_node(shape, &reference, &|_| section.clone(), &medium, Formulation::Continuum)
    }

    /// Two-node elements with the given reference vectors, in any frame, and the section at ξ.
    pub fn two_node(
        shape: BeamShape,
        reference: &[Vector3<f64>; 8],
        section: &dyn Fn(f64) -> CrossSection,
        medium: &Medium,
        formulation: Formulation,
    ) -> Self {
        let (lame, length) = (medium.lame, shape.length);
        let enhanced = formulation != Formulation::Continuum;
        let law = |g0: &Directors, section: &CrossSection| match (is_straight(g0), enhanced) {
            (true, false) => SectionLaw::continuum(lame, section.moments),
            (true, true) => SectionLaw::enhanced(lame, section),
            (false, enhanced) => SectionLaw::curved(lame, section, g0, enhanced),
        };
        let mut profile = match formulation {
            Formulation::Continuum | Formulation::Enhanced => {
                let rule: Vec<Sample<'_>> = gauss().iter().map(|&(xi, w)| (xi, w, &law as _)).collect();
                Self::build(&shape, reference, section, medium, &rule)
            }
            Formulation::Linked => {
                let axial = |g0: &Directors, section: &CrossSection| {
                    law(g0, section).minus(&SectionLaw::poisson(lame, section, g0)).among(&[AA, BB, CC])
                };
                let nodal = |g0: &Directors, section: &CrossSection| {
                    let poisson = SectionLaw::poisson(lame, section, g0);
                    law(g0, section).minus(&poisson).among(&[DD, EE, DE]).plus(&poisson)
                };
                let mid = |g0: &Directors, section: &CrossSection| law(g0, section).among(&[BD, CE]);
                let rest = |g0: &Directors, section: &CrossSection| {
                    law(g0, section)
                        .minus(&axial(g0, section))
                        .minus(&nodal(g0, section))
                        .minus(&mid(g0, section))
                };
                let mut rule: Vec<Sample<'_>> = gauss3().iter().map(|&(xi, w)| (xi, w, &rest as _)).collect();
                rule.extend(lobatto3().iter().map(|&(xi, w)| -> Sample<'_> { (xi, w, &axial) }));
                rule.extend(
                    [(0.0, 0.5), (1.0, 0.5)].iter().map(|&(xi, w)| -> Sample<'_> { (xi, w, &nodal) }),
                );
                rule.push((0.5, 1.0, &mid));
                let mut profile = Self::build(&shape, reference, section, medium, &rule);
                profile.stations.iter_mut().for_each(|station| station.link(length));
                profile
            }
        };
        if formulation != Formulation::Linked {
            // Nothing reads h: what is zero costs nothing.
            for station in &mut profile.stations {
                for i in [0, 1, 4, 5] {
                    station.weights[i][1] = 0.0;
                }
                station.reference[5] = Vector3::zeros();
            }
        }
        profile
    }
}

impl Profile<9> {
    /// Three-node elements with the given reference vectors, in any frame, and the section at ξ.
    ///
    /// [`SectionLaw::enhanced`] without Poisson's effect at two points, which frees the element from shear locking;
    /// Poisson's effect on the axis at three.
    ///
    /// Source: Nachbagauer, Gruber & Gerstmayr (2013).
    pub fn three_node(
        shape: QuadraticShape,
        reference: &[Vector3<f64>; 9],
        section: &dyn Fn(f64) -> CrossSection,
        medium: &Medium,
    ) -> Self {
        let lame = medium.lame;
        let all = |g0: &Directors, section: &CrossSection| match is_straight(g0) {
            true => SectionLaw::enhanced(lame, section),
            false => SectionLaw::curved(lame, section, g0, true),
        };
        let nodal = |g0: &Directors, section: &CrossSection| {
            all(g0, section).minus(&SectionLaw::poisson(lame, section, g0)).among(&[DD, EE, DE])
        };
        let rest = |g0: &Directors, section: &CrossSection| all(g0, section).minus(&nodal(g0, section));
        let mut rule: Vec<Sample<'_>> = gauss2().iter().map(|&(xi, w)| (xi, w, &rest as _)).collect();
        rule.extend(lobatto3().iter().map(|&(xi, w)| -> Sample<'_> { (xi, w, &nodal) }));
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
        medium: &Medium,
        rule: &[Sample<'_>],
    ) -> Self {
        let relative = Relative::new::<S>(reference);
        let stations = rule.iter().map(|&(xi, w, law)| {
            let weights = shape.directors(xi);
            let directors = Station::<N>::sum::<S>(&weights, &relative);
            let g0 = settled(directors, shape.length());
            let section = section(xi);
            let quadratic = law(&g0, &section);
            let viscosity = (medium.retardation != 0.0).then(|| quadratic.times(medium.retardation));
            let law = if medium.neo_hookean {
                Law::Hyperelastic(NeoHookean::new(medium.lame, section.points))
            } else {
                Law::Quadratic(quadratic)
            };
            Station { xi, weight: w * shape.length(), weights, reference: g0, law, viscosity }
        });
        let (mut mass, mut first) = ([[0.0; N]; N], [0.0; N]);
        for (xi, w) in gauss() {
            let (section, values) = (section(xi), shape.values(xi));
            let weight = w * shape.length() * medium.density;
            for a in 0..N {
                if matches!(S::KINDS[a], Kind::Position | Kind::Slope) {
                    first[a] += weight * section.moments.area * values[a];
                }
                for b in 0..N {
                    let moment = match (S::KINDS[a], S::KINDS[b]) {
                        (Kind::Y, Kind::Y) => section.inertia[0],
                        (Kind::Z, Kind::Z) => section.inertia[1],
                        (Kind::Y | Kind::Z, _) | (_, Kind::Y | Kind::Z) => continue,
                        _ => section.moments.area,
                    };
                    mass[a][b] += weight * moment * values[a] * values[b];
                }
            }
        }
        Self { stations: stations.collect(), mass, first, gravity: medium.gravity, drag: medium.drag }
    }
}

impl Station<8> {
    /// Brings its laws under linked strains.
    fn link(&mut self, length: f64) {
        if let Law::Quadratic(law) = &mut self.law {
            *law = law.linked(self.xi, length);
        }
        self.viscosity = self.viscosity.as_ref().map(|law| law.linked(self.xi, length));
    }
}

/// Directors that are straight but for rounding, straight.
fn settled(g0: Directors, length: f64) -> Directors {
    let scales = [1.0, length, length, 1.0, 1.0, 1.0];
    let near = g0.iter().zip(straight()).zip(scales).all(|((g, s), scale)| (g - s).amax() * scale < 1e-12);
    if near { straight() } else { g0 }
}
