use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::joints::parts::{
    AngularDrive, AngularSpring, End, Freed, JointActuation, JointBuilder, JointKind, LinearDrive,
};
use crate::model::{Capability, Place, TimeFunction};
use crate::units::Scaled;

/// A pin in a sleeve: leaves rotation about an axis and displacement along it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Cylindrical {
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
    /// Prescribes the angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<AngularDrive>,
    /// A torsion spring and a damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<AngularSpring>,
    /// Prescribes the displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feed: Option<LinearDrive>,
}

impl JointKind for Cylindrical {
    fn word(&self) -> &'static str {
        "cylindrical"
    }

    fn noun(&self) -> &'static str {
        "cylindrical joint"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        4
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let axis = Vector3::from(self.axis).normalize();
        let measures = measures::cylindrical(builder.a(), builder.b(), axis);
        builder.keep(&[(measures::GUIDE, 2), (measures::AXIS, 2)], measures);
        builder.angle(axis, &self.angular_actuation());
        builder.displacement(axis, &self.linear_actuation());
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a cylindrical joint")); 2]
    }

    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        let drive = self.drive.iter().map(|drive| (".drive", &drive.time));
        drive.chain(self.feed.iter().map(|feed| (".feed", &feed.time))).collect()
    }

    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        let drive = self.drive.iter_mut().map(|drive| &mut drive.time);
        drive.chain(self.feed.iter_mut().map(|feed| &mut feed.time)).collect()
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }

    fn freedoms(&self) -> &'static [Freed] {
        &[Freed::Angle, Freed::Displacement]
    }

    fn angular_actuation(&self) -> JointActuation<'_> {
        JointActuation::angular(&self.drive, &self.spring, &None)
    }

    fn linear_actuation(&self) -> JointActuation<'_> {
        JointActuation { table: "feed", ..JointActuation::linear(&self.feed, &None, &None) }
    }
}
