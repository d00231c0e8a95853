//! Terms of a mesh: its elements and their prescribed strains.

use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::elements::{Change, ElementPlace, Prestrain, Prestrains, StrainEnergy};

impl BeamMesh {
    /// Prescribes strains. A source acts on the elements that its part covers. Elements of hyperelastic materials have none.
    #[must_use]
    pub fn with_prestrains(self, sources: Vec<Prestrain>) -> Self {
        let of = |element: usize| {
            let place = self.place(element);
            let covers = |source: &&Prestrain| source.covers(place.start, place.length);
            let here: Vec<_> = sources.iter().filter(covers).cloned().collect();
            if here.is_empty() {
                return None;
            }
            self.elements.prestrained(element, place, &here).map(Arc::from)
        };
        let terms = if sources.is_empty() { Vec::new() } else { (0..self.count()).map(of).collect() };
        Self { prestrains: Prestrains::new(sources, terms), ..self }
    }

    /// Returns the elements, then their prescribed strains as terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        let mut terms = self.elements.terms();
        terms.extend(self.prestrains.copied());
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
        let [Change { strain, curvature }, _] = self.prestrains.changes(state, self.place(element), xi);
        (strain, curvature)
    }

    fn place(&self, element: usize) -> ElementPlace {
        ElementPlace { start: element as f64 * self.length, length: self.length }
    }

    /// Returns the prescribed change of shape at an arc length, and its rate.
    pub(super) fn prescribed_changes(&self, state: &State, s: f64) -> [Change; 2] {
        let (element, xi) = self.locate(s);
        self.prestrains.changes(state, self.place(element), xi)
    }
}
