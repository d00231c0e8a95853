use std::ops::Range;

use ancf_solver::equations::{
    Inadmissibility, Level, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual,
    middle_residual,
};
use nalgebra::Vector3;

use super::coincidence::AXES;
use super::wrench::Wrench;
use crate::kinematics::{BodyVector, ElementAxis};

/// Sliding joint of a point on the axis of a beam: r_a = r_b(s), with the undeformed arc length s as a massless
/// coordinate.
///
/// Φ = r_a − r_b(s), and Φ_qᵀ λ applies λ to the point, −λ N to the beam and −λ·r_b′(s) to s. The latter is the
/// tangential component. It vanishes unless a drive or a constraint acts on s, so the joint is frictionless.
///
/// Each element of the beam has one term. All terms share the three multipliers and s. The term of the element that
/// contains s is active, so the point passes from element to element. Only two-node elements have a continuous tangent.
/// A point beyond the ends of the beam is inadmissible.
///
/// Units: length; λ is a force.
/// Source: Sugiyama, Escalona & Shabana (2003), sliding joints of the absolute nodal coordinate formulation.
#[derive(Clone, Debug)]
pub struct SlideConstraint {
    point: BodyVector,
    axis: ElementAxis,
    /// Coordinates, s minus its reference value first.
    coordinates: Vec<usize>,
    first: usize,
    start: f64,
    /// True if the beam ends at the start or at the end of the element.
    ends: [bool; 2],
}

/// Position of s among the coordinates.
const S: usize = 0;

impl SlideConstraint {
    /// Creates the terms of a sliding joint along the elements of a beam, starting at the arc length `start`.
    ///
    /// Uses the three multipliers from `first`.
    pub fn along(
        axes: impl IntoIterator<Item = ElementAxis>,
        point: impl Into<BodyVector>,
        coordinate: usize,
        start: f64,
        first: usize,
    ) -> Vec<Self> {
        let point = &point.into();
        let mut slides: Vec<Self> =
            axes.into_iter().map(|axis| Self::new(&axis, point, coordinate, start, first)).collect();
        if let Some(slide) = slides.first_mut() {
            slide.ends[0] = true;
        }
        if let Some(slide) = slides.last_mut() {
            slide.ends[1] = true;
        }
        slides
    }

    fn new(axis: &ElementAxis, point: &BodyVector, coordinate: usize, start: f64, first: usize) -> Self {
        let mut others: Vec<usize> = point.coordinates().chain(axis.coordinates()).collect();
        others.sort_unstable();
        others.dedup();
        let coordinates: Vec<usize> = [coordinate].into_iter().chain(others).collect();
        let (point, axis) = (point.within(&coordinates), axis.within(&coordinates));
        Self { point, axis, coordinates, first, start, ends: [false; 2] }
    }

    /// Returns the reaction of the beam on the point: −λ.
    pub fn reaction(&self, s: &State) -> Wrench {
        let force = -Vector3::from_column_slice(&s.lambda[self.first..self.first + 3]);
        Wrench { force, ..Wrench::default() }
    }

    /// Returns the arc length s if it is in this element. The first and the last element extend beyond the ends of the
    /// beam.
    fn local_arc_length(&self, q: &[f64]) -> Option<f64> {
        let (s, span) = (self.start + q[S], self.axis.span());
        let within = (self.ends[0] || s >= span.start) && (self.ends[1] || s < span.end);
        within.then_some(s)
    }
}

