use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{
    AngularDrive, AngularFriction, AngularSpring, AngularStops, End, JointActions, JointBuilder,
    JointCoordinate, JointKind,
};
use crate::model::{Capability, JointLaw, LawKind, Place, TimeFunction};
use crate::units::Scaled;

/// Hinge: constrains the position and allows rotation about one axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Revolute {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the axis in the undeformed state, in the global frame. Its magnitude has no effect.
    #[unit(none)]
    pub axis: [f64; 3],
    /// Prescribed angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<AngularDrive>,
    /// Torsion spring and damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<AngularSpring>,
    /// Dry friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<AngularFriction>,
    /// Law of a moment on `a` about the axis, by the angle x, in radians, and its rate v.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment: Option<JointLaw>,
    /// Stops of the angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stops: Option<AngularStops>,
}

impl JointKind for Revolute {
    fn word(&self) -> &'static str {
        "revolute"
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
        builder.coincide();
        builder.parallel(axis, "hinge axis");
        builder.angle(axis, &self.angle_actions());
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a hinge")); 2]
    }

    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        self.drive.iter().map(|drive| (".drive", &drive.time)).collect()
    }

    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        self.drive.iter_mut().map(|drive| &mut drive.time).collect()
    }

    fn laws_mut(&mut self) -> Vec<&mut JointLaw> {
        self.moment.iter_mut().collect()
    }

    fn bearing_keys(&self) -> &'static [&'static str] {
        &["radius", "span", "collar"]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }

    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        &[JointCoordinate::Angle]
    }

    fn angle_actions(&self) -> JointActions<'_> {
        JointActions::along_angle(&self.drive, &self.spring, &self.friction)
            .with_law(&self.moment, LawKind::Moment)
            .with_stops(self.stops.as_ref().map(AngularStops::law))
    }

    fn closes(&self) -> bool {
        true
    }
}
