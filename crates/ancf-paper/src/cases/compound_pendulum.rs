//! Rigid compound pendulum in closed form, the reference of Figures 8 and 9.

/// Uniform rod of length L and diameter d on a hinge, released at rest from the horizontal.
///
/// θ'' = W² cos θ with θ from the horizontal downwards, W² = ½ g L / (L²/3 + d²/16). With φ = π/2 − θ,
/// sin(φ/2) = k sn(K − W t, k), k = sin(π/4): exact to rounding.
///
/// Units: coherent. Source: Abramowitz & Stegun (1964), 16.4, 17.6; any textbook on the pendulum.
#[derive(Clone, Copy, Debug)]
pub struct CompoundPendulum {
    /// W, 1/time.
    frequency: f64,
    length: f64,
}

/// Position and acceleration of the tip in the plane of motion. x is the initial direction, y points upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipState {
    /// Position (x, y).
    pub position: [f64; 2],
    /// Acceleration.
    pub acceleration: [f64; 2],
}

/// Modulus sin(φ₀/2) of the release at φ₀ = π/2.
const MODULUS: f64 = std::f64::consts::FRAC_1_SQRT_2;

impl CompoundPendulum {
    /// Creates a pendulum under gravity g.
    pub fn new(length: f64, diameter: f64, gravity: f64) -> Self {
        let arm = length * length / 3.0 + diameter * diameter / 16.0;
        Self { frequency: (0.5 * gravity * length / arm).sqrt(), length }
    }

    /// Returns the state of the tip at time t.
    pub fn tip(&self, t: f64) -> TipState {
        let (w, l) = (self.frequency, self.length);
        let (quarter, _) = jacobi(0.0);
        let (_, [sn, cn]) = jacobi(quarter - w * t);
        // θ = π/2 − φ, so cos θ = sin φ and sin θ = cos φ.
        let half = MODULUS * sn;
        let (cos, sin) = (2.0 * half * (1.0 - half * half).sqrt(), 1.0 - 2.0 * half * half);
        let rate = 2.0 * MODULUS * w * cn;
        let (radial, tangential) = (rate * rate, w * w * cos);
        TipState {
            position: [l * cos, -l * sin],
            acceleration: [l * (-radial * cos - tangential * sin), l * (radial * sin - tangential * cos)],
        }
    }
}

/// Returns the quarter period K and sn(u), cn(u) of modulus [`MODULUS`] by the arithmetic-geometric mean.
fn jacobi(u: f64) -> (f64, [f64; 2]) {
    let (mut a, mut b) = (1.0, (1.0 - MODULUS * MODULUS).sqrt());
    let mut ratios = Vec::with_capacity(8);
    let mut scale = 1.0;
    for _ in 0..6 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        scale *= 2.0;
        ratios.push(c / a);
    }
    let mut phi: f64 = scale * a * u;
    for ratio in ratios.iter().rev() {
        phi = 0.5 * (phi + (ratio * phi.sin()).asin());
    }
    (std::f64::consts::FRAC_PI_2 / a, [phi.sin(), phi.cos()])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// L = 1, d = 0.02, g = 9.81: independent integration by an eighth-order Runge-Kutta method, 12 digits.
    #[test]
    fn agrees_with_numerical_integration() {
        let pendulum = CompoundPendulum::new(1.0, 0.02, 9.81);
        let expected = [
            (0.0, [1.0, 0.0], [0.0, -14.7138964578]),
            (0.25, [0.897555597254, -0.440901292625], [-17.4683418341, -6.13301910796]),
            (0.5, [-0.0901281176136, -0.995930179488], [3.96221596757, 29.069226548]),
            (1.0, [-0.999966738166, -0.00815613650197], [0.360013668843, -14.7109600395]),
            (1.5, [0.266044667463, -0.963960701956], [-11.3204277691, 26.3034545112]),
            (2.0, [0.999467890296, -0.0326180359245], [-1.4390490701, -14.6669325135]),
        ];
        for (t, position, acceleration) in expected {
            let tip = pendulum.tip(t);
            for i in 0..2 {
                assert!((tip.position[i] - position[i]).abs() < 1e-11, "t = {t}: {tip:?}");
                assert!((tip.acceleration[i] - acceleration[i]).abs() < 1e-9, "t = {t}: {tip:?}");
            }
        }
    }
}
