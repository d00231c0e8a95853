use std::sync::Arc;

use ancf_solver::equations::{LANES, Lanes, LocalLanes, Term, Weights};
use pulp::Simd;

use super::batched::{BatchTerm, TermBatch, consecutive, elements_of_bodies};
use super::beam_law::{BatchStation, BeamLaw};
use super::kernel::{BatchKernel, KernelBatch};
use super::relative::RelativeLanes;
use super::strain::SectionLanes;
use super::triangle::{VectorBlocks, lower};
use crate::elements::{Beam24, Beam27, BeamElement};
use crate::kinematics::{BeamShape, Interpolation, QuadraticShape};
use crate::lanes::{Lane, LaneNumber, Pass, VectorLanes, dot, plus, scaled};
use crate::sections::STRAINS;

/// Batch of beam elements with N vectors: A + 1 of the axis and B of each kind of section vector.
#[derive(Debug)]
struct BeamBatch<const N: usize, const A: usize, const B: usize, C> {
    count: usize,
    law: Arc<BeamLaw<N, A, B, C>>,
    /// Reference directors in the global frame at each station, or shared by all stations.
    reference: Vec<[[Lanes; 3]; 7]>,
}

impl BatchTerm for Beam24 {
    fn batches(elements: &[&Self]) -> Vec<TermBatch> {
        batches::<8, 3, 2, BeamShape>(elements)
    }
}

impl BatchTerm for Beam27 {
    fn batches(elements: &[&Self]) -> Vec<TermBatch> {
        batches::<9, 2, 3, QuadraticShape>(elements)
    }
}

fn batches<const N: usize, const A: usize, const B: usize, S: Interpolation<N>>(
    elements: &[&BeamElement<N, S>],
) -> Vec<TermBatch>
where
    BeamElement<N, S>: Term,
{
    let mut batches: Vec<TermBatch> = Vec::new();
    let mut last: Option<(&BeamElement<N, S>, Arc<BeamLaw<N, A, B, f64>>)> = None;
    for (first, elements) in elements_of_bodies(elements) {
        let head = elements[0];
        let congruent = elements.iter().all(|element| Arc::ptr_eq(&element.profile, &head.profile));
        if !congruent {
            let profiles: Vec<_> = elements.iter().map(|element| &*element.profile).collect();
            let law = BeamLaw::<N, A, B, Lanes>::new::<S>(&profiles);
            let batch = law.map(|law| BeamBatch::new(elements, Arc::new(law)));
            batches.extend(batch.map(|batch| consecutive(first, KernelBatch(batch))));
            continue;
        }
        let known = last.as_ref().filter(|(known, _)| Arc::ptr_eq(&known.profile, &head.profile));
        let law = match known {
            Some((_, law)) => Some(Arc::clone(law)),
            None => BeamLaw::new::<S>(&[&*head.profile]).map(Arc::new),
        };
        if let Some(law) = law {
            batches.push(consecutive(first, KernelBatch(BeamBatch::new(elements, Arc::clone(&law)))));
            last = Some((head, law));
        }
    }
    batches
}

impl<const N: usize, const A: usize, const B: usize, C: LaneNumber> BeamBatch<N, A, B, C> {
    fn new<S: Interpolation<N>>(elements: &[&BeamElement<N, S>], law: Arc<BeamLaw<N, A, B, C>>) -> Self {
        let at = |s: usize| {
            let directors: Vec<_> = elements
                .iter()
                .map(|element| element.profile.stations[s].reference(&element.frame))
                .collect();
            std::array::from_fn(|i| {
                std::array::from_fn(|axis| {
                    Lanes(std::array::from_fn(|lane| directors[lane.min(directors.len() - 1)][i][axis]))
                })
            })
        };
        let mut reference: Vec<[[Lanes; 3]; 7]> = (0..law.stations.len()).map(at).collect();
        if reference.iter().all(|other| *other == reference[0]) {
            reference.truncate(1);
        }
        Self { count: elements.len(), law, reference }
    }

    /// Computes the directors at a station.
    #[inline(always)]
    fn deform<S: Simd>(
        &self,
        pass: Pass<S>,
        station: usize,
        q: &RelativeLanes<S, A, B>,
        section: &mut SectionLanes<S>,
    ) {
        let BatchStation { mix, plan, .. } = &self.law.stations[station];
        let reference = &self.reference[station.min(self.reference.len() - 1)];
        section.deform(pass, reference, &mix.directors(pass, q, plan.reach), plan.reach);
    }
}

impl<const N: usize, const A: usize, const B: usize, C: LaneNumber> BatchKernel for BeamBatch<N, A, B, C> {
    fn count(&self) -> usize {
        self.count
    }

    fn is_damped(&self) -> bool {
        self.law.mass_damping != 0.0 || self.law.is_viscous()
    }

