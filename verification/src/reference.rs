//! Independent solutions: Runge-Kutta, roots, quadrature, elliptic integrals.

/// Integrates y' = f(x, y) with `steps` equal steps of the Runge-Kutta scheme of fourth order and returns y(`to`).
pub fn runge_kutta<const N: usize>(
    f: impl Fn(f64, &[f64; N]) -> [f64; N],
    start: [f64; N],
    to: f64,
    steps: u32,
) -> [f64; N] {
    let h = to / f64::from(steps);
    let mut y = start;
    for step in 0..steps {
        let x = h * f64::from(step);
        let along = |k: &[f64; N], part: f64| std::array::from_fn(|i| y[i] + part * h * k[i]);
        let first = f(x, &y);
        let second = f(x + 0.5 * h, &along(&first, 0.5));
        let third = f(x + 0.5 * h, &along(&second, 0.5));
        let fourth = f(x + h, &along(&third, 1.0));
        for i in 0..N {
            y[i] += h / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]);
        }
    }
    y
}

/// Returns the root of `f` between `low` and `high`, where it changes sign once, by bisection.
pub fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle).signum() == sign { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Returns the integral of `f` by Simpson's rule with 2000 intervals.
pub fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    const INTERVALS: u32 = 2000;
    let h = (to - from) / f64::from(INTERVALS);
    let weight = |k: u32| if k == 0 || k == INTERVALS { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
    (0..=INTERVALS).map(|k| weight(k) * f(from + h * f64::from(k))).sum::<f64>() * h / 3.0
}

/// Returns the complete elliptic integral K(k) by the arithmetic-geometric mean.
pub fn elliptic_k(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_have_known_values() {
        let [y, v] = runge_kutta(|_, [y, v]: &[f64; 2]| [*v, -y], [1.0, 0.0], 2.0, 400);
        assert!((y - 2f64.cos()).abs() < 1e-10 && (v + 2f64.sin()).abs() < 1e-10);
        assert!((root(|x| x * x - 2.0, 1.0, 2.0) - 2f64.sqrt()).abs() < 1e-14);
        assert!((integral(f64::exp, 0.0, 1.0) - 1f64.exp() + 1.0).abs() < 1e-13);
        assert!((elliptic_k(0.5f64.sqrt()) - 1.854_074_677_301_372).abs() < 1e-14);
    }
}
