/// Result of a measurement, or the reason why it failed.
pub type Result<T> = std::result::Result<T, String>;
