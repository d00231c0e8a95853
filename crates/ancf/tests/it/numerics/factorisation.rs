//! Sparse matrices and their factorisation against dense algebra: chains, trees, loops, constraints, any numbering.

use std::ops::Range;

use ancf::solver::equations::{EquationsOfMotion, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::factor::Factor;
use ancf::solver::sparse::SparseMatrix;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

use crate::common::random::Random;

/// Random integer below n.
fn below(random: &mut Random, n: usize) -> usize {
    (random.bits() % n as u64) as usize
}

/// Constant matrix of some unknowns as a term.
#[derive(Clone)]
struct Block {
    coordinates: Vec<usize>,
    multipliers: Range<usize>,
    matrix: DMatrix<f64>,
}

impl Block {
    /// Random positive definite matrix.
    fn definite(random: &mut Random, coordinates: Vec<usize>) -> Self {
        let n = coordinates.len();
        let a = DMatrix::from_fn(n, n, |_, _| random.number());
        let matrix = &a * a.transpose() + DMatrix::identity(n, n) * 0.3;
        Self { coordinates, multipliers: 0..0, matrix }
    }

    /// Random symmetric matrix.
    fn symmetric(random: &mut Random, coordinates: Vec<usize>) -> Self {
        let n = coordinates.len();
        let a = DMatrix::from_fn(n, n, |_, _| random.number());
        Self { coordinates, multipliers: 0..0, matrix: &a + a.transpose() }
    }

    /// Random constraints.
    fn constraint(random: &mut Random, coordinates: Vec<usize>, multipliers: Range<usize>) -> Self {
        let (n, m) = (coordinates.len(), multipliers.len());
        let mut matrix = DMatrix::zeros(n + m, n + m);
        for (i, j) in (n..n + m).flat_map(|i| (0..n).map(move |j| (i, j))) {
            matrix[(i, j)] = random.number();
            matrix[(j, i)] = matrix[(i, j)];
        }
        Self { coordinates, multipliers, matrix }
    }
}

impl Term for Block {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }
    fn multipliers(&self) -> Range<usize> {
        self.multipliers.clone()
    }
    fn residual(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn tangent(&self, _: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        for j in 0..self.matrix.nrows() {
            (j..self.matrix.nrows()).for_each(|i| k.add(i, j, self.matrix[(i, j)]));
        }
    }
}

/// Sum of blocks as a sparse and as a dense matrix.
struct Equations {
    coordinates: usize,
    multipliers: usize,
    blocks: Vec<Block>,
}

impl Equations {
    fn sparse(&self) -> SparseMatrix {
        let terms = self.blocks.iter().map(|block| Box::new(block.clone()) as Box<dyn Term>).collect();
        let system = System::new(self.coordinates, self.multipliers, terms);
        let mut k = system.matrix();
        let rest = State::rest(self.coordinates, self.multipliers);
        system.tangent(&rest, Weights::STIFFNESS, &mut k);
        k
    }

    fn dense(&self) -> DMatrix<f64> {
        let size = self.coordinates + self.multipliers;
        let mut dense = DMatrix::zeros(size, size);
        for block in &self.blocks {
            let multipliers = block.multipliers.clone().map(|m| self.coordinates + m);
            let unknowns: Vec<usize> = block.coordinates.iter().copied().chain(multipliers).collect();
            for (i, &row) in unknowns.iter().enumerate() {
                unknowns.iter().enumerate().for_each(|(j, &c)| dense[(row, c)] += block.matrix[(i, j)]);
            }
        }
        dense
    }

    /// Random mechanism: bodies with elements and joints between them, a tree and additional loops.
    fn mechanism(seed: u64, bodies: usize, loops: usize) -> Self {
        let mut random = Random(seed);
        let mut starts = vec![0];
        (0..bodies).for_each(|body| starts.push(starts[body] + 1 + below(&mut random, 13)));
        let mut free: Vec<usize> = (0..starts[bodies]).collect();
        // Coordinates are numbered in order or at random.
        if seed.is_multiple_of(2) {
            (1..free.len()).for_each(|i| free.swap(i, below(&mut random, i + 1)));
        }
        let of = |body: usize| free[starts[body]..starts[body + 1]].to_vec();
        let mut equations = Self { coordinates: free.len(), multipliers: 0, blocks: Vec::new() };
        for body in 0..bodies {
            let own = of(body);
            equations.blocks.push(Block::definite(&mut random, own.clone()));
            // Load, and constraints of a rigid body.
            equations.blocks.push(Block::definite(&mut random, own[own.len() / 2..].to_vec()));
            let rigid = (own.len() / 4).min(below(&mut random, 4));
            equations.constrain(&mut random, own, rigid);
        }
        for joint in 1..bodies + loops {
            let one = if joint < bodies { joint } else { below(&mut random, bodies) };
            let other = if joint < bodies && below(&mut random, 3) > 0 {
                joint - 1
            } else {
                below(&mut random, one.max(1))
            };
            let mut both = of(other);
            both.extend(of(one));
            both.sort_unstable();
            both.dedup();
            if below(&mut random, 2) == 0 {
                equations.blocks.push(Block::definite(&mut random, both));
            } else {
                let count = (both.len() / 6).min(below(&mut random, 4));
                equations.constrain(&mut random, both, count);
            }
        }
        equations
    }

    /// Adds constraints.
    fn constrain(&mut self, random: &mut Random, coordinates: Vec<usize>, count: usize) {
        if count > 0 {
            let first = self.multipliers;
            self.multipliers += count;
            self.blocks.push(Block::constraint(random, coordinates, first..self.multipliers));
        }
    }
}

/// Solves the equations. Returns the relative error of the solution and the number of negative pivots.
fn solve(equations: &Equations) -> (f64, Option<usize>) {
    let (k, dense) = (equations.sparse(), equations.dense());
    let mut factor = Factor::new(k.pattern()).unwrap();
    factor.factorise(&k).unwrap();
    let b = DVector::from_fn(dense.nrows(), |i, _| (i as f64 + 1.0).sin());
    let mut x = b.clone();
    factor.solve(&k, x.as_mut_slice()).unwrap();
    let exact = dense.lu().solve(&b).unwrap();
    ((x - &exact).amax() / exact.amax(), factor.negative_pivots())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Entries, products, magnitudes, diagonal and constraints of sparse matrices.
    #[test]
    fn sparse_matrices_equal_dense_matrices(seed in 0_u64..1_000_000, bodies in 1_usize..9, loops in 0_usize..4) {
        let equations = Equations::mechanism(seed, bodies, loops);
        let (k, dense) = (equations.sparse(), equations.dense());
        let size = dense.nrows();
        let own = DMatrix::from_fn(size, size, |i, j| k.dense()[i][j]);
        prop_assert!((&own - &dense).amax() < 1e-13);
        let x = DVector::from_fn(size, |i, _| (i as f64).cos());
        prop_assert!((DVector::from(k.times(x.as_slice())) - &dense * &x).amax() < 1e-12);
        let sizes = dense.abs() * x.abs();
        prop_assert!((DVector::from(k.magnitudes(x.as_slice())) - &sizes).amax() < 1e-12);
        (0..size).for_each(|i| assert_eq!(k.diagonal_of(i), own[(i, i)]));
        let n = equations.coordinates;
        let constraints = equations.blocks.iter().map(|block| block.multipliers.len() * block.coordinates.len());
        prop_assert_eq!(k.constraints().count(), constraints.sum::<usize>());
        for (multiplier, coordinate, value) in k.constraints() {
            prop_assert!(multiplier >= n && coordinate < n);
            prop_assert_eq!(value, own[(multiplier, coordinate)]);
        }
    }

    /// LDLᵀ solves definite mechanisms with constraints, with one negative pivot per multiplier.
    #[test]
    fn constrained_mechanisms_are_solved(seed in 0_u64..1_000_000, bodies in 1_usize..9, loops in 0_usize..4) {
        let equations = Equations::mechanism(seed, bodies, loops);
        let (error, negative) = solve(&equations);
        prop_assert!(error < 1e-8, "{error:e}");
        prop_assert_eq!(negative, Some(equations.multipliers));
    }

    /// Sylvester's law of inertia (1852).
    #[test]
    fn negative_pivots_count_negative_eigenvalues(seed in 0_u64..1_000_000, bodies in 1_usize..7) {
        let mut equations = Equations::mechanism(seed, bodies, 1);
        let mut random = Random(seed);
        let free = equations.blocks.iter_mut().filter(|block| block.multipliers.is_empty());
        free.for_each(|block| *block = Block::symmetric(&mut random, block.coordinates.clone()));
        let negative = equations.dense().symmetric_eigenvalues().iter().filter(|value| **value < 0.0).count();
        let (_, pivots) = solve(&equations);
        // Inaccurate solutions are repeated by LU, which does not count negative pivots.
        prop_assert!(pivots.is_none_or(|pivots| pivots == negative), "{pivots:?} of {negative}");
    }
}

/// Chain or ring of nodes with 12 coordinates.
fn chain(nodes: usize, closed: bool) -> Equations {
    let mut random = Random(3);
    let links = if closed { nodes } else { nodes - 1 };
    let ends = |link: usize| [link, (link + 1) % nodes].into_iter().flat_map(|n| 12 * n..12 * n + 12);
    let blocks = (0..links).map(|link| Block::definite(&mut random, ends(link).collect())).collect();
    Equations { coordinates: 12 * nodes, multipliers: 0, blocks }
}

/// Chains have no fill-in; rings have the coupling of each node with one other.
#[test]
fn chains_have_no_fill_in() {
    let entries = |equations: &Equations| equations.sparse().pattern().entries();
    let (own, coupling) = (96, 144);
    for nodes in [5, 6, 40] {
        assert_eq!(entries(&chain(nodes, false)), nodes * own + (nodes - 1) * coupling);
        assert_eq!(entries(&chain(nodes, true)), nodes * own + (2 * nodes - 3) * coupling);
    }
    assert!(solve(&chain(40, true)).0 < 1e-10);
}

/// Constraints on single coordinates of a node and loads on some of them do not split the node.
#[test]
fn clamps_and_loads_do_not_split_nodes() {
    let mut equations = chain(7, false);
    let entries = equations.sparse().pattern().entries();
    let mut random = Random(8);
    equations.blocks.push(Block::definite(&mut random, vec![38, 41]));
    assert_eq!(equations.sparse().pattern().entries(), entries);
    (0..12).for_each(|i| equations.constrain(&mut random, vec![i], 1));
    // The first node has 24 unknowns; the others are unchanged.
    let more = equations.sparse().pattern().entries() - entries;
    assert!(more <= (24 * 28 / 2 + 24 * 12) - (96 + 144), "{more}");
    let (error, negative) = solve(&equations);
    assert!(error < 1e-10 && negative == Some(12), "{error:e}");
}

/// LU replaces LDLᵀ if the diagonal vanishes.
#[test]
fn zero_pivots_are_solved_by_lu() {
    let matrix = DMatrix::from_row_slice(2, 2, &[0.0, 2.0, 2.0, 0.0]);
    let swap = Block { coordinates: vec![0, 1], multipliers: 0..0, matrix };
    let equations = Equations { coordinates: 2, multipliers: 0, blocks: vec![swap] };
    let (error, negative) = solve(&equations);
    assert!(error < 1e-15 && negative.is_none());
}

#[test]
fn non_finite_entries_are_errors() {
    for bad in [f64::NAN, f64::INFINITY] {
        let mut equations = chain(4, false);
        equations.blocks[1].matrix[(3, 1)] = bad;
        let k = equations.sparse();
        let mut factor = Factor::new(k.pattern()).unwrap();
        let mut x = vec![1.0; equations.coordinates];
        assert!(factor.factorise(&k).is_err() || factor.solve(&k, &mut x).is_err());
    }
}

/// A repeated constraint is solved by the least multipliers, for any numbering of the unknowns.
#[test]
fn repeated_constraints_have_least_multipliers() {
    let mut equations = chain(5, false);
    let constraint = Block::constraint(&mut Random(9), vec![13, 17, 50], 0..1);
    equations.blocks.extend((0..3).map(|m| Block { multipliers: m..m + 1, ..constraint.clone() }));
    equations.multipliers = 3;
    let terms = equations.blocks.iter().map(|block| Box::new(block.clone()) as Box<dyn Term>).collect();
    let system = System::new(equations.coordinates, 3, terms).with_shared_multipliers(0..3);
    let mut k = system.matrix();
    system.tangent(&State::rest(equations.coordinates, 3), Weights::STIFFNESS, &mut k);
    let mut factor = Factor::new(k.pattern()).unwrap();
    factor.factorise(&k).unwrap();
    let mut b = vec![1.0; equations.coordinates];
    b.extend([0.5; 3]);
    let mut x = b.clone();
    factor.solve(&k, &mut x).unwrap();
    let rest = DVector::from(b) - equations.dense() * DVector::from_column_slice(&x);
    assert!(rest.amax() < 1e-9 && !factor.is_lu());
    let lambda = &x[equations.coordinates..];
    assert!(lambda.iter().all(|value| (value - lambda[0]).abs() < 1e-8 * lambda[0].abs()), "{lambda:?}");
}

/// Long chains and trees are solved to rounding, with bitwise equal results for any number of threads.
#[test]
fn threads_do_not_change_the_solution() {
    for (nodes, arm) in [(3000, usize::MAX), (3200, 400)] {
        let mut random = Random(5);
        let coordinates = |node: usize| 6 * node..6 * node + 6;
        // Arms branch from the middle of earlier arms.
        let before = |node: usize| {
            if node.is_multiple_of(arm) { (node / arm - 1) / 2 * arm + arm / 2 } else { node - 1 }
        };
        let links = (1..nodes).map(|node| coordinates(before(node)).chain(coordinates(node)).collect());
        let blocks = links.map(|ends| Block::definite(&mut random, ends)).collect();
        let mut equations = Equations { coordinates: 6 * nodes, multipliers: 0, blocks };
        equations.constrain(&mut random, coordinates(7).collect(), 3);
        equations.constrain(&mut random, coordinates(nodes - 1).collect(), 2);
        let k = equations.sparse();
        let b: Vec<f64> = (0..k.pattern().size()).map(|i| (i as f64).sin()).collect();
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let (mut factor, mut x) = (Factor::new(k.pattern()).unwrap(), b.clone());
            pool.install(|| {
                factor.factorise(&k).unwrap();
                factor.solve(&k, &mut x).unwrap();
            });
            assert_eq!(factor.negative_pivots(), Some(5));
            x
        };
        let x = run(1);
        let sizes = k.magnitudes(&x);
        for ((b, y), size) in b.iter().zip(k.times(&x)).zip(sizes) {
            assert!((b - y).abs() <= 1e-11 * (b.abs() + size), "{b} {y} {size}");
        }
        [2, 4].into_iter().for_each(|threads| assert!(run(threads) == x, "{threads} threads"));
    }
}

