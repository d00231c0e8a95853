use super::index_lists::IndexLists;
use super::ordering::Ranks;
use super::supernodes::{RowRun, Supernode, Supernodes};

/// Elimination order of the unknowns and the resulting supernodes.
pub(crate) struct EliminationOrder {
    /// Unknown at each position.
    pub(crate) order: Vec<u32>,
    pub(crate) supernodes: Supernodes,
}

/// Marker of a missing parent.
const NO_PARENT: u32 = u32::MAX;

impl EliminationOrder {
    /// Eliminates the unknowns of a sum of dense blocks rank by rank.
    ///
    /// The supernodes are ordered such that each subtree of the elimination tree is contiguous.
    ///
    /// Source: Liu (1990), the elimination tree and its postorder; Duff & Reid (1983), the multifrontal method.
    pub(crate) fn new(ranks: &Ranks, blocks: &IndexLists) -> Self {
        let segments = Segments::new(ranks);
        let (rows, parent) = fill(&segments, first_touched(&segments, blocks));
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
            let own = segments.of_supernode(old);
            let below = &rows[old as usize];
            let last = supernodes.list.last();
            let supernode = Supernode {
                first: last.map_or(0, |last| last.first + last.columns),
                columns: own.map(|segment| segments.length(segment)).sum(),
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

/// Segments: unknowns of one rank with equal adjacency. The rows of a supernode consist of segments.
struct Segments {
    order: Vec<u32>,
    /// Start of each segment in the order, and the end.
    starts: Vec<u32>,
    /// Supernode of each segment.
    supernode: Vec<u32>,
    /// First segment of each supernode, and the end.
    of_supernodes: Vec<u32>,
    /// Segment of each unknown.
    of: Vec<u32>,
}

impl Segments {
    fn new(ranks: &Ranks) -> Self {
        let mut order = Vec::with_capacity(ranks.labels.len());
        let (mut starts, mut supernode, mut of_supernodes) = (Vec::new(), Vec::new(), Vec::new());
        let mut of = vec![0; ranks.labels.len()];
        for unknowns in ranks.unknowns.iter().filter(|unknowns| !unknowns.is_empty()) {
            of_supernodes.push(supernode.len() as u32);
            for alike in unknowns.chunk_by(|&a, &b| ranks.labels[a as usize] == ranks.labels[b as usize]) {
                alike.iter().for_each(|&unknown| of[unknown as usize] = supernode.len() as u32);
                starts.push(order.len() as u32);
                supernode.push(of_supernodes.len() as u32 - 1);
                order.extend_from_slice(alike);
            }
        }
        starts.push(order.len() as u32);
        of_supernodes.push(supernode.len() as u32);
        Self { order, starts, supernode, of_supernodes, of }
    }

    fn count(&self) -> usize {
        self.supernode.len()
    }

    fn length(&self, segment: u32) -> u32 {
        self.starts[segment as usize + 1] - self.starts[segment as usize]
    }

    fn unknowns(&self, segment: u32) -> &[u32] {
        &self.order[self.starts[segment as usize] as usize..self.starts[segment as usize + 1] as usize]
    }

    fn of_supernode(&self, supernode: u32) -> std::ops::Range<u32> {
        self.of_supernodes[supernode as usize]..self.of_supernodes[supernode as usize + 1]
    }
}

/// Returns for each supernode the later segments of the blocks that it is the first to touch.
///
/// Elimination couples these segments.
fn first_touched(segments: &Segments, blocks: &IndexLists) -> IndexLists {
    let mut pairs = Vec::new();
    let mut touched = Vec::new();
    for block in blocks.iter().filter(|block| !block.is_empty()) {
        touched.clear();
        touched.extend(block.iter().map(|&unknown| segments.of[unknown as usize]));
        touched.sort_unstable();
        touched.dedup();
        let first = segments.supernode[touched[0] as usize];
        let later = touched.iter().filter(|&&segment| segments.supernode[segment as usize] != first);
        pairs.extend(later.map(|&segment| (first, segment)));
    }
    IndexLists::by_key(segments.of_supernodes.len() - 1, pairs.iter().copied())
}

/// Computes the rows of each supernode as ascending segments, including those of its children, and its parent.
///
/// The parent is the supernode of the first row.
fn fill(segments: &Segments, touched: IndexLists) -> (IndexLists, Vec<u32>) {
    let count = touched.len();
    let (mut rows, mut parent) = (IndexLists::new(), Vec::with_capacity(count));
    // Children as linked lists: the first child of each supernode, and the next sibling of each child.
    let (mut children, mut next) = (vec![NO_PARENT; count], vec![NO_PARENT; count]);
    let mut seen = vec![NO_PARENT; segments.count()];
    let mut own: Vec<u32> = Vec::new();
    for supernode in 0..count as u32 {
        own.clear();
        let mut see = |segment: u32| {
            if seen[segment as usize] != supernode && segments.supernode[segment as usize] != supernode {
                seen[segment as usize] = supernode;
                own.push(segment);
            }
        };
        touched[supernode as usize].iter().for_each(|&segment| see(segment));
        let mut child = children[supernode as usize];
        while child != NO_PARENT {
            rows[child as usize].iter().for_each(|&segment| see(segment));
            child = next[child as usize];
        }
        own.sort_unstable();
        let up = own.first().map_or(NO_PARENT, |&segment| segments.supernode[segment as usize]);
        if up != NO_PARENT {
            next[supernode as usize] = children[up as usize];
            children[up as usize] = supernode;
        }
        parent.push(up);
        rows.push(own.iter().copied());
    }
    (rows, parent)
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
