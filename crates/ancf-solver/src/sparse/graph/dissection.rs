use super::coarsening::CoarseGraph;
use super::minimum_degree::minimum_degree;
use super::separation::Separation;
use super::weighted_graph::WeightedGraph;
use crate::vectors::PseudoRandom;

/// Number of vertices up to which a part is ordered by minimum degree.
const LEAF: usize = 120;
/// Number of vertices up to which a graph is separated without a coarser one.
const COARSEST: usize = 60;
/// Numbers of separations of the coarsest graph and of a whole graph, of which the best is used.
const INITIAL: usize = 30;
const TRIALS: usize = 4;

/// Computes the order of elimination of a graph by nested dissection: two sides without edges between them, each in this order,
/// then their separator. Small parts are ordered by minimum degree.
///
/// Networks in three dimensions, such as heaps of cables, have several times fewer operations than by minimum degree.
///
/// Source: George (1973); Karypis & Kumar (1998), multilevel separators.
pub(crate) fn nested_dissection(graph: &WeightedGraph) -> Vec<u32> {
    let mut random = PseudoRandom(1);
    let mut place = vec![None; graph.len()];
    let mut parts: Vec<Vec<u32>> = vec![(0..graph.len() as u32).collect()];
    let mut reversed = Vec::with_capacity(graph.len());
    while let Some(vertices) = parts.pop() {
        let part = graph.part(&vertices, &mut place);
        let separation = (part.len() > LEAF).then(|| best_of(TRIALS, || separated(&part, &mut random)));
        match separation.filter(Separation::has_sides) {
            Some(separation) => {
                let [one, other, separator] = separation.vertices(&vertices);
                reversed.extend(separator);
                parts.extend([one, other]);
            }
            None => {
                let order = minimum_degree(part.lists());
                reversed.extend(order.into_iter().rev().map(|at| vertices[at as usize]));
            }
        }
    }
    reversed.reverse();
    reversed
}

/// Returns the best of several separations.
fn best_of(count: usize, mut create: impl FnMut() -> Separation) -> Separation {
    let first = create();
    let others = (1..count).map(|_| create());
    others.fold(first, |best, other| if other.cost() < best.cost() { other } else { best })
}

/// Separates a graph by the best separation of its coarsest graph, which is refined on each finer graph.
fn separated(graph: &WeightedGraph, random: &mut PseudoRandom) -> Separation {
    let mut levels: Vec<CoarseGraph> = Vec::new();
    loop {
        let last = levels.last().map_or(graph, |level| &level.graph);
        match (last.len() > COARSEST).then(|| CoarseGraph::new(last, random)).flatten() {
            Some(coarser) => levels.push(coarser),
            None => break,
        }
    }
    let coarsest = levels.last().map_or(graph, |level| &level.graph);
    let grown = || {
        let mut separation = Separation::grown(coarsest, random);
        separation.refine(coarsest);
        separation
    };
    let mut separation = best_of(INITIAL, grown);
    while let Some(coarse) = levels.pop() {
        let fine = levels.last().map_or(graph, |level| &level.graph);
        let parts = coarse.of.iter().map(|&vertex| separation.parts[vertex as usize]).collect();
        separation = Separation::new(fine, parts);
        separation.refine(fine);
    }
    separation
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::graph::IndexLists;

    fn graph(vertices: u32, edges: &[[u32; 2]]) -> WeightedGraph {
        let pairs = edges.iter().flat_map(|&[a, b]| [(a, b), (b, a)]);
        let lists = IndexLists::by_key(vertices as usize, pairs);
        let all: Vec<u32> = (0..vertices).collect();
        WeightedGraph::part_of(&lists, &vec![1; vertices as usize], &all)
    }

    /// Square grid whose vertices have edges to their eight neighbours, as those of a shell have.
    fn grid(n: u32) -> WeightedGraph {
        let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let mut edges = Vec::new();
        for (i, j) in cells {
            let near = [(i, j + 1), (i + 1, j), (i + 1, j + 1), (i + 1, j.wrapping_sub(1))];
            let inside = near.into_iter().filter(|&(i, j)| i < n && j < n);
            edges.extend(inside.map(|(k, l)| [i * n + j, k * n + l]));
        }
        graph(n * n, &edges)
    }

    /// A line of vertices separates a square grid.
    #[test]
    fn separators_of_grids() {
        let n = 40;
        let grid = grid(n);
        let mut random = PseudoRandom(1);
        let separation = best_of(TRIALS, || separated(&grid, &mut random));
        let all: Vec<u32> = (0..grid.len() as u32).collect();
        let parts = separation.vertices(&all);
        for &vertex in &parts[0] {
            assert!(grid.neighbours(vertex).iter().all(|other| !parts[1].contains(other)));
        }
        let [one, other, separator] = parts.map(|part| part.len() as f64);
        assert!(separator <= 1.1 * f64::from(n), "{separator}");
        assert!(one.max(other) <= 0.6 * grid.len() as f64, "{one} {other}");
    }

    /// Orders are permutations, also of graphs without separators and of separate graphs.
    #[test]
    fn orders_are_permutations() {
        let n = 300;
        let star: Vec<[u32; 2]> = (1..n).map(|vertex| [0, vertex]).collect();
        let clique: Vec<[u32; 2]> = (0..n).flat_map(|a| (0..a).map(move |b| [a, b])).collect();
        let rings: Vec<[u32; 2]> = (0..n).map(|vertex| [vertex, (vertex + 3) % n]).collect();
        for graph in
            [graph(n, &star), graph(n, &clique), graph(n, &rings), graph(n, &[]), graph(0, &[]), grid(25)]
        {
            let mut order = nested_dissection(&graph);
            order.sort_unstable();
            assert_eq!(order, (0..graph.len() as u32).collect::<Vec<_>>());
        }
    }
}
