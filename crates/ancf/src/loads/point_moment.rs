use ancf_mechanics::forces::Moment;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{LoadBuilder, LoadKind};
use crate::model::{At, Capability, NamedPosition, Place, TimeFunction};
use crate::units::Scaled;

/// Moment on a section or on a rigid body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct PointMoment {
    /// Point of application.
    pub on: Place,
    /// Moment vector in the global frame, of a follower in the undeformed state; force length.
    #[unit(force * length)]
    pub moment: [f64; 3],
    /// True for a load that rotates with the section.
    #[serde(default)]
    pub follower: bool,
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for PointMoment {
    fn noun(&self) -> &'static str {
        "moment"
    }

    fn label(&self) -> &'static str {
        if self.follower { "follower moment" } else { self.noun() }
    }

    fn is_known_within_elements(&self) -> bool {
        !matches!(self.on.at, At::Named(NamedPosition::Center) | At::Length(_))
    }

    fn has_unknown_moments(&self) -> bool {
        !self.is_known_within_elements()
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let (on, function) = (builder.attachment(&self.on), builder.function(&self.time));
        let frames = on.moment_frames();
        let moment = Vector3::from(self.moment) / frames.len() as f64;
        for frame in &frames {
            builder.add(match self.follower {
                false => Moment::new(frame, moment, function.clone()),
                true => Moment::follower(frame, moment, function.clone()),
            });
        }
    }

    fn on(&self) -> Option<&Place> {
        Some(&self.on)
    }

    fn needs(&self) -> Option<(Capability, &'static str)> {
        Some((Capability::Section, "a moment"))
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
