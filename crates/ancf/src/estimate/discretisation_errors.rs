use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::body_errors::BodyError;
use super::finer::FinerMesh;
use super::gap_field::GapField;
use super::value_errors::{ProbeError, ValueError, ValueErrors};
use crate::assembly::RecordedQuantity;
use crate::model::Quantity;
use crate::units::Scales;

/// Class of an estimate of the discretisation error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Resolution {
    /// The gaps add up to less than 0.3 rad: the estimate is accurate.
    Good,
    /// The estimate states the order of magnitude: the gaps add up to at most 1 rad, taut elements are neither rods nor strings,
    /// elements are strongly curved, contacts are active, or loads within elements are not known in detail. With shells, loads or joints
    /// act at points.
    Rough,
    /// The elements do not resolve the shape.
    Unresolved,
    /// Joints, point moments or moments that vary act between the nodes of elements, the tension of a taut element vanishes at an end, or the response of the
    /// structure to the gaps is not known, such as near a critical load. With shells, the second solution failed.
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

/// Estimated errors of the mesh in the last state of a static analysis, or in modes or buckling, in the user's units.
///
/// The exact solution is that of Reissner's and Simo's rod with the stiffness EA, GA, GJ and EI of the sections. Not included
/// are the deformation of sections by loads beside the axis, warping, and strains and stresses.
///
/// For models with shells the errors follow on request from a second solution, with twice the elements in each direction. It has four times
/// the elements of a shell. The run takes six to eight times as long. Its values also contain the section forces and stresses of
/// shells. The exact solution is then that of the theory of the elements on the smooth surface through the nodes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DiscretisationErrors {
    /// Class of the estimate.
    pub resolution: Resolution,
    /// Largest sum of the gaps of the elements of a body, or largest rotation of the response to the gaps, in rad; 0 with shells.
    pub gaps: f64,
    /// Body with the largest sum of gaps, with shells that with most elements, and its number of elements.
    pub body: String,
    /// Number of elements of this body.
    pub elements: usize,
    /// Bound of the relative difference between the rod and the strains of the elements; 0 with shells.
    pub law: f64,
    /// Largest relative error of the displacement of a probe; `None` without probes that move.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub displacement: Option<ProbeError>,
    /// Modes and buckling: the largest relative error of a frequency or load factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub eigenvalue: Option<EigenvalueError>,
    /// Contributions of the flexible bodies. Models with shells and several bodies have none.
    #[serde(default)]
    pub bodies: Vec<BodyError>,
    /// Errors of positions, rotations, section forces, reactions and joint coordinates, or of frequencies and load factors
    /// (`frequency[1]`, ...); empty unless the class is good or rough.
    pub values: Vec<ValueError>,
    /// Models with shells: second solution from which the errors follow.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub finer: Option<FinerMesh>,
}

impl DiscretisationErrors {
    /// Estimates the errors at an equilibrium; `None` without flexible bodies. `respond` solves K z = f there.
    pub(crate) fn new(
        field: &GapField<'_>,
        scales: Scales,
        mut respond: impl FnMut(&[f64]) -> Option<Vec<f64>>,
    ) -> Option<Self> {
        let mut errors = Self::of_gaps(field)?;
        if !errors.gaps.is_finite() || errors.resolution == Resolution::Unresolved {
            errors.resolution = Resolution::Unresolved;
            return Some(errors);
        }
        let forces = field.forces();
        let response = if field.is_unknown() { None } else { respond(&forces.total) };
        let Some(response) = response else {
            return Some(Self { resolution: Resolution::Unknown, ..errors });
        };
        let mut values = ValueErrors::new(field, &response, scales);
        errors.gaps = errors.gaps.max(values.rotation());
        errors.resolution = Resolution::of(errors.gaps);
        if errors.resolution == Resolution::Good && field.is_rough() {
            errors.resolution = Resolution::Rough;
        }
        if errors.resolution != Resolution::Unresolved {
            (errors.values, errors.displacement) = values.evaluate();
            if let Some(weights) = errors.weights(field).and_then(|force| respond(&force)) {
                errors.bodies = BodyError::relative(field, &forces.works(&weights));
            }
        }
        Some(errors)
    }

