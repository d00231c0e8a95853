/// Pseudo-random numbers in [−1, 1), the same in every run (SplitMix64; Steele, Lea & Flood 2014).
#[derive(Debug)]
pub(crate) struct PseudoRandom(pub(crate) u64);

impl PseudoRandom {
    /// Returns the next number.
    pub(crate) fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Returns a vector of numbers, which has components along all eigenvectors.
    pub(crate) fn vector(&mut self, size: usize) -> Vec<f64> {
        (0..size).map(|_| self.number()).collect()
    }

    /// Returns an index below a number of items.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        let share = 0.5 * (self.number() + 1.0);
        ((share * count as f64) as usize).min(count - 1)
    }
}
