use pulp::Arch;

use super::elimination::{Factorise, SubtreeUpdates};
use super::factor_values::{FactorLayout, FactorSection, FactorValues};
use super::substitution::{Backward, Forward, SubtractProduct, SubtreeView, add_outside, copy_outside};
use super::work_space::{WorkSize, WorkSpace};
use crate::sparse::{
    FactorStorage, MIN_SUBTREE, Subtree, Subtrees, Supernodes, VectorSection, process_subtrees,
};

/// Supernodal LDLᵀ of a symmetric matrix without pivoting, by the multifrontal method.
///
/// Each supernode is eliminated in a dense frontal matrix. The front assembles the entries of K and the update matrices
/// of the children. Its own update matrix is kept on a stack until the parent is assembled. L is stored like the matrix.
/// Subtrees are processed in parallel. The trunk follows after them, or precedes them in backward substitution. Subtrees whose
/// factors are not stored are factorised again for each substitution, with equal results.
///
/// Source: Duff & Reid (1983); Liu (1992).
#[derive(Debug)]
pub(crate) struct Ldlt {
    /// Factor L, zero on and above the diagonal.
    l: FactorValues,
    /// Inverse pivots D⁻¹.
    inverse: Vec<f64>,
    subtrees: Subtrees,
    /// Working storage of the trunk and of each subtree.
    trunk: WorkSpace,
    spaces: Vec<WorkSpace>,
}

/// A pivot is zero, not finite, or below its rounding error.
pub(crate) struct BadPivot;

impl Ldlt {
    /// Allocates storage for matrices with the given supernodes.
    pub(crate) fn new(supernodes: &Supernodes, storage: FactorStorage) -> Self {
        Self::with(supernodes, Subtrees::new(supernodes, MIN_SUBTREE), storage)
    }

    fn with(supernodes: &Supernodes, subtrees: Subtrees, storage: FactorStorage) -> Self {
        let unknowns = supernodes.list.last().map_or(0, |last| last.own().end);
        let space = |subtree: &Subtree| {
            let outside = supernodes.list[subtree.root()].below as usize;
            WorkSpace::new(WorkSize::of_subtree(supernodes, subtree), outside)
        };
        Self {
            l: FactorValues::new(FactorLayout::new(supernodes, &subtrees, storage)),
            inverse: vec![0.0; unknowns],
            trunk: WorkSpace::new(WorkSize::new(supernodes, &subtrees.trunk, &subtrees.list), 0),
            spaces: subtrees.list.iter().map(space).collect(),
            subtrees,
        }
    }

    /// Returns the number of values that a factorisation stores, with its working storage.
    pub(crate) fn values(supernodes: &Supernodes, storage: FactorStorage) -> usize {
        let subtrees = Subtrees::new(supernodes, MIN_SUBTREE);
        let spaces = subtrees.list.iter().map(|subtree| WorkSize::of_subtree(supernodes, subtree).values());
        FactorLayout::new(supernodes, &subtrees, storage).stored
            + WorkSize::new(supernodes, &subtrees.trunk, &subtrees.list).values()
            + spaces.sum::<usize>()
    }

    /// Factorises a matrix.
    ///
    /// # Errors
    /// If a pivot is zero, not finite, or below its rounding error.
    pub(crate) fn factorise(&mut self, supernodes: &Supernodes, k: &[f64]) -> Result<(), BadPivot> {
        let Self { l, inverse, subtrees: Subtrees { list: subtrees, trunk: ranges }, trunk, spaces } = self;
        let FactorValues { stored, trunk: places, buffers } = l;
        let l = buffers.is_none().then(|| VectorSection::new(0, stored));
        process_subtrees(
            subtrees,
            spaces,
            (l, VectorSection::new(0, inverse)),
            &|(l, inverse), subtree| {
                let (l, next_l) = l.map(|l| l.split_at(subtree.start)).unzip();
                let (inverse, next) = inverse.split_at(subtree.positions.start);
                ((l, inverse), (next_l, next))
            },
            &|subtree, space, (l, inverse)| match (l, &*buffers) {
                (Some(l), _) => factorise_subtree(supernodes, k, subtree, space, (l, inverse)),
                (None, None) => {}
                (None, Some(buffers)) => buffers.lend(|buffer| {
                    let (l, _) = buffer.sections(subtree);
                    factorise_subtree(supernodes, k, subtree, space, (l, inverse));
                }),
            },
        );
        let is_good = |space: &WorkSpace| space.top.is_some();
        trunk.top = spaces.iter().all(is_good).then_some(0);
        let updates = SubtreeUpdates { subtrees, spaces };
        for (range, (first, place)) in ranges.iter().cloned().zip(places) {
            let l = VectorSection::new(*first, &mut stored[place.clone()]);
            let inverse = VectorSection::new(0, inverse);
            Arch::new().dispatch(Factorise { supernodes, k, range, l, inverse, space: trunk, updates });
        }
        if is_good(trunk) { Ok(()) } else { Err(BadPivot) }
    }

