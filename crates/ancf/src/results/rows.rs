use std::f64::consts::TAU;

use ancf_mechanics::constraints::Wrench;
use ancf_mechanics::elements::StrainEnergy;
use ancf_solver::equations::{Energy, Power, State};
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::model::Quantity;
use crate::units::{Dimension, Scales, Units};

/// The columns of a run, and their values in one state, in the user's units.
///
/// | columns | what |
/// |---|---|
/// | `t`, in statics `load` | time, load factor |
/// | `p.x p.y p.z`, `p.vx ..`, `p.ax ..` | motion of each probe `p`: position, velocity, acceleration |
/// | `p.e0 p.e1 p.e2 p.e3`, `p.wx p.wy p.wz` | Euler parameters of its rotation since the reference state, angular velocity |
/// | `p.N p.Qy p.Qz p.T p.My p.Mz` | its section forces, as the part beyond exerts them on the part before |
/// | `p.exx p.eyy p.ezz p.exy p.exz p.eyz` | its strain, Green's, in the section's frame |
/// | `p.sxx ..` | its stress, second Piola-Kirchhoff |
/// | `j.fx j.fy j.fz`, `j.mx ..` | force and moment that each joint `j` exerts on its end `a` |
/// | `j.angle j.rate` | of hinges and sleeves: angle of `a` about the axis, counted on over whole turns, and its rate |
/// | `j.displacement j.speed` | of sliders: displacement along the axis, and its rate |
/// | `j.position j.speed` | of slides: arc length from the start of the undeformed beam, and its rate |
/// | `j.length j.speed` | of rods and springs: distance of the ends, and its rate |
/// | `b.axial b.bending b.shear b.torsion b.section b.volume` | strain energy of each body `b` by part, if asked for |
/// | `iterations`, ... | what the analysis says of each state |
/// | `kinetic`, `strain`, `potential` | energies; the potential is zero in the reference configuration |
/// | `work` | of motions: supplied since the start by prescribed motions, their blows included, and by loads without potential |
/// | `dissipated` | of motions: lost since the start by damping, drag and friction |
/// | `balance` | of motions: total energy at the start, plus `work`, less `dissipated`, less that of the state: the error of the integration |
#[derive(Debug)]
pub struct Rows {
    columns: Vec<Column>,
    row: Vec<f64>,
    scales: Scales,
    parts: bool,
    past: Past,
}

/// What a row takes from those before it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Past {
    /// Total energy of the first state.
    initial: Option<f64>,
    /// Angles of the row before, by coordinate.
    angles: Vec<f64>,
}

/// A column of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// The dimension of its numbers; none of what has no unit of the user, such as a residual.
    pub dimension: Option<Dimension>,
}

impl Column {
    pub(crate) fn new(name: impl Into<String>, dimension: impl Into<Option<Dimension>>) -> Self {
        Self { name: name.into(), dimension: dimension.into() }
    }

    /// The unit of its numbers, `1` of pure ones; none of what has no unit of the user.
    pub fn unit(&self, units: &Units) -> Option<String> {
        let unit = units.of(self.dimension?);
        Some(if unit.is_empty() { "1".to_owned() } else { unit })
    }

    /// Columns under the name of what they are about.
    fn of<'a>(owner: &str, names: impl IntoIterator<Item = &'a str>, dimension: Dimension) -> Vec<Self> {
        names.into_iter().map(|name| Self::new(format!("{owner}.{name}"), dimension)).collect()
    }
}

/// Places of a symmetric matrix in columns.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Name of the first column of a motion.
pub(crate) const TIME: &str = "t";
/// Name of the first column of equilibria.
pub(crate) const LOAD: &str = "load";

/// The columns of [`Rows`].
pub(crate) fn columns(assembly: &Assembly, first: &str, own: &[&str]) -> Vec<Column> {
    let of_first = if first == TIME { Dimension::TIME } else { Dimension::NUMBER };
    let mut columns = vec![Column::new(first, of_first)];
    for probe in &assembly.measures {
        columns.extend(columns_of_probe(&probe.name, probe.quantity));
    }
    for name in assembly.joints() {
        columns.extend(Column::of(name, ["fx", "fy", "fz"], Dimension::FORCE));
        columns.extend(Column::of(name, ["mx", "my", "mz"], Dimension::ENERGY));
    }
    for (joint, coordinate) in assembly.joint_coordinates() {
        let pairs = coordinate.columns().into_iter().zip(coordinate.dimensions());
        columns.extend(pairs.flat_map(|(column, dimension)| Column::of(joint, [column], dimension)));
    }
    if assembly.energy_parts {
        let parts = ["axial", "bending", "shear", "torsion", "section", "volume"];
        columns.extend(assembly.bodies().flat_map(|(body, _)| Column::of(body, parts, Dimension::ENERGY)));
    }
    columns.extend(own.iter().map(|&name| Column::new(name, None)));
    // Equilibria have no history that could be booked.
    let books: &[&str] = if first == TIME { &["work", "dissipated", "balance"] } else { &[] };
    let energies = ["kinetic", "strain", "potential"].iter().chain(books);
    columns.extend(energies.map(|&name| Column::new(name, Dimension::ENERGY)));
    columns
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
            [of(&["e0", "e1", "e2", "e3"], Dimension::NUMBER), of(&["wx", "wy", "wz"], Dimension::RATE)]
                .concat()
        }
        Quantity::SectionForces => {
            [of(&["N", "Qy", "Qz"], Dimension::FORCE), of(&["T", "My", "Mz"], Dimension::ENERGY)].concat()
        }
        Quantity::Strain => of(&["exx", "eyy", "ezz", "exy", "exz", "eyz"], Dimension::NUMBER),
        Quantity::Stress => of(&["sxx", "syy", "szz", "sxy", "sxz", "syz"], Dimension::STRESS),
    }
}

