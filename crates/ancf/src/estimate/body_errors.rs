use serde::{Deserialize, Serialize};

use super::gap_field::{BodyGaps, GapField};

/// Expected relative error for which the number of elements is stated.
const WANTED: f64 = 0.01;
/// Share of the error below which a body does not contribute.
pub(super) const NEGLIGIBLE: f64 = 0.01;

/// Contribution of a flexible body to the largest relative error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyError {
    /// Name of the body.
    pub body: String,
    /// Number of elements.
    pub elements: usize,
    /// Sum of the sizes of the contributions of its elements, relative to the displacement, frequency or load factor with the largest
    /// relative error. Without a probe that moves, and for a mesh that does not resolve the shape, the sum of the gaps in rad.
    pub error: f64,
    /// Part of the sum over all bodies.
    pub share: f64,
    /// Number of elements of this body for an error of 1 % of the value; `None` if the error does not vanish on fine meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub elements_for_one_percent: Option<usize>,
}

impl BodyError {
    /// Creates the contributions from those of the elements of each body, relative to a value.
    pub(super) fn relative(field: &GapField<'_>, contributions: &[Vec<f64>]) -> Vec<Self> {
        let sum = |elements: &Vec<f64>| elements.iter().map(|x| x.abs()).sum();
        Self::of_sizes(field, &contributions.iter().map(sum).collect::<Vec<_>>(), true)
    }

    /// Creates the contributions from the sums of the gaps.
    pub(super) fn of_gaps(field: &GapField<'_>) -> Vec<Self> {
        let count = field.assembly.bodies().count();
        let sizes: Vec<f64> =
            (0..count).map(|number| field.body(number).map_or(0.0, BodyGaps::sum)).collect();
        Self::of_sizes(field, &sizes, false)
    }

    fn of_sizes(field: &GapField<'_>, sizes: &[f64], is_relative: bool) -> Vec<Self> {
        let total: f64 = sizes.iter().sum();
        let share = |size: f64| if total > 0.0 { size / total } else { 0.0 };
        let contributing = sizes.iter().filter(|size| share(**size) > NEGLIGIBLE).count();
        let names: Vec<&str> = field.assembly.bodies().map(|(name, _)| name).collect();
        let of_body = |(number, elements): (usize, usize)| {
            let (body, error) = (names[number].to_owned(), sizes[number]);
            let order = field.body(number).and_then(|body| body.order).filter(|_| is_relative);
            let found = Self { body, elements, error, share: share(error), elements_for_one_percent: None };
            let expected = order.map(|order| found.elements_for(WANTED, contributing, order));
            Self { elements_for_one_percent: expected, ..found }
        };
        field.bodies().map(|(number, body)| of_body((number, body.mesh.count()))).collect()
    }

    /// Number of elements of a single flexible body for a relative error of 1 %, at an order of convergence by their number.
    pub(super) fn elements_for_one_percent(&self, order: f64) -> usize {
        self.elements_for(WANTED, 1, order)
    }

    /// Number of elements, at least one, for a relative error to which a number of bodies contributes in equal parts, at an order of
    /// convergence.
    pub(super) fn elements_for(&self, expected: f64, contributing: usize, order: f64) -> usize {
        let excess = self.error * contributing.max(1) as f64 / expected;
        (excess.powf(1.0 / order) * self.elements as f64).ceil().max(1.0) as usize
    }
}
