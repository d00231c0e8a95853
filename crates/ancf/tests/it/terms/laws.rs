//! Laws of all terms: consistent tangent, energy, power balance, mass, rounding bound, constraint levels.
//!
//! New elements, joints and loads are added to [`super::cases`]. Elements are stubby, so that all parts of an energy are of
//! one magnitude. Most residuals are polynomials of degree three at most: five-point differences with large steps are exact
//! to rounding. Other smooth residuals are differentiated by extrapolation.

use ancf::solver::equations::{Energy, Level, Local, Power, Term, Weights};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::cases::{TermCase, terms};
use super::kind::TermKind;
use crate::common::random::Random;
use crate::common::sample::{Sample, energy, extrapolated_derivative, residual, rounding, sizes, tangent};

/// Asserts that two vectors agree relative to the larger one, at least to one.
pub(super) fn assert_close(what: &str, a: &DVector<f64>, b: &DVector<f64>, tolerance: f64) {
    let (error, size) = ((a - b).amax(), a.amax().max(b.amax()).max(1.0));
    assert!(error <= tolerance * size, "{what}: {error:e} of {size:e}");
}

/// Vector with one component.
pub(super) fn scalar(x: f64) -> DVector<f64> {
    DVector::from_element(1, x)
}

/// Asserts that the tangent is the derivative of the residual along z, its constraint rows divided by w_q.
fn assert_tangent(TermCase { name, term, kind }: &TermCase, s: &Sample, z: &DVector<f64>, w: Weights) {
    let term = term.as_ref();
    let (n, m) = sizes(term);
    let mut product = tangent(term, s, w) * z;
    product.rows_mut(n, m).scale_mut(w.q);
    let mut slope = kind.derivative(|h| residual(term, &s.moved(z, h, w)));
    if *kind == TermKind::Retarded {
        // z·B(q)ᵀ D B(v) z is half the rate of z·B(q)ᵀ D B(q) z along v.
        let damping = |h: f64| {
            let moved = Sample { q: &s.q + &s.v * h, ..s.clone() };
            scalar(z.dot(&(tangent(term, &moved, Weights { q: 0.0, v: 1.0, a: 0.0 }) * z)))
        };
        let omitted = kind.derivative(damping) * (0.5 * w.q);
        (product, slope) = (scalar(product.dot(z)) + omitted, scalar(slope.dot(z)));
    }
    if matches!(kind, TermKind::Damped | TermKind::NonConservative) {
        // z·Kz depends on the symmetric part only; random z cover all of it.
        (product, slope) = (scalar(product.dot(z)), scalar(slope.dot(z)));
    }
    assert_close(&format!("{name}: tangent"), &product, &slope, kind.tolerance());
}

/// Asserts that conservative forces are derivatives of the energy.
///
/// Along a change of q and v, dU = f dq and dT = M v dv + ½ v·dM v. The residual with v in place of a contains M v.
fn assert_energy(TermCase { name, term, kind }: &TermCase, s: &Sample, z: &DVector<f64>) {
    let term = term.as_ref();
    let (n, m) = sizes(term);
    let both = Weights { q: 1.0, v: 1.0, a: 0.0 };
    let power = kind.derivative(|h| scalar(energy(term, &s.moved(z, h, both)).total()));
    let at_rest = Sample { v: DVector::zeros(n), a: s.v.clone(), lambda: DVector::zeros(m), ..s.clone() };
    let work = scalar(residual(term, &at_rest).rows(0, n).dot(&z.rows(0, n)));
    let kinetic = |s: &Sample| 0.5 * s.v.dot(&(mass(term, s) * &s.v));
    let work = work + kind.derivative(|h| scalar(kinetic(&s.moved(z, h, Weights::STIFFNESS))));
    if *kind != TermKind::NonConservative {
        assert_close(&format!("{name}: energy"), &power, &work, kind.tolerance());
    }
    // Prescribed strains are stresses in the reference state.
    if !name.starts_with("contact") && !name.contains("prestrain") {
        let rest = Sample::rest(term);
        assert_eq!(energy(term, &rest), Energy::default(), "{name}: energy of the reference state");
    }
}

/// Asserts that the mass matrix is positive semi-definite.
fn assert_mass(TermCase { name, term, .. }: &TermCase, s: &Sample) {
    let inertia = SymmetricEigen::new(mass(term.as_ref(), s)).eigenvalues;
    assert!(inertia.min() >= -1e-14 * inertia.max(), "{name}: negative mass");
}

/// Asserts that changes of the state by one ulp change the residual by at most twice the rounding bound.
///
/// The bound itself is of the order of rounding.
fn assert_rounding(TermCase { name, term, .. }: &TermCase, s: &Sample, random: &mut Random) {
    let term = term.as_ref();
    let (here, bound) = (residual(term, s), rounding(term, s));
    for _ in 0..20 {
        let mut ulp = |x: &DVector<f64>| x.map(|x| x * (1.0 + 0.5 * f64::EPSILON * random.number().signum()));
        let near = Sample { q: ulp(&s.q), v: ulp(&s.v), a: ulp(&s.a), lambda: ulp(&s.lambda) };
        let moved = (residual(term, &near) - &here).abs();
        assert!(moved <= &bound * 2.0, "{name}: rounding {} above its bound {}", moved.amax(), bound.amax());
    }
    assert!(bound.amax() < 1e-12 * here.amax().max(1.0), "{name}: rounding bound {:e}", bound.amax());
}

