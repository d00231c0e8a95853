//! Neo-Hookean law of a section: derivatives of the energy, limit of small strains, closed forms.

use ancf::mechanics::sections::{Directors, Lame, NeoHookean, SectionLaw, SectionPoint, Stiffness};
use ancf::model::Section;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::directors::{LAME, SECTIONS, rotated, straight, sum};
use crate::common::continuum::gradient_of_directors;
use crate::common::random::Random;

fn random_directors(random: &mut Random, size: f64) -> Directors {
    std::array::from_fn(|_| random.vector3() * size)
}

fn points(section: Section) -> Vec<SectionPoint> {
    section.points().expect("the section has a shape")
}

fn law(lame: Lame, section: Section) -> NeoHookean {
    NeoHookean::new(lame, points(section))
}

/// Second derivative of an energy by directors.
fn stiffness(add: impl Fn(&mut Stiffness)) -> Stiffness {
    let mut h = [[Matrix3::zeros(); 7]; 7];
    add(&mut h);
    h
}

fn dot(p: &Directors, u: &Directors) -> f64 {
    p.iter().zip(u).map(|(p, u)| p.dot(u)).sum()
}

fn size(p: &Directors) -> f64 {
    p.iter().map(Vector3::amax).fold(0.0, f64::max)
}

fn distance(p: &Directors, q: &Directors) -> f64 {
    size(&sum(p, q, -1.0))
}

/// Sections with straight, curved, twisted and skew references, and moderate increments.
fn samples() -> Vec<(Section, Directors, Directors)> {
    let mut random = Random(1998);
    let mut samples = Vec::new();
    for section in SECTIONS {
        for _ in 0..5 {
            samples.push((section.clone(), straight(), random_directors(&mut random, 0.2)));
            let tilted = rotated(Rotation3::new(random.vector3() * 3.0), &straight());
            samples.push((
                section.clone(),
                sum(&tilted, &random_directors(&mut random, 0.2), 1.0),
                random_directors(&mut random, 0.2),
            ));
        }
    }
    samples
}

/// Derivative f'(0) by central differences of fourth order.
fn derivative<T>(f: impl Fn(f64) -> T, combine: impl Fn([(T, f64); 4]) -> T) -> T {
    let h = 1e-3;
    combine([-2.0, -1.0, 1.0, 2.0].map(|k: f64| {
        let weight = if k.abs() > 1.5 { -1.0 } else { 8.0 } * k.signum() / (12.0 * h);
        (f(k * h), weight)
    }))
}

#[test]
fn reference_has_no_energy_and_no_force() {
    for (section, g0, _) in samples() {
        let (law, rest) = (law(LAME, section), [Vector3::zeros(); 7]);
        assert_eq!(law.energy(&g0, &rest), 0.0);
        assert_eq!(law.forces(&g0, &rest), rest);
        assert!(law.is_admissible(&g0, &rest));
    }
}

#[test]
fn forces_are_derivatives_of_the_energy() {
    let mut random = Random(3);
    for (section, g0, u) in samples() {
        let (law, direction) = (law(LAME, section.clone()), random_directors(&mut random, 1.0));
        let slope = derivative(
            |h| law.energy(&g0, &sum(&u, &direction, h)),
            |terms| terms.iter().map(|(value, weight)| value * weight).sum(),
        );
        let power = dot(&law.forces(&g0, &u), &direction);
        let scale = size(&law.forces(&g0, &u));
        assert!((power - slope).abs() < 1e-9 * scale, "{section:?}: {power} and {slope}");
    }
}

#[test]
fn stiffness_is_the_symmetric_derivative_of_the_forces() {
    let mut random = Random(4);
    for (section, g0, u) in samples() {
        let (law, direction) = (law(LAME, section.clone()), random_directors(&mut random, 1.0));
        let slope = derivative(
            |h| law.forces(&g0, &sum(&u, &direction, h)),
            |terms| {
                terms.iter().fold([Vector3::zeros(); 7], |slope, (value, weight)| sum(&slope, value, *weight))
            },
        );
        let h = stiffness(|h| law.add_stiffness(&g0, &u, 1.0, h));
        let of = |i: usize, j: usize| if i >= j { h[i][j] } else { h[j][i].transpose() };
        let product: Directors = std::array::from_fn(|i| (0..7).map(|j| of(i, j) * direction[j]).sum());
        let error = distance(&product, &slope) / size(&slope);
        assert!(error < 1e-9, "{section:?}: {error:e}");
        for (i, row) in h.iter().enumerate() {
            assert!((row[i] - row[i].transpose()).amax() <= 1e-13 * row[i].amax(), "{section:?}: block {i}");
        }
    }
}

