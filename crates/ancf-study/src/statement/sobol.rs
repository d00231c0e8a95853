//! Scrambled Sobol sequence.
//!
//! Sobol (1967) in the Gray code order of Antonov & Saleev (1979), with the direction numbers of Joe & Kuo (2008). Nested uniform
//! scrambling by Owen (1998), in which hashes replace random bits: the points are the same on every machine.

use std::hash::Hasher;
use std::sync::LazyLock;

use siphasher::sip::SipHasher24;

/// Maximum number of dimensions.
pub const MAX_SOBOL_DIMENSION: usize = 481;

const BITS: u32 = 32;

/// Direction numbers of one dimension, as binary fractions.
type Directions = [u32; BITS as usize];

/// Direction numbers of all dimensions.
static DIRECTIONS: LazyLock<Vec<Directions>> = LazyLock::new(|| {
    let table = include_str!("direction_numbers.txt").lines().filter(|line| !line.starts_with('#'));
    // The first dimension is the van der Corput sequence.
    let first = std::array::from_fn(|k| 1 << (BITS as usize - 1 - k));
    std::iter::once(first).chain(table.map(directions)).collect()
});

/// Computes the direction numbers of a line of the table by the recurrence of Bratley & Fox (1988).
fn directions(line: &str) -> Directions {
    let numbers: Vec<u32> = line.split(' ').filter_map(|number| number.parse().ok()).collect();
    let (polynomial, initial) = (numbers[0], &numbers[1..]);
    let degree = initial.len();
    let mut directions = [0; BITS as usize];
    for k in 0..BITS as usize {
        directions[k] = if k < degree {
            initial[k] << (BITS as usize - 1 - k)
        } else {
            let last = directions[k - degree];
            let terms = (1..degree).filter(|i| polynomial >> (degree - i) & 1 == 1);
            terms.fold(last ^ (last >> degree), |sum, i| sum ^ directions[k - i])
        };
    }
    directions
}

/// Returns the coordinates of all points in one dimension, without scrambling, as binary fractions.
fn sequence(directions: &Directions) -> impl Iterator<Item = u32> {
    let next = |x: u32, k: u32| x ^ directions[k.trailing_ones() as usize];
    (0..u32::MAX).scan(0, move |x, k| Some(std::mem::replace(x, next(*x, k))))
}

/// Returns the first `count` points of the scrambled sequence by dimension, 0 < p < 1.
///
/// A larger number of points extends a smaller one. At most [`MAX_SOBOL_DIMENSION`] dimensions are returned.
pub fn sobol_points(dimension: usize, count: u32, seed: u32) -> Vec<Vec<f64>> {
    let coordinates = |(number, directions): (u32, &Directions)| {
        let scrambled = sequence(directions).take(count as usize).map(|x| scramble(x, number, seed));
        scrambled.map(|x| (f64::from(x) + 0.5) / f64::from(BITS).exp2()).collect()
    };
    (0..).zip(DIRECTIONS.iter()).take(dimension).map(coordinates).collect()
}

