/// Points and weights of the five-point Gauss-Legendre rule on [0, 1], exact to degree nine.
///
/// The energy density of the fully parameterised beam has degree eight along the axis.
/// Source: Abramowitz & Stegun (1964), table 25.4.
pub fn gauss() -> [(f64, f64); 5] {
    let root = (10.0_f64 / 7.0).sqrt();
    let (inner, outer) = ((5.0 - 2.0 * root).sqrt() / 3.0, (5.0 + 2.0 * root).sqrt() / 3.0);
    let part = 13.0 * 70.0_f64.sqrt();
    let (heavy, light) = ((322.0 + part) / 900.0, (322.0 - part) / 900.0);
    on_unit([(-outer, light), (-inner, heavy), (0.0, 128.0 / 225.0), (inner, heavy), (outer, light)])
}

/// The three-point rule, exact to degree five.
pub fn gauss3() -> [(f64, f64); 3] {
    let x = 0.6_f64.sqrt();
    on_unit([(-x, 5.0 / 9.0), (0.0, 8.0 / 9.0), (x, 5.0 / 9.0)])
}

/// The two-point rule, exact to degree three.
pub fn gauss2() -> [(f64, f64); 2] {
    let x = (1.0_f64 / 3.0).sqrt();
    on_unit([(-x, 1.0), (x, 1.0)])
}

/// A rule on [−1, 1] brought to [0, 1].
fn on_unit<const N: usize>(rule: [(f64, f64); N]) -> [(f64, f64); N] {
    rule.map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_to_their_degrees() {
        for (rule, exact) in [(gauss().to_vec(), 9), (gauss3().to_vec(), 5), (gauss2().to_vec(), 3)] {
            for degree in 0..=exact {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree)).sum();
                assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "degree {degree}");
            }
        }
    }
}
