use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use parquet::file::reader::FileReader;
use parquet::record::{Field, Row};
use toml::{Table, Value};

use crate::cases::CaseOutcome;
use crate::statement::TABLE_COLUMNS;
use crate::table::{StudyError, TableError, open_table, table_files};

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
    /// Reads the study in a folder; `None` if there is no table.
    ///
    /// The newest table is read: `cases.parquet` alone, `cases-K-of-N.parquet` with the other parts of the same number and
    /// the same text of the study. Tables of an earlier state of the study are omitted.
    ///
    /// # Errors
    /// If a table cannot be read.
    pub fn read(folder: &Path) -> Result<Option<Self>, StudyError> {
        let Some((first, others)) = newest(table_files(folder)?) else { return Ok(None) };
        let read = |path: PathBuf| rows_of(&path).map_err(|source| StudyError::Table { path, source });
        let (about, mut found) = read(first)?;
        for path in others {
            let (other, more) = read(path)?;
            if other.text == about.text {
                found.extend(more);
            }
        }
        let numbered = found.into_iter().filter_map(|row| match row.get("case") {
            Some(Field::Long(case)) => Some((*case, row)),
            _ => None,
        });
        let rows: BTreeMap<i64, BTreeMap<String, Field>> = numbered.collect();
        let (objectives, parameters): (Vec<String>, Vec<String>) =
            about.values.into_iter().partition(|name| about.objectives.contains(name));
        let columns =
            |names: Vec<String>| names.into_iter().map(|name| column(&rows, name)).collect::<Vec<_>>();
        let outcome = |row| CaseOutcome::from_word(&word(row, "outcome")).unwrap_or(CaseOutcome::Failed);
        Ok(Some(Self {
            cases: rows.keys().copied().collect(),
            parameters: columns(parameters),
            objectives: columns(objectives),
            outcomes: rows.values().map(outcome).collect(),
            messages: rows.values().map(|row| word(row, "message")).collect(),
            seconds: rows.values().map(|row| number(row.get("seconds"))).collect(),
            text: about.text,
        }))
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

/// Returns the newest of the tables, and the other parts of the same study if it is a part.
fn newest(mut files: Vec<PathBuf>) -> Option<(PathBuf, Vec<PathBuf>)> {
    let time = |path: &PathBuf| fs::metadata(path).and_then(|about| about.modified()).ok();
    let index = (0..files.len()).max_by_key(|&k| time(&files[k]))?;
    let first = files.swap_remove(index);
    let parts = |path: &Path| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        name.rsplit_once("-of-").map(|(_, count)| count.to_owned())
    };
    let count = parts(&first);
    files.retain(|path| count.is_some() && parts(path) == count);
    Some((first, files))
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
    let reader = open_table(path)?;
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

#[cfg(test)]
mod tests {
    use std::fs::File;
    use std::time::{Duration, SystemTime};

    use super::*;
    use crate::cases::CaseRow;
    use crate::statement::Objectives;
    use crate::table::StudyTable;

    /// Writes a table with one row at an age in seconds.
    fn write(folder: &Path, name: &str, text: &str, case: usize, age: u64) {
        let row = CaseRow {
            outcome: CaseOutcome::Finished,
            message: None,
            objectives: Vec::new(),
            steps: None,
            iterations: None,
            seconds: age as f64,
        };
        let path = folder.join(name);
        let objectives = Objectives::new();
        let table = StudyTable { axes: &[], objectives: &objectives, text };
        table.write(&path, &[(case, "key", &row)]).unwrap();
        let time = SystemTime::now() - Duration::from_secs(age);
        File::options().append(true).open(&path).unwrap().set_modified(time).unwrap();
    }

    fn ages(folder: &Path) -> Vec<(i64, f64)> {
        let record = StudyRecord::read(folder).unwrap().unwrap();
        record.cases.into_iter().zip(record.seconds).collect()
    }

    #[test]
    fn a_folder_without_table_has_no_study() {
        let folder = tempfile::TempDir::new().unwrap();
        assert!(StudyRecord::read(folder.path()).unwrap().is_none());
        assert!(StudyRecord::read(&folder.path().join("none")).unwrap().is_none());
    }

    #[test]
    fn tables_of_an_earlier_state_of_the_study_are_omitted() {
        let folder = tempfile::TempDir::new().unwrap();
        let folder = folder.path();
        write(folder, "cases-1-of-2.parquet", "old", 0, 50);
        write(folder, "cases-2-of-2.parquet", "old", 1, 40);
        assert_eq!(ages(folder), [(0, 50.0), (1, 40.0)]);
        write(folder, "cases.parquet", "new", 0, 30);
        assert_eq!(ages(folder), [(0, 30.0)]);
        write(folder, "cases-2-of-2.parquet", "new", 1, 20);
        assert_eq!(ages(folder), [(1, 20.0)]);
        write(folder, "cases-1-of-3.parquet", "new", 0, 10);
        assert_eq!(ages(folder), [(0, 10.0)]);
        write(folder, "cases-3-of-3.parquet", "new", 2, 5);
        assert_eq!(ages(folder), [(0, 10.0), (2, 5.0)]);
    }
}
