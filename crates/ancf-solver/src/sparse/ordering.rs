use std::cmp::Reverse;
use std::iter;

use super::carriers::{ConstraintRow, carried_places};
use super::graph::{IndexLists, WeightedGraph, minimum_degree, nested_dissection};

/// Massless coordinates of a term and the multipliers that determine them.
pub(crate) type Massless = (Vec<usize>, std::ops::Range<usize>);

/// Unknowns in ranks, which define the order of elimination. A rank is a group of coordinates and its dependent
/// unknowns.
pub(crate) struct Ranks {
    /// Unknowns of each rank in order. Multipliers are numbered after coordinates.
    pub(crate) unknowns: IndexLists,
    /// Label of each unknown. Neighbours with equal labels have equal adjacency.
    pub(crate) labels: Vec<u32>,
}

/// Order of groups that are on no tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CoreOrder {
    MinimumDegree,
    NestedDissection,
}

impl Ranks {
    /// Ranks the unknowns of a sum of dense blocks, with the row of each multiplier.
    pub(crate) fn new(
        core: CoreOrder,
        groups: &CoordinateGroups,
        rows: &[ConstraintRow],
        blocks: &IndexLists,
        massless: &[Massless],
    ) -> Self {
        let (coordinates, multipliers) = (groups.of.len(), rows.len());
        let groups = groups.ordered(core);
        let mut rank = vec![None; coordinates];
        groups.iter().flatten().zip(0..).for_each(|(&c, place)| rank[c as usize] = Some(place));
        let carried = carried_places(&groups, &rank, blocks, rows);
        let all_massless = || massless.iter().flat_map(|(late, _)| late.iter().copied());
        let mut is_massless = vec![false; coordinates];
        all_massless().for_each(|c| (is_massless[c], rank[c]) = (true, None));
        // Unknowns without a block come last.
        let end = coordinates as u32;
        let before = last_coordinates(multipliers, blocks, &rank);
        let mut defines = vec![false; multipliers];
        for (late, defining) in massless.iter().filter(|(late, _)| !late.is_empty()) {
            defining.clone().for_each(|m| defines[m] = true);
            let last = defining.clone().map(|m| before[m].unwrap_or(end)).max();
            late.iter().for_each(|&c| rank[c] = rank[c].max(last));
        }
        let after = last_coordinates(multipliers, blocks, &rank);
        let rank_of = |m: usize| if defines[m] { before[m] } else { carried[m].or(after[m]) };
        rank.extend((0..multipliers).map(rank_of));
        let of = |kind: bool| (0..multipliers).filter(move |&m| defines[m] == kind).map(|m| coordinates + m);
        // Order of the unknowns within a rank.
        let (defining, other) = (of.clone()(true), of(false));
        let regular = (0..coordinates).filter(|&c| !is_massless[c]);
        let late = (0..coordinates).filter(|&c| is_massless[c]);
        let sequence = regular.chain(defining).chain(late).chain(other);
        let pairs = sequence.map(|unknown| (rank[unknown].unwrap_or(end), unknown as u32));
        let labels = labels(&groups, coordinates + multipliers, blocks, &is_massless);
        let placed = IndexLists::by_key(coordinates + 1, pairs);
        let mut places = placed.iter();
        let of_groups = groups.iter().map(|group| group.len()).chain(iter::once(1));
        let mut unknowns = IndexLists::new();
        of_groups.for_each(|places_of| unknowns.push(places.by_ref().take(places_of).flatten().copied()));
        Self { unknowns, labels }
    }
}