    /// Largest relative error of the displacement of a probe, of a frequency or of a load factor.
    pub fn largest(&self) -> Option<f64> {
        let eigenvalue = self.eigenvalue.as_ref().map(|error| error.relative.abs());
        self.displacement.as_ref().map(|error| error.relative).or(eigenvalue)
    }

    /// Derivative of the largest relative error of a displacement by the coordinates, as forces.
    fn weights(&self, field: &GapField<'_>) -> Option<Vec<f64>> {
        let name = &self.displacement.as_ref()?.probe;
        let is_probe = |probe: &&RecordedQuantity| probe.quantity == Quantity::Motion && probe.name == *name;
        let probe = field.assembly.recorded_quantities.iter().find(is_probe)?;
        let error = |axis: &str| {
            let column = format!("{name}.{axis}");
            self.values.iter().find(|value| value.column == column).map(|value| value.error)
        };
        let direction = Vector3::new(error("x")?, error("y")?, error("z")?);
        let size = direction.norm() * probe.place.point.displacement(field.state).norm();
        if size <= 0.0 {
            return None;
        }
        let mut forces = vec![0.0; field.state.q.len() + field.state.lambda.len()];
        probe.place.point.add(&field.state.q, direction / size, &mut forces);
        Some(forces)
    }

    /// Sum of the gaps; `None` without flexible bodies.
    fn of_gaps(field: &GapField<'_>) -> Option<Self> {
        let largest = field.bodies().max_by(|(_, a), (_, b)| a.sum().total_cmp(&b.sum()));
        let (number, body) = largest?;
        let (name, _) = field.assembly.bodies().nth(number)?;
        Some(Self {
            resolution: Resolution::of(body.sum()),
            gaps: body.sum(),
            body: name.to_owned(),
            elements: body.mesh.count(),
            law: field.law(),
            displacement: None,
            eigenvalue: None,
            bodies: BodyError::of_gaps(field),
            values: Vec::new(),
            finer: None,
        })
    }

    /// Errors of eigenvalues about a state, whose column has the name `column`: values and relative errors, NaN if unknown.
    /// `works` has the parts of the elements in the relative error of the one with a number.
    pub(crate) fn of_eigenvalues(
        field: &GapField<'_>,
        column: &str,
        found: &[[f64; 2]],
        works: impl FnOnce(usize) -> Option<Vec<Vec<f64>>>,
    ) -> Option<Self> {
        let mut errors = Self::of_gaps(field)?;
        let known = || found.iter().enumerate().filter(|(_, [_, relative])| relative.is_finite());
        let value = |(k, &[value, relative]): (usize, &[f64; 2])| ValueError {
            column: format!("{column}[{}]", k + 1),
            value,
            error: value * relative,
        };
        errors.values = known().map(value).collect();
        let worst = known().max_by(|(_, [_, a]), (_, [_, b])| a.abs().total_cmp(&b.abs()));
        errors.eigenvalue = worst.map(|(k, &[value, relative])| EigenvalueError {
            column: column.to_owned(),
            number: k + 1,
            value,
            relative,
        });
        if let Some(works) = errors.eigenvalue.as_ref().and_then(|worst| works(worst.number - 1)) {
            errors.bodies = BodyError::relative(field, &works);
        }
        errors.resolution = if errors.values.is_empty() {
            Resolution::Unknown
        } else if field.is_rough() {
            Resolution::Rough
        } else {
            Resolution::Good
        };
        Some(errors)
    }
}

/// Error of a frequency or a critical load factor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EigenvalueError {
    /// Column of the results: `frequency` or `factor`.
    pub column: String,
    /// Number of the mode, from 1.
    pub number: usize,
    /// Computed value.
    pub value: f64,
    /// Estimate of the exact value less the computed one, relative to it.
    pub relative: f64,
}
