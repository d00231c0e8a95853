use std::cell::RefCell;
use std::fmt;
use std::ops::AddAssign;
use std::sync::Arc;

use nalgebra::DVector;

use super::batch::{Batch, GatheredLanes, LocalLanes, LowerLanes, PlacedBatch};
use super::contact_pairs::{ActiveContacts, ActiveGroup, ActivePair, ContactSearch, acting_pairs};
use super::dependence::{redundant_rows, scaled_constraint_rows};
use super::energy::{Energy, Level, Power};
use super::motion_equations::EquationsOfMotion;
use super::scatter::{Scatter, pattern_of, scatters};
use super::state::{Inadmissibility, State, StepStates, Weights};
use super::stiffness_products::{StiffnessProducts, stiffness_products};
use super::term::{LOCAL, Local, LocalMatrix, Term};
use super::term_sums::{LocalEnds, LocalState, Rotation, largest_rotation, powers, skew_stiffness};
use super::thread_parts::{ThreadParts, enclosing_range};
use crate::sparse::{ConstraintRow, Pattern, SparseMatrix};

/// Equations of motion as a sum of terms: gather, evaluate, scatter.
pub struct System {
    coordinates: usize,
    multipliers: usize,
    terms: Vec<Arc<dyn Term>>,
    /// Number of terms without contacts, which are the last ones.
    lasting: usize,
    contacts: ActiveContacts,
    /// Indices of the terms with multipliers, and the rows that determine the order of elimination.
    constraints: Vec<usize>,
    rows: Arc<[ConstraintRow]>,
    pattern: Arc<Pattern>,
    /// Coordinates that are angles with counted turns.
    angles: Vec<usize>,
    /// Scatter map of each term.
    scatters: Vec<Scatter>,
    /// Batches, indices of the terms that are evaluated one by one, and batches by residual rows and by matrix entries.
    batches: Arc<[PlacedBatch]>,
    unbatched: Vec<usize>,
    by_rows: ThreadParts,
    by_entries: ThreadParts,
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
            unbatched: (0..terms.len()).collect(),
            terms,
            rows,
            pattern,
            batches: Arc::default(),
            by_rows: ThreadParts::new(&[]),
            by_entries: ThreadParts::new(&[]),
        }
    }

    /// Adds searches for terms that are active in some states only.
    ///
    /// None of these terms is included before [`with_near_terms`](EquationsOfMotion::with_near_terms) or
    /// [`with_active_terms`](EquationsOfMotion::with_active_terms) is called.
    #[must_use]
    pub fn with_searches(self, searches: Vec<Arc<dyn ContactSearch>>) -> Self {
        Self { contacts: ActiveContacts::new(searches), ..self }
    }

    /// Evaluates terms in batches, each given with the index of its first term.
    ///
    /// # Panics
    /// If the terms of a batch differ in size. This is a programming error, not an input error.
    #[must_use]
    pub fn with_batches(self, batches: impl IntoIterator<Item = (usize, Box<dyn Batch>)>) -> Self {
        let place = |(first, batch)| PlacedBatch::new(first, batch, &self.terms);
        let batches = batches.into_iter().map(place).collect();
        self.in_batches(batches)
    }

    fn in_batches(self, batches: Arc<[PlacedBatch]>) -> Self {
        let mut unbatched = vec![true; self.terms.len()];
        batches.iter().for_each(|batched| unbatched[batched.terms()].fill(false));
        let unbatched = (0..self.terms.len()).filter(|&i| unbatched[i]).collect();
        let rows: Vec<_> = batches.iter().map(PlacedBatch::range).collect();
        let entries = |batched: &PlacedBatch| {
            enclosing_range(self.scatters[batched.terms()].iter().map(Scatter::range))
        };
        let entries: Vec<_> = batches.iter().map(entries).collect();
        let (by_rows, by_entries) = (ThreadParts::new(&rows), ThreadParts::new(&entries));
        Self { batches, unbatched, by_rows, by_entries, ..self }
    }

    /// Replaces the terms of the contact groups by those of other groups, in ascending order.
    fn with_group_terms(&self, groups: Vec<ActiveGroup>) -> (Self, SparseMatrix) {
        let terms = self.contacts.terms_of(&groups, &self.terms[self.lasting..]);
        self.with_terms(terms, groups)
    }

    /// Replaces the terms of contacts. `groups` are their groups, or empty for other terms.
    fn with_terms(&self, added: Vec<Arc<dyn Term>>, groups: Vec<ActiveGroup>) -> (Self, SparseMatrix) {
        let (n, lasting) = (self.coordinates, &self.terms[..self.lasting]);
        let new = |added: &[&Arc<dyn Term>]| pattern_of(n, &self.rows, lasting.iter().chain(added.iter().copied()));
        let (contacts, pattern) = self.contacts.replaced(groups, (&added, n), &self.pattern, new);
        let terms: Vec<_> = lasting.iter().cloned().chain(added).collect();
        let kept = if Arc::ptr_eq(&pattern, &self.pattern) { self.lasting } else { 0 };
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
            unbatched: Vec::new(),
            by_rows: ThreadParts::new(&[]),
            by_entries: ThreadParts::new(&[]),
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
        self
    }

    /// Returns the searches for contacts.
    pub fn searches(&self) -> &[Arc<dyn ContactSearch>] {
        &self.contacts.searches
    }

    /// Returns the terms.
    pub fn terms(&self) -> &[Arc<dyn Term>] {
        &self.terms
    }

    /// Creates a zero matrix of the pattern of the system.
    pub fn matrix(&self) -> SparseMatrix {
        SparseMatrix::zero(Arc::clone(&self.pattern))
    }

    /// Adds a vector summed over some terms; `share` adds to the local rows.
    fn add<'a>(
        &self,
        terms: impl Iterator<Item = &'a Arc<dyn Term>>,
        s: &State,
        sum: &mut [f64],
        share: impl Fn(&dyn Term, &Local<'_>, &mut [f64]),
    ) {
        let (mut gathered, mut rows) = (LocalState::EMPTY, [0.0; LOCAL]);
        for term in terms {
            let term = term.as_ref();
            let local = gathered.gather(s, term);
            let n = local.q.len() + local.lambda.len();
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
    fn add_matrix(
        &self,
        terms: impl Iterator<Item = usize>,
        values: &mut [f64],
        mut share: impl FnMut(&dyn Term, &mut LocalMatrix<'_>),
    ) {
        let mut storage = [0.0; LOCAL * (LOCAL + 1) / 2];
        for i in terms {
            let term = self.terms[i].as_ref();
            let size = term.coordinates().len() + term.multipliers().len();
            let mut block = LocalMatrix::zero(size, &mut storage);
            share(term, &mut block);
            let lower = block.lower();
            self.scatters[i].add(values, 0, |k| lower[k]);
        }
    }

    /// Adds a matrix of two states, summed over some terms.
    fn add_pair_matrix(
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
    fn of<'a>(&'a self, batches: &'a [u32]) -> impl Iterator<Item = &'a PlacedBatch> {
        batches.iter().map(|&i| &self.batches[i as usize])
    }

    /// Sums over all batches.
    fn sum<T: Default + AddAssign + Send>(
        &self,
        s: &State,
        share: impl Fn(&dyn Batch, &LocalLanes<'_>) -> T + Sync,
    ) -> T {
        self.by_rows.sum(|batches| {
            let (mut lanes, mut sum) = (GatheredLanes::EMPTY, T::default());
            for batched in self.of(batches) {
                sum += share(&*batched.batch, &lanes.gather(s, batched));
            }
            sum
        })
    }

    /// Returns the terms outside all batches.
    fn unbatched(&self) -> impl Iterator<Item = &Arc<dyn Term>> {
        self.unbatched.iter().map(|&i| &self.terms[i])
    }
}

impl EquationsOfMotion for System {
    fn coordinates(&self) -> usize {
        self.coordinates
    }

    fn multipliers(&self) -> usize {
        self.multipliers
    }

    fn residual(&self, s: &State, r: &mut [f64]) {
        r.fill(0.0);
        self.by_rows.add_to(r, |batches, r, first| {
            let mut lanes = GatheredLanes::EMPTY;
            self.of(batches).for_each(|batched| lanes.add_residual(s, batched, r, first));
        });
        self.add(self.unbatched(), s, r, |term, at, rows| term.residual(at, rows));
    }

    fn constraints(&self, s: &State, level: Level, phi: &mut [f64]) {
        phi.fill(0.0);
        let mut gathered = LocalState::EMPTY;
        for &i in &self.constraints {
            let term = self.terms[i].as_ref();
            term.constraints(&gathered.gather(s, term), level, &mut phi[term.multipliers()]);
        }
    }

    fn rounding(&self, s: &State, floor: &mut [f64]) {
        floor.fill(0.0);
        self.add(self.terms.iter(), s, floor, |term, at, rows| term.rounding(at, rows));
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn tangent(&self, s: &State, w: Weights, k: &mut SparseMatrix) {
        let values = k.values_mut();
        values.fill(0.0);
        self.by_entries.add_to(values, |batches, values, first| {
            let (mut lanes, mut lower) = (GatheredLanes::EMPTY, LowerLanes::ZERO);
            for batched in self.of(batches) {
                let at = lanes.gather(s, batched);
                lower.add_tangent(batched, &at, w, &self.scatters, (values, first));
            }
        });
        let (mut gathered, terms) = (LocalState::EMPTY, self.unbatched.iter().copied());
        self.add_matrix(terms, values, |term, block| term.tangent(&gathered.gather(s, term), w, block));
    }

    fn stiffness_products(&self, s: &State, x: &[DVector<f64>]) -> StiffnessProducts {
        stiffness_products(&self.terms, s, x)
    }

    fn average_residual(&self, step: &StepStates<'_>, r: &mut [f64]) {
        r.fill(0.0);
        let ends = RefCell::new(LocalEnds::EMPTY);
        self.add(self.terms.iter(), step.middle, r, |term, middle, rows| {
            term.average_residual(&ends.borrow_mut().gather(step, *middle, term), rows);
        });
    }

    fn average_tangent(&self, step: &StepStates<'_>, w: Weights, k: &mut SparseMatrix) {
        k.values_mut().fill(0.0);
        let (mut gathered, mut ends, w) = (LocalState::EMPTY, LocalEnds::EMPTY, w.of_middle());
        self.add_matrix(0..self.terms.len(), k.values_mut(), |term, block| {
            let middle = gathered.gather(step.middle, term);
            term.average_tangent(&ends.gather(step, middle, term), w, block);
        });
    }

    fn add_stress_prediction(&self, s: &State, from: &State, k: &mut SparseMatrix) {
        let terms = (0..self.terms.len()).filter(|&i| self.terms[i].has_stress_prediction());
        self.add_pair_matrix(terms, [s, from], k, |term, at, from, k| term.stress_prediction(at, from, k));
    }

    fn stress_stiffness(&self, s: &State, by: &State, k: &mut SparseMatrix) {
        k.values_mut().fill(0.0);
        let terms = 0..self.terms.len();
        self.add_pair_matrix(terms, [s, by], k, |term, at, by, k| term.stress_stiffness(at, by, k));
    }

    fn inadmissible(&self, s: &State) -> Option<(usize, Inadmissibility)> {
        let batched = self.by_rows.find(|batches| {
            let mut lanes = GatheredLanes::EMPTY;
            self.of(batches).find_map(|batched| {
                let lane = batched.batch.inadmissible(&lanes.gather(s, batched))?;
                Some(&self.terms[batched.first + lane])
            })
        });
        let mut gathered = LocalState::EMPTY;
        let mut reason = |term: &dyn Term| term.inadmissibility(&gathered.gather(s, term));
        let mut terms = batched.into_iter().chain(self.unbatched());
        terms.find_map(|term| Some((*term.coordinates().first()?, reason(term.as_ref())?)))
    }

    fn skew_stiffness(&self, s: &State) -> Vec<(usize, usize, f64)> {
        skew_stiffness(&self.terms, s)
    }

    fn crossing(&self, from: &State, to: &State) -> Option<usize> {
        self.searches().iter().find_map(|search| search.crossing(from, to))
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        self.searches().iter().find_map(|search| search.passing(from, to))
    }

    fn acting_pairs(&self, s: &State) -> Option<Vec<ActivePair>> {
        (!self.searches().is_empty()).then(|| acting_pairs(self.searches(), s))
    }

    fn rotation(&self, from: &State, to: &State) -> Rotation {
        largest_rotation(&self.terms, from, to)
    }

    fn with_near_terms(&self, s: &State) -> Option<(Self, SparseMatrix)> {
        self.contacts.near(s).map(|groups| self.with_group_terms(groups))
    }

    fn with_active_terms(&self, s: &State) -> Option<(Self, SparseMatrix)> {
        self.contacts.completed(s).map(|groups| self.with_group_terms(groups))
    }

    fn active_groups(&self) -> Vec<ActiveGroup> {
        self.contacts.groups.clone()
    }

    fn with_groups(&self, groups: &[ActiveGroup]) -> Option<(Self, SparseMatrix)> {
        self.contacts.accepts(groups).then(|| self.with_group_terms(groups.to_vec()))
    }

    fn with_pairs(&self, pairs: &[ActivePair]) -> Option<(Self, SparseMatrix)> {
        let term = |(i, pair): &ActivePair| Some(self.searches().get(*i)?.term(*pair));
        Some(self.with_terms(pairs.iter().map(term).collect::<Option<_>>()?, Vec::new()))
    }

    fn degrees_of_freedom(&self, s: &State) -> usize {
        let terms = self.constraints.iter().map(|&i| self.terms[i].as_ref());
        // Constraints are redundant only where multipliers are shared.
        let shared = !self.pattern.shared().is_empty();
        let excess = if shared { redundant_rows(terms, self.multipliers, s) } else { 0 };
        (self.coordinates + excess).saturating_sub(self.multipliers)
    }

    fn counted_angles(&self) -> &[usize] {
        &self.angles
    }

    fn energy(&self, s: &State) -> Energy {
        let mut energy = self.sum(s, |batch, at| batch.energy(at));
        let mut gathered = LocalState::EMPTY;
        self.unbatched().for_each(|term| energy += term.energy(&gathered.gather(s, term.as_ref())));
        energy
    }

    fn exchange(&self, s: &State, damping: &mut [f64]) -> Power {
        damping.fill(0.0);
        self.by_rows.add_to(damping, |batches, r, first| {
            let damped = self.of(batches).filter(|batched| batched.batch.is_damped());
            damped.for_each(|batched| GatheredLanes::EMPTY.add_damping(s, batched, r, first));
        });
        let damped = |term: &&Arc<dyn Term>| term.is_damped();
        self.add(self.unbatched().filter(damped), s, damping, |term, at, r| term.damping_forces(at, r));
        powers(self.unbatched(), s)
    }
}
