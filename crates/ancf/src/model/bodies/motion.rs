use ancf_mechanics::kinematics::NodalVector;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::{Dimension, Scales};

/// How a body moves at the start of a motion: as a rigid one, v(r) = v₀ + ω × (r − c).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct InitialMotion {
    /// Velocity v₀ of the point `about`, length/time.
    pub velocity: [f64; 3],
    /// Angular velocity ω in the global frame, radians/time.
    pub spin: [f64; 3],
    /// The point c, length; the start of the axis, or the centre of a rigid body, by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about: Option<[f64; 3]>,
}

impl InitialMotion {
    /// Whether nothing moves.
    pub fn is_rest(&self) -> bool {
        self.velocity == [0.0; 3] && self.spin == [0.0; 3] && self.about.is_none()
    }

    pub(crate) fn scaled(self, scales: &Scales) -> Self {
        let vector = |x: [f64; 3], of| x.map(|x| x / scales.unit(of));
        let Self { velocity, spin, about } = self;
        Self {
            velocity: vector(velocity, Dimension::VELOCITY),
            spin: vector(spin, Dimension::RATE),
            about: about.map(|about| vector(about, Dimension::LENGTH)),
        }
    }

    /// The velocity of a vector of a body that starts at a point: of a position v₀ + ω × (r − c), of a direction ω × d.
    pub(crate) fn of(&self, vector: &NodalVector, start: Vector3<f64>) -> Vector3<f64> {
        let spin = Vector3::from(self.spin);
        if !vector.is_position() {
            return spin.cross(&vector.value);
        }
        let about = self.about.map_or(start, Vector3::from);
        Vector3::from(self.velocity) + spin.cross(&(vector.value - about))
    }
}
