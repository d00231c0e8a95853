//! Distributed quantities of a body: parts of its elements, and markers with integrated weights.

use std::ops::Range;

use ancf_solver::equations::State;

use super::mesh::BeamMesh;
use crate::inertia::MassVisitor;
use crate::kinematics::{Marker, NodalVector, gauss, gauss3};

/// Part of one element within an interval of arc length.
#[derive(Clone, Debug)]
pub struct ElementSpan {
    /// Index of the element.
    pub element: usize,
    /// Arc lengths of the start and the end.
    pub span: Range<f64>,
}

impl ElementSpan {
    /// Returns three Gauss points as arc lengths, with weights of unit length. Integrals are exact to degree five.
    pub fn points(&self) -> [(f64, f64); 3] {
        gauss3().map(|point| self.placed(point))
    }

    /// Returns five Gauss points. Integrals are exact to degree nine.
    pub fn fine_points(&self) -> [(f64, f64); 5] {
        gauss().map(|point| self.placed(point))
    }

    fn placed(&self, (x, w): (f64, f64)) -> (f64, f64) {
        let length = self.span.end - self.span.start;
        (self.span.start + x * length, w * length)
    }
}

impl BeamMesh {
    /// Returns the parts of the elements within an interval of arc length. Parts of rounding size are dropped.
    pub fn element_spans(&self, span: Range<f64>) -> impl Iterator<Item = ElementSpan> + '_ {
        (0..self.count()).filter_map(move |element| {
            let start = (element as f64 * self.length).max(span.start);
            let end = ((element + 1) as f64 * self.length).min(span.end);
            (end - start > 1e-12 * self.length).then_some(ElementSpan { element, span: start..end })
        })
    }

    /// Returns ∫ p(s) r(s) ds over a part as a marker, for p at most quadratic.
    ///
    /// A force f p(s) per length has the virtual work of f on this marker.
    pub fn distributed_marker(&self, span: &ElementSpan, p: impl Fn(f64) -> f64) -> Marker {
        let points = span.points().map(|(s, w)| (w * p(s), self.point(s)));
        Marker::combined(points.iter().map(|(factor, point)| (*factor, point)))
    }

    /// Returns ∫ ρ r dV of each element as a marker. An acceleration field a has the virtual work of a on it.
    pub fn mass_markers(&self) -> impl Iterator<Item = Marker> + '_ {
        (0..self.count()).map(|element| {
            let offset = element * self.stride();
            let first = self.elements.first_moments(element);
            let kinds = self.node_kinds();
            let value = |i: usize| {
                let is_position = kinds[i % kinds.len()] == crate::kinematics::VectorKind::Position;
                self.reference[offset + i] + if is_position { self.origin } else { Default::default() }
            };
            let reference = first.iter().enumerate().map(|(i, w)| value(i) * *w).sum();
            Marker::new(first.iter().enumerate().map(|(i, w)| (self.first + 3 * (offset + i), *w)), reference)
        })
    }

    /// Visits the elements with their nodal vectors in a state and their compact mass matrices.
    pub(crate) fn visit_masses(&self, s: &State, visit: &mut MassVisitor<'_>) {
        let vectors: Vec<NodalVector> = self.vectors(s).collect();
        for element in 0..self.count() {
            let first = element * self.stride();
            let own = &vectors[first..first + self.elements.first_moments(element).len()];
            visit(own, &|a, b| self.elements.mass(element, a, b));
        }
    }
}
