//! Estimated errors of the mesh against a finer mesh.

use ancf::estimate::{DiscretisationErrors, Resolution, ValueError};
use ancf::model::{Scheme, Step};

use super::law::{Check, Law};
use super::refinement::{distance, is_position, refined};
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

/// Estimated errors of a motion: they do not change it, and are not smaller than a quarter of the difference from a motion in steps of
/// one quarter on a mesh with twice the elements.
pub(super) struct MotionErrors;

/// Ratio of the true and the estimated error.
const UNDERSTATED: f64 = 4.0;
/// Difference relative to the length above which the steps or the mesh do not resolve the motion, and below which it is not checked.
const UNRESOLVED: f64 = 0.05;
const UNCHECKED: f64 = 1e-3;

impl Law for MotionErrors {
    fn name(&self) -> &'static str {
        "motion_errors"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let Some(dynamics) = case.model.analysis.dynamics() else { return Check::Inapplicable };
        let Step::Fixed(step) = dynamics.step else { return Check::Inapplicable };
        let has_estimate = case.model.contacts.is_empty()
            && !case.rubs_by_reaction()
            && !matches!(dynamics.scheme, Scheme::Energy | Scheme::DampedEnergy { .. });
        // An initial velocity that joints stop is an impulse, which excites all vibrations.
        let is_pushed = case.model.bodies.iter().any(|body| !body.motion().is_rest());
        if !has_estimate || case.base.is_divided || !case.base.verdict.is_finished() {
            return Check::Inapplicable;
        }
        let mut model = case.model.clone();
        model.output.errors = true;
        let found = run(&model);
        let changed = case.base.columns.iter().find(|own| {
            let other = found.column(&own.name);
            !other.is_some_and(|other| {
                own.values.iter().zip(&other.values).all(|(a, b)| a.to_bits() == b.to_bits())
            })
        });
        if let Some(own) = changed {
            let (quantity, values) = (own.name.clone(), "changed by the estimate".into());
            return Check::Violated(Finding { law: self.name(), quantity, values, excess: f64::INFINITY });
        }
        let mut fine = refined(&case.model, 2);
        if let Some(dynamics) = fine.analysis.dynamics_mut() {
            dynamics.step = Step::Fixed(step / 4.0);
        }
        let fine = run(&fine);
        if is_pushed && !case.model.joints.is_empty() || fine.is_divided || !fine.verdict.is_finished() {
            return Check::Holds;
        }
        let length = case.model.length();
        let is_error = |name: &str| name.strip_suffix("_error").is_some_and(is_position);
        let errors = found.columns.iter().filter(|column| is_error(&column.name));
        let all = || errors.clone().flat_map(|column| &column.values);
        // Concentrated forces and wrinkles of shells leave an order of magnitude.
        let is_irregular =
            found.motion_errors.as_ref().is_some_and(|own| own.finer.is_some() && own.is_rough);
        if is_irregular || all().skip(1).any(|error| error.is_nan()) {
            return Check::Holds;
        }
        let mean = |sum: f64| (sum / all().count().max(1) as f64).sqrt();
        let estimate = mean(all().map(|error| error * error).sum()) / length;
        let error = distance([&case.base, &fine], 4) / length;
        let excess = error / (UNDERSTATED * estimate + UNCHECKED);
        if error > UNRESOLVED || excess < 1.0 {
            return Check::Holds;
        }
        let values = format!("estimate {estimate:.2e}, difference {error:.2e} of the length");
        Check::Violated(Finding { law: self.name(), quantity: "position".into(), values, excess })
    }
}
