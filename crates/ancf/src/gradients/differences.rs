//! Extrapolated differences.

/// Values of functions of a parameter at two distances from its value.
pub(super) struct DifferencePair {
    /// Distance h.
    pub(super) step: f64,
    /// Values at h and at −h.
    pub(super) values: [Vec<f64>; 2],
}

/// Derivatives of functions with their estimated errors.
pub(super) struct Derivatives {
    pub(super) values: Vec<f64>,
    /// Values of less extrapolation, whose differences are the estimated errors.
    pub(super) others: Vec<f64>,
    pub(super) errors: Vec<f64>,
}

/// Second difference, relative to the first one, below which functions are smooth.
const KINK: f64 = 1e-3;
/// Number of steps over which second differences are proportional to the step at a kink.
const LINEAR: usize = 4;

/// Returns the derivatives of functions at zero from central differences with decreasing steps, extrapolated to the step zero.
///
/// Each function takes the extrapolation with the smallest estimated error: its difference from the extrapolations of lower order, or
/// from that of equal order with larger steps. Errors of large steps decrease by extrapolation, rounding errors of small steps appear in
/// the differences.
///
/// Source: Ridders (1982).
pub(super) fn extrapolated(pairs: &[DifferencePair]) -> Derivatives {
    let count = pairs.first().map_or(0, |pair| pair.values[0].len());
    let (values, others): (Vec<f64>, Vec<f64>) = (0..count).map(|i| extrapolated_component(pairs, i)).unzip();
    let errors = values.iter().zip(&others).map(|(value, other)| (value - other).abs()).collect();
    Derivatives { values, others, errors }
}

/// Returns the derivative of a function, and the extrapolation whose difference is its estimated error.
fn extrapolated_component(pairs: &[DifferencePair], i: usize) -> (f64, f64) {
    let mut best = (f64::NAN, f64::NAN);
    let mut above: Vec<f64> = Vec::new();
    for (row, pair) in pairs.iter().enumerate() {
        let [after, before] = &pair.values;
        let mut own = vec![(after[i] - before[i]) / (2.0 * pair.step)];
        for column in 1..=row {
            // Errors of central differences are powers of h².
            let ratio = (pairs[row - column].step / pair.step).powi(2);
            let (finer, coarser) = (own[column - 1], above[column - 1]);
            let value = finer + (finer - coarser) / (ratio - 1.0);
            let farther = if (value - finer).abs() > (value - coarser).abs() { finer } else { coarser };
            own.push(value);
            for other in [Some(farther), above.get(column).copied()].into_iter().flatten() {
                if best.0.is_nan() || (value - other).abs() < (best.0 - best.1).abs() {
                    best = (value, other);
                }
            }
        }
        above = own;
    }
    best
}

/// True if a function has a kink at zero: its one-sided slopes have different limits. `rounding` bounds the rounding errors of the
/// functions.
///
/// Second differences with the step h are then proportional to h, those of smooth functions to h², and those of rounding errors do not
/// depend on h.
pub(super) fn has_kink(pairs: &[DifferencePair], centre: &[f64], rounding: &[f64]) -> bool {
    let Some(smallest) = pairs.last() else { return false };
    let second = |pair: &DifferencePair, i: usize| {
        let [after, before] = &pair.values;
        (after[i] - centre[i]) + (before[i] - centre[i])
    };
    let is_linear = |i: usize| {
        pairs[pairs.len().saturating_sub(LINEAR)..].windows(2).all(|pair| {
            let ratio = pair[1].step / pair[0].step;
            let found = second(&pair[1], i) / (second(&pair[0], i) * ratio);
            found > ratio.sqrt() && found < ratio.sqrt().recip()
        })
    };
    (0..centre.len()).any(|i| {
        let slope = (smallest.values[0][i] - smallest.values[1][i]).abs();
        second(smallest, i).abs() > KINK * slope + 4.0 * rounding[i] && is_linear(i)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pairs(f: impl Fn(f64) -> f64) -> Vec<DifferencePair> {
        let pair = |k: i32| {
            let step = 0.5_f64.powi(k) / 8.0;
            DifferencePair { step, values: [step, -step].map(|h| vec![f(h)]) }
        };
        (0..5).map(pair).collect()
    }

    /// Derivatives of smooth functions, with errors that bound the true ones.
    #[test]
    fn derivatives_of_smooth_functions() {
        let check = |f: &dyn Fn(f64) -> f64, exact: f64| {
            let found = extrapolated(&pairs(f));
            let deviation = (found.values[0] - exact).abs();
            assert!(deviation <= 1e-10 * exact.abs().max(1.0), "{deviation}");
            assert!(deviation <= 10.0 * found.errors[0] + 1e-13, "{deviation} for {}", found.errors[0]);
            assert!(!has_kink(&pairs(f), &[f(0.0)], &[1e-14 * f(0.0).abs()]));
        };
        check(&|h| 3.0 * h, 3.0);
        check(&|h| (1.0 + h).powi(-3), -3.0);
        check(&f64::exp, 1.0);
        check(&|h| (4.0 * h).sin(), 4.0);
        check(&|_| 1e6, 0.0);
    }

    /// Kinks are found, jumps of curvature are none.
    #[test]
    fn kinks() {
        let at_zero = |f: &dyn Fn(f64) -> f64| has_kink(&pairs(f), &[f(0.0)], &[1e-14 * f(0.0).abs()]);
        assert!(at_zero(&f64::abs));
        assert!(at_zero(&|h| 5.0 + h + 0.1 * h.max(0.0)));
        assert!(!at_zero(&|h| h * h.abs() + h));
    }
}
