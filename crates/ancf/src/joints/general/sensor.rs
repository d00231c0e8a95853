use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::{Finding, finding};
use crate::joints::parts::{End, JointActions, JointBuilder, JointContext, JointCoordinate, JointKind};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Quantity that a sensor between two places measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Distance of the points.
    Distance,
    /// Displacement of `a` relative to `b` along an axis of `b`.
    Displacement,
    /// Angle of `a` relative to `b` about an axis of `b`.
    Angle,
}

/// Sensor between two places: records their distance, a displacement or an angle, without a force.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end.
    pub a: Place,
    /// Second end: a place or a point of the ground, also at a distance from `a`, or the ground at the point of `a` (not for distances).
    pub b: End,
    /// Measured quantity: the distance of the points; or the displacement or the angle of `a` relative to `b`, zero in the
    /// undeformed state.
    #[unit(none)]
    pub measure: Measure,
    /// Direction of the axis of a displacement or an angle in the undeformed state, in the global frame. It is fixed to `b`. Its
    /// magnitude has no effect.
    #[unit(none)]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<[f64; 3]>,
}

impl JointKind for Sensor {
    fn word(&self) -> &'static str {
        "sensor"
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
        let axis = Vector3::from(self.axis.unwrap_or([1.0, 0.0, 0.0])).normalize();
        match self.measure {
            Measure::Distance => builder.length(),
            Measure::Displacement => builder.displacement(axis, &JointActions::default()),
            Measure::Angle => builder.projected_angle(axis),
        }
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        let section = |is_needed: bool| is_needed.then_some((Capability::Section, "this sensor"));
        [section(self.measure == Measure::Angle), section(self.measure != Measure::Distance)]
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        self.axis.iter().map(|axis| ("axis", *axis)).collect()
    }

    fn free_coordinates(&self) -> &'static [JointCoordinate] {
        match self.measure {
            Measure::Distance => &[],
            Measure::Displacement => &[JointCoordinate::Displacement],
            Measure::Angle => &[JointCoordinate::Angle],
        }
    }

    fn spans(&self) -> bool {
        true
    }

    fn may_coincide(&self) -> bool {
        self.measure != Measure::Distance
    }

    fn check(&self, path: &str, _: &dyn JointContext) -> Vec<Finding> {
        let error = match (self.measure, self.axis) {
            (Measure::Distance, Some(_)) => ("an axis", "none for the distance of two points"),
            (Measure::Displacement | Measure::Angle, None) => {
                ("no axis", "the direction of the displacement or the axis of the angle")
            }
            _ => return Vec::new(),
        };
        let absence = self.axis.is_none();
        vec![Finding { absence, ..finding(format!("{path}.axis"), error.0, error.1) }]
    }
}
