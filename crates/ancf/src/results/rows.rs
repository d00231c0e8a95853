use std::sync::Arc;

use ancf_mechanics::bodies::CarriedFrame;
use ancf_mechanics::constraints::Wrench;
use ancf_mechanics::elements::StrainEnergy;
use ancf_solver::equations::{Energy, Power, State, Term};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use super::angle_counter::{AngleCounter, AngleHistory, AngleRates};
use super::body_motion;
use super::column::Column;
use super::powers;
use super::row_columns::{ERROR, columns, error_columns};
use crate::assembly::{Assembly, RecordedQuantity};
use crate::model::Quantity;
use crate::units::{Dimension, Scales};

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
    /// Start of the step before the next row, if its accelerations and multipliers are those of the step.
    step_start: Option<State>,
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
            step_start: None,
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
        let start = self.step_start.take();
        let start = start.as_ref();
        self.push_probes(assembly, start, s);
        let mut before = start.map(|start| assembly.reactions(start));
        for reaction in assembly.reactions(s) {
            self.push_wrench(before.as_mut().and_then(Iterator::next), reaction);
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
            powers::fill(assembly, start, s, &self.scales, &mut self.row);
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

    /// Sets the start of the step before the next row, if its accelerations and multipliers are those of the step.
    pub(crate) fn set_step_start(&mut self, start: Option<State>) {
        self.step_start = start;
    }

    /// Counts the turns of joint angles up to a state at the time, load factor or arc length `at`, in solver units. It must be
    /// called for the first state and after each accepted step, before the row of the state.
    pub(crate) fn count_turns(&mut self, at: f64, s: &State, rates: AngleRates) {
        self.angles.count(at, s, rates);
    }

    /// Angles with their full turns that a state determines up to them.
    pub(crate) fn counted_angles(&self) -> impl Iterator<Item = f64> {
        self.angles.values()
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

    /// Appends the values of the probes in a state. With the start of the step before, forces and accelerations are means of both ends.
    fn push_probes(&mut self, assembly: &Assembly, start: Option<&State>, s: &State) {
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
                    let sensed = |s: &State| sensed(assembly, probe, s);
                    if let Some([acceleration, rate]) = sensed(s) {
                        let before = start.and_then(sensed).map(|[before, _]| before);
                        self.extend(mean(before, acceleration), Dimension::ACCELERATION);
                        self.extend(rate, Dimension::RATE);
                    }
                }
                Quantity::SectionForces => {
                    let (contacts, before) = contacts.get_or_insert_with(|| {
                        (assembly.contact_terms(s), start.map(|start| (start, assembly.contact_terms(start))))
                    });
                    let at = |s: &State, contacts: &[Arc<dyn Term>]| {
                        let mut frame = CarriedFrame::default();
                        assembly.section_forces(probe.body, probe.s, s, contacts, &mut frame)
                    };
                    let Some(found) = at(s, contacts) else { continue };
                    let before = before.as_ref().and_then(|(start, contacts)| at(start, contacts));
                    self.push_wrench(before, found);
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
                    let [strain, stress] = mesh.strain_and_stress(s, probe.s, (probe.offset, probe.warping));
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

    /// Appends a force and moment; with those at the start of the step, their mean.
    fn push_wrench(&mut self, before: Option<Wrench>, Wrench { force, moment }: Wrench) {
        self.extend(mean(before.map(|before| before.force), force), Dimension::FORCE);
        self.extend(mean(before.map(|before| before.moment), moment), Dimension::ENERGY);
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

/// Acceleration less gravity and angular velocity along the axes of the section or the rigid body of a probe.
fn sensed(assembly: &Assembly, probe: &RecordedQuantity, s: &State) -> Option<[Vector3<f64>; 2]> {
    let ([w, x, y, z], velocity) = probe.place.rotation(s)?;
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)).inverse();
    Some([turn * (probe.place.point.acceleration(s) - assembly.gravity), turn * velocity])
}

/// Mean of a vector at both ends of a step, or the vector at its end.
fn mean(before: Option<Vector3<f64>>, end: Vector3<f64>) -> Vector3<f64> {
    before.map_or(end, |before| (before + end) * 0.5)
}
