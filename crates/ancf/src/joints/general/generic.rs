use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axes::{directions, frame, rule_of_axes};
use crate::errors::{Finding, finding};
use crate::joints::parts::{
    End, JointActions, JointBuilder, JointContext, JointCoordinate, JointKind, measures,
};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Motion along or about one axis of a generic joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DirectionMotion {
    /// Constrained to zero.
    Locked,
    /// Without constraint.
    Free,
}

/// Generic joint: constrains chosen displacements and rotations of `a` relative to `b`.
///
/// The displacements are along the axes of `b`. Rotations: with two locked ones, the axis of the free one stays parallel at both ends.
/// With one locked rotation the joint is a universal joint, whose cross has the first free axis, in the order x, y, z, x, after the
/// locked one fixed to `a`, and the second one to `b`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Generic {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the axes are fixed; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Displacements along the x-, y- and z-axis.
    #[unit(none)]
    pub displacements: [DirectionMotion; 3],
    /// Rotations about the x-, y- and z-axis.
    #[unit(none)]
    pub rotations: [DirectionMotion; 3],
    /// Direction of the x-axis in the undeformed state, in the global frame; global x by default. Its magnitude has no effect.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x_axis: Option<[f64; 3]>,
    /// Direction of the y-axis, perpendicular to the x-axis; global y by default.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y_axis: Option<[f64; 3]>,
}

/// Numbers of the directions with a motion.
fn with(motions: [DirectionMotion; 3], motion: DirectionMotion) -> Vec<usize> {
    (0..3).filter(|&k| motions[k] == motion).collect()
}

/// Number of the single free direction, if there is one.
fn single(motions: [DirectionMotion; 3]) -> Option<usize> {
    match with(motions, DirectionMotion::Free)[..] {
        [free] => Some(free),
        _ => None,
    }
}

impl JointKind for Generic {
    fn word(&self) -> &'static str {
        "generic"
    }

    fn noun(&self) -> &'static str {
        "generic joint"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        let locked = |motions| with(motions, DirectionMotion::Locked).len();
        locked(self.displacements) + locked(self.rotations)
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let axes = frame([self.x_axis, self.y_axis]);
        let (a, b) = (builder.a(), builder.b());
        let locked = with(self.displacements, DirectionMotion::Locked);
        match locked.len() {
            3 => builder.coincide(),
            count => {
                let rows = locked.iter().map(|&k| measures::along(a, b, axes[k])).collect();
                builder.keep(&[(measures::GUIDE, count)], rows);
            }
        }
        let rows: Vec<_> = match with(self.rotations, DirectionMotion::Locked)[..] {
            // Two locked rotations keep the axis of the free one; three also keep a normal of it.
            [_, _] | [_, _, _] => {
                let free = single(self.rotations).unwrap_or(0);
                let [e, u, v] = [0, 1, 2].map(|k| axes[(free + k) % 3]);
                let normal = [u, v].map(|normal| measures::angle(a, b, e, normal));
                let about = (self.removes_all_rotations()).then(|| measures::angle(a, b, u, v));
                normal.into_iter().chain(about).collect()
            }
            [locked] => vec![measures::angle(a, b, axes[(locked + 1) % 3], axes[(locked + 2) % 3])],
            _ => Vec::new(),
        };
        match (rows.len(), single(self.rotations)) {
            (3, _) => builder.expect_aligned(&axes),
            (2, Some(free)) => builder.expect_aligned(&[axes[free]]),
            _ => {}
        }
        builder.keep(&[("rotation", rows.len())], rows);
        if let Some(free) = single(self.rotations) {
            builder.angle(axes[free], &JointActions::default());
        }
        if let Some(free) = single(self.displacements) {
            builder.displacement(axes[free], &JointActions::default());
        }
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        let turns = !with(self.rotations, DirectionMotion::Locked).is_empty();
        let moves = !with(self.displacements, DirectionMotion::Free).is_empty();
        let need = |is_needed: bool| is_needed.then_some((Capability::Section, "a generic joint"));
        [need(turns), need(turns || moves)]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        directions([self.x_axis, self.y_axis])
    }

    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        match (single(self.rotations), single(self.displacements)) {
            (Some(_), Some(_)) => &[JointCoordinate::Angle, JointCoordinate::Displacement],
            (Some(_), None) => &[JointCoordinate::Angle],
            (None, Some(_)) => &[JointCoordinate::Displacement],
            (None, None) => &[],
        }
    }

    fn check(&self, path: &str, _: &dyn JointContext) -> Vec<Finding> {
        let expected = "at least one locked direction";
        let none = || finding(format!("{path}.rotations"), "six free directions", expected);
        let none = (self.removes() == 0).then(none);
        none.into_iter().chain(rule_of_axes(path, [self.x_axis, self.y_axis])).collect()
    }
}

impl Generic {
    fn removes_all_rotations(&self) -> bool {
        self.rotations == [DirectionMotion::Locked; 3]
    }
}
