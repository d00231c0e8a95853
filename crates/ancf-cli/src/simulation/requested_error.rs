//! Requested error of a refinement.

/// Parses a relative error: `1%` or `0.01`.
pub fn requested_error(text: &str) -> Result<f64, String> {
    let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 0.01));
    match number.trim().parse::<f64>().map(|number| number * unit) {
        Ok(requested) if (1e-9..1.0).contains(&requested) => Ok(requested),
        _ => Err("expected a relative error between 1e-7 % and 100 %, such as 1% or 0.01".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_percentages_or_numbers() {
        assert_eq!(requested_error("1%"), Ok(0.01));
        assert_eq!(requested_error("0.5 %"), Ok(0.005));
        assert_eq!(requested_error("1e-3"), Ok(1e-3));
        for wrong in ["", "0", "%", "100%", "-1%", "nan", "1 percent"] {
            assert!(requested_error(wrong).is_err(), "{wrong}");
        }
    }
}
