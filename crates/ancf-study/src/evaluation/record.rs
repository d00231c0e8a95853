use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};
use toml::{Table, Value};

use crate::cases::CaseOutcome;
use crate::statement::TABLE_COLUMNS;
use crate::table::{StudyError, TableError};

/// Table of a study as read from its folder.
#[derive(Clone, Debug, Default)]
pub struct StudyRecord {
    /// Text of the study file.
    pub text: String,
    /// Numbers of the cases, in ascending order.
    pub cases: Vec<i64>,
    /// Parameters by path.
    pub parameters: Vec<RecordedColumn>,
    /// Objectives by name.
    pub objectives: Vec<RecordedColumn>,
    /// Outcomes of the cases.
    pub outcomes: Vec<CaseOutcome>,
    /// Messages of the cases, empty without one.
    pub messages: Vec<String>,
    /// Wall-clock time of each case, s.
    pub seconds: Vec<f64>,
}

/// Column of a study: a parameter or an objective.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedColumn {
    /// Path of the parameter, or name of the objective.
    pub name: String,
    /// Values; NaN for a null and for a value that is not a number.
    pub numbers: Vec<f64>,
    /// Values as text.
    pub texts: Vec<String>,
    /// True if all values are integers.
    pub is_integer: bool,
}

impl RecordedColumn {
    /// True if the values are numbers, and not all equal.
    pub fn varies(&self) -> bool {
        self.numbers.iter().all(|x| x.is_finite()) && self.distinct().len() > 1
    }

    /// Sorted distinct numbers.
    pub fn distinct(&self) -> Vec<f64> {
        let mut numbers: Vec<f64> = self.numbers.iter().copied().filter(|x| x.is_finite()).collect();
        numbers.sort_by(f64::total_cmp);
        numbers.dedup();
        numbers
    }
}

impl StudyRecord {
    /// Files of the tables in the folder of a study; empty if the folder has no study.
    pub fn files(folder: &Path) -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
        let is_table = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            name.starts_with("cases") && name.ends_with(".parquet")
        };
        let mut files: Vec<PathBuf> = entries.filter(is_table).collect();
        files.sort();
        files
    }

    /// Reads the tables in the folder of a study. If a case occurs more than once, a finished row takes precedence.
    ///
    /// # Errors
    /// If there is no table, or a table cannot be read.
    pub fn read(folder: &Path) -> Result<Self, StudyError> {
        let mut rows: BTreeMap<i64, BTreeMap<String, Field>> = BTreeMap::new();
        let mut about = About::default();
        for path in Self::files(folder) {
            let (own, read) = rows_of(&path).map_err(|source| StudyError::Table { path, source })?;
            about = own;
            for row in read {
                let Some(Field::Long(case)) = row.get("case") else { continue };
                let is_finished = word(&row, "outcome") == CaseOutcome::Finished.word();
                if is_finished || !rows.contains_key(case) {
                    rows.insert(*case, row);
                }
            }
        }
        let (objectives, parameters): (Vec<String>, Vec<String>) =
            about.values.into_iter().partition(|name| about.objectives.contains(name));
        let columns =
            |names: Vec<String>| names.into_iter().map(|name| column(&rows, name)).collect::<Vec<_>>();
        let outcome = |row| CaseOutcome::from_word(&word(row, "outcome")).unwrap_or(CaseOutcome::Failed);
        Ok(Self {
            cases: rows.keys().copied().collect(),
            parameters: columns(parameters),
            objectives: columns(objectives),
            outcomes: rows.values().map(outcome).collect(),
            messages: rows.values().map(|row| word(row, "message")).collect(),
            seconds: rows.values().map(|row| number(row.get("seconds"))).collect(),
            text: about.text,
        })
    }

    /// Number of cases with an outcome.
    pub fn count(&self, outcome: CaseOutcome) -> usize {
        self.outcomes.iter().filter(|one| **one == outcome).count()
    }

    /// Record of the finished cases.
    #[must_use]
    pub fn finished(&self) -> Self {
        let kept: Vec<usize> =
            (0..self.cases.len()).filter(|&k| self.outcomes[k] == CaseOutcome::Finished).collect();
        let column = |column: &RecordedColumn| RecordedColumn {
            name: column.name.clone(),
            numbers: kept.iter().map(|&k| column.numbers[k]).collect(),
            texts: kept.iter().map(|&k| column.texts[k].clone()).collect(),
            is_integer: column.is_integer,
        };
        Self {
            text: self.text.clone(),
            cases: kept.iter().map(|&k| self.cases[k]).collect(),
            parameters: self.parameters.iter().map(column).collect(),
            objectives: self.objectives.iter().map(column).collect(),
            outcomes: vec![CaseOutcome::Finished; kept.len()],
            messages: kept.iter().map(|&k| self.messages[k].clone()).collect(),
            seconds: kept.iter().map(|&k| self.seconds[k]).collect(),
        }
    }

    /// Numeric parameters that vary.
    pub fn varying(&self) -> Vec<&RecordedColumn> {
        self.parameters.iter().filter(|column| column.varies()).collect()
    }
}

