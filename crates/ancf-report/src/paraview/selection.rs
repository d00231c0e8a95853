use crate::instants::evenly;

/// Which frames of a run are wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Selection {
    /// Those whose values are at least this.
    pub from: f64,
    /// Those whose values are at most this.
    pub to: f64,
    /// At most so many, evenly spaced, the first and the last among them.
    pub most: usize,
}

impl Default for Selection {
    /// All of them.
    fn default() -> Self {
        Self { from: f64::NEG_INFINITY, to: f64::INFINITY, most: usize::MAX }
    }
}

impl Selection {
    /// Numbers of the frames that are wanted, in order, by the values of all.
    pub fn pick(&self, values: &[f64]) -> Vec<usize> {
        let within: Vec<usize> =
            (0..values.len()).filter(|k| (self.from..=self.to).contains(&values[*k])).collect();
        evenly(within.len(), self.most).into_iter().map(|k| within[k]).collect()
    }
}
