//! Equations of motion of a system.

use std::cell::RefCell;
use std::sync::Arc;

use nalgebra::DVector;

use super::batch::LaneStorage;
use super::constraint_rows::redundant_rows;
use super::contact_pairs::{ActiveGroup, ActivePair, acting_pairs};
use super::law_changes::{LawChanges, law_changes};
use super::motion_equations::EquationsOfMotion;
use super::stiffness_products::{StiffnessProducts, stiffness_products};
use super::system::System;
use super::term_sums::{
    LocalEnds, LocalState, Rotation, largest_rotation, powers, skew_entries, supplied_forces, visited_entries,
};
use super::terms::{Energy, Inadmissibility, Level, Power, State, StepStates, Term, Weights};
use crate::sparse::{Pattern, SparseMatrix};

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
            LaneStorage::with(|storage| {
                self.of(batches).for_each(|batched| storage.lanes.add_residual(s, batched, r, first));
            });
        });
        self.add(self.unbatched(), s, r, |term, at, rows| term.residual(at, rows));
        if let Some(released) = &self.released {
            released.subtract(s.load, 0, r);
        }
    }

    fn constraints(&self, s: &State, level: Level, phi: &mut [f64]) {
        phi.fill(0.0);
        LaneStorage::with(|storage| {
            let constrained = self.batches.iter().filter(|batched| batched.has_multipliers());
            constrained.for_each(|batched| storage.lanes.add_constraints(s, batched, level, phi));
        });
        let mut gathered = LocalState::EMPTY;
        for &i in &self.unbatched_constraints {
            let term = self.terms[i].as_ref();
            term.constraints(&gathered.gather(s, term), level, &mut phi[term.multipliers()]);
        }
        if let (Some(released), Level::Position) = (&self.released, level) {
            released.subtract(s.load, self.coordinates, phi);
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
        k.set_inertia(w.a != 0.0);
        let values = k.values_mut();
        self.set_batched(values, |lanes, entries, of, scatters, to| {
            let at = lanes.gather(s, of.0);
            entries.add_tangent(of, |batch, k| batch.tangent(&at, w, k), scatters, to);
        });
        let (mut gathered, terms) = (LocalState::EMPTY, self.unbatched.iter().copied());
        self.add_matrix(terms, values, |term, block| term.tangent(&gathered.gather(s, term), w, block));
    }

    fn predicted_stiffness(&self, s: &State, from: &State, k: &mut SparseMatrix) {
        k.set_inertia(false);
        let values = k.values_mut();
        self.set_batched(values, |lanes, entries, of, scatters, to| {
            let (at, from) = lanes.gather_pair([s, from], of.0);
            entries.add_tangent(of, |batch, k| batch.predicted_stiffness(&at, from, k), scatters, to);
        });
        let ([mut at, mut before], terms) = ([LocalState::EMPTY; 2], self.unbatched.iter().copied());
        self.add_matrix(terms, values, |term, block| {
            let at = at.gather(s, term);
            term.tangent(&at, Weights::STIFFNESS, block);
            if term.has_stress_prediction() {
                term.stress_prediction(&at, &before.gather(from, term), block);
            }
        });
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

    fn has_cables(&self) -> bool {
        self.terms.iter().any(|term| term.is_cable())
    }

    fn add_least_tension(&self, s: &State, from: &State, least: f64, k: &mut SparseMatrix) {
        let terms = (0..self.terms.len()).filter(|&i| self.terms[i].is_cable());
        self.add_pair_matrix(terms, [s, from], k, |term, at, from, k| term.least_tension(at, from, least, k));
    }

    fn stress_stiffness(&self, s: &State, by: &State, k: &mut SparseMatrix) {
        k.values_mut().fill(0.0);
        let terms = 0..self.terms.len();
        self.add_pair_matrix(terms, [s, by], k, |term, at, by, k| term.stress_stiffness(at, by, k));
    }

    fn inadmissible(&self, s: &State) -> Option<(usize, Inadmissibility)> {
        let batched = self.by_rows.find(|batches| {
            let mut limited = self.of(batches).filter(|batched| !batched.batch.is_constraint());
            LaneStorage::with(|storage| {
                limited.find_map(|batched| {
                    let lane = batched.batch.inadmissible(&storage.lanes.gather(s, batched))?;
                    Some(&self.terms[batched.terms[lane]])
                })
            })
        });
        let mut gathered = LocalState::EMPTY;
        let mut reason = |term: &dyn Term| term.inadmissibility(&gathered.gather(s, term));
        let mut terms = batched.into_iter().chain(self.unbatched());
        terms.find_map(|term| Some((*term.coordinates().first()?, reason(term.as_ref())?)))
    }

    fn half_turn(&self, from: &State, to: &State) -> Option<usize> {
        let [mut before, mut after] = [LocalState::EMPTY; 2];
        let mut passes =
            |term: &dyn Term| term.passes_half_turn(&before.gather(from, term), &after.gather(to, term));
        let mut terms = self.unbatched().filter(|term| term.has_half_turn());
        terms.find(|term| passes(term.as_ref()))?.coordinates().first().copied()
    }

    fn skew_stiffness(&self, s: &State) -> Vec<(usize, usize, f64)> {
        skew_entries(&self.terms, s, <dyn Term>::skew_stiffness)
    }

    fn skew_damping(&self, s: &State) -> Vec<(usize, usize, f64)> {
        skew_entries(&self.terms, s, <dyn Term>::skew_damping)
    }

    fn observes_multipliers(&self) -> bool {
        self.terms[..self.lasting].iter().any(|term| !term.observed_multipliers().is_empty())
    }

    fn omitted_stiffness(&self, s: &State) -> Vec<(usize, usize, f64)> {
        visited_entries(&self.terms, s, <dyn Term>::omitted_stiffness)
    }

    fn omitted_damping(&self, s: &State) -> Vec<(usize, usize, f64)> {
        visited_entries(&self.terms, s, <dyn Term>::omitted_damping)
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

    fn has_kinks(&self) -> bool {
        self.unbatched().any(|term| term.has_kinks())
    }

    fn law_changes(&self, from: &State, middle: &State, to: &State) -> Option<LawChanges> {
        let terms = self.unbatched.iter().map(|&i| (i, self.terms[i].as_ref()));
        law_changes(terms, [from, middle, to])
    }

    fn add_tangents(&self, terms: &[usize], s: &State, w: Weights, k: &mut SparseMatrix) {
        let mut gathered = LocalState::EMPTY;
        self.add_matrix(terms.iter().copied(), k.values_mut(), |term, block| {
            term.tangent(&gathered.gather(s, term), w, block);
        });
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

    fn energy_size(&self, s: &State) -> f64 {
        let mut gathered = LocalState::EMPTY;
        let mut of = |term: &dyn Term| term.energy(&gathered.gather(s, term)).largest();
        let batched = self.sum(s, |batch, at| batch.energy(at).largest());
        batched + self.unbatched().map(|term| of(term.as_ref())).sum::<f64>()
    }

    fn exchange(&self, s: &State, damping: &mut [f64]) -> Power {
        damping.fill(0.0);
        self.by_rows.add_to(damping, |batches, r, first| {
            let damped = self.of(batches).filter(|batched| batched.batch.is_damped());
            LaneStorage::with(|storage| {
                damped.for_each(|batched| storage.lanes.add_damping(s, batched, r, first));
            });
        });
        let damped = |term: &&Arc<dyn Term>| term.is_damped();
        self.add(self.unbatched().filter(damped), s, damping, |term, at, r| term.damping_forces(at, r));
        powers(self.unbatched(), s)
    }

    fn supplied_forces(&self, s: &State) -> f64 {
        supplied_forces(self.unbatched(), s)
    }
}