/// Labels coordinates with mass by their group, and all other unknowns by their first block.
fn labels(groups: &IndexLists, unknowns: usize, blocks: &IndexLists, is_massless: &[bool]) -> Vec<u32> {
    let mut labels = vec![0; unknowns];
    let is_special = |u: usize| is_massless.get(u).is_none_or(|is_massless| *is_massless);
    for (block, label) in blocks.iter().zip(1..) {
        for unknown in block.iter().map(|&u| u as usize).filter(|&u| is_special(u)) {
            if labels[unknown] == 0 {
                labels[unknown] = label;
            }
        }
    }
    for (group, label) in groups.iter().zip(blocks.len() as u32 + 1..) {
        group.iter().filter(|&&c| !is_special(c as usize)).for_each(|&c| labels[c as usize] = label);
    }
    labels
}

/// Returns for each multiplier the last rank among the coordinates of its blocks, for coordinates with a rank.
fn last_coordinates(multipliers: usize, blocks: &IndexLists, rank: &[Option<u32>]) -> Vec<Option<u32>> {
    let mut last: Vec<Option<u32>> = vec![None; multipliers];
    let coordinates = rank.len();
    for block in blocks.iter().filter(|block| !is_free(block, coordinates)) {
        let touched = block.iter().filter(|&&u| (u as usize) < coordinates);
        let latest = touched.filter_map(|&c| rank[c as usize]).max();
        for &unknown in block.iter().filter(|&&u| u as usize >= coordinates) {
            let last = &mut last[unknown as usize - coordinates];
            *last = (*last).max(latest);
        }
    }
    last
}

/// Groups of coordinates and their graph.
pub(crate) struct CoordinateGroups {
    /// Group of each coordinate.
    of: Vec<u32>,
    /// Numbers of coordinates of the groups.
    sizes: Vec<u32>,
    /// Adjacent groups of each group.
    graph: IndexLists,
}

impl CoordinateGroups {
    /// Groups the coordinates of a sum of dense blocks.
    pub(crate) fn new(coordinates: usize, blocks: &IndexLists) -> Self {
        let (of, count) = groups(coordinates, blocks);
        let mut sizes = vec![0; count];
        of.iter().for_each(|&group| sizes[group as usize] += 1);
        let graph = graph(&of, count, blocks);
        Self { of, sizes, graph }
    }

    /// Returns the coordinates of each group in the order of elimination.
    fn ordered(&self, core: CoreOrder) -> IndexLists {
        let count = self.sizes.len();
        let mut turn = vec![0; count];
        for (group, at) in elimination(core, &self.graph, &self.sizes).into_iter().zip(0..) {
            turn[group as usize] = at;
        }
        IndexLists::by_key(count, self.of.iter().zip(0..).map(|(&group, c)| (turn[group as usize], c)))
    }
}

/// Returns true if a block has no multipliers.
fn is_free(block: &[u32], coordinates: usize) -> bool {
    block.iter().all(|&u| (u as usize) < coordinates)
}

/// Groups coordinates by the set of blocks that contain them. Returns the group of each coordinate and the group count.
///
/// Blocks with multipliers and blocks contained in another block are ignored, so joints and loads do not split a node.
fn groups(coordinates: usize, blocks: &IndexLists) -> (Vec<u32>, usize) {
    let free = || blocks.iter().zip(0..).filter(|(block, _)| is_free(block, coordinates));
    let of = IndexLists::by_key(
        coordinates,
        free().flat_map(|(block, b)| block.iter().copied().zip(iter::repeat(b))),
    );
    let is_within_another = |block: &[u32], b: u32| {
        let fewest = block.iter().map(|&c| &of[c as usize]).min_by_key(|of| of.len());
        fewest.into_iter().flatten().any(|&other| {
            let larger = &blocks[other as usize];
            (larger.len(), Reverse(other)) > (block.len(), Reverse(b))
                && block.iter().all(|c| larger.contains(c))
        })
    };
    let mut classes = Classes { class: vec![0; coordinates], split: vec![(u32::MAX, 0)] };
    for (block, b) in free().filter(|(block, b)| !is_within_another(block, *b)) {
        classes.split_block(b, block.iter().map(|&c| c as usize));
    }
    // Coordinates that belong only to blocks with multipliers.
    let alone: Vec<bool> = classes.class.iter().map(|&class| class == 0).collect();
    for (block, b) in blocks.iter().zip(0..).filter(|(block, _)| !is_free(block, coordinates)) {
        let own = block.iter().map(|&c| c as usize);
        classes.split_block(b, own.filter(|&c| c < coordinates && alone[c]));
    }
    classes.numbered()
}

