use std::ops::Range;

use super::supernodes::{Panel, Panels};

/// Partition of the supernodes into disjoint subtrees, processed in parallel, and the *trunk* of the remaining
/// supernodes.
///
/// The partition depends on the structure only. Results are therefore identical to the last digit for any number of
/// threads.
#[derive(Debug)]
pub(crate) struct Branches {
    /// Subtrees in ascending order.
    pub(crate) branches: Vec<Branch>,
    /// Supernodes of the trunk in ascending order.
    pub(crate) trunk: Vec<Range<usize>>,
}

/// Subtree of the elimination tree. Its rows are its own positions, and outside it the rows below its root.
///
/// The root is the last supernode of the subtree.
#[derive(Debug)]
pub(crate) struct Branch {
    pub(crate) panels: Range<usize>,
    pub(crate) positions: Range<usize>,
    /// Index of its first value.
    pub(crate) start: usize,
}

impl Branch {
    /// Returns the last supernode.
    pub(crate) fn root(&self) -> usize {
        self.panels.end - 1
    }

    fn new(panels: &Panels, root: usize) -> Self {
        let (root, first) = (root + 1, panels.panels[root].subtree as usize);
        let (one, last) = (panels.panels[first], panels.panels[root - 1]);
        Self { panels: first..root, positions: one.first as usize..last.own().end, start: one.start }
    }
}

/// Minimum number of supernodes of a subtree. Measured: 0.3 to 0.8 µs per supernode, and 5 µs to wake a thread.
pub(crate) const LEAST: usize = 256;

impl Branches {
    /// Finds the subtrees with a minimum number of supernodes. A single subtree is assigned to the trunk.
    pub(crate) fn new(panels: &Panels, least: usize) -> Self {
        let mut branches = Vec::new();
        let is_large = |&root: &usize| size(&panels.panels, root) >= least;
        let large = |end, first| subtrees(panels, end, first).filter(is_large);
        let mut open: Vec<usize> = large(panels.panels.len(), 0).collect();
        while let Some(root) = open.pop() {
            let children = |of: usize| large(of, panels.panels[of].subtree as usize);
            let mut fork = root;
            while let (Some(child), None) = (children(fork).next(), children(fork).nth(1)) {
                fork = child;
            }
            // The supernodes between a root and its fork become part of the trunk.
            let way = size(&panels.panels, root) - size(&panels.panels, fork);
            if children(fork).nth(1).is_some() && 8 * way < size(&panels.panels, root) {
                open.extend(children(fork));
            } else {
                branches.push(Branch::new(panels, root));
            }
        }
        if branches.len() < 2 {
            branches.clear();
        }
        branches.sort_unstable_by_key(Branch::root);
        let mut trunk = Vec::with_capacity(branches.len() + 1);
        let starts = branches.iter().map(|branch| branch.panels.start).chain([panels.panels.len()]);
        let ends = [0].into_iter().chain(branches.iter().map(|branch| branch.panels.end));
        trunk.extend(ends.zip(starts).map(|(from, to)| from..to).filter(|range| !range.is_empty()));
        Self { branches, trunk }
    }
}

/// Returns the number of supernodes of a subtree.
fn size(panels: &[Panel], root: usize) -> usize {
    root + 1 - panels[root].subtree as usize
}

/// Returns the children of a supernode in descending order.
#[inline(always)]
pub(crate) fn children(panels: &Panels, panel: usize) -> impl Iterator<Item = usize> {
    subtrees(panels, panel, panels.panels[panel].subtree as usize)
}

/// Returns the roots of the subtrees that end before `end`, in descending order down to the supernode `first`.
#[inline(always)]
fn subtrees(panels: &Panels, end: usize, first: usize) -> impl Iterator<Item = usize> {
    let mut end = end;
    std::iter::from_fn(move || {
        let root = end.checked_sub(1).filter(|&root| root >= first)?;
        end = panels.panels[root].subtree as usize;
        Some(root)
    })
}

