//! Elastic laws of sections: continuum by points and by moments of area, rods in closed form, twisted and curved references.

use ancf::mechanics::sections::{CrossSection, DeformationFactors, Directors, SectionLaw};
use ancf::model::Section;
use nalgebra::{Rotation3, Vector3};

use super::directors::{LAME, SECTIONS, rotated, straight, sum};
use crate::common::continuum;
use crate::common::random::Random;

const POISSON: f64 = 0.3;

fn cross_section(section: Section) -> CrossSection {
    section.cross_section(POISSON)
}

/// Directors a .. e; h and k vanish for a straight reference.
fn directors([a, b, c, d, e]: [Vector3<f64>; 5]) -> Directors {
    [a, b, c, d, e, Vector3::zeros(), Vector3::zeros()]
}

/// Directors of a bar twisted by `rate` per length.
fn twisted(rate: f64) -> Directors {
    directors([Vector3::x(), Vector3::z() * rate, Vector3::y() * -rate, Vector3::y(), Vector3::z()])
}

fn random_directors(random: &mut Random, size: f64) -> Directors {
    directors(std::array::from_fn(|_| random.vector3() * size))
}

/// Energy per length by integration over the section.
fn reference_energy(section: Section, g0: &Directors, g: &Directors) -> f64 {
    continuum::integrate_section(section, |at| {
        let [j, j0] = [g, g0].map(|g| continuum::gradient_of_directors(g, at));
        continuum::energy_density(LAME, &j, &j0)
    })
}

