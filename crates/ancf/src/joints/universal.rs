use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::errors::{Finding, finding};
use crate::joints::parts::{AngularFriction, End, JointBuilder, JointContext, JointFriction, JointKind};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Sine of the angle below which two axes count as parallel.
const PARALLEL: f64 = 1e-3;

/// Cardan joint of two shafts: constrains the position and the angle between the arms of the cross.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Universal {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end; the ground by default.
    #[serde(default)]
    pub b: End,
    /// Direction of the arm of the cross that is fixed to `a`, in the undeformed state, in the global frame.
    #[unit(none)]
    pub axis_a: [f64; 3],
    /// Direction of the arm of the cross that is fixed to `b`, in the undeformed state, in the global frame. Not parallel to
    /// `axis_a`.
    #[unit(none)]
    pub axis_b: [f64; 3],
    /// Dry friction of the bearings of each arm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<AngularFriction>,
}

impl JointKind for Universal {
    fn word(&self) -> &'static str {
        "universal"
    }

    fn noun(&self) -> &'static str {
        "universal joint"
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
        let arms = [self.axis_a, self.axis_b].map(|axis| Vector3::from(axis).normalize());
        let measures = measures::universal(builder.a(), builder.b(), arms);
        builder.keep(&[(measures::POSITION, 3), ("angle of the arms", 1)], measures);
        if let Some(friction) = self.friction() {
            builder.add_cross_friction(arms, &friction);
        }
    }

    fn friction(&self) -> Option<JointFriction> {
        self.friction.map(AngularFriction::law)
    }

    fn bearing_keys(&self) -> &'static [&'static str] {
        &["radius", "span"]
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a universal joint")); 2]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis_a", self.axis_a), ("axis_b", self.axis_b)]
    }

    fn check(&self, path: &str, _context: &dyn JointContext) -> Vec<Finding> {
        let [a, b] = [self.axis_a, self.axis_b].map(|axis| Vector3::from(axis).normalize());
        // A zero direction has a zero cross product; it is reported by another check.
        let parallel = a.cross(&b).norm() < PARALLEL;
        let found = parallel.then(|| {
            let key = format!("{path}.axis_b");
            let error = finding(key, "a direction parallel to `axis_a`", "a direction of its own");
            error.rests_on([format!("{path}.axis_a")])
        });
        found.into_iter().collect()
    }
}
