//! Numbers in messages.

/// Formats a count: "1 step", "2 steps".
pub fn count(number: u64, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}
