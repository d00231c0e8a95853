//! The results of a study as a table in a Parquet file.

use std::collections::HashMap;
use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::sync::Arc;

use ancf_results::whole;
use anyhow::{Context, Result};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::record::Field;
use parquet::schema::types::Type;
use toml::Value;

use super::design::Axis;
use super::objective::Objectives;
use super::row::{Ending, Row};

/// Columns of every table; parameters and objectives come after the first.
pub const COLUMNS: [&str; 7] = ["case", "outcome", "message", "steps", "iterations", "seconds", "key"];

/// A column by the type of its values; `None` where there is nothing.
enum Column {
    Integers(Vec<Option<i64>>),
    Numbers(Vec<Option<f64>>),
    Truths(Vec<Option<bool>>),
    Texts(Vec<Option<String>>),
}

/// The rows of cases with what they belong to.
pub struct Table<'a> {
    /// The parameters.
    pub axes: &'a [Axis],
    /// The objectives.
    pub objectives: &'a Objectives,
    /// The text of the study.
    pub text: &'a str,
}

impl Table<'_> {
    /// Writes cases, with their keys and rows, to a file: at once all of it or nothing.
    pub fn write(&self, path: &Path, cases: &[(usize, &str, &Row)]) -> Result<()> {
        whole(path, |file| self.fill(file, cases).map_err(io::Error::other))
            .with_context(|| format!("cannot write {}", path.display()))
    }

    fn fill(&self, file: &File, cases: &[(usize, &str, &Row)]) -> Result<()> {
        let columns = self.columns(cases);
        let fields = columns.iter().map(|(name, column)| column.field(name));
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let schema = Type::group_type_builder("study").with_fields(fields).build()?;
        let about = |key: &str, value: &str| KeyValue::new(key.to_owned(), value.to_owned());
        let program = concat!("ancf ", env!("CARGO_PKG_VERSION"));
        let properties = WriterProperties::builder()
            .set_created_by(program.into())
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(vec![about("program", program), about("study", self.text)]))
            .build();
        let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
        let mut group = writer.next_row_group()?;
        for (_, column) in &columns {
            column.write(&mut group)?;
        }
        group.close()?;
        writer.close()?;
        Ok(())
    }

    fn columns(&self, cases: &[(usize, &str, &Row)]) -> Vec<(String, Column)> {
        let rows = || cases.iter().map(|(_, _, row)| *row);
        let count = |count: Option<u64>| count.and_then(|count| i64::try_from(count).ok());
        let case = cases.iter().map(|(case, _, _)| i64::try_from(*case).ok());
        let mut columns = vec![("case".to_owned(), Column::Integers(case.collect()))];
        for axis in self.axes {
            columns.push((
                axis.path.clone(),
                Column::of(axis, cases.iter().map(|(case, _, _)| axis.value(*case))),
            ));
        }
        for (k, name) in self.objectives.keys().enumerate() {
            columns.push((name.clone(), Column::Numbers(rows().map(|row| row.objectives[k]).collect())));
        }
        let last = [
            Column::Texts(rows().map(|row| Some(row.ending.word().to_owned())).collect()),
            Column::Texts(rows().map(|row| row.message.clone()).collect()),
            Column::Integers(rows().map(|row| count(row.steps)).collect()),
            Column::Integers(rows().map(|row| count(row.iterations)).collect()),
            Column::Numbers(rows().map(|row| Some(row.seconds)).collect()),
            Column::Texts(cases.iter().map(|(_, key, _)| Some((*key).to_owned())).collect()),
        ];
        columns.extend(COLUMNS[1..].iter().map(|name| (*name).to_owned()).zip(last));
        columns
    }
}

