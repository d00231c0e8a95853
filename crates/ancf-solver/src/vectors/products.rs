use super::chunks::sum_of_chunks;

/// Returns √(x·x).
pub(crate) fn norm(x: &[f64]) -> f64 {
    dot(x, x).sqrt()
}

/// Returns x·y of vectors of equal length.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    debug_assert_eq!(x.len(), y.len(), "vectors of equal length");
    sum_of_chunks(x.len(), |range| dot_of_chunk(&x[range.clone()], &y[range]))
}

/// Computes x·y in eight sums, to avoid a dependence between additions.
fn dot_of_chunk(x: &[f64], y: &[f64]) -> f64 {
    let ((x, of_x), (y, of_y)) = (x.as_chunks::<8>(), y.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (x, y) in x.iter().zip(y) {
        (0..8).for_each(|i| sums[i] += x[i] * y[i]);
    }
    let rest: f64 = of_x.iter().zip(of_y).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}
