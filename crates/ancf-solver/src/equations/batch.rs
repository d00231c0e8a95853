use std::cell::Cell;
use std::ops::Range;
use std::sync::Arc;

use super::scatter::Scatter;
use super::term_sums::unknowns;
use super::terms::{Energy, Level, Power, State, Term, Weights};
use super::thread_parts::enclosing_range;
use crate::sparse::Pattern;

/// Maximum number of terms that a batch evaluates side by side.
pub const LANES: usize = 8;

/// One number for each term of a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

/// State variables of the terms of a batch, side by side: one [`Local`](super::terms::Local) per lane.
///
/// Lanes beyond the number of terms repeat the last term.
#[derive(Clone, Copy, Debug)]
pub struct LocalLanes<'a> {
    /// Coordinates.
    pub q: &'a [Lanes],
    /// Velocities.
    pub v: &'a [Lanes],
    /// Accelerations.
    pub a: &'a [Lanes],
    /// Multipliers.
    pub lambda: &'a [Lanes],
    /// Load factor s, which multiplies all loads.
    pub load: f64,
}

/// Group of up to [`LANES`] terms of the same kind and size, evaluated by SIMD lanes.
///
/// A batch computes the same sums as its terms, except for rounding. The terms remain the definition. They also serve
/// the quantities that are not evaluated at every iteration.
pub trait Batch: Send + Sync {
    /// Returns the number of terms.
    fn count(&self) -> usize;

    /// Adds the residuals of the terms: rows of the coordinates, then of the multipliers.
    fn residual(&self, at: &LocalLanes<'_>, r: &mut [Lanes]);

    /// Returns the entries (i, j), i ≥ j, of the tangents that can differ from zero; `None` for dense tangents.
    fn entries(&self) -> Option<&[[u8; 2]]> {
        None
    }

    /// Sets the tangents of the terms: their [`entries`](Self::entries), or the lower triangle by columns.
    ///
    /// Entry (i, j), i ≥ j, of a lower triangle of n rows has the index j n − j (j + 1)/2 + i.
    fn tangent(&self, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]);

    /// Sets the stiffness of the terms with the stresses that a linear system at the coordinates `from` predicts, as
    /// [`tangent`](Self::tangent) with [`Term::stress_prediction`]. By default the terms have none.
    fn predicted_stiffness(&self, at: &LocalLanes<'_>, _from: &[Lanes], k: &mut [Lanes]) {
        self.tangent(at, Weights::STIFFNESS, k);
    }

