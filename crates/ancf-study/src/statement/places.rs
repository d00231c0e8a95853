//! Places in a model that the parameters of a study set, and conflicts between parameters.

use ancf::ModelError;
use ancf::reading::substitute;
use toml::Value;

use super::parameter::parameter_path;

/// Returns the data of a model with the first value of each parameter, and the errors of the paths.
///
/// A path without a target is an error, and so is a parameter that overwrites or redirects another. Parameters are set in the
/// given order.
pub fn check_places(first_values: &[(String, Value)], base: &Value) -> (Value, Vec<ModelError>) {
    let (places, mut errors) = ParameterPlaces::new(first_values, base);
    errors.extend(places.conflicts());
    (places.data, errors)
}

/// Places that the parameters set.
struct ParameterPlaces<'a> {
    /// Data of the model with the first value of every parameter.
    data: Value,
    parameters: Vec<ParameterTarget<'a>>,
}

/// Parameter and the places that it sets.
struct ParameterTarget<'a> {
    path: &'a str,
    places: Vec<String>,
}

impl<'a> ParameterPlaces<'a> {
    /// Sets the first values in the given order. Returns an error for each path without a target.
    fn new(first_values: &'a [(String, Value)], base: &Value) -> (Self, Vec<ModelError>) {
        let mut places = Self { data: base.clone(), parameters: Vec::new() };
        let mut errors = Vec::new();
        for (path, value) in first_values {
            match substitute(&mut places.data, path, value.clone()) {
                Ok(set) => places.parameters.push(ParameterTarget { path, places: set }),
                Err(error) => errors.push(ModelError { path: parameter_path(path), ..error }),
            }
        }
        (places, errors)
    }

    /// Returns an error for each parameter that overwrites or redirects another.
    fn conflicts(&self) -> Vec<ModelError> {
        let mut errors = Vec::new();
        for (k, one) in self.parameters.iter().enumerate() {
            for (l, other) in self.parameters.iter().enumerate().filter(|(l, _)| *l != k) {
                match one.overlap(other) {
                    Some(error) if l < k => errors.push(error),
                    None if self.is_redirected(one, other) => errors.push(one.path_through(other)),
                    _ => {}
                }
            }
        }
        errors
    }

    /// True if the path of `one` has another target once `other` has a value that names nothing.
    fn is_redirected(&self, one: &ParameterTarget<'_>, other: &ParameterTarget<'_>) -> bool {
        let mut data = self.data.clone();
        let nothing = || Value::String("\0".into());
        substitute(&mut data, other.path, nothing()).is_ok()
            && substitute(&mut data, one.path, nothing()).map_or(true, |places| places != one.places)
    }
}

impl ParameterTarget<'_> {
    /// Returns the error of a place that another parameter sets too, as a whole or in part.
    fn overlap(&self, other: &Self) -> Option<ModelError> {
        let pairs = || self.places.iter().flat_map(|mine| other.places.iter().map(move |its| (mine, its)));
        let (mine, its) = pairs().find(|(mine, its)| within(mine, its) || within(its, mine))?;
        let found = if within(mine, its) {
            format!("`{mine}`, which `{}` sets too", other.path)
        } else {
            format!("`{mine}`, of which `{}` sets a part", other.path)
        };
        let error = ModelError::new(parameter_path(self.path), found, "every place to be set once");
        let hint = "give the whole with its parts, or the parts alone";
        Some(if mine == its { error } else { error.hint(hint) })
    }

    /// Returns the error of a path whose target depends on the value of another parameter.
    fn path_through(&self, other: &Self) -> ModelError {
        let found = format!("a path through what `{}` sets", other.path);
        let expected = "a path that leads to the same place in every case";
        let error = ModelError::new(parameter_path(self.path), found, expected);
        match self.places.first() {
            Some(place) => error.hint(format!("such as `{place}`")),
            None => error,
        }
    }
}

/// True if `place` equals `whole` or is a part of it.
fn within(place: &str, whole: &str) -> bool {
    place.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
