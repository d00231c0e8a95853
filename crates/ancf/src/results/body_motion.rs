//! Columns of the motion of whole bodies: mass centers, momenta and energies.

use ancf_mechanics::inertia::Momentum;
use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::column::Column;
use crate::assembly::Assembly;
use crate::units::{Dimension, Scales, UnitQuantity};

const VECTORS: [([&str; 3], Dimension); 3] = [
    (["cx", "cy", "cz"], Dimension::LENGTH),
    (["px", "py", "pz"], Dimension::MOMENTUM),
    (["lx", "ly", "lz"], Dimension::ANGULAR_MOMENTUM),
];
const ENERGIES: [&str; 2] = ["kinetic", "strain"];

/// Columns of each body and then of the model, none unless the model requests them.
pub(super) fn columns(assembly: &Assembly) -> Vec<Column> {
    let mut columns = Vec::new();
    if !assembly.output.momentum {
        return columns;
    }
    let vectors = || VECTORS.iter().flat_map(|(names, of)| names.iter().map(|name| (*name, *of)));
    for (body, _) in assembly.bodies() {
        columns.extend(vectors().map(|(name, of)| Column::new(format!("{body}.{name}"), of)));
        let energy = |name| Column::new(format!("{body}.{name}"), Dimension::ENERGY);
        columns.extend(ENERGIES.map(|name| energy(name).with_quantity(UnitQuantity::Energy)));
    }
    columns.extend(vectors().map(|(name, of)| Column::new(name, of)));
    columns
}

/// Appends the values of the columns in a state, in the user's units.
pub(super) fn fill(assembly: &Assembly, s: &State, scales: &Scales, row: &mut Vec<f64>) {
    if !assembly.output.momentum {
        return;
    }
    let mut sum = Momentum::default();
    for (_, body) in assembly.bodies() {
        let own = body.momentum(s);
        sum += own;
        row.extend(vectors(&own, scales));
        let energy = scales.unit(Dimension::ENERGY);
        row.extend([own.kinetic, body.strain_energy(s).total()].map(|value| value * energy));
    }
    row.extend(vectors(&sum, scales));
}

fn vectors(of: &Momentum, scales: &Scales) -> impl Iterator<Item = f64> {
    let values: [Vector3<f64>; 3] = [of.center(), of.linear, of.angular];
    let units = VECTORS.map(|(_, dimension)| scales.unit(dimension));
    values.into_iter().zip(units).flat_map(|(value, unit)| <[f64; 3]>::from(value * unit))
}
