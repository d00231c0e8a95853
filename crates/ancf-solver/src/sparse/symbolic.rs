use super::graph::IndexLists;
use super::ordering::Ranks;

/// Marker of a missing parent.
pub(super) const NO_PARENT: u32 = u32::MAX;

/// Segments: unknowns of one rank with equal adjacency. The rows of a supernode consist of segments.
pub(super) struct Segments {
    pub(super) order: Vec<u32>,
    /// Start of each segment in the order, and the end.
    starts: Vec<u32>,
    /// Supernode of each segment.
    pub(super) supernode: Vec<u32>,
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

    /// Returns the number of segments.
    pub(super) fn count(&self) -> usize {
        self.supernode.len()
    }

    /// Returns the number of unknowns of a segment.
    pub(super) fn length(&self, segment: u32) -> u32 {
        self.starts[segment as usize + 1] - self.starts[segment as usize]
    }

    /// Returns the unknowns of a segment.
    pub(super) fn unknowns(&self, segment: u32) -> &[u32] {
        &self.order[self.starts[segment as usize] as usize..self.starts[segment as usize + 1] as usize]
    }

    /// Returns the number of columns of a supernode.
    pub(super) fn columns(&self, supernode: u32) -> u32 {
        self.of_supernode(supernode).map(|segment| self.length(segment)).sum()
    }

    /// Returns the segments of a supernode.
    pub(super) fn of_supernode(&self, supernode: u32) -> std::ops::Range<u32> {
        self.of_supernodes[supernode as usize]..self.of_supernodes[supernode as usize + 1]
    }
}

/// Computes the segments, the rows of each supernode as segments, and its parent.
pub(super) fn symbolic(ranks: &Ranks, blocks: &IndexLists) -> (Segments, IndexLists, Vec<u32>) {
    let segments = Segments::new(ranks);
    let (rows, parent) = fill(&segments, first_touched(&segments, blocks));
    (segments, rows, parent)
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
