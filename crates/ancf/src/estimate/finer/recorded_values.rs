use std::f64::consts::TAU;

use ancf_mechanics::bodies::CarriedFrame;
use ancf_solver::equations::State;
use nalgebra::Vector3;

use crate::assembly::{Assembly, RecordedQuantity};
use crate::model::Quantity;
use crate::results::{RESULTANTS, SURFACE_STRESS};
use crate::units::{Dimension, Scales};

/// Value of a column whose error is estimated.
struct RecordedValue {
    column: String,
    value: f64,
    /// Compared value: the displacement for a position, otherwise the value.
    compared: f64,
    kind: Kind,
}

/// Kind of a recorded value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Displacement, force or coordinate, with the order of convergence of displacements.
    Plain,
    /// Angle with an unknown number of turns.
    Angle,
    /// Euler parameter: all four have either sign.
    EulerParameter,
    /// Value of the derivatives of displacements.
    Derivative,
}

/// Value on a mesh, and its change on a finer one.
pub(in crate::estimate) struct ValueChange {
    pub(in crate::estimate) column: String,
    pub(in crate::estimate) value: f64,
    pub(in crate::estimate) change: f64,
    /// True for forces and stresses that follow from derivatives of displacements.
    pub(in crate::estimate) is_derivative: bool,
}

/// Values of all columns whose errors are estimated, in a state, in the order of the columns.
pub(in crate::estimate) struct RecordedValues<'a> {
    assembly: &'a Assembly,
    state: &'a State,
    scales: Scales,
    values: Vec<RecordedValue>,
}

impl<'a> RecordedValues<'a> {
    /// Evaluates the values of probes, reactions and joint coordinates.
    pub(in crate::estimate) fn new(assembly: &'a Assembly, state: &'a State, scales: Scales) -> Self {
        let mut values = Self { assembly, state, scales, values: Vec::new() };
        assembly.recorded_quantities.iter().for_each(|probe| values.push_probe(probe));
        for (joint, reaction) in assembly.joints().zip(assembly.reactions(state)) {
            values.push_vector(joint, ["fx", "fy", "fz"], reaction.force, Dimension::FORCE);
            values.push_vector(joint, ["mx", "my", "mz"], reaction.moment, Dimension::ENERGY);
        }
        for (joint, coordinate) in assembly.joint_coordinates() {
            let ([column, _], [of_value, _]) = (coordinate.columns(), coordinate.dimensions());
            let kind = if coordinate.wraps() { Kind::Angle } else { Kind::Plain };
            values.push(joint, column, coordinate.at(state)[0] * scales.unit(of_value), kind);
        }
        values
    }

    /// Changes from the values on a coarser mesh. Positions change by the displacements.
    pub(in crate::estimate) fn changes_from(&self, coarse: &Self) -> Vec<ValueChange> {
        let (mut changes, mut sign) = (Vec::new(), 1.0);
        for (k, (given, fine)) in coarse.values.iter().zip(&self.values).enumerate() {
            if given.kind == Kind::EulerParameter && given.column.ends_with(".e0") {
                let four = coarse.values[k..].iter().zip(&self.values[k..]).take(4);
                sign = four.map(|(a, b)| a.value * b.value).sum::<f64>().signum();
            }
            let change = match given.kind {
                Kind::EulerParameter => sign * fine.value - given.value,
                Kind::Angle => {
                    let change = fine.value - given.value;
                    change - (change / TAU).round() * TAU
                }
                Kind::Plain | Kind::Derivative => fine.compared - given.compared,
            };
            let is_derivative = given.kind == Kind::Derivative;
            changes.push(ValueChange {
                column: given.column.clone(),
                value: given.value,
                change,
                is_derivative,
            });
        }
        changes
    }

    fn push(&mut self, owner: &str, name: &str, value: f64, kind: Kind) {
        let column = format!("{owner}.{name}");
        self.values.push(RecordedValue { column, value, compared: value, kind });
    }

    fn push_vector(&mut self, owner: &str, names: [&str; 3], vector: Vector3<f64>, of: Dimension) {
        let unit = self.scales.unit(of);
        (0..3).for_each(|k| self.push(owner, names[k], vector[k] * unit, Kind::Plain));
    }

    fn push_probe(&mut self, probe: &RecordedQuantity) {
        let Self { assembly, state, scales, .. } = *self;
        match probe.quantity {
            Quantity::Motion => {
                let unit = scales.unit(Dimension::LENGTH);
                let point = &probe.place.point;
                let (value, displacement) = (point.value(state) * unit, point.displacement(state) * unit);
                for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
                    let (column, kind) = (format!("{}.{axis}", probe.name), Kind::Plain);
                    self.values.push(RecordedValue {
                        column,
                        value: value[k],
                        compared: displacement[k],
                        kind,
                    });
                }
            }
            Quantity::Rotation => {
                let Some((parameters, _)) = probe.place.rotation(state) else { return };
                let names = ["e0", "e1", "e2", "e3"].into_iter().zip(parameters);
                names.for_each(|(name, value)| self.push(&probe.name, name, value, Kind::EulerParameter));
            }
            Quantity::SectionForces => {
                let (contacts, mut frame) = (assembly.contact_terms(state), CarriedFrame::default());
                let found = assembly.section_forces(probe.body, probe.s, state, &contacts, &mut frame);
                let Some(found) = found else { return };
                self.push_vector(&probe.name, ["N", "Qy", "Qz"], found.force, Dimension::FORCE);
                self.push_vector(&probe.name, ["T", "My", "Mz"], found.moment, Dimension::ENERGY);
            }
            Quantity::Resultants | Quantity::SurfaceStress => self.push_surface(probe),
            Quantity::Strain | Quantity::Stress | Quantity::InertialSensor => {}
        }
    }

    /// Adds the section forces per length or the stresses of a shell.
    fn push_surface(&mut self, probe: &RecordedQuantity) {
        let Some((names, values)) = surface_values(self.assembly, probe, self.state, self.scales) else {
            return;
        };
        let named = names.iter().zip(values);
        named.for_each(|(name, value)| self.push(&probe.name, name, value, Kind::Derivative));
    }
}

/// Names and values of the section forces per length or the stresses of a shell at a probe, in the user's units.
pub(in crate::estimate) fn surface_values(
    assembly: &Assembly,
    probe: &RecordedQuantity,
    state: &State,
    scales: Scales,
) -> Option<(&'static [&'static str], Vec<f64>)> {
    let found = assembly.body_of(probe.body).surface_stress(state, probe.surface?)?;
    if probe.quantity == Quantity::Resultants {
        let [force, moment] = [Dimension::FORCE_PER_LENGTH, Dimension::FORCE].map(|of| scales.unit(of));
        let values = found.force.iter().map(|n| n * force).chain(found.moment.iter().map(|m| m * moment));
        return Some((&RESULTANTS, values.collect()));
    }
    let stress = scales.unit(Dimension::STRESS);
    let layers = found.layers.iter().flat_map(|layer| layer.iter().copied());
    Some((&SURFACE_STRESS, layers.chain([found.largest_von_mises()]).map(|x| x * stress).collect()))
}
