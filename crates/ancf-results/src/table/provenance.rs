use std::collections::BTreeMap;

use ancf::Column;
use ancf::model::Units;
use parquet::file::metadata::KeyValue;

use crate::folder::sha256;

/// Origin of results, written into every Parquet file: program, model and units.
#[derive(Clone, Debug)]
pub(crate) struct Provenance {
    text: String,
    units: Option<BTreeMap<String, String>>,
}

/// Name and version of the program.
pub(crate) const PROGRAM: &str = concat!("ancf ", env!("CARGO_PKG_VERSION"));

impl Provenance {
    /// Provenance of a model, given its text, the names of its units, and the columns of its run.
    pub(crate) fn new(text: &str, units: &Units, columns: &[Column]) -> Self {
        let of = |column: &Column| Some((column.name.clone(), column.unit(units)?));
        Self { text: text.to_owned(), units: Some(columns.iter().filter_map(of).collect()) }
    }

    /// Removes the units, for a table whose columns have none.
    pub(crate) fn without_units(&self) -> Self {
        Self { units: None, ..self.clone() }
    }

    /// Key-value metadata of a Parquet file.
    pub(crate) fn metadata(&self) -> Vec<KeyValue> {
        let entry = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let mut metadata = vec![
            entry("program", PROGRAM.to_owned()),
            entry("model", self.text.clone()),
            entry("sha256", sha256(self.text.as_bytes())),
        ];
        if let Some(Ok(units)) = self.units.as_ref().map(serde_json::to_string) {
            metadata.push(entry("units", units));
        }
        metadata
    }
}
