use ancf_mechanics::functions::InputSignal;
use ancf_solver::dynamics::{StepReport, consistent_positions};
use ancf_solver::equations::State;

use super::step_error::{StepError, argument};
use super::stepper::{Setting, Stepper};
use crate::errors::quoted;
use crate::failure::{AlternationMonitor, RotationMonitor};
use crate::initial::{coordinate_units, units};
use crate::results::{AngleRates, Rows, TIME};
use crate::simulate::COLUMNS;

/// Complete state of a motion, in the user's units.
///
/// The coordinates are changes from the reference configuration: displacements of nodes and centres, changes of directions relative to
/// the magnitude of their reference values, and coordinates of joints.
#[derive(Clone, Debug, PartialEq)]
pub struct CompleteState {
    /// Time.
    pub time: f64,
    /// Coordinates q.
    pub coordinates: Vec<f64>,
    /// Velocities dq/dt.
    pub velocities: Vec<f64>,
    /// Angles of joints and sensors that coordinates determine up to whole turns, rad, in the order of
    /// [`Simulation::counted_angles`](crate::Simulation::counted_angles). A given state has the turns nearest to them. If there are none,
    /// its angles are between −π and π.
    pub angles: Vec<f64>,
}

/// Coordinates of a body or a joint in a [`CompleteState`].
#[derive(Clone, Debug, PartialEq)]
pub struct BodyLayout {
    /// Name.
    pub name: String,
    /// First coordinate.
    pub first: usize,
    /// True for each position, false for each direction: vectors of three coordinates. Empty for joints.
    pub are_positions: Vec<bool>,
    /// Reference values of the vectors: positions, and unit directions. The mixed derivatives of shells have the unit of the tangent
    /// before them.
    pub reference: Vec<[f64; 3]>,
    /// Number of coordinates of a joint.
    pub joint_coordinates: usize,
}

/// Correction of a given state by the projection onto the constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Largest displacement of a node or centre, length.
    pub moved: f64,
    /// Largest rotation of a rigid body or a section, rad, and change of the lengths of directors.
    pub turned: f64,
    /// Kinetic energy of the correction of the velocities, relative to that of the given velocities.
    pub corrected: f64,
}

impl Stepper {
    /// Layout of the state by body, followed by that of joints with coordinates.
    pub fn layout(&self) -> Vec<BodyLayout> {
        let (assembly, scales) = (&self.simulation.assembly, self.simulation.scales());
        let rest = assembly.rest();
        let bodies = assembly.bodies().map(|(name, body)| {
            let vectors = body.vectors(&rest);
            let units = units(&vectors, scales);
            let reference = vectors.iter().zip(units).map(|(vector, unit)| (vector.value * unit).into());
            BodyLayout {
                name: name.to_owned(),
                first: vectors.first().map_or(0, |vector| vector.first),
                are_positions: vectors.iter().map(|vector| vector.is_position()).collect(),
                reference: reference.collect(),
                joint_coordinates: 0,
            }
        });
        let joints = assembly.joints.iter().filter(|joint| !joint.coordinates.is_empty());
        let joints = joints.map(|joint| BodyLayout {
            name: joint.name.clone(),
            first: joint.coordinates.start,
            are_positions: Vec::new(),
            reference: Vec::new(),
            joint_coordinates: joint.coordinates.len(),
        });
        bodies.chain(joints).collect()
    }

    /// Present state. Its velocities satisfy the constraints, without the error of the time steps, so that a motion that continues from
    /// it has no impulses.
    pub fn state(&self) -> CompleteState {
        let (s, scales) = (self.dynamics.state(), self.simulation.scales());
        let consistent = self.simulation.without_velocity_error(s);
        let s = consistent.as_ref().unwrap_or(s);
        let units = coordinate_units(&self.simulation.assembly, scales);
        CompleteState {
            time: self.time(),
            coordinates: s.q.iter().zip(&units).map(|(q, unit)| q * unit).collect(),
            velocities: s.v.iter().zip(&units).map(|(v, unit)| v * (unit / scales.time)).collect(),
            angles: self.rows.counted_angles().collect(),
        }
    }

