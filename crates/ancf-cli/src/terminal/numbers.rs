//! Numbers in messages.

/// Formats a count: "1 step", "2 steps".
pub fn count(number: u64, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

/// Formats a number with at most six digits and without trailing zeros. Small and large numbers have an exponent.
pub fn short(x: f64) -> String {
    let plain = x == 0.0 || (1e-4..1e9).contains(&x.abs());
    let rounded = format!("{x:.5e}").parse::<f64>();
    rounded.map_or_else(|_| x.to_string(), |x| if plain { x.to_string() } else { format!("{x:e}") })
}
