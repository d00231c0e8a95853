use std::ops::Range;

use ancf_solver::equations::{
    Level, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual, middle_residual,
    quadratic_constraints,
};
use nalgebra::Vector3;

use super::bilinear_row::{BilinearRow, QuadraticConstraint};
use super::constraint_group::GroupedConstraint;
use super::wrench::Wrench;
use crate::kinematics::BodyVector;

/// Names of the global axes.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// Describes a body-fixed direction by its reference value.
pub(crate) fn direction(reference: Vector3<f64>) -> String {
    let unit = reference.try_normalize(0.0).unwrap_or(reference);
    let along = (0..3).find(|&k| unit[k].abs() > 1.0 - 1e-9);
    match along {
        Some(k) => format!("direction {}", AXES[k]),
        None => format!("direction ({:.3}, {:.3}, {:.3})", unit.x, unit.y, unit.z),
    }
}

/// Three linear equations that keep a − b at its reference value, for two points or two directions.
///
/// Φ = (a − a₀) − (b − b₀), and Φ_qᵀ λ applies λ to a and −λ to b. Points may have a gap g = b₀ − a₀ in the reference
/// state. The gap is kept, or closed by Φ = a − b, or closed with the load factor s by Φ = (a − a₀) − (b − b₀) − s g.
///
/// Units: those of the markers; λ is a force for points and a moment for directions.
#[derive(Clone, Debug)]
pub struct CoincidenceConstraint {
    global: BodyVector,
    a: BodyVector,
    b: BodyVector,
    coordinates: Vec<usize>,
    first: usize,
    direction: bool,
    /// Removed part of the reference gap.
    gap: Vector3<f64>,
    /// True if the gap is multiplied by the load factor.
    by_load: bool,
}

impl CoincidenceConstraint {
    /// Constrains two points. Uses the three multipliers from `first`.
    pub fn points(a: impl Into<BodyVector>, b: impl Into<BodyVector>, first: usize) -> Self {
        Self::new(a.into(), b.into(), first, false)
    }

    /// Moves a point to a ground point with the load factor. Uses the three multipliers from `first`.
    pub fn toward(a: impl Into<BodyVector>, target: Vector3<f64>, first: usize) -> Self {
        Self::points(a, BodyVector::fixed(target), first).closed_by_load()
    }

    /// Closes the reference gap of the points.
    #[must_use]
    pub fn closed(self) -> Self {
        Self { gap: self.gap(), by_load: false, ..self }
    }

    /// Keeps the reference gap of the points.
    #[must_use]
    pub fn kept(self) -> Self {
        Self { gap: Vector3::zeros(), by_load: false, ..self }
    }

    /// Returns the reference gap b₀ − a₀.
    pub fn gap(&self) -> Vector3<f64> {
        self.b.reference() - self.a.reference()
    }

    /// Closes the reference gap in proportion to the load factor.
    #[must_use]
    pub fn closed_by_load(self) -> Self {
        Self { gap: self.gap(), by_load: true, ..self }
    }

    /// Constrains two directions. Uses the three multipliers from `first`.
    pub fn directions(a: impl Into<BodyVector>, b: impl Into<BodyVector>, first: usize) -> Self {
        Self::new(a.into(), b.into(), first, true)
    }

    /// Returns true for points and false for directions.
    pub const fn is_of_points(&self) -> bool {
        !self.direction
    }

    fn new(a: BodyVector, b: BodyVector, first: usize, direction: bool) -> Self {
        let coordinates = BodyVector::union_coordinates([&a, &b]);
        let (local_a, local_b) = (a.within(&coordinates), b.within(&coordinates));
        let (gap, by_load) = (Vector3::zeros(), false);
        Self { global: a, a: local_a, b: local_b, coordinates, first, direction, gap, by_load }
    }

    /// Copies the constraint as a part of a group, if both vectors are linear in the coordinates.
    pub fn grouped(&self) -> Option<GroupedConstraint> {
        GroupedConstraint::new(self)
    }

    /// Returns the removed part of the gap at a load factor.
    fn removed_gap(&self, load: f64) -> Vector3<f64> {
        if self.by_load { self.gap * load } else { self.gap }
    }