/// Section of a vector that starts at an offset.
pub(crate) struct Stretch<'a> {
    first: usize,
    values: &'a mut [f64],
}

impl<'a> Stretch<'a> {
    /// Creates the section of a full vector.
    pub(crate) fn whole(values: &'a mut [f64]) -> Self {
        Self { first: 0, values }
    }

    /// Splits the section at an entry.
    pub(crate) fn cut(self, at: usize) -> (Self, Self) {
        let (before, after) = self.values.split_at_mut(at - self.first);
        (Self { first: self.first, values: before }, Self { first: at, values: after })
    }

    /// Returns some of the entries.
    #[inline(always)]
    pub(crate) fn of(&mut self, entries: Range<usize>) -> &mut [f64] {
        &mut self.values[entries.start - self.first..entries.end - self.first]
    }

    /// Returns some of the entries and consumes the section.
    pub(crate) fn into_of(self, entries: Range<usize>) -> &'a mut [f64] {
        &mut self.values[entries.start - self.first..entries.end - self.first]
    }
}

/// Processes the subtrees in parallel, each with its own working storage and data. `cut` splits the data before a
/// subtree.
pub(crate) fn fork<S: Send, P: Send>(
    branches: &[Branch],
    spaces: &mut [S],
    parted: P,
    cut: &(impl Fn(P, &Branch) -> (P, P) + Sync),
    work: &(impl Fn(&Branch, &mut S, P) + Sync),
) {
    match (branches, spaces) {
        ([], _) | (_, []) => {}
        ([branch], [space, ..]) => work(branch, space, parted),
        (_, spaces) => {
            let middle = branches.len() / 2;
            let ((left, right), (here, there)) = (branches.split_at(middle), spaces.split_at_mut(middle));
            let (before, after) = cut(parted, &right[0]);
            let one = || fork(left, here, before, cut, work);
            let other = || fork(right, there, after, cut, work);
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
    use super::super::index_lists::Lists;
    use super::super::pattern::Pattern;
    use super::*;

    /// Checks that subtrees and trunk partition all supernodes. Outside a subtree, only rows of its root may occur.
    fn checked(links: impl Iterator<Item = (u32, u32)>, nodes: usize) -> Branches {
        let blocks: Lists = links.map(|(a, b)| vec![a, b]).collect();
        let pattern = Pattern::new(nodes, 0, &blocks, &[]);
        let panels = pattern.panels();
        let found = Branches::new(panels, LEAST);
        let mut all: Vec<usize> = found.trunk.iter().cloned().flatten().collect();
        all.extend(found.branches.iter().flat_map(|branch| branch.panels.clone()));
        all.sort_unstable();
        assert!(all.into_iter().eq(0..panels.panels.len()));
        for branch in &found.branches {
            assert!(branch.panels.len() >= LEAST);
            let rows = branch.panels.clone().flat_map(|at| panels.runs(at)).flat_map(|run| run.positions());
            let outside = rows.filter(|row| !branch.positions.contains(row));
            outside.for_each(|row| assert!(panels.row(branch.root(), row).is_some()));
        }
        found
    }

    /// A chain has two subtrees, a tree more, and a short chain none.
    #[test]
    fn chains_and_trees() {
        let chain = |nodes: u32| checked((1..nodes).map(|n| (n - 1, n)), nodes as usize);
        assert_eq!(chain(3000).branches.len(), 2);
        assert!(chain(500).branches.is_empty());
        // Eight chains of 400 nodes, in pairs at the ends of four chains of ten nodes, which meet at one node.
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
        assert_eq!(tree.branches.len(), 8);
        // A ring and a ladder.
        checked((0..3000).map(|n| (n, (n + 1) % 3000)), 3000);
        checked((0..4000).flat_map(|n| [(n, n + 2), (n - n % 2, n - n % 2 + 1)]), 4002);
    }
}
