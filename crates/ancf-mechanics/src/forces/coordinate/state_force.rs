use std::sync::Arc;

use ancf_solver::equations::{Energy, Local, LocalMatrix, State, Term, Weights};

use crate::constraints::Wrench;
use crate::laws::{LawState, LawUnits, LawValue, StateLaw};

/// Force along one coordinate by a law with states of first order: f(t, x, v, z), dz/dt = g(t, x, v, z).
///
/// Each state has a coordinate y with z = z₀ + dy/dt: the equation m (ÿ − g) = 0 is one of second order, with a constant mass and
/// consistent accelerations. The mass m = E/(z T)² with a typical energy E of the model and a typical magnitude of the state
/// determines the accuracy of z only. The coordinates have no energy; the force supplies work at zero rate v, and the rest
/// dissipates.
///
/// The tangent lacks the derivatives of the force by the states, and of their rates by x, v and other states, which are not
/// symmetric. Newton's method converges linearly, by a factor of the order of the step squared.
///
/// Units: the force is energy per unit of the coordinate.
#[derive(Clone, Debug)]
pub struct StateForce {
    /// Coordinate x, then y of each state.
    coordinates: Vec<usize>,
    law: Arc<StateLaw>,
    units: LawUnits,
    /// Mass of each state.
    masses: Vec<f64>,
}

/// Largest number of states of a law.
pub(crate) const STATES: usize = 8;

impl StateForce {
    /// Creates the force with its coordinates x, y₁, y₂, … and the typical energies E/z² of the states.
    ///
    /// # Panics
    /// If the numbers of states differ or exceed eight. This is a programming error, not an input error.
    pub fn new(coordinates: Vec<usize>, law: Arc<StateLaw>, units: LawUnits, energies: Vec<f64>) -> Self {
        assert!(law.states() <= STATES, "at most {STATES} states");
        assert_eq!(coordinates.len(), law.states() + 1);
        assert_eq!(energies.len(), law.states());
        let masses = energies.iter().map(|energy| energy / units.time.powi(2)).collect();
        Self { coordinates, law, units, masses }
    }

    /// State of the law at a rate of x, with the values of its states.
    fn state(&self, at: &Local<'_>, rate: f64) -> (LawState, [f64; STATES]) {
        let LawUnits { position, time, .. } = self.units;
        let mut z = [0.0; STATES];
        for (k, start) in self.law.start().iter().enumerate() {
            z[k] = start + at.v[k + 1] / time;
        }
        (LawState { t: at.t * time, x: at.q[0] * position, v: rate * position / time }, z)
    }

    /// Resistance to the increase of the coordinate at a rate, with its derivatives.
    fn resistance(&self, at: &Local<'_>, rate: f64) -> LawValue {
        let LawUnits { position, time, force } = self.units;
        let (state, z) = self.state(at, rate);
        let value = self.law.force(state, &z);
        LawValue {
            force: -value.force / force,
            by_position: -value.by_position * position / force,
            by_rate: -value.by_rate * position / (time * force),
        }
    }

    /// Acceleration of the coordinate of a state that satisfies its equation, and its derivative by the rate of the coordinate.
    fn acceleration(&self, k: usize, at: &Local<'_>) -> [f64; 2] {
        let time = self.units.time;
        let (state, z) = self.state(at, at.v[0]);
        let [rate, by_state] = self.law.rate(k, state, &z);
        [rate * time * time, by_state * time]
    }

    /// Returns zero: the equation that defines the coordinate has the reaction.
    pub fn reaction(&self, _: &State) -> Wrench {
        Wrench::default()
    }
}

impl Term for StateForce {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += self.resistance(at, at.v[0]).force;
        for (k, mass) in self.masses.iter().enumerate() {
            r[k + 1] += mass * (at.a[k + 1] - self.acceleration(k, at)[0]);
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let LawValue { force, by_position, by_rate } = self.resistance(at, at.v[0]);
        let own = (by_position * at.q[0]).abs() + (by_rate * at.v[0]).abs();
        floor[0] += 8.0 * f64::EPSILON * (force.abs() + own);
        for (k, mass) in self.masses.iter().enumerate() {
            let [acceleration, by_rate] = self.acceleration(k, at);
            let size = at.a[k + 1].abs() + acceleration.abs() + (by_rate * at.v[k + 1]).abs();
            floor[k + 1] += 8.0 * f64::EPSILON * mass * size;
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let LawValue { by_position, by_rate, .. } = self.resistance(at, at.v[0]);
        k.add(0, 0, w.q * by_position + w.v * by_rate);
        for (i, mass) in self.masses.iter().enumerate() {
            let slope = if w.v == 0.0 { 0.0 } else { self.acceleration(i, at)[1] };
            k.add(i + 1, i + 1, mass * (w.a - w.v * slope));
        }
    }

    fn energy(&self, _: &Local<'_>) -> Energy {
        Energy::default()
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        // The residuals of the states, zero in a solution, do no work.
        let of_states =
            |(k, mass): (usize, &f64)| mass * (at.a[k + 1] - self.acceleration(k, at)[0]) * at.v[k + 1];
        -at.v[0] * self.resistance(at, 0.0).force - self.masses.iter().enumerate().map(of_states).sum::<f64>()
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += self.resistance(at, at.v[0]).force - self.resistance(at, 0.0).force;
    }
}
