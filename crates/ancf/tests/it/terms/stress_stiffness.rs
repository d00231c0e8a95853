//! Geometric stiffness: the stiffness of initial stresses.

use ancf::model::MaterialLaw;
use ancf::solver::equations::Weights;
use nalgebra::{DVector, Vector3};

use super::cases::{TermCase, terms};
use super::kind::TermKind;
use super::laws::{assert_close, scalar};
use super::magnet::Magnet;
use crate::common::models::beams::beam_cases;
use crate::common::random::Random;
use crate::common::sample::{Sample, sizes, stress_stiffness, tangent};

/// Third derivative of the energy and of λ·Φ. With T the stiffness of initial stresses and quadratic strains,
/// D³(x, y, z) = x·T(z)y + y·T(x)z + z·T(y)x. Terms with other strains: in the reference state.
#[test]
fn stress_stiffness_is_a_third_of_the_third_derivative() {
    let mut random = Random(1961);
    for TermCase { name, term, kind } in terms() {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        // Neo-Hookean stress is not linear in the strain: sections/neo_hookean.rs tests it. Contacts start without stress. The pressure of
        // a gas is not linear in its volume.
        let is_nonlinear =
            name.contains("NeoHookean") || name.starts_with("contact") || name.starts_with("gas");
        // Preloaded terms are stressed in the reference state and by the load factor.
        let is_preloaded = name.starts_with("preloaded");
        // A force at an arm of a section has load stiffness, as the magnet below.
        let is_load = name == "frames: force";
        if is_nonlinear || is_preloaded || is_load || kind == TermKind::NonConservative {
            continue;
        }
        for _ in 0..5 {
            let mut s = Sample::rest(term);
            if kind == TermKind::Polynomial {
                s = Sample { v: s.v, a: s.a, ..Sample::random(term, &mut random) };
            }
            let [x, y, z] = std::array::from_fn(|_| random.vector(n + m));
            let k = |h: f64| tangent(term, &s.moved(&z, h, Weights::STIFFNESS), Weights::STIFFNESS);
            let third = kind.derivative(|h| scalar(x.dot(&(k(h) * &y))));
            let of = |z, x: &DVector<f64>, y| x.dot(&(stress_stiffness(term, &s, z, 0.0) * y));
            let sum = scalar(of(&z, &x, &y) + of(&x, &y, &z) + of(&y, &z, &x));
            assert_close(&format!("{name}: stress stiffness"), &sum, &third, 1e-11);
            let of_load = stress_stiffness(term, &s, &DVector::zeros(n + m), 1.0).amax();
            assert_eq!(of_load, 0.0, "{name}: dead loads have no stiffness");
        }
    }
}

/// Stiffness of a load per load factor, independent of the current load.
#[test]
fn stress_stiffness_contains_the_load_stiffness() {
    let s = Sample::random(&Magnet, &mut Random(1));
    assert_eq!(stress_stiffness(&Magnet, &s, &scalar(0.2), 2.0)[(0, 0)], -6.0);
}

/// Infinitesimal translation and rotation of a deformed element.
#[test]
fn rigid_motion_adds_no_stress() {
    let mut random = Random(25);
    for case in beam_cases().into_iter().filter(|case| case.law == MaterialLaw::StVenantKirchhoff) {
        let element = case.element(Vector3::zeros());
        let (name, term) = (&element.name, element.term.as_ref());
        let (s, linear, angular) = (Sample::random(term, &mut random), random.vector3(), random.vector3());
        let z = element.rigid_velocity(&s.q, angular, linear);
        let size = stress_stiffness(term, &s, &random.vector(z.len()), 0.0).amax();
        let rigid = stress_stiffness(term, &s, &z, 0.0).amax();
        assert!(rigid < 1e-12 * size, "{name}: {rigid:e} of {size:e}");
    }
}