/// Superposed rotations do not change the energy and rotate the forces.
#[test]
fn rotations_do_not_change_the_energy() {
    let mut random = Random(5);
    for (section, g0, u) in samples() {
        let (law, r) = (law(LAME, section.clone()), Rotation3::new(random.vector3() * 3.0));
        let from = |g: &Directors| sum(&rotated(r, g), &g0, -1.0);
        let (energy, forces) = (law.energy(&g0, &u), law.forces(&g0, &u));
        let moved = from(&sum(&g0, &u, 1.0));
        assert!((law.energy(&g0, &moved) / energy - 1.0).abs() < 1e-12, "{section:?}");
        assert!(
            distance(&law.forces(&g0, &moved), &rotated(r, &forces)) < 1e-12 * size(&forces),
            "{section:?}"
        );
        assert!(law.energy(&g0, &from(&g0)) < 1e-28, "{section:?}: {:e}", law.energy(&g0, &from(&g0)));
        assert!(size(&law.forces(&g0, &from(&g0))) < 1e-13, "{section:?}");
    }
}

/// W = Σ w det J₀ [½G(tr C − 3) − G ln det F + ½λ(ln det F)²], evaluated literally.
#[test]
fn energy_equals_its_definition() {
    for (section, g0, u) in samples() {
        let density = |p: &SectionPoint| {
            let [j, j0] = [sum(&g0, &u, 1.0), g0].map(|g| gradient_of_directors(&g, [p.y, p.z]));
            let f = j * j0.try_inverse().unwrap();
            let log = f.determinant().ln();
            let w = 0.5 * LAME.shear * (f.norm_squared() - 3.0) - LAME.shear * log
                + 0.5 * LAME.lambda * log * log;
            p.weight * j0.determinant() * w
        };
        let (plain, energy) = (
            points(section.clone()).iter().map(density).sum::<f64>(),
            law(LAME, section.clone()).energy(&g0, &u),
        );
        assert!((energy / plain - 1.0).abs() < 1e-12, "{section:?}: {energy} and {plain}");
    }
}

/// Small strains: the relative difference from St. Venant-Kirchhoff decreases with the strain down to rounding.
///
/// The stiffness of the reference is equal.
#[test]
fn small_strain_limit_is_st_venant_kirchhoff() {
    let mut random = Random(6);
    for section in SECTIONS {
        let g0 = rotated(Rotation3::new(random.vector3() * 3.0), &straight());
        let (soft, plain) = (law(LAME, section.clone()), SectionLaw::continuum(LAME, section.moments()));
        let direction = random_directors(&mut random, 1.0);
        for strain in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
            let u = direction.map(|direction| direction * strain);
            let (a, b) = (soft.energy(&g0, &u), plain.energy(&g0, &u));
            let bound = 20.0 * strain + 1e-14;
            assert!((a / b - 1.0).abs() < bound, "{section:?}, {strain:e}: {:e}", a / b - 1.0);
            let (p, q) = (soft.forces(&g0, &u), plain.forces(&g0, &u));
            assert!(distance(&p, &q) < bound * size(&q), "{section:?}, {strain:e}: forces");
        }
        let rest = [Vector3::zeros(); 7];
        let a = stiffness(|h| soft.add_stiffness(&g0, &rest, 1.0, h));
        let b = stiffness(|h| plain.add_stiffness(&g0, &rest, 1.0, h));
        let largest = b[0][0].amax();
        for i in 0..5 {
            for j in 0..=i {
                assert!((a[i][j] - b[i][j]).amax() < 1e-14 * largest, "{section:?}: block {i}, {j}");
            }
        }
    }
}