    /// Solves K x = b in place, by position. `k` is the factorised matrix.
    pub(crate) fn solve(&mut self, supernodes: &Supernodes, k: &[f64], x: &mut [f64]) {
        self.process_subtrees(supernodes, k, x, &|subtree, l, _, space, x| {
            let (range, part) = (subtree.supernodes.clone(), &mut space.part[..]);
            space.outside.fill(0.0);
            let x = SubtreeView::of(supernodes, subtree, x, &mut space.outside);
            Arch::new().dispatch(Forward { supernodes, range, l, x, part });
        });
        let Self { l, inverse, subtrees: Subtrees { list: subtrees, trunk: ranges }, trunk, spaces } = self;
        let part = &mut trunk.part[..];
        for (subtree, space) in subtrees.iter().zip(&*spaces) {
            add_outside(supernodes, subtree, &space.outside, x);
        }
        for (range, l) in ranges.iter().cloned().zip(l.trunk_sections()) {
            let x = SubtreeView::whole(supernodes, &mut *x);
            Arch::new().dispatch(Forward { supernodes, range, l, x, part });
        }
        for (range, l) in ranges.iter().cloned().zip(l.trunk_sections()).rev() {
            let x = SubtreeView::whole(supernodes, &mut *x);
            Arch::new().dispatch(Backward { supernodes, range, l, inverse, x, part });
        }
        for (subtree, space) in subtrees.iter().zip(&mut *spaces) {
            copy_outside(supernodes, subtree, x, &mut space.outside);
        }
        self.process_subtrees(supernodes, k, x, &|subtree, l, inverse, space, x| {
            let (range, part) = (subtree.supernodes.clone(), &mut space.part[..]);
            let x = SubtreeView::of(supernodes, subtree, x, &mut space.outside);
            Arch::new().dispatch(Backward { supernodes, range, l, inverse, x, part });
        });
    }

    /// Processes the subtrees in parallel, each with its factor, the inverse pivots, its working storage and its part of `x`.
    fn process_subtrees(
        &mut self,
        supernodes: &Supernodes,
        k: &[f64],
        x: &mut [f64],
        work: &(impl Fn(&Subtree, FactorSection<'_>, &[f64], &mut WorkSpace, VectorSection<'_>) + Sync),
    ) {
        let Self { l, inverse, subtrees, spaces, .. } = self;
        let (l, inverse) = (&*l, &inverse[..]);
        process_subtrees(
            &subtrees.list,
            spaces,
            VectorSection::new(0, x),
            &|x, subtree| x.split_at(subtree.positions.start),
            &|subtree, space, x| match &l.buffers {
                None => work(subtree, FactorSection::new(0, &l.stored), inverse, space, x),
                Some(buffers) => buffers.lend(|buffer| {
                    factorise_subtree(supernodes, k, subtree, space, buffer.sections(subtree));
                    // Other pivots would be those of another matrix.
                    assert!(buffer.inverse(subtree) == &inverse[subtree.positions.clone()]);
                    work(subtree, buffer.values(subtree), inverse, space, x);
                }),
            },
        );
    }

    /// Computes r −= K x by position, for a matrix with the same supernodes.
    pub(crate) fn subtract_product(&mut self, supernodes: &Supernodes, k: &[f64], x: &[f64], r: &mut [f64]) {
        let Self { subtrees: Subtrees { list: subtrees, trunk: ranges }, trunk, spaces, .. } = self;
        let x = || SubtreeView::whole(supernodes, x);
        process_subtrees(
            subtrees,
            spaces,
            VectorSection::new(0, r),
            &|r, subtree| r.split_at(subtree.positions.start),
            &|subtree, space, r| {
                let (range, parts) =
                    (subtree.supernodes.clone(), (&mut space.part[..], &mut space.product[..]));
                space.outside.fill(0.0);
                let r = SubtreeView::of(supernodes, subtree, r, &mut space.outside);
                Arch::new().dispatch(SubtractProduct { supernodes, range, k, x: x(), r, parts });
            },
        );
        for (subtree, space) in subtrees.iter().zip(&*spaces) {
            add_outside(supernodes, subtree, &space.outside, r);
        }
        for range in ranges.iter().cloned() {
            let (r, parts) =
                (SubtreeView::whole(supernodes, &mut *r), (&mut trunk.part[..], &mut trunk.product[..]));
            Arch::new().dispatch(SubtractProduct { supernodes, range, k, x: x(), r, parts });
        }
    }

    /// Returns the inverse pivots D⁻¹.
    pub(crate) fn inverse_pivots(&self) -> &[f64] {
        &self.inverse
    }
}

