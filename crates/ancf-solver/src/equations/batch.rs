use std::ops::Range;
use std::sync::Arc;

use super::scatter::Scatter;
use super::terms::{Energy, Power, State, Term, Weights};

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
    /// Load factor s, which multiplies all loads.
    pub load: f64,
}

/// Group of up to [`LANES`] terms of the same kind and size, without multipliers, evaluated by SIMD lanes.
///
/// A batch computes the same sums as its terms, except for rounding. The terms remain the definition. They also serve
/// the quantities that are not evaluated at every iteration.
pub trait Batch: Send + Sync {
    /// Returns the number of terms.
    fn count(&self) -> usize;

    /// Adds the residuals of the terms, one row for each coordinate.
    fn residual(&self, at: &LocalLanes<'_>, r: &mut [Lanes]);

    /// Sets the tangents of the terms, stored as the lower triangle by columns.
    ///
    /// Entry (i, j), i ≥ j, of n coordinates has the index j n − j (j + 1)/2 + i.
    fn tangent(&self, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]);

    /// Returns the sum of the energies of the terms.
    fn energy(&self, at: &LocalLanes<'_>) -> Energy;

    /// Returns the first term that does not admit this state
    /// ([`Term::inadmissibility`](super::terms::Term::inadmissibility)).
    fn inadmissible(&self, at: &LocalLanes<'_>) -> Option<usize>;

    /// True if the terms have damping forces.
    fn is_damped(&self) -> bool;

    /// Adds the damping forces of the terms ([`Term::damping_forces`](super::terms::Term::damping_forces)).
    fn damping_forces(&self, at: &LocalLanes<'_>, r: &mut [Lanes]);

    /// Returns the sum of the powers of the terms. Terms of batches supply none.
    fn power(&self, at: &LocalLanes<'_>) -> Power {
        let mut forces = [Lanes::default(); MAX_COORDINATES];
        self.damping_forces(at, &mut forces[..at.q.len()]);
        let of = |lane: usize| at.v.iter().zip(&forces).map(|(v, f)| v.0[lane] * f.0[lane]).sum::<f64>();
        Power { work: 0.0, dissipation: (0..self.count()).map(of).sum() }
    }
}

/// Maximum number of coordinates of a term in a batch.
const MAX_COORDINATES: usize = 32;

/// Batch together with the position of its terms in a system.
pub(crate) struct PlacedBatch {
    /// Index of its first term.
    pub(crate) first: usize,
    pub(crate) batch: Box<dyn Batch>,
    /// Global coordinates: local coordinate i of term l is stored at i × LANES + l.
    coordinates: Vec<u32>,
}

impl PlacedBatch {
    /// Creates a batch of consecutive `terms`, starting at index `first`.
    ///
    /// # Panics
    /// If the terms differ in size, or are too many or too large. This is a programming error, not an input error.
    pub(crate) fn new(first: usize, batch: Box<dyn Batch>, terms: &[Arc<dyn Term>]) -> Self {
        let own = &terms[first..first + batch.count()];
        let width = own[0].coordinates().len();
        assert!(
            own.len() <= LANES && width <= MAX_COORDINATES,
            "a batch has at most {LANES} terms with {MAX_COORDINATES} coordinates"
        );
        let alike = |term: &Arc<dyn Term>| term.coordinates().len() == width && term.multipliers().is_empty();
        assert!(
            own.iter().all(alike),
            "terms of a batch have equal numbers of coordinates and no multipliers"
        );
        let of = |i: usize| (0..LANES).map(move |l| own[l.min(own.len() - 1)].coordinates()[i] as u32);
        Self { first, coordinates: (0..width).flat_map(of).collect(), batch }
    }

    /// Returns the indices of the terms.
    pub(crate) fn terms(&self) -> Range<usize> {
        self.first..self.first + self.batch.count()
    }

    /// Returns the range of the coordinates.
    pub(crate) fn range(&self) -> Range<usize> {
        let (least, most) = self.coordinates.iter().fold((u32::MAX, 0), |(a, b), &c| (a.min(c), b.max(c)));
        least as usize..most as usize + 1
    }

    /// Gathers entries of a global vector.
    fn gather(&self, from: &[f64], to: &mut [Lanes]) {
        for (to, coordinates) in to.iter_mut().zip(self.coordinates.as_chunks::<LANES>().0) {
            to.0 = std::array::from_fn(|l| from[coordinates[l] as usize]);
        }
    }

    /// Adds local rows to a section of a global vector that starts at coordinate `first`.
    fn add(&self, rows: &[Lanes], sum: &mut [f64], first: usize) {
        for (row, coordinates) in rows.iter().zip(self.coordinates.chunks_exact(LANES)) {
            for (value, &c) in row.0.iter().zip(coordinates).take(self.batch.count()) {
                sum[c as usize - first] += value;
            }
        }
    }
}

/// State variables of a batch, gathered from a global state.
pub(crate) struct GatheredLanes {
    q: [Lanes; MAX_COORDINATES],
    v: [Lanes; MAX_COORDINATES],
    a: [Lanes; MAX_COORDINATES],
}

impl GatheredLanes {
    const NONE: [Lanes; MAX_COORDINATES] = [Lanes([0.0; LANES]); MAX_COORDINATES];
    pub(crate) const EMPTY: Self = Self { q: Self::NONE, v: Self::NONE, a: Self::NONE };

    /// Gathers coordinates and velocities. Accelerations are left unchanged, since only residuals depend on them.
    pub(crate) fn gather<'a>(&'a mut self, s: &State, of: &PlacedBatch) -> LocalLanes<'a> {
        let Self { q, v, a } = self;
        let width = of.coordinates.len() / LANES;
        of.gather(&s.q, q);
        of.gather(&s.v, v);
        LocalLanes { q: &q[..width], v: &v[..width], a: &a[..width], load: s.load }
    }

    /// Adds the residual of a batch to a section of the global residual that starts at coordinate `first`.
    pub(crate) fn add_residual(&mut self, s: &State, of: &PlacedBatch, sum: &mut [f64], first: usize) {
        let mut rows = Self::NONE;
        of.gather(&s.a, &mut self.a);
        let at = self.gather(s, of);
        let rows = &mut rows[..at.q.len()];
        of.batch.residual(&at, rows);
        of.add(rows, sum, first);
    }

    /// Adds the damping forces of a batch to a section of a global vector that starts at coordinate `first`.
    pub(crate) fn add_damping(mut self, s: &State, of: &PlacedBatch, sum: &mut [f64], first: usize) {
        let mut rows = Self::NONE;
        let at = self.gather(s, of);
        let rows = &mut rows[..at.q.len()];
        of.batch.damping_forces(&at, rows);
        of.add(rows, sum, first);
    }
}

/// Lower triangles of the tangents of a batch.
pub(crate) struct LowerLanes([Lanes; MAX_COORDINATES * (MAX_COORDINATES + 1) / 2]);

impl LowerLanes {
    pub(crate) const ZERO: Self = Self([Lanes([0.0; LANES]); MAX_COORDINATES * (MAX_COORDINATES + 1) / 2]);

    /// Adds the tangents of a batch to a section of the matrix values.
    pub(crate) fn add_tangent(
        &mut self,
        of: &PlacedBatch,
        at: &LocalLanes<'_>,
        w: Weights,
        scatters: &[Scatter],
        (values, first): (&mut [f64], usize),
    ) {
        let width = at.q.len();
        let lower = &mut self.0[..width * (width + 1) / 2];
        of.batch.tangent(at, w, lower);
        for (lane, scatter) in scatters[of.terms()].iter().enumerate() {
            scatter.add(values, first, |k| lower[k].0[lane]);
        }
    }
}
