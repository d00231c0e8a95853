use ancf_solver::equations::{Batch, State, Term};
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::elements::{RigidBody, StrainEnergy};
use crate::kinematics::{Attachment, Kind, Marker, NodalVector};

/// A body as coordinates and terms.
#[derive(Clone, Debug)]
pub enum Body {
    /// A beam or a cable of elements.
    Flexible(BeamMesh),
    /// A rigid body or a point mass.
    Rigid(RigidBody),
}

impl Body {
    /// Its mesh, if it is flexible.
    pub const fn mesh(&self) -> Option<&BeamMesh> {
        match self {
            Self::Flexible(mesh) => Some(mesh),
            Self::Rigid(_) => None,
        }
    }

    /// Number of coordinates.
    pub fn coordinates(&self) -> usize {
        match self {
            Self::Flexible(mesh) => mesh.coordinates(),
            Self::Rigid(body) => body.coordinates(),
        }
    }

    /// Number of multipliers of its own.
    pub const fn multipliers(&self) -> usize {
        match self {
            Self::Flexible(_) => 0,
            Self::Rigid(body) => body.multipliers(),
        }
    }

    /// Its terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        match self {
            Self::Flexible(mesh) => mesh.terms(),
            Self::Rigid(body) => body.terms(),
        }
    }

    /// Batches of its terms, each with the number of its first one.
    pub fn batches(&self) -> Vec<(usize, Box<dyn Batch>)> {
        self.mesh().map_or_else(Vec::new, BeamMesh::batches)
    }

    /// Sums Σ m x of its masses and positions, part by part: times an acceleration, the forces of a uniform field.
    pub fn mass_markers(&self) -> Vec<Marker> {
        match self {
            Self::Flexible(mesh) => mesh.mass_markers().collect(),
            Self::Rigid(body) => vec![body.mass_marker()],
        }
    }

    /// What joints, loads and probes hold on to: at an arc length of a flexible body, at a point of the reference state of a
    /// rigid one.
    pub fn attachment(&self, s: f64, point: Vector3<f64>) -> Attachment {
        match self {
            Self::Flexible(mesh) => mesh.attachment(s),
            Self::Rigid(body) => body.attachment(point),
        }
    }

    /// All vectors that its coordinates are, in a state, in the order of the coordinates.
    pub fn vectors(&self, s: &State) -> Vec<NodalVector> {
        match self {
            Self::Flexible(mesh) => mesh.vectors(s).collect(),
            Self::Rigid(body) => body.vectors(s).collect(),
        }
    }

    /// The node, if it has nodes, and the vector that a coordinate belongs to, if it is one of this body.
    pub fn place_of(&self, coordinate: usize) -> Option<(Option<usize>, Kind)> {
        match self {
            Self::Flexible(mesh) => mesh.place_of(coordinate).map(|(node, kind)| (Some(node), kind)),
            Self::Rigid(body) => body.place_of(coordinate).map(|kind| (None, kind)),
        }
    }

    /// The arc length of a node in the reference state; 0 of a body without nodes.
    pub fn arc_length(&self, node: usize) -> f64 {
        self.mesh().map_or(0.0, |mesh| {
            let nodes = mesh.coordinates() / (3 * mesh.node_kinds().len());
            mesh.length() * node as f64 / (nodes - 1).max(1) as f64
        })
    }

    /// Strain energy by part.
    pub fn strain_energy(&self, state: &State) -> StrainEnergy {
        self.mesh().map_or_else(StrainEnergy::default, |mesh| mesh.strain_energy(state))
    }
}
