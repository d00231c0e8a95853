use std::ops::Range;

use ancf_solver::equations::{
    Energy, Inadmissibility, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual,
};

use crate::functions::Function;

/// Gas in an enclosed volume V₀ + v, with the massless coordinate v: U = −∫ (p − p_a) dv.
///
/// p = [p_a + s (p₀ − p_a)] (m(t) V₀/V)^κ, with the pressure p_a outside, the exponent κ of a polytropic change and the amount m of gas relative to
/// that in the undeformed state. Added gas has the state of the gas inside. The load factor s of statics brings the gas from the
/// pressure outside to p₀. The gas has no mass.
///
/// The constraint of [`EnclosedVolume`](super::EnclosedVolume) determines v; its multiplier is p_a − p. The energy is zero at V₀. The rate of m supplies the power
/// ∂U/∂t.
///
/// Units: p pressure, V volume.
#[derive(Clone, Debug)]
pub struct GasPressure {
    coordinate: [usize; 1],
    multiplier: usize,
    volume: f64,
    pressure: f64,
    ambient: f64,
    exponent: f64,
    amount: Function,
}

impl GasPressure {
    /// Creates a gas in the undeformed volume V₀, with the coordinate v and the multiplier of its constraint.
    ///
    /// `pressures` are p₀ and p_a.
    pub fn new(
        (coordinate, multiplier): (usize, usize),
        volume: f64,
        [pressure, ambient]: [f64; 2],
        exponent: f64,
        amount: Function,
    ) -> Self {
        Self { coordinate: [coordinate], multiplier, volume, pressure, ambient, exponent, amount }
    }

    /// Returns the volume of the gas and its pressure in a state.
    pub fn volume_and_pressure(&self, s: &State) -> [f64; 2] {
        let v = s.q[self.coordinate[0]];
        [self.volume + v, self.absolute(v, s.t, s.load)]
    }

    /// Returns the undeformed volume V₀.
    pub const fn reference_volume(&self) -> f64 {
        self.volume
    }

    /// Returns ln(V/V₀).
    fn logarithm(&self, v: f64) -> f64 {
        (v / self.volume).ln_1p()
    }

    /// Returns the pressure of the amount m = 1 in the undeformed volume.
    fn initial(&self, load: f64) -> f64 {
        self.ambient + load * (self.pressure - self.ambient)
    }

    fn absolute(&self, v: f64, t: f64, load: f64) -> f64 {
        let amount = self.amount.value(t).powf(self.exponent);
        self.initial(load) * amount * (-self.exponent * self.logarithm(v)).exp()
    }

    /// Returns V₀ [1 − (V/V₀)^(1−κ)]/(1 − κ), minus the integral of (V₀/V)^κ.
    fn integral(&self, v: f64) -> f64 {
        let l = self.logarithm(v);
        let z = (1.0 - self.exponent) * l;
        -self.volume * l * if z == 0.0 { 1.0 } else { z.exp_m1() / z }
    }
}

/// Position of v among the unknowns of the term, and of the multiplier.
const V: usize = 0;
const ROW: usize = 1;

impl Term for GasPressure {
    fn coordinates(&self) -> &[usize] {
        &self.coordinate
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn massless(&self) -> &[usize] {
        &self.coordinate
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, _: usize) -> String {
        "volume".into()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[V] += self.ambient - self.absolute(at.q[V], at.t, at.load) - at.lambda[0];
        r[ROW] -= at.q[V];
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let pressure = self.absolute(at.q[V], at.t, at.load);
        let stiffness = self.exponent * pressure / (self.volume + at.q[V]);
        floor[V] +=
            f64::EPSILON * (self.ambient + 8.0 * pressure + stiffness * at.q[V].abs() + at.lambda[0].abs());
        floor[ROW] += f64::EPSILON * at.q[V].abs();
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let stiffness = self.exponent * self.absolute(at.q[V], at.t, at.load) / (self.volume + at.q[V]);
        k.add(V, V, w.q * stiffness);
        k.add(ROW, V, -1.0);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        discrete_residual(self, step, r);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let amount = self.amount.value(at.t).powf(self.exponent);
        let of_gas = self.initial(at.load) * amount * self.integral(at.q[V]);
        Energy { potential: of_gas + self.ambient * at.q[V], ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let amount = self.amount.at(at.t);
        let rate = self.exponent * amount.value.powf(self.exponent - 1.0) * amount.rate;
        self.initial(at.load) * rate * self.integral(at.q[V])
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        (self.volume + at.q[V] <= 0.0).then_some(Inadmissibility::EmptyVolume)
    }
}
