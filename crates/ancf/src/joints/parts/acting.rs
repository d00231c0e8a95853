//! Coordinates of a joint, with springs, friction, force laws and stops along them.

use std::sync::Arc;

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::constraints::{
    BilinearMeasure, HingeAngle, MeasureConstraint, MeasureTarget, SlideConstraint,
};
use ancf_mechanics::forces::{Bearing, CoordinateForce, Friction, Slip, Spring, Strut};
use ancf_mechanics::functions::Function;
use ancf_mechanics::laws::{LawUnits, Resistance};
use nalgebra::Vector3;

use super::actions::JointActions;
use super::builder::JointBuilder;
use super::coupling::JointCoordinate;
use super::equations::{JointStateLaw, Part};
use super::friction::JointFriction;
use super::measures;
use super::recorded_coordinate::{RecordedCoordinate, Source};
use crate::model::{JointLaw, LawKind, LawUse, TimeMode};

impl JointBuilder<'_> {
    /// Records the angle about an axis of unit length, and adds the actions along it.
    ///
    /// The other equations of the joint must keep the axes of both ends parallel. A joint records one angle.
    pub fn angle(&mut self, axis: impl Into<Vector3<f64>>, actions: &JointActions<'_>) {
        let axis = axis.into();
        let vectors = measures::hinge(self.a(), self.b(), axis);
        let mut coordinate = None;
        if (self.coupled)(JointCoordinate::Angle) || actions.is_some() {
            let (own, multiplier) = (self.coordinate(), self.multipliers(1));
            let [p, u, v] = &vectors;
            self.add(HingeAngle::new(own, p, [u, v], multiplier));
            self.act(own, actions);
            let normals = normals_to(axis).map(|normal| self.b().direction(normal));
            self.add_along_friction(own, actions, |friction| Bearing::Pin {
                normals: Box::new(normals),
                radius: friction.radius.unwrap_or(0.0),
                span: friction.span,
                collar: friction.arm.unwrap_or(0.0),
            });
            coordinate = Some(own);
        }
        let ends = Box::new([self.a().clone(), self.b().clone()]);
        self.equations
            .recorded
            .push(RecordedCoordinate { source: Source::Angle { vectors, ends }, coordinate });
    }

    /// Records the angle of the projection of a vector of the first end, about an axis of unit length of the second end.
    pub(crate) fn projected_angle(&mut self, axis: Vector3<f64>) {
        let vectors = measures::hinge(self.a(), self.b(), axis);
        let mut coordinate = None;
        if (self.coupled)(JointCoordinate::Angle) {
            let (own, multiplier) = (self.coordinate(), self.multipliers(1));
            let [p, u, v] = &vectors;
            self.add(HingeAngle::new(own, p, [u, v], multiplier));
            coordinate = Some(own);
        }
        self.equations.recorded.push(RecordedCoordinate { source: Source::Projection(vectors), coordinate });
    }

    /// Records the displacement along an axis of the second end, and adds the actions along it.
    pub fn displacement(&mut self, axis: impl Into<Vector3<f64>>, actions: &JointActions<'_>) {
        let measure = measures::along(self.a(), self.b(), axis.into());
        let mut coordinate = None;
        if (self.coupled)(JointCoordinate::Displacement) || actions.is_some() {
            let (own, multiplier) = (self.coordinate(), self.multipliers(1));
            let tie = MeasureConstraint::defining(own, measure.clone(), multiplier);
            self.add(tie.named("definition of the displacement"));
            self.act(own, actions);
            self.add_along_friction(own, actions, |friction| Bearing::Guide {
                span: friction.span,
                arm: friction.arm,
            });
            coordinate = Some(own);
        }
        self.equations
            .recorded
            .push(RecordedCoordinate { source: Source::Displacement(measure), coordinate });
    }

    /// Constrains the first point to the axis of the second body, and adds the actions along it.
    pub fn slide(&mut self, actions: &JointActions<'_>) {
        let Some((axes, start)) = self.ends.beam.take() else { return };
        let (own, first) = (self.coordinate(), self.multipliers(3));
        // Each term evaluates the multipliers that all of them share: the first one reports the reaction.
        for (k, slide) in
            SlideConstraint::along(axes, &self.a().point, own, start, first).into_iter().enumerate()
        {
            self.equations.parts.push(Part { reacts: k == 0, ..Part::new(Box::new(slide)) });
        }
        self.act(own, actions);
        self.add_along_friction(own, actions, |_| Bearing::Curve);
        self.equations
            .recorded
            .push(RecordedCoordinate { source: Source::Position(start), coordinate: Some(own) });
    }

    /// Records the distance of the two points, once.
    pub fn length(&mut self) {
        if self.equations.recorded.iter().any(|recorded| matches!(recorded.source, Source::Length(_))) {
            return;
        }
        let source = Source::Length(measures::apart(self.a(), self.b()));
        self.equations.recorded.push(RecordedCoordinate { source, coordinate: None });
    }

    /// Adds a spring and a damper along a measure.
    pub fn spring(&mut self, measure: BilinearMeasure, stiffness: f64, damping: f64) {
        self.add(Spring::new(measure, stiffness, damping));
    }

    /// Adds a spring and a damper between the two points, free of force at a length; in tension only if stated.
    pub fn strut(&mut self, [stiffness, damping]: [f64; 2], length: Option<f64>, tension_only: bool) {
        let apart = measures::apart(self.a(), self.b());
        let length = length.unwrap_or_else(|| apart.reference().norm());
        let strut = Strut::new(&self.a().point, &self.b().point, stiffness, damping, length);
        self.add(if tension_only { strut.tension_only() } else { strut });
        self.length();
    }

    /// Adds a force between the two points by a law of the elongation beyond a length.
    pub fn tension(&mut self, law: &JointLaw, length: Option<f64>) {
        let reference = measures::apart(self.a(), self.b()).reference().norm();
        let lengths = [length.unwrap_or(reference), reference];
        let law = law.resistance(LawKind::Tension, lengths, self.time_mode);
        self.add(Strut::with_law(&self.a().point, &self.b().point, law));
        self.length();
    }

    /// Adds drive, spring, friction, force law and stops of a joint coordinate.
    pub fn act(&mut self, coordinate: usize, actions: &JointActions<'_>) {
        let measure = || BilinearMeasure::coordinate(coordinate);
        if let Some(drive) = &actions.drive {
            if drive.is_held(self.time_mode) {
                let next = self.equations.multipliers.end;
                self.equations.held.push(next);
            }
            self.prescribe("drive", measure(), drive.target(self.time_mode));
        }
        if let Some([stiffness, damping, rest]) = actions.spring {
            let rest = MeasureTarget::new(rest, Function::ONE);
            self.add(Spring::with_set_point(measure(), stiffness, damping, rest));
        }
        if let Some(friction) = actions.friction.filter(|friction| friction.amount > 0.0) {
            self.add(Friction::new(measure(), friction.amount, friction.curve));
        }
        if let Some(law) = actions.law {
            self.act_by_law(coordinate, law);
        }
        if let Some(stops) = actions.stops {
            let law = Resistance::acting(Arc::new(stops), LawUnits::OWN);
            self.add(CoordinateForce::new(coordinate, law));
        }
    }

    /// Adds friction in proportion to the reaction, if it has a coefficient. The first equations of the joint are those of the bearing.
    fn add_along_friction(
        &mut self,
        coordinate: usize,
        actions: &JointActions<'_>,
        bearing: impl FnOnce(&JointFriction) -> Bearing,
    ) {
        if let Some(friction) = actions.friction.filter(|friction| friction.coefficient > 0.0) {
            let slip = vec![Slip::Rate(BilinearMeasure::coordinate(coordinate))];
            // The friction without a reaction is a term of its own.
            let by_reaction = JointFriction { amount: 0.0, ..friction };
            self.add_friction(slip, bearing(&friction), &by_reaction);
        }
    }

    /// Adds a force law of a coordinate. Laws with states or signals become terms when all joints are built. States are coordinates
    /// of the joint in motions, and have their values at the start in other analyses.
    fn act_by_law(&mut self, coordinate: usize, law: LawUse<'_>) {
        let with_states = law.law.state_law(law.kind, &[]).expect("a checked law has no syntax errors");
        let Some((state_law, units)) = with_states.filter(|_| self.time_mode == TimeMode::AsGiven) else {
            let law = law.law.resistance(law.kind, [0.0; 2], self.time_mode);
            return self.add(CoordinateForce::new(coordinate, law));
        };
        let mut coordinates = vec![coordinate];
        for state in law.law.states() {
            let own = self.coordinate();
            coordinates.push(own);
            let columns = [state.name.clone(), format!("{}_rate", state.name)];
            let source = Source::State { columns, start: state.start, time: units.time };
            self.equations.recorded.push(RecordedCoordinate { source, coordinate: Some(own) });
        }
        self.equations.states.extend(&coordinates[1..]);
        let energies = law.law.states().iter().map(|state| self.energy / state.size.powi(2)).collect();
        let signals = law.law.signals().to_vec();
        self.equations.laws.push(JointStateLaw {
            coordinates,
            law: Arc::new(state_law),
            units,
            energies,
            signals,
            scales: law.law.units(),
            key: law.key,
        });
    }
}
