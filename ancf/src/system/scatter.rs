use super::Pattern;

/// Where the lower triangle of a small matrix over some unknowns goes in a matrix of a pattern.
#[derive(Clone, Debug)]
pub struct Scatter {
    slots: Vec<u32>,
}

impl Scatter {
    /// That of the given unknowns, multipliers counted after the coordinates.
    ///
    /// # Panics
    /// If the pattern was made without a block of them.
    pub fn new(pattern: &Pattern, unknowns: &[usize]) -> Self {
        let lower = |j: usize| unknowns[j..].iter().map(move |&i| pattern.slot(i, unknowns[j]));
        Self { slots: (0..unknowns.len()).flat_map(lower).collect() }
    }

    /// Adds entries to the values of a matrix: `entry(k)` is the k-th of the lower triangle by columns.
    pub fn add(&self, values: &mut [f64], entry: impl Fn(usize) -> f64) {
        for (k, &slot) in self.slots.iter().enumerate() {
            values[slot as usize] += entry(k);
        }
    }
}
