use ancf_mechanics::constraints::MeasureTarget;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::measures;
use crate::errors::{Finding, finding, number};
use crate::joints::parts::{End, JointBuilder, JointContext, JointKind, JointSymbol};
use crate::model::{Place, TimeFunction};
use crate::units::Scaled;

/// Massless rod with ball joints at its ends: constrains or prescribes the distance of two points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Distance {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end: a place or a point of the ground, at a distance from `a`.
    pub b: End,
    /// Change of the distance, length; 0 by default. The function of time multiplies it.
    #[unit(length)]
    #[serde(default)]
    pub change: f64,
    /// Function of time; 1 by default. In statics the load factor multiplies `change` instead.
    #[serde(default)]
    pub time: TimeFunction,
}

impl JointKind for Distance {
    fn word(&self) -> &'static str {
        "distance"
    }

    fn noun(&self) -> &'static str {
        "rod"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        1
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let (measure, length) = measures::half_square(builder.a(), builder.b());
        let target = MeasureTarget::of_length(length, self.change, builder.function(&self.time));
        builder.prescribe("length", measure, target);
        builder.length();
    }

    fn times(&self) -> Vec<(&'static str, &TimeFunction)> {
        vec![("", &self.time)]
    }

    fn times_mut(&mut self) -> Vec<&mut TimeFunction> {
        vec![&mut self.time]
    }

    fn spans(&self) -> bool {
        true
    }

    fn symbol(&self) -> JointSymbol {
        JointSymbol::Line("rod")
    }

    fn check(&self, path: &str, context: &dyn JointContext) -> Vec<Finding> {
        let key = format!("{path}.time");
        if self.change != 0.0 && self.time.jumps(context.end_time()) {
            return vec![finding(key, "a function that jumps", "a continuous function")];
        }
        let start = self.change * self.time.compile().map_or(0.0, |function| function.value(0.0));
        let nonzero = context.starts_undeformed() && start.abs() > 1e-6 * context.length();
        let found = nonzero.then(|| {
            let found = format!("a change of {} at t = 0", number(start));
            let error = finding(key, found, "a motion that starts from the undeformed state, at 0");
            Finding { absence: true, ..error.rests_on([format!("{path}.change")]) }
        });
        found.into_iter().collect()
    }
}
