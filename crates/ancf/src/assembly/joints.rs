//! Joints and couplings of a model as equations.

use ancf_mechanics::constraints::{Measure as Measured, Tie};
use ancf_mechanics::kinematics::{Attachment, ElementAxis};
use ancf_solver::equations::Term;

use crate::assembly::joint_equations::{Holds, JointEquations};
use crate::model::{Beam, Body, Clock, Coupled, Coupling, Formulation, Joint, Model, Place};

impl Model {
    /// Numbers of coordinates and multipliers of bodies and joints.
    pub(crate) fn numbers(
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        joints: &[JointEquations],
    ) -> [usize; 2] {
        let of_bodies = bodies.iter().map(|(_, body)| [body.coordinates(), body.multipliers()]);
        let of_joints = joints.iter().map(|joint| [joint.coordinates(), joint.multipliers()]);
        of_bodies.chain(of_joints).fold([0, 0], |[n, m], [c, l]| [n + c, m + l])
    }

    /// The equations of the joints, multipliers counted on from the bodies' and from joint to joint.
    pub(crate) fn joint_equations(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        clock: Clock,
    ) -> Vec<JointEquations> {
        let mut first = Self::numbers(bodies, &[]);
        let held = Held { model: self, bodies };
        let equations = self.joints.iter().enumerate().map(|(number, joint)| {
            let (locking, coupled) = (self.is_locking(joint), |freed| self.is_coupled(number, freed));
            let equations = JointEquations::new(joint, locking, first, clock, coupled, &held);
            first = [first[0] + equations.coordinates(), first[1] + equations.multipliers()];
            equations.with_gap(self.gap(joint))
        });
        equations.collect()
    }

    /// The equations of the couplings, by multipliers after those of the joints.
    pub(crate) fn coupling_terms(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        joints: &[JointEquations],
    ) -> Vec<Box<dyn Term>> {
        let [_, first] = Self::numbers(bodies, joints);
        let part = |measure: Measured, part: &Coupled| {
            let (joint, freed) = self.coupled(part)?;
            let coordinate = joints[joint].freedoms().iter().find_map(|freedom| freedom.coupled(freed))?;
            Some(measure.plus(coordinate, part.factor))
        };
        let tie = |(k, coupling): (usize, &Coupling)| {
            let measure = coupling.joints.iter().try_fold(Measured::default(), part);
            let measure = measure.expect("a checked coupling names freedoms that are there");
            Box::new(Tie::new(measure, first + k).named("coupling")) as Box<dyn Term>
        };
        self.couplings.iter().enumerate().map(tie).collect()
    }

    /// Whether the first end of a joint is on a beam of the continuum formulation.
    fn is_locking(&self, joint: &Joint) -> bool {
        let body = &self.bodies[self.body_of(joint.ends().0)];
        matches!(body, Body::Beam(Beam { formulation: Formulation::Continuum, .. }))
    }
}

/// The bodies of a model, for its joints to hold on to.
struct Held<'a> {
    model: &'a Model,
    bodies: &'a [(String, ancf_mechanics::bodies::Body)],
}

impl Holds for Held<'_> {
    fn attachment(&self, place: &Place) -> Attachment {
        self.model.attachment(self.bodies, place)
    }

    fn beam(&self, place: &Place) -> Option<(Vec<ElementAxis>, f64)> {
        let index = self.model.body_of(place);
        let axes = self.bodies[index].1.mesh()?.element_axes().collect();
        Some((axes, self.model.bodies[index].arc_length(place.at)))
    }
}
