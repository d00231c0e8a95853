use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::{Finding, finding};
use crate::joints::parts::{
    End, Freed, JointActuation, JointBuilder, JointContext, JointKind, LinearDrive, LinearFriction,
    LinearSpring,
};
use crate::model::{Beam, Body, Formulation, Place, TimeFunction};
use crate::units::Scaled;

/// A bead on a beam: a point slides along the axis of a beam, bent as it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Slide {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The point that slides, and receives the reaction.
    pub a: Place,
    /// The place of a beam of two-node elements or of a cable where it is at the start.
    pub b: End,
    /// Prescribes the displacement along the beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<LinearDrive>,
    /// A spring and a damper along the beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<LinearSpring>,
    /// Dry friction along the beam, of a given force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
}

impl JointKind for Slide {
    fn word(&self) -> &'static str {
        "slide"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        2
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        builder.slide(&self.linear_actuation());
    }

    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        self.drive.iter().map(|drive| (".drive", &drive.time)).collect()
    }

    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        self.drive.iter_mut().map(|drive| &mut drive.time).collect()
    }

    fn freedoms(&self) -> &'static [Freed] {
        &[Freed::Displacement]
    }

    fn linear_actuation(&self) -> JointActuation<'_> {
        JointActuation::linear(&self.drive, &self.spring, &self.friction)
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        self.misfit(path, context).into_iter().collect()
    }
}

impl Slide {
    /// Finding if the second end is not on an axis with a continuous tangent.
    fn misfit(&self, path: &str, context: &dyn JointContext) -> Option<Finding> {
        let wanted = "a place on a cable or on a beam of two-node elements";
        let End::Place(place) = &self.b else {
            return Some(finding(format!("{path}.b"), "the ground", wanted));
        };
        let quadratic = "a beam of formulation \"quadratic\", whose tangent has kinks";
        let found = match context.body(place)? {
            Body::Beam(Beam { formulation: Formulation::Quadratic, .. }) => quadratic,
            Body::Beam(_) | Body::Cable(_) if place.offset == [0.0; 3] => return None,
            Body::Beam(_) | Body::Cable(_) => {
                let wanted = "none: points slide along the axis";
                return Some(finding(format!("{path}.b.offset"), "an arm", wanted));
            }
            Body::Rigid(_) => "a rigid body",
            Body::Mass(_) => "a point mass",
        };
        Some(finding(format!("{path}.b.body"), found, wanted).rests_on(["bodies".into()]))
    }
}
