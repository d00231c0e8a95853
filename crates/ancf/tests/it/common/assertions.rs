//! Assertions on numbers.

/// Asserts that a number equals a reference within an absolute tolerance.
#[track_caller]
pub(crate) fn assert_near(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = (value - reference).abs();
    assert!(error <= tolerance, "{what}: {value} instead of {reference}, error {error:e}");
}

/// Asserts that a number equals a reference within a relative tolerance.
#[track_caller]
pub(crate) fn assert_relative(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = (value / reference - 1.0).abs();
    assert!(error < tolerance, "{what}: {value:e} instead of {reference:e}, relative error {error:e}");
}
