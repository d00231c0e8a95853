//! Structures of many bodies: size of factors and of fronts for the order of elimination.

use super::carriers::ConstraintRow;
use super::elimination::EliminationOrder;
use super::graph::IndexLists;
use super::ordering::{CoordinateGroups, CoreOrder, Ranks};
use super::pattern::Pattern;

/// Unknowns of a structure. Nodes have position and slopes, three coordinates each.
#[derive(Default)]
struct Structure {
    coordinates: u32,
    elements: Vec<Vec<u32>>,
    /// Coordinates of each constraint, one row for each multiplier.
    constraints: Vec<Vec<ConstraintRow>>,
}

impl Structure {
    /// Adds a chain of nodes. Returns the first coordinate of each node.
    fn body(&mut self, nodes: u32, size: u32) -> Vec<u32> {
        let first: Vec<u32> = (0..nodes).map(|node| self.coordinates + size * node).collect();
        self.coordinates += size * nodes;
        self.elements.extend(first.windows(2).map(|pair| (pair[0]..pair[1] + size).collect()));
        first
    }

    /// Constrains `count` coordinates of two nodes to be equal, or those of one node to be fixed.
    fn connect(&mut self, one: u32, other: Option<u32>, count: u32) {
        let all = |node: u32, k: u32, sign: f64| {
            (0..count).map(move |c| (node + c, if c == k { sign } else { 0.0 }))
        };
        let row = |k| all(one, k, 1.0).chain(other.into_iter().flat_map(move |other| all(other, k, -1.0)));
        self.constraints.push((0..count).map(|k| row(k).collect()).collect());
    }

    /// Returns the rows of the constraints and the blocks of all terms.
    fn parts(&self) -> (Vec<ConstraintRow>, IndexLists) {
        let rows: Vec<ConstraintRow> = self.constraints.iter().flatten().cloned().collect();
        let mut blocks: Vec<Vec<u32>> = self.elements.clone();
        let mut multiplier = self.coordinates;
        for constraint in &self.constraints {
            let coordinates = constraint[0].iter().map(|&(c, _)| c);
            blocks.push(coordinates.chain(multiplier..multiplier + constraint.len() as u32).collect());
            multiplier += constraint.len() as u32;
        }
        (rows, blocks.into_iter().collect())
    }

    fn pattern(&self) -> Pattern {
        let (rows, blocks) = self.parts();
        Pattern::new(self.coordinates as usize, &rows, &blocks, &[])
    }

    /// Returns the products of a factorisation in the order by minimum degree.
    fn products_by_degree(&self) -> f64 {
        let (rows, blocks) = self.parts();
        let groups = CoordinateGroups::new(self.coordinates as usize, &blocks);
        let ranks = Ranks::new(CoreOrder::MinimumDegree, &groups, &rows, &blocks, &[]);
        EliminationOrder::new(&ranks, &blocks).supernodes.products()
    }

    /// Returns the millions of entries of L and of operations of the factorisation, and the largest front.
    fn sizes(&self) -> [f64; 3] {
        let (mut entries, mut operations, mut front) = (0.0, 0.0, 0_u32);
        for supernode in &self.pattern().supernodes().list {
            front = front.max(supernode.columns + supernode.below);
            for column in 0..supernode.columns {
                let height = f64::from(supernode.columns - column + supernode.below);
                entries += height;
                operations += height * height;
            }
        }
        [1e-6 * entries, 1e-6 * operations, f64::from(front)]
    }
}

/// Cables with ten elements from the ground to a rigid body.
fn platform(cables: u32) -> Structure {
    let mut all = Structure::default();
    let deck = all.body(1, 12)[0];
    // Six equations of a rigid body on its three directors.
    all.elements.push((deck..deck + 12).collect());
    let directors: Vec<u32> = (deck + 3..deck + 12).collect();
    let rigid =
        |k: usize| directors.iter().enumerate().map(|(i, &c)| (c, if i == k { 1.0 } else { 0.0 })).collect();
    all.constraints.push((0..6).map(rigid).collect());
    for _ in 0..cables {
        let nodes = all.body(11, 6);
        all.connect(nodes[0], None, 3);
        let last = nodes[10];
        let row = |k: u32| {
            let point = (0..3).map(|c| (last + c, if c == k { 1.0 } else { 0.0 }));
            let vectors = (0..4).flat_map(|v| (0..3).map(move |c| (v, c)));
            let of_deck = vectors.map(|(v, c)| (deck + 3 * v + c, if c == k { -0.01 } else { 0.0 }));
            point.chain(of_deck).collect()
        };
        all.constraints.push((0..3).map(row).collect());
    }
    all
}

