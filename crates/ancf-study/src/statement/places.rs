//! The places in a model that the parameters of a study set, and parameters that are in each other's way.

use std::collections::BTreeMap;

use ancf::ModelError;
use ancf::model::substitute;
use toml::Value;

use super::statement::{Parameter, at};

/// The places that parameters set.
pub struct Places<'a> {
    /// The model with the first value of every parameter.
    pub data: Value,
    parameters: Vec<Target<'a>>,
}

/// A parameter and the places that it sets.
struct Target<'a> {
    path: &'a str,
    places: Vec<String>,
}

impl<'a> Places<'a> {
    /// Sets the first values in the order in which a case sets its own; with paths that lead nowhere.
    pub fn of(parameters: &'a BTreeMap<String, Parameter>, base: &Value) -> (Self, Vec<ModelError>) {
        let mut places = Self { data: base.clone(), parameters: Vec::new() };
        let mut faults = Vec::new();
        for (path, parameter) in parameters {
            let Some(value) = parameter.first() else { continue };
            match substitute(&mut places.data, path, value) {
                Ok(set) => places.parameters.push(Target { path, places: set }),
                Err(error) => faults.push(ModelError { path: at(path), ..error }),
            }
        }
        (places, faults)
    }

    /// Parameters of which one would undo, or turn elsewhere, what another sets.
    pub fn faults(&self) -> Vec<ModelError> {
        let mut faults = Vec::new();
        for (k, one) in self.parameters.iter().enumerate() {
            for (l, other) in self.parameters.iter().enumerate().filter(|(l, _)| *l != k) {
                match one.overlap(other) {
                    Some(fault) if l < k => faults.push(fault),
                    None if self.is_turned(one, other) => faults.push(one.through(other)),
                    _ => {}
                }
            }
        }
        faults
    }

    /// Whether a path leads elsewhere once another parameter has a value that names nothing.
    fn is_turned(&self, one: &Target<'_>, other: &Target<'_>) -> bool {
        let mut data = self.data.clone();
        let nothing = || Value::String("\0".into());
        substitute(&mut data, other.path, nothing()).is_ok()
            && substitute(&mut data, one.path, nothing()).map_or(true, |places| places != one.places)
    }
}

impl Target<'_> {
    /// The fault of setting what another sets too, the whole of it or a part.
    fn overlap(&self, other: &Self) -> Option<ModelError> {
        let pairs = || self.places.iter().flat_map(|mine| other.places.iter().map(move |its| (mine, its)));
        let (mine, its) = pairs().find(|(mine, its)| within(mine, its) || within(its, mine))?;
        let found = if within(mine, its) {
            format!("`{mine}`, which `{}` sets too", other.path)
        } else {
            format!("`{mine}`, of which `{}` sets a part", other.path)
        };
        let error = ModelError::new(at(self.path), found, "every place to be set once");
        let hint = "give the whole with its parts, or the parts alone";
        Some(if mine == its { error } else { error.hint(hint) })
    }

    /// The fault of a path that leads where the value of another parameter says.
    fn through(&self, other: &Self) -> ModelError {
        let found = format!("a path through what `{}` sets", other.path);
        let wanted = "a path that leads to the same place in every case";
        let error = ModelError::new(at(self.path), found, wanted);
        match self.places.first() {
            Some(place) => error.hint(format!("such as `{place}`")),
            None => error,
        }
    }
}

/// Whether a place is another or lies in it.
fn within(place: &str, whole: &str) -> bool {
    place.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}
