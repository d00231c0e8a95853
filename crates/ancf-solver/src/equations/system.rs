use std::fmt;
use std::ops::AddAssign;
use std::sync::Arc;

use super::batch::{Batch, GatheredLanes, LaneStorage, LocalLanes, PlacedBatch, TangentLanes, TangentPlaces};
use super::constraint_rows::scaled_constraint_rows;
use super::contact_pairs::{ActiveContacts, ActiveGroup, ContactSearch};
use super::motion_equations::EquationsOfMotion;
use super::scatter::{Scatter, pattern_of, scatters};
use super::term_sums::{LocalState, USUAL};
use super::terms::{LOCAL, Local, LocalMatrix, State, Term, Weights};
use super::thread_parts::ThreadParts;
use crate::sparse::{ConstraintRow, FactorStorage, Pattern, SparseMatrix};
use crate::vectors::for_each_chunk;

/// Equations of motion as a sum of terms: gather, evaluate, scatter.
///
/// Clones share terms and pattern.
#[derive(Clone)]
pub struct System {
    pub(super) coordinates: usize,
    pub(super) multipliers: usize,
    pub(super) terms: Vec<Arc<dyn Term>>,
    /// Number of terms without contacts, which are the last ones.
    pub(super) lasting: usize,
    pub(super) contacts: ActiveContacts,
    /// Indices of the terms with multipliers, and the rows that determine the order of elimination.
    pub(super) constraints: Vec<usize>,
    rows: Arc<[ConstraintRow]>,
    pub(super) pattern: Arc<Pattern>,
    /// Coordinates that are angles with counted turns.
    pub(super) angles: Vec<usize>,
    /// Scatter map of each term.
    pub(super) scatters: Vec<Scatter>,
    /// Batches with the places of their tangents in the matrix.
    pub(super) batches: Arc<[PlacedBatch]>,
    pub(super) places: Arc<[TangentPlaces]>,
    /// Indices of the terms that are evaluated one by one, and of those with multipliers among them.
    pub(super) unbatched: Vec<usize>,
    pub(super) unbatched_constraints: Vec<usize>,
    /// Batches by residual rows and by matrix entries.
    pub(super) by_rows: ThreadParts,
    pub(super) by_entries: ThreadParts,
    /// Residual of a state that is subtracted.
    pub(super) released: Option<Release>,
}

/// Residual of a state that is subtracted in proportion to 1 − s/s₁, with the load factor s, and in some rows entirely.
#[derive(Clone, Debug)]
pub(super) struct Release {
    residual: Arc<[f64]>,
    /// Last load factor s₁.
    last: f64,
    kept: Arc<[usize]>,
}

impl Release {
    /// Subtracts the residual at a load factor from the rows from `first` on.
    pub(super) fn subtract(&self, load: f64, first: usize, r: &mut [f64]) {
        let part = 1.0 - load / self.last;
        r.iter_mut().zip(&self.residual[first..]).for_each(|(r, at_start)| *r -= part * at_start);
        let kept = self.kept.iter().filter(|row| **row >= first);
        kept.for_each(|&row| r[row - first] -= (1.0 - part) * self.residual[row]);
    }
}

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sizes = [self.coordinates, self.multipliers, self.terms.len()];
        f.debug_struct("System").field("sizes", &sizes).finish_non_exhaustive()
    }
}

impl System {
    /// Creates the sum of `terms` over the given numbers of coordinates and multipliers.
    ///
    /// # Panics
    /// If a term has more than [`LOCAL`] unknowns or an unknown out of range. This is a programming error, not an input
    /// error.
    pub fn new(coordinates: usize, multipliers: usize, terms: Vec<Box<dyn Term>>) -> Self {
        let terms: Vec<Arc<dyn Term>> = terms.into_iter().map(Arc::from).collect();
        let rows: Arc<[ConstraintRow]> = scaled_constraint_rows(&terms, coordinates, multipliers).into();
        let pattern = Arc::new(pattern_of(coordinates, &rows, terms.iter()));
        Self {
            coordinates,
            multipliers,
            lasting: terms.len(),
            contacts: ActiveContacts::default(),
            constraints: (0..terms.len()).filter(|&i| !terms[i].multipliers().is_empty()).collect(),
            angles: terms.iter().filter_map(|term| term.counted_angle()).collect(),
            scatters: scatters(&pattern, coordinates, &terms),
            unbatched: Vec::new(),
            unbatched_constraints: Vec::new(),
            terms,
            rows,
            pattern,
            batches: Arc::default(),
            places: Arc::default(),
            by_rows: ThreadParts::new(&[]),
            by_entries: ThreadParts::new(&[]),
            released: None,
        }
        .in_batches(Arc::default())
    }

