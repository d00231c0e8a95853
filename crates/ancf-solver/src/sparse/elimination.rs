use super::amalgamation::merged;
use super::graph::IndexLists;
use super::ordering::Ranks;
use super::supernodes::{RowRun, Supernode, Supernodes};
use super::symbolic::{NO_PARENT, symbolic};

/// Elimination order of the unknowns and the resulting supernodes.
pub(crate) struct EliminationOrder {
    /// Unknown at each position.
    pub(crate) order: Vec<u32>,
    pub(crate) supernodes: Supernodes,
}

impl EliminationOrder {
    /// Eliminates the unknowns of a sum of dense blocks rank by rank.
    ///
    /// The supernodes are ordered such that each subtree of the elimination tree is contiguous.
    ///
    /// Source: Liu (1990), the elimination tree and its postorder; Duff & Reid (1983), the multifrontal method.
    pub(crate) fn new(ranks: &Ranks, blocks: &IndexLists) -> Self {
        let (mut segments, mut rows, mut parent) = symbolic(ranks, blocks);
        if let Some(ranks) = merged(&segments, &rows, &parent, &ranks.labels) {
            (segments, rows, parent) = symbolic(&ranks, blocks);
        }
        let places = postorder(&parent);
        let mut turn = vec![0; parent.len()];
        places.iter().enumerate().for_each(|(supernode, place)| turn[place.at as usize] = supernode as u32);
        let mut order = Vec::with_capacity(segments.order.len());
        let mut position = vec![0; segments.count()];
        for &old in &turn {
            for segment in segments.of_supernode(old) {
                position[segment as usize] = order.len() as u32;
                order.extend_from_slice(segments.unknowns(segment));
            }
        }
        let mut supernodes = Supernodes::default();
        for (&old, new) in turn.iter().zip(0..) {
            let below = &rows[old as usize];
            let last = supernodes.list.last();
            let supernode = Supernode {
                first: last.map_or(0, |last| last.first + last.columns),
                columns: segments.columns(old),
                below: below.iter().map(|&segment| segments.length(segment)).sum(),
                runs: supernodes.runs.len() as u32,
                subtree: new + 1 - places[old as usize].subtree,
                start: last.map_or(0, |last| last.values().end),
            };
            supernodes.list.push(supernode);
            for (i, &segment) in below.iter().enumerate() {
                let (first, length) = (position[segment as usize], segments.length(segment));
                let follows = i > 0
                    && segments.supernode[segment as usize] == segments.supernode[below[i - 1] as usize];
                match supernodes.runs.last_mut() {
                    Some(run) if follows && run.first + run.length == first => run.length += length,
                    _ => supernodes.runs.push(RowRun { first, length, parent_row: 0 }),
                }
            }
        }
        let parents = turn.iter().map(|&old| parent[old as usize]);
        let parents: Vec<_> = parents.map(|p| (p != NO_PARENT).then(|| places[p as usize].at)).collect();
        set_parent_rows(&mut supernodes, &parents);
        Self { order, supernodes }
    }
}

/// Sets the positions of all runs in the parents. A parent contains all rows of its children except its own.
fn set_parent_rows(supernodes: &mut Supernodes, parents: &[Option<u32>]) {
    for (child, parent) in parents.iter().enumerate() {
        let first = supernodes.list[child].runs as usize;
        for at in first..first + supernodes.runs(child).len() {
            let row =
                parent.and_then(|parent| supernodes.row(parent as usize, supernodes.runs[at].first as usize));
            supernodes.runs[at].parent_row = row.unwrap_or_default() as u32;
        }
    }
}

/// Position of a supernode in the postorder, and the size of its subtree.
struct PostorderPlace {
    at: u32,
    subtree: u32,
}

/// Computes the postorder of a tree whose parents follow their children. Each subtree becomes contiguous.
fn postorder(parent: &[u32]) -> Vec<PostorderPlace> {
    let mut places: Vec<PostorderPlace> =
        parent.iter().map(|_| PostorderPlace { at: 0, subtree: 1 }).collect();
    for (child, &parent) in parent.iter().enumerate().filter(|(_, parent)| **parent != NO_PARENT) {
        places[parent as usize].subtree += places[child].subtree;
    }
    // End of the free positions of each subtree and of the whole tree.
    let (mut free, mut end) = (vec![0; parent.len()], parent.len() as u32);
    for supernode in (0..parent.len()).rev() {
        let end = match parent[supernode] {
            NO_PARENT => &mut end,
            parent => &mut free[parent as usize],
        };
        let at = *end - 1;
        *end -= places[supernode].subtree;
        (places[supernode].at, free[supernode]) = (at, at);
    }
    places
}
