use ancf_mechanics::functions::Function;

use super::free_motion::number;
use crate::model::{Model, TimeMode};

/// Describes functions of time that steps of a fixed size do not resolve, one sentence each.
///
/// Such steps evaluate a function at their ends only. A pulse between the ends has no effect, a pulse at an end that of a whole step, and
/// a vibration appears with another period.
pub(crate) fn time_warnings(model: &Model) -> Vec<String> {
    let Some((settings, step)) =
        model.analysis.dynamics().and_then(|own| own.step.fixed().map(|step| (own, step)))
    else {
        return Vec::new();
    };
    let model = model.with_signals();
    let functions =
        model.time_functions().into_iter().map(|(path, time)| (path, TimeMode::AsGiven.function(time)));
    let warning = |(path, function): (String, Function)| {
        let variation = function.unresolved_variation([model.initial.start_time, settings.duration], step)?;
        let [at, width, step] = [variation.at, variation.width, step].map(number);
        Some(format!(
            "`{path}` changes by {} within {width} at t = {at}, which steps of {step} do not resolve: its effect is lost or \
             wrong; use smaller steps, or `step = {{ tolerance = ... }}`",
            number(variation.deviation)
        ))
    };
    functions.chain(model.laws_of_time()).filter_map(warning).collect()
}
