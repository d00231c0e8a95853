use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::joints::parts::{
    AngularDrive, AngularSpring, End, JointActions, JointBuilder, JointCoordinate, JointFriction, JointKind,
    LinearDrive, LinearFriction,
};
use crate::model::{Capability, JointLaw, LawKind, Place, TimeFunction};
use crate::units::Scaled;

/// Cylindrical joint: allows rotation about an axis and displacement along it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Cylindrical {
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
    /// Prescribed angle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drive: Option<AngularDrive>,
    /// Torsion spring and damper.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spring: Option<AngularSpring>,
    /// Prescribed displacement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub feed: Option<LinearDrive>,
    /// Dry friction against the rotation and the displacement together: the slip at `radius` has both components.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<LinearFriction>,
    /// Law of a moment on `a` about the axis, by the angle x, in radians, and its rate v.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment: Option<JointLaw>,
    /// Law of a force on `a` along the axis, by the displacement x and its rate v.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<JointLaw>,
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
        builder.expect_aligned(&[axis]);
        builder.angle(axis, &self.angle_actions());
        builder.displacement(axis, &self.displacement_actions());
        if let Some(friction) = self.friction() {
            builder.add_sleeve_friction(axis, &friction);
        }
    }

    fn friction(&self) -> Option<JointFriction> {
        self.friction.map(LinearFriction::law)
    }

    fn bearing_keys(&self) -> &'static [&'static str] {
        &["radius", "span"]
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

    fn laws_mut(&mut self) -> Vec<&mut JointLaw> {
        self.moment.iter_mut().chain(&mut self.force).collect()
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }

    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        &[JointCoordinate::Angle, JointCoordinate::Displacement]
    }

    fn angle_actions(&self) -> JointActions<'_> {
        JointActions::along_angle(&self.drive, &self.spring, &None).with_law(&self.moment, LawKind::Moment)
    }

    fn displacement_actions(&self) -> JointActions<'_> {
        JointActions { table: "feed", ..JointActions::along_displacement(&self.feed, &None, &None) }
            .with_law(&self.force, LawKind::Force)
    }
}