/// Integration by points and by moments of area, for a straight reference.
#[test]
fn integration_by_points_equals_moments_of_area() {
    let mut random = Random(1);
    for section in SECTIONS {
        let by_points = SectionLaw::curved(LAME, &cross_section(section.clone()), &straight());
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

/// Stretch, further twist and arbitrary motion of a twisted prismatic bar: the energy is that of the volume.
///
/// A further twist τ has the energy ½G I_p τ² + ½(λ+2G)∫(½r²τ²)² dA, independent of the initial twist.
#[test]
fn twisted_bars_have_the_energy_of_their_volume() {
    let mut random = Random(2);
    for section in SECTIONS {
        for rate in [0.5, -2.0] {
            let g0 = twisted(rate);
            let law = SectionLaw::curved(LAME, &cross_section(section.clone()), &g0);
            let mut stretched = g0;
            stretched[0] *= 1.1;
            let any = sum(&g0, &random_directors(&mut random, 0.5), 1.0);
            for g in [stretched, twisted(rate + 0.3), any] {
                let (energy, expected) =
                    (law.energy(&g0, &sum(&g, &g0, -1.0)), reference_energy(section.clone(), &g0, &g));
                assert!(
                    (energy / expected - 1.0).abs() < 1e-12,
                    "{section:?}, {rate}: {energy} and {expected}"
                );
            }
            let m = section.moments();
            let fourth = m.yyyy + 2.0 * m.yyzz + m.zzzz;
            let expected = 0.5 * LAME.shear * (m.yy + m.zz) * 0.09
                + 0.125 * (LAME.lambda + 2.0 * LAME.shear) * fourth * 0.0081;
            let energy = law.energy(&g0, &sum(&twisted(rate + 0.3), &g0, -1.0));
            assert!((energy / expected - 1.0).abs() < 1e-12, "{section:?}, {rate}: {energy} and {expected}");
        }
    }
}

/// Random references: curved, twisted and skew, in any frame.
fn random_references(random: &mut Random) -> Vec<Directors> {
    (0..5)
        .map(|_| {
            let r = Rotation3::new(random.vector3() * 3.0);
            rotated(r, &sum(&straight(), &random_directors(random, 0.2), 1.0))
        })
        .collect()
}

/// Rotations before and after a deformation do not change the energy, nor does the frame of the reference.
#[test]
fn rotations_do_not_change_the_energy() {
    let mut random = Random(3);
    for section in SECTIONS {
        let cross = cross_section(section.clone());
        for g0 in random_references(&mut random) {
            let laws = |g0: &Directors| {
                [
                    SectionLaw::curved(LAME, &cross, g0),
                    SectionLaw::enhanced(LAME, &cross, g0, &DeformationFactors::ELASTIC),
                ]
            };
            let (u, r) = (random_directors(&mut random, 0.3), Rotation3::new(random.vector3() * 3.0));
            let turned = |g: &Directors| rotated(r, g);
            for (law, law_in_turned_frame) in laws(&g0).iter().zip(laws(&turned(&g0))) {
                let energy = law.energy(&g0, &u);
                let after = law.energy(&g0, &sum(&turned(&sum(&g0, &u, 1.0)), &g0, -1.0));
                let before = law_in_turned_frame.energy(&turned(&g0), &turned(&u));
                assert!((after / energy - 1.0).abs() < 1e-12, "{section:?}: {after} and {energy}");
                assert!((before / energy - 1.0).abs() < 1e-12, "{section:?}: {before} and {energy}");
                assert!(law.energy(&g0, &sum(&turned(&g0), &g0, -1.0)) < 1e-28, "{section:?}");
            }
        }
    }
}

/// Stretch, bending, shear and twist of a straight rod, each alone, with ε₁₁ the Green strain of a fibre.
///
/// Fixed lateral directors store the energy of the suppressed contraction ν ε_aa.
#[test]
fn rod_energies_have_closed_forms() {
    let young = LAME.young();
    let poisson = 0.5 * LAME.lambda / (LAME.lambda + LAME.shear);
    for section in SECTIONS {
        let (m, cross) = (section.moments(), cross_section(section.clone()));
        let law = SectionLaw::enhanced(LAME, &cross, &straight(), &DeformationFactors::ELASTIC);
        // Energy of the suppressed contraction at the axial strain ε.
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
        let expected = [
            axial(x + square),
            0.5 * young * (m.yy * x * x + m.yyyy * square * square),
            0.5 * young * (m.zz * x * x + m.zzzz * square * square),
            0.5 * cross.shear[1] * LAME.shear * m.area * x * x + axial(square),
            0.5 * LAME.shear * cross.torsion * x * x + 0.5 * young * fourth * square * square,
        ];
        for (u, expected) in cases.iter().zip(expected) {
            let energy = law.energy(&straight(), u);
            assert!((energy / expected - 1.0).abs() < 1e-12, "{section:?}: {energy} and {expected}");
        }
    }
}

/// EA and EI of a curved rod by Winkler's theory, ∫dA/(1 − κy) and ∫y² dA/(1 − κy), to the accuracy of 16 points.
#[test]
fn curved_rods_have_the_stiffness_of_winkler() {
    let (curvature, young) = (0.8, LAME.young());
    let zero = Vector3::zeros();
    let g0 = directors([Vector3::x(), Vector3::x() * -curvature, zero, Vector3::y(), Vector3::z()]);
    for section in SECTIONS {
        let law = SectionLaw::rod(LAME, &cross_section(section.clone()), &g0, &DeformationFactors::ELASTIC);
        let small = 1e-6;
        let moment = |power: i32| {
            continuum::integrate_section(section.clone(), |[y, _]| y.powi(power) / (1.0 - curvature * y))
        };
        let mut cases = [[zero; 7]; 2];
        cases[0][0] = Vector3::x() * small;
        cases[1][1] = Vector3::x() * small;
        for (u, expected) in cases.iter().zip([moment(0), moment(2)]) {
            let energy = law.energy(&g0, u) / (0.5 * young * small * small);
            assert!((energy / expected - 1.0).abs() < 2e-6, "{section:?}: {energy} and {expected}");
        }
    }
}

/// Laws of stretch, bending and torsion alone sum to the rod law. Each vanishes in the deformations of the others.
#[test]
fn parts_of_a_rod_law_are_separate() {
    let (zero, small) = (Vector3::zeros(), 1e-6);
    let only = |k: usize| {
        let mut factors = [0.0; 3];
        factors[k] = 1.0;
        let [stretch, bending, torsion] = factors;
        DeformationFactors { stretch, bending, torsion, ..DeformationFactors::default() }
    };
    for section in SECTIONS {
        let cross = cross_section(section.clone());
        let laws = [0, 1, 2].map(|k| SectionLaw::rod(LAME, &cross, &straight(), &only(k)));
        let whole = SectionLaw::rod(LAME, &cross, &straight(), &DeformationFactors::ELASTIC);
        // Strain of the axis, curvatures about z and y, twist.
        let x = Vector3::x() * small;
        let twist = [zero, Vector3::z() * small, Vector3::y() * -small, zero, zero, zero, zero];
        let deformations = [
            [x, zero, zero, zero, zero, zero, zero],
            [zero, x, zero, zero, zero, zero, zero],
            [zero, zero, x, zero, zero, zero, zero],
            twist,
        ];
        for (u, owner) in deformations.iter().zip([0, 1, 1, 2]) {
            let energies = laws.each_ref().map(|law| law.energy(&straight(), u));
            let expected = whole.energy(&straight(), u);
            for (k, energy) in energies.iter().enumerate() {
                let expected = if k == owner { expected } else { 0.0 };
                // The quadratic parts of the strains are of the order of the deformation.
                assert!(
                    (energy - expected).abs() < 1e-5 * whole.energy(&straight(), u),
                    "{section:?}: {energies:?}"
                );
            }
        }
        let mut random = Random(3);
        for _ in 0..5 {
            let u = std::array::from_fn(|i| if i < 5 { random.vector3() * 0.3 } else { zero });
            let sum: f64 = laws.iter().map(|law| law.energy(&straight(), &u)).sum();
            let expected = whole.energy(&straight(), &u);
            assert!((sum / expected - 1.0).abs() < 1e-12, "{section:?}: {sum} and {expected}");
        }
    }
}