/// Stretch s with the free lateral stretch m, G(m² − 1) + λ ln(s m²) = 0. Axial force A (G(s − 1/s) + λ ln(s m²)/s).
///
/// λ = 0 gives m = 1 and A G(s − 1/s).
#[test]
fn uniaxial_force_follows_from_free_contraction() {
    for section in SECTIONS {
        for lame in [LAME, Lame { lambda: 0.0, ..LAME }, Lame { lambda: 200.0, shear: 1.0 }] {
            for s in [0.3, 0.9, 1.0 + 1e-9, 1.5, 4.0] {
                let Lame { lambda, shear } = lame;
                let lateral = |m: f64| shear * (m * m - 1.0) + lambda * (s * m * m).ln();
                let (mut low, mut high) = (0.01, 10.0);
                for _ in 0..100 {
                    let middle = 0.5 * (low + high);
                    if lateral(middle) > 0.0 { high = middle } else { low = middle }
                }
                let m = 0.5 * (low + high);
                let [x, zero, _, y, z, ..] = straight();
                let u = [x * (s - 1.0), zero, zero, y * (m - 1.0), z * (m - 1.0), zero, zero];
                let p = law(lame, section.clone()).forces(&straight(), &u);
                let axial = shear * (s - 1.0 / s) + lambda * (s * m * m).ln() / s;
                let mut expected = [zero; 7];
                expected[0] = x * (axial * section.moments().area);
                let error = distance(&p, &expected) / (section.moments().area * (shear + lambda));
                assert!(error < 1e-14, "{section:?}, {lame:?}, stretch {s}: {error:e}");
            }
        }
    }
}

/// Uniform dilatation F = s I of a curved reference: volume A per length for any curvature, since the axis is the centroid line.
#[test]
fn dilatation_of_a_curved_reference_has_the_energy_of_its_volume() {
    let [x, _, _, y, z, _, zero] = straight();
    let bent: Directors = [x, x * 1.3, x * -0.7, y, z, zero, zero];
    for section in SECTIONS {
        for s in [0.5, 0.99, 1.1, 2.0_f64] {
            let log = 3.0 * s.ln();
            let w = LAME.shear * (1.5 * (s * s - 1.0) - log) + 0.5 * LAME.lambda * log * log;
            let energy = law(LAME, section.clone()).energy(&bent, &bent.map(|g| g * (s - 1.0)));
            let expected = w * section.moments().area;
            assert!((energy / expected - 1.0).abs() < 1e-12, "{section:?}, {s}: {energy} and {expected}");
        }
    }
}

/// Changes of the state by one ulp change the forces by at most twice the bound. The bound is of the order of rounding.
#[test]
fn rounding_error_is_within_its_bound() {
    let mut random = Random(7);
    let mut tightest = f64::INFINITY;
    for (section, g0, u) in samples() {
        let law = law(LAME, section.clone());
        let du = u.map(|u| f64::EPSILON * u.norm());
        let (here, bound) = (law.forces(&g0, &u), law.rounding(&g0, &u, &du));
        for _ in 0..50 {
            let near = u.map(|u| u.map(|u| u * (1.0 + 0.5 * f64::EPSILON * random.number().signum())));
            for (i, p) in law.forces(&g0, &near).iter().enumerate() {
                let moved = (p - here[i]).amax();
                assert!(moved <= 2.0 * bound[i], "{section:?}: {moved:e} above {:e}", bound[i]);
                tightest = tightest.min(bound[i] / moved);
            }
        }
        let largest = bound.iter().copied().fold(0.0, f64::max);
        assert!(largest < 1e-13 * size(&here).max(1.0), "{section:?}: bound {largest:e}");
    }
    assert!(tightest < 100.0, "the bound is at least {tightest} times the change");
}

#[test]
fn inverted_sections_are_inadmissible() {
    let [x, _, _, y, _, _, zero] = straight();
    let flat = [zero, zero, zero, -y, zero, zero, zero];
    let out = [x * -1.5, zero, zero, zero, zero, zero, zero];
    // The concave side is inverted, the axis is not.
    let bent = [zero, x * 20.0, zero, zero, zero, zero, zero];
    for section in SECTIONS {
        let law = law(LAME, section);
        for u in [flat, out, bent] {
            assert!(!law.is_admissible(&straight(), &u));
            assert_eq!(law.energy(&straight(), &u), f64::INFINITY);
            assert!(law.forces(&straight(), &u).iter().all(|p| p.iter().all(|p| p.is_nan())));
            assert!(stiffness(|h| law.add_stiffness(&straight(), &u, 1.0, h))[4][0][(0, 0)].is_nan());
            assert_eq!(law.rounding(&straight(), &u, &[0.0; 7]), [f64::INFINITY; 7]);
        }
    }
}

