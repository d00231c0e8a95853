use std::collections::BTreeMap;
use std::fmt::Write;

use ancf::Column;
use ancf::model::Units;
use parquet::file::metadata::KeyValue;
use sha2::{Digest, Sha256};

/// Where results come from: written into every file of them.
#[derive(Clone, Debug)]
pub(crate) struct Provenance {
    text: String,
    units: BTreeMap<String, String>,
}

pub(crate) const PROGRAM: &str = concat!("ancf ", env!("CARGO_PKG_VERSION"));

impl Provenance {
    /// Of a model by its text, with the names of its units, and its columns.
    pub(crate) fn new(text: &str, units: &Units, columns: &[Column]) -> Self {
        let of = |column: &Column| Some((column.name.clone(), column.unit(units)?));
        Self { text: text.to_owned(), units: columns.iter().filter_map(of).collect() }
    }

    /// The same of a table whose columns have no units.
    pub(crate) fn without_units(&self) -> Self {
        Self { units: BTreeMap::new(), ..self.clone() }
    }

    pub(crate) fn metadata(&self) -> Vec<KeyValue> {
        let about = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let mut metadata = vec![
            about("program", PROGRAM.to_owned()),
            about("model", self.text.clone()),
            about("sha256", sha256(self.text.as_bytes())),
        ];
        if let (false, Ok(units)) = (self.units.is_empty(), serde_json::to_string(&self.units)) {
            metadata.push(about("units", units));
        }
        metadata
    }
}

/// The SHA-256 of bytes, in hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut digits, byte| {
        write!(digits, "{byte:02x}").expect("a String takes any text");
        digits
    })
}
