//! Terms of a mesh: its elements and their prescribed strains.

use std::fmt;
use std::sync::Arc;

use ancf_solver::equations::{LOCAL, Local, State, Term};
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::elements::{Change, ElementPlace, Prestrain, PrestrainTerm, StrainEnergy, prestrains};
use crate::sections::{Directors, STRAINS, Strains};

/// Prescribed strains of a mesh, with the terms of the elements that have any.
#[derive(Clone, Default)]
pub(super) struct Prestrains {
    sources: Vec<Prestrain>,
    terms: Vec<Option<Arc<dyn PrestrainTerm>>>,
}

impl fmt::Debug for Prestrains {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Prestrains").field("sources", &self.sources).finish_non_exhaustive()
    }
}

impl Prestrains {
    /// Returns the term of an element.
    pub(super) fn term(&self, element: usize) -> Option<&dyn PrestrainTerm> {
        self.terms.get(element)?.as_deref()
    }

    /// Returns the strain energy that the term of an element adds to its parts.
    fn parts(&self, state: &State, element: usize, q: &[f64]) -> StrainEnergy {
        let zeros = [0.0; LOCAL];
        let still = &zeros[..q.len()];
        let at = Local { q, v: still, a: still, lambda: &[], t: state.t, load: state.load };
        self.term(element).map_or_else(StrainEnergy::default, |term| term.parts(&at))
    }
}

impl BeamMesh {
    /// Prescribes strains. A source acts on the elements that its part covers. Elements of hyperelastic materials have none.
    #[must_use]
    pub fn with_prestrains(self, sources: Vec<Prestrain>) -> Self {
        let of = |element: usize| {
            let start = element as f64 * self.length;
            let here: Vec<_> =
                sources.iter().filter(|source| source.covers(start, self.length)).cloned().collect();
            if here.is_empty() {
                return None;
            }
            let place = ElementPlace { start, length: self.length };
            self.elements.prestrained(element, place, &here).map(Arc::from)
        };
        let terms = if sources.is_empty() { Vec::new() } else { (0..self.count()).map(of).collect() };
        Self { prestrains: Prestrains { sources, terms }, ..self }
    }

    /// Returns the elements, then their prescribed strains as terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        let mut terms = self.elements.terms();
        terms.extend(self.prestrains.terms.iter().flatten().map(|term| term.copied()));
        terms
    }

    /// Returns the strain energy of all elements by part.
    pub fn strain_energy(&self, state: &State) -> StrainEnergy {
        let mut sum = StrainEnergy::default();
        let (size, stride) = (3 * self.weights(0.0).len(), 3 * self.stride());
        for element in 0..self.count() {
            let first = self.first_coordinate() + element * stride;
            let q = &state.q[first..first + size];
            sum += self.elements.strain_energy(element, q);
            sum += self.prestrains.parts(state, element, q);
        }
        sum
    }

    /// Returns the prescribed axial strain and curvature at ξ of an element, the latter in the frame of the section.
    pub fn prestrain(&self, state: &State, element: usize, xi: f64) -> (f64, Vector3<f64>) {
        let Change { strain, curvature } = self.change(state, element, xi);
        (strain, curvature)
    }

    fn change(&self, state: &State, element: usize, xi: f64) -> Change {
        let start = element as f64 * self.length;
        let covering = self.prestrains.sources.iter().filter(|source| source.covers(start, self.length));
        covering.fold(Change::default(), |sum, source| {
            sum.plus(&source.at(start + xi * self.length), source.factor(state.t, state.load)[0])
        })
    }

    /// Returns the prescribed section strains at an arc length with reference directors.
    pub(super) fn section_prestrains(&self, state: &State, s: f64, g0: &Directors) -> Strains {
        if self.prestrains.sources.is_empty() {
            return [0.0; STRAINS];
        }
        let (element, xi) = self.locate(s);
        prestrains(g0, &self.change(state, element, xi))
    }
}
