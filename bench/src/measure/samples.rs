use super::clock;
use crate::Result;
use crate::subjects::Subject;

/// Median of numbers; the upper of both middle values if their count is even.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Minimum number of samples and maximum time.
#[derive(Clone, Copy, Debug)]
pub struct SampleSize {
    /// Minimum number of samples.
    pub least: usize,
    /// CPU time in seconds after which no samples beyond the minimum are taken.
    pub seconds: f64,
}

impl SampleSize {
    /// Samples of work that takes microseconds.
    pub const SMALL: Self = Self { least: 9, seconds: 0.6 };
    /// Samples of work that takes seconds.
    pub const LARGE: Self = Self { least: 3, seconds: 1.0 };
}

/// Measures the CPU time per element of a subject repeatedly, in seconds.
///
/// # Errors
/// If a run fails.
pub fn samples(subject: &mut dyn Subject, size: SampleSize) -> Result<Vec<f64>> {
    let mut samples = Vec::new();
    let start = clock::own();
    sample(subject)?;
    while samples.len() < size.least || (samples.len() < 999 && clock::own() - start < size.seconds) {
        samples.push(sample(subject)?);
    }
    Ok(samples)
}

/// Measures the CPU time per element of one run, in seconds.
///
/// # Errors
/// If the run fails.
pub fn sample(subject: &mut dyn Subject) -> Result<f64> {
    subject.prepare()?;
    let start = clock::own();
    subject.run()?;
    Ok((clock::own() - start) / subject.count())
}
