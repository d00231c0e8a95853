//! Fixed columns of the results table.

/// Columns of every table. Parameters and objectives follow the first.
pub const TABLE_COLUMNS: [&str; 7] = ["case", "outcome", "message", "steps", "iterations", "seconds", "key"];
