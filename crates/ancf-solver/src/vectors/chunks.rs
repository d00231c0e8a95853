use std::array;
use std::mem;
use std::ops::Range;

/// Largest number of entries in a chunk: 256 kB of each vector. A thread takes 5 µs to wake and 20 µs for a chunk.
const CHUNK: usize = 1 << 15;

/// Calls `work(range, chunk)` for the chunks of a vector, each with its range of entries.
pub(crate) fn for_each_chunk(x: &mut [f64], work: impl Fn(Range<usize>, &mut [f64]) + Sync) {
    for_each_chunk_of([x], |range, [x]| work(range, x));
}

/// Calls `work(range, chunks)` for the chunks of vectors of equal length.
pub(crate) fn for_each_chunk_of<const N: usize>(
    vectors: [&mut [f64]; N],
    work: impl Fn(Range<usize>, [&mut [f64]; N]) + Sync,
) {
    let length = vectors[0].len();
    debug_assert!(vectors.iter().all(|x| x.len() == length), "vectors of equal length");
    split(vectors, 0..length, &work);
}

fn split<const N: usize>(
    mut vectors: [&mut [f64]; N],
    range: Range<usize>,
    work: &(impl Fn(Range<usize>, [&mut [f64]; N]) + Sync),
) {
    if range.len() <= CHUNK || rayon::current_num_threads() == 1 {
        return work(range, vectors);
    }
    let half = range.len() / 2;
    let mut high = array::from_fn(|_| Default::default());
    let low = array::from_fn(|i| {
        let (low, rest) = mem::take(&mut vectors[i]).split_at_mut(half);
        high[i] = rest;
        low
    });
    let middle = range.start + half;
    rayon::join(|| split(low, range.start..middle, work), || split(high, middle..range.end, work));
}

/// Copies a vector of the same length.
pub(crate) fn copy(from: &[f64], to: &mut [f64]) {
    for_each_chunk(to, |range, to| to.copy_from_slice(&from[range]));
}

/// Sums `part` over the chunks of `length` entries. The order of the sums does not depend on the number of threads.
pub(crate) fn sum_of_chunks(length: usize, part: impl Fn(Range<usize>) -> f64 + Sync) -> f64 {
    fold(0..length, &part, &|a, b| a + b)
}

/// Returns the largest value of `part` for the chunks of `length` entries.
pub(crate) fn largest_of_chunks(length: usize, part: impl Fn(Range<usize>) -> f64 + Sync) -> f64 {
    fold(0..length, &part, &f64::max)
}

fn fold(
    range: Range<usize>,
    part: &(impl Fn(Range<usize>) -> f64 + Sync),
    plus: &(impl Fn(f64, f64) -> f64 + Sync),
) -> f64 {
    if range.len() <= CHUNK {
        return part(range);
    }
    let middle = range.start + range.len() / 2;
    let [low, high] = [range.start..middle, middle..range.end].map(|half| || fold(half, part, plus));
    let (low, high) =
        if rayon::current_num_threads() == 1 { (low(), high()) } else { rayon::join(low, high) };
    plus(low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Chunks cover a vector once and in their places, and sums do not depend on the number of threads.
    #[test]
    fn chunks_cover_a_vector() {
        let length = 5 * CHUNK + 7;
        let of = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let (mut x, mut y) = (vec![0.0; length], vec![1.0; length]);
                for_each_chunk_of([&mut x, &mut y], |range, [x, y]| {
                    for (i, (x, y)) in range.zip(x.iter_mut().zip(y)) {
                        *x += 1.0 / (1.0 + i as f64);
                        *y -= *x;
                    }
                });
                let sum = sum_of_chunks(length, |range| x[range].iter().sum());
                let largest = largest_of_chunks(length, |range| y[range].iter().copied().fold(0.0, f64::max));
                let mut copied = vec![0.0; length];
                copy(&x, &mut copied);
                assert_eq!(copied, x);
                (x, y, sum, largest)
            })
        };
        let one = of(1);
        assert!(one.0.iter().enumerate().all(|(i, x)| *x == 1.0 / (1.0 + i as f64)));
        assert_eq!(one.3, 1.0 - 1.0 / length as f64);
        // The harmonic number.
        let harmonic = (length as f64).ln() + 0.577_215_664_901_532_9 + 0.5 / length as f64;
        assert!((one.2 - harmonic).abs() < 1e-10);
        assert_eq!(one, of(2));
        assert_eq!(one, of(3));
    }
}
