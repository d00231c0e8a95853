/// Dry friction as a function of the rate, relative to its value at high rates.
///
/// g(v) = tanh(v/ε) (1 + (p − 1) exp(−(v/vₛ)²)): below the rate ε friction is viscous, above it falls from the peak p to 1 over the
/// rate vₛ (Stribeck). Without a peak, p = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionCurve {
    /// Rate ε below which friction is viscous.
    pub creep: f64,
    /// Peak p.
    pub peak: f64,
    /// Rate vₛ.
    pub decay: f64,
}

impl FrictionCurve {
    /// Creates a curve without a peak.
    pub const fn flat(creep: f64) -> Self {
        Self { creep, peak: 1.0, decay: 1.0 }
    }

    /// Returns g.
    pub fn at(&self, v: f64) -> f64 {
        (v / self.creep).tanh() * self.excess(v)
    }

    /// Returns g/v, which is regular at zero.
    pub fn ratio(&self, v: f64) -> f64 {
        let x = v / self.creep;
        let of_tanh = if x.abs() < 1e-4 { 1.0 - x * x / 3.0 } else { x.tanh() / x };
        of_tanh / self.creep * self.excess(v)
    }

    /// Returns dg/dv.
    pub fn slope(&self, v: f64) -> f64 {
        let ratio = v / self.creep;
        let of_excess = -2.0 * v / self.decay.powi(2) * (self.excess(v) - 1.0);
        self.excess(v) / self.creep / ratio.cosh().powi(2) + ratio.tanh() * of_excess
    }

    fn excess(&self, v: f64) -> f64 {
        1.0 + (self.peak - 1.0) * (-(v / self.decay).powi(2)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_derivatives() {
        for curve in [FrictionCurve::flat(0.1), FrictionCurve { creep: 0.1, peak: 1.6, decay: 0.5 }] {
            for v in [-2.0, -0.4, 0.0, 0.03, 0.2, 0.9] {
                let h = 1e-6;
                let difference = (curve.at(v + h) - curve.at(v - h)) / (2.0 * h);
                assert!((curve.slope(v) - difference).abs() < 1e-7 * (1.0 + difference.abs()), "{v}");
                assert!((curve.ratio(v) * v - curve.at(v)).abs() < 1e-15, "{v}");
            }
        }
        assert!((FrictionCurve { creep: 0.1, peak: 1.6, decay: 0.5 }.at(9.0) - 1.0).abs() < 1e-15);
    }
}
