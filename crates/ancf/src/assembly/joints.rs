//! Joints and couplings of a model as equations.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::sync::Arc;

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::constraints::{BilinearMeasure as Measured, MeasureConstraint, MeasureFactor};
use ancf_mechanics::forces::{Signal, SignalSource, StateForce};
use ancf_mechanics::kinematics::{Attachment, BodyVector, ElementAxis};
use ancf_solver::equations::{LOCAL, Term};
use nalgebra::Vector3;

use crate::errors::{ModelError, ModelErrors, quoted};
use crate::joints::{
    Coupled, Coupling, End, Gap, Ground, Joint, JointBody, JointBuilder, JointCoordinate, JointEnds,
    JointEquations, JointKind, JointStateLaw, LinearRows, Numbering, Part, RecordedCoordinate, Source,
};
use crate::model::{Body, IndexedModel, Model, Place, Probe, Quantity, TimeMode};
use crate::units::{Dimension, ScaleChoice, Scales};

/// Signal of a coordinate of a joint or of its rate.
fn signal_of_joint(recorded: &RecordedCoordinate, column: &str, scales: Scales) -> Option<Signal> {
    let is_rate = recorded.columns()[1] == column;
    let [unit, unit_of_rate] = recorded.dimensions().map(|dimension| scales.unit(dimension));
    let (source, offset) = match (&recorded.source, recorded.coordinate) {
        (Source::State { .. }, _) if is_rate => return None,
        (Source::State { start, time, .. }, Some(own)) => {
            return Some(Signal::rate(SignalSource::Coordinate(own), time.recip(), *start));
        }
        (Source::Gas(_), _) if is_rate => return None,
        (Source::Gas(gas), Some(own)) => {
            let (source, offset) = (SignalSource::Coordinate(own), gas.reference_volume() * unit);
            return Some(Signal::value(source, gas.area() * unit, offset));
        }
        (Source::Position(start), Some(own)) => (SignalSource::Coordinate(own), *start),
        (Source::Angle { .. } | Source::Projection(_) | Source::Displacement(_), Some(own)) => {
            (SignalSource::Coordinate(own), 0.0)
        }
        (Source::Displacement(measure), None) => (SignalSource::Measure(measure.clone()), 0.0),
        (Source::Length(apart), _) => (SignalSource::Norm(apart.clone()), 0.0),
        _ => return None,
    };
    Some(match is_rate {
        false => Signal::value(source, unit, offset * unit),
        true => Signal::rate(source, unit_of_rate, 0.0),
    })
}

/// Term of a law with its signals and their paths.
///
/// # Errors
/// If it depends on too many coordinates, with the first signal beyond.
fn state_force(law: &JointStateLaw, signals: Vec<(String, Signal)>) -> Result<StateForce, ModelError> {
    let mut coordinates: BTreeSet<usize> = law.coordinates.iter().copied().collect();
    for (path, signal) in &signals {
        coordinates.extend(signal.coordinates());
        if coordinates.len() > LOCAL {
            let found = format!("signals that depend on more than {LOCAL} coordinates");
            let expected = "fewer signals: a place on a beam has 12 to 27 coordinates, a rigid body 12";
            return Err(ModelError::new(path, found, expected));
        }
    }
    let signals: Vec<Signal> = signals.into_iter().map(|(_, signal)| signal).collect();
    let (coordinates, energies) = (law.coordinates.clone(), law.energies.clone());
    Ok(StateForce::new(coordinates, Arc::clone(&law.law), law.units, energies, &signals))
}

