//! Modes of random systems against dense linear algebra.

use std::ops::Range;

use ancf::solver::eigen::{EigenError, EigenModes, modes};
use ancf::solver::equations::{Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::newton::Interrupt;
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use crate::common::random::Random;

const TAU: f64 = std::f64::consts::TAU;

fn random_matrix(random: &mut Random, rows: usize, columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |_, _| random.number())
}

/// Linear system M a + K q + Φᵀ λ = 0, Φ q = 0 as one term.
#[derive(Clone)]
struct Block {
    coordinates: Vec<usize>,
    multipliers: Range<usize>,
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    constraints: DMatrix<f64>,
}

impl Term for Block {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multipliers.clone()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let vector = |x: &[f64]| DVector::from_column_slice(x);
        let forces = &self.stiffness * vector(at.q)
            + &self.mass * vector(at.a)
            + self.constraints.transpose() * vector(at.lambda);
        let gaps = &self.constraints * vector(at.q);
        r.iter_mut().zip(forces.iter().chain(gaps.iter())).for_each(|(r, x)| *r += x);
    }

    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}

    fn tangent(&self, _: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let n = self.coordinates.len();
        for j in 0..n {
            for i in j..n {
                k.add(i, j, w.q * self.stiffness[(i, j)] + w.a * self.mass[(i, j)]);
            }
            for i in 0..self.multipliers.len() {
                k.add(n + i, j, self.constraints[(i, j)]);
            }
        }
    }
}

/// Random system with given numbers of negative and zero eigenvalues of the stiffness.
///
/// Units of the coordinates differ by factors up to 10^`units`.
fn block(random: &mut Random, n: usize, m: usize, negative: usize, zero: usize, units: f64) -> Block {
    let unit = DVector::from_fn(n, |_, _| 10.0_f64.powf(units * random.number()));
    let scaled = |a: DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| a[(i, j)] * unit[i] * unit[j]);
    let root = random_matrix(random, n, n);
    let turn = random_matrix(random, n, n).qr().q();
    let values = DVector::from_fn(n, |i, _| match i {
        _ if i < negative => -1.0 - i as f64,
        _ if i < negative + zero => 0.0,
        _ => 10.0_f64.powf(3.0 * random.number()),
    });
    let stiffness = &turn * DMatrix::from_diagonal(&values) * turn.transpose();
    let constraints = random_matrix(random, m, n);
    Block {
        coordinates: (0..n).collect(),
        multipliers: 0..m,
        stiffness: scaled((&stiffness + stiffness.transpose()) * 0.5),
        mass: scaled(&root * root.transpose() + DMatrix::identity(n, n)),
        constraints: DMatrix::from_fn(m, n, |i, j| constraints[(i, j)] * unit[j]),
    }
}

