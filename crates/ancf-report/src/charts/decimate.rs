use std::ops::Range;

/// Returns the indices of about `most` rows that preserve the extremes of each column, in ascending order.
///
/// They include the first row, the last row, and the rows of the maximum and minimum of each column. The remaining rows are
/// taken from intervals of equal length: the first row of an interval and the three rows with the greatest weight. A row that is
/// an extreme of a column within the interval has as weight the ratio of the range in the interval to the total range. Weights
/// of several columns are added.
pub(crate) fn decimate(columns: &[&[f64]], rows: usize, most: usize) -> Vec<usize> {
    if rows <= most {
        return (0..rows).collect();
    }
    let total: Vec<Extremes> = columns.iter().map(|column| extremes(column, 0..rows)).collect();
    let mut kept = vec![0, rows - 1];
    kept.extend(total.iter().flat_map(|column| column.rows()));
    let intervals = (most / ROWS_PER_INTERVAL).max(1);
    for k in 0..intervals {
        let interval = rows * k / intervals..rows * (k + 1) / intervals;
        kept.push(interval.start);
        let mut weights: Vec<(usize, f64)> = Vec::new();
        for (column, total) in columns.iter().zip(&total) {
            let here = extremes(column, interval.clone());
            let share = here.range() / total.range();
            if share.is_finite() {
                weights.extend(here.rows().map(|row| (row, share)));
            }
        }
        kept.extend(heaviest(weights));
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// Rows that are kept of each interval.
const ROWS_PER_INTERVAL: usize = 4;

/// Rows with the greatest sums of weights.
fn heaviest(mut weights: Vec<(usize, f64)>) -> impl Iterator<Item = usize> {
    weights.sort_unstable_by_key(|(row, _)| *row);
    weights.dedup_by(|next, sum| {
        let same = next.0 == sum.0;
        if same {
            sum.1 += next.1;
        }
        same
    });
    weights.sort_by(|x, y| y.1.total_cmp(&x.1));
    weights.into_iter().take(ROWS_PER_INTERVAL - 1).map(|(row, _)| row)
}

/// Rows and values of the minimum and maximum of a column.
#[derive(Clone, Copy)]
struct Extremes {
    least: Option<(usize, f64)>,
    most: Option<(usize, f64)>,
}

impl Extremes {
    fn rows(self) -> impl Iterator<Item = usize> {
        [self.least, self.most].into_iter().flatten().map(|(row, _)| row)
    }

    fn range(self) -> f64 {
        match (self.least, self.most) {
            (Some((_, least)), Some((_, most))) => most - least,
            _ => f64::NAN,
        }
    }
}

fn extremes(column: &[f64], rows: Range<usize>) -> Extremes {
    let mut found = Extremes { least: None, most: None };
    for row in rows.start..rows.end.min(column.len()) {
        let x = column[row];
        if !x.is_finite() {
            continue;
        }
        if found.least.is_none_or(|(_, least)| x < least) {
            found.least = Some((row, x));
        }
        if found.most.is_none_or(|(_, most)| x > most) {
            found.most = Some((row, x));
        }
    }
    found
}
