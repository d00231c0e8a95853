//! What is spread along a body: parts of its elements, and markers whose weights are integrals.

use std::ops::Range;

use super::mesh::{BeamMesh, Elements};
use crate::kinematics::{Marker, gauss, gauss3};

/// One element within a span.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Number of the element.
    pub element: usize,
    /// Arc lengths at which the piece starts and ends.
    pub span: Range<f64>,
}

impl Piece {
    /// Arc lengths of the three points of Gauss, with lengths for weights: integrals are exact to degree five.
    pub fn points(&self) -> [(f64, f64); 3] {
        gauss3().map(|point| self.placed(point))
    }

    /// Five points, exact to degree nine.
    pub fn many_points(&self) -> [(f64, f64); 5] {
        gauss().map(|point| self.placed(point))
    }

    fn placed(&self, (x, w): (f64, f64)) -> (f64, f64) {
        let length = self.span.end - self.span.start;
        (self.span.start + x * length, w * length)
    }
}

impl BeamMesh {
    /// The parts of the elements that a span of arc length covers, but for slivers of rounding.
    pub fn pieces(&self, span: Range<f64>) -> impl Iterator<Item = Piece> + '_ {
        (0..self.count()).filter_map(move |element| {
            let start = (element as f64 * self.length).max(span.start);
            let end = ((element + 1) as f64 * self.length).min(span.end);
            (end - start > 1e-12 * self.length).then_some(Piece { element, span: start..end })
        })
    }

    /// ∫ p(s) r(s) ds over a piece as a marker, p at most quadratic: a force f p(s) per length does the work of f on it.
    pub fn spread(&self, piece: &Piece, p: impl Fn(f64) -> f64) -> Marker {
        let points = piece.points().map(|(s, w)| (w * p(s), self.point(s)));
        Marker::combined(points.iter().map(|(factor, point)| (*factor, point)))
    }

    /// ∫ ρ r dV of each element as a marker: an acceleration field a does the work of a on it.
    pub fn mass_markers(&self) -> impl Iterator<Item = Marker> + '_ {
        (0..self.count()).map(|element| {
            let offset = element * self.stride();
            let first: &[f64] = match &self.elements {
                Elements::Two(elements) => elements[element].profile().first_moments(),
                Elements::Three(elements) => elements[element].profile().first_moments(),
                Elements::Cable(elements) => elements[element].profile().first_moments(),
            };
            let kinds = self.node_kinds();
            let value = |i: usize| {
                let is_position = kinds[i % kinds.len()] == crate::kinematics::Kind::Position;
                self.reference[offset + i] + if is_position { self.origin } else { Default::default() }
            };
            let reference = first.iter().enumerate().map(|(i, w)| value(i) * *w).sum();
            Marker::new(first.iter().enumerate().map(|(i, w)| (self.first + 3 * (offset + i), *w)), reference)
        })
    }
}
