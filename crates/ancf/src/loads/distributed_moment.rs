use ancf_mechanics::forces::Moment;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{AxisPart, LoadBuilder, LoadContext, LoadKind, end, start};
use crate::errors::Finding;
use crate::model::{At, Capability, TimeFunction};
use crate::units::Scaled;

/// Moment per length on the sections of a beam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct DistributedMoment {
    /// Name of the body.
    pub body: String,
    /// Start of the load; the start of the axis by default.
    #[serde(default = "start")]
    pub from: At,
    /// End of the load; the end of the axis by default.
    #[serde(default = "end")]
    pub to: At,
    /// Moment per undeformed length in the global frame, of a follower in the frame of each section; force.
    #[unit(force)]
    pub moment: [f64; 3],
    /// Moment per undeformed length at `to`, force. The load varies linearly from `moment` at `from`. Constant by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(force)]
    pub moment_end: Option<[f64; 3]>,
    /// True for a load that rotates with the sections.
    #[serde(default)]
    pub follower: bool,
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for DistributedMoment {
    fn noun(&self) -> &'static str {
        "moment per length"
    }

    fn label(&self) -> &'static str {
        if self.follower { "follower moment per length" } else { self.noun() }
    }

    fn is_known_within_elements(&self) -> bool {
        !self.follower && self.moment_end.is_none() && self.part().is_whole()
    }

    fn has_unknown_moments(&self) -> bool {
        self.moment_end.is_some() || !self.part().is_whole()
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let Some((body, mesh)) = builder.flexible(&self.body) else { return };
        let function = builder.function(&self.time);
        for (s, moment) in self.part().span(body).points(mesh) {
            let (Some(frame), function) = (mesh.frame(s), function.clone()) else { return };
            builder.add(match self.follower {
                true => Moment::in_section(&frame, moment, function),
                false => Moment::new(&frame, moment, function),
            });
        }
    }

    fn along(&self) -> Option<AxisPart<'_>> {
        Some(self.part())
    }

    fn bodies(&self) -> Vec<(String, &str)> {
        vec![("body".into(), &self.body)]
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

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        self.part().check(path, context)
    }
}

impl DistributedMoment {
    fn part(&self) -> AxisPart<'_> {
        let loads = [self.moment, self.moment_end.unwrap_or(self.moment)];
        AxisPart { body: &self.body, from: &self.from, to: &self.to, loads }
    }
}
