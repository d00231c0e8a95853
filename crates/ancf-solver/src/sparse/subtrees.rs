use std::ops::Range;

use super::supernodes::{Supernode, Supernodes};

/// Partition of the supernodes into disjoint subtrees, processed in parallel, and the *trunk* of the remaining
/// supernodes.
///
/// The partition depends on the structure only. Results are therefore identical to the last digit for any number of
/// threads.
#[derive(Debug)]
pub(crate) struct Subtrees {
    /// Subtrees in ascending order.
    pub(crate) list: Vec<Subtree>,
    /// Supernodes of the trunk in ascending order.
    pub(crate) trunk: Vec<Range<usize>>,
}

/// Subtree of the elimination tree. Its rows are its own positions, and outside it the rows below its root.
///
/// The root is the last supernode of the subtree.
#[derive(Debug)]
pub(crate) struct Subtree {
    pub(crate) supernodes: Range<usize>,
    pub(crate) positions: Range<usize>,
    /// Index of its first value.
    pub(crate) start: usize,
}

impl Subtree {
    /// Returns the last supernode.
    pub(crate) fn root(&self) -> usize {
        self.supernodes.end - 1
    }

    fn new(supernodes: &Supernodes, root: usize) -> Self {
        let (root, first) = (root + 1, supernodes.list[root].subtree as usize);
        let (one, last) = (supernodes.list[first], supernodes.list[root - 1]);
        Self { supernodes: first..root, positions: one.first as usize..last.own().end, start: one.start }
    }
}

/// Minimum number of supernodes of a subtree. Measured: 0.3 to 0.8 µs per supernode, and 5 µs to wake a thread.
pub(crate) const MIN_SUBTREE: usize = 256;

impl Subtrees {
    /// Finds the subtrees with a minimum number of supernodes. A single subtree is assigned to the trunk.
    pub(crate) fn new(supernodes: &Supernodes, least: usize) -> Self {
        let mut subtrees = Vec::new();
        let is_large = |&root: &usize| size(&supernodes.list, root) >= least;
        let large = |end, first| subtree_roots(supernodes, end, first).filter(is_large);
        let mut open: Vec<usize> = large(supernodes.list.len(), 0).collect();
        while let Some(root) = open.pop() {
            let children = |of: usize| large(of, supernodes.list[of].subtree as usize);
            let mut fork = root;
            while let (Some(child), None) = (children(fork).next(), children(fork).nth(1)) {
                fork = child;
            }
            // The supernodes between a root and its fork become part of the trunk.
            let way = size(&supernodes.list, root) - size(&supernodes.list, fork);
            if children(fork).nth(1).is_some() && 8 * way < size(&supernodes.list, root) {
                open.extend(children(fork));
            } else {
                subtrees.push(Subtree::new(supernodes, root));
            }
        }
        if subtrees.len() < 2 {
            subtrees.clear();
        }
        subtrees.sort_unstable_by_key(Subtree::root);
        let mut trunk = Vec::with_capacity(subtrees.len() + 1);
        let starts = subtrees.iter().map(|subtree| subtree.supernodes.start).chain([supernodes.list.len()]);
        let ends = [0].into_iter().chain(subtrees.iter().map(|subtree| subtree.supernodes.end));
        trunk.extend(ends.zip(starts).map(|(from, to)| from..to).filter(|range| !range.is_empty()));
        Self { list: subtrees, trunk }
    }
}

/// Returns the number of supernodes of a subtree.
fn size(supernodes: &[Supernode], root: usize) -> usize {
    root + 1 - supernodes[root].subtree as usize
}

/// Returns the children of a supernode in descending order.
#[inline(always)]
pub(crate) fn children(supernodes: &Supernodes, supernode: usize) -> impl Iterator<Item = usize> {
    subtree_roots(supernodes, supernode, supernodes.list[supernode].subtree as usize)
}

/// Returns the roots of the subtrees that end before `end`, in descending order down to the supernode `first`.
#[inline(always)]
fn subtree_roots(supernodes: &Supernodes, end: usize, first: usize) -> impl Iterator<Item = usize> {
    let mut end = end;
    std::iter::from_fn(move || {
        let root = end.checked_sub(1).filter(|&root| root >= first)?;
        end = supernodes.list[root].subtree as usize;
        Some(root)
    })
}

/// Section of a vector that starts at an offset.
pub(crate) struct VectorSection<'a> {
    first: usize,
    values: &'a mut [f64],
}

