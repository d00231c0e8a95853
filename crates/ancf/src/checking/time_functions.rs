//! Checks of functions of time, force laws, inputs and ground points.

use std::collections::BTreeSet;

use ancf_mechanics::functions::InputSignal;
use ancf_mechanics::laws::{ForceLaw as _, LawState, is_law_name};
use nalgebra::Vector3;

use super::findings::{COINCIDENT, body, rule_of_names};
use crate::errors::{Finding, finding, formula_error, number, quoted};
use crate::joints::{End, Joint};
use crate::model::{
    IndexedModel, Input, JointLaw, LawKind, LawUse, Model, Origin, TimeFunction, Varying, joints_of,
};
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
        Err(error) => Some(formula_error(path, text, error)),
        Ok(function) => {
            let value = function.value(0.0);
            let found = || format!("a formula that is {value} at t = 0");
            (!value.is_finite()).then(|| finding(path, found(), "one that is a number"))
        }
    }
}

/// Checks that formulas of force laws are valid, defined in the undeformed state, and free of t in analyses without time.
pub(crate) fn laws(model: &IndexedModel<'_>) -> Vec<Finding> {
    let signals = constant_inputs(model);
    let of_formulas = model.laws().filter_map(|(path, one)| rule_of_law(model, &path, &one, &signals));
    of_formulas.chain((0..model.inputs.len()).filter_map(|number| rule_of_input(model, number))).collect()
}

/// Inputs with their declared values.
fn constant_inputs(model: &Model) -> Vec<(String, InputSignal)> {
    model.inputs.iter().map(|input| (input.name.clone(), InputSignal::new(input.value))).collect()
}

/// Names of the inputs that formulas of force laws contain.
fn inputs_of_laws(model: &Model) -> BTreeSet<String> {
    let signals = constant_inputs(model);
    let laws = model.laws().filter_map(|(_, one)| one.law.expression(one.kind, 1.0, &signals).ok()?);
    let laws: Vec<_> = laws.collect();
    let with_states = model.laws().filter_map(|(_, one)| one.law.state_law(one.kind, &signals).ok()?);
    let with_states: Vec<_> = with_states.map(|(law, _)| law).collect();
    let used = |number: &usize| {
        laws.iter().any(|law| law.contains_input(*number))
            || with_states.iter().any(|law| law.contains_input(*number))
    };
    (0..signals.len()).filter(used).map(|number| signals[number].0.clone()).collect()
}

fn rule_of_law(
    model: &IndexedModel<'_>,
    path: &str,
    one: &LawUse<'_>,
    signals: &[(String, InputSignal)],
) -> Option<Finding> {
    let JointLaw::Expression { text, .. } = one.law else { return None };
    if let Some(error) = rule_of_words(path, one.law) {
        return Some(error);
    }
    let key = format!("{path}.text");
    let law = match one.law.expression(one.kind, 1.0, signals) {
        Ok(law) => law?,
        Err(error) => return Some(formula_error(key, text, error).rests_on(["inputs".to_owned()])),
    };
    if law.contains_time() && model.analysis.dynamics().is_none() {
        let expected = "a formula without `t`, since the analysis has no time; an input is a parameter";
        return Some(finding(key, "`t` in a formula", expected).rests_on(["analysis".to_owned()]));
    }
    let of_states = rule_of_states(model, path, one, signals);
    if of_states.is_some() {
        return of_states;
    }
    if !one.law.signals().is_empty() {
        return None;
    }
    let value = law.at(LawState { t: 0.0, x: 0.0, v: 0.0 }).force;
    let found = format!("a formula that is {value} at x = 0, v = 0, t = 0");
    (!value.is_finite()).then(|| finding(key, found, "one that is a number"))
}

/// Finding for names of states and signals that no formula can contain. They are also parts of the names of columns.
fn rule_of_words(path: &str, law: &JointLaw) -> Option<Finding> {
    let states = law.states().iter().enumerate().map(|(k, state)| ("states", k, &state.name));
    let signals = law.signals().iter().enumerate().map(|(k, signal)| ("signals", k, &signal.name));
    let is_word = |name: &str| {
        name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && !name.starts_with(|c: char| c.is_ascii_digit())
    };
    let (list, k, name) = states.chain(signals).find(|(.., name)| !is_word(name))?;
    let expected = "letters from a to z, digits and _, with no digit at the start: it is a word of formulas";
    Some(finding(format!("{path}.{list}[{k}].name"), quoted(name), expected))
}

