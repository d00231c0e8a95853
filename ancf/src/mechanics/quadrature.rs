/// Points and weights of the five-point Gauss-Legendre rule on [0, 1], exact to degree nine.
///
/// The energy density of the fully parameterised beam has degree eight along the axis.
/// Source: Abramowitz & Stegun (1964), table 25.4.
pub fn gauss() -> [(f64, f64); 5] {
    let root = (10.0_f64 / 7.0).sqrt();
    let (inner, outer) = ((5.0 - 2.0 * root).sqrt() / 3.0, (5.0 + 2.0 * root).sqrt() / 3.0);
    let part = 13.0 * 70.0_f64.sqrt();
    let (heavy, light) = ((322.0 + part) / 900.0, (322.0 - part) / 900.0);
    [(-outer, light), (-inner, heavy), (0.0, 128.0 / 225.0), (inner, heavy), (outer, light)]
        .map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_to_degree_nine() {
        for degree in 0..=9 {
            let sum: f64 = gauss().iter().map(|(x, w)| w * x.powi(degree)).sum();
            assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "degree {degree}");
        }
    }
}