    /// Adds searches for terms that are active in some states only.
    ///
    /// None of these terms is included before [`with_near_terms`](super::motion_equations::EquationsOfMotion::with_near_terms) or
    /// [`with_active_terms`](super::motion_equations::EquationsOfMotion::with_active_terms) is called.
    #[must_use]
    pub fn with_searches(self, searches: Vec<Arc<dyn ContactSearch>>) -> Self {
        Self { contacts: ActiveContacts::new(searches), ..self }
    }

    /// Evaluates terms in batches, each given with the indices of its terms.
    ///
    /// # Panics
    /// If the terms of a batch differ in size. This is a programming error, not an input error.
    #[must_use]
    pub fn with_batches(self, batches: impl IntoIterator<Item = (Vec<usize>, Box<dyn Batch>)>) -> Self {
        let place = |(terms, batch)| PlacedBatch::new(terms, batch, &self.terms, self.coordinates);
        let batches: Arc<[PlacedBatch]> = batches.into_iter().map(place).collect();
        let places = batches.iter().map(|batched| TangentPlaces::new(batched, &self.pattern)).collect();
        Self { places, ..self }.in_batches(batches)
    }

    fn in_batches(self, batches: Arc<[PlacedBatch]>) -> Self {
        let mut is_alone = vec![true; self.terms.len()];
        batches.iter().flat_map(|batched| &batched.terms).for_each(|&term| is_alone[term] = false);
        let unbatched = (0..self.terms.len()).filter(|&i| is_alone[i]).collect();
        let unbatched_constraints = self.constraints.iter().copied().filter(|&i| is_alone[i]).collect();
        let rows: Vec<_> = batches.iter().map(PlacedBatch::range).collect();
        let placed = batches.iter().zip(&*self.places);
        let entries: Vec<_> = placed.map(|(of, places)| places.range(of, &self.scatters)).collect();
        let (by_rows, by_entries) = (ThreadParts::new(&rows), ThreadParts::new(&entries));
        Self { batches, unbatched, unbatched_constraints, by_rows, by_entries, ..self }
    }

    /// Replaces the terms of the contact groups by those of other groups, in ascending order.
    pub(super) fn with_group_terms(&self, groups: Vec<ActiveGroup>) -> (Self, SparseMatrix) {
        let terms = self.contacts.terms_of(&groups, &self.terms[self.lasting..]);
        self.with_terms(terms, groups)
    }

    /// Replaces the terms of contacts. `groups` are their groups, or empty for other terms.
    pub(super) fn with_terms(
        &self,
        added: Vec<Arc<dyn Term>>,
        groups: Vec<ActiveGroup>,
    ) -> (Self, SparseMatrix) {
        let (n, lasting) = (self.coordinates, &self.terms[..self.lasting]);
        let new =
            |added: &[&Arc<dyn Term>]| pattern_of(n, &self.rows, lasting.iter().chain(added.iter().copied()));
        let (contacts, pattern) = self.contacts.replaced(groups, (&added, n), &self.pattern, new);
        let terms: Vec<_> = lasting.iter().cloned().chain(added).collect();
        let is_kept = Arc::ptr_eq(&pattern, &self.pattern);
        let kept = if is_kept { self.lasting } else { 0 };
        let place = |batched| TangentPlaces::new(batched, &pattern);
        let places =
            if is_kept { Arc::clone(&self.places) } else { self.batches.iter().map(place).collect() };
        let new = scatters(&pattern, n, &terms[kept..]);
        let system = Self {
            contacts,
            constraints: self.constraints.clone(),
            rows: Arc::clone(&self.rows),
            angles: self.angles.clone(),
            scatters: self.scatters[..kept].iter().cloned().chain(new).collect(),
            pattern,
            terms,
            batches: Arc::default(),
            places,
            unbatched: Vec::new(),
            unbatched_constraints: Vec::new(),
            by_rows: ThreadParts::new(&[]),
            by_entries: ThreadParts::new(&[]),
            released: self.released.clone(),
            ..*self
        }
        .in_batches(Arc::clone(&self.batches));
        let matrix = system.matrix();
        (system, matrix)
    }