/// Finding for the states and signals of a force law: names, formulas of rates, analyses without them, and laws of struts, which have
/// no coordinate.
fn rule_of_states(
    model: &IndexedModel<'_>,
    path: &str,
    one: &LawUse<'_>,
    signals: &[(String, InputSignal)],
) -> Option<Finding> {
    let (states, own_signals) = (one.law.states(), one.law.signals());
    let key = match (states.is_empty(), own_signals.is_empty()) {
        (true, true) => return None,
        (false, _) => "states",
        (true, false) => "signals",
    };
    if one.kind == LawKind::Tension {
        let expected = "none for a spring between two points; a guide or a hinge has a coordinate";
        return Some(finding(format!("{path}.{key}"), key, expected));
    }
    if model.output.errors {
        let expected = format!("false with {key} of force laws, whose errors are not estimated");
        return Some(finding("output.errors".into(), "true", expected).rests_on([path.to_owned()]));
    }
    let is_motion = model.analysis.dynamics().is_some() && model.initial.from != Origin::Equilibrium;
    if !own_signals.is_empty() && !is_motion {
        let found = "a law with signals in an equilibrium, modes or critical loads";
        let expected = "a motion that does not start by its own equilibrium; in a list of analyses, `only_in` limits the joint to \
                        motions";
        let rests_on = ["analysis", "initial"].map(str::to_owned);
        return Some(finding(format!("{path}.signals"), found, expected).rests_on(rests_on));
    }
    let of_states = states.iter().enumerate().map(|(k, state)| ("states", k, state.name.as_str()));
    let of_signals = own_signals.iter().enumerate().map(|(k, signal)| ("signals", k, signal.name.as_str()));
    let names: Vec<_> = of_states.chain(of_signals).collect();
    let named = |(i, &(list, k, name)): (usize, &(&str, usize, &str))| {
        let is_taken = is_law_name(name, &one.kind.variables())
            || signals.iter().any(|(input, _)| input == name)
            || names[..i].iter().any(|(.., other)| *other == name);
        let expected = "another name: it is a variable, a function, an input, or another state or signal";
        is_taken.then(|| finding(format!("{path}.{list}[{k}].name"), quoted(name), expected))
    };
    names.iter().enumerate().find_map(named).or_else(|| match one.law.state_law(one.kind, signals) {
        Err((number, error)) => {
            let k = number?;
            Some(formula_error(format!("{path}.states[{k}].rate"), &states[k].rate, error))
        }
        Ok(law) => {
            let ((law, _), at) = (law?, LawState { t: 0.0, x: 0.0, v: 0.0 });
            if !own_signals.is_empty() {
                return None;
            }
            let rate = |k: usize| law.rate(k, at, law.start()).force;
            let k = (0..states.len()).find(|k| !rate(*k).is_finite())?;
            let found = format!("a formula that is {} at the start", rate(k));
            Some(finding(format!("{path}.states[{k}].rate"), found, "one that is a number"))
        }
    })
}

/// Finding if the name of an input has another meaning in a formula of a force law.
fn rule_of_input(model: &IndexedModel<'_>, number: usize) -> Option<Finding> {
    let name = &model.inputs[number].name;
    let clashes = |one: LawUse<'_>| {
        matches!(one.law, JointLaw::Expression { .. }) && is_law_name(name, &one.kind.variables())
    };
    let expected = "another name: in formulas of force laws it is a variable or a function";
    let error = finding(format!("inputs[{number}].name"), quoted(name), expected);
    model.laws().any(|(_, one)| clashes(one)).then(|| error.rests_on(["joints".to_owned()]))
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
    let laws = inputs_of_laws(model);
    for (path, name) in &used {
        if declared.iter().all(|(_, own)| own != name) {
            let names = declared.iter().map(|(_, name)| name.as_str()).collect();
            let error = unknown(format!("{path}.name"), "input", name, names);
            findings.push(error.rests_on(["inputs".to_owned()]));
        }
    }
    for (path, name) in &declared {
        if used.iter().all(|(_, own)| own != name) && !laws.contains(name) {
            let found = format!("{}, which no load, no drive and no force law uses", quoted(name));
            let expected = "an input in a formula of a force law, or as the `time` of a load or drive: \
                            `time = { kind = \"input\", name = ... }`";
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
