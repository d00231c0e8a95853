use std::sync::Arc;

use ancf_solver::equations::{Energy, LOCAL, Local, LocalMatrix, State, Term, Weights};

use super::signal::{Signal, Variable};
use crate::constraints::Wrench;
use crate::laws::{LawState, LawUnits, LawValue, StateLaw};

/// Force along one coordinate by a law with states of first order and signals: f(t, x, v, z, s), dz/dt = g(t, x, v, z, s).
///
/// Each state has a coordinate y with z = z₀ + dy/dt: the equation m (ÿ − g) = 0 is one of second order, with a constant mass and
/// consistent accelerations. The mass m = E/(z T)² with a typical energy E of the model and a typical magnitude of the state
/// determines the accuracy of z only. The coordinates have no energy; the force supplies work at zero rate v, and the rest
/// dissipates. Signals are quantities of other parts of the model in the same state.
///
/// The tangent lacks the derivatives of the force by states and signals, and of the rates of states by x, v, signals and other states,
/// which are not symmetric ([`Term::omitted_stiffness`]). Newton's method converges linearly, by a factor of the order of the step
/// squared, or of the step for signals that are rates.
///
/// Units: the force is energy per unit of the coordinate.
#[derive(Clone, Debug)]
pub struct StateForce {
    /// Coordinate x, y of each state, and the coordinates of the signals.
    coordinates: Vec<usize>,
    law: Arc<StateLaw>,
    units: LawUnits,
    /// Mass of each state.
    masses: Vec<f64>,
    signals: Vec<Signal>,
}

/// Largest number of states of a law, and of its signals.
pub(crate) const STATES: usize = 8;

/// Values of states and signals.
type Values = [f64; 2 * STATES];

impl StateForce {
    /// Creates the force with its coordinates x, y₁, y₂, …, the typical energies E/z² of the states, and the signals.
    ///
    /// # Panics
    /// If the numbers of states or signals differ or exceed eight. This is a programming error, not an input error.
    pub fn new(
        mut coordinates: Vec<usize>,
        law: Arc<StateLaw>,
        units: LawUnits,
        energies: Vec<f64>,
        signals: &[Signal],
    ) -> Self {
        assert!(law.states() <= STATES && law.signals() <= STATES, "at most {STATES} states and signals");
        assert_eq!(coordinates.len(), law.states() + 1);
        assert_eq!(energies.len(), law.states());
        assert_eq!(signals.len(), law.signals());
        let masses = energies.iter().map(|energy| energy / units.time.powi(2)).collect();
        let mut others: Vec<usize> = signals.iter().flat_map(Signal::coordinates).collect();
        others.sort_unstable();
        others.dedup();
        others.retain(|other| !coordinates.contains(other));
        coordinates.extend(others);
        let signals = signals.iter().map(|signal| signal.within(&coordinates)).collect();
        Self { coordinates, law, units, masses, signals }
    }

    /// State of the law at a rate of x, with the values of its states and signals.
    fn state(&self, at: &Local<'_>, rate: f64) -> (LawState, Values) {
        let LawUnits { position, time, .. } = self.units;
        let mut z = [0.0; 2 * STATES];
        for (k, start) in self.law.start().iter().enumerate() {
            z[k] = start + at.v[k + 1] / time;
        }
        let of_signals = z[self.masses.len()..].iter_mut().zip(&self.signals);
        of_signals.for_each(|(value, signal)| *value = signal.at(at));
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
        let [rate, by_state] = self.law.rate_by(k, k, state, &z);
        [rate * time * time, by_state * time]
    }

    /// Bound of the rounding error of row i by those of states and signals.
    fn rounding_of_variables(&self, i: usize, at: &Local<'_>) -> f64 {
        let count = self.masses.len();
        let of = |j: usize| match j.checked_sub(count) {
            Some(signal) => self.derivative(i, j, at) * self.signals[signal].rounding(at),
            None => {
                let [start, rate] = [self.law.start()[j], at.v[j + 1] / self.units.time];
                8.0 * f64::EPSILON * self.derivative(i, j, at) * (start.abs() + rate.abs())
            }
        };
        (0..count + self.signals.len()).map(|j| of(j).abs()).sum()
    }

    /// Derivative of row i by the state or signal j.
    fn derivative(&self, i: usize, j: usize, at: &Local<'_>) -> f64 {
        let (state, z) = self.state(at, at.v[0]);
        match i.checked_sub(1) {
            None => -self.law.force_by(j, state, &z) / self.units.force,
            Some(k) => -self.masses[k] * self.units.time.powi(2) * self.law.rate_by(k, j, state, &z)[1],
        }
    }

    /// Visits the derivatives by coordinates or rates that the tangent lacks.
    fn visit_omitted(&self, at: &Local<'_>, by: Variable, visit: &mut dyn FnMut(usize, usize, f64)) {
        let LawUnits { position, time, .. } = self.units;
        let count = self.masses.len();
        for i in 0..=count {
            let mut row = [0.0; LOCAL];
            let row = &mut row[..at.q.len()];
            if let Some(k) = i.checked_sub(1) {
                let (state, z) = self.state(at, at.v[0]);
                let rate = self.law.rate(k, state, &z);
                let factor = -self.masses[k] * time * time * position;
                row[0] += match by {
                    Variable::Coordinates => factor * rate.by_position,
                    Variable::Rates => factor * rate.by_rate / time,
                };
            }
            for j in 0..count {
                if by == Variable::Rates && i != j + 1 {
                    row[j + 1] += self.derivative(i, j, at) / time;
                }
            }
            for (s, signal) in self.signals.iter().enumerate() {
                signal.add_derivative(at, by, self.derivative(i, count + s, at), row);
            }
            row.iter().enumerate().filter(|(_, x)| **x != 0.0).for_each(|(j, x)| visit(i, j, *x));
        }
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
        floor[0] += 8.0 * f64::EPSILON * (force.abs() + own) + self.rounding_of_variables(0, at);
        for (k, mass) in self.masses.iter().enumerate() {
            let acceleration = self.acceleration(k, at)[0];
            let size = at.a[k + 1].abs() + acceleration.abs();
            floor[k + 1] += 8.0 * f64::EPSILON * mass * size + self.rounding_of_variables(k + 1, at);
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

    fn omitted_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        self.visit_omitted(at, Variable::Coordinates, visit);
    }

    fn omitted_damping(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        self.visit_omitted(at, Variable::Rates, visit);
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
