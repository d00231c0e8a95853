use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::{Finding, finding};
use crate::joints::parts::{End, JointBuilder, JointContext, JointKind, JointSymbol};
use crate::model::{JointLaw, LawKind, LawUse, Place};
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
    /// Law of a tensile force in addition, by the elongation x beyond the length at zero force, its rate v, and `length`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<JointLaw>,
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
        if self.tension.is_none() || self.stiffness > 0.0 || self.damping > 0.0 {
            builder.strut([self.stiffness, self.damping], self.length, self.tension_only);
        }
        if let Some(law) = &self.tension {
            builder.tension(law, self.length);
        }
    }

    fn laws(&self) -> Vec<LawUse<'_>> {
        self.tension.iter().map(|law| LawUse::new(law, LawKind::Tension)).collect()
    }

    fn laws_mut(&mut self) -> Vec<&mut JointLaw> {
        self.tension.iter_mut().collect()
    }

    fn check(&self, path: &str, _: &dyn JointContext) -> Vec<Finding> {
        let only_law = self.tension.is_some() && self.stiffness == 0.0 && self.damping == 0.0;
        let expected = "a stiffness or damping to which it applies; a formula is limited by `max(0, ..)`";
        let error = || finding(format!("{path}.tension_only"), "`tension_only` of a force law", expected);
        (self.tension_only && only_law).then(error).into_iter().collect()
    }

    fn spans(&self) -> bool {
        true
    }

    fn symbol(&self) -> JointSymbol {
        JointSymbol::Line(match (self.tension_only, self.stiffness) {
            (true, _) => "rope",
            (false, 0.0) if self.tension.is_none() => "damper",
            (false, _) => "spring",
        })
    }
}