/// Beams of two elements along the edges of n³ cubes, clamped to each other at the corners and at the feet.
fn lattice(n: u32) -> Structure {
    let mut all = Structure::default();
    let mut first = std::collections::BTreeMap::new();
    for (x, y, z, d) in (0..=n)
        .flat_map(|x| (0..=n).flat_map(move |y| (0..=n).flat_map(move |z| (0..3).map(move |d| (x, y, z, d)))))
    {
        let mut end = [x, y, z];
        end[d] += 1;
        if end[d] > n || (d < 2 && z == 0) {
            continue;
        }
        let nodes = all.body(3, 12);
        for (corner, node) in [([x, y, z], nodes[0]), (end, nodes[2])] {
            if corner[2] == 0 {
                all.connect(node, None, 6);
            } else if let Some(&other) = first.get(&corner) {
                all.connect(node, Some(other), 6);
            } else {
                first.insert(corner, node);
            }
        }
    }
    all
}

/// Cables in two directions with a node and a spherical joint at each of n² knots.
fn net(n: u32) -> Structure {
    let mut all = Structure::default();
    let cables: Vec<[Vec<u32>; 2]> = (0..n).map(|_| [all.body(n, 6), all.body(n, 6)]).collect();
    for (i, j) in (0..n as usize).flat_map(|i| (0..n as usize).map(move |j| (i, j))) {
        all.connect(cables[j][0][i], Some(cables[i][1][j]), 3);
    }
    for c in (0..n as usize).step_by(5) {
        all.connect(cables[c][0][0], None, 3);
        all.connect(cables[c][0][n as usize - 1], None, 3);
    }
    all
}

/// Each cable has ten fronts of its own nodes, and one with its last node and the rigid body. Entries and operations are sums
/// of h and h² over the heights h of the columns.
#[test]
fn cables_of_a_platform_are_eliminated_one_by_one() {
    let cables = 1000;
    let sum = |power: i32, heights: std::ops::RangeInclusive<i32>| -> f64 {
        heights.map(|height| f64::from(height).powi(power)).sum()
    };
    let expected = [1, 2].map(|power| {
        // A node with a spherical joint has nine columns; the rigid body has twelve coordinates and six constraints.
        let cable = sum(power, 7..=15) + 9.0 * sum(power, 7..=12) + sum(power, 13..=21);
        1e-6 * (f64::from(cables) * cable + sum(power, 1..=18))
    });
    let [entries, operations, front] = platform(cables as u32).sizes();
    assert!((entries - expected[0]).abs() < 1e-9 && (operations - expected[1]).abs() < 1e-9);
    assert!((front - 21.0).abs() < 0.5);
}

/// Sizes exceed those of an independent symbolic elimination by at most 15 %, the zeros of merged supernodes. That elimination
/// orders single unknowns: groups by minimum degree, and each multiplier after the first group with enough coordinates.
///
/// With each multiplier after its last coordinate it has 707 and 862 million operations, and fronts of 966 and 717 rows.
#[test]
fn sizes_of_lattices_and_nets() {
    for (structure, expected) in [(lattice(5), [0.85, 90.0, 432.0]), (net(40), [1.71, 394.0, 558.0])] {
        let sizes = structure.sizes();
        let is_within = sizes.iter().zip(expected).all(|(size, expected)| *size <= 1.15 * expected);
        assert!(is_within, "{sizes:?}, expected {expected:?}");
    }
}

/// Layers of parallel cables of twenty elements, each layer across the one below. Contacts couple the elements at each crossing.
fn heap(layers: u32, cables: u32) -> Structure {
    let mut all = Structure::default();
    let nodes: Vec<Vec<Vec<u32>>> =
        (0..layers).map(|_| (0..cables).map(|_| all.body(21, 6)).collect()).collect();
    let element = |cable: &[u32], other: u32| {
        let at = (20.0 * (0.02 + 0.96 * (f64::from(other) + 0.5) / f64::from(cables))) as usize;
        cable[at]..cable[at] + 12
    };
    for pair in nodes.windows(2) {
        for (i, lower) in pair[0].iter().enumerate() {
            for (j, upper) in pair[1].iter().enumerate() {
                let block = element(lower, j as u32).chain(element(upper, i as u32));
                all.elements.push(block.collect());
            }
        }
    }
    all
}

/// The order of the library METIS has 835 million operations for this heap and a front of 612 rows.
#[test]
fn heaps_are_dissected() {
    let heap = heap(6, 20);
    let [_, operations, front] = heap.sizes();
    assert!(operations < 1.15 * 835.0 && front < 1.15 * 612.0, "{operations} {front}");
    assert!(0.5e6 * operations < 0.4 * heap.products_by_degree(), "{}", heap.products_by_degree());
}
