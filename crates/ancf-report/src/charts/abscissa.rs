use ancf::model::Analysis;
use ancf::units::Dimension;

use crate::run::Recording;

/// Common abscissa of all charts.
#[derive(Clone, Debug, PartialEq)]
pub struct Abscissa {
    /// Name of the column: time, load factor, arc length of the path, or number of the mode or row.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// Values in ascending order.
    pub values: Vec<f64>,
}

impl Abscissa {
    /// Abscissa of a run: its first column, or the arc length of a path, whose load factor may decrease.
    ///
    /// A column that does not ascend is replaced by the numbers of the rows.
    pub(super) fn of(recording: &Recording<'_>) -> Self {
        let first = recording.series.columns().next();
        let length = recording.series.column("length").map(|values| ("length", values));
        let is_path = matches!(recording.model.analysis, Analysis::Path(_));
        let found = if is_path { length.or(first) } else { first };
        let rows = first.map_or(0, |(_, values)| values.len());
        match found {
            Some((name, values)) if values.is_sorted() && values.iter().all(|x| x.is_finite()) => {
                let unit = if name == "t" { recording.unit(Dimension::TIME) } else { String::new() };
                Self { name: name.to_owned(), unit, values: values.to_vec() }
            }
            _ => Self {
                name: "row".to_owned(),
                unit: String::new(),
                values: (0..rows).map(|row| row as f64).collect(),
            },
        }
    }
}

/// Returns the positions of frames on the abscissa, given their values in the first column; `None` if a frame has no row.
pub(crate) fn positions_on_abscissa(recording: &Recording<'_>, values: &[f64]) -> Option<Vec<f64>> {
    let (_, first) = recording.series.columns().next()?;
    let abscissa = Abscissa::of(recording).values;
    let mut row = 0;
    let position = |value: &f64| {
        row += first.get(row..)?.iter().position(|x| x == value)?;
        abscissa.get(row).copied()
    };
    values.iter().map(position).collect()
}
