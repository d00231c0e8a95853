//! Properties of the cable element beyond the laws of all terms.

use ancf::mechanics::elements::{CableDamping, CableRule};
use ancf::solver::equations::{Inadmissibility, Term, Weights};
use nalgebra::{DVector, Matrix4, Rotation3, SymmetricEigen, Vector3};

use crate::common::models::cables::{Cable, DAMPING, LENGTH, SECTION, cables};
use crate::common::random::Random;
use crate::common::sample::{Sample, energy, residual, tangent};

const VISCOUS: CableDamping = CableDamping { mass: 0.0, ..DAMPING };

/// Undamped cables without gravity.
fn undamped() -> Vec<Cable> {
    cables(CableDamping::default(), Vector3::zeros())
}

/// Random state of moderate deformation.
fn bent(cable: &Cable, random: &mut Random) -> Sample {
    let mut at = Sample::random(&cable.term, random);
    at.q *= 0.1;
    at.a.fill(0.0);
    at
}

/// Absolute nodal vectors e = e₀ + q.
fn nodes(cable: &Cable, at: &Sample) -> [Vector3<f64>; 4] {
    std::array::from_fn(|k| cable.reference[k] + at.q.fixed_rows::<3>(3 * k))
}

/// Velocities of a rotation about the origin with the angular velocity ω.
fn rotation(cable: &Cable, at: &Sample, omega: Vector3<f64>) -> DVector<f64> {
    let spun = nodes(cable, at).map(|e| omega.cross(&e));
    DVector::from_iterator(12, spun.iter().flatten().copied())
}

/// Points and weights of a rule on [0, 1] for axial and bending strains, from tables of up to fifteen digits.
fn points(rule: CableRule) -> [Vec<(f64, f64)>; 2] {
    let symmetric = |half: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let both = |&(x, w): &(f64, f64)| if x == 0.0 { vec![(x, w)] } else { vec![(-x, w), (x, w)] };
        half.iter().flat_map(both).map(|(x, w)| (0.5 + 0.5 * x, 0.5 * w)).collect()
    };
    let two = symmetric(&[(0.577350269189626, 1.0)]);
    match rule {
        CableRule::Full => [
            symmetric(&[
                (0.0, 0.568888888888889),
                (0.538469310105683, 0.478628670499366),
                (0.906179845938664, 0.236926885056189),
            ]),
            symmetric(&[(0.0, 0.888888888888889), (0.774596669241483, 0.555555555555556)]),
        ],
        CableRule::Reduced => [
            symmetric(&[(0.339981043584856, 0.652145154862546), (0.861136311594053, 0.347854845137454)]),
            two,
        ],
        CableRule::Lobatto => [symmetric(&[(0.0, 4.0 / 3.0), (1.0, 1.0 / 3.0)]), two],
    }
}

/// r′ and r″ at ξ, from the Bézier form of the cubic.
fn curve(cable: &Cable, e: &[Vector3<f64>; 4], xi: f64) -> [Vector3<f64>; 2] {
    let third = LENGTH / (3.0 * cable.slope);
    let control = [e[0], e[0] + e[1] * third, e[2] - e[3] * third, e[2]];
    let steps: [Vector3<f64>; 3] = std::array::from_fn(|i| control[i + 1] - control[i]);
    let turns: [Vector3<f64>; 2] = std::array::from_fn(|i| steps[i + 1] - steps[i]);
    let rest = 1.0 - xi;
    let first = steps[0] * (rest * rest) + steps[1] * (2.0 * rest * xi) + steps[2] * (xi * xi);
    [first * (3.0 / LENGTH), (turns[0] * rest + turns[1] * xi) * (6.0 / (LENGTH * LENGTH))]
}

/// Strain energy ½∫(EA (|r′| − 1)² + EI |r′ × r″|²/|r′|⁴) dx by the points of the rule; strains and resultants.
#[test]
fn strain_energy_equals_the_integral_along_the_axis() {
    let mut random = Random(8);
    for cable in undamped() {
        let at = bent(&cable, &mut random);
        let e = nodes(&cable, &at);
        let strains = |xi: f64| {
            let [a, b] = curve(&cable, &e, xi);
            (a.norm() - 1.0, a.cross(&b) / a.norm_squared())
        };
        let [axial, bending] = points(cable.rule);
        let stretch: f64 = axial.iter().map(|&(xi, w)| w * strains(xi).0.powi(2)).sum();
        let bend: f64 = bending.iter().map(|&(xi, w)| w * strains(xi).1.norm_squared()).sum();
        let reference = 0.5 * LENGTH * (SECTION.axial * stretch + SECTION.bending * bend);
        let found = energy(&cable.term, &at).strain;
        assert!((found / reference - 1.0).abs() < 1e-13, "{}: {found} and {reference}", cable.name);
        let (strain, curvature) = cable.term.strains(at.q.as_slice(), 0.3);
        let (force, moment) = cable.term.resultants(at.q.as_slice(), &[0.0; 12], 0.3);
        assert!((strain - strains(0.3).0).abs() < 1e-14, "{}", cable.name);
        assert!((curvature - strains(0.3).1).norm() < 1e-13, "{}", cable.name);
        assert!((force - SECTION.axial * strain).abs() < 1e-14, "{}", cable.name);
        assert!((moment - curvature * SECTION.bending).norm() < 1e-14, "{}", cable.name);
    }
}

