use super::body_motion;
use super::column::Column;
use super::powers;
use crate::assembly::Assembly;
use crate::model::Quantity;
use crate::units::{Dimension, UnitQuantity};

/// Columns of the membrane forces and moments of a shell.
pub(crate) const RESULTANTS: [&str; 6] = ["nuu", "nvv", "nuv", "muu", "mvv", "muv"];
/// Columns of the stresses of a shell.
pub(crate) const SURFACE_STRESS: [&str; 10] = [
    "suu_top",
    "svv_top",
    "suv_top",
    "suu_middle",
    "svv_middle",
    "suv_middle",
    "suu_bottom",
    "svv_bottom",
    "suv_bottom",
    "von_mises",
];

/// Name of the first column of dynamics.
pub(crate) const TIME: &str = "t";
/// Name of the first column of statics and paths.
pub(crate) const LOAD: &str = "load";

/// Suffix of the columns of errors.
pub(super) const ERROR: &str = "_error";

/// Columns of [`Rows`].
pub(crate) fn columns(assembly: &Assembly, first: &str, solver: &[&str]) -> Vec<Column> {
    let of_first = if first == TIME { Dimension::TIME } else { Dimension::NUMBER };
    let mut columns = vec![Column::new(first, of_first)];
    for probe in &assembly.recorded_quantities {
        columns.extend(columns_of_probe(&probe.name, probe.quantity));
    }
    for name in assembly.joints() {
        columns.extend(columns_of_reaction(name));
    }
    for (joint, coordinate) in assembly.joint_coordinates() {
        let pairs = coordinate.columns().into_iter().zip(coordinate.dimensions());
        let quantity = coordinate.quantity();
        let columns_of = |(column, dimension)| Column::of(joint, [column], dimension);
        columns.extend(pairs.flat_map(columns_of).map(|column| column.with_quantity(quantity)));
    }
    if assembly.output.energy_parts {
        let parts = ["axial", "bending", "shear", "torsion", "section", "volume"];
        let energies = assembly.bodies().flat_map(|(body, _)| Column::of(body, parts, Dimension::ENERGY));
        columns.extend(energies.map(|column| column.with_quantity(UnitQuantity::Energy)));
    }
    columns.extend(body_motion::columns(assembly));
    if first == TIME {
        columns.extend(powers::columns(assembly));
    }
    columns.extend(solver.iter().map(|&name| Column::new(name, None)));
    // Statics has no time history, so no energy balance.
    let balance: &[&str] = if first == TIME { &["work", "dissipated", "balance"] } else { &[] };
    let energies = ["kinetic", "strain", "potential"].iter().chain(balance);
    let energy = |name| Column::new(name, Dimension::ENERGY).with_quantity(UnitQuantity::Energy);
    columns.extend(energies.map(|&name| energy(name)));
    columns.extend(error_columns(assembly));
    columns
}

/// Columns of the estimated errors of positions, rotations, section forces, stresses of shells, reactions and joint coordinates.
pub(super) fn error_columns(assembly: &Assembly) -> Vec<Column> {
    if !assembly.output.errors {
        return Vec::new();
    }
    let mut values = Vec::new();
    for probe in &assembly.recorded_quantities {
        let count = match probe.quantity {
            Quantity::Motion => 3,
            Quantity::Rotation => 4,
            Quantity::SectionForces | Quantity::Resultants => 6,
            Quantity::SurfaceStress => SURFACE_STRESS.len(),
            Quantity::Strain | Quantity::Stress | Quantity::InertialSensor => 0,
        };
        values.extend(columns_of_probe(&probe.name, probe.quantity).into_iter().take(count));
    }
    values.extend(assembly.joints().flat_map(columns_of_reaction));
    for (joint, coordinate) in assembly.joint_coordinates() {
        let ([name, _], [dimension, _]) = (coordinate.columns(), coordinate.dimensions());
        let quantity = coordinate.quantity();
        values
            .extend(Column::of(joint, [name], dimension).into_iter().map(|one| one.with_quantity(quantity)));
    }
    values.into_iter().map(|value| Column { name: value.name + ERROR, ..value }).collect()
}

fn columns_of_reaction(joint: &str) -> Vec<Column> {
    let force = Column::of(joint, ["fx", "fy", "fz"], Dimension::FORCE);
    [force, Column::of(joint, ["mx", "my", "mz"], Dimension::ENERGY)].concat()
}

fn columns_of_probe(name: &str, quantity: Quantity) -> Vec<Column> {
    let of = |names: &[&'static str], dimension| Column::of(name, names.iter().copied(), dimension);
    match quantity {
        Quantity::Motion => [
            of(&["x", "y", "z"], Dimension::LENGTH),
            of(&["vx", "vy", "vz"], Dimension::VELOCITY),
            of(&["ax", "ay", "az"], Dimension::ACCELERATION),
        ]
        .concat(),
        Quantity::Rotation => {
            let rates = of(&["wx", "wy", "wz"], Dimension::RATE).into_iter();
            let rates = rates.map(|rate| rate.with_quantity(UnitQuantity::Angle)).collect();
            [of(&["e0", "e1", "e2", "e3"], Dimension::NUMBER), rates].concat()
        }
        Quantity::SectionForces => {
            [of(&["N", "Qy", "Qz"], Dimension::FORCE), of(&["T", "My", "Mz"], Dimension::ENERGY)].concat()
        }
        Quantity::Strain => of(&["exx", "eyy", "ezz", "exy", "exz", "eyz"], Dimension::NUMBER),
        Quantity::Stress => of(&["sxx", "syy", "szz", "sxy", "sxz", "syz"], Dimension::STRESS),
        Quantity::InertialSensor => {
            let rates = of(&["imu_wx", "imu_wy", "imu_wz"], Dimension::RATE).into_iter();
            let rates = rates.map(|rate| rate.with_quantity(UnitQuantity::Angle)).collect();
            [of(&["imu_ax", "imu_ay", "imu_az"], Dimension::ACCELERATION), rates].concat()
        }
        Quantity::Resultants => {
            [of(&RESULTANTS[..3], Dimension::FORCE_PER_LENGTH), of(&RESULTANTS[3..], Dimension::FORCE)]
                .concat()
        }
        Quantity::SurfaceStress => of(&SURFACE_STRESS, Dimension::STRESS),
    }
}
