//! Checks of inputs.

use super::findings::unknown;
use super::rules::rule_of_names;
use crate::errors::{Finding, finding, quoted};
use crate::model::IndexedModel;

/// Checks that inputs have unique names, that functions of time refer to inputs, and that each input has a use.
pub(super) fn inputs(model: &IndexedModel<'_>) -> Vec<Finding> {
    let paths = |(i, input): (usize, &crate::model::Input)| (format!("inputs[{i}]"), input.name.clone());
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