impl<'a> VectorSection<'a> {
    /// Creates a section that begins with the entry `first`.
    pub(crate) fn new(first: usize, values: &'a mut [f64]) -> Self {
        Self { first, values }
    }

    /// Splits the section at an entry.
    pub(crate) fn split_at(self, at: usize) -> (Self, Self) {
        let (before, after) = self.values.split_at_mut(at - self.first);
        (Self { first: self.first, values: before }, Self { first: at, values: after })
    }

    /// Returns some of the entries.
    #[inline(always)]
    pub(crate) fn slice(&mut self, entries: Range<usize>) -> &mut [f64] {
        &mut self.values[entries.start - self.first..entries.end - self.first]
    }

    /// Returns some of the entries and consumes the section.
    pub(crate) fn into_slice(self, entries: Range<usize>) -> &'a mut [f64] {
        &mut self.values[entries.start - self.first..entries.end - self.first]
    }
}

/// Processes the subtrees in parallel, each with its own working storage and data. `cut` splits the data before a
/// subtree.
pub(crate) fn process_subtrees<S: Send, P: Send>(
    subtrees: &[Subtree],
    spaces: &mut [S],
    data: P,
    cut: &(impl Fn(P, &Subtree) -> (P, P) + Sync),
    work: &(impl Fn(&Subtree, &mut S, P) + Sync),
) {
    match (subtrees, spaces) {
        ([], _) | (_, []) => {}
        ([subtree], [space, ..]) => work(subtree, space, data),
        (_, spaces) => {
            let middle = subtrees.len() / 2;
            let ((left, right), (here, there)) = (subtrees.split_at(middle), spaces.split_at_mut(middle));
            let (before, after) = cut(data, &right[0]);
            let one = || process_subtrees(left, here, before, cut, work);
            let other = || process_subtrees(right, there, after, cut, work);
            // With a single thread, waking another one has no benefit.
            if rayon::current_num_threads() > 1 {
                rayon::join(one, other);
            } else {
                one();
                other();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::pattern::Pattern;
    use super::*;
    use crate::sparse::graph::IndexLists;

    /// Checks that subtrees and trunk partition all supernodes. Outside a subtree, only rows of its root may occur.
    fn checked(links: impl Iterator<Item = (u32, u32)>, nodes: usize) -> Subtrees {
        let blocks: IndexLists = links.map(|(a, b)| vec![a, b]).collect();
        let pattern = Pattern::new(nodes, &[], &blocks, &[]);
        let supernodes = pattern.supernodes();
        let found = Subtrees::new(supernodes, MIN_SUBTREE);
        let mut all: Vec<usize> = found.trunk.iter().cloned().flatten().collect();
        all.extend(found.list.iter().flat_map(|subtree| subtree.supernodes.clone()));
        all.sort_unstable();
        assert!(all.into_iter().eq(0..supernodes.list.len()));
        for subtree in &found.list {
            assert!(subtree.supernodes.len() >= MIN_SUBTREE);
            let rows =
                subtree.supernodes.clone().flat_map(|at| supernodes.runs(at)).flat_map(|run| run.positions());
            let outside = rows.filter(|row| !subtree.positions.contains(row));
            outside.for_each(|row| assert!(supernodes.row(subtree.root(), row).is_some()));
        }
        found
    }

    /// A chain has two subtrees, a tree more, and a short chain none.
    #[test]
    fn chains_and_trees() {
        let chain = |nodes: u32| checked((1..nodes).map(|n| (n - 1, n)), nodes as usize);
        assert_eq!(chain(3000).list.len(), 2);
        assert!(chain(500).list.is_empty());
        // Eight chains of 400 nodes, in pairs at the ends of four chains of ten nodes with a common node.
        let parent = |n: u32| match n {
            1..=40 => {
                if n % 10 == 1 {
                    0
                } else {
                    n - 1
                }
            }
            _ if (n - 41_u32).is_multiple_of(400) => 10 * ((n - 41) / 800 + 1),
            _ => n - 1,
        };
        let tree = checked((1..3241).map(|n| (parent(n), n)), 3241);
        assert_eq!(tree.list.len(), 8);
        // A ring and a ladder.
        checked((0..3000).map(|n| (n, (n + 1) % 3000)), 3000);
        checked((0..4000).flat_map(|n| [(n, n + 2), (n - n % 2, n - n % 2 + 1)]), 4002);
    }
}
