//! Stiffness of the stresses that a linear system predicts, in place of those of the iterate.

use ancf::mechanics::elements::CableDamping;
use ancf::solver::equations::{LOCAL, LocalMatrix, Term, Weights};
use nalgebra::{DMatrix, DVector, Vector3};

use super::cases::{TermCase, terms};
use super::kind::TermKind;
use crate::common::assertions::assert_near;
use crate::common::models::cables::{self, Cable};
use crate::common::random::Random;
use crate::common::sample::{Sample, sizes, stress_prediction, stress_stiffness};

/// Strains ε of second order: n(q) − n(q₀) − ∂n/∂q₀ Δ = ½ (∂n/∂q − ∂n/∂q₀) Δ. The stiffness T of stresses is linear in them.
#[test]
fn prediction_of_quadratic_strains_is_half_of_a_difference() {
    let mut random = Random(2017);
    let is_of_kind = |case: &TermCase| case.kind == TermKind::Polynomial && case.term.has_stress_prediction();
    let cases: Vec<_> = terms().into_iter().filter(is_of_kind).collect();
    assert!(cases.len() > 10);
    for TermCase { name, term, .. } in cases {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        let (from, z) = (Sample::random(term, &mut random), random.vector(n + m));
        let at = from.moved(&z, 1.0, Weights::STIFFNESS);
        let [now, before] = [&at, &from].map(|s| stress_stiffness(term, s, &z, 0.0));
        let difference = stress_prediction(term, &at, &from) + (now - before) * 0.5;
        let size = stress_stiffness(term, &from, &z, 0.0).amax();
        assert!(difference.amax() < 1e-12 * size, "{name}: {:e} of {size:e}", difference.amax());
    }
}

/// A small increment changes the stiffness by the second order: with half of the increment by a quarter.
#[test]
fn prediction_is_of_second_order() {
    let mut random = Random(24);
    for TermCase { name, term, .. } in terms().into_iter().filter(|case| case.term.has_stress_prediction()) {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        let mut at = Sample::rest(term);
        at.q = random.vector(n) * 0.1;
        let z = random.vector(n + m);
        let of = |h: f64| stress_prediction(term, &at, &at.moved(&z, -h, Weights::STIFFNESS));
        let [whole, half] = [2e-3, 1e-3].map(of);
        let off = (&whole - &half * 4.0).amax();
        assert!(off <= 0.02 * whole.amax(), "{name}: {off:e} of {:e}", whole.amax());
    }
}

/// Unit vectors along a cable and across it.
fn directions(cable: &Cable) -> [Vector3<f64>; 2] {
    let along = cable.reference[2].normalize();
    [along, along.cross(&Vector3::new(0.3, -0.8, 0.5)).normalize()]
}

/// Coordinates of a linear displacement with the gradient x.
fn of_gradient(cable: &Cable, x: Vector3<f64>) -> DVector<f64> {
    let nodal = [Vector3::zeros(), x * cable.slope, x * cables::LENGTH, x * cable.slope];
    DVector::from_iterator(12, nodal.iter().flatten().copied())
}

/// Straight cable that turns and stretches by a linear displacement θ x across its axis: N = EA (√(1 + θ²) − 1), predicted N = 0.
#[test]
fn a_transverse_increment_has_no_predicted_axial_force() {
    let theta = 0.75_f64;
    for cable in cables::cables(CableDamping::default(), Vector3::zeros()) {
        let term: &dyn Term = &cable.term;
        let ([along, across], moved) = (directions(&cable), |x| of_gradient(&cable, x));
        let from = Sample::rest(term);
        let at = from.moved(&moved(across * theta), 1.0, Weights::STIFFNESS);
        let stretch = 1.0_f64.hypot(theta);
        // Displacement with a gradient normal to the turned axis.
        let z = moved((across - along * theta) / stretch);
        let found = z.dot(&(stress_prediction(term, &at, &from) * &z));
        let expected = -cables::SECTION.axial * (stretch - 1.0) / stretch * cables::LENGTH;
        assert_near(&cable.name, found, expected, 1e-12);
        let stretched = from.moved(&moved(along * theta), 1.0, Weights::STIFFNESS);
        assert!(stress_prediction(term, &stretched, &from).amax() < 1e-12, "{}", cable.name);
    }
}

/// Straight cable that turns by an increment: the predicted axial force, zero, is raised to that of the least strain. A greater predicted
/// one is left.
#[test]
fn the_predicted_tension_is_at_least_that_of_a_strain() {
    let least = 1e-3;
    for cable in cables::cables(CableDamping::default(), Vector3::zeros()) {
        let term: &dyn Term = &cable.term;
        let ([along, across], moved) = (directions(&cable), |x| of_gradient(&cable, x));
        let stiffness = |at: &Sample, from: &Sample| {
            let (size, mut storage) = (at.q.len(), [0.0; LOCAL * LOCAL]);
            let mut k = LocalMatrix::zero(size, &mut storage);
            term.least_tension(&at.local(), &from.local(), least, &mut k);
            let z = moved(across);
            z.dot(&(DMatrix::from_fn(size, size, |i, j| k.get(i.max(j), i.min(j))) * &z))
        };
        let rest = Sample::rest(term);
        // A force N along a line has the stiffness N/l against a unit gradient across it.
        let expected = cables::SECTION.axial * least * cables::LENGTH;
        assert_near(&cable.name, stiffness(&rest, &rest), expected, 1e-12);
        let slack = rest.moved(&moved(along * -0.2), 1.0, Weights::STIFFNESS);
        let of_slack = cables::SECTION.axial * (least + 0.2) / 0.8 * cables::LENGTH;
        assert_near(&cable.name, stiffness(&slack, &rest), of_slack, 1e-12);
        let taut = rest.moved(&moved(along * 0.2), 1.0, Weights::STIFFNESS);
        assert!(stiffness(&taut, &rest).abs() < 1e-12, "{}", cable.name);
    }
}