/// Translation and rotation of any size: no energy, no elastic force.
#[test]
fn rigid_motion_has_no_energy_and_no_force() {
    let mut random = Random(24);
    for cable in undamped() {
        for _ in 0..10 {
            let (turn, shift) = (Rotation3::new(random.vector3() * 3.0), random.vector3() * 10.0);
            let mut at = Sample::rest(&cable.term);
            for (k, e) in cable.reference.iter().enumerate() {
                let moved = turn * e - e + if k % 2 == 0 { shift } else { Vector3::zeros() };
                at.q.rows_mut(3 * k, 3).copy_from(&moved);
            }
            let force = residual(&cable.term, &at).amax() / cable.slope;
            assert!(force < 1e-12 * SECTION.axial, "{}: force {force:e}", cable.name);
            let strain = energy(&cable.term, &at).strain;
            assert!(strain < 1e-24 * SECTION.axial * LENGTH, "{}: energy {strain:e}", cable.name);
        }
    }
}

/// Axial force EA ε of the strain ε = 10⁻¹², without cancellation.
#[test]
fn small_strains_do_not_cancel() {
    for cable in undamped() {
        let (direction, strain) = ((cable.reference[2] / LENGTH), 1e-12);
        let mut at = Sample::rest(&cable.term);
        for (k, part) in [0.0, cable.slope, LENGTH, cable.slope].into_iter().enumerate() {
            at.q.rows_mut(3 * k, 3).copy_from(&(direction * (part * strain)));
        }
        let force = -residual(&cable.term, &at).fixed_rows::<3>(0).dot(&direction);
        assert!((force / (SECTION.axial * strain) - 1.0).abs() < 1e-11, "{}: {force:e}", cable.name);
    }
}

/// Zero eigenvalues of the stiffness belong to three translations and two rotations; a spin about the axis moves nothing.
///
/// The mass is positive definite.
#[test]
fn stiffness_has_five_rigid_modes_and_mass_is_definite() {
    for Cable { name, term, .. } in undamped() {
        let rest = Sample::rest(&term);
        let eigenvalues = |w| {
            let mut values = SymmetricEigen::new(tangent(&term, &rest, w)).eigenvalues.data.as_vec().clone();
            values.sort_unstable_by(f64::total_cmp);
            values
        };
        let (stiffness, mass) = (eigenvalues(Weights::STIFFNESS), eigenvalues(Weights::MASS));
        assert!(stiffness[0] > -1e-13 * stiffness[11], "{name}: {stiffness:?}");
        assert!(stiffness[4] < 1e-13 * stiffness[11], "{name}: {stiffness:?}");
        assert!(stiffness[5] > 1e-3 * stiffness[11], "{name}: {stiffness:?}");
        assert!(mass[0] > 1e-5 * mass[11], "{name}: {mass:?}");
    }
}

/// Mass matrix of the Hermite cubic bar, ρA l/420 times the matrix of textbooks of structural dynamics.
#[test]
fn mass_is_that_of_a_hermite_bar() {
    for cable in undamped() {
        let (l, c) = (LENGTH / cable.slope, SECTION.line_density * LENGTH / 420.0);
        #[rustfmt::skip]
        let textbook = Matrix4::new(
            156.0,     22.0 * l,       54.0,     -13.0 * l,
            22.0 * l,  4.0 * l * l,    13.0 * l, -3.0 * l * l,
            54.0,      13.0 * l,       156.0,    -22.0 * l,
            -13.0 * l, -3.0 * l * l,  -22.0 * l,  4.0 * l * l,
        ) * c;
        let profile = cable.term.profile();
        for i in 0..4 {
            for j in 0..4 {
                assert!((profile.mass()[i][j] - textbook[(i, j)]).abs() < 1e-15, "{i} {j}");
            }
        }
        let weight: f64 = [0, 2].iter().map(|&i| profile.first_moments()[i]).sum();
        assert!((weight - SECTION.line_density * LENGTH).abs() < 1e-15);
    }
}

