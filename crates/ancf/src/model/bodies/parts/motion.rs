use ancf_mechanics::kinematics::NodalVector;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Initial motion of a body: the velocity field of a rigid body, v(r) = v₀ + ω × (r − c), plus a motion along its own axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct InitialMotion {
    /// Velocity v₀ of the point `about`, length/time.
    #[unit(length / time)]
    pub velocity: [f64; 3],
    /// Angular velocity ω in the global frame, radians/time.
    #[unit(radian / time)]
    pub spin: [f64; 3],
    /// Point c, length; the start of the axis, or the centre of mass of a rigid body or shell, by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[unit(length)]
    pub about: Option<[f64; 3]>,
    /// Speed of a beam or cable along its own axis towards its end, length/time. Its shape does not change.
    #[unit(length / time)]
    pub axial: f64,
}

impl InitialMotion {
    /// True if all keys have their defaults: the body starts at rest.
    pub fn is_rest(&self) -> bool {
        self.velocity == [0.0; 3] && self.spin == [0.0; 3] && self.about.is_none() && self.axial == 0.0
    }

    /// Velocity of a nodal vector of a body. `default` is the point c by default.
    ///
    /// A position has v₀ + ω × (r − c), a direction ω × d.
    pub(crate) fn of(&self, vector: &NodalVector, default: Vector3<f64>) -> Vector3<f64> {
        let spin = Vector3::from(self.spin);
        if !vector.is_position() {
            return spin.cross(&vector.value);
        }
        let about = self.about.map_or(default, Vector3::from);
        Vector3::from(self.velocity) + spin.cross(&(vector.value - about))
    }
}
