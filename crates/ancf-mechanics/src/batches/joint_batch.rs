use ancf_solver::equations::{Batch, LANES, Lanes, Level, LocalLanes, MAX_UNKNOWNS, Term, Weights};
use pulp::Simd;

use super::bilinear_lanes::BilinearLanes;
use super::entry_list::EntryList;
use crate::batch::{BatchKernel, BatchTerm, KernelBatch, TermBatch, alike};
use crate::constraints::ConstraintGroup;
use crate::lanes::{Lane, Pass};

/// Batch of constraints of joints with equal structure.
#[derive(Debug)]
struct JointBatch {
    count: usize,
    rows: BilinearLanes,
    entries: Vec<[u8; 2]>,
}

impl BatchTerm for ConstraintGroup {
    fn batches(joints: &[&Self]) -> Vec<TermBatch> {
        let structure = |joint: &Self| -> Option<Vec<usize>> {
            let (coordinates, rows) = (joint.coordinates().len(), joint.rows());
            let own = rows.iter().flat_map(|row| row.structure());
            (coordinates + rows.len() <= MAX_UNKNOWNS).then(|| [coordinates].into_iter().chain(own).collect())
        };
        let batch = |joints: &[&Self]| -> Box<dyn Batch> {
            let (rows, mut entries): (Vec<_>, _) =
                (joints.iter().map(|joint| joint.rows()).collect(), EntryList::default());
            let rows = BilinearLanes::new(joints[0].coordinates().len(), &rows, &mut entries);
            Box::new(KernelBatch(JointBatch { count: joints.len(), rows, entries: entries.list }))
        };
        alike(joints, structure, batch)
    }
}

impl BatchKernel for JointBatch {
    fn count(&self) -> usize {
        self.count
    }

    fn is_constraint(&self) -> bool {
        true
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn entries(&self) -> Option<&[[u8; 2]]> {
        Some(&self.entries)
    }

    #[inline(always)]
    fn add_residual<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        self.rows.add_residual(pass, at, r);
    }

    #[inline(always)]
    fn set_tangent<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]) {
        for entry in &mut *k {
            pass.store(entry, pass.zero());
        }
        self.rows.add_tangent(pass, at, w.q, k);
    }

    #[inline(always)]
    fn add_constraints<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, level: Level, phi: &mut [Lanes]) {
        self.rows.add_constraints(pass, at, level, phi);
    }

    #[inline(always)]
    fn energies<S: Simd>(&self, pass: Pass<S>, _: &LocalLanes<'_>) -> [Lane<S>; 3] {
        [pass.zero(); 3]
    }

    #[inline(always)]
    fn check_admissible<S: Simd>(&self, _: Pass<S>, _: &LocalLanes<'_>, _: &mut [bool; LANES]) {}
}
