/// Returns f = β/sin β and its first two derivatives by C = cos β, for h = 1 − C.
///
/// (1 − C²) f' = C f − 1 and (1 − C²) f'' = f + 3 C f'. For small h: f = Σ aₙ hⁿ, aₙ₊₁ = aₙ (n + 1)/(2n + 3).
pub(super) fn ratio(h: f64) -> [f64; 3] {
    if h.abs() < 0.1 {
        let (mut f, mut a, mut power) = ([0.0; 3], 1.0, 1.0);
        let (mut before, mut twice) = (0.0, 0.0);
        for n in 0..16 {
            let order = f64::from(n);
            f[0] += a * power;
            f[1] -= a * order * before;
            f[2] += a * order * (order - 1.0) * twice;
            (twice, before, power) = (before, power, power * h);
            a *= (order + 1.0) / (2.0 * order + 3.0);
        }
        return f;
    }
    let (c, square) = (1.0 - h, h * (2.0 - h));
    let f = square.max(0.0).sqrt().atan2(c) / square.sqrt();
    let slope = (c * f - 1.0) / square;
    [f, slope, (f + 3.0 * c * slope) / square]
}

#[cfg(test)]
mod tests {
    use super::ratio;

    /// Closed form and series agree where they meet; f(cos β) sin β = β.
    #[test]
    fn ratio_is_the_angle_over_its_sine() {
        for angle in [1e-9_f64, 1e-3, 0.2, 0.44, 0.46, 1.0, 2.0, 3.1] {
            let h = 2.0 * (0.5 * angle).sin().powi(2);
            assert!((ratio(h)[0] * angle.sin() - angle).abs() < 1e-14 * angle * (1.0 + 1.0 / (3.15 - angle)));
        }
        for h in [0.01, 0.0999, 0.1001, 0.5, 1.7] {
            let step = 1e-4;
            let differences = [0, 1].map(|k| -(ratio(h + step)[k] - ratio(h - step)[k]) / (2.0 * step));
            for (found, expected) in differences.iter().zip(&ratio(h)[1..]) {
                assert!((found - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{h}: {found} {expected}");
            }
        }
    }
}