/// A coordinate with a stiffness ε of rounding errors that constraints determine, such as the orientation of a rigid body in
/// statics: [2, −1, 0, 1; −1, 3, 0, 0; 0, 0, ε, 1; 1, 0, 1, 0] x = b. Without ε, x₃ = −x₁ and λ = b₃.
#[test]
fn stiffness_of_rounding_errors_does_not_affect_solutions() {
    let (one, other) = (0.3, -0.7);
    for stiffness in [0.0, 1e-47, -1e-30, 1e-17, -3e-17] {
        let matrix = DMatrix::from_row_slice(
            4,
            4,
            &[2.0, -1.0, 0.0, 1.0, -1.0, 3.0, 0.0, 0.0, 0.0, 0.0, stiffness, 1.0, 1.0, 0.0, 1.0, 0.0],
        );
        let block = Block { coordinates: vec![0, 1, 2], multipliers: 0..1, matrix };
        let equations = Equations { coordinates: 3, multipliers: 1, blocks: vec![block] };
        let k = equations.sparse();
        let mut factor = Factor::new(k.pattern()).unwrap();
        factor.factorise(&k).unwrap();
        let mut x = [one, other, 0.1, 0.0];
        factor.solve(&k, &mut x).unwrap();
        // 2 x₁ − x₂ = one − 0.1, −x₁ + 3 x₂ = other.
        let exact = [(3.0 * (one - 0.1) + other) / 5.0, (one - 0.1 + 2.0 * other) / 5.0];
        let exact = [exact[0], exact[1], -exact[0], 0.1];
        x.iter().zip(exact).for_each(|(x, exact)| assert!((x - exact).abs() < 1e-15, "{stiffness}: {x:?}"));
    }
}
