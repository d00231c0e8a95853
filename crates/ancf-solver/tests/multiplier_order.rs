//! Solutions of constrained structures against dense LU, where multipliers are eliminated before some of their coordinates.

use std::ops::Range;

use ancf_solver::equations::{EquationsOfMotion, Local, LocalMatrix, State, System, Term, Weights};
use ancf_solver::factor::Factor;
use nalgebra::{DMatrix, DVector};

/// Masses, springs and linear constraints of some coordinates.
#[derive(Clone, Default)]
struct Part {
    coordinates: Vec<usize>,
    multipliers: Range<usize>,
    mass: Vec<f64>,
    /// Stiffness of each spring and the coefficients of its elongation.
    springs: Vec<(f64, Vec<f64>)>,
    rows: Vec<Vec<f64>>,
}

impl Term for Part {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }
    fn multipliers(&self) -> Range<usize> {
        self.multipliers.clone()
    }
    fn residual(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn tangent(&self, _: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.mass.iter().enumerate().for_each(|(i, m)| k.add(i, i, w.a * m));
        for (stiffness, along) in &self.springs {
            for (i, a) in along.iter().enumerate() {
                along[..=i].iter().enumerate().for_each(|(j, b)| k.add(i, j, w.q * stiffness * a * b));
            }
        }
        for (row, m) in self.rows.iter().zip(self.coordinates.len()..) {
            row.iter().enumerate().for_each(|(i, entry)| k.add(m, i, *entry));
        }
    }
}

/// Structure of parts with three coordinates per point.
#[derive(Clone, Default)]
struct Structure {
    coordinates: usize,
    multipliers: usize,
    parts: Vec<Part>,
}

impl Structure {
    /// Adds a chain of points with mass and springs. Returns the first coordinate of each point.
    fn chain(&mut self, points: usize, mass: f64, stiffness: f64) -> Vec<usize> {
        let first: Vec<usize> = (0..points).map(|point| self.coordinates + 3 * point).collect();
        self.coordinates += 3 * points;
        for pair in first.windows(2) {
            let coordinates = (pair[0]..pair[0] + 3).chain(pair[1]..pair[1] + 3).collect();
            // Axial stiffness of a straight rod, and a hundredth of it in transverse directions.
            let along =
                |k: usize| (0..6).map(|i| if i % 3 == k { [-1.0, 1.0][i / 3] } else { 0.0 }).collect();
            let springs = (0..3).map(|k| (stiffness * [1.0, 0.01, 0.01][k], along(k))).collect();
            let mass = vec![0.5 * mass; 6];
            self.parts.push(Part { coordinates, mass, springs, ..Part::default() });
        }
        first
    }

    fn constrain(&mut self, coordinates: Vec<usize>, rows: Vec<Vec<f64>>) {
        let multipliers = self.multipliers..self.multipliers + rows.len();
        self.multipliers = multipliers.end;
        self.parts.push(Part { coordinates, multipliers, rows, ..Part::default() });
    }

    /// Fixes a point, or connects it with another one.
    fn pin(&mut self, one: usize, other: Option<usize>) {
        let points: Vec<usize> = [Some(one), other].into_iter().flatten().collect();
        let coordinates: Vec<usize> = points.iter().flat_map(|&point| point..point + 3).collect();
        let entry = |i: usize, k: usize| if i % 3 == k { [1.0, -1.0][i / 3] } else { 0.0 };
        let rows = (0..3).map(|k| (0..coordinates.len()).map(|i| entry(i, k)).collect()).collect();
        self.constrain(coordinates, rows);
    }

    /// Chains from fixed points to points of a rigid body with a centre and three directors.
    fn deck(chains: usize, body: f64) -> Self {
        let mut all = Self::default();
        let deck = all.coordinates;
        all.coordinates += 12;
        let own: Vec<usize> = (deck..deck + 12).collect();
        all.parts.push(Part { coordinates: own.clone(), mass: vec![body; 12], ..Part::default() });
        // Unit directors d_i · d_j = const, linearised.
        let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        let entry = |c: usize, [i, j]: [usize; 2]| f64::from(u8::from(c == 3 * (i + 1) + j));
        let rigid = |(i, j)| (0..12).map(|c| entry(c, [i, j]) + entry(c, [j, i])).collect();
        all.constrain(own.clone(), pairs.into_iter().map(rigid).collect());
        for chain in 0..chains {
            let points = all.chain(6, 1.0, 1e4);
            all.pin(points[0], None);
            let angle = chain as f64;
            let place = [1.0, angle.cos(), angle.sin(), 0.3 * (2.0 * angle).cos()];
            let last = points[5]..points[5] + 3;
            let row = |k: usize| {
                let point = (0..3).map(|c| f64::from(u8::from(c == k)));
                point.chain((0..12).map(|c| if c % 3 == k { -place[c / 3] } else { 0.0 })).collect()
            };
            all.constrain(last.chain(own.iter().copied()).collect(), (0..3).map(row).collect());
        }
        all
    }

