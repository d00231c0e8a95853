use std::ops::Range;

use ancf_mechanics::bodies::{BeamMesh, BodyTerms, ShellPlace};
use ancf_mechanics::constraints::Wrench;
use ancf_mechanics::kinematics::{Attachment, BodyVector, VectorKind};
use ancf_mechanics::shells::{ShearShellMesh, ShellMesh};
use ancf_solver::equations::{EquationsOfMotion, State, System};
use ancf_solver::newton::{SolveError, SolveFailure};
use nalgebra::Vector3;

use super::inputs::{Inputs, NoNumber};
use super::loads::InnerLoads;
use super::redundancy::Redundancy;
use crate::errors::short;
use crate::joints::{GapClosure, JointEquations, RecordedCoordinate};
use crate::model::{Output, Quantity};

/// Distance from a restart, relative to the step, within which a state is that of the restart.
const RESTART: f64 = 1e-6;

/// Equations of motion of a model, with the data to evaluate their solution.
#[derive(Debug)]
pub struct Assembly {
    /// Equations of motion.
    pub system: System,
    /// Names and points of the probes.
    pub probes: Vec<(String, BodyVector)>,
    /// Quantities that the probes record.
    pub recorded_quantities: Vec<RecordedQuantity>,
    /// Content of the output.
    pub output: Output,
    pub(crate) bodies: Vec<(String, BodyTerms)>,
    pub(crate) joints: Vec<JointEquations>,
    pub(crate) couplings: Vec<String>,
    pub(crate) redundancy: Redundancy,
    pub(crate) closed: Option<GapClosure>,
    pub(crate) breaks: Vec<f64>,
    pub(crate) inputs: Inputs,
    pub(crate) inner_loads: InnerLoads,
    pub(crate) owned: OwnedTerms,
    /// Acceleration of gravity.
    pub(crate) gravity: Vector3<f64>,
    /// Start and step of a motion by an energy-momentum scheme.
    pub(crate) averaged: Option<[f64; 2]>,
}

/// Terms of the system of each joint and load, in the order of the model.
#[derive(Clone, Debug, Default)]
pub(crate) struct OwnedTerms {
    pub(crate) joints: Vec<Range<usize>>,
    pub(crate) loads: Vec<Range<usize>>,
}

/// One quantity that a probe records.
#[derive(Debug)]
pub struct RecordedQuantity {
    /// Name of the probe.
    pub name: String,
    /// Recorded quantity.
    pub quantity: Quantity,
    /// Attachment at the point of the probe.
    pub place: Attachment,
    /// Index of the body.
    pub body: usize,
    /// Arc length.
    pub s: f64,
    /// Coordinates (y, z) in the section.
    pub offset: [f64; 2],
    /// Gradient of the warping function there.
    pub warping: [f64; 2],
    /// Place on a shell.
    pub surface: Option<ShellPlace>,
}

impl Assembly {
    /// Rows of the residual whose constraints keep a given state in statics: those of drives by a rate.
    pub(crate) fn held_rows(&self) -> Vec<usize> {
        let first = self.system.coordinates();
        self.joints
            .iter()
            .flat_map(|joint| joint.held.iter().map(move |multiplier| first + multiplier))
            .collect()
    }

    /// Start of the nominal step before a recorded state of an energy-momentum scheme, whose accelerations and multipliers are those of the
    /// step. `None` for other schemes, at the start and at jumps of loads.
    pub(crate) fn step_start(&self, s: &State) -> Option<State> {
        let [start, step] = self.averaged?;
        let is_restart =
            std::iter::once(&start).chain(&self.breaks).any(|t| (s.t - t).abs() < RESTART * step);
        (!is_restart).then(|| s.start_of_step(step))
    }

    /// Reference configuration at rest.
    pub fn rest(&self) -> State {
        State::rest(self.system.coordinates(), self.system.multipliers())
    }

