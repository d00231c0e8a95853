use ancf_mechanics::forces::FollowerForce;
use ancf_mechanics::kinematics::BodyVector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{AxisPart, LoadBuilder, LoadContext, LoadKind, end, start};
use crate::errors::Finding;
use crate::model::{At, Capability, TimeFunction};
use crate::units::Scaled;

/// Force per length along the axis of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct DistributedForce {
    /// Name of the body.
    pub body: String,
    /// Start of the load; the start of the axis by default.
    #[serde(default = "start")]
    pub from: At,
    /// End of the load; the end of the axis by default.
    #[serde(default = "end")]
    pub to: At,
    /// Force per undeformed length in the global frame, of a follower in the frame of each section; force/length.
    #[unit(force / length)]
    pub force: [f64; 3],
    /// Force per undeformed length at `to`, force/length. The load varies linearly from `force` at `from`. Constant by
    /// default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(force / length)]
    pub force_end: Option<[f64; 3]>,
    /// True for a load that rotates with the sections.
    #[serde(default)]
    pub follower: bool,
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for DistributedForce {
    fn noun(&self) -> &'static str {
        "force per length"
    }

    fn label(&self) -> &'static str {
        if self.follower { "follower force per length" } else { self.noun() }
    }

    fn is_known_within_elements(&self) -> bool {
        !self.follower && self.part().is_whole()
    }

    /// Adds a dead load as the nodal forces that do its work exactly on a cubic axis, a follower by integration points.
    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let Some((body, mesh)) = builder.flexible(&self.body) else { return };
        let (span, function) = (self.part().span(body), builder.function(&self.time));
        if self.follower {
            for (s, force) in span.points(mesh) {
                let Some(frame) = mesh.frame(s) else { return };
                let force = BodyVector::turned(&frame, frame.composed(&force));
                builder.add(FollowerForce::new(mesh.point(s), force, function.clone()));
            }
            return;
        }
        let ([from, to], [first, last]) = (span.ends, span.loads);
        for element in mesh.element_spans(from..to) {
            let mut add = |weight: &dyn Fn(f64) -> f64, force| {
                builder.force(mesh.distributed_marker(&element, weight), force, function.clone());
            };
            if first == last {
                add(&|_| 1.0, first);
            } else {
                add(&|s| 1.0 - span.fraction(s), first);
                add(&|s| span.fraction(s), last);
            }
        }
    }

    fn along(&self) -> Option<AxisPart<'_>> {
        Some(self.part())
    }

    fn bodies(&self) -> Vec<(String, &str)> {
        vec![("body".into(), &self.body)]
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

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        self.part().check(path, context)
    }
}

impl DistributedForce {
    fn part(&self) -> AxisPart<'_> {
        let loads = [self.force, self.force_end.unwrap_or(self.force)];
        AxisPart { body: &self.body, from: &self.from, to: &self.to, loads }
    }
}
