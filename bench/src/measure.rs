//! Medians of repeated measurements.

use crate::clock;
use crate::subject::Subject;

/// What a measurement returns: why it could not be done, in words.
pub type Result<T> = std::result::Result<T, String>;

/// The middle of some numbers.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// How long and how often.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Least number of repetitions.
    pub least: usize,
    /// After so many seconds there are no more than these.
    pub seconds: f64,
}

impl Effort {
    /// Of rows that take microseconds.
    pub const SMALL: Self = Self { least: 9, seconds: 0.6 };
    /// Of rows that take seconds.
    pub const LARGE: Self = Self { least: 3, seconds: 1.0 };
}

/// Times of the processor per element of a subject, s.
///
/// # Errors
/// If it fails.
pub fn samples(subject: &mut dyn Subject, effort: Effort) -> Result<Vec<f64>> {
    let mut samples = Vec::new();
    let begun = clock::own();
    sample(subject)?;
    while samples.len() < effort.least || (samples.len() < 999 && clock::own() - begun < effort.seconds) {
        samples.push(sample(subject)?);
    }
    Ok(samples)
}

/// One time of the processor per element, s.
///
/// # Errors
/// If it fails.
pub fn sample(subject: &mut dyn Subject) -> Result<f64> {
    subject.prepare()?;
    let begun = clock::own();
    subject.run()?;
    Ok((clock::own() - begun) / subject.count())
}