    #[inline(always)]
    fn add_residual<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        let law = &*self.law;
        let (q, v) = (RelativeLanes::of(pass, &law.layout, at.q), self.moving(pass, at));
        let (mut force, mut section) = (RelativeLanes::zero(pass), SectionLanes::new(pass));
        for (s, station) in law.stations.iter().enumerate() {
            self.deform(pass, s, &q, &mut section);
            station.resultants(pass, v.as_ref(), law.retardation, station.weight, &mut section);
            station.plan.force_terms(pass, &section.n, &section.now, &mut section.scratch);
            station.mix.spread(pass, &section.scratch, &mut force, station.plan.reach);
        }
        let mut rows = law.inertia(pass, at);
        force.add_to(&law.layout, &mut rows);
        for a in 0..N {
            for axis in 0..3 {
                let row = &mut r[3 * a + axis];
                pass.store(row, pass.load(row) + rows[a][axis]);
            }
        }
    }

    #[inline(always)]
    fn set_tangent<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]) {
        self.set_stiffness(pass, at, None, w, k);
    }

    #[inline(always)]
    fn set_predicted<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, from: &[Lanes], k: &mut [Lanes]) {
        self.set_stiffness(pass, at, Some(from), Weights::STIFFNESS, k);
    }

    #[inline(always)]
    fn energies<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> [Lane<S>; 3] {
        let law = &*self.law;
        let q = RelativeLanes::of(pass, &law.layout, at.q);
        let (mut strain, mut section, half) = (pass.zero(), SectionLanes::new(pass), pass.splat(0.5));
        for (s, station) in law.stations.iter().enumerate() {
            self.deform(pass, s, &q, &mut section);
            station.resultants(pass, None, 0.0, station.weight, &mut section);
            for k in 0..station.plan.resultants.len() {
                strain = section.n[k].mul_add(section.strains[k], strain);
            }
        }
        let (mut kinetic, mut potential) = (pass.zero(), pass.zero());
        for (a, b, mass) in &law.mass {
            let (x, y) = (pass.vector(&at.v[3 * a..3 * a + 3]), pass.vector(&at.v[3 * b..3 * b + 3]));
            let share = if a == b { mass.lane(pass) * half } else { mass.lane(pass) };
            kinetic = dot(x, y).mul_add(share, kinetic);
        }
        for (a, first) in law.first.iter().enumerate() {
            let fall = dot(law.gravity(pass, -at.load), pass.vector(&at.q[3 * a..3 * a + 3]));
            potential = fall.mul_add(first.lane(pass), potential);
        }
        [kinetic, strain * half, potential]
    }

    /// Requires det J > 0 on the axis.
    #[inline(always)]
    fn check_admissible<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, admissible: &mut [bool; LANES]) {
        let q = RelativeLanes::of(pass, &self.law.layout, at.q);
        let mut section = SectionLanes::new(pass);
        for s in 0..self.law.stations.len() {
            self.deform(pass, s, &q, &mut section);
            let [a, _, _, d, e, ..] = section.now;
            let cross = [d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]];
            // Lanes of other passes remain admissible.
            let mut det = Lanes([1.0; LANES]);
            pass.store(&mut det, dot(a, cross));
            admissible.iter_mut().zip(det.0).for_each(|(admissible, det)| *admissible &= det > 0.0);
        }
    }
}

impl<const N: usize, const A: usize, const B: usize, C: LaneNumber> BeamBatch<N, A, B, C> {
    /// Sets tangents. With the coordinates `from` the stresses are those that a linear system there predicts: without the part that is of
    /// second order in the increment.
    #[inline(always)]
    fn set_stiffness<S: Simd>(
        &self,
        pass: Pass<S>,
        at: &LocalLanes<'_>,
        from: Option<&[Lanes]>,
        w: Weights,
        k: &mut [Lanes],
    ) {
        let law = &*self.law;
        let mut blocks = VectorBlocks::<S, A, B>::zero(pass);
        // Viscosity adds τ D to the stiffness by v. The other terms are omitted, see `BeamStation::stiffness`.
        let squares = w.q + w.v * law.retardation;
        if w.q != 0.0 || (w.v != 0.0 && law.is_viscous()) {
            let (q, v) = (RelativeLanes::of(pass, &law.layout, at.q), self.moving(pass, at));
            let mut section = SectionLanes::new(pass);
            let change = from.map(|from| q.minus(&RelativeLanes::of(pass, &law.layout, from)));
            // The storage of the triangle contains H until the triangle is written.
            let (h, _) = k.as_chunks_mut();
            for (s, station) in law.stations.iter().enumerate() {
                let BatchStation { weight, mix, plan, elasticity, viscosity } = station;
                self.deform(pass, s, &q, &mut section);
                station.resultants(pass, v.as_ref(), law.retardation, weight * w.q, &mut section);
                if let Some(change) = &change {
                    station.subtract_second_order(pass, change, &mut section);
                }
                plan.stiffness(pass, elasticity, &mut section, weight * squares, h);
                blocks.add(pass, mix, h, plan.reach);
                if let Some(viscosity) = viscosity {
                    section.n.fill(pass.zero());
                    plan.stiffness(pass, viscosity, &mut section, weight * w.v, h);
                    blocks.add(pass, mix, h, plan.reach);
                }
            }
        }
        blocks.write::<N>(pass, &law.layout, k);
        let inertia = w.a + law.mass_damping * w.v;
        if inertia != 0.0 {
            let inertia = pass.splat(inertia);
            for (a, b, mass) in &law.mass {
                for axis in 0..3 {
                    let entry = &mut k[lower(3 * N, 3 * a + axis, 3 * b + axis)];
                    pass.store(entry, mass.lane(pass).mul_add(inertia, pass.load(entry)));
                }
            }
        }
    }

