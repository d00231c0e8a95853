use ancf_mechanics::kinematics::{NodalVector, VectorKind};
use ancf_solver::equations::State;
use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::errors::{ModelError, ModelErrors, quoted};
use crate::joints::RecordedCoordinate;
use crate::units::{Dimension, Scales};

/// State given for the start of a motion, by body and joint, in the user's units.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenState {
    /// Description of the origin, for messages and reports.
    source: String,
    bodies: Vec<GivenBody>,
    joints: Vec<GivenJoint>,
    /// Angles with their full turns, by their columns. The structure at the start may have them as coordinates or not.
    angles: Vec<(String, f64)>,
}

/// Nodal vectors of a body in the order of its coordinates.
#[derive(Clone, Debug, PartialEq)]
struct GivenBody {
    name: String,
    vectors: Vec<GivenVector>,
}

/// Nodal vector: a position, or a derivative relative to the magnitude of its reference value or of that of a tangent.
#[derive(Clone, Debug, PartialEq)]
struct GivenVector {
    is_position: bool,
    reference: Vector3<f64>,
    /// Change from the reference value. Strains are computed from it, so it is not the difference of two positions.
    change: Vector3<f64>,
    rate: Vector3<f64>,
}

/// Coordinates of a joint with their rates.
#[derive(Clone, Debug, PartialEq)]
struct GivenJoint {
    name: String,
    coordinates: Vec<[f64; 2]>,
    /// Coordinates of states of force laws with their rates.
    states: Vec<[f64; 2]>,
}

/// Description of a joint with another number of coordinates.
fn of_joint(what: &str, [given, own]: [usize; 2], name: &str) -> String {
    format!("{given} {what} of joint {}, not {own}", quoted(name))
}

/// Relative difference of reference values up to which structures are equal.
const EQUAL: f64 = 1e-9;

impl GivenState {
    /// State of an assembly in solver units with their scales.
    pub(crate) fn new(assembly: &Assembly, scales: Scales, state: &State, source: String) -> Self {
        let rest = assembly.rest();
        let bodies = assembly.bodies().map(|(name, body)| {
            let vectors = body.vectors(&rest);
            let pairs = vectors.iter().zip(units(&vectors, scales));
            let vectors = pairs.map(|(vector, unit)| GivenVector::new(vector, unit, scales, state));
            GivenBody { name: name.to_owned(), vectors: vectors.collect() }
        });
        let joints = assembly.joints.iter().map(|joint| {
            let unit = |c| unit_of_coordinate(assembly, c, scales);
            let value = |c: usize| [state.q[c] * unit(c), state.v[c] * unit(c) / scales.time];
            GivenJoint {
                name: joint.name.clone(),
                coordinates: joint.free_coordinates().map(value).collect(),
                states: joint.states.iter().copied().map(value).collect(),
            }
        });
        let recorded = assembly.joint_coordinates();
        let angles = recorded.filter(|(_, own)| own.is_angle() && own.coordinate.is_some());
        let value = |(joint, own): (&str, &RecordedCoordinate)| (own.column(joint), own.at(state)[0]);
        Self {
            source,
            bodies: bodies.collect(),
            joints: joints.collect(),
            angles: angles.map(value).collect(),
        }
    }

    /// Adds the values of angles with their full turns, by their columns ([`Simulation::counted_angles`](crate::Simulation::counted_angles)).
    #[must_use]
    pub fn with_angles(mut self, angles: impl IntoIterator<Item = (String, f64)>) -> Self {
        self.angles.extend(angles);
        self
    }

    /// Angles with their full turns.
    pub(crate) fn angles(&self) -> &[(String, f64)] {
        &self.angles
    }

    /// Description of the origin.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// State of an assembly of the same structure, at t = 0 in solver units with their scales.
    ///
    /// # Errors
    /// If bodies or coordinates of joints differ.
    pub(crate) fn state(&self, assembly: &Assembly, scales: Scales) -> Result<State, ModelErrors> {
        let mut s = assembly.rest();
        let rest = s.clone();
        if let Some(surplus) =
            self.bodies.iter().find(|body| assembly.bodies().all(|(name, _)| name != body.name))
        {
            return Err(self.mismatch(format!("a further body {}", quoted(&surplus.name))));
        }
        for (name, body) in assembly.bodies() {
            let given = self.bodies.iter().find(|given| given.name == name);
            let given = given.ok_or_else(|| self.mismatch(format!("no body {}", quoted(name))))?;
            let vectors = body.vectors(&rest);
            if let Some(difference) = given.difference(&vectors, scales) {
                return Err(self.mismatch(format!("{difference} body {}", quoted(name))));
            }
            let units = units(&vectors, scales);
            for ((vector, unit), given) in vectors.iter().zip(units).zip(&given.vectors) {
                given.write(vector.first, unit, scales, &mut s);
            }
        }
        for joint in assembly.joints.iter().filter(|joint| !joint.coordinates.is_empty()) {
            // The coordinates of a new joint follow from the projection of the positions.
            let Some(given) = self.joints.iter().find(|given| given.name == joint.name) else { continue };
            let own: Vec<usize> = joint.free_coordinates().collect();
            if given.coordinates.len() != own.len() {
                let counts = [given.coordinates.len(), own.len()];
                return Err(self.mismatch(of_joint("coordinates", counts, &joint.name)));
            }
            let counts = [given.states.len(), joint.states.len()];
            if counts[0] != counts[1] && !counts.contains(&0) {
                return Err(self.mismatch(of_joint("states of force laws", counts, &joint.name)));
            }
            // States exist in motions only; without given ones they have their values at the start.
            let coordinates = own.iter().zip(&given.coordinates);
            for (&c, [value, rate]) in coordinates.chain(joint.states.iter().zip(&given.states)) {
                let unit = unit_of_coordinate(assembly, c, scales);
                (s.q[c], s.v[c]) = (value / unit, rate / unit * scales.time);
            }
        }
        Ok(s)
    }

