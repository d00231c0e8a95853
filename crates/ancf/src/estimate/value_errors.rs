use std::f64::consts::TAU;
use std::sync::Arc;

use ancf_mechanics::bodies::{CarriedFrame, RodGap};
use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::finer::surface_values;
use super::gap_field::{BodyGaps, GapField};
use super::movement::{moved, sizes_of};
use crate::assembly::{Assembly, RecordedQuantity};
use crate::model::Quantity;
use crate::units::{Dimension, Scales};

/// Largest relative movement of the states between which values are differentiated.
const DIFFERENCE: f64 = 1e-4;
/// Displacement, relative to the largest one of the model, below which a probe does not move.
pub(super) const STILL: f64 = 1e-9;

/// Dimensions of forces and moments.
const WRENCH: [Dimension; 2] = [Dimension::FORCE, Dimension::ENERGY];

/// Estimated discretisation error of a value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ValueError {
    /// Column of the results.
    pub column: String,
    /// Computed value.
    pub value: f64,
    /// Estimate of the exact value less the computed one: value + error is a better value.
    pub error: f64,
}

/// Error of the displacement of a probe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProbeError {
    /// Name of the probe.
    pub probe: String,
    /// Size of the error, relative to the displacement.
    pub relative: f64,
    /// Component of the error along the displacement, relative to the displacement: positive if the displacement is too small.
    pub along: f64,
    /// Column with the largest error.
    pub column: String,
    /// Its value.
    pub value: f64,
    /// Its error.
    pub error: f64,
}

/// Derivatives of all values along the error of a state.
pub(super) struct ValueErrors<'a> {
    assembly: &'a Assembly,
    state: &'a State,
    contacts: &'a [Arc<dyn Term>],
    /// Gaps whose response the error is.
    gaps: Option<&'a GapField<'a>>,
    scales: Scales,
    /// States moved by ± h times the error.
    states: [State; 2],
    h: f64,
    rotation: f64,
}

impl<'a> ValueErrors<'a> {
    /// Creates the derivatives along the response (q, λ) of the structure to gaps.
    pub(super) fn new(field: &'a GapField<'a>, response: &[f64], scales: Scales) -> Self {
        let error = |h: f64| moved(field.state, response, h);
        let sizes = sizes_of(field.assembly, field.state, response);
        Self::along((field.assembly, field.state, &field.contacts), Some(field), scales, (sizes, error))
    }

