use ancf_mechanics::constraints::MeasureTarget;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::errors::{Finding, finding, number};
use crate::joints::parts::{ClampedGradients, End, JointBuilder, JointContext, JointKind};
use crate::model::{Capability, Place, TimeFunction};
use crate::units::Scaled;

/// Clamp to a frame with prescribed rotation about the place and prescribed displacement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct DrivenClamp {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// End with prescribed motion, on which the reaction acts.
    pub a: Place,
    /// Direction of the axis of rotation in the global frame. Its magnitude has no effect. No rotation by default.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<[f64; 3]>,
    /// Angle, in radians; 1 by default. The function of time multiplies it.
    #[unit(radian)]
    #[serde(default = "one")]
    pub angle: f64,
    /// Displacement, length; zero by default. The function of time multiplies it.
    #[unit(length)]
    #[serde(default)]
    pub displacement: [f64; 3],
    /// Function of time. In statics the load factor multiplies angle and displacement instead.
    pub time: TimeFunction,
    /// Gradients that are constrained in addition to the position; by default as in a clamp.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fix: Option<ClampedGradients>,
}

fn one() -> f64 {
    1.0
}

/// Second end of a driven clamp.
static GROUND: End = End::Ground;
/// Largest initial angle that counts as zero, in radians.
const ANGLE_TOLERANCE: f64 = 1e-6;
/// Largest initial displacement that counts as zero, relative to the model length.
const DISPLACEMENT_TOLERANCE: f64 = 1e-6;
/// Expectation of a prescribed motion.
const REST_AT_START: &str = "a motion that starts from the undeformed state, at 0";

impl DrivenClamp {
    fn has_displacement(&self) -> bool {
        self.displacement != [0.0; 3]
    }
}

impl JointKind for DrivenClamp {
    fn word(&self) -> &'static str {
        "drive"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &GROUND)
    }

    fn removes(&self) -> usize {
        6
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        if !self.has_displacement() {
            builder.coincide();
        }
        let function = builder.function(&self.time);
        match self.axis {
            None => builder.clamp(self.fix),
            Some(axis) => {
                let axis = Vector3::from(axis).normalize();
                builder.prescribe_rotation(axis, self.angle, &function, self.fix);
            }
        }
        if self.has_displacement() {
            for (measure, displacement) in
                measures::meeting(builder.a(), builder.b()).into_iter().zip(self.displacement)
            {
                builder.prescribe(
                    "driven position",
                    measure,
                    MeasureTarget::new(displacement, function.clone()),
                );
            }
        }
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [self.axis.map(|_| (Capability::DrivenSection, "a drive")); 2]
    }

    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        vec![("", &self.time)]
    }

    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        vec![&mut self.time]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        self.axis.iter().map(|axis| ("axis", *axis)).collect()
    }

    fn accepts_ground_point(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        let key = format!("{path}.time");
        let start = self.time.compile().map_or(0.0, |function| function.value(0.0));
        let angle = if self.axis.is_some() { self.angle * start } else { 0.0 };
        let displacement = Vector3::from(self.displacement).norm() * start;
        if self.time.jumps(context.end_time()) {
            return vec![finding(key, "a function that jumps", "a continuous function")];
        }
        let nonzero = |found: String, own: &str| {
            let error = finding(key.clone(), found, REST_AT_START);
            vec![Finding { absence: true, ..error.rests_on([format!("{path}.{own}")]) }]
        };
        if context.starts_undeformed() && angle.abs() > ANGLE_TOLERANCE {
            nonzero(format!("an angle of {} at t = 0", number(angle)), "angle")
        } else if context.starts_undeformed()
            && displacement.abs() > DISPLACEMENT_TOLERANCE * context.length()
        {
            nonzero(format!("a displacement of {} at t = 0", number(displacement)), "displacement")
        } else {
            Vec::new()
        }
    }
}
