use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{End, JointBuilder, JointKind, JointSymbol};
use crate::model::Place;
use crate::units::Scaled;

/// Spring and damper between two points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct PointSpring {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end: a place or a point of the ground, at a distance from `a`.
    pub b: End,
    /// Stiffness, force/length.
    #[unit(force / length)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub stiffness: f64,
    /// Damping, force time/length.
    #[unit(force * time / length)]
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Length at zero force, length. By default the distance in the undeformed state.
    #[unit(length)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0))]
    pub length: Option<f64>,
    /// True for tension only, as in a rope.
    #[serde(default)]
    pub tension_only: bool,
}

impl JointKind for PointSpring {
    fn word(&self) -> &'static str {
        "spring"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        0
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        builder.strut([self.stiffness, self.damping], self.length, self.tension_only);
    }

    fn spans(&self) -> bool {
        true
    }

    fn symbol(&self) -> JointSymbol {
        JointSymbol::Line(match (self.tension_only, self.stiffness) {
            (true, _) => "rope",
            (false, 0.0) => "damper",
            (false, _) => "spring",
        })
    }
}
