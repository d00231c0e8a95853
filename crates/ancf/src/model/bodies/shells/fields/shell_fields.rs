use ancf_mechanics::functions::ExpressionError;
use ancf_mechanics::shells::{LocalSection, PlaceFormula};
use nalgebra::Vector3;

use super::fibres::{AngleField, AxisField, FibreAngle, FibreAxis};
use super::normal::is_parallel;
use super::thickness::{ShellThickness, ThicknessField};
use crate::errors::is_direction;

/// Point of a shell in the reference state at which its fields are evaluated.
#[derive(Clone, Debug)]
pub(crate) struct FieldPoint {
    pub(crate) position: Vector3<f64>,
    /// Parameters u and v of a patch.
    pub(crate) parameters: Option<[f64; 2]>,
    /// Direction of the normal.
    pub(crate) normal: Vector3<f64>,
    /// Nodes of the element of a mesh with their weights, which are zero without a node.
    pub(crate) nodes: [(usize, f64); 4],
}

/// Values of the fields at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FieldValues {
    pub(crate) thickness: f64,
    pub(crate) angle: f64,
    /// Axis of the fibres, if it varies.
    pub(crate) axis: Option<Vector3<f64>>,
}

/// Syntax error of a formula, with the key and the text of the formula.
#[derive(Clone, Debug)]
pub(crate) struct FieldError {
    pub(crate) key: String,
    pub(crate) text: String,
    pub(crate) error: ExpressionError,
}

/// Formula in positions that are measured in a unit.
#[derive(Clone, Debug)]
struct Formula {
    formula: PlaceFormula,
    unit: f64,
}

#[derive(Clone, Debug)]
enum Thickness {
    Uniform(f64),
    Formula(Formula),
    Nodes(Vec<f64>),
}

#[derive(Clone, Debug)]
enum Angle {
    Uniform(f64),
    Formula(Formula),
}

/// Fields of a shell for evaluation.
#[derive(Clone, Debug)]
pub(crate) struct ShellFields {
    thickness: Thickness,
    angle: Angle,
    axis: Option<[Formula; 3]>,
}

/// Fields of a shell as given.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GivenFields<'a> {
    pub(crate) thickness: &'a ShellThickness,
    pub(crate) angle: Option<&'a FibreAngle>,
    pub(crate) axis: Option<&'a FibreAxis>,
    /// True for a patch with the parameters u and v.
    pub(crate) is_patch: bool,
}

impl Formula {
    fn at(&self, point: &FieldPoint) -> f64 {
        self.formula.at(&(point.position / self.unit), point.parameters.unwrap_or_default())
    }
}

impl GivenFields<'_> {
    /// True if all points of the shell have the same section.
    pub(super) fn are_uniform(&self) -> bool {
        let is_turned = self.angle.is_some_and(|angle| *angle != FibreAngle::Uniform(0.0));
        self.thickness.uniform().is_some()
            && !is_turned
            && self.axis.is_none_or(|axis| axis.uniform().is_some())
    }

    fn formula(&self, key: &str, text: &str, unit: f64) -> Result<Formula, FieldError> {
        match PlaceFormula::parse(text, self.is_patch) {
            Ok(formula) => Ok(Formula { formula, unit }),
            Err(error) => Err(FieldError { key: key.into(), text: text.into(), error }),
        }
    }

    /// Compiles the formulas.
    pub(super) fn compile(&self) -> Result<ShellFields, FieldError> {
        let thickness = match self.thickness {
            ShellThickness::Uniform(thickness) => Thickness::Uniform(*thickness),
            ShellThickness::Varying(ThicknessField::Expression { text, unit }) => {
                Thickness::Formula(self.formula("thickness.text", text, *unit)?)
            }
            ShellThickness::Varying(ThicknessField::Nodes { values }) => Thickness::Nodes(values.clone()),
        };
        let angle = match self.angle {
            None => Angle::Uniform(0.0),
            Some(FibreAngle::Uniform(angle)) => Angle::Uniform(*angle),
            Some(FibreAngle::Varying(AngleField::Expression { text, unit })) => {
                Angle::Formula(self.formula("fibre_angle.text", text, *unit)?)
            }
        };
        let axis = match self.axis {
            None | Some(FibreAxis::Uniform(_)) => None,
            Some(FibreAxis::Varying(AxisField::Expression { text: [x, y, z], unit })) => Some([
                self.formula("fibre_axis.text[0]", x, *unit)?,
                self.formula("fibre_axis.text[1]", y, *unit)?,
                self.formula("fibre_axis.text[2]", z, *unit)?,
            ]),
        };
        Ok(ShellFields { thickness, angle, axis })
    }
}

impl ShellFields {
    /// Values at a point. Those of missing nodes are not numbers.
    pub(crate) fn at(&self, point: &FieldPoint) -> FieldValues {
        let thickness = match &self.thickness {
            Thickness::Uniform(thickness) => *thickness,
            Thickness::Formula(formula) => formula.at(point) * formula.unit,
            Thickness::Nodes(values) => {
                let of = |(node, weight): &(usize, f64)| weight * values.get(*node).unwrap_or(&f64::NAN);
                point.nodes.iter().map(of).sum()
            }
        };
        let angle = match &self.angle {
            Angle::Uniform(angle) => *angle,
            Angle::Formula(formula) => formula.at(point),
        };
        let axis = self.axis.as_ref().map(|axis| Vector3::from(axis.each_ref().map(|x| x.at(point))));
        FieldValues { thickness, angle, axis }
    }
}

/// Value of a field that a section does not have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum FieldDefect {
    /// Thickness that is not a positive number.
    Thickness(f64),
    /// Angle that is not a number.
    Angle(f64),
    /// Axis without a direction.
    Axis([f64; 3]),
    /// Axis along the normal.
    Normal([f64; 3]),
}

impl FieldValues {
    /// Defect of the values at a point.
    pub(super) fn defect(&self, point: &FieldPoint) -> Option<FieldDefect> {
        if !(self.thickness.is_finite() && self.thickness > 0.0) {
            return Some(FieldDefect::Thickness(self.thickness));
        }
        if !self.angle.is_finite() {
            return Some(FieldDefect::Angle(self.angle));
        }
        let axis = <[f64; 3]>::from(self.axis?);
        if !is_direction(axis) {
            return Some(FieldDefect::Axis(axis));
        }
        is_parallel(&point.normal, &axis).then_some(FieldDefect::Normal(axis))
    }

    /// Section at the point, relative to one with a given thickness.
    pub(super) fn section(&self, thickness: f64) -> LocalSection {
        LocalSection { scale: self.thickness / thickness, axis: self.axis, turn: self.angle }
    }
}
