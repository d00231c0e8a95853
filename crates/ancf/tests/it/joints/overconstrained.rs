//! Linkage with a redundant crank: nonlinear constraints that are redundant in all positions.

use std::ops::Range;

use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper, consistent_accelerations};
use ancf::solver::equations::{
    Energy, EquationsOfMotion, Level, Local, LocalMatrix, State, System, Term, Weights, constraint_rows,
};
use ancf::solver::factor::{SparseRow, dependences};
use ancf::solver::newton::{Newton, SolveFailure, StopRule};
use nalgebra::Vector2;

const GRAVITY: f64 = 9.81;
const CRANK: [f64; 2] = [0.6, 0.8];
const COUPLER: f64 = 3.0;

/// Point mass in the plane.
struct Particle {
    mass: f64,
    coordinates: [usize; 2],
}

impl Term for Particle {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += self.mass * at.a[0];
        r[1] += self.mass * (at.a[1] + GRAVITY);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * self.mass * at.a[0].abs();
        floor[1] += f64::EPSILON * self.mass * (at.a[1].abs() + GRAVITY);
    }

    fn tangent(&self, _: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        (0..2).for_each(|i| k.add(i, i, w.a * self.mass));
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let kinetic = 0.5 * self.mass * at.v.iter().map(|v| v * v).sum::<f64>();
        Energy { kinetic, strain: 0.0, potential: self.mass * GRAVITY * at.q[1] }
    }
}

/// Rigid bar to the ground or to another particle, ½ |d + u|² = ½ l².
struct Bar {
    d: Vector2<f64>,
    length: f64,
    coordinates: Vec<usize>,
    multiplier: usize,
}

impl Bar {
    fn new(d: [f64; 2], coordinates: Vec<usize>, multiplier: usize) -> Self {
        let d = Vector2::from(d);
        Self { length: d.norm(), d, coordinates, multiplier }
    }

    /// Sign of a coordinate in the relative displacement.
    fn sign(&self, i: usize) -> f64 {
        if self.coordinates.len() == 4 && i < 2 { -1.0 } else { 1.0 }
    }

    /// Relative displacement of the ends.
    fn displacement(&self, q: &[f64]) -> Vector2<f64> {
        let mut u = Vector2::zeros();
        q.iter().enumerate().for_each(|(i, q)| u[i % 2] += self.sign(i) * q);
        u
    }
}

impl Term for Bar {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (u, n) = (self.displacement(at.q), at.q.len());
        (0..n).for_each(|i| r[i] += at.lambda[0] * self.sign(i) * (self.d + u)[i % 2]);
        let initial = 0.5 * (self.d.norm_squared() - self.length * self.length);
        r[n] += initial + self.d.dot(&u) + 0.5 * u.norm_squared();
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (n, size) = (at.q.len(), at.q.iter().map(|q| q.abs()).sum::<f64>());
        (0..n).for_each(|i| floor[i] += f64::EPSILON * at.lambda[0].abs() * (self.d.norm() + size));
        floor[n] += f64::EPSILON * (self.d.norm() + size).powi(2);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (u, n) = (self.displacement(at.q), at.q.len());
        for i in 0..n {
            k.add(n, i, self.sign(i) * (self.d + u)[i % 2]);
            for j in (0..=i).filter(|j| (i - j) % 2 == 0) {
                k.add(i, j, w.q * at.lambda[0] * self.sign(i) * self.sign(j));
            }
        }
    }
}

/// The second particle is the midpoint of the others.
struct Middle;

impl Term for Middle {
    fn coordinates(&self) -> &[usize] {
        &[0, 1, 2, 3, 4, 5]
    }

    fn multipliers(&self) -> Range<usize> {
        3..5
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        for k in 0..2 {
            for (first, weight) in [(0, 0.5), (2, -1.0), (4, 0.5)] {
                r[first + k] += weight * at.lambda[k];
                r[6 + k] += weight * at.q[first + k];
            }
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        for k in 0..2 {
            for first in [0, 2, 4] {
                floor[first + k] += f64::EPSILON * at.lambda[k].abs();
                floor[6 + k] += f64::EPSILON * at.q[first + k].abs();
            }
        }
    }

    fn tangent(&self, _: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        for i in 0..2 {
            for (first, weight) in [(0, 0.5), (2, -1.0), (4, 0.5)] {
                k.add(6 + i, first + i, weight);
            }
        }
    }
}

/// Coupler of three particles on two or three parallel cranks. The third crank is longer by the factor `stretch`.
fn linkage(cranks: usize, stretch: f64) -> System {
    let particle = |k: usize| Particle { mass: 1.0 + k as f64, coordinates: [2 * k, 2 * k + 1] };
    let mut terms: Vec<Box<dyn Term>> = (0..3).map(|k| Box::new(particle(k)) as Box<dyn Term>).collect();
    terms.push(Box::new(Bar::new(CRANK, vec![0, 1], 0)));
    terms.push(Box::new(Bar::new(CRANK, vec![4, 5], 1)));
    terms.push(Box::new(Bar::new([COUPLER, 0.0], vec![0, 1, 4, 5], 2)));
    terms.push(Box::new(Middle));
    if cranks == 3 {
        let mut last = Bar::new(CRANK, vec![2, 3], 5);
        last.length *= stretch;
        terms.push(Box::new(last));
    }
    System::new(6, cranks + 3, terms)
}

/// Rows of Φ_q by multiplier.
fn rows(system: &System, s: &State) -> Vec<SparseRow> {
    let mut rows = vec![SparseRow::new(); system.multipliers()];
    for term in system.terms() {
        term.multipliers().zip(constraint_rows(term.as_ref(), s)).for_each(|(m, row)| rows[m] = row);
    }
    rows
}

fn dynamics(system: &System) -> TimeStepper<'_, System> {
    let newton = Newton::new(system.matrix(), StopRule::Energy(1e-12), 30).unwrap().with_new_tangents();
    let start = State::rest(6, system.multipliers());
    let mut dynamics = TimeStepper::new(system, SchemeCoefficients::generalized_alpha(0.8), newton, 0, start);
    dynamics.restart(0.0).unwrap();
    dynamics
}

