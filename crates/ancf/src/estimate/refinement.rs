use std::fmt;

use serde::{Deserialize, Serialize};

use super::body_errors::NEGLIGIBLE;
use super::discretisation_errors::{DiscretisationErrors, Resolution};
use super::finer::halved;
use crate::errors::percentage;
use crate::joints::End;
use crate::model::{Body, Model};

/// Largest number of meshes.
const MESHES: usize = 10;
/// Largest factor between the numbers of elements of consecutive meshes.
const LARGEST: f64 = 4.0;
/// Part of the requested error that a refined mesh aims at.
const AIM: f64 = 0.7;
/// Ratio of the errors of consecutive meshes above which the refinement has no effect.
const NO_EFFECT: f64 = 0.8;
/// Number of failed runs that are repeated on a finer mesh.
const FAILURES: usize = 2;
/// Distance of a joint from a node, relative to an element, that is a rounding error.
const AT_NODE: f64 = 1e-9;
/// Largest number of elements of a body.
const ELEMENTS: usize = 100_000;
/// Largest number of elements of a body of a model with shells, a quarter of that of the second solution.
const SHELL_ELEMENTS: usize = ELEMENTS / 4;

/// Mesh of a refinement and its error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeshStep {
    /// Flexible bodies and their numbers of elements.
    pub elements: Vec<(String, usize)>,
    /// Largest relative error; `None` if the mesh does not resolve the shape, the error is not known or the run failed.
    pub error: Option<f64>,
}

impl fmt::Display for MeshStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let elements: Vec<String> =
            self.elements.iter().map(|(body, count)| format!("`{body}` {count}")).collect();
        let error = self.error.map_or_else(|| "not known".into(), percentage);
        write!(f, "elements {}; error {error}", elements.join(", "))
    }
}

/// Refinement of the bodies of a model until the estimated error meets a wish.
#[derive(Clone, Debug)]
pub struct Refinement {
    requested: f64,
    meshes: Vec<MeshStep>,
    failures: usize,
}

/// Result of a run in a refinement.
#[derive(Clone, Debug, PartialEq)]
pub enum RefinementStep {
    /// The error is as small as requested.
    Reached,
    /// The next model.
    Next(Box<Model>),
    /// Refinement does not help, for a stated reason.
    Ended(String),
}

impl Refinement {
    /// Creates a refinement to a relative error.
    pub const fn new(requested: f64) -> Self {
        Self { requested, meshes: Vec::new(), failures: 0 }
    }

    /// Meshes so far.
    pub fn meshes(&self) -> &[MeshStep] {
        &self.meshes
    }

    /// Returns the next model after a run of `model` with these errors.
    ///
    /// Each body is refined by the factor that its contribution requires for the order of convergence of its elements, at most four.
    /// Where the mesh does not resolve the shape, and in models with shells, all bodies get twice the number of elements in each direction.
    pub fn advance(&mut self, model: &Model, errors: Option<&DiscretisationErrors>) -> RefinementStep {
        let Some(errors) = errors else {
            return RefinementStep::Ended("this analysis has no estimate of the error of the mesh".into());
        };
        let error = errors.largest();
        let before = self.meshes.last().and_then(|step| step.error);
        self.meshes.push(MeshStep { elements: elements_of(model), error });
        match (errors.resolution, error) {
            (Resolution::Unknown, _) => RefinementStep::Ended("the error of this mesh is not known".into()),
            (Resolution::Unresolved, _) => self.halve(model),
            (_, None) => {
                RefinementStep::Ended("no probe moves, so there is no error of a displacement".into())
            }
            (_, Some(error)) if error <= self.requested => RefinementStep::Reached,
            (_, Some(error)) if before.is_some_and(|before| error > NO_EFFECT * before) => {
                RefinementStep::Ended(format!(
                    "the finer mesh has the same error, {}: it is that of the formulation or of the section law",
                    percentage(error)
                ))
            }
            _ if model.has_shells() => self.halve(model),
            _ => {
                let contributing = errors.bodies.iter().filter(|body| body.share > NEGLIGIBLE).count();
                self.next(model, |body| {
                    let found = errors.bodies.iter().find(|found| found.body == body.name());
                    let requested = found.map_or(0, |found| {
                        found.elements_for(AIM * self.requested, contributing, body.convergence_order())
                    });
                    requested.max(body.elements() as usize)
                })
            }
        }
    }

