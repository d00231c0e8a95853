use ancf_mechanics::bodies::normals_to;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::joints::parts::{
    End, JointActions, JointBuilder, JointCoordinate, JointKind, LinearDrive, LinearFriction, LinearSpring,
    LinearStops,
};
use crate::model::{Capability, JointLaw, LawKind, Place, TimeFunction};
use crate::units::Scaled;

/// Prismatic joint: allows displacement along an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Prismatic {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the axis is fixed; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the axis in the undeformed state, in the global frame. Its magnitude has no effect.
    #[unit(none)]
    pub axis: [f64; 3],
    /// Prescribed displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<LinearDrive>,
    /// Spring and damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<LinearSpring>,
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
    /// Law of a force on `a` along the axis, by the displacement x and its rate v.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<JointLaw>,
    /// Stops of the displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stops: Option<LinearStops>,
}

impl JointKind for Prismatic {
    fn word(&self) -> &'static str {
        "prismatic"
    }

    fn noun(&self) -> &'static str {
        "prismatic joint"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        5
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let axis = Vector3::from(self.axis).normalize();
        let measures = measures::prismatic(builder.a(), builder.b(), axis);
        builder.keep(&[(measures::GUIDE, 2), (measures::AXIS, 2), ("rotation about the axis", 1)], measures);
        let [u, v] = normals_to(axis);
        builder.expect_aligned(&[axis, u, v]);
        builder.displacement(axis, &self.displacement_actions());
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a prismatic joint")); 2]
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

    fn bearing_keys(&self) -> &'static [&'static str] {
        &["span", "arm"]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }

    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        &[JointCoordinate::Displacement]
    }

    fn displacement_actions(&self) -> JointActions<'_> {
        JointActions::along_displacement(&self.drive, &self.spring, &self.friction)
            .with_law(&self.force, LawKind::Force)
            .with_stops(self.stops.as_ref().map(LinearStops::law))
    }
}