/// Metadata and columns of a table.
#[derive(Debug, Default)]
struct About {
    /// Text of the study file; empty for a study of the Python package.
    text: String,
    /// Columns of parameters and objectives.
    values: Vec<String>,
    /// Names of the objectives.
    objectives: Vec<String>,
}

/// Reads the metadata and the rows of a table.
fn rows_of(path: &Path) -> Result<(About, Vec<BTreeMap<String, Field>>), TableError> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let file = reader.metadata().file_metadata();
    let entries = || file.key_value_metadata().into_iter().flatten();
    let entry = |key: &str| entries().find(|entry| entry.key == key).and_then(|entry| entry.value.clone());
    let text = entry("study").unwrap_or_default();
    let listed = entry("objectives").and_then(|names| serde_json::from_str(&names).ok());
    let columns = file.schema_descr().columns().iter().map(|column| column.name().to_owned());
    let about = About {
        values: columns.filter(|name| !TABLE_COLUMNS.contains(&name.as_str())).collect(),
        objectives: listed.unwrap_or_else(|| objectives_of(&text)),
        text,
    };
    let fields = |row: Row| row.into_columns().into_iter().collect();
    let rows = reader.get_row_iter(None)?.map(|row| Ok(fields(row?)));
    let rows = rows.collect::<Result<_, TableError>>()?;
    Ok((about, rows))
}

/// Names of the objectives in the text of a study file.
fn objectives_of(text: &str) -> Vec<String> {
    match text.parse::<Table>().unwrap_or_default().remove("objectives") {
        Some(Value::Table(objectives)) => objectives.keys().cloned().collect(),
        _ => Vec::new(),
    }
}

fn column(rows: &BTreeMap<i64, BTreeMap<String, Field>>, name: String) -> RecordedColumn {
    let fields: Vec<Option<&Field>> = rows.values().map(|row| row.get(&name)).collect();
    let text = |field: &Option<&Field>| match field {
        None | Some(Field::Null) => String::new(),
        Some(Field::Str(text)) => text.clone(),
        Some(field) => field.to_string(),
    };
    RecordedColumn {
        numbers: fields.iter().map(|field| number(*field)).collect(),
        texts: fields.iter().map(text).collect(),
        is_integer: fields.iter().all(|field| matches!(field, Some(Field::Long(_)))),
        name,
    }
}

fn number(field: Option<&Field>) -> f64 {
    match field {
        Some(Field::Double(x)) => *x,
        Some(Field::Long(n)) => *n as f64,
        _ => f64::NAN,
    }
}

fn word(row: &BTreeMap<String, Field>, name: &str) -> String {
    match row.get(name) {
        Some(Field::Str(text)) => text.clone(),
        _ => String::new(),
    }
}
