//! Elasticity of sections: the continuum by points and by moments, that of a rod in closed form, twisted and curved references.

use crate::common::continuum;
use crate::common::sample::Random;
use ancf::mechanics::{CrossSection, Directors, Lame, SectionLaw};
use ancf::model::Section;
use nalgebra::{Rotation3, Vector3};

const POISSON: f64 = 0.3;
const LAME: Lame = Lame { lambda: 3.0, shear: 2.0 };
const SECTIONS: [Section; 4] = [
    Section::Circle { diameter: 0.3 },
    Section::Tube { outer: 0.4, inner: 0.3 },
    Section::Rectangle { height: 0.3, width: 0.2 },
    Section::Ellipse { height: 0.2, width: 0.4 },
];

fn cross_section(section: Section) -> CrossSection {
    section.cross_section(POISSON)
}

/// a, b, c, d, e and, which a straight reference has none of, h and k.
fn directors([a, b, c, d, e]: [Vector3<f64>; 5]) -> Directors {
    [a, b, c, d, e, Vector3::zeros(), Vector3::zeros()]
}

fn straight() -> Directors {
    let zero = Vector3::zeros();
    directors([Vector3::x(), zero, zero, Vector3::y(), Vector3::z()])
}

/// Twisted by `rate` per length.
fn twisted(rate: f64) -> Directors {
    directors([Vector3::x(), Vector3::z() * rate, Vector3::y() * -rate, Vector3::y(), Vector3::z()])
}

fn sum(g: &Directors, u: &Directors, factor: f64) -> Directors {
    std::array::from_fn(|i| g[i] + u[i] * factor)
}

fn random_directors(random: &mut Random, size: f64) -> Directors {
    directors(std::array::from_fn(|_| random.vector3() * size))
}

/// Energy per length by an integral over the section.
fn brute(section: Section, g0: &Directors, g: &Directors) -> f64 {
    continuum::integrate_section(section, |at| {
        let [j, j0] = [g, g0].map(|g| continuum::gradient_of_directors(g, at));
        continuum::energy_density(LAME, &j, &j0)
    })
}

/// A straight reference by points is that by moments.
#[test]
fn points_are_as_good_as_moments() {
    let mut random = Random(1);
    for section in SECTIONS {
        let by_points = SectionLaw::curved(LAME, &cross_section(section), &straight());
        let by_moments = SectionLaw::continuum(LAME, section.moments());
        for _ in 0..10 {
            let u = random_directors(&mut random, 1.0);
            let energies = [&by_points, &by_moments].map(|law| law.energy(&straight(), &u));
            assert!((energies[0] / energies[1] - 1.0).abs() < 1e-13, "{section:?}: {energies:?}");
            let [p, q] = [&by_points, &by_moments].map(|law| law.forces(&straight(), &u));
            let size = q.iter().map(|q| q.norm()).fold(0.0, f64::max);
            let error = sum(&p, &q, -1.0).iter().map(|p| p.norm()).fold(0.0, f64::max);
            assert!(error < 1e-13 * size, "{section:?}: {error:e} of {size:e}");
        }
    }
}

/// A twisted prismatic bar: stretched, twisted on, and in any motion, it has the energy of its volume. Twisted on by τ, it does
/// not know of its first twist: ½G I_p τ² + ½(λ+2G)∫(½r²τ²)² dA.
#[test]
fn twisted_bars_are_continua() {
    let mut random = Random(2);
    for section in SECTIONS {
        for rate in [0.5, -2.0] {
            let g0 = twisted(rate);
            let law = SectionLaw::curved(LAME, &cross_section(section), &g0);
            let mut stretched = g0;
            stretched[0] *= 1.1;
            let any = sum(&g0, &random_directors(&mut random, 0.5), 1.0);
            for g in [stretched, twisted(rate + 0.3), any] {
                let (energy, wanted) = (law.energy(&g0, &sum(&g, &g0, -1.0)), brute(section, &g0, &g));
                assert!((energy / wanted - 1.0).abs() < 1e-12, "{section:?}, {rate}: {energy} and {wanted}");
            }
            let m = section.moments();
            let fourth = m.yyyy + 2.0 * m.yyzz + m.zzzz;
            let wanted = 0.5 * LAME.shear * (m.yy + m.zz) * 0.09
                + 0.125 * (LAME.lambda + 2.0 * LAME.shear) * fourth * 0.0081;
            let energy = law.energy(&g0, &sum(&twisted(rate + 0.3), &g0, -1.0));
            assert!((energy / wanted - 1.0).abs() < 1e-12, "{section:?}, {rate}: {energy} and {wanted}");
        }
    }
}

