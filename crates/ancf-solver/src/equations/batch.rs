use std::ops::Range;
use std::sync::Arc;

use super::energy::{Energy, Power};
use super::scatter::Scatter;
use super::state::{State, Weights};
use super::term::Term;

/// The most terms that a batch evaluates side by side.
pub const LANES: usize = 8;

/// One number of each term of a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

/// The part of a state that a batch sees: [`Local`](super::term::Local) for each of its terms, side by side.
///
/// Lanes beyond the number of terms repeat the last one.
#[derive(Clone, Copy, Debug)]
pub struct LocalLanes<'a> {
    /// Coordinates.
    pub q: &'a [Lanes],
    /// Velocities.
    pub v: &'a [Lanes],
    /// Accelerations.
    pub a: &'a [Lanes],
    /// Load factor: a load acts so many times.
    pub load: f64,
}

/// Up to [`LANES`] terms of the same kind and size, without multipliers, that are evaluated at once: the arithmetic of each is
/// done in a lane of the machine's vectors.
///
/// What it computes is what its terms compute one by one, but for rounding: they are its definition, and stay for whatever is
/// not asked for at every iteration.
pub trait Batch: Send + Sync {
    /// Number of its terms.
    fn count(&self) -> usize;

    /// Adds their shares of the residual, a row for each coordinate.
    fn residual(&self, at: &LocalLanes<'_>, r: &mut [Lanes]);

    /// Sets their shares of the tangent, the lower triangle by columns: entry (i, j), i ≥ j, of n coordinates is at
    /// j n − j (j + 1)/2 + i.
    fn tangent(&self, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]);

    /// The sum of their energies.
    fn energy(&self, at: &LocalLanes<'_>) -> Energy;

    /// The first of them that cannot be in this state ([`Term::is_admissible`](super::term::Term::is_admissible)).
    fn inadmissible(&self, at: &LocalLanes<'_>) -> Option<usize>;

    /// The sum of their powers ([`Term::power`](super::term::Term::power)).
    fn power(&self, at: &LocalLanes<'_>) -> Power;
}

/// The most coordinates of a term of a batch.
const WIDTH: usize = 32;

/// A batch among the terms of a system.
pub(crate) struct Batched {
    /// The number of its first term.
    pub(crate) first: usize,
    pub(crate) batch: Box<dyn Batch>,
    /// Coordinate i of term l at i × LANES + l.
    coordinates: Vec<u32>,
}

impl Batched {
    /// A batch of the `terms` from the `first` one on.
    ///
    /// # Panics
    /// If these are not alike, or too many or too large: a mistake in code, not in input.
    pub(crate) fn new(first: usize, batch: Box<dyn Batch>, terms: &[Arc<dyn Term>]) -> Self {
        let own = &terms[first..first + batch.count()];
        let width = own[0].coordinates().len();
        assert!(
            own.len() <= LANES && width <= WIDTH,
            "a batch is of at most {LANES} terms of {WIDTH} coordinates"
        );
        let alike = |term: &Arc<dyn Term>| term.coordinates().len() == width && term.multipliers().is_empty();
        assert!(own.iter().all(alike), "terms of a batch have as many coordinates and no multipliers");
        let of = |i: usize| (0..LANES).map(move |l| own[l.min(own.len() - 1)].coordinates()[i] as u32);
        Self { first, coordinates: (0..width).flat_map(of).collect(), batch }
    }

    /// The numbers of its terms.
    pub(crate) fn terms(&self) -> Range<usize> {
        self.first..self.first + self.batch.count()
    }

    /// The range of its coordinates.
    pub(crate) fn range(&self) -> Range<usize> {
        let (least, most) = self.coordinates.iter().fold((u32::MAX, 0), |(a, b), &c| (a.min(c), b.max(c)));
        least as usize..most as usize + 1
    }

    /// Gathers from a vector.
    fn gather(&self, from: &[f64], to: &mut [Lanes]) {
        for (to, coordinates) in to.iter_mut().zip(self.coordinates.as_chunks::<LANES>().0) {
            to.0 = std::array::from_fn(|l| from[coordinates[l] as usize]);
        }
    }

    /// Adds rows to a vector that begins at a coordinate.
    fn add(&self, rows: &[Lanes], sum: &mut [f64], first: usize) {
        for (row, coordinates) in rows.iter().zip(self.coordinates.chunks_exact(LANES)) {
            for (value, &c) in row.0.iter().zip(coordinates).take(self.batch.count()) {
                sum[c as usize - first] += value;
            }
        }
    }
}

/// The unknowns of a batch, gathered from a state.
pub(crate) struct GatheredLanes {
    q: [Lanes; WIDTH],
    v: [Lanes; WIDTH],
    a: [Lanes; WIDTH],
}

impl GatheredLanes {
    const NONE: [Lanes; WIDTH] = [Lanes([0.0; LANES]); WIDTH];
    pub(crate) const EMPTY: Self = Self { q: Self::NONE, v: Self::NONE, a: Self::NONE };

    /// Coordinates and velocities; accelerations are left as they are, since only residuals depend on them.
    pub(crate) fn gather<'a>(&'a mut self, s: &State, of: &Batched) -> LocalLanes<'a> {
        let Self { q, v, a } = self;
        let width = of.coordinates.len() / LANES;
        of.gather(&s.q, q);
        of.gather(&s.v, v);
        LocalLanes { q: &q[..width], v: &v[..width], a: &a[..width], load: s.load }
    }

    /// Adds the residual of a batch to that of all, from a coordinate on.
    pub(crate) fn add_residual(&mut self, s: &State, of: &Batched, sum: &mut [f64], first: usize) {
        let mut rows = Self::NONE;
        of.gather(&s.a, &mut self.a);
        let at = self.gather(s, of);
        let rows = &mut rows[..at.q.len()];
        of.batch.residual(&at, rows);
        of.add(rows, sum, first);
    }
}

/// The lower triangles of a batch.
pub(crate) struct LowerLanes([Lanes; WIDTH * (WIDTH + 1) / 2]);

impl LowerLanes {
    pub(crate) const ZERO: Self = Self([Lanes([0.0; LANES]); WIDTH * (WIDTH + 1) / 2]);

    /// Adds the tangents of a batch at gathered unknowns to the values of a matrix, from one on.
    pub(crate) fn add_tangent(
        &mut self,
        of: &Batched,
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
