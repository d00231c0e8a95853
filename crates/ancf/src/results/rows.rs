use ancf_mechanics::bodies::CarriedFrame;
use ancf_mechanics::constraints::Wrench;
use ancf_mechanics::elements::StrainEnergy;
use ancf_solver::equations::{Energy, Power, State};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use super::angle_counter::{AngleCounter, AngleHistory, AngleRates};
use super::body_motion;
use super::column::Column;
use super::powers;
use crate::assembly::Assembly;
use crate::model::Quantity;
use crate::units::{Dimension, Scales, UnitQuantity};

/// Columns of a run and their values in one state, in the user's units.
///
/// | columns | content |
/// |---|---|
/// | `t`, in statics `load` | time, load factor |
/// | `p.x p.y p.z`, `p.vx ..`, `p.ax ..` | motion of each probe `p`: position, velocity, acceleration |
/// | `p.e0 p.e1 p.e2 p.e3`, `p.wx p.wy p.wz` | Euler parameters of the rotation from the reference state, angular velocity |
/// | `p.imu_ax p.imu_ay p.imu_az`, `p.imu_wx ..` | acceleration less gravity and angular velocity along the axes of the section or the rigid body |
/// | `p.N p.Qy p.Qz p.T p.My p.Mz` | section forces: those of the part at larger arc lengths on the part at smaller ones |
/// | `p.exx p.eyy p.ezz p.exy p.exz p.eyz` | Green strain, in the section frame |
/// | `p.sxx ..` | second Piola-Kirchhoff stress |
/// | `p.nuu p.nvv p.nuv p.muu p.mvv p.muv` | membrane forces and moments per length of a shell |
/// | `p.suu_top p.svv_top p.suv_top p.suu_middle ..`, `p.von_mises` | stresses of a shell; largest equivalent stress of both faces |
/// | `j.fx j.fy j.fz`, `j.mx ..` | force and moment of each joint `j` on its end `a` |
/// | `j.angle j.rate` | revolute and cylindrical joints: angle of `a` about the axis, with whole turns, and its rate |
/// | `j.displacement j.speed` | prismatic and cylindrical joints: displacement along the axis, and its rate |
/// | `j.position j.speed` | slides: arc length from the start of the undeformed beam, and its rate |
/// | `g.volume g.pressure` | gases `g`: volume and absolute pressure |
/// | `j.length j.speed` | distance joints and springs: distance of the ends, and its rate |
/// | `b.axial b.bending b.shear b.torsion b.section b.volume` | strain energy of each body `b` by part, on request |
/// | `b.cx b.cy b.cz`, `b.px ..`, `b.lx ..`, `b.kinetic b.strain` | mass center, linear and angular momentum about the origin, energies of each body `b`, on request |
/// | `j.power`, `loads[0].power` | dynamics: power of each joint and load on the bodies, on request |
/// | `cx cy cz`, `px ..`, `lx ..` | mass center and momenta of the model, on request |
/// | `p.x_error ..`, `j.fx_error ..` | estimated errors, exact less computed, on request; NaN if they are not known |
/// | `iterations`, ... | solver values of each state |
/// | `kinetic`, `strain`, `potential` | energies; the potential energy is zero in the reference configuration |
/// | `work` | dynamics: work of prescribed motions, including velocity jumps, and of loads without potential, since the start |
/// | `dissipated` | dynamics: energy dissipated by damping, drag and friction since the start |
/// | `balance` | dynamics: total energy at the start, plus `work`, minus `dissipated`, minus total energy: the integration error |
#[derive(Debug)]
pub struct Rows {
    columns: Vec<Column>,
    row: Vec<f64>,
    scales: Scales,
    /// Total energy of the first state.
    initial: Option<f64>,
    angles: AngleCounter,
    /// First column of the errors, and the errors of the next row.
    first_error: usize,
    errors: Vec<f64>,
}

/// Values of earlier states on which a row depends.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct RowHistory {
    /// Total energy of the first state.
    initial: Option<f64>,
    angles: AngleHistory,
}

