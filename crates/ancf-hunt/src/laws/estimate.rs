//! Estimated errors of the mesh against a finer mesh.

use ancf::estimate::{DiscretisationErrors, Resolution, ValueError};

use super::law::{Check, Law};
use super::refinement::{is_position, refined};
use crate::compare::{Case, Finding};
use crate::random::Random;
use crate::run::run;

/// Value + error of statics, frequencies and load factors is that of a mesh with four times the elements, to the size of the error:
/// the ratio of the estimated and the true error is at least one half.
pub(super) struct Estimate;

/// Ratio of the remaining and the estimated error.
const REMAINING: f64 = 1.0;
/// Difference relative to the length that is not checked.
const SMALL: f64 = 1e-5;
/// Difference of the values relative to the length above which the meshes have different equilibria.
const OTHER: f64 = 0.3;
/// Relative error of a frequency or load factor above which it is not checked.
const RELATIVE: f64 = 0.1;
/// Relative difference of frequencies and load factors that is not checked.
const SMALL_RELATIVE: f64 = 1e-3;

impl Law for Estimate {
    fn name(&self) -> &'static str {
        "estimate"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let Some(coarse) = good(case.base.errors.as_ref()) else { return Check::Inapplicable };
        let twin = run(&refined(&case.model, 4));
        let Some(fine) = good(twin.errors.as_ref()) else { return Check::Inapplicable };
        if coarse.eigenvalue.is_some() {
            return Check::of(of_eigenvalues(coarse, fine));
        }
        let length = case.model.length();
        // Parts of an error may cancel in one component.
        let largest = |errors: &DiscretisationErrors| {
            let positions = errors.values.iter().filter(|value| is_position(&value.column));
            positions.map(|value| value.error.abs()).fold(0.0, f64::max)
        };
        let tolerance = REMAINING * (largest(coarse) + largest(fine)) + SMALL * length;
        let mut worst: Option<Finding> = None;
        for (value, exact) in coarse.values.iter().zip(&fine.values) {
            let is_other = (value.value - exact.value).abs() > OTHER * length;
            if !is_position(&value.column) || value.column != exact.column || is_other {
                continue;
            }
            let excess = (value.value + value.error - exact.value - exact.error).abs() / tolerance;
            if excess > 1.0 && worst.as_ref().is_none_or(|worst| excess > worst.excess) {
                let values = format!(
                    "{:e} + {:e} / {:e} + {:e} with four times the elements",
                    value.value, value.error, exact.value, exact.error
                );
                worst = Some(Finding { law: self.name(), quantity: value.column.clone(), values, excess });
            }
        }
        Check::of(worst)
    }
}

/// Compares corrected frequencies or load factors with the nearest ones of the fine mesh: the order of the modes may change.
fn of_eigenvalues(coarse: &DiscretisationErrors, fine: &DiscretisationErrors) -> Option<Finding> {
    let corrected = |value: &ValueError| value.value + value.error;
    let largest = fine.values.iter().map(corrected).fold(0.0, |a: f64, b| a.max(b.abs()));
    let is_checked = |value: &&ValueError| {
        value.error.abs() <= RELATIVE * value.value.abs()
            && corrected(value).abs() < (1.0 - RELATIVE) * largest
    };
    for value in coarse.values.iter().filter(is_checked) {
        let distance = |exact: &&ValueError| (corrected(value) - corrected(exact)).abs();
        let nearest = fine.values.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        let tolerance =
            REMAINING * (value.error.abs() + nearest.error.abs()) + SMALL_RELATIVE * value.value.abs();
        let excess = distance(&nearest) / tolerance;
        if excess > 1.0 {
            let values = format!(
                "{:e} + {:e} / {:e} + {:e} with four times the elements",
                value.value, value.error, nearest.value, nearest.error
            );
            return Some(Finding { law: "estimate", quantity: value.column.clone(), values, excess });
        }
    }
    None
}

fn good(errors: Option<&DiscretisationErrors>) -> Option<&DiscretisationErrors> {
    errors.filter(|errors| errors.resolution == Resolution::Good)
}
