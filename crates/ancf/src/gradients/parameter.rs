use toml::Value;

use crate::errors::{ModelError, ModelErrors, quoted, short};
use crate::model::Model;
use crate::reading::{substitute, values_at};

/// Number of a model by which results are differentiated.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Path of the number, such as `materials.steel.young` ([`substitute`]).
    pub path: String,
    /// Size of the largest change for differences; by default a part of the number. It is necessary for a zero, except for a component of
    /// a vector with others.
    pub size: Option<f64>,
}

impl Parameter {
    /// Parameter that is changed in proportion to its number.
    pub fn new(path: impl Into<String>) -> Self {
        Self { path: path.into(), size: None }
    }
}

impl From<&str> for Parameter {
    fn from(path: &str) -> Self {
        Self::new(path)
    }
}

/// Largest change, relative to the number.
const LARGEST: f64 = 1.0 / 8.0;
/// Keys that are not part of the mechanical model.
const EXCLUDED: [&str; 4] = ["analysis", "output", "scales", "inputs"];

/// Parameter of a model with its value.
#[derive(Clone, Debug)]
pub(super) struct ModelNumber {
    pub(super) path: String,
    pub(super) value: f64,
    /// Complete paths of the number.
    places: Vec<String>,
    /// Largest change.
    pub(super) largest: f64,
}

impl ModelNumber {
    /// Finds the number of a parameter in the data of a model.
    pub(super) fn new(data: &Value, parameter: &Parameter) -> Result<Self, ModelError> {
        let path = &parameter.path;
        let first = path.split(['.', '[']).next().unwrap_or_default();
        if EXCLUDED.contains(&first) {
            let expected = "a number of the structure or its loads";
            return Err(ModelError::new(path, quoted(first), expected));
        }
        let found = values_at(data, path)?;
        let mut numbers = Vec::new();
        for (place, value) in &found {
            numbers.push(number(place, value.as_ref())?);
        }
        let Some(&value) = numbers.first() else {
            return Err(ModelError::new(path, "no value", "a number"));
        };
        if numbers.iter().any(|other| *other != value) {
            let expected = "equal numbers, or the path of one of them";
            return Err(ModelError::new(path, "different numbers in several bodies", expected));
        }
        let size = match parameter.size {
            Some(size) if size.is_finite() && size > 0.0 => Some(size),
            Some(size) => {
                return Err(ModelError::new(path, format!("the size {size}"), "a positive size"));
            }
            None if value != 0.0 => Some(LARGEST * value.abs()),
            None => neighbours(data, path).map(|size| LARGEST * size),
        };
        let largest = size.ok_or_else(|| {
            let expected = "a number other than 0, or the size of its change";
            ModelError::new(path, "0, to which changes have no proportion", expected)
        })?;
        let places = found.into_iter().map(|(place, _)| place).collect();
        Ok(Self { path: path.clone(), value, places, largest })
    }

    /// Number with smaller changes.
    pub(super) fn reduced(&self, factor: f64) -> Self {
        Self { largest: factor * self.largest, ..self.clone() }
    }

    /// Returns the model with a changed number.
    ///
    /// # Errors
    /// All errors of the changed model.
    pub(super) fn varied(&self, data: &Value, by: f64) -> Result<Model, ModelErrors> {
        let mut data = data.clone();
        substitute(&mut data, &self.path, Value::Float(self.value + by))
            .map_err(|error| ModelErrors(vec![error]))?;
        Model::from_value(&data).map_err(|errors| self.of_changed(errors, by))
    }

    /// Rejects a number that cannot change by its usual part without a contradiction to other numbers, such as a gap in a joint.
    ///
    /// Smaller changes within the tolerance of gaps would have the effect of a misfit.
    pub(super) fn require_freedom(&self, data: &Value) -> Result<(), ModelErrors> {
        // Models with larger changes are assembled, which is the same check.
        if self.largest >= LARGEST * self.value.abs() {
            return Ok(());
        }
        for sign in [1.0, -1.0] {
            match self.varied(data, sign * LARGEST * self.value) {
                Err(errors) if !self.is_out_of_range(&errors) => return Err(errors),
                _ => {}
            }
        }
        Ok(())
    }

    /// True if errors of a changed model are those of the range of the number.
    pub(super) fn is_out_of_range(&self, errors: &ModelErrors) -> bool {
        errors.iter().all(|error| self.places.contains(&error.path))
    }

    /// States the changed number in errors of the changed model.
    pub(super) fn of_changed(&self, errors: ModelErrors, by: f64) -> ModelErrors {
        let hint = format!("with `{}` = {} for its derivative", self.path, short(self.value + by));
        ModelErrors(errors.into_iter().map(|error| error.hint(hint.clone())).collect())
    }
}

fn number(path: &str, value: Option<&Value>) -> Result<f64, ModelError> {
    let expected = "a number that can vary continuously";
    match value {
        Some(Value::Float(x)) => Ok(*x),
        Some(Value::Integer(x)) => Err(ModelError::new(path, format!("the integer {x}"), expected)),
        Some(_) => Err(ModelError::new(path, "no number", expected)),
        None => Err(ModelError::new(path, "no value", "a number in the model")),
    }
}

/// Largest magnitude of the components of the vector of a component.
fn neighbours(data: &Value, path: &str) -> Option<f64> {
    let (vector, _) = path.strip_suffix(']')?.rsplit_once('[')?;
    let found = values_at(data, vector).ok()?;
    let of_vector = |value: &Value| match value {
        Value::Array(items) => items.iter().filter_map(Value::as_float).map(f64::abs).fold(0.0, f64::max),
        _ => 0.0,
    };
    let largest = found.iter().filter_map(|(_, value)| value.as_ref()).map(of_vector).fold(0.0, f64::max);
    (largest > 0.0).then_some(largest)
}
