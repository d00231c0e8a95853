//! Number formats of tables, text and figures.

/// Minus sign, as wide as a plus sign.
const MINUS: &str = "\u{2212}";

/// Formats with fixed decimals: `-1.357`.
pub fn fixed(x: f64, decimals: usize) -> String {
    typeset(&format!("{x:.decimals$}"))
}

/// Formats with fixed decimals and a sign, except for zero: `+0.001`.
pub fn signed(x: f64, decimals: usize) -> String {
    let text = format!("{x:+.decimals$}");
    let is_zero = text.chars().all(|c| !c.is_ascii_digit() || c == '0');
    if is_zero { text[1..].to_owned() } else { typeset(&text) }
}

/// Formats with significant digits: `0.0995`, `131`, `2.3×10⁻¹²`.
pub fn significant(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return typeset(&x.to_string());
    }
    // Exponent after rounding: 9.996 is 10.0.
    let rounded = format!("{x:.*e}", digits.saturating_sub(1));
    let exponent: i32 = rounded.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    if (-4..5).contains(&exponent) {
        let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        fixed(rounded.parse().unwrap_or(x), decimals)
    } else {
        scientific(x, digits)
    }
}

/// Formats as a power of ten with a factor of `digits` digits: `8.4×10¹⁰`, `10⁻⁵`.
pub fn scientific(x: f64, digits: usize) -> String {
    let text = format!("{x:.*e}", digits.saturating_sub(1));
    let Some((front, exponent)) = text.split_once('e') else { return text };
    let factor = if digits == 1 && front == "1" { String::new() } else { format!("{}×", typeset(front)) };
    format!("{factor}10{}", exponent.chars().map(raised).collect::<String>())
}

/// Formats without loss: the text parses to the same number.
pub fn exact(x: f64) -> String {
    if x == 0.0 || (1e-5..1e15).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

fn typeset(text: &str) -> String {
    text.replace('-', MINUS)
}

fn raised(c: char) -> char {
    match c {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        '-' => '⁻',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts() {
        assert_eq!(fixed(-1.3565, 3), "−1.357");
        assert_eq!([signed(0.0004, 3), signed(-0.0004, 3), signed(0.0006, 3)], ["0.000", "0.000", "+0.001"]);
        let significant = [0.099_56, 131.04, 9.996, 2457.0, 2.34e-12, 0.0].map(|x| significant(x, 3));
        assert_eq!(significant, ["0.0996", "131", "10.0", "2460", "2.34×10⁻¹²", "0"]);
        assert_eq!(
            [scientific(8.427e10, 2), scientific(1e-5, 1), scientific(5e-9, 1)],
            ["8.4×10¹⁰", "10⁻⁵", "5×10⁻⁹"]
        );
        for x in [0.1 + 0.2, 1.578_174_331_716_589e24, -5e-9, 0.0, 6263.0] {
            assert_eq!(exact(x).parse(), Ok(x));
        }
    }
}