    /// Marks multipliers that redundant constraints leave undetermined. Must be called before any matrix is created.
    ///
    /// The factorisation distributes their forces in the least-squares sense ([`Factor`](crate::factor::Factor)).
    #[must_use]
    pub fn with_shared_multipliers(mut self, multipliers: impl IntoIterator<Item = usize>) -> Self {
        let unknowns = multipliers.into_iter().map(|multiplier| self.coordinates + multiplier);
        Arc::make_mut(&mut self.pattern).share(unknowns);
        let coordinates = self.without_stiffness();
        Arc::make_mut(&mut self.pattern).leave_without_stiffness(coordinates.into_iter());
        self
    }

    /// Sets the stored part of the factors of matrices. Must be called before any matrix is created.
    #[must_use]
    pub fn with_factor_storage(mut self, storage: FactorStorage) -> Self {
        Arc::make_mut(&mut self.pattern).store(storage);
        self
    }

    /// Returns the coordinates without stiffness in the reference state without constraint forces.
    fn without_stiffness(&self) -> Vec<usize> {
        let mut stiffness = self.matrix();
        self.tangent(&State::rest(self.coordinates, self.multipliers), Weights::STIFFNESS, &mut stiffness);
        let diagonal: Vec<f64> = stiffness.diagonal().collect();
        let pattern = &self.pattern;
        (0..self.coordinates).filter(|&coordinate| diagonal[pattern.position(coordinate)] == 0.0).collect()
    }

    /// System that is in equilibrium in a state at the load factor s = 0, from which it is released in proportion to s.
    ///
    /// The equations are r(q, λ, s) − (1 − s/s₁) r(q₀, λ₀, 0) = 0: forces that hold the state, and gaps of constraints, decrease to
    /// zero at the last load factor s₁, which is not 0. Rows of constraints in `kept` keep their gaps. Statics only: the equations of
    /// motion and the tangent with respect to s lack this part.
    #[must_use]
    pub fn released_from(&self, start: &State, last: f64, kept: &[usize]) -> Self {
        let mut held = State { load: 0.0, ..start.clone() };
        held.v.fill(0.0);
        held.a.fill(0.0);
        let complete = self.with_active_terms(&held);
        let mut residual = vec![0.0; self.coordinates + self.multipliers];
        complete.as_ref().map_or(self, |(system, _)| system).residual(&held, &mut residual);
        let release = Release { residual: residual.into(), last, kept: kept.into() };
        Self { released: Some(release), ..self.clone() }
    }

    /// Returns the searches for contacts.
    pub fn searches(&self) -> &[Arc<dyn ContactSearch>] {
        &self.contacts.searches
    }

    /// Returns the terms.
    pub fn terms(&self) -> &[Arc<dyn Term>] {
        &self.terms
    }

    /// Returns the pattern of its matrices.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Creates a zero matrix of the pattern of the system.
    pub fn matrix(&self) -> SparseMatrix {
        SparseMatrix::zero(Arc::clone(&self.pattern))
    }
}

