//! Columns and rows that several tables share.

use super::table::{CellValue, NumberFormat, PaperColumn};
use crate::results::FormValues;

/// Column of the number of elements.
pub(super) const ELEMENTS: PaperColumn = PaperColumn::new("n", "", NumberFormat::Fixed(0));

/// Creates a row from values that convert into cells.
macro_rules! row {
    ($($cell:expr),* $(,)?) => { vec![$(CellValue::from($cell)),*] };
}

pub(super) use row;

/// Columns of a quantity: computed, printed, difference.
pub(super) fn compared(group: &'static str, unit: &'static str, decimals: [usize; 2]) -> [PaperColumn; 3] {
    let [ours, printed] = decimals.map(NumberFormat::Fixed);
    let difference = NumberFormat::Signed(decimals[0]);
    [("ancf", ours), ("paper", printed), ("difference", difference)]
        .map(|(name, format)| PaperColumn::new(name, unit, format).under(group))
}

/// Cells of [`compared`].
pub(super) fn compare(ours: f64, paper: f64) -> [CellValue; 3] {
    [ours, paper, ours - paper].map(CellValue::from)
}

/// Columns of an analysis time: computed, printed, ratio.
pub(super) fn timed(group: &'static str) -> [PaperColumn; 3] {
    [
        ("ancf", "s", NumberFormat::Significant(3)),
        ("paper", "s", NumberFormat::Fixed(2)),
        ("paper / ancf", "", NumberFormat::Significant(2)),
    ]
    .map(|(name, unit, format)| PaperColumn::new(name, unit, format).under(group))
}

/// Cells of [`timed`].
pub(super) fn time(ours: f64, paper: f64) -> [CellValue; 3] {
    [ours, paper, paper / ours].map(CellValue::from)
}

/// Returns the rows of a quantity that the paper prints for both forms.
pub(super) fn rows(forms: &FormValues, cells: impl Fn(f64, f64) -> [CellValue; 3]) -> Vec<Vec<CellValue>> {
    let printed = |column: &Option<Vec<f64>>, i: usize| {
        column.as_ref().and_then(|column| column.get(i)).copied().unwrap_or(f64::NAN)
    };
    let row = |(i, &n): (usize, &u32)| {
        let dim = cells(forms.dim[i], printed(&forms.paper_dim, i));
        let nondim = cells(forms.nondim[i], printed(&forms.paper_nondim, i));
        [row![n], dim.to_vec(), nondim.to_vec()].concat()
    };
    forms.n.iter().enumerate().map(row).collect()
}
