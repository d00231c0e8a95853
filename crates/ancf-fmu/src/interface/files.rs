use std::ffi::CStr;

use ancf::reading::substitute;
use ancf::{Model, ModelErrors};
use toml::Value;

use super::variables::Interface;

/// Name of the model file in the resources of an FMU.
pub const MODEL: &str = "model.toml";
/// Name of the file with the variables.
pub const INTERFACE: &str = "interface.toml";

/// Text that the library inside FMUs of this version contains.
pub const MARKER: &CStr =
    text_of(concat!("ancf library for FMUs, version ", env!("CARGO_PKG_VERSION"), "\0"));

const fn text_of(text: &'static str) -> &'static CStr {
    match CStr::from_bytes_with_nul(text.as_bytes()) {
        Ok(text) => text,
        Err(_) => c"",
    }
}

/// Model with values of its parameters and inputs.
///
/// # Errors
/// If the model is not valid with these values.
pub fn model_with(
    data: &Value,
    interface: &Interface,
    parameters: &[f64],
    inputs: &[f64],
) -> Result<Model, ModelErrors> {
    let mut data = data.clone();
    let mut set = |path: &str, value: f64| {
        substitute(&mut data, path, value.into()).map_err(|error| ModelErrors(vec![error]))
    };
    for (parameter, value) in interface.parameters.iter().zip(parameters) {
        set(&parameter.path, *value)?;
    }
    for (i, value) in inputs.iter().enumerate() {
        set(&format!("inputs[{i}].value"), *value)?;
    }
    Model::from_value(&data)
}
