use std::f64::consts::TAU;

use ancf_mechanics::bodies::{CarriedFrame, RodGap};
use ancf_solver::equations::State;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::gap_field::GapField;
use super::movement::{moved, sizes_of};
use crate::assembly::RecordedQuantity;
use crate::model::Quantity;
use crate::units::{Dimension, Scales};

/// Largest relative movement of the states between which values are differentiated.
const DIFFERENCE: f64 = 1e-4;
/// Displacement, relative to the largest one, below which a probe does not move.
const STILL: f64 = 1e-9;

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

/// Derivatives of all values along the response of the structure to the gaps.
pub(super) struct ValueErrors<'a> {
    field: &'a GapField<'a>,
    scales: Scales,
    /// States moved by ± h times the response.
    states: [State; 2],
    h: f64,
    rotation: f64,
}

impl<'a> ValueErrors<'a> {
    pub(super) fn new(field: &'a GapField<'a>, response: &[f64], scales: Scales) -> Self {
        let (state, sizes) = (field.state, sizes_of(field.assembly, field.state, response));
        let largest = sizes[0].max(sizes[1]);
        let h = if largest > 0.0 { DIFFERENCE / largest } else { 1.0 };
        let states = [-h, h].map(|h| moved(state, response, h));
        Self { field, scales, states, h, rotation: sizes[1] }
    }

    /// Largest rotation of the response.
    pub(super) fn rotation(&self) -> f64 {
        self.rotation
    }

    fn unit(&self, of: Dimension) -> f64 {
        self.scales.unit(of)
    }

    /// Errors of all columns, and the largest relative error of the displacement of a probe.
    pub(super) fn evaluate(mut self) -> (Vec<ValueError>, Option<ProbeError>) {
        let (mut values, mut displacements) = (Vec::new(), Vec::new());
        let field = self.field;
        for probe in &field.assembly.recorded_quantities {
            let Some(of_probe) = self.of_probe(probe) else { continue };
            if probe.quantity == Quantity::Motion {
                let unit = self.unit(Dimension::LENGTH);
                displacements.push((
                    probe.place.point.displacement(field.state) * unit,
                    of_probe.clone(),
                    probe,
                ));
            }
            values.extend(of_probe);
        }
        values.extend(self.of_joints());
        (values, largest_error(&displacements))
    }

    /// Errors of the columns of a probe; `None` for strains, stresses and quantities that it does not have.
    fn of_probe(&mut self, probe: &RecordedQuantity) -> Option<Vec<ValueError>> {
        let field = self.field;
        let Some(body) = field.body(probe.body) else { return self.of_quantity(probe, &RodGap::default()) };
        let (element, xi) = body.mesh.locate(probe.s);
        let gap = if xi == 0.0 {
            RodGap::default()
        } else if xi == 1.0 {
            *body.gap(element)
        } else {
            field.gap_at(probe.body, element, xi)?
        };
        // The element moves by the response less the gap at its end.
        let w = body.mesh.gap_displacement(field.state, element, body.gap(element));
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
        let (name, state) = (&probe.name, self.field.state);
        match probe.quantity {
            Quantity::Motion => {
                let point = &probe.place.point;
                let [before, after] = self.states.each_ref().map(|s| point.value(s));
                let arm = self.field.body(probe.body).map_or_else(Vector3::zeros, |body| {
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
            Quantity::Strain | Quantity::Stress => None,
        }
    }

    fn of_section_forces(&self, probe: &RecordedQuantity, gap: &RodGap) -> Option<Vec<ValueError>> {
        let field = self.field;
        let at = |s: &State| {
            let mut carried = CarriedFrame::default();
            field.assembly.section_forces(probe.body, probe.s, s, &field.contacts, &mut carried)
        };
        let [before, after] = self.states.each_ref().map(at);
        let (before, after, now) = (before?, after?, at(field.state)?);
        let axes = field.body(probe.body)?.mesh.section_frame(field.state, probe.s);
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
        let (assembly, state) = (self.field.assembly, self.field.state);
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

/// Largest error of a displacement, relative to the displacement.
fn largest_error(displacements: &[(Vector3<f64>, Vec<ValueError>, &RecordedQuantity)]) -> Option<ProbeError> {
    let largest = displacements.iter().map(|(moved, ..)| moved.norm()).fold(0.0, f64::max);
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
    let moving =
        displacements.iter().filter(|(moved, ..)| moved.norm() > STILL * largest && moved.norm() > 0.0);
    moving.map(error_of).max_by(|a, b| a.relative.total_cmp(&b.relative))
}
