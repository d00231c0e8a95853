use ancf_mechanics::kinematics::NodalVector;
use ancf_solver::equations::State;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::body::Body;
use crate::assembly::Assembly;
use crate::model::Model;
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
    fn of(&self, vector: &NodalVector, start: Vector3<f64>) -> Vector3<f64> {
        let spin = Vector3::from(self.spin);
        if !vector.is_position() {
            return spin.cross(&vector.value);
        }
        let about = self.about.map_or(start, Vector3::from);
        Vector3::from(self.velocity) + spin.cross(&(vector.value - about))
    }
}

impl Body {
    /// How it moves at the start.
    pub const fn motion(&self) -> &InitialMotion {
        match self {
            Self::Beam(beam) => &beam.motion,
            Self::Cable(cable) => &cable.motion,
            Self::Rigid(rigid) => &rigid.motion,
            Self::Mass(mass) => &mass.motion,
        }
    }
}

impl Assembly {
    /// The state in which a motion starts, with the velocities that the model states; joints may contradict them
    /// ([`consistent_velocities`](ancf_solver::dynamics::consistent_velocities)). `model` is the one that was assembled.
    pub fn start(&self, model: &Model) -> State {
        let mut s = self.initial();
        for (body, (_, built)) in model.bodies.iter().zip(self.bodies()) {
            if body.motion().is_rest() {
                continue;
            }
            let vectors = built.vectors(&s);
            // The first vector is where the axis starts, or the centre.
            let start = vectors.first().map_or_else(Vector3::zeros, |vector| vector.value);
            for vector in &vectors {
                let velocity = body.motion().of(vector, start);
                s.v[vector.first..vector.first + 3].copy_from_slice(velocity.as_slice());
            }
        }
        s
    }
}
