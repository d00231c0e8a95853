/// Violation of a law by a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Name of the law.
    pub law: &'static str,
    /// Column or other quantity.
    pub quantity: String,
    /// Values and tolerance, in words.
    pub values: String,
    /// Deviation in multiples of the tolerance.
    pub excess: f64,
}

impl Finding {
    /// Finding without a number.
    pub fn of_kind(law: &'static str, quantity: &str, values: String) -> Self {
        Self { law, quantity: quantity.to_owned(), values, excess: f64::INFINITY }
    }
}