    fn system(&self) -> System {
        let terms = self.parts.iter().map(|part| Box::new(part.clone()) as Box<dyn Term>);
        System::new(self.coordinates, self.multipliers, terms.collect())
    }
}

/// Rod of constant length between two points, with their difference in the reference configuration.
struct Rod {
    coordinates: Vec<usize>,
    multiplier: usize,
    difference: [f64; 3],
}

impl Term for Rod {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }
    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }
    fn residual(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn tangent(&self, at: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        for i in 0..3 {
            let entry = at.q[3 + i] - at.q[i] + self.difference[i];
            k.add(6, i, -entry);
            k.add(6, 3 + i, entry);
        }
    }
}

/// Solution of a system and of dense LU for the same right-hand side, and the factor.
struct Solutions {
    sparse: Vec<f64>,
    dense: Vec<f64>,
    factor: Factor,
}

fn solutions(system: &System, w: Weights) -> Solutions {
    solutions_in(system, &State::rest(system.coordinates(), system.multipliers()), w)
}

fn solutions_in(system: &System, s: &State, w: Weights) -> Solutions {
    let (n, m) = (system.coordinates(), system.multipliers());
    let mut k = system.matrix();
    system.tangent(s, w, &mut k);
    let mut factor = Factor::new(k.pattern()).expect("the memory suffices");
    factor.factorise(&k).expect("the matrix is not singular");
    let b: Vec<f64> = (0..n + m).map(|i| ((i + 1) as f64 * 0.754_877_67).fract() - 0.5).collect();
    let mut sparse = b.clone();
    factor.solve(&k, &mut sparse).expect("the backward error is small");
    let rows = k.dense();
    let dense = DMatrix::from_fn(n + m, n + m, |i, j| rows[i][j]);
    let dense = dense.full_piv_lu().solve(&DVector::from(b)).expect("the matrix is not singular");
    let dense = dense.as_slice().to_vec();
    Solutions { sparse, dense, factor }
}

/// Largest difference of the coordinates, and of the multipliers, relative to the largest value.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let largest = b.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    a.iter().zip(b).fold(0.0_f64, |worst, (x, y)| worst.max((x - y).abs())) / largest
}

fn assert_alike(found: &Solutions, coordinates: usize, tolerance: f64) {
    let [(a, l), (b, m)] = [&found.sparse, &found.dense].map(|x| x.split_at(coordinates));
    assert!(difference(a, b) < tolerance, "coordinates: {:e}", difference(a, b));
    assert!(difference(l, m) < tolerance, "multipliers: {:e}", difference(l, m));
}

/// Weights of a time step h with matrices divided by h²: the stiffness relative to the mass.
fn dynamics(h: f64) -> Weights {
    Weights { q: 1.0, a: 1.0 / (h * h), ..Weights::STIFFNESS }
}

/// Heavy and light rigid bodies on chains, in short and long steps. Each multiplier has a negative pivot.
#[test]
fn rigid_decks() {
    for body in [1e-3, 1.0, 1e6] {
        let structure = Structure::deck(8, body);
        let system = structure.system();
        for h in [1e-5, 1e-2, 10.0] {
            let found = solutions(&system, dynamics(h));
            assert!(!found.factor.is_lu(), "body {body}, step {h}");
            assert_eq!(found.factor.negative_pivots(), Some(structure.multipliers));
            assert_alike(&found, structure.coordinates, 1e-9);
        }
    }
}

/// Chains in statics that are supported through other chains only, in both orders of numbering.
#[test]
fn unsupported_groups_in_statics() {
    for is_reversed in [false, true] {
        let mut structure = Structure::default();
        let mut chains: Vec<Vec<usize>> = (0..5).map(|c| structure.chain(1 + c % 3 * 2, 1.0, 1e3)).collect();
        if is_reversed {
            chains.reverse();
        }
        // Single points have no stiffness, only constraints on both sides.
        structure.pin(chains[0][0], None);
        for c in 1..chains.len() {
            let last = *chains[c - 1].last().unwrap();
            structure.pin(last, Some(chains[c][0]));
        }
        let found = solutions(&structure.system(), Weights::STIFFNESS);
        assert_alike(&found, structure.coordinates, 1e-9);
    }
}

