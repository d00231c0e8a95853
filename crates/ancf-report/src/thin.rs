use std::ops::Range;

/// Numbers of the rows that stand for all, in order: at most about `most`.
///
/// The first, the last, and the rows of each column's largest and smallest values are among them. Rows are thinned in stretches of
/// equal length; each stretch keeps its first row and three more, those that are extremes of most columns there, by
/// the range of the column in the stretch over that in all.
pub(crate) fn thinned(columns: &[&[f64]], rows: usize, most: usize) -> Vec<usize> {
    if rows <= most {
        return (0..rows).collect();
    }
    let whole: Vec<Extremes> = columns.iter().map(|column| extremes(column, 0..rows)).collect();
    let mut kept = vec![0, rows - 1];
    kept.extend(whole.iter().flat_map(|column| column.rows()));
    let stretches = (most / EACH).max(1);
    for k in 0..stretches {
        let stretch = rows * k / stretches..rows * (k + 1) / stretches;
        kept.push(stretch.start);
        let mut worth: Vec<(usize, f64)> = Vec::new();
        for (column, whole) in columns.iter().zip(&whole) {
            let here = extremes(column, stretch.clone());
            let share = here.range() / whole.range();
            if share.is_finite() {
                worth.extend(here.rows().map(|row| (row, share)));
            }
        }
        kept.extend(best(worth));
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// Rows of each stretch.
const EACH: usize = 4;

/// The rows that are worth most.
fn best(mut worth: Vec<(usize, f64)>) -> impl Iterator<Item = usize> {
    worth.sort_unstable_by_key(|(row, _)| *row);
    worth.dedup_by(|next, sum| {
        let same = next.0 == sum.0;
        if same {
            sum.1 += next.1;
        }
        same
    });
    worth.sort_by(|x, y| y.1.total_cmp(&x.1));
    worth.into_iter().take(EACH - 1).map(|(row, _)| row)
}

/// The smallest and the largest of some numbers, and their rows.
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