/// Flips each bit by a hash of the bits above it.
fn scramble(x: u32, dimension: u32, seed: u32) -> u32 {
    let flip = |bit: u32| {
        let mut hasher = SipHasher24::new_with_keys(u64::from(seed), 1);
        for number in [dimension, bit, x.checked_shr(BITS - bit).unwrap_or(0)] {
            hasher.write(&number.to_le_bytes());
        }
        ((hasher.finish() & 1) as u32) << (BITS - 1 - bit)
    };
    (0..BITS).fold(x, |sum, bit| sum ^ flip(bit))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of `scipy.stats.qmc.Sobol(481, scramble=False, bits=32)`, times 2^32.
    #[test]
    fn the_sequence_without_scrambling() {
        assert_eq!(DIRECTIONS.len(), MAX_SOBOL_DIMENSION);
        let dimensions = [0, 1, 2, 7, 100, 480];
        for (number, expected) in [
            (0, [0; 6]),
            (1, [0x8000_0000; 6]),
            (2, [0xc000_0000, 0x4000_0000, 0x4000_0000, 0xc000_0000, 0x4000_0000, 0x4000_0000]),
            (3, [0x4000_0000, 0xc000_0000, 0xc000_0000, 0x4000_0000, 0xc000_0000, 0xc000_0000]),
            (37, [0xec00_0000, 0xa400_0000, 0x9400_0000, 0xcc00_0000, 0x5c00_0000, 0xfc00_0000]),
            (1_000_000, [0x06c7_1000, 0x4fd9_f000, 0xd3f7_9000, 0x044c_9000, 0x0a17_7000, 0x5737_d000]),
        ] {
            let point = dimensions.map(|dimension: usize| sequence(&DIRECTIONS[dimension]).nth(number));
            assert_eq!(point, expected.map(Some), "{number}");
        }
    }

    /// Each of 2^m intervals of each dimension contains one of the first 2^m points.
    #[test]
    fn every_dimension_is_stratified() {
        for column in sobol_points(MAX_SOBOL_DIMENSION, 256, 3) {
            let mut intervals: Vec<u32> = column.iter().map(|p| (p * 256.0) as u32).collect();
            intervals.sort_unstable();
            assert_eq!(intervals, (0..256).collect::<Vec<_>>());
        }
    }

    /// Each of 2^m rectangles of the first two dimensions contains one of the first 2^m points, a (0, m, 2)-net.
    #[test]
    fn the_first_two_dimensions_form_a_net() {
        let [x, y]: [Vec<f64>; 2] = sobol_points(2, 64, 7).try_into().unwrap();
        for columns in [1, 2, 4, 8, 16, 32, 64] {
            let rows = 64 / columns;
            let mut boxes: Vec<u32> = (0..64)
                .map(|k: usize| (x[k] * f64::from(columns)) as u32 * rows + (y[k] * f64::from(rows)) as u32)
                .collect();
            boxes.sort_unstable();
            assert_eq!(boxes, (0..64).collect::<Vec<_>>(), "{columns} columns");
        }
    }

    /// Mean of Π (xᵢ + 1/2) over the unit cube of 8 dimensions, exactly 1. Independent samples have a standard error of 0.015.
    #[test]
    fn the_mean_of_a_product_converges_faster_than_with_random_samples() {
        let (count, dimension) = (4096, 8);
        for seed in 0..4 {
            let points = sobol_points(dimension, count, seed);
            let product = |k: usize| points.iter().map(|column| column[k] + 0.5).product::<f64>();
            let mean = (0..count as usize).map(product).sum::<f64>() / f64::from(count);
            assert!((mean - 1.0).abs() < 1e-3, "{mean}");
        }
    }

    /// A point is uniformly distributed over the seeds, and its coordinates are independent.
    #[test]
    fn scrambling_makes_each_point_random() {
        let seeds = 2000;
        for k in [0, 5] {
            let points = (0..seeds).map(|seed| sobol_points(2, 6, seed));
            let centred: Vec<[f64; 2]> = points.map(|p| [p[0][k] - 0.5, p[1][k] - 0.5]).collect();
            let mean = |f: fn(&[f64; 2]) -> f64| centred.iter().map(f).sum::<f64>() / f64::from(seeds);
            // Four standard deviations.
            let limit = 4.0 / f64::from(seeds).sqrt();
            assert!(mean(|x| x[0]).abs() < limit / 12.0_f64.sqrt());
            assert!(mean(|x| x[1]).abs() < limit / 12.0_f64.sqrt());
            assert!((mean(|x| x[0] * x[0]) - 1.0 / 12.0).abs() < limit / 180.0_f64.sqrt());
            assert!(mean(|x| x[0] * x[1]).abs() < limit / 12.0);
        }
    }

    #[test]
    fn more_points_extend_fewer_and_seeds_differ() {
        let few = sobol_points(3, 10, 1);
        let many = sobol_points(3, 100, 1);
        assert!(few.iter().zip(&many).all(|(few, many)| *few == many[..10]));
        assert!(few.iter().zip(sobol_points(3, 10, 2)).all(|(one, other)| *one != other));
        assert!(many.iter().flatten().all(|p| 0.0 < *p && *p < 1.0));
    }
}
