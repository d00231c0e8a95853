use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::joints::parts::{End, JointActions, JointBuilder, JointFriction, JointKind, LinearFriction};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Point on a straight line: allows displacement along the line and all rotations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct PointOnLine {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the line is fixed; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the line in the undeformed state, in the global frame. Its magnitude has no effect.
    #[unit(none)]
    pub axis: [f64; 3],
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
}

impl JointKind for PointOnLine {
    fn word(&self) -> &'static str {
        "point_on_line"
    }

    fn noun(&self) -> &'static str {
        "point on a line"
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
        let axis = Vector3::from(self.axis).normalize();
        let measures = measures::on_line(builder.a(), builder.b(), axis);
        builder.keep(&[(measures::GUIDE, 2)], measures);
        builder.displacement(axis, &JointActions::default());
        if let Some(friction) = self.friction() {
            builder.add_line_friction(axis, &friction);
        }
    }

    fn friction(&self) -> Option<JointFriction> {
        self.friction.map(LinearFriction::law)
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [None, Some((Capability::Section, "a guide line"))]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }
}