    /// Largest displacement of nodes and centres between two states.
    pub(crate) fn displacement(&self, from: &State, to: &State) -> f64 {
        let pairs = self.bodies().flat_map(|(_, body)| body.vectors(from).into_iter().zip(body.vectors(to)));
        let moved = pairs.filter(|(vector, _)| vector.is_position()).map(|(a, b)| (b.value - a.value).norm());
        moved.fold(0.0, f64::max)
    }

    /// Largest rotation of a direction between two states, in rad. A change of its length counts as a rotation.
    pub(crate) fn turn(&self, from: &State, to: &State) -> f64 {
        let pairs = self.bodies().flat_map(|(_, body)| body.vectors(from).into_iter().zip(body.vectors(to)));
        let directions =
            pairs.filter(|(vector, _)| !vector.is_position() && vector.kind != VectorKind::Twist);
        let chord = directions.map(|(a, b)| (b.value - a.value).norm() / a.value.norm()).fold(0.0, f64::max);
        2.0 * (0.5 * chord).min(1.0).asin()
    }

    /// Returns a joint whose ends have another orientation than in the reference state, although its equations hold.
    pub(crate) fn misaligned(&self, s: &State) -> Option<&str> {
        self.joints.iter().find(|joint| !joint.is_aligned(s)).map(|joint| joint.name.as_str())
    }

    /// Returns the failure of a state that a term does not admit, such as a driven hinge, whose equations also hold half a turn from its
    /// angle.
    pub(crate) fn inadmissible(&self, s: &State) -> Option<SolveError> {
        let (worst, reason) = self.system.inadmissible(s)?;
        let failure = SolveFailure::Inadmissible(reason);
        Some(SolveError { worst: Some(worst), ..SolveError::at(s.t, failure) })
    }

    /// Names of the joints.
    pub fn joints(&self) -> impl Iterator<Item = &str> {
        self.with_reactions().map(|joint| joint.name.as_str())
    }

    /// Reaction of each joint in a state: force and moment on its end `a`.
    pub fn reactions<'a>(&'a self, s: &'a State) -> impl Iterator<Item = Wrench> + 'a {
        self.with_reactions().map(|joint| joint.reaction(s))
    }

    /// Joints, without the gases.
    fn with_reactions(&self) -> impl Iterator<Item = &JointEquations> {
        self.joints.iter().filter(|joint| joint.is_joint())
    }

    /// Recorded coordinates of the joints and gases, with their names.
    pub fn joint_coordinates(&self) -> impl Iterator<Item = (&str, &RecordedCoordinate)> {
        self.joints
            .iter()
            .flat_map(|joint| joint.recorded.iter().map(|coordinate| (joint.name.as_str(), coordinate)))
    }

    /// Bodies with their names.
    pub fn bodies(&self) -> impl Iterator<Item = (&str, &BodyTerms)> {
        self.bodies.iter().map(|(name, body)| (name.as_str(), body))
    }

    /// Body of an index, which [`RecordedQuantity`] contains.
    pub fn body_of(&self, number: usize) -> &BodyTerms {
        &self.bodies[number].1
    }

    /// Times at which loads and drives or their rates jump, in ascending order. Time steps should end there.
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// Mesh of a flexible body.
    pub fn mesh(&self, body: &str) -> Option<&BeamMesh> {
        self.bodies.iter().find(|(name, _)| name == body).and_then(|(_, body)| body.mesh())
    }

    /// Mesh of a shear-deformable shell.
    pub fn shear_shell(&self, body: &str) -> Option<&ShearShellMesh> {
        self.bodies.iter().find(|(name, _)| name == body).and_then(|(_, body)| body.shear_shell())
    }

    /// Mesh of a thin shell.
    pub fn shell(&self, body: &str) -> Option<&ShellMesh> {
        self.bodies.iter().find(|(name, _)| name == body).and_then(|(_, body)| body.shell())
    }