    /// Continues from another state: positions and velocities are projected onto the constraints in the norm of the kinetic energy,
    /// accelerations and multipliers are computed with the present inputs, and the energy balance begins anew. Inputs keep their values and transitions.
    ///
    /// # Errors
    /// If sizes or numbers are not valid, or if the state cannot be projected. Nothing has changed then.
    pub fn set_state(&mut self, given: &CompleteState) -> Result<Projection, StepError> {
        let s = self.checked(given)?;
        let (assembly, scaled) = (&self.simulation.assembly, &self.simulation.scaled);
        let mut consistent = s.clone();
        let system = &assembly.system;
        consistent_positions(system, &mut system.matrix(), &mut consistent, scaled.length())
            .map_err(|error| self.failed(error))?;
        if let Some(joint) = assembly.misaligned(&consistent) {
            let found = format!("bodies of joint {} that are turned against each other", quoted(joint));
            return Err(argument(
                "state, coordinates",
                found,
                "rotations of less than a right angle from those of the joint",
            ));
        }
        if let Some(error) = assembly.inadmissible(&consistent) {
            return Err(self.failed(error));
        }
        let turned = assembly.turn(&s, &consistent);
        let moved = assembly.displacement(&s, &consistent) * self.simulation.scales().length;
        let corrected = assembly.projection(&consistent).unwrap_or(0.0);
        let former: Vec<_> = self.simulation.inputs.iter().map(InputSignal::transition).collect();
        self.move_inputs(s.t);
        if let Err(error) = self.dynamics.set_state(&consistent) {
            self.simulation.inputs.iter().zip(former).for_each(|(signal, one)| signal.set(one));
            return Err(self.failed(error));
        }
        self.pending.fill(None);
        let names = self.simulation.counted_angles().into_iter();
        let angles: Vec<_> = names.zip(given.angles.iter().copied()).collect();
        self.begin_history(&angles);
        Ok(Projection { moved, turned, corrected })
    }

    /// State in solver units.
    fn checked(&self, given: &CompleteState) -> Result<State, StepError> {
        let (assembly, scales) = (&self.simulation.assembly, self.simulation.scales());
        let mut s = assembly.initial();
        for (what, numbers) in [("coordinates", &given.coordinates), ("velocities", &given.velocities)] {
            if numbers.len() != s.q.len() {
                let expected = format!("{} numbers", s.q.len());
                return Err(argument(&format!("state, {what}"), numbers.len(), &expected));
            }
            if let Some(x) = numbers.iter().find(|x| !x.is_finite()) {
                return Err(argument(&format!("state, {what}"), x, "finite numbers"));
            }
        }
        let count = self.rows.counted_angles().count();
        if !(given.angles.is_empty() || given.angles.len() == count) {
            let expected = format!("none or {count} numbers");
            return Err(argument("state, angles", given.angles.len(), &expected));
        }
        if let Some(x) = given.angles.iter().find(|x| !x.is_finite()) {
            return Err(argument("state, angles", x, "finite numbers"));
        }
        if !(given.time.is_finite() && given.time >= 0.0) {
            return Err(argument("state, time", given.time, "a time of at least 0"));
        }
        let units = coordinate_units(assembly, scales);
        s.t = given.time / scales.time;
        for (i, unit) in units.iter().enumerate() {
            s.q[i] = given.coordinates[i] / unit;
            s.v[i] = given.velocities[i] / (unit / scales.time);
        }
        Ok(s)
    }

    /// Continues all inputs at another time with their present values and new settings.
    fn move_inputs(&self, to: f64) {
        let now = self.dynamics.state().t;
        for (signal, setting) in self.simulation.inputs.iter().zip(&self.pending) {
            let own = signal.transition();
            let set = setting.map(|Setting { value, duration }| own.towards(value, now, duration));
            signal.set(set.unwrap_or(own).moved(now, to));
        }
    }

    /// Begins the histories of rows, monitors and events at the present state, with the turns of some angles by their columns.
    fn begin_history(&mut self, angles: &[(String, f64)]) {
        let (assembly, scaled) = (&self.simulation.assembly, &self.simulation.scaled);
        let s = self.dynamics.state();
        self.rows = Rows::new(assembly, self.simulation.scales(), TIME, &COLUMNS);
        self.rows.start_turns(angles);
        self.rows.count_turns(s.t, s, AngleRates::Velocities);
        self.monitors.rotations = RotationMonitor::new(scaled, assembly, s.t);
        self.monitors.alternations = AlternationMonitor::new(scaled, s.a.len());
        self.events.move_to(s.t);
        self.report = StepReport::default();
        self.is_row_current = false;
        self.row();
    }
}