/// Same motion with few additional iterations; the redundancy is found and the sum of the forces is unchanged.
#[test]
fn redundant_crank_does_not_change_the_motion() {
    let (two, three) = (linkage(2, 1.0), linkage(3, 1.0).with_shared_multipliers(0..6));
    let (mut a, mut b) = (dynamics(&two), dynamics(&three));
    let mut iterations = [0, 0];
    for step in 1..=1000 {
        let t = 2e-3 * f64::from(step);
        let reports = [a.advance(t), b.advance(t)]
            .map(|report| report.unwrap_or_else(|error| panic!("{step}: {error}")));
        iterations[0] += reports[0].iterations;
        iterations[1] += reports[1].iterations;
        let difference = a.state().q.iter().zip(&b.state().q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(difference < 1e-9, "{step}: {difference:e}");
        let mut phi = vec![0.0; 6];
        three.constraints(b.state(), Level::Position, &mut phi);
        assert!(phi.iter().all(|phi| phi.abs() < 1e-12), "{step}: {phi:?}");
        let found = dependences(rows(&three, b.state()), 1e-8);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].row(), 5);
        // Least multipliers have no component Σ cᵢ λᵢ in the weights of the solver, hence they stay small.
        let largest = b.state().lambda.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
        assert!(largest < 1e3, "{step}: {:?}", b.state().lambda);
    }
    assert!(iterations[1] <= iterations[0] + iterations[0] / 4, "{iterations:?}");
    assert!(a.state().q[0].abs() > 0.5, "the linkage moves");
    // Crank forces act along the parallel cranks; their sum Σ λ r supports the coupler.
    let of = |s: &State| s.lambda[0] + s.lambda[1] + s.lambda.get(5).copied().unwrap_or(0.0);
    let (whole, shared) = (of(a.state()), of(b.state()));
    assert!((whole - shared).abs() < 1e-6 * whole.abs(), "{whole} {shared}");
}

/// Multipliers at the start are a weighted least-squares solution.
#[test]
fn redundant_multipliers_are_a_least_squares_solution() {
    let system = linkage(3, 1.0).with_shared_multipliers(0..6);
    let mut s = State::rest(6, 6);
    consistent_accelerations(&system, &mut system.matrix(), &mut s).unwrap();
    let found = dependences(rows(&system, &s), 1e-8);
    let mut r = vec![0.0; 12];
    system.residual(&s, &mut r);
    assert!(r[..6].iter().all(|r| r.abs() < 1e-10), "{r:?}");
    // Weights of the solver: largest squared row entry per mass.
    let mass = |c: usize| 1.0 + (c / 2) as f64;
    let rows = rows(&system, &s);
    let weight = |i: usize| rows[i].iter().map(|&(c, x)| x * x / mass(c)).fold(0.0, f64::max);
    let (mut sum, mut size) = (0.0, 0.0_f64);
    for (&i, c) in &found[0].coefficients {
        sum += c * weight(i) * s.lambda[i];
        size += (c * weight(i) * s.lambda[i]).abs();
    }
    assert!(sum.abs() < 1e-6 * size, "{sum} of {size}");
}

/// A third crank of another length contradicts the others.
#[test]
fn contradicting_crank_fails_to_converge() {
    let wrong = linkage(3, 1.01).with_shared_multipliers(0..6);
    let newton = Newton::new(wrong.matrix(), StopRule::Energy(1e-12), 30).unwrap();
    let mut dynamics = TimeStepper::new(&wrong, SchemeCoefficients::ADAMS, newton, 3, State::rest(6, 6));
    dynamics.restart(0.0).unwrap();
    let error = dynamics.advance(1e-3).unwrap_err();
    assert!(
        matches!(
            error.failure,
            SolveFailure::NotConverged | SolveFailure::Stagnated | SolveFailure::Diverged
        ),
        "{error}"
    );
}
