use super::record::RecordedColumn;

/// Largest observed order.
const MAX_ORDER: f64 = 20.0;

/// Convergence of an objective f with a size h, from the coarsest case to the finest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Convergence {
    /// Sizes h. Of integers, which are counts, 1/count.
    pub sizes: Vec<f64>,
    /// Values f.
    pub values: Vec<f64>,
    /// Observed order p of f = f∞ + C hᵖ through a case and the two before; NaN if there is none.
    pub orders: Vec<f64>,
    /// Limit f∞ of the finest case with an order (Richardson 1911).
    pub limit: Option<f64>,
}

/// Estimates the order of convergence of an objective with a numeric parameter. `None` for fewer than three values, or if a value
/// occurs more than once.
pub fn convergence(parameter: &RecordedColumn, objective: &RecordedColumn) -> Option<Convergence> {
    let size = |x: f64| if parameter.is_integer { 1.0 / x } else { x };
    let pairs = parameter.numbers.iter().map(|&x| size(x)).zip(objective.numbers.iter().copied());
    let mut pairs: Vec<(f64, f64)> = pairs.collect();
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    let is_valid = pairs.iter().all(|(h, f)| h.is_finite() && *h > 0.0 && f.is_finite());
    if pairs.len() < 3 || !is_valid || pairs.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return None;
    }
    let (sizes, values): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
    let (orders, limits) = observed_orders(&sizes, &values);
    let limit = limits.into_iter().rfind(|limit| limit.is_finite());
    Some(Convergence { sizes, values, orders, limit })
}

/// Returns the order p and the limit f∞ of f = f∞ + C hᵖ through each value and the two before. NaN if there is none.
///
/// Sizes decrease. The numbers of sizes and values are equal.
pub fn observed_orders(sizes: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let mut orders = vec![f64::NAN; sizes.len()];
    let mut limits = orders.clone();
    for (k, (h, f)) in sizes.windows(3).zip(values.windows(3)).enumerate() {
        if let Some(p) = order([h[0], h[1], h[2]], [f[0], f[1], f[2]]) {
            orders[k + 2] = p;
            limits[k + 2] = f[2] + (f[2] - f[1]) / ((p * (h[1] / h[2]).ln()).exp_m1());
        }
    }
    (orders, limits)
}

/// Order p with (f₂ − f₁)/(f₃ − f₂) = (h₁ᵖ − h₂ᵖ)/(h₂ᵖ − h₃ᵖ), h₁ > h₂ > h₃ (Roache 1994), by bisection.
fn order(h: [f64; 3], f: [f64; 3]) -> Option<f64> {
    let (first, second) = (f[1] - f[0], f[2] - f[1]);
    let (a, b) = ((h[0] / h[1]).ln(), (h[1] / h[2]).ln());
    let ratio = first / second;
    // The right side increases with p, from a/b at p = 0.
    if second == 0.0 || ratio.is_nan() || ratio <= a / b {
        return None;
    }
    let excess = |p: f64| (b * p).exp() * (a * p).exp_m1() / (b * p).exp_m1() - ratio;
    let (mut low, mut high) = (1e-9, MAX_ORDER);
    if excess(high) < 0.0 {
        return None;
    }
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(numbers: &[f64], is_integer: bool) -> RecordedColumn {
        RecordedColumn { numbers: numbers.to_vec(), is_integer, ..RecordedColumn::default() }
    }

    /// f = 3 − 2 hᵖ with unequal ratios of sizes, of counts and of steps.
    #[test]
    fn order_and_limit_of_a_power_are_exact() {
        for p in [0.5, 1.0, 2.0, 4.0] {
            for (x, is_integer) in [([3.0, 5.0, 1.0, 2.0, 12.0], true), ([0.1, 0.02, 0.5, 0.2, 0.05], false)]
            {
                let f = x.map(|x: f64| 3.0 - 2.0 * if is_integer { 1.0 / x } else { x }.powf(p));
                let found = convergence(&column(&x, is_integer), &column(&f, false)).unwrap();
                assert!(found.sizes.is_sorted_by(|a, b| a > b));
                assert!(found.orders[..2].iter().all(|p| p.is_nan()));
                let worst = found.orders[2..].iter().map(|own| (own - p).abs()).fold(0.0, f64::max);
                assert!(worst < 1e-6, "{p}: {:?}", found.orders);
                assert!((found.limit.unwrap() - 3.0).abs() < 1e-8, "{found:?}");
            }
        }
    }

    #[test]
    fn oscillations_and_repeated_sizes_have_no_order() {
        let x = column(&[1.0, 2.0, 4.0], true);
        let found = convergence(&x, &column(&[1.0, 2.0, 1.5], false)).unwrap();
        assert!(found.limit.is_none() && found.orders.iter().all(|p| p.is_nan()));
        assert_eq!(convergence(&column(&[1.0, 2.0, 2.0], true), &x), None);
        assert_eq!(convergence(&column(&[1.0, 2.0], true), &column(&[1.0, 2.0], true)), None);
    }
}