    /// Returns the contribution to the joint reaction on the body of marker a.
    ///
    /// It is the force −λ for a point, or the moment a × (−λ) for a direction.
    pub fn reaction(&self, s: &State) -> Wrench {
        let force = -Vector3::from_column_slice(&s.lambda[self.first..self.first + 3]);
        if self.direction {
            Wrench { moment: self.global.value(s).cross(&force), ..Wrench::default() }
        } else {
            Wrench { force, ..Wrench::default() }
        }
    }
}

impl QuadraticConstraint for CoincidenceConstraint {
    fn rows(&self) -> Option<Vec<BilinearRow>> {
        let signed = |vector: &BodyVector, sign: f64| {
            let parts = vector.marker()?.parts().iter();
            Some(parts.map(|&(first, w)| (first, sign * w)).collect::<Vec<_>>())
        };
        let mut parts = signed(&self.a, 1.0)?;
        for (first, w) in signed(&self.b, -1.0)? {
            // Points of one body share vectors.
            match parts.iter_mut().find(|(known, _)| *known == first) {
                Some((_, sum)) => *sum += w,
                None => parts.push((first, w)),
            }
        }
        let row = |k: usize| BilinearRow {
            linear: parts.iter().map(|(first, w)| (first + k, *w)).collect(),
            offset: if self.by_load { [0.0, self.gap[k]] } else { [self.gap[k], 0.0] },
            ..BilinearRow::default()
        };
        Some((0..3).map(row).collect())
    }
}

impl Term for CoincidenceConstraint {
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
        let what = if self.direction { direction(self.a.reference()) } else { "position".to_owned() };
        format!("{what} along {}", AXES[k])
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (rows, equations) = r.split_at_mut(at.q.len());
        let lambda = Vector3::from_column_slice(at.lambda);
        self.a.add(at.q, lambda, rows);
        self.b.add(at.q, -lambda, rows);
        let apart = self.a.change(at.q) - self.b.change(at.q) - self.removed_gap(at.load);
        for (row, apart) in equations.iter_mut().zip(&apart) {
            *row += apart;
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (rows, equations) = floor.split_at_mut(at.q.len());
        for (row, gap) in equations.iter_mut().zip(&self.removed_gap(at.load)) {
            *row += f64::EPSILON * gap.abs();
        }
        for vector in [&self.a, &self.b] {
            let Some(marker) = vector.marker() else {
                let force = Vector3::from_column_slice(at.lambda).norm();
                vector.add_errors(at.q, force, 0.0, rows);
                let [_, error] = vector.errors(at.q);
                equations.iter_mut().for_each(|row| *row += error);
                continue;
            };
            for &(first, w) in marker.parts() {
                for k in 0..3 {
                    rows[first + k] += f64::EPSILON * (w * at.lambda[k]).abs();
                    equations[k] += f64::EPSILON * (w * at.q[first + k]).abs();
                }
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, weights: Weights, k: &mut LocalMatrix<'_>) {
        let n = at.q.len();
        for (vector, sign) in [(&self.a, 1.0), (&self.b, -1.0)] {
            if let Some(marker) = vector.marker() {
                for &(first, w) in marker.parts() {
                    (0..3).for_each(|i| k.add(n + i, first + i, sign * w));
                }
                continue;
            }
            vector.blocks(at.q, |first, block| {
                for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                    k.add(n + i, first + j, sign * block[(i, j)]);
                }
            });
            vector.add_curvature(at.q, Vector3::from_column_slice(at.lambda) * (sign * weights.q), k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        if self.a.is_linear() && self.b.is_linear() {
            return middle_residual(self, step, r);
        }
        discrete_residual(self, step, r);
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        if self.a.is_linear() && self.b.is_linear() {
            return quadratic_constraints(self, at, level, phi);
        }
        let row = match level {
            Level::Position => self.a.change(at.q) - self.b.change(at.q) - self.removed_gap(at.load),
            Level::Velocity => self.a.rate(at.q, at.v) - self.b.rate(at.q, at.v),
            Level::Acceleration => self.a.rate_slope(at.q, at.v) - self.b.rate_slope(at.q, at.v),
        };
        (0..3).for_each(|k| phi[k] += row[k]);
    }
}
