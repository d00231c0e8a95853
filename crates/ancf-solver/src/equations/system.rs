use std::cell::RefCell;
use std::fmt;
use std::ops::AddAssign;
use std::sync::Arc;

use nalgebra::DVector;

use super::batch::{Batch, GatheredLanes, LocalLanes, LowerLanes, PlacedBatch};
use super::contact_pairs::{
    ActivePair, ContactSearch, acting_pairs, is_missing, is_near_missing, near_pairs, with_pairs,
};
use super::dependence::{redundant_rows, scaled_constraint_rows};
use super::energy::{Energy, Level, Power};
use super::motion_equations::EquationsOfMotion;
use super::scatter::Scatter;
use super::state::{Inadmissibility, State, StepStates, Weights};
use super::stiffness_products::{StiffnessProducts, stiffness_products};
use super::term::{LOCAL, Local, LocalMatrix, Term};
use super::term_sums::{LocalEnds, LocalState, Rotation, largest_rotation, powers, skew_stiffness, unknowns};
use super::thread_parts::{ThreadParts, enclosing_range};
use crate::sparse::{ConstraintRow, IndexLists, Pattern, SparseMatrix};

/// Equations of motion as a sum of terms: gather, evaluate, scatter.
pub struct System {
    coordinates: usize,
    multipliers: usize,
    terms: Vec<Arc<dyn Term>>,
    /// Searches that add terms, and the pairs of the last terms in ascending order.
    searches: Arc<[Arc<dyn ContactSearch>]>,
    active: Vec<ActivePair>,
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
        let terms: Vec<_> = terms.into_iter().map(Arc::from).collect();
        let rows = scaled_constraint_rows(&terms, coordinates, multipliers).into();
        Self::from_terms(coordinates, rows, terms, Arc::default(), Vec::new())
    }

    /// Adds searches for terms that are active in some states only.
    ///
    /// None of these terms is included before [`with_near_terms`](EquationsOfMotion::with_near_terms) or
    /// [`with_active_terms`](EquationsOfMotion::with_active_terms) is called.
    #[must_use]
    pub fn with_searches(self, searches: Vec<Arc<dyn ContactSearch>>) -> Self {
        Self { searches: searches.into(), ..self }
    }

    fn from_terms(
        coordinates: usize,
        rows: Arc<[ConstraintRow]>,
        terms: Vec<Arc<dyn Term>>,
        searches: Arc<[Arc<dyn ContactSearch>]>,
        active: Vec<ActivePair>,
    ) -> Self {
        let blocks: IndexLists = terms.iter().map(|term| unknowns(&**term, coordinates)).collect();
        assert!(blocks.iter().all(|block| block.len() <= LOCAL), "a term has at most {LOCAL} unknowns");
        let defining = terms.iter().filter(|term| !term.massless().is_empty());
        let defined: Vec<_> = defining.map(|term| (term.massless().to_vec(), term.multipliers())).collect();
        let pattern = Pattern::new(coordinates, &rows, &blocks, &defined);
        let scatters = blocks.iter().map(|unknowns| Scatter::new(&pattern, unknowns)).collect();
        let constraints = (0..terms.len()).filter(|&i| !terms[i].multipliers().is_empty()).collect();
        let angles = terms.iter().filter_map(|term| term.counted_angle()).collect();
        Self {
            coordinates,
            multipliers: rows.len(),
            unbatched: (0..terms.len()).collect(),
            terms,
            searches,
            active,
            constraints,
            rows,
            pattern: Arc::new(pattern),
            angles,
            scatters,
            batches: Arc::default(),
            by_rows: ThreadParts::new(&[]),
            by_entries: ThreadParts::new(&[]),
        }
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

    /// Replaces the terms of the pairs by those of other pairs, in ascending order.
    fn with_pair_terms(&self, active: Vec<ActivePair>) -> (Self, SparseMatrix) {
        let lasting = self.terms[..self.terms.len() - self.active.len()].iter().cloned();
        let terms = lasting.chain(active.iter().map(|&(i, pair)| self.searches[i].term(pair))).collect();
        let (rows, searches) = (Arc::clone(&self.rows), Arc::clone(&self.searches));
        let system = Self::from_terms(self.coordinates, rows, terms, searches, active)
            .in_batches(Arc::clone(&self.batches))
            .with_shared_multipliers(self.pattern.sharing().map(|unknown| unknown - self.coordinates));
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
        &self.searches
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
        self.searches.iter().find_map(|search| search.crossing(from, to))
    }

    fn passing(&self, from: &State, to: &State) -> Option<f64> {
        self.searches.iter().find_map(|search| search.passing(from, to))
    }

    fn acting_pairs(&self, s: &State) -> Option<Vec<ActivePair>> {
        (!self.searches.is_empty()).then(|| acting_pairs(&self.terms, &self.active, s))
    }

    fn rotation(&self, from: &State, to: &State) -> Rotation {
        largest_rotation(&self.terms, from, to)
    }

    fn with_near_terms(&self, s: &State) -> Option<(Self, SparseMatrix)> {
        let near = near_pairs(&self.searches, s);
        is_near_missing(&self.active, &near).then(|| self.with_pair_terms(with_pairs(&near, &[])))
    }

    fn with_active_terms(&self, s: &State) -> Option<(Self, SparseMatrix)> {
        let near = near_pairs(&self.searches, s);
        // The pairs of the start of the step are kept, so that repetitions of the step terminate.
        is_missing(&self.active, &near, 0.0).then(|| self.with_pair_terms(with_pairs(&near, &self.active)))
    }

    fn active_pairs(&self) -> Vec<ActivePair> {
        self.active.clone()
    }

    fn with_pairs(&self, active: &[ActivePair]) -> Option<(Self, SparseMatrix)> {
        let is_here = |(i, pair): &ActivePair| self.searches.get(*i).is_some_and(|each| each.contains(*pair));
        (active.is_sorted_by(|a, b| a < b) && active.iter().all(is_here))
            .then(|| self.with_pair_terms(active.to_vec()))
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