impl Column {
    /// The values of a parameter: if all it ever has are of one type, in a column of that type, else as text.
    fn of<'v>(axis: &Axis, values: impl Iterator<Item = &'v Value>) -> Self {
        let all = |test: fn(&Value) -> bool| axis.values().iter().all(test);
        if all(Value::is_integer) {
            Self::Integers(values.map(Value::as_integer).collect())
        } else if all(|value| value.is_integer() || value.is_float()) {
            let number = |value: &Value| value.as_float().or_else(|| value.as_integer().map(|n| n as f64));
            Self::Numbers(values.map(number).collect())
        } else if all(Value::is_bool) {
            Self::Truths(values.map(Value::as_bool).collect())
        } else {
            let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), ToOwned::to_owned);
            Self::Texts(values.map(|value| Some(text(value))).collect())
        }
    }

    fn field(&self, name: &str) -> parquet::errors::Result<Arc<Type>> {
        let (physical, logical) = match self {
            Self::Integers(_) => (Physical::INT64, None),
            Self::Numbers(_) => (Physical::DOUBLE, None),
            Self::Truths(_) => (Physical::BOOLEAN, None),
            Self::Texts(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(name, physical).with_repetition(Repetition::OPTIONAL);
        Ok(Arc::new(field.with_logical_type(logical).build()?))
    }

    fn write(&self, group: &mut SerializedRowGroupWriter<'_, &File>) -> parquet::errors::Result<()> {
        match self {
            Self::Integers(values) => write::<Int64Type>(group, values),
            Self::Numbers(values) => write::<DoubleType>(group, values),
            Self::Truths(values) => write::<BoolType>(group, values),
            Self::Texts(texts) => {
                let bytes = |text: &Option<String>| text.as_deref().map(ByteArray::from);
                write::<ByteArrayType>(group, &texts.iter().map(bytes).collect::<Vec<_>>())
            }
        }
    }
}

fn write<D: DataType>(
    group: &mut SerializedRowGroupWriter<'_, &File>,
    values: &[Option<D::T>],
) -> parquet::errors::Result<()> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    let present: Vec<D::T> = values.iter().flatten().cloned().collect();
    let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
    column.typed::<D>().write_batch(&present, Some(&levels), None)?;
    column.close()
}

/// Rows by their keys of all tables in a folder, but of cases that were stopped; those that finished go before others.
pub fn rows_in(folder: &Path, objectives: &Objectives) -> Result<HashMap<String, Row>> {
    let mut rows = HashMap::new();
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(rows),
        entries => entries.with_context(|| format!("cannot read {}", folder.display()))?,
    };
    for entry in entries {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("cases") && name.ends_with(".parquet") {
            let other = "remove it or take another folder for the results";
            read(&path, objectives, &mut rows)
                .with_context(|| format!("{} cannot be read; {other}", path.display()))?;
        }
    }
    Ok(rows)
}

fn read(path: &Path, objectives: &Objectives, rows: &mut HashMap<String, Row>) -> Result<()> {
    for row in SerializedFileReader::new(File::open(path)?)?.get_row_iter(None)? {
        let fields = row?.into_columns();
        let fields: HashMap<&str, &Field> = fields.iter().map(|(name, field)| (&**name, field)).collect();
        let Some((key, row)) = from_fields(&fields, objectives) else { continue };
        let is_better = row.ending == Ending::Finished || !rows.contains_key(&key);
        if row.ending != Ending::Stopped && is_better {
            rows.insert(key, row);
        }
    }
    Ok(())
}

/// The key and the row of a case; `None` if it is the row of another study.
fn from_fields(fields: &HashMap<&str, &Field>, objectives: &Objectives) -> Option<(String, Row)> {
    let number = |name: &str| match fields.get(name) {
        Some(Field::Double(x)) => Some(*x),
        _ => None,
    };
    let count = |name: &str| match fields.get(name) {
        Some(Field::Long(n)) => u64::try_from(*n).ok(),
        _ => None,
    };
    let text = |name: &str| match fields.get(name) {
        Some(Field::Str(text)) => Some(text.clone()),
        _ => None,
    };
    let values = objectives.keys().map(|name| fields.contains_key(name.as_str()).then(|| number(name)));
    let row = Row {
        ending: Ending::of(&text("outcome")?)?,
        message: text("message"),
        objectives: values.collect::<Option<_>>()?,
        steps: count("steps"),
        iterations: count("iterations"),
        seconds: number("seconds")?,
    };
    Some((text("key")?, row))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(ending: Ending) -> Row {
        Row { ending, message: None, objectives: Vec::new(), steps: None, iterations: None, seconds: 1.0 }
    }

    /// Of the rows of a case in several files, in whatever order these are read.
    #[test]
    fn a_stopped_row_hides_none_and_a_finished_one_all() {
        let objectives = Objectives::new();
        let table = Table { axes: &[], objectives: &objectives, text: "" };
        for (one, other, kept) in [
            (Ending::Stopped, Ending::Failed, Some(Ending::Failed)),
            (Ending::Stopped, Ending::Invalid, Some(Ending::Invalid)),
            (Ending::Failed, Ending::Finished, Some(Ending::Finished)),
            (Ending::Stopped, Ending::Stopped, None),
        ] {
            for endings in [[one, other], [other, one]] {
                let folder = tempfile::TempDir::new().unwrap();
                for (ending, name) in endings.into_iter().zip(["cases.parquet", "cases-1-of-2.parquet"]) {
                    table.write(&folder.path().join(name), &[(0, "key", &row(ending))]).unwrap();
                }
                let rows = rows_in(folder.path(), &objectives).unwrap();
                assert_eq!(rows.get("key").map(|row| row.ending), kept, "{endings:?}");
            }
        }
    }
}
