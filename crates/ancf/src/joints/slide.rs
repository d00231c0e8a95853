use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::{Finding, finding};
use crate::joints::parts::{
    End, JointActions, JointBuilder, JointContext, JointCoordinate, JointKind, LinearDrive, LinearFriction,
    LinearSpring, LinearStops,
};
use crate::model::{Body, JointLaw, LawKind, Place, TimeFunction};
use crate::units::Scaled;

/// Sliding joint: constrains a point to the deformed axis of a beam or cable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Slide {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Sliding point, on which the reaction acts.
    pub a: Place,
    /// Initial place on the axis of a cable or of a beam of two-node elements.
    pub b: End,
    /// Prescribed displacement along the axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<LinearDrive>,
    /// Spring and damper along the axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<LinearSpring>,
    /// Dry friction along the axis, of a given force or by the reaction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
    /// Law of a force on `a` along the axis, by the displacement x and its rate v.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<JointLaw>,
    /// Stops of the displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stops: Option<LinearStops>,
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
        builder.slide(&self.displacement_actions());
    }

    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        self.drive.iter().map(|drive| (".drive", &drive.time)).collect()
    }

    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        self.drive.iter_mut().map(|drive| &mut drive.time).collect()
    }

    fn laws_mut(&mut self) -> Vec<&mut JointLaw> {
        self.force.iter_mut().collect()
    }

    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        &[JointCoordinate::Displacement]
    }

    fn displacement_actions(&self) -> JointActions<'_> {
        JointActions::along_displacement(&self.drive, &self.spring, &self.friction)
            .with_law(&self.force, LawKind::Force)
            .with_stops(self.stops.as_ref().map(LinearStops::law))
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        self.check_axis(path, context).into_iter().collect()
    }
}

impl Slide {
    /// Finding if the second end is not on an axis with a continuous tangent.
    fn check_axis(&self, path: &str, context: &dyn JointContext) -> Option<Finding> {
        let expected = "a place on a cable or on a beam of two-node elements";
        let End::Place(place) = &self.b else {
            return Some(finding(format!("{path}.b"), "the ground", expected));
        };
        let quadratic = "a beam of formulation \"quadratic\", whose tangent has kinks";
        let found = match context.body(place)? {
            Body::Beam(beam) if beam.formulation.has_middle_node() => quadratic,
            Body::Beam(_) | Body::Cable(_) if place.offset == [0.0; 3] => return None,
            Body::Beam(_) | Body::Cable(_) => {
                let expected = "no arm, since the point slides along the axis";
                return Some(finding(format!("{path}.b.offset"), "an arm", expected));
            }
            Body::Shell(_) | Body::ShearShell(_) => "a shell",
            Body::Rigid(_) => "a rigid body",
            Body::Mass(_) => "a point mass",
        };
        Some(finding(format!("{path}.b.body"), found, expected).rests_on(["bodies".into()]))
    }
}
