use ancf_solver::equations::{Batch, LANES, Lanes, Level, LocalLanes, Weights};
use pulp::Simd;

use super::bilinear_lanes::{BilinearLanes, add};
use super::entry_list::EntryList;
use crate::batch::{BatchKernel, BatchTerm, KernelBatch, TermBatch, alike};
use crate::elements::RigidTerm;
use crate::lanes::{Lane, LaneNumber, Pass, VectorLanes, dot, plus, scaled};

/// Batch of rigid bodies or of point masses.
#[derive(Debug)]
struct RigidBatch {
    count: usize,
    /// Number of vectors of a body.
    vectors: usize,
    /// Masses of pairs (a, b), a ≥ b, of vectors, with the numbers of their three entries.
    masses: Vec<PairMass>,
    weight: [Lanes; 3],
    rigidity: BilinearLanes,
    entries: Vec<[u8; 2]>,
}

#[derive(Debug)]
struct PairMass {
    pair: [usize; 2],
    mass: Lanes,
    entries: [usize; 3],
}

impl BatchTerm for RigidTerm {
    fn batches(bodies: &[&Self]) -> Vec<TermBatch> {
        let batch = |bodies: &[&Self]| -> Box<dyn Batch> { Box::new(KernelBatch(RigidBatch::new(bodies))) };
        alike(bodies, |body| Some(body.vectors()), batch)
    }
}

impl RigidBatch {
    fn new(bodies: &[&RigidTerm]) -> Self {
        let of = |number: &dyn Fn(&RigidTerm) -> f64| {
            Lanes::of(&bodies.iter().map(|body| number(body)).collect::<Vec<_>>())
        };
        let (vectors, mut entries) = (bodies[0].vectors(), EntryList::default());
        let pairs = (0..vectors).flat_map(|a| (0..=a).map(move |b| [a, b]));
        let pairs = pairs.filter(|&[a, b]| bodies.iter().any(|body| body.mass(a, b) != 0.0));
        let masses = pairs.map(|pair @ [a, b]| PairMass {
            pair,
            mass: of(&|body| body.mass(a, b)),
            entries: entries.diagonal(3 * a, 3 * b),
        });
        let masses = masses.collect();
        let rows: Vec<_> = bodies.iter().map(|body| body.rows()).collect();
        let rigidity = BilinearLanes::new(3 * vectors, &rows, &mut entries);
        let weight = [0, 1, 2].map(|axis| of(&|body| body.weight()[axis]));
        Self { count: bodies.len(), vectors, masses, weight, rigidity, entries: entries.list }
    }

    /// Returns a vector of coordinates.
    #[inline(always)]
    fn vector<S: Simd>(pass: Pass<S>, x: &[Lanes], vector: usize) -> VectorLanes<S> {
        pass.vector(&x[3 * vector..3 * vector + 3])
    }

    /// Returns the director i = 1, 2, 3.
    #[inline(always)]
    fn director<S: Simd>(pass: Pass<S>, q: &[Lanes], i: usize) -> VectorLanes<S> {
        let mut director = Self::vector(pass, q, i);
        director[i - 1] = director[i - 1] + pass.splat(1.0);
        director
    }
}

impl BatchKernel for RigidBatch {
    fn count(&self) -> usize {
        self.count
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn entries(&self) -> Option<&[[u8; 2]]> {
        Some(&self.entries)
    }

    #[inline(always)]
    fn add_residual<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        let mut rows = [pass.zeros(); 4];
        rows[0] = scaled(pass.vector(&self.weight), pass.splat(-at.load));
        for PairMass { pair: [a, b], mass, .. } in &self.masses {
            let mass = pass.load(mass);
            rows[*a] = plus(rows[*a], Self::vector(pass, at.a, *b), mass);
            if a != b {
                rows[*b] = plus(rows[*b], Self::vector(pass, at.a, *a), mass);
            }
        }
        for (row, x) in r[..3 * self.vectors].iter_mut().zip(rows.as_flattened()) {
            add(pass, row, *x);
        }
        self.rigidity.add_residual(pass, at, r);
    }

    #[inline(always)]
    fn set_tangent<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]) {
        for entry in &mut *k {
            pass.store(entry, pass.zero());
        }
        for PairMass { mass, entries, .. } in &self.masses {
            let value = pass.load(mass) * pass.splat(w.a);
            for &entry in entries {
                pass.store(&mut k[entry], value);
            }
        }
        self.rigidity.add_tangent(pass, at, w.q, k);
    }

    #[inline(always)]
    fn add_constraints<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, level: Level, phi: &mut [Lanes]) {
        self.rigidity.add_constraints(pass, at, level, phi);
    }

    #[inline(always)]
    fn energies<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> [Lane<S>; 3] {
        let mut kinetic = pass.zero();
        for PairMass { pair: [a, b], mass, .. } in &self.masses {
            let weight = pass.splat(if a == b { 0.5 } else { 1.0 }) * pass.load(mass);
            let square = dot(Self::vector(pass, at.v, *a), Self::vector(pass, at.v, *b));
            kinetic = square.mul_add(weight, kinetic);
        }
        let work = dot(pass.vector(&self.weight), Self::vector(pass, at.q, 0));
        [kinetic, pass.zero(), work * pass.splat(-at.load)]
    }

    /// See [`RigidTerm`]: d₁·(d₂ × d₃) is positive.
    #[inline(always)]
    fn check_admissible<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, admissible: &mut [bool; LANES]) {
        if self.vectors < 4 {
            return;
        }
        let (x, y) = (Self::director(pass, at.q, 1), Self::director(pass, at.q, 2));
        let z = Self::director(pass, at.q, 3);
        let mut normal = pass.zeros();
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            normal[i] = y[j].mul_add(z[k], -(y[k] * z[j]));
        }
        let mut volume = Lanes([1.0; LANES]);
        pass.store(&mut volume, dot(x, normal));
        admissible.iter_mut().zip(volume.0).for_each(|(admissible, volume)| *admissible &= volume > 0.0);
    }
}