/// Asserts that Φ_q has no other entries than those that the term states.
fn assert_entries(TermCase { name, term, .. }: &TermCase, s: &Sample) {
    let (n, m) = sizes(term.as_ref());
    let (k, entries) = (tangent(term.as_ref(), s, Weights::MASS), term.constraint_entries());
    for entry in (0..m).flat_map(|row| (0..n).map(move |i| [row, i])) {
        let [row, i] = entry;
        assert!(k[(n + row, i)] == 0.0 || entries.contains(&entry), "{name}: entry {entry:?}");
    }
}

fn mass(term: &dyn Term, s: &Sample) -> DMatrix<f64> {
    let n = s.q.len();
    tangent(term, s, Weights::MASS).view((0, 0), (n, n)).into_owned()
}

/// Tangent = ∂residual, residual = ∂energy, mass ≥ 0 and rounding bound at one random state.
fn assert_laws(case: &TermCase, random: &mut Random) {
    let (term, kind) = (case.term.as_ref(), case.kind);
    let (n, m) = sizes(term);
    let (mut s, mut z) = (Sample::random(term, random), random.vector(n + m));
    let is_contact = case.name.starts_with("contact");
    // The closest point of a beam is not smooth near its centre of curvature.
    s.q *= if is_contact { 0.5 * kind.amplitude() } else { kind.amplitude() };
    if is_contact {
        // Shorter steps of the differences: at full length the nearest singularity causes errors of 10⁻⁸.
        z *= 0.25;
    }
    let mut w = Weights { q: 1.3 + random.number(), v: random.number(), a: 1.3 + random.number() };
    if kind == TermKind::IncompleteStiffness {
        w.q = 0.0;
    }
    assert_tangent(case, &s, &z, w);
    assert_energy(case, &s, &z);
    assert_mass(case, &s);
    assert_entries(case, &s);
    assert_rounding(case, &s, random);
}

#[test]
fn every_term_obeys_the_laws() {
    for case in terms() {
        // Seed from the name: the states of a term do not depend on the terms before it.
        let mut random =
            Random(case.name.bytes().fold(2017, |seed, byte| 31 * seed % (1 << 40) + u64::from(byte)));
        for _ in 0..10 {
            assert_laws(&case, &mut random);
        }
    }
}

/// Power balance in any motion: dE/dt = v·r + supplied power − dissipation.
#[test]
fn every_term_satisfies_the_power_balance() {
    let mut random = Random(1666);
    for TermCase { name, term, kind } in terms().into_iter().filter(|case| case.term.multipliers().is_empty())
    {
        let term = term.as_ref();
        for _ in 0..10 {
            let mut s = Sample::random(term, &mut random);
            s.q *= kind.amplitude();
            // Prescribed neutral positions are no polynomials of time. The load factor is 1 while time passes.
            let kind = if name.starts_with("preloaded") { TermKind::Smooth } else { kind };
            let stored = kind.derivative(|h| {
                let later = Sample { q: &s.q + &s.v * h, v: &s.v + &s.a * h, ..s.clone() };
                let at = later.local();
                scalar(term.energy(&Local { t: at.t + h, load: 1.0, ..at }).total())
            });
            let now = Local { load: 1.0, ..s.local() };
            let mut r = s.q.clone() * 0.0;
            term.residual(&now, r.as_mut_slice());
            let Power { work, dissipation } = term.power(&now);
            let supplied = scalar(s.v.dot(&r) + work - dissipation);
            assert_close(&format!("{name}: power balance"), &stored, &supplied, kind.tolerance());
            // An element of a mesh subtracts the contacts with its edges that its neighbours add. `contact::face_sums` tests the sum.
            let is_part = name.contains("of a face");
            assert!(dissipation >= 0.0 || is_part, "{name}: dissipation {dissipation:e}");
        }
    }
}

/// Constraints that declare no damping have forces that do not depend on velocities.
#[test]
fn undamped_constraints_do_not_depend_on_velocities() {
    let mut random = Random(1687);
    let is_tested = |case: &TermCase| !case.term.multipliers().is_empty() && !case.term.is_damped();
    let cases: Vec<_> = terms().into_iter().filter(is_tested).collect();
    assert!(cases.len() > 5, "{} cases", cases.len());
    for TermCase { name, term, kind } in cases {
        let term = term.as_ref();
        let mut moving = Sample::random(term, &mut random);
        moving.q *= kind.amplitude();
        let still = Sample { v: &moving.v * 0.0, ..moving.clone() };
        assert_eq!(residual(term, &moving), residual(term, &still), "{name}");
    }
}

/// Constraints on velocity and acceleration level are time derivatives along q + v h, t + h.
#[test]
fn constraint_levels_are_time_derivatives() {
    let mut random = Random(1988);
    for TermCase { name, term, kind } in terms() {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        let mut s = Sample::random(term, &mut random);
        s.q *= kind.amplitude();
        let along = |level: Level, h: f64| {
            let q = &s.q + &s.v * h;
            let at = Local { q: q.as_slice(), t: 0.3 + h, load: 1.0, ..s.local() };
            let mut phi = DVector::zeros(m);
            term.constraints(&at, level, phi.as_mut_slice());
            phi
        };
        for (level, next) in [(Level::Position, Level::Velocity), (Level::Velocity, Level::Acceleration)] {
            let slope = extrapolated_derivative(|h| along(level, h));
            assert_close(&format!("{name}, {next:?} of {n}"), &along(next, 0.0), &slope, 1e-10);
        }
    }
}

#[test]
fn coordinates_of_a_term_are_distinct() {
    for TermCase { name, term, .. } in terms() {
        let mut coordinates = term.coordinates().to_vec();
        coordinates.sort_unstable();
        coordinates.dedup();
        assert_eq!(coordinates.len(), term.coordinates().len(), "{name}");
    }
}