/// A constraint that is present twice moves nothing else, and its multipliers share the force.
#[test]
fn redundant_constraints() {
    let mut single = Structure::deck(4, 10.0);
    let (one, other) = (single.chain(3, 1.0, 1e4), single.chain(3, 1.0, 1e4));
    single.pin(one[2], Some(other[0]));
    let mut double = single.clone();
    let first = single.multipliers - 3;
    double.pin(one[2], Some(other[0]));
    let w = dynamics(1e-2);
    let solve = |system: System| {
        let (n, m) = (system.coordinates(), system.multipliers());
        let mut k = system.matrix();
        system.tangent(&State::rest(n, m), w, &mut k);
        let mut factor = Factor::new(k.pattern()).unwrap();
        factor.factorise(&k).unwrap();
        let mut x: Vec<f64> = (0..n + m).map(|i| if i < n { (i as f64).sin() } else { 0.0 }).collect();
        factor.solve(&k, &mut x).unwrap();
        let (x, lambda) = x.split_at(n);
        (x.to_vec(), lambda.to_vec(), factor.is_lu())
    };
    let (x, lambda, _) = solve(single.system());
    let (y, mu, is_lu) = solve(double.system().with_shared_multipliers(first..first + 6));
    assert!(!is_lu);
    assert!(difference(&y, &x) < 1e-9, "{:e}", difference(&y, &x));
    for k in 0..3 {
        let force = lambda[first + k];
        for half in [mu[first + k], mu[first + 3 + k]] {
            assert!((half - 0.5 * force).abs() < 1e-9 * force.abs());
        }
    }
}

/// Random trees and loops of chains with random constraints.
#[test]
fn random_structures() {
    let mut state = 1_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for _ in 0..60 {
        let mut structure = Structure::default();
        let mut points = Vec::new();
        for chain in 0..8 {
            let mass = 10.0_f64.powf(4.0 * random() - 2.0);
            let own = structure.chain(2 + (4.0 * random()) as usize, mass, 1e4);
            for _ in 0..if chain == 0 { 0 } else { 1 + (1.5 * random()) as usize } {
                let other: usize = points[(random() * points.len() as f64) as usize];
                let one = own[(random() * own.len() as f64) as usize];
                let coordinates: Vec<usize> = (one..one + 3).chain(other..other + 3).collect();
                let count = 1 + (2.0 * random()) as usize;
                let rows = (0..count).map(|_| (0..6).map(|_| random() - 0.5).collect()).collect();
                structure.constrain(coordinates, rows);
            }
            points.extend(own);
        }
        for h in [1e-4, 1e-2, 1.0] {
            let found = solutions(&structure.system(), dynamics(h));
            if !found.factor.is_lu() {
                assert_eq!(found.factor.negative_pivots(), Some(structure.multipliers));
            }
            assert_alike(&found, structure.coordinates, 1e-7);
        }
    }
}

/// A point that carries two rods at a right angle in the reference configuration, in states in which the rods are collinear but
/// for an angle.
#[test]
fn rods_that_become_collinear() {
    let mut structure = Structure::default();
    let points: Vec<usize> = (0..3).map(|_| structure.chain(2, 1.0, 1e4)[0]).collect();
    let terms = structure.parts.iter().map(|part| Box::new(part.clone()) as Box<dyn Term>);
    let rod = |multiplier: usize, difference: [f64; 3]| -> Box<dyn Term> {
        let [one, other] = [points[0], points[1 + multiplier]];
        let coordinates = (one..one + 3).chain(other..other + 3).collect();
        Box::new(Rod { coordinates, multiplier, difference })
    };
    let rods = [rod(0, [1.0, 0.0, 0.0]), rod(1, [0.0, 1.0, 0.0])];
    let system = System::new(structure.coordinates, 2, terms.chain(rods).collect());
    for angle in [1.0_f64, 1e-3, 1e-6, 1e-9, 0.0] {
        let mut s = State::rest(structure.coordinates, 2);
        let other = points[2];
        s.q[other..other + 2].copy_from_slice(&[-angle.cos(), angle.sin() - 1.0]);
        let found = solutions_in(&system, &s, dynamics(1e-3));
        assert_alike(&found, structure.coordinates, 1e-7);
    }
}
