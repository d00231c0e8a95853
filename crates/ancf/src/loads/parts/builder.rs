use std::fmt;
use std::sync::Arc;

use ancf_mechanics::bodies::{BeamMesh, BodyTerms};
use ancf_mechanics::fluid::FlowField;
use ancf_mechanics::forces::{ExternalForce, Force};
use ancf_mechanics::functions::{ForceFunction, Function};
use ancf_mechanics::kinematics::{Attachment, BodyVector, Marker};
use ancf_mechanics::shells::{ElementPatch, ShearShellMesh, ShellMesh};
use ancf_solver::equations::Term;
use nalgebra::Vector3;

use super::context::LoadContext;
use crate::model::{Body, Place, ShearShell, TimeFunction, TimeMode, elements_of};

/// Builder of the terms of one load.
///
/// A [`LoadKind`](super::LoadKind) adds its terms in [`build`](super::LoadKind::build). All data are in solver units.
pub struct LoadBuilder<'a> {
    context: &'a dyn LoadContext,
    bodies: &'a [(String, BodyTerms)],
    attach: &'a dyn Fn(&Place) -> Attachment,
    time_mode: TimeMode,
    terms: Vec<Box<dyn Term>>,
}

impl fmt::Debug for LoadBuilder<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LoadBuilder").field("terms", &self.terms.len()).finish_non_exhaustive()
    }
}

impl<'a> LoadBuilder<'a> {
    /// A builder without terms. `attach` resolves places.
    pub(crate) fn new(
        context: &'a dyn LoadContext,
        bodies: &'a [(String, BodyTerms)],
        attach: &'a dyn Fn(&Place) -> Attachment,
        time_mode: TimeMode,
    ) -> Self {
        Self { context, bodies, attach, time_mode, terms: Vec::new() }
    }

    /// The finished terms.
    pub(crate) fn finish(self) -> Vec<Box<dyn Term>> {
        self.terms
    }

    /// Function of time for the analysis: 1 in statics, where the load factor multiplies the load.
    pub fn function(&self, time: &TimeFunction) -> Function {
        self.time_mode.function(time)
    }

    /// Fluid of a density with a uniform current, which a function of time multiplies.
    pub(in crate::loads) fn flow(
        &self,
        density: f64,
        current: [f64; 3],
        time: &TimeFunction,
    ) -> Arc<FlowField> {
        let (gravity, function) = (Vector3::from(self.context.gravity()), self.function(time));
        Arc::new(FlowField { density, gravity, current: Vector3::from(current), function })
    }

    /// Treatment of functions of time.
    pub(crate) fn time_mode(&self) -> TimeMode {
        self.time_mode
    }

    /// Attachment of a place to its body.
    pub fn attachment(&self, place: &Place) -> Attachment {
        (self.attach)(place)
    }

    /// Flexible body of a name, with its mesh.
    pub fn flexible(&self, name: &str) -> Option<(&'a Body, &'a BeamMesh)> {
        let (_, body) = self.context.body(name)?;
        let (_, built) = self.bodies.iter().find(|(own, _)| own == name)?;
        Some((body, built.mesh()?))
    }

    /// Mesh and data of a shear-deformable shell of a name.
    pub(in crate::loads) fn shear_shell(&self, name: &str) -> Option<(&'a ShearShellMesh, &'a ShearShell)> {
        let (body, built) = self.body(name)?;
        built.shear_shell().zip(body.shear_shell())
    }

    /// Body of a name in the model, with its terms.
    pub(in crate::loads) fn body(&self, name: &str) -> Option<(&'a Body, &'a BodyTerms)> {
        let (_, body) = self.context.body(name)?;
        let (_, built) = self.bodies.iter().find(|(own, _)| own == name)?;
        Some((body, built))
    }

    /// Mesh of a thin shell of a name.
    pub fn shell(&self, name: &str) -> Option<&'a ShellMesh> {
        self.bodies.iter().find(|(own, _)| own == name)?.1.shell()
    }

    /// Middle surfaces of the elements of a shell or of a region of it, with positions relative to an origin.
    pub(in crate::loads) fn patches(
        &self,
        body: &str,
        region: Option<&str>,
        origin: Vector3<f64>,
    ) -> Vec<ElementPatch> {
        self.body(body).map_or_else(Vec::new, |(body, terms)| patches(body, terms, region, origin))
    }

    /// Names of all bodies.
    pub fn body_names(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        self.bodies.iter().map(|(name, _)| name.as_str())
    }

    /// All bodies with their names, in the order of the model.
    pub(in crate::loads) fn bodies(&self) -> &'a [(String, BodyTerms)] {
        self.bodies
    }

    /// Markers of all bodies, weighted by the mass that each one stands for.
    pub fn mass_markers(&self) -> impl Iterator<Item = Marker> + use<'a> {
        self.bodies.iter().flat_map(|(_, body)| body.mass_markers())
    }

    /// Properties of the model.
    pub fn context(&self) -> &'a dyn LoadContext {
        self.context
    }

    /// Adds a term.
    pub fn add(&mut self, term: impl Term + 'static) {
        self.add_boxed(Box::new(term));
    }

    /// Adds a term of a type that is known at run time only.
    pub fn add_boxed(&mut self, term: Box<dyn Term>) {
        self.terms.push(term);
    }

    /// Adds a force of constant direction at a point.
    pub fn force(
        &mut self,
        point: impl Into<BodyVector>,
        force: impl Into<Vector3<f64>>,
        function: Function,
    ) {
        self.add(Force::varying(point, force.into(), function));
    }

    /// Adds a force at a place, computed from time, position and velocity.
    pub fn external_force(&mut self, on: &Place, force: ForceFunction) {
        self.add(ExternalForce::new(self.attachment(on).point, force, self.context.length()));
    }
}

/// Middle surfaces of the elements of a shell or of a region of it, with positions relative to an origin. Empty for other bodies.
pub(crate) fn patches(
    body: &Body,
    terms: &BodyTerms,
    region: Option<&str>,
    origin: Vector3<f64>,
) -> Vec<ElementPatch> {
    let patch = |k: usize| match (terms.shell(), terms.shear_shell()) {
        (Some(mesh), _) => Some(ElementPatch::thin(mesh, k, origin)),
        (_, Some(mesh)) => Some(ElementPatch::face(mesh, k, origin)),
        _ => None,
    };
    elements_of(body, region).into_iter().filter_map(patch).collect()
}
