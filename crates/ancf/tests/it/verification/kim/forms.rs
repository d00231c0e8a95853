//! Non-dimensional form of Kim et al. (2017).

use ancf::Model;
use ancf::model::{ScaleChoice, Slopes, Step};

use crate::common::models::rod;

/// Returns the non-dimensional form: units of table 3, length-valued slopes.
pub(super) fn non_dimensional(mut model: Model) -> Model {
    model.scales = ScaleChoice::Paper;
    rod::beam(&mut model).slopes = Slopes::Length;
    model
}

/// Returns the non-dimensional form with the step of the paper, 0.001 of its unit of time.
///
/// The duration is a multiple of the step.
pub(super) fn non_dimensional_step(model: Model) -> Model {
    let mut model = non_dimensional(model);
    let step = 1e-3 * model.scales().scales.time;
    let settings = rod::settings(&mut model);
    (settings.step, settings.duration) = (Step::Fixed(step), (settings.duration / step).floor() * step);
    model
}