/// All ω² in ascending order, in the null space of Φ by dense algebra.
fn dense(block: &Block) -> Vec<f64> {
    let (m, n) = block.constraints.shape();
    let mut turned = DMatrix::identity(n, n);
    // Coordinates are scaled first for an accurate null space.
    let unit = DMatrix::from_diagonal(&block.mass.diagonal().map(|mass| 1.0 / mass.sqrt()));
    (&block.constraints * &unit).transpose().qr().q_tr_mul(&mut turned);
    let free = &unit * turned.rows(m, n - m).transpose();
    let root = Cholesky::new(free.transpose() * &block.mass * &free).unwrap().l();
    let half = root.solve_lower_triangular(&(free.transpose() * &block.stiffness * &free)).unwrap();
    let reduced = root.solve_lower_triangular(&half.transpose()).unwrap();
    let mut values: Vec<f64> = SymmetricEigen::new(reduced).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

fn solve(blocks: Vec<Block>, count: usize) -> Result<EigenModes, EigenError> {
    let (mut n, mut m) = (0, 0);
    let terms = blocks.into_iter().map(|mut block| {
        block.coordinates.iter_mut().for_each(|c| *c += n);
        block.multipliers = m..m + block.multipliers.len();
        (n, m) = (n + block.coordinates.len(), m + block.multipliers.len());
        Box::new(block) as Box<dyn Term>
    });
    let terms: Vec<_> = terms.collect();
    let system = System::new(n, m, terms);
    modes(&system, system.matrix(), &State::rest(n, m), count, &Interrupt::default())
}

/// Asserts the first `count` eigenvalues to the rounding error of the largest one.
fn assert_same(modes: &EigenModes, all: &[f64], count: usize) {
    let reference = &all[..count];
    assert_eq!(modes.modes.len(), count);
    let largest = all.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
    for (mode, reference) in modes.modes.iter().zip(reference) {
        let error = (mode.omega_squared - reference).abs();
        assert!(error < 1e-11 * largest, "{} instead of {reference}", mode.omega_squared);
    }
}

#[test]
fn eigenvalues_of_random_systems_equal_dense_algebra() {
    let mut random = Random(10);
    for (n, m, units) in [(1, 0, 0.0), (12, 0, 0.0), (20, 5, 0.0), (40, 11, 3.0), (30, 29, 0.0)] {
        for negative in [0, 1, 3] {
            if negative + m < n {
                let block = block(&mut random, n, m, negative, 0, units);
                let reference = dense(&block);
                for count in [1, 3, n - m, n + 5] {
                    let count_found = count.min(n - m);
                    assert_same(&solve(vec![block.clone()], count).unwrap(), &reference, count_found);
                }
            }
        }
    }
}

/// Ten equal systems have ten equal eigenvalues of each kind.
#[test]
fn multiple_eigenvalues_are_complete() {
    let block = block(&mut Random(3), 20, 5, 0, 0, 0.0);
    let reference: Vec<f64> = dense(&block).iter().flat_map(|&squared| [squared; 10]).collect();
    for count in [10, 17, 20] {
        assert_same(&solve(vec![block.clone(); 10], count).unwrap(), &reference, count);
    }
}

#[test]
fn free_motions_have_zero_eigenvalues() {
    for units in [0.0, 2.0] {
        let block = block(&mut Random(4), 30, 0, 0, 7, units);
        let modes = solve(vec![block], 9).unwrap();
        assert_eq!(modes.rigid, 7);
        assert!(
            modes.modes[..7].iter().all(|mode| mode.omega_squared == 0.0 && mode.frequency() == Some(0.0))
        );
        assert!(modes.modes[7].omega_squared > 1e-4);
    }
}

/// Shapes satisfy xᵀ M x = 1, xᵀ K x = ω² and the constraints. Unstable modes have no frequency.
#[test]
fn shapes_are_orthonormal_and_satisfy_constraints() {
    let block = block(&mut Random(5), 30, 6, 2, 0, 0.0);
    let modes = solve(vec![block.clone()], 6).unwrap().modes;
    let x = DMatrix::from_fn(30, 6, |i, j| modes[j].shape[i]);
    let squared = DMatrix::from_fn(6, 6, |i, j| if i == j { modes[i].omega_squared } else { 0.0 });
    assert!((x.transpose() * &block.mass * &x - DMatrix::identity(6, 6)).amax() < 1e-7);
    assert!((x.transpose() * &block.stiffness * &x - squared).amax() < 1e-7);
    assert!((&block.constraints * &x).amax() < 1e-12);
    assert!(modes.iter().all(|mode| mode.residual < 1e-6));
    for mode in &modes {
        assert_eq!(mode.frequency(), (mode.omega_squared >= 0.0).then(|| mode.omega_squared.sqrt() / TAU));
    }
    assert!(modes[0].omega_squared < 0.0);
}

#[test]
fn systems_without_modes_have_no_result() {
    assert!(solve(vec![block(&mut Random(6), 5, 5, 0, 0, 0.0)], 3).unwrap().modes.is_empty());
    assert!(solve(vec![block(&mut Random(6), 5, 1, 0, 0, 0.0)], 0).unwrap().modes.is_empty());
}

#[test]
fn redundant_constraints_are_singular() {
    let mut block = block(&mut Random(7), 10, 3, 0, 0, 0.0);
    let first = block.constraints.row(0).into_owned();
    block.constraints.set_row(2, &first);
    assert_eq!(solve(vec![block], 2), Err(EigenError::Singular));
}
