use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::joints::parts::{
    End, Freed, JointActuation, JointBuilder, JointKind, LinearDrive, LinearFriction, LinearSpring,
};
use crate::model::{Capability, Place, TimeFunction};
use crate::units::Scaled;

/// A slider in a straight guide: leaves displacement along an axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Prismatic {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end that receives the reaction.
    pub a: Place,
    /// The other end, which carries the axis; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the axis in the undeformed state, in the global frame; its length does not matter.
    #[unit(none)]
    pub axis: [f64; 3],
    /// Prescribes the displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<LinearDrive>,
    /// A spring and a damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<LinearSpring>,
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
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
        builder.displacement(axis, &self.linear_actuation());
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

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }

    fn freedoms(&self) -> &'static [Freed] {
        &[Freed::Displacement]
    }

    fn linear_actuation(&self) -> JointActuation<'_> {
        JointActuation::linear(&self.drive, &self.spring, &self.friction)
    }
}
