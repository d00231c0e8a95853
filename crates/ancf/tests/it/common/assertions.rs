//! Assertions on numbers.

/// Asserts that a number equals a reference within an absolute tolerance.
#[track_caller]
pub(crate) fn assert_near(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = (value - reference).abs();
    assert!(error <= tolerance, "{what}: {value} instead of {reference}, {error:e} off");
}