/// The energy increases without bound as the section becomes flat; that of St. Venant-Kirchhoff stays finite.
#[test]
fn energy_of_a_flat_section_is_unbounded() {
    let law = law(LAME, SECTIONS[0].clone());
    let energy = |gap: f64| {
        let mut u = [Vector3::zeros(); 7];
        u[3] = Vector3::y() * (gap - 1.0);
        law.energy(&straight(), &u)
    };
    let energies = [0.5, 0.1, 1e-2, 1e-4, 1e-8, 1e-12].map(energy);
    assert!(energies.windows(2).all(|pair| pair[1] > pair[0]), "{energies:?}");
    assert!(energies[5].is_finite());
}

/// Bending with a relative curvature of half the thickness: 16 points agree with many points to 10⁻⁵.
#[test]
fn sixteen_points_suffice_for_bending() {
    let section = Section::rectangle(0.3, 0.2);
    let cells = |n: u32| {
        let part = Section::rectangle(0.3 / f64::from(n), 0.2);
        let shift = |k: u32| 0.3 * ((f64::from(k) + 0.5) / f64::from(n) - 0.5);
        let moved =
            move |k| points(part.clone()).into_iter().map(move |p| SectionPoint { y: p.y + shift(k), ..p });
        NeoHookean::new(LAME, (0..n).flat_map(moved).collect())
    };
    let mut u = [Vector3::zeros(); 7];
    u[1] = Vector3::x() * -(0.5 / 0.3);
    let fine = cells(16).energy(&straight(), &u);
    let error = law(LAME, section).energy(&straight(), &u) / fine - 1.0;
    let coarse = cells(8).energy(&straight(), &u) / fine - 1.0;
    assert!(coarse.abs() < 1e-12, "{coarse:e}");
    assert!(error.abs() < 1e-5, "{error:e}");
}

/// One point: derivative of the stress components along the directors, J⁻¹ ∂W/∂J.
///
/// Section in the reference state: stress stiffness of St. Venant-Kirchhoff.
#[test]
fn stress_stiffness_is_the_derivative_of_the_stress() {
    let mut random = Random(8);
    for (section, g0, u) in samples() {
        let (point, direction) = (points(section.clone())[1], random_directors(&mut random, 1.0));
        let law = NeoHookean::new(LAME, vec![point]);
        let stress = |h: f64| {
            let u = sum(&u, &direction, h);
            let p = law.forces(&g0, &u);
            let j = gradient_of_directors(&sum(&g0, &u, 1.0), [point.y, point.z]);
            j.try_inverse().unwrap() * Matrix3::from_columns(&[p[0], p[3], p[4]])
        };
        let slope = derivative(stress, |terms| terms.iter().map(|(stress, weight)| stress * *weight).sum());
        let h = stiffness(|h| law.add_stress_stiffness(&g0, &u, &direction, h));
        for (i, factor, column) in [(0, 1.0, 0), (1, point.y, 0), (2, point.z, 0), (3, 1.0, 1), (4, 1.0, 2)] {
            let expected = Matrix3::from_diagonal_element(factor * slope[(column, 0)]);
            assert!((h[i][0] - expected).amax() < 1e-9 * slope.amax(), "{section:?}: block {i}");
        }
        let expected = Matrix3::from_diagonal_element(slope[(2, 1)]);
        assert!((h[4][3] - expected).amax() < 1e-9 * slope.amax(), "{section:?}: block 4, 3");
    }
    for section in SECTIONS {
        let g0 = rotated(Rotation3::new(random.vector3() * 3.0), &straight());
        let (rest, direction) = ([Vector3::zeros(); 7], random_directors(&mut random, 1.0));
        let plain = SectionLaw::continuum(LAME, section.moments());
        let a = stiffness(|h| law(LAME, section.clone()).add_stress_stiffness(&g0, &rest, &direction, h));
        let b = stiffness(|h| plain.add_stress_stiffness(&g0, &rest, &direction, h));
        for (i, row) in a.iter().enumerate().take(5) {
            for (j, a) in row.iter().enumerate().take(i + 1) {
                assert!((a - b[i][j]).amax() < 1e-14 * b[0][0].amax(), "{section:?}: block {i}, {j}");
            }
        }
    }
}
