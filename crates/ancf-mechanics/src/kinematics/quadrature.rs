/// Returns points and weights of the five-point Gauss-Legendre rule on [0, 1], exact to degree nine.
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

/// Returns the three-point Gauss-Legendre rule, exact to degree five.
pub fn gauss3() -> [(f64, f64); 3] {
    let x = 0.6_f64.sqrt();
    on_unit([(-x, 5.0 / 9.0), (0.0, 8.0 / 9.0), (x, 5.0 / 9.0)])
}

/// Returns the two-point Gauss-Legendre rule, exact to degree three.
pub fn gauss2() -> [(f64, f64); 2] {
    let x = (1.0_f64 / 3.0).sqrt();
    on_unit([(-x, 1.0), (x, 1.0)])
}

/// Returns the places and weights of Simpson's rule on `cells` × `cells` equal cells of the unit square, line by line.
///
/// It is exact to degree three and has points on the edges. Each direction has 2 `cells` + 1 points.
pub(crate) fn simpson_points(cells: usize) -> impl Iterator<Item = ([f64; 2], f64)> {
    let line = move || {
        let last = 2 * cells;
        (0..=last).map(move |k| {
            let share = if k == 0 || k == last { 1.0 } else { 2.0 * (1 + k % 2) as f64 };
            (k as f64 / last as f64, share / (6 * cells) as f64)
        })
    };
    line().flat_map(move |(y, across)| line().map(move |(x, along)| ([x, y], along * across)))
}

/// Maps a rule from [−1, 1] to [0, 1].
fn on_unit<const N: usize>(rule: [(f64, f64); N]) -> [(f64, f64); N] {
    rule.map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w))
}

/// Returns the four-point Gauss-Legendre rule on [0, 1], exact to degree seven.
pub(crate) fn gauss4() -> [(f64, f64); 4] {
    let root = 2.0 / 7.0 * 1.2_f64.sqrt();
    let (inner, outer) = ((3.0 / 7.0 - root).sqrt(), (3.0 / 7.0 + root).sqrt());
    let part = 30.0_f64.sqrt() / 72.0;
    let (heavy, light) = (0.25 + part, 0.25 - part);
    on_unit([(-outer, light), (-inner, heavy), (inner, heavy), (outer, light)].map(|(x, w)| (x, 2.0 * w)))
}

/// Returns the three-point Lobatto rule on [0, 1], which is Simpson's rule, exact to degree three.
pub(crate) fn lobatto3() -> [(f64, f64); 3] {
    [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_exact(rule: &[(f64, f64)], highest: i32) {
        for degree in 0..=highest + 1 {
            let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree)).sum();
            let exact = (sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15;
            assert_eq!(exact, degree <= highest, "{} points, degree {degree}", rule.len());
        }
    }

    #[test]
    fn exact_to_their_degrees() {
        assert_exact(&gauss2(), 3);
        assert_exact(&lobatto3(), 3);
        let line: Vec<_> =
            simpson_points(3).filter(|([_, y], _)| *y == 0.0).map(|([x, _], w)| (x, 18.0 * w)).collect();
        assert_exact(&line, 3);
        assert_exact(&gauss3(), 5);
        assert_exact(&gauss4(), 7);
        assert_exact(&gauss(), 9);
    }
}
