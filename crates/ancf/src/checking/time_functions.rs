//! Checks of functions of time, of inputs, and of ground points.

use nalgebra::Vector3;

use super::findings::{COINCIDENT, body, rule_of_names};
use crate::errors::{Finding, finding, number, quoted};
use crate::joints::{End, Joint};
use crate::model::{IndexedModel, Input, TimeFunction, Varying, joints_of};
use crate::schema::unknown;

/// Checks that functions of time are defined: tables in ascending order, intervals not empty, valid formulas.
pub(crate) fn functions(model: &IndexedModel<'_>) -> Vec<Finding> {
    model.time_functions().into_iter().filter_map(|(path, time)| rule_of_function(&path, time)).collect()
}

fn rule_of_function(path: &str, time: &TimeFunction) -> Option<Finding> {
    let TimeFunction::Varying(varying) = time else { return None };
    let key = |key: &str| format!("{path}.{key}");
    match varying {
        Varying::Table { times, values } if times.len() != values.len() => {
            let found = format!("{} for {} times", values.len(), times.len());
            Some(finding(key("values"), found, "as many values as times").rests_on([key("times")]))
        }
        Varying::Table { times, .. } => {
            let at = times.windows(2).position(|pair| pair[0] > pair[1])?;
            let found = format!("{} after {}", number(times[at + 1]), number(times[at]));
            Some(finding(format!("{}[{}]", key("times"), at + 1), found, "times in order"))
        }
        Varying::Ramp { start, end } => (start >= end).then(|| {
            let expected = format!("a time after the start, {}", number(*start));
            finding(key("end"), number(*end), expected).rests_on([key("start")])
        }),
        Varying::Step { at, until: Some(until) } => (at >= until).then(|| {
            let expected = format!("a time after `at`, {}", number(*at));
            finding(key("until"), number(*until), expected).rests_on([key("at")])
        }),
        Varying::Step { until: None, .. } | Varying::Sine { .. } | Varying::Input { .. } => None,
        Varying::Expression { text, .. } => rule_of_formula(key("text"), text, time),
        Varying::External { .. } => {
            let value = time.compile().ok()?.value(0.0);
            let found = format!("a function that is {value} at t = 0");
            (!value.is_finite()).then(|| finding(key("name"), found, "one that is a number"))
        }
    }
}

fn rule_of_formula(path: String, text: &str, time: &TimeFunction) -> Option<Finding> {
    match time.compile() {
        Err(error) => {
            let rest: String = text.chars().skip(error.at).collect();
            let found = match rest.as_str() {
                "" => "its end".to_owned(),
                rest => quoted(rest),
            };
            let found = format!("{found} at character {}", error.at + 1);
            Some(finding(path, found, error.expected))
        }
        Ok(function) => {
            let value = function.value(0.0);
            let found = || format!("a formula that is {value} at t = 0");
            (!value.is_finite()).then(|| finding(path, found(), "one that is a number"))
        }
    }
}

/// Checks that inputs have unique names, that functions of time refer to inputs, and that each input has a use.
pub(crate) fn inputs(model: &IndexedModel<'_>) -> Vec<Finding> {
    let paths = |(i, input): (usize, &Input)| (format!("inputs[{i}]"), input.name.clone());
    let declared: Vec<(String, String)> = model.inputs.iter().enumerate().map(paths).collect();
    let mut findings =
        rule_of_names(declared.iter().map(|(path, name)| (path.clone(), name.as_str())).collect());
    let used = model.time_functions();
    let used: Vec<(&str, &str)> =
        used.iter().filter_map(|(path, time)| Some((path.as_str(), time.input_name()?))).collect();
    for (path, name) in &used {
        if declared.iter().all(|(_, own)| own != name) {
            let names = declared.iter().map(|(_, name)| name.as_str()).collect();
            let error = unknown(format!("{path}.name"), "input", name, names);
            findings.push(error.rests_on(["inputs".to_owned()]));
        }
    }
    for (path, name) in &declared {
        if used.iter().all(|(_, own)| own != name) {
            let found = format!("{}, which no load and no drive uses", quoted(name));
            let expected =
                "an input that is the `time` of a load or drive: `time = { kind = \"input\", name = ... }`";
            let error = finding(format!("{path}.name"), found, expected);
            let error = error.rests_on(["loads", "joints"].map(str::to_owned));
            findings.push(Finding { absence: true, ..error });
        }
    }
    findings
}

/// Checks that joints to ground points start there in dynamics from the undeformed state.
pub(crate) fn ground_points(model: &IndexedModel<'_>) -> Vec<Finding> {
    let rule = |(path, joint): (String, &Joint)| {
        let (a, End::Point(b)) = joint.ends() else { return None };
        if joint.kind().spans() {
            return None;
        }
        let (owner, body) = body(model, a)?;
        let apart = (model.point(a)? - Vector3::from(b.point)).norm();
        let length = if body.is_flexible() { body.length() } else { model.length() };
        (model.starts_undeformed() && !model.assemble && apart > COINCIDENT * length).then(|| {
            let found = format!("a point that is {} away from `a`", number(apart));
            let expected = "in dynamics, the point of `a` in the undeformed state";
            let rests_on = ["from", "to", "shape"].map(|key| format!("{owner}.{key}"));
            let rests_on = rests_on.into_iter().chain(["a.body", "a.at"].map(|key| format!("{path}.{key}")));
            finding(format!("{path}.b.point"), found, expected)
                .hint("`assemble = true` closes the gap, and `initial.from = \"equilibrium\"` closes it in proportion to the load")
                .rests_on(rests_on)
        })
    };
    joints_of(model).filter_map(rule).collect()
}
