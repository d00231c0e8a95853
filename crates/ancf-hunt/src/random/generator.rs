use ancf::nalgebra::{Rotation3, Vector3};

/// Generator of pseudo-random numbers.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Creates a generator.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Generator of case `number` of a hunt.
    pub const fn of_case(seed: u64, number: u64) -> Self {
        let mut start = Self(seed ^ number.wrapping_mul(0xd134_2543_de82_ef95));
        let first = start.bits();
        Self(first)
    }

    /// Returns 64 random bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a number in [low, high), rounded to four digits.
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        rounded(low + (high - low) * self.unit())
    }

    /// Returns a number in [low, high) with a uniform logarithm, rounded to four digits.
    pub fn spread(&mut self, low: f64, high: f64) -> f64 {
        rounded(low * (high / low).powf(self.unit()))
    }

    /// Returns an integer below `count`, or 0.
    pub fn index(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }

    /// True with a probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// Returns an element of a list that is not empty.
    pub fn choose<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.index(list.len())]
    }

    /// Returns a choice by weight from a list with a positive weight.
    pub fn weighted<T: Copy>(&mut self, list: &[(f64, T)]) -> T {
        let sum: f64 = list.iter().map(|(weight, _)| weight).sum();
        let mut left = sum * self.unit();
        for &(weight, choice) in list {
            left -= weight;
            if left < 0.0 {
                return choice;
            }
        }
        list[list.len() - 1].1
    }

    /// Returns a unit vector.
    pub fn direction(&mut self) -> Vector3<f64> {
        loop {
            let x = Vector3::from_fn(|_, _| 2.0 * self.unit() - 1.0);
            if (0.1..1.0).contains(&x.norm()) {
                return x.normalize();
            }
        }
    }

    /// Returns a rotation without special angles.
    pub fn rotation(&mut self) -> Rotation3<f64> {
        let axis = self.direction();
        Rotation3::new(axis * (0.3 + 2.5 * self.unit()))
    }

    /// Permutes a list.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.index(i + 1));
        }
    }
}

/// Rounds to four significant digits, which keeps reported models readable.
pub fn rounded(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}