impl System {
    /// Adds a vector summed over some terms; `share` adds to the local rows.
    pub(super) fn add<'a>(
        &self,
        terms: impl Iterator<Item = &'a Arc<dyn Term>>,
        s: &State,
        sum: &mut [f64],
        share: impl Fn(&dyn Term, &Local<'_>, &mut [f64]),
    ) {
        let (mut gathered, mut small, mut large) = (LocalState::EMPTY, [0.0; USUAL], Vec::new());
        for term in terms {
            let term = term.as_ref();
            let local = gathered.gather(s, term);
            let n = local.q.len() + local.lambda.len();
            let rows = if n <= USUAL {
                &mut small[..]
            } else {
                large.resize(LOCAL, 0.0);
                &mut large[..]
            };
            rows[..n].fill(0.0);
            share(term, &local, &mut rows[..n]);
            let (of_coordinates, of_multipliers) = rows[..n].split_at(local.q.len());
            for (&c, row) in term.coordinates().iter().zip(of_coordinates) {
                sum[c] += row;
            }
            for (m, row) in term.multipliers().zip(of_multipliers) {
                sum[self.coordinates + m] += row;
            }
        }
    }

    /// Adds a matrix summed over some terms; `share` adds to the lower triangle of the local matrix.
    pub(super) fn add_matrix(
        &self,
        terms: impl Iterator<Item = usize>,
        values: &mut [f64],
        mut share: impl FnMut(&dyn Term, &mut LocalMatrix<'_>),
    ) {
        let (mut small, mut large) = ([0.0; USUAL * (USUAL + 1) / 2], Vec::new());
        for i in terms {
            let term = self.terms[i].as_ref();
            let size = term.coordinates().len() + term.multipliers().len();
            let storage = if size <= USUAL {
                &mut small[..]
            } else {
                large.resize(LOCAL * (LOCAL + 1) / 2, 0.0);
                &mut large[..]
            };
            let mut block = LocalMatrix::zero(size, storage);
            share(term, &mut block);
            let lower = block.lower();
            self.scatters[i].add(values, 0, |k| lower[k]);
        }
    }

    /// Sets a matrix to the sum of the tangents of all batches. `add` adds those of one batch, with its places and the scatter maps, to a
    /// section of the values that starts at an entry.
    pub(super) fn set_batched(
        &self,
        values: &mut [f64],
        add: impl Fn(
            &mut GatheredLanes,
            &mut TangentLanes,
            (&PlacedBatch, &TangentPlaces),
            &[Scatter],
            (&mut [f64], usize),
        ) + Sync,
    ) {
        for_each_chunk(values, |_, values| values.fill(0.0));
        self.by_entries.add_to(values, |batches, values, first| {
            LaneStorage::with(|LaneStorage { lanes, entries }| {
                for &i in batches {
                    let of = (&self.batches[i as usize], &self.places[i as usize]);
                    add(lanes, entries, of, &self.scatters, (&mut *values, first));
                }
            });
        });
    }

    /// Adds a matrix of two states, summed over some terms.
    pub(super) fn add_pair_matrix(
        &self,
        terms: impl Iterator<Item = usize>,
        [s, other]: [&State; 2],
        k: &mut SparseMatrix,
        share: impl Fn(&dyn Term, &Local<'_>, &Local<'_>, &mut LocalMatrix<'_>),
    ) {
        let [mut at, mut beside] = [LocalState::EMPTY; 2];
        self.add_matrix(terms, k.values_mut(), |term, block| {
            share(term, &at.gather(s, term), &beside.gather(other, term), block);
        });
    }

    /// Batches of the given indices.
    pub(super) fn of<'a>(&'a self, batches: &'a [u32]) -> impl Iterator<Item = &'a PlacedBatch> {
        batches.iter().map(|&i| &self.batches[i as usize])
    }

    /// Sums over all batches except constraints, which have no energy and power.
    pub(super) fn sum<T: Default + AddAssign + Send>(
        &self,
        s: &State,
        share: impl Fn(&dyn Batch, &LocalLanes<'_>) -> T + Sync,
    ) -> T {
        self.by_rows.sum(|batches| {
            let mut sum = T::default();
            LaneStorage::with(|storage| {
                for batched in self.of(batches).filter(|batched| !batched.batch.is_constraint()) {
                    sum += share(&*batched.batch, &storage.lanes.gather(s, batched));
                }
            });
            sum
        })
    }

    /// Returns the terms outside all batches.
    pub(super) fn unbatched(&self) -> impl Iterator<Item = &Arc<dyn Term>> {
        self.unbatched.iter().map(|&i| &self.terms[i])
    }
}