    /// Creates the derivatives along the error of a motion. `gaps` are those of the mesh, `None` for the error of the time steps.
    pub(super) fn in_motion(
        (assembly, state, contacts): (&'a Assembly, &'a State, &'a [Arc<dyn Term>]),
        gaps: Option<&'a GapField<'a>>,
        error: &State,
        scales: Scales,
    ) -> Self {
        let sizes = sizes_of(assembly, state, &error.q);
        let changed = |h: f64| {
            let mut changed = state.clone();
            changed.add_multiple(error, h);
            changed
        };
        Self::along((assembly, state, contacts), gaps, scales, (sizes, changed))
    }

    fn along(
        (assembly, state, contacts): (&'a Assembly, &'a State, &'a [Arc<dyn Term>]),
        gaps: Option<&'a GapField<'a>>,
        scales: Scales,
        (sizes, moved): ([f64; 2], impl Fn(f64) -> State),
    ) -> Self {
        let largest = sizes[0].max(sizes[1]);
        let h = if largest > 0.0 { DIFFERENCE / largest } else { 1.0 };
        let states = [-h, h].map(moved);
        Self { assembly, state, contacts, gaps, scales, states, h, rotation: sizes[1] }
    }

    /// Gaps of a body.
    fn gaps_of(&self, body: usize) -> Option<&'a BodyGaps<'a>> {
        self.gaps.and_then(|gaps| gaps.body(body))
    }

    /// Largest rotation of the response.
    pub(super) fn rotation(&self) -> f64 {
        self.rotation
    }

    fn unit(&self, of: Dimension) -> f64 {
        self.scales.unit(of)
    }

    /// Errors of all columns, and the largest relative error of the displacement of a probe.
    pub(super) fn evaluate(&mut self) -> (Vec<ValueError>, Option<ProbeError>) {
        let (mut values, mut displacements) = (Vec::new(), Vec::new());
        let (assembly, state) = (self.assembly, self.state);
        for probe in &assembly.recorded_quantities {
            let Some(of_probe) = self.of_probe(probe) else { continue };
            if probe.quantity == Quantity::Motion {
                let unit = self.unit(Dimension::LENGTH);
                displacements.push((probe.place.point.displacement(state) * unit, of_probe.clone(), probe));
            }
            values.extend(of_probe);
        }
        values.extend(self.of_joints());
        let moved = assembly.displacement(&assembly.rest(), state) * self.unit(Dimension::LENGTH);
        (values, largest_error(&displacements, STILL * moved))
    }

    /// Errors of the columns of a probe; `None` for strains, stresses and quantities that it does not have.
    fn of_probe(&mut self, probe: &RecordedQuantity) -> Option<Vec<ValueError>> {
        let state = self.state;
        let Some(body) = self.gaps_of(probe.body) else { return self.of_quantity(probe, &RodGap::default()) };
        let (element, xi) = body.mesh.locate(probe.s);
        let gap = if xi == 0.0 {
            RodGap::default()
        } else if xi == 1.0 {
            *body.gap(element)
        } else {
            self.gaps?.gap_at(probe.body, element, xi)?
        };
        // The element moves by the response less the gap at its end.
        let w = body.mesh.gap_displacement(state, element, body.gap(element));
        let first = body.mesh.first_coordinate_of(element);
        let mut kept: Vec<Vec<f64>> = Vec::new();
        for (state, h) in self.states.iter_mut().zip([-self.h, self.h]) {
            let own = &mut state.q[first..first + w.len()];
            kept.push(own.to_vec());
            own.iter_mut().zip(&w).for_each(|(q, w)| *q -= h * w);
        }
        let errors = self.of_quantity(probe, &gap);
        for (state, kept) in self.states.iter_mut().zip(kept) {
            state.q[first..first + w.len()].copy_from_slice(&kept);
        }
        errors
    }

    /// Errors of a quantity: its derivative along the movement of the element, and the gap at the probe.
    fn of_quantity(&self, probe: &RecordedQuantity, gap: &RodGap) -> Option<Vec<ValueError>> {
        let (name, state) = (&probe.name, self.state);
        match probe.quantity {
            Quantity::Motion => {
                let point = &probe.place.point;
                let [before, after] = self.states.each_ref().map(|s| point.value(s));
                let arm = self.gaps_of(probe.body).map_or_else(Vector3::zeros, |body| {
                    point.value(state) - body.mesh.point(probe.s).value(state)
                });
                let error = (after - before) / (2.0 * self.h) + gap.translation + gap.rotation.cross(&arm);
                let unit = self.unit(Dimension::LENGTH);
                Some(columns(name, ["x", "y", "z"], point.value(state) * unit, error * unit))
            }
            Quantity::Rotation => {
                let [before, after] = self.states.each_ref().map(|s| probe.place.rotation(s).map(|(e, _)| e));
                let (before, after) = (before?, after?);
                let (now, _) = probe.place.rotation(state)?;
                let same: f64 = before.iter().zip(after).map(|(a, b)| a * b).sum::<f64>().signum();
                let (scalar, vector) = (now[0], Vector3::new(now[1], now[2], now[3]));
                let turned = gap.rotation * scalar + gap.rotation.cross(&vector);
                let of_gap = [-gap.rotation.dot(&vector), turned.x, turned.y, turned.z];
                let value = |k: usize| ValueError {
                    column: format!("{name}.e{k}"),
                    value: now[k],
                    error: (after[k] - same * before[k]) / (2.0 * self.h) + 0.5 * of_gap[k],
                };
                Some((0..4).map(value).collect())
            }
            Quantity::SectionForces => self.of_section_forces(probe, gap),
            Quantity::Resultants | Quantity::SurfaceStress => self.of_surface(probe),
            Quantity::Strain | Quantity::Stress | Quantity::InertialSensor => None,
        }
    }

    fn of_surface(&self, probe: &RecordedQuantity) -> Option<Vec<ValueError>> {
        let values = |state| surface_values(self.assembly, probe, state, self.scales);
        let ((names, now), [before, after]) = (values(self.state)?, self.states.each_ref().map(values));
        let (changes, now) = (after?.1.into_iter().zip(before?.1), names.iter().zip(now));
        let error = |((name, value), (after, before)): ((&&str, f64), (f64, f64))| ValueError {
            column: format!("{}.{name}", probe.name),
            value,
            error: (after - before) / (2.0 * self.h),
        };
        Some(now.zip(changes).map(error).collect())
    }

    fn of_section_forces(&self, probe: &RecordedQuantity, gap: &RodGap) -> Option<Vec<ValueError>> {
        let Self { assembly, state, contacts, .. } = *self;
        let at = |s: &State| {
            let mut carried = CarriedFrame::default();
            assembly.section_forces(probe.body, probe.s, s, contacts, &mut carried)
        };
        let [before, after] = self.states.each_ref().map(at);
        let (before, after, now) = (before?, after?, at(state)?);
        let axes = assembly.body_of(probe.body).mesh()?.section_frame(state, probe.s);
        let seen = |x: Vector3<f64>| Vector3::from(axes.map(|axis| axis.dot(&x)));
        let (turn, shift, more) = (seen(gap.rotation), seen(gap.translation), seen(gap.moment));
        let force = (after.force - before.force) / (2.0 * self.h) + now.force.cross(&turn);
        let moment = (after.moment - before.moment) / (2.0 * self.h) + now.moment.cross(&turn)
            - shift.cross(&now.force)
            + more;
        let [of_force, of_moment] = WRENCH.map(|of| self.unit(of));
        let mut errors = columns(&probe.name, ["N", "Qy", "Qz"], now.force * of_force, force * of_force);
        errors.extend(columns(&probe.name, ["T", "My", "Mz"], now.moment * of_moment, moment * of_moment));
        Some(errors)
    }

    /// Errors of reactions and joint coordinates.
    fn of_joints(&self) -> Vec<ValueError> {
        let Self { assembly, state, .. } = *self;
        let [before, after] = &self.states;
        let [of_force, of_moment] = WRENCH.map(|of| self.unit(of));
        let mut errors = Vec::new();
        let all = assembly.joints().zip(assembly.reactions(state)).zip(assembly.reactions(before));
        for (((name, now), before), after) in all.zip(assembly.reactions(after)) {
            let force = (after.force - before.force) / (2.0 * self.h);
            let moment = (after.moment - before.moment) / (2.0 * self.h);
            errors.extend(columns(name, ["fx", "fy", "fz"], now.force * of_force, force * of_force));
            errors.extend(columns(name, ["mx", "my", "mz"], now.moment * of_moment, moment * of_moment));
        }
        for (joint, coordinate) in assembly.joint_coordinates() {
            let ([column, _], [of_value, _]) = (coordinate.columns(), coordinate.dimensions());
            let [now, before, after] = [state, before, after].map(|s| coordinate.at(s)[0]);
            let change = after - before;
            let turns = if coordinate.wraps() { (change / TAU).round() * TAU } else { 0.0 };
            let unit = self.unit(of_value);
            let error = (change - turns) / (2.0 * self.h) * unit;
            errors.push(ValueError { column: format!("{joint}.{column}"), value: now * unit, error });
        }
        errors
    }
}

/// Errors of three columns.
fn columns(owner: &str, names: [&str; 3], value: Vector3<f64>, error: Vector3<f64>) -> Vec<ValueError> {
    let one =
        |k: usize| ValueError { column: format!("{owner}.{}", names[k]), value: value[k], error: error[k] };
    (0..3).map(one).collect()
}

/// Largest error of a displacement of a probe, relative to the displacement. Probes with displacements up to `least` do not move.
pub(super) fn largest_error(
    displacements: &[(Vector3<f64>, Vec<ValueError>, &RecordedQuantity)],
    least: f64,
) -> Option<ProbeError> {
    let error_of = |(moved, errors, probe): &(Vector3<f64>, Vec<ValueError>, &RecordedQuantity)| {
        let (error, size) = (Vector3::from_fn(|k, _| errors[k].error), moved.norm());
        let worst = &errors[error.iamax()];
        ProbeError {
            probe: probe.name.clone(),
            relative: error.norm() / size,
            along: error.dot(moved) / (size * size),
            column: worst.column.clone(),
            value: worst.value,
            error: worst.error,
        }
    };
    let moving = displacements.iter().filter(|(moved, ..)| moved.norm() > least);
    moving.map(error_of).max_by(|a, b| a.relative.total_cmp(&b.relative))
}