/// References that are curved, twisted and skew, in any frame.
fn references(random: &mut Random) -> Vec<Directors> {
    let frame = |random: &mut Random| Rotation3::new(random.vector3() * 3.0);
    let skew = |random: &mut Random| sum(&straight(), &random_directors(random, 0.2), 1.0);
    (0..5)
        .map(|_| {
            let r = frame(random);
            skew(random).map(|g| r * g)
        })
        .collect()
}

/// Rotations cost nothing, before and after a deformation, and the frame in which a reference is told does not matter.
#[test]
fn rotations_cost_nothing() {
    let mut random = Random(3);
    for section in SECTIONS {
        let cross = cross_section(section);
        for g0 in references(&mut random) {
            let laws = |g0: &Directors| {
                [SectionLaw::curved(LAME, &cross, g0), SectionLaw::enhanced(LAME, &cross, g0)]
            };
            let (u, r) = (random_directors(&mut random, 0.3), Rotation3::new(random.vector3() * 3.0));
            let turned = |g: &Directors| g.map(|g| r * g);
            for (law, of_turned) in laws(&g0).iter().zip(laws(&turned(&g0))) {
                let energy = law.energy(&g0, &u);
                let after = law.energy(&g0, &sum(&turned(&sum(&g0, &u, 1.0)), &g0, -1.0));
                let before = of_turned.energy(&turned(&g0), &turned(&u));
                assert!((after / energy - 1.0).abs() < 1e-12, "{section:?}: {after} and {energy}");
                assert!((before / energy - 1.0).abs() < 1e-12, "{section:?}: {before} and {energy}");
                assert!(law.energy(&g0, &sum(&turned(&g0), &g0, -1.0)) < 1e-28, "{section:?}");
            }
        }
    }
}

/// Stretch, bending, shear and twist of a straight rod, each alone, with ε₁₁ = Green's strain of a fibre; what a strain of the axis
/// does to the sides, they pay for: ν ε_aa.
#[test]
fn rods_in_closed_form() {
    let young = LAME.young();
    let poisson = 0.5 * LAME.lambda / (LAME.lambda + LAME.shear);
    for section in SECTIONS {
        let (m, cross) = (section.moments(), cross_section(section));
        let law = SectionLaw::enhanced(LAME, &cross, &straight());
        // Both sides held while the axis has the strain ε.
        let sides = |strain: f64| 2.0 * (LAME.lambda + LAME.shear) * m.area * (poisson * strain).powi(2);
        let axial = |strain: f64| 0.5 * young * m.area * strain * strain + sides(strain);
        let x = 0.2_f64;
        let square = 0.5 * x * x;
        let fourth = m.yyyy + 2.0 * m.yyzz + m.zzzz;
        let mut cases = [[Vector3::zeros(); 7]; 5];
        cases[0][0] = Vector3::x() * x;
        cases[1][1] = Vector3::x() * x;
        cases[2][2] = Vector3::x() * x;
        cases[3][0] = Vector3::z() * x;
        cases[4] = sum(&twisted(x), &straight(), -1.0);
        let wanted = [
            axial(x + square),
            0.5 * young * (m.yy * x * x + m.yyyy * square * square),
            0.5 * young * (m.zz * x * x + m.zzzz * square * square),
            0.5 * cross.shear[1] * LAME.shear * m.area * x * x + axial(square),
            0.5 * LAME.shear * cross.torsion * x * x + 0.5 * young * fourth * square * square,
        ];
        for (u, wanted) in cases.iter().zip(wanted) {
            let energy = law.energy(&straight(), u);
            assert!((energy / wanted - 1.0).abs() < 1e-12, "{section:?}: {energy} and {wanted}");
        }
    }
}

/// A curved rod of depth h at the radius R: EA and EI of Winkler's theory, ∫dA/(1 − κy) and ∫y² dA/(1 − κy), to the 16 points.
#[test]
fn curved_rods_are_stiffer_inside() {
    let (curvature, young) = (0.8, LAME.young());
    let zero = Vector3::zeros();
    let g0 = directors([Vector3::x(), Vector3::x() * -curvature, zero, Vector3::y(), Vector3::z()]);
    for section in SECTIONS {
        let law = SectionLaw::rod(LAME, &cross_section(section), &g0);
        let small = 1e-6;
        let moment = |power: i32| {
            continuum::integrate_section(section, |[y, _]| y.powi(power) / (1.0 - curvature * y))
        };
        let mut cases = [[zero; 7]; 2];
        cases[0][0] = Vector3::x() * small;
        cases[1][1] = Vector3::x() * small;
        for (u, wanted) in cases.iter().zip([moment(0), moment(2)]) {
            let energy = law.energy(&g0, u) / (0.5 * young * small * small);
            assert!((energy / wanted - 1.0).abs() < 2e-6, "{section:?}: {energy} and {wanted}");
        }
    }
}
