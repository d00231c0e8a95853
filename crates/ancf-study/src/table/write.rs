//! Results of a study as a Parquet table.

use std::fs::File;
use std::io;
use std::path::Path;
use std::sync::Arc;

use ancf_results::{checksum_placeholder, write_atomically, write_checksums};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use toml::Value;

use super::error::{StudyError, TableError};
use super::parameter_type::ParameterType;
use crate::cases::{CaseRow, ParameterAxis};
use crate::statement::{Objectives, TABLE_COLUMNS};

/// Column by the type of its values. `None` is a null.
enum TableColumn {
    Integers(Vec<Option<i64>>),
    Numbers(Vec<Option<f64>>),
    Truths(Vec<Option<bool>>),
    Texts(Vec<Option<String>>),
}

/// Parameters, objectives and text of a study, for its table.
#[derive(Clone, Copy, Debug)]
pub struct StudyTable<'a> {
    /// Parameters.
    pub axes: &'a [ParameterAxis],
    /// Objectives.
    pub objectives: &'a Objectives,
    /// Text of the study file.
    pub text: &'a str,
}

impl StudyTable<'_> {
    /// Writes cases, with their keys and rows, to a file. The file is replaced as a whole.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path, cases: &[(usize, &str, &CaseRow)]) -> Result<(), StudyError> {
        write_atomically(path, |file| self.fill(file, cases).map_err(io::Error::other))
            .map_err(|source| StudyError::File { action: "write", path: path.to_owned(), source })
    }

    fn fill(&self, file: &File, cases: &[(usize, &str, &CaseRow)]) -> Result<(), TableError> {
        let columns = self.columns(cases);
        let fields = columns.iter().map(|(name, column)| column.field(name));
        let fields = fields.collect::<Result<Vec<_>, _>>()?;
        let schema = Type::group_type_builder("study").with_fields(fields).build()?;
        let about = |key: &str, value: &str| KeyValue::new(key.to_owned(), value.to_owned());
        let program = concat!("ancf ", env!("CARGO_PKG_VERSION"));
        let properties = WriterProperties::builder()
            .set_created_by(program.into())
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(vec![
                about("program", program),
                about("study", self.text),
                checksum_placeholder(1),
            ]))
            .build();
        let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
        let mut group = writer.next_row_group()?;
        for (_, column) in &columns {
            column.write(&mut group)?;
        }
        group.close()?;
        writer.close()?;
        Ok(write_checksums(file)?)
    }

    fn columns(&self, cases: &[(usize, &str, &CaseRow)]) -> Vec<(String, TableColumn)> {
        let rows = || cases.iter().map(|(_, _, row)| *row);
        let count = |count: Option<u64>| count.and_then(|count| i64::try_from(count).ok());
        let case = cases.iter().map(|(case, _, _)| i64::try_from(*case).ok());
        let mut columns = vec![("case".to_owned(), TableColumn::Integers(case.collect()))];
        for axis in self.axes {
            columns.push((
                axis.path.clone(),
                TableColumn::of_parameter(axis, cases.iter().map(|(case, _, _)| axis.value(*case))),
            ));
        }
        for (k, name) in self.objectives.keys().enumerate() {
            columns.push((name.clone(), TableColumn::Numbers(rows().map(|row| row.objectives[k]).collect())));
        }
        let last = [
            TableColumn::Texts(rows().map(|row| Some(row.outcome.word().to_owned())).collect()),
            TableColumn::Texts(rows().map(|row| row.message.clone()).collect()),
            TableColumn::Integers(rows().map(|row| count(row.steps)).collect()),
            TableColumn::Integers(rows().map(|row| count(row.iterations)).collect()),
            TableColumn::Numbers(rows().map(|row| Some(row.seconds)).collect()),
            TableColumn::Texts(cases.iter().map(|(_, key, _)| Some((*key).to_owned())).collect()),
        ];
        columns.extend(TABLE_COLUMNS[1..].iter().map(|name| (*name).to_owned()).zip(last));
        columns
    }
}

impl TableColumn {
    /// Creates the column of a parameter. If its values have different types, the column contains text.
    fn of_parameter<'v>(axis: &ParameterAxis, values: impl Iterator<Item = &'v Value>) -> Self {
        let number = |value: &Value| value.as_float().or_else(|| value.as_integer().map(|n| n as f64));
        let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), ToOwned::to_owned);
        match ParameterType::of(axis.values()) {
            ParameterType::Integer => Self::Integers(values.map(Value::as_integer).collect()),
            ParameterType::Number => Self::Numbers(values.map(number).collect()),
            ParameterType::Boolean => Self::Truths(values.map(Value::as_bool).collect()),
            ParameterType::Text => Self::Texts(values.map(|value| Some(text(value))).collect()),
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
