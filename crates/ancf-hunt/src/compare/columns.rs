use ancf::units::Dimension;

use super::case::Case;
use super::finding::Finding;
use crate::run::{Record, Run, Verdict};

/// Columns of the solution procedure, which twins do not share.
const PROCEDURE: [&str; 12] = [
    "iterations",
    "residual",
    "increment",
    "drift",
    "violation",
    "length",
    "slope",
    "limit",
    "mode",
    "unstable",
    "frequency_error",
    "factor_error",
];

/// Factor between the deviation of a neighbour and the tolerance.
pub(super) const NEIGHBOUR: f64 = 1e4;

/// Finding if one of two runs is complete and the other one is not, or if one panicked.
pub fn unequal_verdicts(law: &'static str, base: &Run, other: &Run) -> Option<Finding> {
    let is_panic = matches!(other.verdict, Verdict::Panicked(_));
    let is_stopped = [base, other].iter().any(|run| run.verdict == Verdict::Stopped);
    if !is_panic && (is_stopped || base.verdict.word() == other.verdict.word()) {
        return None;
    }
    let part = |run: &Run| format!("{} {}", run.verdict.word(), run.verdict.reason());
    Some(Finding::of_kind(law, "verdict", format!("{} / {}", part(base), part(other))))
}

/// Finding if two runs differ in a bit.
pub fn identical(law: &'static str, base: &Run, other: &Run) -> Option<Finding> {
    for (a, b) in base.columns.iter().zip(&other.columns) {
        let is_same = |(x, y): (&f64, &f64)| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan());
        if a.values.len() != b.values.len() || !a.values.iter().zip(&b.values).all(is_same) {
            let row = a.values.iter().zip(&b.values).position(|pair| !is_same(pair)).unwrap_or(0);
            let value = |record: &Record| record.values.get(row).copied().unwrap_or(f64::NAN);
            let values = format!(
                "row {row}: {:e} / {:e}, {} / {} rows",
                value(a),
                value(b),
                a.values.len(),
                b.values.len()
            );
            return Some(Finding::of_kind(law, &a.name, values));
        }
    }
    None
}

/// Compares a twin, mapped back to the frame and units of the base, with the base. Returns the largest deviation above the
/// tolerance, to which `more` adds for a column and a row.
pub(super) fn compare_within(
    law: &'static str,
    case: &Case,
    twin: &Run,
    relative: f64,
    more: &dyn Fn(&Record, usize) -> f64,
) -> Option<Finding> {
    if let Some(finding) = unequal_verdicts(law, &case.base, twin) {
        return Some(finding);
    }
    if !case.base.verdict.is_finished() {
        return None;
    }
    let rows = case.shared_rows(twin)?;
    let mut worst: Option<Finding> = None;
    let is_determined =
        |name: &str| !case.base.is_redundant || !(is_reaction(name) || case.rubs_by_reaction());
    let is_compared = |name: &str| !PROCEDURE.contains(&name) && is_determined(name);
    for column in case.base.columns.iter().filter(|column| is_compared(&column.name)) {
        let (Some(dimension), Some(other)) = (dimension(column), twin.column(&column.name)) else { continue };
        let size = case.magnitudes.of(dimension);
        let neighbour = case.neighbour.column(&column.name);
        for row in rows.clone() {
            let (a, b) = (column.values[row], aligned(&case.base, twin, &other.name, row, other.values[row]));
            if a == b || (a.is_nan() && b.is_nan()) {
                continue;
            }
            let spread = case.spread(column, neighbour, row);
            let own = own_size(column, size, row) * case.tolerance(relative) + NEIGHBOUR * spread;
            let tolerance = own + more(column, row);
            let excess = (a - b).abs() / tolerance;
            if excess.is_nan() || excess > worst.as_ref().map_or(1.0, |worst| worst.excess) {
                let values = format!("row {row}: {a:e} / {b:e}, tolerance {tolerance:.1e} of {size:.1e}");
                worst = Some(Finding { law, quantity: column.name.clone(), values, excess });
            }
        }
    }
    worst
}

/// True for forces and moments of joints.
fn is_reaction(column: &str) -> bool {
    column.rsplit_once('.').is_some_and(|(_, suffix)| ["fx", "fy", "fz", "mx", "my", "mz"].contains(&suffix))
}

/// Dimension of a column whose values are compared.
fn dimension(column: &Record) -> Option<Dimension> {
    match column.name.as_str() {
        "factor" | "load" => Some(Dimension::NUMBER),
        _ => column.dimension,
    }
}

/// Magnitude of a value: its own for eigenvalues, which span decades.
fn own_size(column: &Record, size: f64, row: usize) -> f64 {
    match column.name.as_str() {
        "frequency" | "squared" => column.values[row].abs() + 1e-6 * size,
        "factor" => column.values[row].abs() + 1e-6,
        _ => size,
    }
}

/// Value with the sign of Euler parameters, which is arbitrary, chosen as in the base.
fn aligned(base: &Run, twin: &Run, name: &str, row: usize, value: f64) -> f64 {
    let Some((owner, suffix)) = name.rsplit_once('.') else { return value };
    if !["e0", "e1", "e2", "e3"].contains(&suffix) {
        return value;
    }
    let parameter = |run: &Run, k: usize| {
        run.column(&format!("{owner}.e{k}")).and_then(|column| column.values.get(row).copied()).unwrap_or(0.0)
    };
    let product: f64 = (0..4).map(|k| parameter(base, k) * parameter(twin, k)).sum();
    if product < 0.0 { -value } else { value }
}

/// Values of a column in the last row; NaN without rows.
pub fn last_of(run: &Run, name: &str) -> f64 {
    run.column(name).and_then(|column| column.values.last().copied()).unwrap_or(f64::NAN)
}
