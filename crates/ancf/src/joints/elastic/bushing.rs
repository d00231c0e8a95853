use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{End, JointBuilder, JointKind, JointSymbol, measures};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Bushing: springs and dampers between two coincident places, along and about three axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Bushing {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the axes are fixed; the ground by default. The axes are initially parallel to the global axes.
    #[serde(default)]
    pub b: End,
    /// Stiffnesses along x, y, z, force/length, and about x, y, z, force length.
    #[unit([force / length; 3], [force * length / radian; 3])]
    pub stiffness: [f64; 6],
    /// Dampings along x, y, z, force time/length, and about x, y, z, force length time; none by default.
    #[unit([force * time / length; 3], [force * length * time / radian; 3])]
    #[serde(default)]
    pub damping: [f64; 6],
}

impl JointKind for Bushing {
    fn word(&self) -> &'static str {
        "bushing"
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
        for (k, measure) in measures::bushing(builder.a(), builder.b()).into_iter().enumerate() {
            if self.stiffness[k] > 0.0 || self.damping[k] > 0.0 {
                builder.spring(measure, self.stiffness[k], self.damping[k]);
            }
        }
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a bushing")); 2]
    }

    fn symbol(&self) -> JointSymbol {
        JointSymbol::Line("bushing")
    }
}