/// Indices of a symmetric matrix in the order of columns.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

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
const ERROR: &str = "_error";

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
fn error_columns(assembly: &Assembly) -> Vec<Column> {
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

impl Rows {
    /// Creates the columns of an assembly: the first one, those of probes and joints, `solver`, energies. `scales` are the units
    /// of the assembly.
    pub fn new(assembly: &Assembly, scales: Scales, first: &str, solver: &[&str]) -> Self {
        let columns = columns(assembly, first, solver);
        let count = error_columns(assembly).len();
        Self {
            first_error: columns.len() - count,
            errors: vec![f64::NAN; count],
            row: Vec::with_capacity(columns.len()),
            columns,
            scales,
            initial: None,
            angles: AngleCounter::new(assembly),
        }
    }

    /// Names of the columns.
    pub fn columns(&self) -> Vec<String> {
        self.columns.iter().map(|column| column.name.clone()).collect()
    }

    /// Computes the row of one state, in the user's units.
    ///
    /// `first` and `solver` are values of the first column and of the solver's columns, in the user's units. `energy` is the
    /// energy of the state. `exchanged` is the work and dissipation since the start, for dynamics. Both are in solver units.
    pub fn fill(
        &mut self,
        assembly: &Assembly,
        s: &State,
        first: f64,
        solver: &[f64],
        energy: Energy,
        exchanged: Option<Power>,
    ) -> &[f64] {
        self.row.clear();
        self.row.push(first);
        self.push_probes(assembly, s);
        for reaction in assembly.reactions(s) {
            self.extend(reaction.force, Dimension::FORCE);
            self.extend(reaction.moment, Dimension::ENERGY);
        }
        self.push_joint_coordinates(assembly, s);
        if assembly.output.energy_parts {
            for (_, body) in assembly.bodies() {
                let StrainEnergy { axial, bending, shear, torsion, section, volume } = body.strain_energy(s);
                for part in [axial, bending, shear, torsion, section, volume] {
                    self.push(part, Dimension::ENERGY);
                }
            }
        }
        body_motion::fill(assembly, s, &self.scales, &mut self.row);
        if exchanged.is_some() {
            powers::fill(assembly, s, &self.scales, &mut self.row);
        }
        self.row.extend(solver);
        for part in [energy.kinetic, energy.strain, energy.potential] {
            self.push(part, Dimension::ENERGY);
        }
        if let Some(Power { work, dissipation }) = exchanged {
            let initial = *self.initial.get_or_insert(energy.total());
            for part in [work, dissipation, initial + work - dissipation - energy.total()] {
                self.push(part, Dimension::ENERGY);
            }
        }
        self.row.extend(&self.errors);
        &self.row
    }

    /// Last row.
    pub(crate) fn last(&self) -> &[f64] {
        &self.row
    }

    /// Sets the errors of the next row by the columns of their values, in the order of the columns. Errors that are not given are
    /// not known.
    pub(crate) fn set_errors<'a>(&mut self, errors: impl IntoIterator<Item = (&'a str, f64)>) {
        let mut given = errors.into_iter().peekable();
        for (column, error) in self.columns[self.first_error..].iter().zip(&mut self.errors) {
            let is_own = |(value, _): &(&str, f64)| column.name.strip_suffix(ERROR) == Some(value);
            *error = given.next_if(is_own).map_or(f64::NAN, |(_, error)| error);
        }
    }

    /// Counts the turns of joint angles up to a state at the time, load factor or arc length `at`, in solver units. It must be
    /// called for the first state and after each accepted step, before the row of the state.
    pub(crate) fn count_turns(&mut self, at: f64, s: &State, rates: AngleRates) {
        self.angles.count(at, s, rates);
    }

    /// Sets the angles before the first state, by their columns.
    pub(crate) fn start_turns(&mut self, given: &[(String, f64)]) {
        self.angles.start(given);
    }

    /// Counts the next turns from the last angles, with another variable.
    pub(crate) fn restart_turns(&mut self) {
        self.angles.restart();
    }

    /// True if turns of joint angles are counted.
    pub(crate) fn counts_turns(&self) -> bool {
        !self.angles.is_empty()
    }

    /// First step with an ambiguous number of turns: its end, in solver units, and the name of the joint.
    pub(crate) fn ambiguous_turns(&self) -> Option<(f64, &str)> {
        self.angles.ambiguous()
    }

    /// Values of earlier states on which the next row depends.
    pub(crate) fn history(&self) -> RowHistory {
        RowHistory { initial: self.initial, angles: self.angles.history().clone() }
    }

    /// Restores the values of earlier states. Returns false if they belong to other columns.
    pub(crate) fn restore(&mut self, history: &RowHistory) -> bool {
        self.initial = history.initial;
        self.angles.restore(&history.angles)
    }

    fn push_probes(&mut self, assembly: &Assembly, s: &State) {
        let mut contacts = None;
        for probe in &assembly.recorded_quantities {
            match probe.quantity {
                Quantity::Motion => {
                    self.extend(probe.place.point.value(s), Dimension::LENGTH);
                    self.extend(probe.place.point.velocity(s), Dimension::VELOCITY);
                    self.extend(probe.place.point.acceleration(s), Dimension::ACCELERATION);
                }
                Quantity::Rotation => {
                    if let Some((parameters, velocity)) = probe.place.rotation(s) {
                        self.row.extend(parameters);
                        self.extend(velocity, Dimension::RATE);
                    }
                }
                Quantity::InertialSensor => {
                    if let Some(([w, x, y, z], velocity)) = probe.place.rotation(s) {
                        let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)).inverse();
                        let acceleration = probe.place.point.acceleration(s) - assembly.gravity;
                        self.extend(turn * acceleration, Dimension::ACCELERATION);
                        self.extend(turn * velocity, Dimension::RATE);
                    }
                }
                Quantity::SectionForces => {
                    let contacts = contacts.get_or_insert_with(|| assembly.contact_terms(s));
                    let mut frame = CarriedFrame::default();
                    let found = assembly.section_forces(probe.body, probe.s, s, contacts, &mut frame);
                    let Some(Wrench { force, moment }) = found else { continue };
                    self.extend(force, Dimension::FORCE);
                    self.extend(moment, Dimension::ENERGY);
                }
                Quantity::Resultants | Quantity::SurfaceStress => {
                    let body = assembly.body_of(probe.body);
                    let Some(found) = probe.surface.and_then(|at| body.surface_stress(s, at)) else {
                        continue;
                    };
                    if probe.quantity == Quantity::Resultants {
                        self.extend(found.force, Dimension::FORCE_PER_LENGTH);
                        self.extend(found.moment, Dimension::FORCE);
                    } else {
                        found.layers.iter().for_each(|layer| self.extend(*layer, Dimension::STRESS));
                        self.push(found.largest_von_mises(), Dimension::STRESS);
                    }
                }
                Quantity::Strain | Quantity::Stress => {
                    let Some(mesh) = assembly.body_of(probe.body).mesh() else { continue };
                    let [strain, stress] = mesh.strain_and_stress(s, probe.s, probe.offset);
                    if probe.quantity == Quantity::Strain {
                        self.push_entries(&strain, Dimension::NUMBER);
                    } else {
                        self.push_entries(&stress, Dimension::STRESS);
                    }
                }
            }
        }
    }

    fn push_joint_coordinates(&mut self, assembly: &Assembly, s: &State) {
        let Self { row, angles, scales, .. } = self;
        let mut counted = angles.values();
        for (_, coordinate) in assembly.joint_coordinates() {
            let [value, rate] = coordinate.at(s);
            let value = if coordinate.wraps() { counted.next().unwrap_or(value) } else { value };
            let [of_value, of_rate] = coordinate.dimensions();
            row.extend([value * scales.unit(of_value), rate * scales.unit(of_rate)]);
        }
    }

    fn push(&mut self, value: f64, of: Dimension) {
        self.row.push(value * self.scales.unit(of));
    }

    fn extend(&mut self, value: Vector3<f64>, of: Dimension) {
        let unit = self.scales.unit(of);
        self.row.extend(value.iter().map(|x| x * unit));
    }

    fn push_entries(&mut self, value: &Matrix3<f64>, of: Dimension) {
        ENTRIES.iter().for_each(|&at| self.push(value[at], of));
    }
}