/// Factorises a subtree.
fn factorise_subtree(
    supernodes: &Supernodes,
    k: &[f64],
    subtree: &Subtree,
    space: &mut WorkSpace,
    (l, inverse): (VectorSection<'_>, VectorSection<'_>),
) {
    space.top = Some(0);
    let (range, updates) = (subtree.supernodes.clone(), SubtreeUpdates::default());
    Arch::new().dispatch(Factorise { supernodes, k, range, l, inverse, space, updates });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::IndexLists;
    use crate::sparse::Pattern;

    /// Values of a matrix with the entries of dense blocks.
    fn matrix(pattern: &Pattern, blocks: &IndexLists, entry: impl Fn(u32, u32) -> f64) -> Vec<f64> {
        let mut k = vec![0.0; pattern.supernodes().entries()];
        let pairs =
            blocks.iter().flat_map(|block| block.iter().flat_map(|&i| block.iter().map(move |&j| (i, j))));
        pairs.for_each(|(i, j)| k[pattern.slot(i as usize, j as usize)] = entry(i, j));
        k
    }

    /// Factorises a matrix and solves K x = b with a number of threads. Returns x and the residual, which is a rounding error.
    fn solved(ldlt: &mut Ldlt, supernodes: &Supernodes, k: &[f64], threads: usize) -> [Vec<f64>; 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let b: Vec<f64> = (0..ldlt.inverse.len()).map(|i| (i as f64).sin()).collect();
        let (mut x, mut r) = (b.clone(), b);
        pool.install(|| {
            assert!(ldlt.factorise(supernodes, k).is_ok());
            ldlt.solve(supernodes, k, &mut x);
            ldlt.subtract_product(supernodes, k, &x, &mut r);
        });
        assert!(r.iter().all(|r| r.abs() < 1e-13));
        [x, r]
    }

    /// Subtrees change the result by rounding only. The number of threads and the stored part of the factor do not change the
    /// result.
    #[test]
    fn subtrees_change_rounding_only() {
        // Nodes with three coordinates in a comb: each tooth is a chain attached to the previous tooth.
        let node = |n: u32| 3 * n..3 * n + 3;
        let links = (1..600).map(|n| (if n % 60 == 0 { n - 60 } else { n - 1 }, n));
        let blocks: IndexLists = links.map(|(a, b)| node(a).chain(node(b)).collect::<Vec<_>>()).collect();
        let pattern = Pattern::new(1800, &[], &blocks, &[]);
        let supernodes = pattern.supernodes();
        let other = |i: u32, j: u32| {
            (f64::from(i) * 0.7 + f64::from(j)).sin() * (f64::from(j) * 0.7 + f64::from(i)).cos()
        };
        let k = matrix(&pattern, &blocks, |i, j| if i == j { 12.0 } else { other(i, j) });
        let run = |least: usize, threads: usize, storage: FactorStorage| {
            let mut ldlt = Ldlt::with(supernodes, Subtrees::new(supernodes, least), storage);
            let [x, r] = solved(&mut ldlt, supernodes, &k, threads);
            (ldlt.spaces.len(), ldlt.l.stored, [ldlt.inverse, x, r])
        };
        let all = FactorStorage::All;
        let ((none, l, serial), (count, l_with_subtrees, with_subtrees)) =
            (run(1800, 1, all), run(20, 1, all));
        assert!(none == 0 && count > 4, "{none} {count}");
        let pairs = serial.iter().flatten().zip(with_subtrees.iter().flatten());
        let pairs = pairs.chain(l.iter().zip(&l_with_subtrees));
        pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-13, "{a} {b}"));
        for threads in 1..5 {
            let [(_, complete, results), (_, trunk, same)] =
                [all, FactorStorage::Trunk].map(|storage| run(20, threads, storage));
            assert!(complete == l_with_subtrees && results == with_subtrees && same == with_subtrees);
            assert!(
                !trunk.is_empty() && 4 * trunk.len() < complete.len(),
                "{} {}",
                trunk.len(),
                complete.len()
            );
        }
    }

    /// The number of threads does not change the factors of large fronts, whose columns are updated in parallel.
    #[test]
    fn threads_do_not_change_large_fronts() {
        let blocks: IndexLists =
            [0..700, 400..1100].into_iter().map(|block| block.collect::<Vec<u32>>()).collect();
        let pattern = Pattern::new(1100, &[], &blocks, &[]);
        let supernodes = pattern.supernodes();
        assert!(supernodes.list.iter().any(|at| at.columns >= 300 && at.below >= 300));
        let k = matrix(&pattern, &blocks, |i, j| if i == j { 500.0 } else { f64::from(i * j).sin() });
        let run = |threads: usize| {
            let mut ldlt = Ldlt::new(supernodes, FactorStorage::All);
            let [x, _] = solved(&mut ldlt, supernodes, &k, threads);
            (ldlt.l.stored, x)
        };
        let serial = run(1);
        (2..4).for_each(|threads| assert!(run(threads) == serial));
    }
}