/// Partition of the coordinates that is refined block by block.
struct Classes {
    /// Class of each coordinate. It is zero before the first block.
    class: Vec<u32>,
    /// Last block that split each class, and the new class of this split.
    split: Vec<(u32, u32)>,
}

impl Classes {
    /// Separates the members of a block from the other coordinates of their classes.
    fn split_block(&mut self, block: u32, members: impl Iterator<Item = usize>) {
        for c in members {
            let class = self.class[c] as usize;
            if self.split[class].0 != block {
                self.split[class] = (block, self.split.len() as u32);
                self.split.push((u32::MAX, 0));
            }
            self.class[c] = self.split[class].1;
        }
    }

    /// Numbers the classes in order of appearance. Each coordinate without a block forms a class of its own.
    fn numbered(mut self) -> (Vec<u32>, usize) {
        let mut number: Vec<Option<u32>> = vec![None; self.split.len()];
        let mut count = 0;
        for class in &mut self.class {
            let mut new = || {
                count += 1;
                count - 1
            };
            *class = if *class == 0 { new() } else { *number[*class as usize].get_or_insert_with(new) };
        }
        (self.class, count as usize)
    }
}

/// Returns the adjacent groups of each group in ascending order. Groups are adjacent if they share a block.
fn graph(group_of: &[u32], count: usize, blocks: &IndexLists) -> IndexLists {
    let clusters: IndexLists = blocks
        .iter()
        .map(|block| {
            let own = block.iter().filter_map(|&c| group_of.get(c as usize));
            let mut groups: Vec<u32> = own.copied().collect();
            groups.sort_unstable();
            groups.dedup();
            groups
        })
        .collect();
    let pairs = clusters.iter().flat_map(|cluster| {
        cluster.iter().flat_map(move |&g| cluster.iter().filter(move |&&h| h != g).map(move |&h| (g, h)))
    });
    let all = IndexLists::by_key(count, pairs);
    all.iter()
        .map(|others| {
            let mut others = others.to_vec();
            others.sort_unstable();
            others.dedup();
            others
        })
        .collect()
}

/// Computes the elimination order of a graph: leaves from all sides, so that trees end at their centre, then the core. `sizes` are the
/// numbers of coordinates of the vertices.
fn elimination(of_core: CoreOrder, graph: &IndexLists, sizes: &[u32]) -> Vec<u32> {
    let mut degree: Vec<usize> = graph.iter().map(<[u32]>::len).collect();
    let (mut order, mut is_out) = (Vec::with_capacity(graph.len()), vec![false; graph.len()]);
    let mut leaves: Vec<u32> = (0..graph.len() as u32).filter(|&g| degree[g as usize] <= 1).collect();
    while !leaves.is_empty() {
        let mut next = Vec::new();
        for leaf in leaves {
            order.push(leaf);
            is_out[leaf as usize] = true;
            for &other in graph[leaf as usize].iter().filter(|&&other| !is_out[other as usize]) {
                degree[other as usize] -= 1;
                if degree[other as usize] == 1 {
                    next.push(other);
                }
            }
        }
        leaves = next;
    }
    let core: Vec<u32> = (0..graph.len() as u32).filter(|&g| !is_out[g as usize]).collect();
    let part = WeightedGraph::part_of(graph, sizes, &core);
    let of_part = match of_core {
        CoreOrder::MinimumDegree => minimum_degree(part.lists()),
        CoreOrder::NestedDissection => nested_dissection(&part),
    };
    order.extend(of_part.into_iter().map(|at| core[at as usize]));
    order
}
