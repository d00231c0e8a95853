use crate::assembly::Assembly;
use crate::joints::End;
use crate::model::{About, Analysis, At, Body, Model, Modes, Origin, Place};

/// Order of convergence of displacements under concentrated forces on thin shells, or with joints between nodes.
const CONCENTRATED: f64 = 2.0;
/// Lower bound of the order for values that do not converge regularly.
const IRREGULAR: f64 = 1.0;

/// Reason for which an analysis from a given state has no second solution.
pub(crate) const GIVEN_START: &str = "the analysis starts in a given state, which a finer mesh does not have";

/// Order of convergence of the values of a model by the size of its elements.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::estimate) struct Convergence {
    pub(in crate::estimate) order: f64,
    /// Reason for which an error that follows from this order is an order of magnitude.
    pub(in crate::estimate) irregular: Option<String>,
}

impl Convergence {
    /// Lowest order of the flexible bodies of a model.
    ///
    /// # Errors
    /// The reason for which the difference between meshes is no measure of the error.
    pub(in crate::estimate) fn of(model: &Model, assembly: &Assembly) -> Result<Self, String> {
        if let Some(body) = model.bodies.iter().find(|body| has_poisson_locking(model, body)) {
            return Err(format!(
                "the error of beam `{}` with Poisson locking does not vanish on fine meshes",
                body.name()
            ));
        }
        if matches!(model.initial.from, Origin::Folder(_)) {
            return Err(GIVEN_START.into());
        }
        let flexible = model.bodies.iter().filter(|body| body.elements() > 0);
        let order = flexible.map(Body::convergence_order).fold(f64::INFINITY, f64::min);
        let limits = [
            (!model.contacts.is_empty()).then(|| (IRREGULAR, "the model has contacts".to_owned())),
            concentrated(model),
            wrinkled(model),
            assembly.inner_loads.has_joints.then(|| (CONCENTRATED, "joints act within elements".to_owned())),
        ];
        let lowest = limits.into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0));
        let limit = lowest.as_ref().map_or(f64::INFINITY, |(order, _)| *order);
        Ok(Self { order: order.min(limit), irregular: lowest.map(|(_, reason)| reason) })
    }
}

/// Order of values with loads or joints at points of shells, and the reason. Below a concentrated force the displacement of a shell with
/// shear is infinite on fine meshes, as is the rotation of a thin shell below a moment.
fn concentrated(model: &Model) -> Option<(f64, String)> {
    let on_shell = |place: &&Place| {
        let body = model.bodies.iter().find(|body| body.name() == place.body);
        body.filter(|body| body.is_shell() && !matches!(place.at, At::Edge(_)))
    };
    let is_unloaded = matches!(&model.analysis, Analysis::Modes(Modes { about: About::Reference, .. }));
    let loads = model.loads.iter().filter(|_| !is_unloaded).filter_map(|load| load.on());
    let joints = model.joints.iter().flat_map(|joint| {
        let (a, b) = joint.ends();
        [Some(a), if let End::Place(b) = b { Some(b) } else { None }].into_iter().flatten()
    });
    let found = loads.chain(joints).filter_map(|place| on_shell(&place));
    let order = |body: &Body| if body.shear_shell().is_some() { IRREGULAR } else { CONCENTRATED };
    let lowest = found.min_by(|a, b| order(a).total_cmp(&order(b)))?;
    let reason = format!("forces act at points of shell `{}`", lowest.name());
    Some((order(lowest), reason))
}

/// Order of values with a tension field, whose strains have kinks at the edges of wrinkled regions, and the reason.
fn wrinkled(model: &Model) -> Option<(f64, String)> {
    let has_wrinkles = |body: &&Body| body.membrane().is_some_and(|membrane| membrane.tension_field);
    let body = model.bodies.iter().find(has_wrinkles)?;
    Some((CONCENTRATED, format!("shell `{}` is a tension field", body.name())))
}

/// True for elements whose bending stiffness is too large by Poisson's ratio on any mesh.
pub(in crate::estimate) fn has_poisson_locking(model: &Model, body: &Body) -> bool {
    let is_continuum = matches!(body, Body::Beam(beam) if beam.formulation.is_continuum());
    let material = body.section_and_material().and_then(|(_, name)| model.materials.get(name));
    is_continuum && material.is_some_and(|material| material.poisson != 0.0)
}
