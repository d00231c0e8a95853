use serde::{Deserialize, Serialize};

use super::gap_field::GapField;
use super::value_errors::{ProbeError, ValueError, ValueErrors};
use crate::units::Scales;

/// Class of an estimate of the discretisation error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Resolution {
    /// The gaps add up to less than 0.3 rad: the estimate is accurate.
    Good,
    /// The estimate states the order of magnitude: the gaps add up to at most 1 rad, taut elements are neither rods nor strings,
    /// elements are strongly curved, contacts are active, or loads within elements are not known in detail.
    Rough,
    /// The elements do not resolve the shape.
    Unresolved,
    /// Joints act between the nodes of elements, the tension of a taut element vanishes at an end, or the response of the
    /// structure to the gaps is not known, such as near a critical load.
    Unknown,
}

impl Resolution {
    /// Class of a sum of gaps in rad.
    fn of(gaps: f64) -> Self {
        if gaps < GOOD {
            Self::Good
        } else if gaps <= ROUGH {
            Self::Rough
        } else {
            Self::Unresolved
        }
    }
}

const GOOD: f64 = 0.3;
const ROUGH: f64 = 1.0;

/// Estimated errors of the mesh in the last state of a static analysis, in the user's units.
///
/// The exact solution is that of Reissner's and Simo's rod with the stiffness EA, GA, GJ and EI of the sections. Not included
/// are the deformation of sections by loads beside the axis, warping, and strains and stresses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DiscretisationErrors {
    /// Class of the estimate.
    pub resolution: Resolution,
    /// Largest sum of the gaps of the elements of a body, or largest rotation of the response to the gaps, in rad.
    pub gaps: f64,
    /// Body with the largest sum of gaps, and its number of elements.
    pub body: String,
    /// Number of elements of this body.
    pub elements: usize,
    /// Bound of the relative difference between the rod and the strains of the elements.
    pub law: f64,
    /// Largest relative error of the displacement of a probe; `None` without probes that move.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub displacement: Option<ProbeError>,
    /// Errors of positions, rotations, section forces, reactions and joint coordinates; empty unless the class is good or
    /// rough.
    pub values: Vec<ValueError>,
}

impl DiscretisationErrors {
    /// Estimates the errors at an equilibrium; `None` without flexible bodies. `respond` solves K z = f there.
    pub(crate) fn new(
        field: &GapField<'_>,
        scales: Scales,
        respond: impl FnOnce(&[f64]) -> Option<Vec<f64>>,
    ) -> Option<Self> {
        let largest = field.bodies().max_by(|(_, a), (_, b)| a.sum().total_cmp(&b.sum()));
        let (number, body) = largest?;
        let law = field.bodies().map(|(_, body)| body.law()).fold(0.0, f64::max);
        let (name, _) = field.assembly.bodies().nth(number)?;
        let mut errors = Self {
            resolution: Resolution::of(body.sum()),
            gaps: body.sum(),
            body: name.to_owned(),
            elements: body.mesh.count(),
            law,
            displacement: None,
            values: Vec::new(),
        };
        if !errors.gaps.is_finite() || errors.resolution == Resolution::Unresolved {
            errors.resolution = Resolution::Unresolved;
            return Some(errors);
        }
        let response = if field.is_unknown() { None } else { respond(&field.forces()) };
        let Some(response) = response else {
            return Some(Self { resolution: Resolution::Unknown, ..errors });
        };
        let values = ValueErrors::new(field, &response, scales);
        errors.gaps = errors.gaps.max(values.rotation());
        errors.resolution = Resolution::of(errors.gaps);
        if errors.resolution == Resolution::Good && field.is_rough() {
            errors.resolution = Resolution::Rough;
        }
        if errors.resolution != Resolution::Unresolved {
            (errors.values, errors.displacement) = values.evaluate();
        }
        Some(errors)
    }
}