    /// Adds the constraints of the terms at a level, one row for each multiplier
    /// ([`Term::constraints`](super::terms::Term::constraints)).
    fn constraints(&self, _at: &LocalLanes<'_>, _level: Level, _phi: &mut [Lanes]) {}

    /// Returns the sum of the energies of the terms.
    fn energy(&self, at: &LocalLanes<'_>) -> Energy;

    /// Returns the first term that does not admit this state
    /// ([`Term::inadmissibility`](super::terms::Term::inadmissibility)).
    fn inadmissible(&self, at: &LocalLanes<'_>) -> Option<usize>;

    /// True if the terms are constraints only: without inertia, energy and inadmissible states, and with forces that depend on
    /// coordinates and multipliers only. Velocities and accelerations of `at` are then undefined, except for constraints.
    fn is_constraint(&self) -> bool {
        false
    }

    /// True if the terms have damping forces.
    fn is_damped(&self) -> bool;

    /// Adds the damping forces of the terms ([`Term::damping_forces`](super::terms::Term::damping_forces)).
    fn damping_forces(&self, at: &LocalLanes<'_>, r: &mut [Lanes]);

    /// Returns the sum of the powers of the terms. Terms of batches supply none.
    fn power(&self, at: &LocalLanes<'_>) -> Power {
        let mut forces = [Lanes::default(); MAX_UNKNOWNS];
        self.damping_forces(at, &mut forces[..at.q.len()]);
        let of = |lane: usize| at.v.iter().zip(&forces).map(|(v, f)| v.0[lane] * f.0[lane]).sum::<f64>();
        Power { work: 0.0, dissipation: (0..self.count()).map(of).sum() }
    }
}

/// Maximum number of coordinates and multipliers of a term in a batch.
pub const MAX_UNKNOWNS: usize = 32;

/// Batch together with the positions of its terms in a system.
pub(crate) struct PlacedBatch {
    /// Indices of its terms.
    pub(crate) terms: Vec<usize>,
    pub(crate) batch: Box<dyn Batch>,
    /// Number of coordinates of a term.
    width: usize,
    /// Global unknowns, multipliers numbered after all coordinates: local unknown i of term l is stored at i × LANES + l.
    unknowns: Vec<u32>,
}

impl PlacedBatch {
    /// Creates a batch of the terms with the given indices.
    ///
    /// # Panics
    /// If the terms differ in size, or are too many or too large. This is a programming error, not an input error.
    pub(crate) fn new(
        indices: Vec<usize>,
        batch: Box<dyn Batch>,
        terms: &[Arc<dyn Term>],
        coordinates: usize,
    ) -> Self {
        let of = |&index: &usize| unknowns(&*terms[index], coordinates).collect::<Vec<u32>>();
        let own: Vec<Vec<u32>> = indices.iter().map(of).collect();
        let (width, size) = (terms[indices[0]].coordinates().len(), own[0].len());
        assert!(
            own.len() == batch.count() && own.len() <= LANES && size <= MAX_UNKNOWNS,
            "a batch has at most {LANES} terms with {MAX_UNKNOWNS} unknowns"
        );
        let is_alike = |index: &usize| terms[*index].coordinates().len() == width;
        assert!(
            indices.iter().all(is_alike) && own.iter().all(|own| own.len() == size),
            "terms of a batch have equal numbers of coordinates and multipliers"
        );
        let of = |i: usize| (0..LANES).map(move |l| (i, l)).collect::<Vec<_>>();
        let unknowns = (0..size).flat_map(of).map(|(i, l)| own[l.min(own.len() - 1)][i]).collect();
        Self { terms: indices, batch, width, unknowns }
    }

    /// Returns the range of the unknowns.
    pub(crate) fn range(&self) -> Range<usize> {
        let (least, most) = self.unknowns.iter().fold((u32::MAX, 0), |(a, b), &c| (a.min(c), b.max(c)));
        least as usize..most as usize + 1
    }

    /// Returns true if the terms have multipliers.
    pub(crate) fn has_multipliers(&self) -> bool {
        self.size() > self.width
    }

    /// Returns the number of unknowns of a term.
    fn size(&self) -> usize {
        self.unknowns.len() / LANES
    }

    /// Gathers entries of a global vector that starts at unknown `first`, from local unknown `from` on.
    fn gather(&self, from: usize, values: &[f64], first: usize, to: &mut [Lanes]) {
        for (to, unknowns) in to.iter_mut().zip(&self.unknowns.as_chunks::<LANES>().0[from..]) {
            to.0 = std::array::from_fn(|l| values[unknowns[l] as usize - first]);
        }
    }

    /// Adds local rows, from local unknown `from` on, to a section of a global vector that starts at unknown `first`.
    fn add(&self, from: usize, rows: &[Lanes], sum: &mut [f64], first: usize) {
        for (row, unknowns) in rows.iter().zip(&self.unknowns.as_chunks::<LANES>().0[from..]) {
            for (value, &unknown) in row.0.iter().zip(unknowns).take(self.batch.count()) {
                sum[unknown as usize - first] += value;
            }
        }
    }
}

/// Places of the tangents of a batch among the values of a matrix.
pub(crate) enum TangentPlaces {
    /// Lower triangles, by the scatter maps of the terms.
    Dense,
    /// Entries: entry e of term l has the place at e × count + l.
    Sparse(Vec<usize>),
}

impl TangentPlaces {
    pub(crate) fn new(of: &PlacedBatch, pattern: &Pattern) -> Self {
        let Some(entries) = of.batch.entries() else { return Self::Dense };
        let unknown = |i: u8, l: usize| of.unknowns[usize::from(i) * LANES + l] as usize;
        let place = |&[i, j]: &[u8; 2]| {
            (0..of.batch.count()).map(move |l| pattern.slot(unknown(i, l), unknown(j, l)))
        };
        Self::Sparse(entries.iter().flat_map(place).collect())
    }

    /// Returns the range of matrix values that receive entries.
    pub(crate) fn range(&self, of: &PlacedBatch, scatters: &[Scatter]) -> Range<usize> {
        match self {
            Self::Dense => enclosing_range(of.terms.iter().map(|&term| scatters[term].range())),
            Self::Sparse(places) => enclosing_range(places.iter().map(|&place| place..place + 1)),
        }
    }
}

/// State variables of a batch, gathered from a global state.
pub(crate) struct GatheredLanes {
    q: [Lanes; MAX_UNKNOWNS],
    v: [Lanes; MAX_UNKNOWNS],
    a: [Lanes; MAX_UNKNOWNS],
    lambda: [Lanes; MAX_UNKNOWNS],
    /// Rows of the batch.
    rows: [Lanes; MAX_UNKNOWNS],
}

impl GatheredLanes {
    const NONE: [Lanes; MAX_UNKNOWNS] = [Lanes([0.0; LANES]); MAX_UNKNOWNS];
    const EMPTY: Self =
        Self { q: Self::NONE, v: Self::NONE, a: Self::NONE, lambda: Self::NONE, rows: Self::NONE };

    /// Gathers a state and the coordinates of another one, which are stored as accelerations.
    pub(crate) fn gather_pair<'a>(
        &'a mut self,
        [s, other]: [&State; 2],
        of: &PlacedBatch,
    ) -> (LocalLanes<'a>, &'a [Lanes]) {
        self.fill(s, of);
        of.gather(0, &other.q, 0, &mut self.a[..of.width]);
        let (at, _) = self.local(s, of);
        (at, at.a)
    }

    /// Gathers coordinates, velocities and multipliers. Accelerations are left unchanged, since only residuals depend on them, and
    /// velocities of constraints.
    pub(crate) fn gather<'a>(&'a mut self, s: &State, of: &PlacedBatch) -> LocalLanes<'a> {
        self.fill(s, of);
        self.local(s, of).0
    }

    fn fill(&mut self, s: &State, of: &PlacedBatch) {
        let (n, m) = (of.width, of.size() - of.width);
        of.gather(0, &s.q, 0, &mut self.q[..n]);
        if !of.batch.is_constraint() {
            of.gather(0, &s.v, 0, &mut self.v[..n]);
        }
        of.gather(n, &s.lambda, s.q.len(), &mut self.lambda[..m]);
    }

    /// Gathered variables of a batch, and its rows.
    fn local<'a>(&'a mut self, s: &State, of: &PlacedBatch) -> (LocalLanes<'a>, &'a mut [Lanes]) {
        let Self { q, v, a, lambda, rows } = self;
        let (n, size) = (of.width, of.size());
        let at = LocalLanes { q: &q[..n], v: &v[..n], a: &a[..n], lambda: &lambda[..size - n], load: s.load };
        (at, &mut rows[..size])
    }