impl IndexedModel<'_> {
    /// Numbers of coordinates and multipliers of bodies and joints.
    pub(crate) fn numbers(bodies: &[(String, BodyTerms)], joints: &[JointEquations]) -> [usize; 2] {
        let of_bodies = bodies.iter().map(|(_, body)| [body.coordinates(), body.multipliers()]);
        let of_joints = joints.iter().map(|joint| [joint.coordinates.len(), joint.multipliers.len()]);
        of_bodies.chain(of_joints).fold([0, 0], |[n, m], [c, l]| [n + c, m + l])
    }

    /// Equations of the joints, then of the gases. Coordinates and multipliers are numbered after those of the bodies.
    ///
    /// Laws with wrong signals are left out: [`checked_joint_equations`](Self::checked_joint_equations) returns their errors.
    pub(crate) fn joint_equations(
        &self,
        bodies: &[(String, BodyTerms)],
        time_mode: TimeMode,
    ) -> Vec<JointEquations> {
        self.joint_equations_and_errors(bodies, time_mode).0
    }

    /// Equations of the joints of a model whose signals are known.
    ///
    /// # Errors
    /// If a force law has an unknown signal or too many of them.
    pub(crate) fn checked_joint_equations(
        &self,
        bodies: &[(String, BodyTerms)],
        time_mode: TimeMode,
    ) -> Result<Vec<JointEquations>, ModelErrors> {
        let (joints, errors) = self.joint_equations_and_errors(bodies, time_mode);
        if errors.is_empty() { Ok(joints) } else { Err(ModelErrors(errors)) }
    }

    fn joint_equations_and_errors(
        &self,
        bodies: &[(String, BodyTerms)],
        time_mode: TimeMode,
    ) -> (Vec<JointEquations>, Vec<ModelError>) {
        let [mut coordinate, mut multiplier] = Self::numbers(bodies, &[]);
        let edge_rows = RefCell::default();
        let energy = self.state_energy();
        let equations = self.joints.iter().enumerate().map(|(number, joint)| {
            let coupled = |coordinate| self.is_coupled(number, coordinate);
            let numbering = Numbering { coordinate, multiplier, time_mode, energy };
            let equations = self.equations_of(joint.kind(), (bodies, &edge_rows), numbering, &coupled);
            (coordinate, multiplier) = (equations.coordinates.end, equations.multipliers.end);
            equations.with_gap(self.gap(joint))
        });
        let mut equations: Vec<_> = equations.collect();
        let after = Numbering { coordinate, multiplier, time_mode, energy };
        equations.extend(self.gas_equations(bodies, after));
        let found = (0..self.joints.len()).map(|number| self.state_forces(bodies, &equations, number));
        let found: Vec<_> = found.collect();
        let mut errors = Vec::new();
        for (own, (terms, unknown)) in equations.iter_mut().zip(found) {
            own.parts.extend(terms.into_iter().map(|term| Part::new(Box::new(term))));
            errors.extend(unknown);
        }
        (equations, errors)
    }

    /// Force laws of a joint with states and signals, and errors of signals that are unknown or depend on too many coordinates.
    fn state_forces(
        &self,
        bodies: &[(String, BodyTerms)],
        joints: &[JointEquations],
        number: usize,
    ) -> (Vec<StateForce>, Vec<ModelError>) {
        let (mut terms, mut errors) = (Vec::new(), Vec::new());
        for law in &joints[number].laws {
            let (mut signals, mut unknown) = (Vec::new(), Vec::new());
            for (k, signal) in law.signals.iter().enumerate() {
                let path = format!("joints[{number}].{}.signals[{k}].value", law.key);
                let expected = "a position or velocity of a probe, a coordinate of a joint or its rate, or a state, such \
                                as `tip.z`";
                match self.signal(bodies, joints, law, &signal.value) {
                    None => unknown.push(ModelError::new(path, quoted(&signal.value), expected)),
                    Some(found) => signals.push((path, found)),
                }
            }
            if unknown.is_empty() {
                match state_force(law, signals) {
                    Ok(term) => terms.push(term),
                    Err(error) => errors.push(error),
                }
            }
            errors.extend(unknown);
        }
        (terms, errors)
    }

    /// Signal of a column for a force law.
    fn signal(
        &self,
        bodies: &[(String, BodyTerms)],
        joints: &[JointEquations],
        law: &JointStateLaw,
        value: &str,
    ) -> Option<Signal> {
        let (owner, column) = value.rsplit_once('.')?;
        let of_joint = joints.iter().find(|joint| joint.name == owner);
        if let Some(recorded) = of_joint
            .and_then(|joint| joint.recorded.iter().find(|recorded| recorded.columns().contains(&column)))
        {
            return signal_of_joint(recorded, column, law.scales);
        }
        let moves = |probe: &&Probe| probe.name == owner && probe.record.contains(&Quantity::Motion);
        let probe = self.probes.iter().find(moves)?;
        let names = ["x", "y", "z", "vx", "vy", "vz"];
        let number = names.iter().position(|name| *name == column)?;
        let axis = BodyVector::fixed(Vector3::ith(number % 3, 1.0));
        let point = self.probed(bodies, probe).2.point;
        let product = (1.0, MeasureFactor::Other(&axis), MeasureFactor::Point(&point));
        let measure = Measured::new([product]);
        let offset = measure.reference() * law.scales.unit(Dimension::LENGTH);
        let source = SignalSource::Measure(measure);
        Some(match number {
            ..3 => Signal::value(source, law.scales.unit(Dimension::LENGTH), offset),
            _ => Signal::rate(source, law.scales.unit(Dimension::VELOCITY), 0.0),
        })
    }

    /// Typical energy of the model for the states of force laws; 1 without such states.
    fn state_energy(&self) -> f64 {
        if self.laws().all(|(_, one)| one.law.states().is_empty()) {
            return 1.0;
        }
        let automatic = Model { scales: ScaleChoice::Auto, ..Model::clone(self) };
        automatic.scales().scales.unit(Dimension::ENERGY)
    }

    /// Equations of one joint.
    fn equations_of(
        &self,
        joint: &dyn JointKind,
        (bodies, edge_rows): (&[(String, BodyTerms)], &RefCell<LinearRows>),
        numbering: Numbering,
        coupled: &dyn Fn(JointCoordinate) -> bool,
    ) -> JointEquations {
        let (place, stated) = joint.ends();
        let a = self.attachment(bodies, place);
        let (b, beam) = match stated {
            End::Place(place) => (self.attachment(bodies, place), self.beam(bodies, place)),
            End::Point(Ground { point }) if joint.spans() => {
                (Attachment::ground(Vector3::from(*point)), None)
            }
            End::Ground | End::Point(_) => (Attachment::ground(a.point.reference()), None),
        };
        let all_gradients = match stated {
            End::Place(other) => match (self.is_continuum(place), self.is_continuum(other)) {
                (true, true) => a.is_parallel(&b),
                (true, false) => b.is_rigid(),
                (false, true) => a.is_rigid(),
                (false, false) => false,
            },
            End::Ground | End::Point(_) => self.is_continuum(place),
        };
        let body = |place: &Place| {
            let index = self.body_of(place);
            JointBody { data: &self.bodies[index], terms: &bodies[index].1 }
        };
        let other = if let End::Place(other) = stated { Some(body(other)) } else { None };
        let ends =
            JointEnds { a: &a, b: &b, stated, beam, body: body(place), other, edge_rows, all_gradients };
        let mut builder = JointBuilder::new(joint.name(), ends, numbering, coupled);
        joint.build(&mut builder);
        builder.finish()
    }

    /// Treatment of the gap of a joint in the analysis.
    pub(crate) fn gap(&self, joint: &Joint) -> Gap {
        let moves = self.analysis.dynamics().is_some();
        let closes_by_load = matches!(joint.ends().1, End::Point(_)) && !(moves && self.assemble);
        match () {
            () if closes_by_load => Gap::ClosedByLoad,
            () if self.assemble => Gap::Closed,
            () => Gap::Kept,
        }
    }

    /// Element axes of a flexible body, and the arc length of a place on it.
    fn beam(&self, bodies: &[(String, BodyTerms)], place: &Place) -> Option<(Vec<ElementAxis>, f64)> {
        let index = self.body_of(place);
        let axes = bodies[index].1.mesh()?.element_axes().collect();
        Some((axes, self.bodies[index].arc_length(&place.at)))
    }

    /// Equations of the couplings. Multipliers are numbered after those of the joints.
    pub(crate) fn coupling_terms(
        &self,
        bodies: &[(String, BodyTerms)],
        joints: &[JointEquations],
    ) -> Vec<Box<dyn Term>> {
        let [_, first] = Self::numbers(bodies, joints);
        let part = |measure: Measured, part: &Coupled| {
            let (joint, free) = self.coupled_coordinate(part)?;
            let coordinate = joints[joint].recorded.iter().find_map(|recorded| recorded.coupled(free))?;
            Some(measure.plus(coordinate, part.factor))
        };
        let equation = |(k, coupling): (usize, &Coupling)| {
            let measure = coupling.joints.iter().try_fold(Measured::default(), part);
            let measure = measure.expect("a checked coupling names coordinates of its joints");
            Box::new(MeasureConstraint::new(measure, first + k).named("coupling")) as Box<dyn Term>
        };
        self.couplings.iter().enumerate().map(equation).collect()
    }

    /// True if a place is on a beam of the continuum formulation.
    fn is_continuum(&self, place: &Place) -> bool {
        let body = &self.bodies[self.body_of(place)];
        matches!(body, Body::Beam(beam) if beam.formulation.is_continuum())
    }
}
