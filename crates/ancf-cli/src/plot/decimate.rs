//! Decimation of curves for a figure.

/// Returns the first, lowest, highest and last of successive points in each of `columns` pixel columns.
///
/// The appearance of the curve remains. Source: Jugel, Jerzak, Hackenbroich & Markl (2014), "M4: a visualization-oriented time
/// series data aggregation".
pub fn decimated(points: &[[f64; 2]], [lo, hi]: [f64; 2], columns: usize) -> Vec<[f64; 2]> {
    let width = (hi - lo) / columns.max(1) as f64;
    let column = |point: &[f64; 2]| if width > 0.0 { ((point[0] - lo) / width).floor() } else { 0.0 };
    let mut kept = Vec::new();
    for group in points.chunk_by(|a, b| column(a) == column(b)) {
        let by_height = |a: &&usize, b: &&usize| group[**a][1].total_cmp(&group[**b][1]);
        let places: Vec<usize> = (0..group.len()).collect();
        let ends =
            [places.first(), places.iter().min_by(by_height), places.iter().max_by(by_height), places.last()];
        let mut chosen: Vec<usize> = ends.into_iter().flatten().copied().collect();
        chosen.sort_unstable();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|place| group[place]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_are_kept() {
        let points: Vec<[f64; 2]> =
            (0..100_000).map(|k| [f64::from(k), if k == 54_321 { 9.0 } else { f64::from(k % 7) }]).collect();
        let kept = decimated(&points, [0.0, 99_999.0], 500);
        assert!(kept.len() <= 4 * 501, "{}", kept.len());
        assert!(kept.contains(&[54_321.0, 9.0]), "a single peak is visible");
        assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
        assert!(kept.windows(2).all(|pair| pair[0][0] < pair[1][0]), "in order");
        assert_eq!(decimated(&points[..5], [0.0, 4.0], 500), points[..5], "few stay as they are");
    }
}
