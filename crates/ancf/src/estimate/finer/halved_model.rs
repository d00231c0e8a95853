use super::halved_mesh::halved_mesh;
use crate::assembly::Assembly;
use crate::errors::ModelError;
use crate::model::{At, Body, Model, Probe, ShearShell};

/// Model with twice the elements of each flexible body in each direction, and its equations.
#[derive(Debug)]
pub(crate) struct HalvedModel {
    pub(crate) model: Model,
    pub(crate) assembly: Assembly,
}

impl HalvedModel {
    /// Creates the finer model of one with shells in solver units, if its errors are to be estimated.
    pub(crate) fn requested(model: &Model) -> Option<Result<Self, String>> {
        (model.output.errors && model.has_shells()).then(|| Self::new(model))
    }

    /// Creates the model from one in solver units.
    ///
    /// # Errors
    /// A description of the first error of the finer model, such as too little memory.
    pub(crate) fn new(model: &Model) -> Result<Self, String> {
        let mut model = halved(model);
        model.output.errors = false;
        match model.assemble_scaled() {
            Ok(assembly) => Ok(Self { model, assembly }),
            Err(errors) => Err(errors.0.first().map_or_else(String::new, invalid)),
        }
    }

    /// Number of elements of all bodies.
    pub(crate) fn elements(&self) -> usize {
        elements(&self.model)
    }
}

/// Description of an error of the finer model. Numbers other than those of elements and memory are in solver units and are omitted.
fn invalid(error: &ModelError) -> String {
    let found = if error.path == "bodies" { format!(": {}", error.found) } else { String::new() };
    format!("`{}` is not valid with elements of half the size{found}", error.path)
}

/// Number of elements of all bodies of a model.
pub(super) fn elements(model: &Model) -> usize {
    model.bodies.iter().map(|body| body.elements() as usize).sum()
}

/// Returns a model with twice the elements of each flexible body in each direction.
///
/// Joints, loads and regions keep their places. Probes at points of shear-deformable shells are moved to the finer mesh.
pub(in crate::estimate) fn halved(model: &Model) -> Model {
    let mut halved = model.clone();
    for body in &mut halved.bodies {
        match body {
            Body::Beam(_) | Body::Cable(_) => body.set_elements(body.elements().saturating_mul(2)),
            Body::Shell(shell) => shell.elements = shell.elements.map(|count| count.saturating_mul(2)),
            Body::ShearShell(shell) => (shell.mesh, shell.thickness) = halved_mesh(shell),
            Body::Rigid(_) | Body::Mass(_) => {}
        }
    }
    let Model { bodies, probes, .. } = &mut halved;
    for probe in probes {
        let body = bodies.iter().find(|body| body.name() == probe.on.body);
        if let Some(shell) = body.and_then(Body::shear_shell) {
            move_probe(probe, shell);
        }
    }
    halved
}

/// Moves a probe at a point to the nearest point of a mesh.
fn move_probe(probe: &mut Probe, shell: &ShearShell) {
    if let At::Point(point) = &mut probe.on.at
        && let Some(nearest) = shell.nearest(point)
    {
        *point = shell.point_at(nearest.place).into();
    }
}