    /// Returns the next model after a run of `model` that failed: all bodies get twice the number of elements.
    pub fn advance_failed(&mut self, model: &Model) -> RefinementStep {
        let has_failed = self.failures >= FAILURES;
        self.failures += 1;
        self.meshes.push(MeshStep { elements: elements_of(model), error: None });
        if has_failed {
            return RefinementStep::Ended("the run on this mesh failed".into());
        }
        self.halve(model)
    }

    /// Returns the model with twice the elements in each direction.
    fn halve(&self, model: &Model) -> RefinementStep {
        if let Some(shell) = model.bodies.iter().find(|body| body.shear_shell().is_some()) {
            return RefinementStep::Ended(format!(
                "the nodes of shear-deformable shell `{}` are given; create its mesh with smaller elements",
                shell.name()
            ));
        }
        if !model.has_shells() {
            return self.next(model, |body| 2 * body.elements() as usize);
        }
        let finer = halved(model);
        match finer.bodies.iter().find(|body| body.elements() as usize > SHELL_ELEMENTS) {
            _ if self.meshes.len() >= MESHES => too_many_meshes(),
            Some(body) => too_many_elements(body, SHELL_ELEMENTS),
            None => RefinementStep::Next(Box::new(finer)),
        }
    }

    /// Returns the model with more elements.
    fn next(&self, model: &Model, count: impl Fn(&Body) -> usize) -> RefinementStep {
        if self.meshes.len() >= MESHES {
            return too_many_meshes();
        }
        let mut next = model.clone();
        let mut has_changed = false;
        for body in &mut next.bodies {
            let now = body.elements() as usize;
            let requested = nodal(model, body, count(body).min((now as f64 * LARGEST) as usize));
            if requested > ELEMENTS {
                return too_many_elements(body, ELEMENTS);
            }
            if requested > now {
                has_changed = true;
                body.set_elements(requested as u32);
            }
        }
        if has_changed {
            RefinementStep::Next(Box::new(next))
        } else {
            RefinementStep::Ended("no body contributes to the error".into())
        }
    }
}

fn too_many_meshes() -> RefinementStep {
    RefinementStep::Ended(format!("the error is still larger after {MESHES} meshes"))
}

fn too_many_elements(body: &Body, limit: usize) -> RefinementStep {
    RefinementStep::Ended(format!("body `{}` requires more than {limit} elements", body.name()))
}

/// Flexible bodies and their numbers of elements.
fn elements_of(model: &Model) -> Vec<(String, usize)> {
    let flexible = model.bodies.iter().filter(|body| body.elements() > 0);
    flexible.map(|body| (body.name().to_owned(), body.elements() as usize)).collect()
}

/// Returns the smallest number of elements from `count` on with nodes at all joints of a body, or `count` if there is none nearby.
fn nodal(model: &Model, body: &Body, count: usize) -> usize {
    let ends = model.joints.iter().flat_map(|joint| {
        let (a, b) = joint.ends();
        [Some(a), if let End::Place(b) = b { Some(b) } else { None }]
    });
    let own = ends.flatten().filter(|place| place.body == body.name());
    let places: Vec<f64> = own.map(|place| body.arc_length(&place.at) / body.length()).collect();
    let is_nodal = |n: &usize| {
        let distance = |place: &f64| (place * *n as f64 - (place * *n as f64).round()).abs();
        places.iter().all(|place| distance(place) < AT_NODE)
    };
    (count..=4 * count).find(is_nodal).unwrap_or(count)
}
