use ancf::reading::{substitute, values_at};
use toml::Value;

use super::options::ExportError;
use crate::interface::Parameter;

/// Finds the parameters in the data of a model and sets their values.
///
/// # Errors
/// If a path does not exist, is not the path of a real number, or is that of another parameter.
pub(super) fn parameters(
    data: &mut Value,
    stated: &[(String, Option<f64>)],
) -> Result<Vec<Parameter>, ExportError> {
    let mut taken: Vec<String> = Vec::new();
    let mut found = Vec::new();
    for (path, value) in stated {
        let wrong = |reason: String| ExportError::Parameter { path: path.clone(), reason };
        let values = values_at(data, path).map_err(|error| wrong(error.to_string()))?;
        if let Some((twice, _)) = values.iter().find(|(own, _)| taken.contains(own)) {
            return Err(wrong(format!("{twice} is a parameter already")));
        }
        let start = match value {
            Some(value) => *value,
            None => common(&values).map_err(wrong)?,
        };
        taken.extend(values.into_iter().map(|(own, _)| own));
        substitute(data, path, start.into()).map_err(|error| wrong(error.to_string()))?;
        found.push(Parameter { path: path.clone(), start });
    }
    Ok(found)
}

/// Number to which all locations of a path have been set.
fn common(values: &[(String, Option<Value>)]) -> Result<f64, String> {
    let hint = "state one with PATH=VALUE";
    let mut numbers = values.iter().map(|(path, value)| match value {
        Some(Value::Float(number)) => Ok(*number),
        Some(Value::Integer(number)) => Ok(*number as f64),
        Some(_) => Err(format!("{path} is not a number")),
        None => Err(format!("{path} has no value; {hint}")),
    });
    let first = numbers.next().unwrap_or_else(|| Err(format!("it has no value; {hint}")))?;
    match numbers.find(|number| number.as_ref().is_ok_and(|number| *number != first) || number.is_err()) {
        Some(Err(reason)) => Err(reason),
        Some(Ok(other)) => Err(format!("its values differ, {first} and {other}; {hint}")),
        None => Ok(first),
    }
}