    fn mismatch(&self, found: String) -> ModelErrors {
        let found = format!("{}, which has {found}", self.source);
        let error = ModelError::new("initial.from", found, "a state of the same structure");
        ModelErrors(vec![error.hint(
            "bodies, elements and formulations must be equal, and drives, springs, friction and couplings of joints that both models \
             have; materials, sections, loads, further joints and the analysis may differ",
        )])
    }
}

/// User's units of the coordinates of an assembly: lengths, magnitudes of reference directions, and those of joints.
pub(crate) fn coordinate_units(assembly: &Assembly, scales: Scales) -> Vec<f64> {
    let rest = assembly.rest();
    let mut all = vec![1.0; rest.q.len()];
    for (_, body) in assembly.bodies() {
        let vectors = body.vectors(&rest);
        for (vector, unit) in vectors.iter().zip(units(&vectors, scales)) {
            all[vector.first..vector.first + 3].fill(unit);
        }
    }
    for c in assembly.joints.iter().flat_map(|joint| joint.coordinates.clone()) {
        all[c] = unit_of_coordinate(assembly, c, scales);
    }
    all
}

/// User's units of the nodal vectors of a body at rest. The mixed derivative of a flat patch is zero: its unit is that of the tangent
/// before it.
pub(crate) fn units(vectors: &[NodalVector], scales: Scales) -> Vec<f64> {
    let mut last = 1.0;
    let unit = |vector: &NodalVector| match vector.kind {
        VectorKind::Position => scales.length,
        VectorKind::Twist => last,
        _ => {
            last = vector.value.norm().recip();
            last
        }
    };
    vectors.iter().map(unit).collect()
}

/// User's unit of a coordinate of a joint or a gas: that of lengths and volumes, otherwise 1.
fn unit_of_coordinate(assembly: &Assembly, c: usize, scales: Scales) -> f64 {
    let recorded = assembly.joint_coordinates().find(|(_, recorded)| recorded.coordinate == Some(c));
    let dimension = recorded.map_or(Dimension::NUMBER, |(_, recorded)| recorded.dimensions()[0]);
    scales.unit(dimension)
}

impl GivenBody {
    /// Description of a difference of the structure; `None` if it is the same.
    fn difference(&self, vectors: &[NodalVector], scales: Scales) -> Option<&'static str> {
        let is_same_kind = |(a, b): (&GivenVector, &NodalVector)| a.is_position == b.is_position();
        if self.vectors.len() != vectors.len() || !self.vectors.iter().zip(vectors).all(is_same_kind) {
            return Some("other elements of");
        }
        let positions = || self.vectors.iter().filter(|vector| vector.is_position);
        let size = positions().map(|vector| vector.reference.norm()).fold(0.0, f64::max);
        let is_same = |((given, vector), unit): ((&GivenVector, &NodalVector), f64)| {
            let size = if given.is_position { size } else { 1.0 };
            (vector.value * unit - given.reference).norm() <= EQUAL * size
        };
        (!self.vectors.iter().zip(vectors).zip(units(vectors, scales)).all(is_same))
            .then_some("another undeformed shape or place of")
    }
}

impl GivenVector {
    fn new(reference: &NodalVector, unit: f64, scales: Scales, s: &State) -> Self {
        let (first, is_position) = (reference.first, reference.is_position());
        let part = |x: &[f64]| Vector3::from_column_slice(&x[first..first + 3]);
        Self {
            is_position,
            reference: reference.value * unit,
            change: part(&s.q) * unit,
            rate: part(&s.v) * (unit / scales.time),
        }
    }

    /// Writes the vector into a state in solver units, from its first coordinate on.
    fn write(&self, first: usize, unit: f64, scales: Scales, s: &mut State) {
        s.q[first..first + 3].copy_from_slice((self.change / unit).as_slice());
        s.v[first..first + 3].copy_from_slice((self.rate * (scales.time / unit)).as_slice());
    }
}
