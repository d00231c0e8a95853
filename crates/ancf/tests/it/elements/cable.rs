//! What the cable element is, beyond the laws that every term obeys.

use crate::common::models::cables::{Cable, DAMPING, LENGTH, SECTION, cables};
use crate::common::sample::{Random, Sample, energy, residual, tangent};
use ancf::mechanics::{CableDamping, CableRule};
use ancf::system::{Term, Weights};
use nalgebra::{DVector, Matrix4, Rotation3, SymmetricEigen, Vector3};

const VISCOUS: CableDamping = CableDamping { mass: 0.0, ..DAMPING };

fn plain() -> Vec<Cable> {
    cables(CableDamping::default(), Vector3::zeros())
}

/// A state of moderate deformation.
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

/// Velocities of a rotation ω of a state about the origin.
fn rotation(cable: &Cable, at: &Sample, omega: Vector3<f64>) -> DVector<f64> {
    let spun = nodes(cable, at).map(|e| omega.cross(&e));
    DVector::from_iterator(12, spun.iter().flatten().copied())
}

/// Points and weights of a rule on [0, 1], axial and bending; tables of five to fifteen digits, not the library's.
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

/// r′ and r″ at ξ, from a Bezier curve of the same cubic.
fn curve(cable: &Cable, e: &[Vector3<f64>; 4], xi: f64) -> [Vector3<f64>; 2] {
    let third = LENGTH / (3.0 * cable.slope);
    let control = [e[0], e[0] + e[1] * third, e[2] - e[3] * third, e[2]];
    let steps: [Vector3<f64>; 3] = std::array::from_fn(|i| control[i + 1] - control[i]);
    let turns: [Vector3<f64>; 2] = std::array::from_fn(|i| steps[i + 1] - steps[i]);
    let rest = 1.0 - xi;
    let first = steps[0] * (rest * rest) + steps[1] * (2.0 * rest * xi) + steps[2] * (xi * xi);
    [first * (3.0 / LENGTH), (turns[0] * rest + turns[1] * xi) * (6.0 / (LENGTH * LENGTH))]
}

