use crate::errors::{ModelError, nearest, quoted, short};
use crate::model::{EndCondition, Model};
use crate::results::Column;
use crate::schema::did_you_mean;
use crate::units::{Dimension, Scales};

/// Conditions that end a motion, with the columns of their values.
#[derive(Debug, Default)]
pub(crate) struct EndConditions(Vec<(EndCondition, usize, Dimension)>);

/// Errors of conditions without a column in the user's units.
pub(crate) fn unknown_values(model: &Model, columns: &[Column]) -> Vec<ModelError> {
    let known = || columns.iter().filter(|column| column.dimension.is_some()).map(|column| &*column.name);
    let conditions = model.analysis.dynamics().map_or(&[][..], |own| &own.until);
    let unknown = |(i, condition): (usize, &EndCondition)| {
        let name = condition.value.as_str();
        known().all(|column| column != name).then(|| {
            let path = format!("analysis.until[{i}].value");
            let error =
                ModelError::new(path, quoted(name), "a column of the results, such as `tip.z` of a probe");
            did_you_mean(error, nearest(name, known()).map(quoted))
        })
    };
    conditions.iter().enumerate().filter_map(unknown).collect()
}

impl EndConditions {
    /// Conditions of an analysis with some columns. Conditions without a column are errors of the model ([`unknown_values`]).
    pub(crate) fn new(conditions: &[EndCondition], columns: &[Column]) -> Self {
        let column = |condition: &EndCondition| {
            let number = columns.iter().position(|column| column.name == condition.value)?;
            Some((condition.clone(), number, columns[number].dimension?))
        };
        Self(conditions.iter().filter_map(column).collect())
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Description of the first condition that a row in the user's units meets. The conditions are in solver units.
    pub(crate) fn met(&self, row: &[f64], scales: Scales) -> Option<String> {
        let is_met = |(condition, number, dimension): &&(EndCondition, usize, Dimension)| {
            condition.is_met(row[*number] / scales.unit(*dimension), *dimension)
        };
        let (condition, number, dimension) = self.0.iter().find(is_met)?;
        // In the units of the limit.
        let value = row[*number] / scales.unit(*dimension) * condition.units.unit(*dimension);
        let value = short(value);
        Some(format!("`{}` = {value}, {}", condition.value, condition.text()))
    }
}
