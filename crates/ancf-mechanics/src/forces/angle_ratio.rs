use ancf_solver::equations::Inadmissibility;

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

/// 1 + C at which a rotation counts as half a turn.
const HALF_TURN: f64 = 1e-6;

/// Returns the reason why a rotation is inadmissible, for the change C − 1 of the cosine of its angle.
pub(super) fn inadmissible_angle(change: f64) -> Option<Inadmissibility> {
    let is_admissible = 2.0 + change > HALF_TURN;
    (!is_admissible).then_some(Inadmissibility::HalfTurn)
}

/// Returns true if a rotation passes half a turn between two states, for the changes C − 1 of the cosine of its angle and the vectors
/// sin β n.
pub(super) fn passes_half_turn(cosines: [f64; 2], [from, to]: [&[f64]; 2]) -> bool {
    let product: f64 = from.iter().zip(to).map(|(from, to)| from * to).sum();
    cosines[0].max(cosines[1]) < -1.0 && product < 0.0
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
