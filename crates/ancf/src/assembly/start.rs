//! Initial velocities.

use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::assembled::Assembly;
use crate::model::Model;

impl Assembly {
    /// Initial state with the velocities of the model. They may violate the joints
    /// ([`consistent_velocities`](ancf_solver::dynamics::consistent_velocities)). `model` is the assembled model.
    pub fn start(&self, model: &Model) -> State {
        self.with_motions(self.initial(), model)
    }

    /// State with the initial velocities of the bodies of the model.
    pub(crate) fn with_motions(&self, mut s: State, model: &Model) -> State {
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