impl Rows {
    /// Columns of an assembly whose numbers are in the given units: the first, those of probes and joints, `own`, energies.
    pub fn new(assembly: &Assembly, scales: Scales, first: &str, own: &[&str]) -> Self {
        let columns = columns(assembly, first, own);
        Self {
            row: Vec::with_capacity(columns.len()),
            columns,
            scales,
            parts: assembly.energy_parts,
            past: Past { initial: None, angles: vec![0.0; assembly.joint_coordinates().count()] },
        }
    }

    /// Names of the columns.
    pub fn columns(&self) -> Vec<String> {
        self.columns.iter().map(|column| column.name.clone()).collect()
    }

    /// The row of one state, with the value of the first column and of the analysis's own, in the user's units; `energy` is that
    /// of the state and `exchanged`, of motions, what was supplied and dissipated so far, in those of the solver.
    pub fn fill(
        &mut self,
        assembly: &Assembly,
        s: &State,
        first: f64,
        own: &[f64],
        energy: Energy,
        exchanged: Option<Power>,
    ) -> &[f64] {
        self.row.clear();
        self.row.push(first);
        self.measure(assembly, s);
        for reaction in assembly.reactions(s) {
            self.extend(reaction.force, Dimension::FORCE);
            self.extend(reaction.moment, Dimension::ENERGY);
        }
        self.joint_coordinates(assembly, s);
        if self.parts {
            for (_, body) in assembly.bodies() {
                let StrainEnergy { axial, bending, shear, torsion, section, volume } = body.strain_energy(s);
                for part in [axial, bending, shear, torsion, section, volume] {
                    self.push(part, Dimension::ENERGY);
                }
            }
        }
        self.row.extend(own);
        for part in [energy.kinetic, energy.strain, energy.potential] {
            self.push(part, Dimension::ENERGY);
        }
        if let Some(Power { work, dissipation }) = exchanged {
            let initial = *self.past.initial.get_or_insert(energy.total());
            for part in [work, dissipation, initial + work - dissipation - energy.total()] {
                self.push(part, Dimension::ENERGY);
            }
        }
        &self.row
    }

    /// What the next row takes from those so far.
    pub(crate) fn past(&self) -> &Past {
        &self.past
    }

    /// Goes on after other rows; returns false if they are not of these columns.
    pub(crate) fn go_on(&mut self, past: &Past) -> bool {
        let fits = past.angles.len() == self.past.angles.len();
        if fits {
            self.past.clone_from(past);
        }
        fits
    }

    fn measure(&mut self, assembly: &Assembly, s: &State) {
        for probe in &assembly.measures {
            match probe.quantity {
                Quantity::Motion => {
                    self.extend(probe.place.point.value(s), Dimension::LENGTH);
                    self.extend(probe.place.point.sum(&s.v), Dimension::VELOCITY);
                    self.extend(probe.place.point.sum(&s.a), Dimension::ACCELERATION);
                }
                Quantity::Rotation => {
                    if let Some((parameters, velocity)) = probe.place.rotation(s) {
                        self.row.extend(parameters);
                        self.extend(velocity, Dimension::RATE);
                    }
                }
                Quantity::SectionForces => {
                    let Some(mesh) = assembly.body_of(probe.body).mesh() else { continue };
                    let Wrench { force, moment } = mesh.section_forces(s, probe.s);
                    self.extend(force, Dimension::FORCE);
                    self.extend(moment, Dimension::ENERGY);
                }
                Quantity::Strain | Quantity::Stress => {
                    let Some(mesh) = assembly.body_of(probe.body).mesh() else { continue };
                    let [strain, stress] = mesh.strain_and_stress(s, probe.s, probe.offset);
                    if probe.quantity == Quantity::Strain {
                        self.entries(&strain, Dimension::NUMBER);
                    } else {
                        self.entries(&stress, Dimension::STRESS);
                    }
                }
            }
        }
    }

    fn joint_coordinates(&mut self, assembly: &Assembly, s: &State) {
        for (k, (_, coordinate)) in assembly.joint_coordinates().enumerate() {
            let [mut value, rate] = coordinate.at(s);
            if coordinate.wraps() {
                value += TAU * ((self.past.angles[k] - value) / TAU).round();
                self.past.angles[k] = value;
            }
            let [of_value, of_rate] = coordinate.dimensions();
            self.push(value, of_value);
            self.push(rate, of_rate);
        }
    }

    fn push(&mut self, value: f64, of: Dimension) {
        self.row.push(value * self.scales.unit(of));
    }

    fn extend(&mut self, value: Vector3<f64>, of: Dimension) {
        let unit = self.scales.unit(of);
        self.row.extend(value.iter().map(|x| x * unit));
    }

    fn entries(&mut self, value: &Matrix3<f64>, of: Dimension) {
        ENTRIES.iter().for_each(|&at| self.push(value[at], of));
    }
}
