//! Combination of the values of parameters, and numbering of the cases.

use schemars::JsonSchema;
use serde::Deserialize;

/// Combination of the values of lists and ranges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Combine {
    /// Every value with every value of the others.
    #[default]
    Grid,
    /// The first value with the first of the others, the second with the second.
    Zip,
}

/// Numbering of the cases: index of the value of each parameter in each case.
///
/// Every combination of lists is run with every sample of the distributions. Cases are numbered from 0. Samples vary fastest, then
/// the last list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseLayout {
    /// Stride of each parameter: case k has the value at (k / stride) mod length.
    pub strides: Vec<usize>,
    /// Number of cases.
    pub cases: usize,
}

impl CaseLayout {
    /// Creates the numbering for the lengths of lists, `None` for distributions, and a number of samples.
    ///
    /// Zipped lists have equal lengths. Returns `None` if the number of cases cannot be represented.
    pub fn new(lengths: &[Option<usize>], samples: usize, combine: Combine) -> Option<Self> {
        let mut cases = samples;
        let mut strides = vec![1; lengths.len()];
        for (stride, length) in strides.iter_mut().zip(lengths).rev() {
            if let Some(length) = length {
                *stride = if combine == Combine::Grid { cases } else { samples };
                cases = stride.checked_mul(*length)?;
            }
        }
        Some(Self { strides, cases })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_of_lists_and_samples() {
        let grid = CaseLayout::new(&[Some(2), None, Some(3)], 5, Combine::Grid);
        assert_eq!(grid, Some(CaseLayout { strides: vec![15, 1, 5], cases: 30 }));
        let zip = CaseLayout::new(&[Some(3), None, Some(3)], 5, Combine::Zip);
        assert_eq!(zip, Some(CaseLayout { strides: vec![5, 1, 5], cases: 15 }));
        assert_eq!(CaseLayout::new(&[Some(usize::MAX), Some(2)], 1, Combine::Grid), None);
    }
}