    /// Returns the velocities of the vectors if the elements have viscosity.
    #[inline(always)]
    fn moving<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> Option<RelativeLanes<S, A, B>> {
        if self.law.is_viscous() { Some(RelativeLanes::of(pass, &self.law.layout, at.v)) } else { None }
    }
}

impl<const A: usize, const B: usize, C: LaneNumber> BatchStation<A, B, C> {
    /// Subtracts the stress resultants of the strains that are of second order in an increment of the vectors.
    #[inline(always)]
    fn subtract_second_order<S: Simd>(
        &self,
        pass: Pass<S>,
        change: &RelativeLanes<S, A, B>,
        section: &mut SectionLanes<S>,
    ) {
        let SectionLanes { scratch: half, strains, n, .. } = section;
        let increment = self.mix.directors(pass, change, self.plan.reach);
        *half = increment;
        half.iter_mut().for_each(|half| *half = scaled(*half, pass.splat(0.5)));
        self.plan.strains(pass, [half, &increment], false, strains);
        let mut excess = [pass.zero(); STRAINS];
        self.plan.resultants(pass, &self.elasticity, strains, -self.weight, &mut excess);
        n.iter_mut().zip(excess).for_each(|(n, excess)| *n = *n + excess);
    }

    /// Computes the stress resultants of strains, and of their rates if velocities are given, times a factor.
    #[inline(always)]
    fn resultants<S: Simd>(
        &self,
        pass: Pass<S>,
        v: Option<&RelativeLanes<S, A, B>>,
        retardation: f64,
        factor: f64,
        section: &mut SectionLanes<S>,
    ) {
        let SectionLanes { now, middle, increment, scratch: rates, strains, n } = section;
        self.plan.strains(pass, [middle, increment], false, strains);
        let Some(v) = v else { return self.plan.resultants(pass, &self.elasticity, strains, factor, n) };
        *rates = self.mix.directors(pass, v, self.plan.reach);
        if let Some(viscosity) = &self.viscosity {
            self.plan.resultants(pass, &self.elasticity, strains, factor, n);
            self.plan.strains(pass, [now, rates], false, strains);
            let mut viscous = [pass.zero(); STRAINS];
            self.plan.resultants(pass, viscosity, strains, factor, &mut viscous);
            n.iter_mut().zip(viscous).for_each(|(n, viscous)| *n = *n + viscous);
            return;
        }
        rates.iter_mut().for_each(|rate| *rate = scaled(*rate, pass.splat(retardation)));
        self.plan.strains(pass, [now, rates], true, strains);
        self.plan.resultants(pass, &self.elasticity, strains, factor, n);
    }
}

impl<const N: usize, const A: usize, const B: usize, C: LaneNumber> BeamLaw<N, A, B, C> {
    /// Returns true if the elements have viscosity.
    #[inline(always)]
    fn is_viscous(&self) -> bool {
        self.retardation != 0.0 || self.stations[0].viscosity.is_some()
    }

    /// Returns g times a factor.
    #[inline(always)]
    fn gravity<S: Simd>(&self, pass: Pass<S>, factor: f64) -> VectorLanes<S> {
        let [x, y, z] = self.gravity;
        [pass.splat(x * factor), pass.splat(y * factor), pass.splat(z * factor)]
    }

    /// Computes M (a + α v) minus gravity.
    #[inline(always)]
    fn inertia<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> [VectorLanes<S>; N] {
        let (mut moved, mut rows) = ([pass.zeros(); N], [pass.zeros(); N]);
        let gravity = self.gravity(pass, -at.load);
        for a in 0..N {
            moved[a] = pass.vector(&at.a[3 * a..3 * a + 3]);
            rows[a] = scaled(gravity, self.first[a].lane(pass));
        }
        if self.mass_damping != 0.0 {
            for a in 0..N {
                moved[a] =
                    plus(moved[a], pass.vector(&at.v[3 * a..3 * a + 3]), pass.splat(self.mass_damping));
            }
        }
        for &(a, b, mass) in &self.mass {
            let mass: Lane<S> = mass.lane(pass);
            rows[a] = plus(rows[a], moved[b], mass);
            if a != b {
                rows[b] = plus(rows[b], moved[a], mass);
            }
        }
        rows
    }
}
