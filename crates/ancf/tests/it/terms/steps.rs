//! Laws of all terms in steps of the energy-momentum scheme.

use ancf::solver::equations::{Local, LocalStep, Term};
use nalgebra::DVector;

use super::cases::{TermCase, terms};
use super::kind::TermKind;
use crate::common::random::Random;
use crate::common::sample::{Sample, energy, residual, sizes};

/// Residual of a step between two states with the multipliers of the second one.
fn step_residual(term: &dyn Term, from: &Sample, to: &Sample) -> DVector<f64> {
    let middle = Sample { q: (&from.q + &to.q) * 0.5, v: (&from.v + &to.v) * 0.5, ..to.clone() };
    let mut r = DVector::zeros(to.q.len() + to.lambda.len());
    let from = Local { lambda: to.lambda.as_slice(), ..from.local() };
    let step = LocalStep { from, middle: middle.local(), to: to.local(), damping: 0.0 };
    term.average_residual(&step, r.as_mut_slice());
    r
}

/// Random pair of states at rest, at a distance of the given size.
fn ends(case: &TermCase, size: f64, random: &mut Random) -> [Sample; 2] {
    let term = case.term.as_ref();
    let (n, m) = sizes(term);
    let mut from = Sample { v: DVector::zeros(n), a: DVector::zeros(n), ..Sample::random(term, random) };
    from.q *=
        if case.name.starts_with("contact") { 0.5 * case.kind.amplitude() } else { case.kind.amplitude() };
    let to = Sample { q: &from.q + random.vector(n) * size, lambda: random.vector(m), ..from.clone() };
    [from, to]
}

/// The forces of a step do exactly the work of potentials and constraints, and the constraints are those of its end.
#[test]
fn forces_of_steps_do_the_work_of_their_potential() {
    let mut random = Random(1992);
    for case in terms().into_iter().filter(|case| case.kind != TermKind::NonConservative) {
        let (name, term) = (&case.name, case.term.as_ref());
        let n = sizes(term).0;
        for size in [0.3, 0.02] {
            for _ in 0..5 {
                let [from, to] = ends(&case, size * case.kind.amplitude(), &mut random);
                let r = step_residual(term, &from, &to);
                let rows = [&from, &to].map(|s| residual(term, s).rows(n, s.lambda.len()).into_owned());
                let work = r.rows(0, n).dot(&(&to.q - &from.q));
                let potential = [&from, &to].map(|s| energy(term, s)).map(|e| e.strain + e.potential);
                let expected = potential[1] - potential[0] + to.lambda.dot(&(&rows[1] - &rows[0]));
                let scale =
                    potential.iter().map(|x| x.abs()).sum::<f64>() + r.rows(0, n).norm() * size + 1e-3;
                let error = (work - expected).abs() / scale;
                assert!(
                    error < 1e-12,
                    "{name}, {size}: work {work:e}, expected {expected:e}, scale {scale:e}"
                );
                let error = (r.rows(n, rows[1].len()) - &rows[1]).amax();
                assert!(error <= 1e-15 * rows[1].amax(), "{name}: constraints of the end");
            }
        }
    }
}

/// In a step of size zero the forces are those of the state.
#[test]
fn forces_of_short_steps_are_those_of_the_state() {
    let mut random = Random(1993);
    for case in terms() {
        let term = case.term.as_ref();
        let [mut from, _] = ends(&case, 0.0, &mut random);
        let (n, m) = sizes(term);
        (from.v, from.a, from.lambda) = (random.vector(n) * 0.1, random.vector(n), random.vector(m));
        let here = residual(term, &from);
        let to = Sample { q: &from.q + random.vector(n) * 1e-7, ..from.clone() };
        for to in [from.clone(), to] {
            let error = (step_residual(term, &from, &to) - &here).amax() / here.amax().max(1.0);
            assert!(error < 1e-5, "{}: {error:e}", case.name);
        }
    }
}
