use ancf_mechanics::constraints::MeasureTarget;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::errors::{Finding, finding, number};
use crate::joints::parts::{ClampedGradients, End, JointBuilder, JointContext, JointKind};
use crate::model::{Capability, Place, TimeFunction};
use crate::units::Scaled;

/// A clamp to a frame that rotates about the place and moves as prescribed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct DrivenClamp {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The end whose motion is prescribed; it receives the reaction.
    pub a: Place,
    /// Direction of the axis in the global frame; its length does not matter. Without one the frame does not turn.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<[f64; 3]>,
    /// Angle by which the function of time is multiplied, in radians; 1 by default.
    #[unit(radian)]
    #[serde(default = "one")]
    pub angle: f64,
    /// Displacement by which the function of time is multiplied, length; none by default.
    #[unit(length)]
    #[serde(default)]
    pub displacement: [f64; 3],
    /// Function of time; statics ignores it, turns and moves with the load.
    pub time: TimeFunction,
    /// Which gradients are tied besides the position, by default as those of a clamp.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fix: Option<ClampedGradients>,
}

fn one() -> f64 {
    1.0
}

/// Second end of a driven clamp.
static GROUND: End = End::Ground;
/// Angles below this count as zero, in radians.
const NO_ANGLE: f64 = 1e-6;
/// Displacements below this part of the length of the model count as zero.
const NO_DISPLACEMENT: f64 = 1e-6;
/// Expectation of a prescribed motion.
const STARTS: &str = "a motion that starts from the undeformed state, at 0";

impl DrivenClamp {
    fn moves(&self) -> bool {
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
        if !self.moves() {
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
        if self.moves() {
            for (measure, way) in
                measures::meeting(builder.a(), builder.b()).into_iter().zip(self.displacement)
            {
                builder.prescribe("driven position", measure, MeasureTarget::new(way, function.clone()));
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
        if self.time.jumps() {
            return vec![finding(key, "a function that jumps", "one that bodies can follow")];
        }
        let nonzero = |found: String, own: &str| {
            let error = finding(key.clone(), found, STARTS);
            vec![Finding { absence: true, ..error.rests_on([format!("{path}.{own}")]) }]
        };
        if context.is_dynamic() && angle.abs() > NO_ANGLE {
            nonzero(format!("an angle of {} at t = 0", number(angle)), "angle")
        } else if context.is_dynamic() && displacement.abs() > NO_DISPLACEMENT * context.length() {
            nonzero(format!("a displacement of {} at t = 0", number(displacement)), "displacement")
        } else {
            Vec::new()
        }
    }
}
