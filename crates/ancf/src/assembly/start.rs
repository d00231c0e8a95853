//! Initial velocities.

use ancf_solver::dynamics::{SchemeCoefficients, remove_velocity_error};
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

    /// State of a motion with velocities that satisfy its constraints, without the error of steps h of a scheme. `None` if the matrix of
    /// the steps is singular, or if the rate of a drive is infinite.
    ///
    /// A motion may end at a jump of a drive. The velocities are those before the jump.
    pub(crate) fn without_velocity_error(
        &self,
        s: &State,
        scheme: SchemeCoefficients,
        h: f64,
    ) -> Option<State> {
        let mut before = State { t: s.t.next_down().max(0.0), ..s.clone() };
        remove_velocity_error(&self.system, &mut self.system.matrix(), &mut before, (scheme, h)).ok()?;
        before.v.iter().all(|v| v.is_finite()).then_some(State { t: s.t, ..before })
    }

    /// State with the initial velocities of the bodies of the model added.
    pub(crate) fn with_motions(&self, mut s: State, model: &Model) -> State {
        for (body, (_, built)) in model.bodies.iter().zip(self.bodies()) {
            if body.motion().is_rest() {
                continue;
            }
            let vectors = built.vectors(&s);
            // The first vector of other bodies is where the axis starts, or the centre.
            let first = || vectors.first().map_or_else(Vector3::zeros, |vector| vector.value);
            let about = if built.is_shell() { built.momentum(&s).center() } else { first() };
            // Along a shape that does not change, r(x, t) = r(x + u t): all vectors have the rates u ∂/∂x.
            let axial = built.mesh().filter(|_| body.motion().axial != 0.0);
            let axial = axial.map_or_else(Vec::new, |mesh| mesh.axial_derivatives(&s));
            for (i, vector) in vectors.iter().enumerate() {
                let along = axial.get(i).map_or_else(Vector3::zeros, |rate| rate * body.motion().axial);
                let velocity = body.motion().of(vector, about) + along;
                let own = &mut s.v[vector.first..vector.first + 3];
                own.iter_mut().zip(&velocity).for_each(|(v, change)| *v += change);
            }
        }
        s
    }
}