    /// Adds the residual of a batch to a section of the global residual that starts at unknown `first`.
    pub(crate) fn add_residual(&mut self, s: &State, of: &PlacedBatch, sum: &mut [f64], first: usize) {
        if !of.batch.is_constraint() {
            of.gather(0, &s.a, 0, &mut self.a[..of.width]);
        }
        self.fill(s, of);
        let (at, rows) = self.local(s, of);
        rows.fill(Lanes::default());
        of.batch.residual(&at, rows);
        of.add(0, rows, sum, first);
    }

    /// Adds the constraints of a batch at a level, by multiplier.
    pub(crate) fn add_constraints(&mut self, s: &State, of: &PlacedBatch, level: Level, phi: &mut [f64]) {
        self.fill(s, of);
        of.gather(0, &s.v, 0, &mut self.v[..of.width]);
        let (at, rows) = self.local(s, of);
        let rows = &mut rows[..at.lambda.len()];
        rows.fill(Lanes::default());
        of.batch.constraints(&at, level, rows);
        of.add(of.width, rows, phi, s.q.len());
    }

    /// Adds the damping forces of a batch to a section of a global vector that starts at coordinate `first`.
    pub(crate) fn add_damping(&mut self, s: &State, of: &PlacedBatch, sum: &mut [f64], first: usize) {
        self.fill(s, of);
        let (at, rows) = self.local(s, of);
        let rows = &mut rows[..at.q.len()];
        rows.fill(Lanes::default());
        of.batch.damping_forces(&at, rows);
        of.add(0, rows, sum, first);
    }
}

/// Entries of the tangents of a batch.
pub(crate) struct TangentLanes([Lanes; MAX_UNKNOWNS * (MAX_UNKNOWNS + 1) / 2]);

impl TangentLanes {
    const ZERO: Self = Self([Lanes([0.0; LANES]); MAX_UNKNOWNS * (MAX_UNKNOWNS + 1) / 2]);

    /// Adds the tangents of a batch, which `evaluate` sets, to a section of the matrix values.
    pub(crate) fn add_tangent(
        &mut self,
        (of, places): (&PlacedBatch, &TangentPlaces),
        evaluate: impl FnOnce(&dyn Batch, &mut [Lanes]),
        scatters: &[Scatter],
        (values, first): (&mut [f64], usize),
    ) {
        match places {
            TangentPlaces::Dense => {
                let lower = &mut self.0[..of.size() * (of.size() + 1) / 2];
                evaluate(&*of.batch, lower);
                for (lane, &term) in of.terms.iter().enumerate() {
                    scatters[term].add(values, first, |k| lower[k].0[lane]);
                }
            }
            TangentPlaces::Sparse(places) => {
                let count = of.batch.count();
                let entries = &mut self.0[..places.len() / count];
                evaluate(&*of.batch, entries);
                for (entry, places) in entries.iter().zip(places.chunks_exact(count)) {
                    places.iter().zip(&entry.0).for_each(|(&place, x)| values[place - first] += x);
                }
            }
        }
    }
}

/// Working storage of a thread for the evaluation of batches.
pub(crate) struct LaneStorage {
    pub(crate) lanes: GatheredLanes,
    pub(crate) entries: TangentLanes,
}

thread_local! {
    static STORAGE: Cell<Option<Box<LaneStorage>>> = const { Cell::new(None) };
}

impl LaneStorage {
    /// Calls a function with the storage of this thread. It is allocated once: its initialisation costs as much as a batch.
    pub(crate) fn with<T>(evaluate: impl FnOnce(&mut Self) -> T) -> T {
        let new = || Box::new(Self { lanes: GatheredLanes::EMPTY, entries: TangentLanes::ZERO });
        let mut storage = STORAGE.take().unwrap_or_else(new);
        let value = evaluate(&mut storage);
        STORAGE.set(Some(storage));
        value
    }
}