impl Term for SlideConstraint {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.first..self.first + 3
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, k: usize) -> String {
        format!("position along {}", AXES[k])
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let Some(s) = self.local_arc_length(at.q) else { return };
        let (n, lambda) = (at.q.len(), Vector3::from_column_slice(at.lambda));
        let [r_b, tangent, _] = self.axis.at(at.q, s);
        let [weights, ..] = self.axis.weights(s);
        self.point.add(at.q, lambda, &mut r[..n]);
        for (&first, weight) in self.axis.vectors().iter().zip(weights) {
            (0..3).for_each(|k| r[first + k] -= weight * lambda[k]);
        }
        r[S] -= lambda.dot(&tangent);
        let apart = self.point.at(at.q) - r_b;
        (0..3).for_each(|k| r[n + k] += apart[k]);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let Some(s) = self.local_arc_length(at.q) else { return };
        let (n, lambda) = (at.q.len(), Vector3::from_column_slice(at.lambda));
        let [values, slopes, curvatures] = self.axis.weights(s);
        // The weights are cubic in s.
        let turn = f64::EPSILON * (self.start.abs() + at.q[S].abs());
        let of_value = |i: usize| 4.0 * (f64::EPSILON * values[i].abs() + turn * slopes[i].abs());
        let of_slope = |i: usize| 8.0 * (f64::EPSILON * slopes[i].abs() + turn * curvatures[i].abs());
        let [mut apart, _] = self.point.errors(at.q);
        for (i, &first) in self.axis.vectors().iter().enumerate() {
            let size = self.axis.size(i, at.q);
            apart += of_value(i) * size;
            floor[S] += of_slope(i) * size * lambda.norm();
            (0..3).for_each(|k| floor[first + k] += of_value(i) * lambda[k].abs());
        }
        match self.point.marker() {
            Some(point) => point.parts().iter().for_each(|&(first, w)| {
                (0..3).for_each(|k| floor[first + k] += f64::EPSILON * (w * lambda[k]).abs());
            }),
            None => self.point.add_errors(at.q, lambda.norm(), 0.0, floor),
        }
        floor[n..n + 3].iter_mut().for_each(|row| *row += apart);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let Some(s) = self.local_arc_length(at.q) else { return };
        let (n, lambda) = (at.q.len(), Vector3::from_column_slice(at.lambda));
        let [_, tangent, curvature] = self.axis.at(at.q, s);
        let [values, slopes, _] = self.axis.weights(s);
        for i in 0..3 {
            k.add(n + i, S, -tangent[i]);
            for (j, &first) in self.axis.vectors().iter().enumerate() {
                k.add(n + i, first + i, -values[j]);
                k.add(first + i, S, -w.q * slopes[j] * lambda[i]);
            }
        }
        k.add(S, S, -w.q * lambda.dot(&curvature));
        if let Some(point) = self.point.marker() {
            for &(first, weight) in point.parts() {
                (0..3).for_each(|i| k.add(n + i, first + i, weight));
            }
            return;
        }
        self.point.blocks(at.q, |first, block| {
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                k.add(n + i, first + j, block[(i, j)]);
            }
        });
        self.point.add_curvature(at.q, lambda * w.q, k);
    }

    /// In a step between two elements, forces are those of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        if [step.from, step.middle, step.to].iter().all(|at| self.local_arc_length(at.q).is_some()) {
            return discrete_residual(self, step, r);
        }
        middle_residual(self, step, r);
    }

    fn massless(&self) -> &[usize] {
        &self.coordinates[..=S]
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        let Some(s) = self.local_arc_length(at.q) else { return };
        let [r_b, tangent, curvature] = self.axis.at(at.q, s);
        let [velocity, turning, _] = self.axis.sum(at.v, s);
        let rate = at.v[S];
        let row = match level {
            Level::Position => self.point.at(at.q) - r_b,
            Level::Velocity => self.point.rate(at.q, at.v) - velocity - tangent * rate,
            Level::Acceleration => {
                self.point.rate_slope(at.q, at.v) - (turning * (2.0 * rate) + curvature * (rate * rate))
            }
        };
        (0..3).for_each(|k| phi[k] += row[k]);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let (s, span) = (self.start + at.q[S], self.axis.span());
        let slack = 1e-9 * (span.end - span.start);
        let is_admissible = !(self.ends[0] && s < span.start - slack || self.ends[1] && s > span.end + slack);
        (!is_admissible).then_some(Inadmissibility::SliderEnd)
    }
}
