use ancf_mechanics::forces::FollowerForce;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{LoadBuilder, LoadKind};
use crate::model::{Capability, Place, TimeFunction};
use crate::units::Scaled;

/// Force at a point of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct PointForce {
    /// Point of application.
    pub on: Place,
    /// Force vector in the global frame, of a follower in the undeformed state; force.
    #[unit(force)]
    pub force: [f64; 3],
    /// True for a load that rotates with the section.
    #[serde(default)]
    pub follower: bool,
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for PointForce {
    fn noun(&self) -> &'static str {
        "force"
    }

    fn label(&self) -> &'static str {
        if self.follower { "follower force" } else { self.noun() }
    }

    fn is_known_within_elements(&self) -> bool {
        true
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let (on, function) = (builder.attachment(&self.on), builder.function(&self.time));
        if !self.follower {
            builder.force(&on.point, self.force, function);
        } else {
            let force = on.direction(Vector3::from(self.force));
            builder.add(FollowerForce::new(&on.point, force, function));
        }
    }

    fn on(&self) -> Option<&Place> {
        Some(&self.on)
    }

    fn needs(&self) -> Option<(Capability, &'static str)> {
        self.follower.then_some((Capability::Section, "a follower"))
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    fn is_follower(&self) -> bool {
        self.follower
    }
}
