/// Value and rates of a function at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FunctionValue {
    /// Value f.
    pub value: f64,
    /// First rate df/dt, 1/time.
    pub rate: f64,
    /// Second rate d²f/dt², 1/time².
    pub acceleration: f64,
}

impl FunctionValue {
    /// Scales the rates for an argument that is `unit` times the time.
    pub(crate) fn with_scaled_rates(self, unit: f64) -> Self {
        Self { rate: self.rate * unit, acceleration: self.acceleration * unit * unit, ..self }
    }
}
