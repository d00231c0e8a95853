//! Joints and couplings of a model as equations.

use std::cell::RefCell;

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::constraints::{BilinearMeasure as Measured, MeasureConstraint};
use ancf_mechanics::kinematics::{Attachment, ElementAxis};
use ancf_solver::equations::Term;
use nalgebra::Vector3;

use crate::joints::{
    Coupled, Coupling, End, Gap, Ground, Joint, JointBuilder, JointCoordinate, JointEnds, JointEquations,
    JointKind, LinearRows, Numbering,
};
use crate::model::{Body, IndexedModel, Model, Place, TimeMode};
use crate::units::{Dimension, ScaleChoice};

impl IndexedModel<'_> {
    /// Numbers of coordinates and multipliers of bodies and joints.
    pub(crate) fn numbers(bodies: &[(String, BodyTerms)], joints: &[JointEquations]) -> [usize; 2] {
        let of_bodies = bodies.iter().map(|(_, body)| [body.coordinates(), body.multipliers()]);
        let of_joints = joints.iter().map(|joint| [joint.coordinates.len(), joint.multipliers.len()]);
        of_bodies.chain(of_joints).fold([0, 0], |[n, m], [c, l]| [n + c, m + l])
    }

    /// Equations of the joints. Coordinates and multipliers are numbered after those of the bodies.
    pub(crate) fn joint_equations(
        &self,
        bodies: &[(String, BodyTerms)],
        time_mode: TimeMode,
    ) -> Vec<JointEquations> {
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
        equations.collect()
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
        let body = &bodies[self.body_of(place)].1;
        let (shell, shear_shell) = (body.shell(), body.shear_shell());
        let other_shell =
            if let End::Place(place) = stated { bodies[self.body_of(place)].1.shell() } else { None };
        let model_body = &self.bodies[self.body_of(place)];
        let ends = JointEnds {
            a: &a,
            b: &b,
            stated,
            beam,
            shell,
            shear_shell: shear_shell.zip(model_body.shear_shell()),
            other_shell,
            edge_rows,
            all_gradients,
        };
        let mut builder = JointBuilder::new(joint.name(), ends, numbering, coupled);
        joint.build(&mut builder);
        builder.finish()
    }

    /// Treatment of the gap of a joint in the analysis.
    pub(crate) fn gap(&self, joint: &Joint) -> Gap {
        let moves = self.analysis.dynamics().is_some();
        let is_drawn = matches!(joint.ends().1, End::Point(_)) && !(moves && self.assemble);
        match () {
            () if is_drawn => Gap::ClosedByLoad,
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
