use std::collections::BTreeMap;
use std::fmt;

use ancf_mechanics::bodies::normals_to;
use ancf_mechanics::constraints::{
    BilinearMeasure, CoincidenceConstraint, ConstantAngle, ConstrainedVector, LinearConstraint,
    MeasureConstraint, MeasureFactor, MeasureTarget, RotationDrive, SectionDrive,
};
use ancf_mechanics::functions::Function;
use ancf_mechanics::kinematics::{Attachment, BodyVector, Directions};
use ancf_mechanics::shells::{ShearShellMesh, ShellMesh};
use nalgebra::Vector3;

use super::coupling::JointCoordinate;
use super::end::{ClampedGradients, End, Ground, reference};
use super::equations::{EquationOwner, JointBody, JointEnds, JointEquations, Numbering, Part};
use super::measures;
use super::term::JointTerm;
use crate::model::{ShearShell, TimeFunction, TimeMode};

/// Builder of the equations of one joint.
///
/// A [`JointKind`](super::JointKind) adds constraints, springs and friction in [`build`](super::JointKind::build). Coordinates
/// and multipliers are numbered in the order in which they are added.
pub struct JointBuilder<'a> {
    pub(super) ends: JointEnds<'a>,
    pub(super) coupled: &'a dyn Fn(JointCoordinate) -> bool,
    pub(super) time_mode: TimeMode,
    /// Typical energy of the model.
    pub(super) energy: f64,
    pub(super) equations: JointEquations,
}

impl fmt::Debug for JointBuilder<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.equations.fmt(f)
    }
}

impl<'a> JointBuilder<'a> {
    /// Builder without equations. `coupled` states which joint coordinates a coupling uses.
    pub(crate) fn new(
        name: &str,
        ends: JointEnds<'a>,
        numbering: Numbering,
        coupled: &'a dyn Fn(JointCoordinate) -> bool,
    ) -> Self {
        let Numbering { coordinate, multiplier, time_mode, energy } = numbering;
        let equations = JointEquations::new(EquationOwner::Joint, name, coordinate, multiplier);
        Self { ends, coupled, time_mode, energy, equations }
    }

    /// Finished equations.
    pub(crate) fn finish(self) -> JointEquations {
        self.equations
    }

