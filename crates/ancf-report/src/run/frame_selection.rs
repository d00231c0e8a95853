/// Range of frames of a run, and their maximum number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameSelection {
    /// Minimum value of a frame.
    pub from: f64,
    /// Maximum value of a frame.
    pub to: f64,
    /// Maximum number of frames. They are evenly spaced and include the first and the last one.
    pub most: usize,
}

impl Default for FrameSelection {
    /// Selects all frames.
    fn default() -> Self {
        Self { from: f64::NEG_INFINITY, to: f64::INFINITY, most: usize::MAX }
    }
}

impl FrameSelection {
    /// Returns the indices of the selected frames in ascending order, given the values of all frames.
    pub fn pick(&self, values: &[f64]) -> Vec<usize> {
        let within: Vec<usize> =
            (0..values.len()).filter(|k| (self.from..=self.to).contains(&values[*k])).collect();
        evenly_spaced(within.len(), self.most).into_iter().map(|k| within[k]).collect()
    }
}

/// Returns at most `most` indices below `count`, evenly spaced, including the first and the last one.
pub(crate) fn evenly_spaced(count: usize, most: usize) -> Vec<usize> {
    if count <= most {
        return (0..count).collect();
    }
    let last = (most - 1).max(1);
    (0..=last).map(|k| (k * (count - 1) + last / 2) / last).collect()
}