    /// Description of the owner of an equation: a node of a body, or a joint.
    pub fn name_of(&self, equation: usize) -> String {
        self.name_in(equation, 1.0)
    }

    /// Description of the place of a failed iteration, with arc lengths as in [`name_in`](Self::name_in).
    pub(crate) fn place_of(&self, error: &SolveError, length: f64) -> String {
        error.worst.map_or_else(|| "the whole system".into(), |worst| self.name_in(worst, length))
    }

    /// Description of the owner of an equation. Arc lengths of nodes are multiplied by `length`, the unit of length of the assembly.
    pub(crate) fn name_in(&self, equation: usize, length: f64) -> String {
        let mut first = 0;
        for (name, body) in &self.bodies {
            if let Some((node, kind)) = body.locate_coordinate(equation) {
                let axis = ["x", "y", "z"][(equation - first) % 3];
                return match node {
                    Some(node) if let Some(mesh) = body.shell() => {
                        let [u, v] = mesh.node_place(node).map(short);
                        format!("shell `{name}`, node at [{u}, {v}], {} along {axis}", tangent(kind))
                    }
                    Some(node) if body.is_shell() => {
                        let vector = if kind == VectorKind::Position { "r" } else { "d" };
                        format!("shell `{name}`, node {node}, {vector} along {axis}")
                    }
                    Some(node) => {
                        let s = short(length * body.arc_length(node));
                        format!("body `{name}`, node {node} (s = {s}), {} along {axis}", word(kind))
                    }
                    None => format!("body `{name}`, {} along {axis}", director(kind)),
                };
            }
            first += body.coordinates();
        }
        for joint in &self.joints {
            if equation < first + joint.coordinates.len() {
                return joint.owner_of_coordinate();
            }
            first += joint.coordinates.len();
        }
        for (name, body) in &self.bodies {
            if equation < first + body.multipliers() {
                return format!("body `{name}`, rigidity constraint");
            }
            first += body.multipliers();
        }
        for joint in &self.joints {
            if equation < first + joint.multipliers.len() {
                return joint.owner_of_multiplier(equation - first);
            }
            first += joint.multipliers.len();
        }
        match self.couplings.get(equation.wrapping_sub(first)) {
            Some(name) => format!("coupling `{name}`"),
            None => format!("equation {equation}"),
        }
    }

    /// Initial state at rest: the reference configuration, or the configuration with closed gaps.
    pub fn initial(&self) -> State {
        self.closed.as_ref().map_or_else(|| self.rest(), |closed| State { load: 1.0, ..closed.state.clone() })
    }

    /// Closure of gaps, if the model requests it.
    pub fn closed(&self) -> Option<&GapClosure> {
        self.closed.as_ref()
    }

    /// First function of the user with a value that is not finite at the time of a state.
    pub(crate) fn no_number(&self, s: &State) -> Option<NoNumber> {
        self.inputs.no_number(s)
    }
}

/// Word of a nodal vector.
const fn word(kind: VectorKind) -> &'static str {
    match kind {
        VectorKind::Position => "r",
        VectorKind::Slope => "r_x",
        VectorKind::Y => "r_y",
        VectorKind::Z => "r_z",
        VectorKind::Twist => "r_uv",
    }
}

/// Word of a nodal vector of a shell.
const fn tangent(kind: VectorKind) -> &'static str {
    match kind {
        VectorKind::Position => "r",
        VectorKind::Slope => "r_u",
        VectorKind::Y => "r_v",
        VectorKind::Z | VectorKind::Twist => "r_uv",
    }
}

/// Word of a vector of a rigid body.
const fn director(kind: VectorKind) -> &'static str {
    match kind {
        VectorKind::Position => "its centre",
        VectorKind::Slope => "its first director",
        VectorKind::Y => "its second director",
        VectorKind::Z | VectorKind::Twist => "its third director",
    }
}