    /// Attachment of the first end.
    pub fn a(&self) -> &'a Attachment {
        self.ends.a
    }

    /// Attachment of the second end.
    pub fn b(&self) -> &'a Attachment {
        self.ends.b
    }

    /// Mesh of the first body, if it is a thin shell.
    pub fn shell(&self) -> Option<&'a ShellMesh> {
        self.ends.body.terms.shell()
    }

    /// Mesh and data of the first body, if it is a shear-deformable shell.
    pub(crate) fn shear_shell(&self) -> Option<(&'a ShearShellMesh, &'a ShearShell)> {
        self.ends.body.shear_shell()
    }

    /// Bodies of both ends, if both are on bodies.
    pub(crate) fn bodies(&self) -> Option<[JointBody<'a>; 2]> {
        Some([self.ends.body, self.ends.other?])
    }

    /// Attachment of the second end, if it is a body.
    pub(crate) fn base(&self) -> Option<&'a Attachment> {
        matches!(self.ends.stated, End::Place(_)).then_some(self.ends.b)
    }

    /// Mesh of the second body, if it is a thin shell.
    pub(crate) fn other_shell(&self) -> Option<&'a ShellMesh> {
        self.ends.other.and_then(|body| body.terms.shell())
    }

    /// Mesh and data of the second body, if it is a shear-deformable shell.
    pub(crate) fn other_shear_shell(&self) -> Option<(&'a ShearShellMesh, &'a ShearShell)> {
        self.ends.other.and_then(|body| body.shear_shell())
    }

    /// Adds a linear equation of nodal vectors of the first body and of others, unless the equations of edges that share its nodes
    /// imply it.
    pub(crate) fn add_linear(
        &mut self,
        vectors: Vec<ConstrainedVector>,
        others: Vec<ConstrainedVector>,
        name: &'static str,
    ) {
        let about = self.a().point.linear().clone();
        let equation = LinearConstraint::new(vectors, &about, self.equations.multipliers.end, name);
        let equation = equation.with_others(others);
        if self.is_new(equation.entries()) {
            self.multipliers(1);
            self.add(equation);
        }
    }

    /// Registers that the product of two directions of a rigid body is constant, for equations of edges that this implies.
    pub(crate) fn assume_constant(&self, a: &BodyVector, b: &BodyVector) {
        self.is_new(BodyVector::product_gradient(a, b));
    }

    /// Registers an equation of edges with these factors of coordinates. Returns false if those before it imply it.
    fn is_new(&self, factors: impl IntoIterator<Item = (usize, f64)>) -> bool {
        let of_mesh = self.shear_shell().map_or(0..0, |(mesh, _)| mesh.range());
        let preferred = self.shell().map_or(of_mesh, ShellMesh::range);
        self.ends.edge_rows.borrow_mut().add(factors, &preferred)
    }

    /// Function of time for the analysis: constant in statics, where loads and drives grow by the load factor.
    pub fn function(&self, time: &TimeFunction) -> Function {
        self.time_mode.function(time)
    }

    /// Reserves a coordinate of the joint; returns its number.
    pub fn coordinate(&mut self) -> usize {
        self.equations.coordinates.end += 1;
        self.equations.coordinates.end - 1
    }

    /// Reserves multipliers; returns the number of the first one.
    pub fn multipliers(&mut self, count: usize) -> usize {
        self.equations.multipliers.end += count;
        self.equations.multipliers.end - count
    }

    /// Adds a term.
    pub fn add(&mut self, term: impl JointTerm + 'static) {
        self.equations.parts.push(Part::new(Box::new(term)));
    }

    /// Constrains the points of both ends to coincide; their gap is kept, closed, or closed with the load factor.
    pub fn coincide(&mut self) {
        let first = self.multipliers(3);
        self.equations.position = Some(match self.ends.stated {
            End::Point(Ground { point }) => {
                CoincidenceConstraint::toward(&self.a().point, Vector3::from(*point), first)
            }
            _ => CoincidenceConstraint::points(&self.a().point, &self.b().point, first),
        });
    }

    /// Constrains two points of the bodies to move together, with the moment of the reaction about the first end.
    pub(crate) fn bond_points(&mut self, a: &Attachment, b: &Attachment) {
        let first = self.multipliers(3);
        let term = Box::new(CoincidenceConstraint::points(&a.point, &b.point, first));
        let arm = Some([a.point.clone(), self.a().point.clone()]);
        self.equations.parts.push(Part { arm, ..Part::new(term) });
    }

    /// Prescribes the rotation of the first end about an axis.
    pub fn prescribe_rotation(
        &mut self,
        axis: Vector3<f64>,
        angle: f64,
        function: &Function,
        fix: Option<ClampedGradients>,
    ) {
        let (here, fix) = (self.a(), self.fixed(fix));
        if let (Directions::Section(_, frame) | Directions::Surface(frame), ClampedGradients::Section) =
            (&here.directions, fix)
        {
            let first = self.multipliers(3);
            return self.add(SectionDrive::new(frame, axis, angle, function.clone(), first));
        }
        for &direction in fix.of(&reference(here)) {
            let (first, direction) = (self.multipliers(3), here.material_direction(direction));
            self.add(RotationDrive::new(&direction, axis, angle, function.clone(), first));
        }
    }

    pub(crate) fn fixed(&self, fix: Option<ClampedGradients>) -> ClampedGradients {
        let default = if self.ends.all_gradients { ClampedGradients::All } else { ClampedGradients::Section };
        fix.unwrap_or(default)
    }

    /// Constrains two directions to keep their angle. The first one belongs to the first end.
    pub fn keep_angle(
        &mut self,
        a: impl Into<BodyVector>,
        b: impl Into<BodyVector>,
        name: Option<&'static str>,
    ) {
        let (a, b, name) = (a.into(), b.into(), name.unwrap_or("angle of directions"));
        if let (Some(a), Some(b)) = (a.marker(), b.marker()) {
            let first = self.multipliers(1);
            return self.add(ConstantAngle::new(a, b, first).named(name));
        }
        let product = (1.0, MeasureFactor::Direction(&a), MeasureFactor::Other(&b));
        self.prescribe(name, BilinearMeasure::new([product]), MeasureTarget::NONE);
    }

    /// Constrains a sum of products of directions, of the first end and of the other one, to its reference value, unless the equations
    /// of edges that share its nodes imply it.
    pub(crate) fn keep_edge_angles(&mut self, products: &[(&BodyVector, &BodyVector)], name: &'static str) {
        let mut gradient = BTreeMap::new();
        for (coordinate, rate) in products.iter().flat_map(|(a, b)| BodyVector::product_gradient(a, b)) {
            *gradient.entry(coordinate).or_insert(0.0) += rate;
        }
        if !self.is_new(gradient) {
            return;
        }
        if let [(a, b)] = *products {
            return self.keep_angle(a.clone(), b.clone(), Some(name));
        }
        let product = |&(a, b)| (1.0, MeasureFactor::Direction(a), MeasureFactor::Other(b));
        self.prescribe(name, BilinearMeasure::new(products.iter().map(product)), MeasureTarget::NONE);
    }

    /// Constrains an axis of unit length of the first end to stay parallel to the same axis of the second end.
    pub fn parallel(&mut self, axis: impl Into<Vector3<f64>>, name: &'static str) {
        let axis = axis.into();
        for normal in normals_to(axis) {
            self.keep_angle(self.a().direction(axis), self.b().direction(normal), Some(name));
        }
        self.expect_aligned(&[axis]);
    }

    /// States that axes of two rigid ends coincide in all admissible states, besides the equations for their products.
    pub(crate) fn expect_aligned(&mut self, axes: &[Vector3<f64>]) {
        let (a, b) = (self.a(), self.b());
        if a.is_rigid() && b.is_rigid() {
            let cosines = axes.iter().map(|&axis| measures::angle(a, b, axis, axis));
            self.equations.alignments.extend(cosines);
        }
    }

    /// Constrains a measure to its reference value, in states in which another measure is positive.
    pub(crate) fn keep_where(
        &mut self,
        name: &'static str,
        measure: BilinearMeasure,
        positive: &BilinearMeasure,
    ) {
        let multiplier = self.multipliers(1);
        self.add(MeasureConstraint::new(measure, multiplier).named(name).where_positive(positive));
    }

    /// Constrains directions of both ends to coincide.
    pub(crate) fn coincide_directions(&mut self, directions: &[Vector3<f64>]) {
        for &direction in directions {
            let first = self.multipliers(3);
            let (a, b) = (self.a().material_direction(direction), self.b().material_direction(direction));
            self.add(CoincidenceConstraint::directions(&a, &b, first));
        }
    }

    /// Constrains a measure to its target.
    pub fn prescribe(&mut self, name: &'static str, measure: BilinearMeasure, target: MeasureTarget) {
        let multiplier = self.multipliers(1);
        self.add(MeasureConstraint::driven(measure, target, multiplier).named(name));
    }

    /// Constrains measures to their reference values: a number of them for each name.
    pub fn keep(&mut self, names: &[(&'static str, usize)], measures: Vec<BilinearMeasure>) {
        let names = names.iter().flat_map(|&(name, count)| std::iter::repeat_n(name, count));
        names.zip(measures).for_each(|(name, measure)| self.prescribe(name, measure, MeasureTarget::NONE));
    }
}
