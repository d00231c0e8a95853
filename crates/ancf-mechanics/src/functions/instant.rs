/// A function at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Instant {
    /// f.
    pub value: f64,
    /// df/dt, 1/time.
    pub rate: f64,
    /// d²f/dt², 1/time².
    pub acceleration: f64,
}

impl Instant {
    /// The same of a function whose time passes `unit` times as fast.
    pub(crate) fn quickened(self, unit: f64) -> Self {
        Self { rate: self.rate * unit, acceleration: self.acceleration * unit * unit, ..self }
    }
}