/// At rest C = τK + αM: Rayleigh damping with the damping ratio (τω + α/ω)/2.
#[test]
fn damping_at_rest_is_rayleigh_damping() {
    for Cable { name, term, .. } in cables(DAMPING, Vector3::zeros()) {
        let rest = Sample::rest(&term);
        let of = |w| tangent(&term, &rest, w);
        let damping = of(Weights { q: 0.0, v: 1.0, a: 0.0 });
        let rayleigh = of(Weights::STIFFNESS) * DAMPING.bending + of(Weights::MASS) * DAMPING.mass;
        assert!((&damping - rayleigh).amax() < 1e-14 * damping.amax(), "{name}");
    }
}

/// Power dissipated by the damping.
fn dissipation(cable: &Cable, at: &Sample) -> f64 {
    let still = Sample { v: DVector::zeros(12), ..at.clone() };
    (residual(&cable.term, at) - residual(&cable.term, &still)).dot(&at.v)
}

#[test]
fn damping_power_is_positive() {
    let mut random = Random(13);
    for cable in cables(VISCOUS, Vector3::zeros()) {
        for _ in 0..50 {
            let at = bent(&cable, &mut random);
            assert!(dissipation(&cable, &at) > 0.0, "{}", cable.name);
        }
    }
}

/// No dissipation in translations. In a rotation ω the spin ω·t of the bent sections dissipates τ EI ∫K² (ω·t)² dx.
///
/// It vanishes for rotations of a straight cable and for rotations of a plane cable in its plane.
#[test]
fn only_spin_of_bent_sections_dissipates_in_rigid_motions() {
    let mut random = Random(14);
    for cable in cables(VISCOUS, Vector3::zeros()) {
        let [_, bending] = points(cable.rule);
        for _ in 0..10 {
            let mut at = bent(&cable, &mut random);
            let shift = random.vector3();
            at.v = DVector::from_fn(12, |i, _| if i / 3 % 2 == 0 { shift[i % 3] } else { 0.0 });
            assert!(dissipation(&cable, &at).abs() < 1e-15, "{}: translation", cable.name);

            let omega = random.vector3();
            at.v = rotation(&cable, &at, omega);
            let e = nodes(&cable, &at);
            let spin = |&(xi, w): &(f64, f64)| {
                let [a, b] = curve(&cable, &e, xi);
                w * LENGTH
                    * (a.cross(&b) / a.norm_squared()).norm_squared()
                    * omega.dot(&a.normalize()).powi(2)
            };
            let expected = VISCOUS.bending * SECTION.bending * bending.iter().map(spin).sum::<f64>();
            let power = dissipation(&cable, &at);
            assert!((power - expected).abs() < 1e-12, "{}: {power} and {expected}", cable.name);

            let normal = cable.reference[2].cross(&omega).normalize();
            for k in 0..4 {
                let moved = at.q.fixed_rows::<3>(3 * k).into_owned();
                at.q.fixed_rows_mut::<3>(3 * k).copy_from(&(moved - normal * normal.dot(&moved)));
            }
            at.v = rotation(&cable, &at, normal);
            assert!(dissipation(&cable, &at).abs() < 1e-13, "{}: in the plane", cable.name);

            let mut straight = Sample::rest(&cable.term);
            straight.v = rotation(&cable, &straight, omega);
            assert!(dissipation(&cable, &straight).abs() < 1e-15, "{}: straight", cable.name);
        }
    }
}

/// Sum of the elastic and damping forces is zero.
#[test]
fn internal_forces_are_in_equilibrium() {
    let mut random = Random(15);
    for cable in cables(VISCOUS, Vector3::zeros()) {
        let at = bent(&cable, &mut random);
        let r = residual(&cable.term, &at);
        let sum = r.fixed_rows::<3>(0) + r.fixed_rows::<3>(6);
        assert!(sum.norm() < 1e-13 * r.amax(), "{}", cable.name);
    }
}

/// Rotations by any angle are admissible; a cable that shrinks to a point is not.
#[test]
fn collapsed_cables_are_inadmissible() {
    for cable in undamped() {
        let mut at = Sample::rest(&cable.term);
        assert_eq!(cable.term.inadmissibility(&at.local()), None, "{}", cable.name);
        for (k, e) in cable.reference.iter().enumerate() {
            at.q.fixed_rows_mut::<3>(3 * k).copy_from(&(e * -2.0));
        }
        assert_eq!(cable.term.inadmissibility(&at.local()), None, "{}: reversed", cable.name);
        for (k, e) in cable.reference.iter().enumerate() {
            at.q.fixed_rows_mut::<3>(3 * k).copy_from(&(e * -0.995));
        }
        assert_eq!(
            cable.term.inadmissibility(&at.local()),
            Some(Inadmissibility::InvertedElement),
            "{}: crushed",
            cable.name
        );
    }
}
