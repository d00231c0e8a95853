use std::collections::BTreeMap;

/// Sparse row or column: entries by index.
pub type SparseVector = BTreeMap<usize, f64>;

/// Entries of a sparse row by column, in ascending order of the columns.
pub type SparseRow = Vec<(usize, f64)>;

/// Sums entries by column.
pub fn sparse_row(mut entries: Vec<(usize, f64)>) -> SparseRow {
    // A stable sort keeps the order of the summands.
    entries.sort_by_key(|(j, _)| *j);
    entries.dedup_by(|(j, x), (before, sum)| {
        let is_same = j == before;
        if is_same {
            *sum += *x;
        }
        is_same
    });
    entries
}

/// Place of a column in a row.
pub(super) fn position(row: &SparseRow, column: usize) -> Option<usize> {
    row.binary_search_by_key(&column, |(j, _)| *j).ok()
}

/// Largest absolute value of the entries.
pub(super) fn largest(row: &[(usize, f64)]) -> f64 {
    row.iter().fold(0.0, |max: f64, (_, x)| max.max(x.abs()))
}

/// Writes row − factor · other into `difference`. `keep` is called for each entry of `other` with its column, whether the
/// row has it, and the difference; it returns whether the entry remains.
pub(super) fn subtract(
    row: impl Iterator<Item = (usize, f64)>,
    factor: f64,
    other: &SparseRow,
    difference: &mut SparseRow,
    mut keep: impl FnMut(usize, bool, f64) -> bool,
) {
    difference.clear();
    let mut own = row.peekable();
    for &(j, x) in other {
        while let Some(before) = own.next_if(|(k, _)| *k < j) {
            difference.push(before);
        }
        let same = own.next_if(|(k, _)| *k == j);
        let value = same.map_or(0.0, |(_, x)| x) - factor * x;
        if keep(j, same.is_some(), value) {
            difference.push((j, value));
        }
    }
    difference.extend(own);
}
