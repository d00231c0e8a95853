use std::fmt;
use std::sync::Arc;

use ancf_solver::equations::{LOCAL, Local, State, Term};

use super::source::{Change, ElementPlace, Prestrain};
use super::term::PrestrainTerm;
use crate::elements::StrainEnergy;

/// Prescribed strains of a mesh, with the terms of the elements that have any.
#[derive(Clone, Default)]
pub(crate) struct Prestrains {
    sources: Vec<Prestrain>,
    terms: Vec<Option<Arc<dyn PrestrainTerm>>>,
}

impl fmt::Debug for Prestrains {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Prestrains").field("sources", &self.sources).finish_non_exhaustive()
    }
}

impl Prestrains {
    /// Creates the list of sources with the terms of all elements, `None` for elements without any.
    pub(crate) fn new(sources: Vec<Prestrain>, terms: Vec<Option<Arc<dyn PrestrainTerm>>>) -> Self {
        Self { sources, terms }
    }

    /// Copies the terms.
    pub(crate) fn copied(&self) -> impl Iterator<Item = Box<dyn Term>> {
        self.terms.iter().flatten().map(|term| term.copied())
    }

    /// Returns the change of shape at ξ of an element at its place in a state, and its rate.
    pub(crate) fn changes(&self, state: &State, place: ElementPlace, xi: f64) -> [Change; 2] {
        let ElementPlace { start, length } = place;
        let covering = self.sources.iter().filter(|source| source.covers(start, length));
        covering.fold([Change::default(); 2], |sums, source| {
            let (change, factors) = (source.at(start + xi * length), source.factor(state.t, state.load));
            [0, 1].map(|k| sums[k].plus(&change, factors[k]))
        })
    }

    /// Returns the term of an element.
    pub(crate) fn term(&self, element: usize) -> Option<&dyn PrestrainTerm> {
        self.terms.get(element)?.as_deref()
    }

    /// Returns the strain energy that the term of an element adds to its parts.
    pub(crate) fn parts(&self, state: &State, element: usize, q: &[f64]) -> StrainEnergy {
        let zeros = [0.0; LOCAL];
        let still = &zeros[..q.len()];
        let at = Local { q, v: still, a: still, lambda: &[], t: state.t, load: state.load };
        self.term(element).map_or_else(StrainEnergy::default, |term| term.parts(&at))
    }
}