/// ½∫(EA (|r′| − 1)² + EI |r′ × r″|²/|r′|⁴) dx by the rule's points, and the strains themselves.
#[test]
fn strain_energy_is_that_of_the_line() {
    let mut random = Random(8);
    for cable in plain() {
        let at = bent(&cable, &mut random);
        let e = nodes(&cable, &at);
        let strains = |xi: f64| {
            let [a, b] = curve(&cable, &e, xi);
            (a.norm() - 1.0, a.cross(&b) / a.norm_squared())
        };
        let [axial, bending] = points(cable.rule);
        let stretch: f64 = axial.iter().map(|&(xi, w)| w * strains(xi).0.powi(2)).sum();
        let bend: f64 = bending.iter().map(|&(xi, w)| w * strains(xi).1.norm_squared()).sum();
        let brute = 0.5 * LENGTH * (SECTION.axial * stretch + SECTION.bending * bend);
        let exact = energy(&cable.term, &at).strain;
        assert!((exact / brute - 1.0).abs() < 1e-13, "{}: {exact} and {brute}", cable.name);
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
fn rigid_motion_costs_nothing() {
    let mut random = Random(24);
    for cable in plain() {
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

/// The force of a strain of 10⁻¹² is EA 10⁻¹².
#[test]
fn tiny_strains_are_not_lost() {
    for cable in plain() {
        let (direction, strain) = ((cable.reference[2] / LENGTH), 1e-12);
        let mut at = Sample::rest(&cable.term);
        for (k, part) in [0.0, cable.slope, LENGTH, cable.slope].into_iter().enumerate() {
            at.q.rows_mut(3 * k, 3).copy_from(&(direction * (part * strain)));
        }
        let force = -residual(&cable.term, &at).fixed_rows::<3>(0).dot(&direction);
        assert!((force / (SECTION.axial * strain) - 1.0).abs() < 1e-11, "{}: {force:e}", cable.name);
    }
}

/// Three translations, two rotations; a spin about the line itself is no motion of it. All mass is positive.
#[test]
fn stiffness_has_five_free_motions_and_mass_none() {
    for Cable { name, term, .. } in plain() {
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

/// ρA l/420 times the matrix of a bar of cubics, as in any textbook of structural dynamics.
#[test]
fn mass_is_that_of_a_bar() {
    for cable in plain() {
        let (l, c) = (LENGTH / cable.slope, SECTION.line_density * LENGTH / 420.0);
        #[rustfmt::skip]
        let book = Matrix4::new(
            156.0,     22.0 * l,       54.0,     -13.0 * l,
            22.0 * l,  4.0 * l * l,    13.0 * l, -3.0 * l * l,
            54.0,      13.0 * l,       156.0,    -22.0 * l,
            -13.0 * l, -3.0 * l * l,  -22.0 * l,  4.0 * l * l,
        ) * c;
        let profile = cable.term.profile();
        for i in 0..4 {
            for j in 0..4 {
                assert!((profile.mass()[i][j] - book[(i, j)]).abs() < 1e-15, "{i} {j}");
            }
        }
        let weight: f64 = [0, 2].iter().map(|&i| profile.first_moments()[i]).sum();
        assert!((weight - SECTION.line_density * LENGTH).abs() < 1e-15);
    }
}

/// At rest C = τK + αM: Rayleigh's damping, so that small vibrations are damped by (τω + α/ω)/2.
#[test]
fn damping_of_small_motions_is_rayleighs() {
    for Cable { name, term, .. } in cables(DAMPING, Vector3::zeros()) {
        let rest = Sample::rest(&term);
        let of = |w| tangent(&term, &rest, w);
        let damping = of(Weights { q: 0.0, v: 1.0, a: 0.0 });
        let rayleigh = of(Weights::STIFFNESS) * DAMPING.retardation + of(Weights::MASS) * DAMPING.mass;
        assert!((&damping - rayleigh).amax() < 1e-14 * damping.amax(), "{name}");
    }
}

/// Power that the damping takes.
fn dissipation(cable: &Cable, at: &Sample) -> f64 {
    let still = Sample { v: DVector::zeros(12), ..at.clone() };
    (residual(&cable.term, at) - residual(&cable.term, &still)).dot(&at.v)
}

#[test]
fn damping_never_gives_energy() {
    let mut random = Random(13);
    for cable in cables(VISCOUS, Vector3::zeros()) {
        for _ in 0..50 {
            let at = bent(&cable, &mut random);
            assert!(dissipation(&cable, &at) > 0.0, "{}", cable.name);
        }
    }
}

/// No loss in translations; in a rotation ω what the spin ω·t of the bent sections loses, τ EI ∫K² (ω·t)² dx, and that is
/// zero for any rotation of a straight cable, and for one in the plane of a plane cable.
#[test]
fn damping_in_rigid_motions() {
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
            let lost = VISCOUS.retardation * SECTION.bending * bending.iter().map(spin).sum::<f64>();
            let power = dissipation(&cable, &at);
            assert!((power - lost).abs() < 1e-12, "{}: {power} and {lost}", cable.name);

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

/// Elastic and damping forces have no resultant.
#[test]
fn inner_forces_balance() {
    let mut random = Random(15);
    for cable in cables(VISCOUS, Vector3::zeros()) {
        let at = bent(&cable, &mut random);
        let r = residual(&cable.term, &at);
        let sum = r.fixed_rows::<3>(0) + r.fixed_rows::<3>(6);
        assert!(sum.norm() < 1e-13 * r.amax(), "{}", cable.name);
    }
}

/// A line may turn by any angle but not shrink to a point.
#[test]
fn crushed_lines_are_not_admissible() {
    for cable in plain() {
        let mut at = Sample::rest(&cable.term);
        assert!(cable.term.is_admissible(&at.local()), "{}", cable.name);
        for (k, e) in cable.reference.iter().enumerate() {
            at.q.fixed_rows_mut::<3>(3 * k).copy_from(&(e * -2.0));
        }
        assert!(cable.term.is_admissible(&at.local()), "{}: turned round", cable.name);
        for (k, e) in cable.reference.iter().enumerate() {
            at.q.fixed_rows_mut::<3>(3 * k).copy_from(&(e * -0.995));
        }
        assert!(!cable.term.is_admissible(&at.local()), "{}: crushed", cable.name);
    }
}
