use std::ops::Range;

use ancf_solver::equations::{
    Energy, Inadmissibility, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual,
};

use crate::functions::Function;

/// Gas in an enclosed volume V₀ + v: U = −∫ (p − p_a) dv. The massless coordinate is the length x = v/A with the area A = V₀^(2/3), such that its
/// stiffness is comparable with those of displacements in any units.
///
/// p = [p_a + s (p₀ − p_a)] (m(t) V₀/V)^κ, with the pressure p_a outside, the exponent κ of a polytropic change and the amount m of gas relative to
/// that in the undeformed state. Added gas has the state of the gas inside. The load factor s of statics brings the gas from the
/// pressure outside to p₀. The gas has no mass.
///
/// The constraint of [`EnclosedVolume`](super::EnclosedVolume) determines x; its multiplier is p_a − p. The energy is zero at V₀. The rate of m supplies the power
/// ∂U/∂t.
///
/// Units: p pressure, V volume.
#[derive(Clone, Debug)]
pub struct GasPressure {
    coordinate: [usize; 1],
    multiplier: usize,
    volume: f64,
    area: f64,
    pressure: f64,
    ambient: f64,
    exponent: f64,
    amount: Function,
}

impl GasPressure {
    /// Creates a gas in the undeformed volume V₀, with the coordinate x and the multiplier of its constraint.
    ///
    /// `pressures` are p₀ and p_a.
    pub fn new(
        (coordinate, multiplier): (usize, usize),
        volume: f64,
        [pressure, ambient]: [f64; 2],
        exponent: f64,
        amount: Function,
    ) -> Self {
        let area = volume.powf(2.0 / 3.0);
        Self { coordinate: [coordinate], multiplier, volume, area, pressure, ambient, exponent, amount }
    }

    /// Returns the volume of the gas and its pressure in a state.
    pub fn volume_and_pressure(&self, s: &State) -> [f64; 2] {
        let v = self.area * s.q[self.coordinate[0]];
        [self.volume + v, self.absolute(v, s.t, s.load)]
    }

    /// Returns the undeformed volume V₀.
    pub const fn reference_volume(&self) -> f64 {
        self.volume
    }

    /// Returns the area A by which the coordinate is multiplied.
    pub const fn area(&self) -> f64 {
        self.area
    }

    /// Returns the change v of the volume.
    fn change(&self, at: &Local<'_>) -> f64 {
        self.area * at.q[X]
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

/// Position of x among the unknowns of the term, and of the multiplier.
const X: usize = 0;
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
        let v = self.change(at);
        r[X] += self.area * (self.ambient - self.absolute(v, at.t, at.load) - at.lambda[0]);
        r[ROW] -= v;
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let v = self.change(at);
        let pressure = self.absolute(v, at.t, at.load);
        let stiffness = self.exponent * pressure / (self.volume + v);
        let sum = self.ambient + 8.0 * pressure + stiffness * v.abs() + at.lambda[0].abs();
        floor[X] += f64::EPSILON * self.area * sum;
        floor[ROW] += f64::EPSILON * v.abs();
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let v = self.change(at);
        let stiffness = self.exponent * self.absolute(v, at.t, at.load) / (self.volume + v);
        k.add(X, X, w.q * stiffness * self.area * self.area);
        k.add(ROW, X, -self.area);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        discrete_residual(self, step, r);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let amount = self.amount.value(at.t).powf(self.exponent);
        let v = self.change(at);
        let of_gas = self.initial(at.load) * amount * self.integral(v);
        Energy { potential: of_gas + self.ambient * v, ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        if self.exponent == 0.0 {
            // The pressure does not depend on the amount, which may be zero.
            return 0.0;
        }
        let amount = self.amount.at(at.t);
        let rate = self.exponent * amount.value.powf(self.exponent - 1.0) * amount.rate;
        self.initial(at.load) * rate * self.integral(self.change(at))
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        (self.volume + self.change(at) <= 0.0).then_some(Inadmissibility::EmptyVolume)
    }
}
