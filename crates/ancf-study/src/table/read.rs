//! Reading of the tables of earlier runs.

use std::collections::HashMap;
use std::path::Path;

use parquet::file::reader::FileReader;
use parquet::record::Field;

use super::error::{StudyError, TableError};
use super::files::{open_table, table_files};
use crate::cases::{CaseOutcome, CaseRow};
use crate::statement::Objectives;

/// Reads the rows of all tables in a folder, by their keys.
///
/// Rows of stopped cases are omitted. If a key occurs more than once, a finished row takes precedence.
///
/// # Errors
/// If the folder or a table cannot be read.
pub fn read_rows(folder: &Path, objectives: &Objectives) -> Result<HashMap<String, CaseRow>, StudyError> {
    let mut rows = HashMap::new();
    for path in table_files(folder)? {
        read(&path, objectives, &mut rows).map_err(|source| StudyError::Table { path, source })?;
    }
    Ok(rows)
}

fn read(path: &Path, objectives: &Objectives, rows: &mut HashMap<String, CaseRow>) -> Result<(), TableError> {
    for row in open_table(path)?.get_row_iter(None)? {
        let fields = row?.into_columns();
        let fields: HashMap<&str, &Field> = fields.iter().map(|(name, field)| (&**name, field)).collect();
        let Some((key, row)) = from_fields(&fields, objectives) else { continue };
        let is_better = row.outcome == CaseOutcome::Finished || !rows.contains_key(&key);
        if row.outcome != CaseOutcome::Stopped && is_better {
            rows.insert(key, row);
        }
    }
    Ok(())
}

/// Returns the key and the row of a case. `None` for a row of another study.
fn from_fields(fields: &HashMap<&str, &Field>, objectives: &Objectives) -> Option<(String, CaseRow)> {
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
    let row = CaseRow {
        outcome: CaseOutcome::from_word(&text("outcome")?)?,
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
    use crate::table::StudyTable;

    fn row(outcome: CaseOutcome) -> CaseRow {
        CaseRow {
            outcome,
            message: None,
            objectives: Vec::new(),
            steps: None,
            iterations: None,
            seconds: 1.0,
        }
    }

    /// A changed byte does not change the results.
    #[test]
    fn damaged_tables_are_rejected() {
        let folder = tempfile::TempDir::new().unwrap();
        let path = folder.path().join("cases.parquet");
        let objectives = Objectives::new();
        let table = StudyTable { axes: &[], objectives: &objectives, text: "checksums of crc32:0" };
        table.write(&path, &[(0, "key", &row(CaseOutcome::Finished))]).unwrap();
        let whole = std::fs::read(&path).unwrap();
        let read = || read_rows(folder.path(), &objectives).map(|rows| format!("{rows:?}"));
        let right = read().unwrap();
        for at in (0..whole.len()).step_by(7) {
            let mut bytes = whole.clone();
            bytes[at] ^= 4;
            std::fs::write(&path, &bytes).unwrap();
            // A table with a damaged key of the checksums is one without them.
            assert!(read().is_err() || read().unwrap() == right, "byte {at}");
        }
    }

    /// Rows of one case in two files, in both orders.
    #[test]
    fn a_stopped_row_is_ignored_and_a_finished_one_takes_precedence() {
        let objectives = Objectives::new();
        let table = StudyTable { axes: &[], objectives: &objectives, text: "" };
        for (one, other, kept) in [
            (CaseOutcome::Stopped, CaseOutcome::Failed, Some(CaseOutcome::Failed)),
            (CaseOutcome::Stopped, CaseOutcome::Invalid, Some(CaseOutcome::Invalid)),
            (CaseOutcome::Failed, CaseOutcome::Finished, Some(CaseOutcome::Finished)),
            (CaseOutcome::Stopped, CaseOutcome::Stopped, None),
        ] {
            for endings in [[one, other], [other, one]] {
                let folder = tempfile::TempDir::new().unwrap();
                for (ending, name) in endings.into_iter().zip(["cases.parquet", "cases-1-of-2.parquet"]) {
                    table.write(&folder.path().join(name), &[(0, "key", &row(ending))]).unwrap();
                }
                let rows = read_rows(folder.path(), &objectives).unwrap();
                assert_eq!(rows.get("key").map(|row| row.outcome), kept, "{endings:?}");
            }
        }
    }
}
