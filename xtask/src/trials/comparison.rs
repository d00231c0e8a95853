//! Comparison of results on two systems.

use std::fs;
use std::path::Path;

use super::first_steps::TEMPLATES;
use crate::system::shell::{Done, say};

/// Largest difference of a column, relative to its largest value. Systems differ in the last bits of elementary functions, and
/// Newton's method leaves 1e-9.
const TOLERANCE: f64 = 1e-7;
/// Columns of the solver: the last residual and the drift follow from the remaining errors of an iteration, and a step at the limit
/// of the stopping rule takes one iteration more or less.
const SOLVER: [&str; 3] = ["residual", "drift", "iterations"];
/// Analyses whose rows are shapes. Their sign, and the shapes of double eigenvalues, are arbitrary: only values are compared.
const SHAPES: [&str; 2] = ["modes", "buckling"];
/// Files with the same bytes on all systems.
const TEXTS: [&str; 5] =
    ["help.txt", "schema.json", "completions.bash", "completions.powershell", "Handbuch ü/ancf-run.1"];

/// Compares the tables of all templates by value and texts by bytes.
pub(super) fn compare(folder: &Path, reference: &Path) -> Done {
    let mut largest = 0.0_f64;
    for run in TEMPLATES.iter().chain(&["fein", "ganz"]) {
        let [own, other] = [folder, reference].map(|folder| table(&folder.join(run).join("probes.csv")));
        largest = largest.max(
            difference(&compared(own?, run), &compared(other?, run))
                .map_err(|why| format!("{run}: {why}"))?,
        );
    }
    say(&format!("largest difference of the tables, relative to the columns: {largest:.1e}"));
    for text in TEXTS {
        let [own, other] = [folder, reference].map(|folder| fs::read(folder.join(text)));
        if own.map_err(|error| error.to_string())? != other.map_err(|error| error.to_string())? {
            return Err(format!("{text} differs"));
        }
    }
    Ok(())
}

/// Columns that are compared.
fn compared(mut table: Table, run: &str) -> Table {
    let is_shape = |name: &str| SHAPES.contains(&run) && name.contains('.');
    table.retain(|(name, _)| !SOLVER.contains(&name.as_str()) && !is_shape(name));
    table
}

/// Columns with their names.
type Table = Vec<(String, Vec<f64>)>;

fn table(file: &Path) -> Result<Table, String> {
    let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let mut lines = text.lines();
    let header = lines.next().unwrap_or_default().split(',');
    let mut columns: Table = header.map(|name| (name.to_owned(), Vec::new())).collect();
    for line in lines {
        for ((_, column), cell) in columns.iter_mut().zip(line.split(',')) {
            // Empty cells are values that do not exist.
            column.push(if cell.is_empty() {
                f64::NAN
            } else {
                cell.parse().map_err(|_| format!("number {cell}"))?
            });
        }
    }
    Ok(columns)
}

/// Largest difference relative to the largest value of the column.
fn difference(own: &Table, other: &Table) -> Result<f64, String> {
    let names = |table: &Table| table.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    if names(own) != names(other) {
        return Err("other columns".to_owned());
    }
    let mut largest = 0.0_f64;
    for ((name, own), (_, other)) in own.iter().zip(other) {
        if own.len() != other.len() {
            return Err(format!("{} rows, expected {}", own.len(), other.len()));
        }
        let scale = other.iter().fold(f64::MIN_POSITIVE, |scale, value| scale.max(value.abs()));
        for (own, other) in own.iter().zip(other) {
            let difference = if own.is_nan() && other.is_nan() { 0.0 } else { (own - other).abs() / scale };
            // Columns of rounding errors, such as the residual of the balance, have no common digits.
            if !(difference <= TOLERANCE || scale < 1e-9) {
                return Err(format!("{name}: {own}, expected {other}"));
            }
            largest = largest.max(if scale < 1e-9 { 0.0 } else { difference });
        }
    }
    Ok(largest)
}

#[cfg(test)]
mod tests {
    use super::difference;

    #[test]
    fn differences_are_relative_to_the_largest_value() {
        let table = |values: &[f64]| vec![("x".to_owned(), values.to_vec())];
        let own = table(&[1e3, f64::NAN, 1e-6]);
        assert_eq!(difference(&own, &own).unwrap(), 0.0);
        assert!(difference(&table(&[1e3, f64::NAN, 2e-6]), &own).unwrap() < 2e-9);
        assert!(difference(&table(&[1e3 + 1e-3, f64::NAN, 1e-6]), &own).is_err());
        assert!(difference(&table(&[1e3, 0.0, 1e-6]), &own).is_err());
        assert!(difference(&table(&[1e3]), &own).is_err());
        assert!(difference(&vec![("y".to_owned(), vec![1e3])], &own).is_err());
    }
}
