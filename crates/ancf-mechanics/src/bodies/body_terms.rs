use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::elements::{RigidBody, StrainEnergy};
use crate::inertia::{MassVisitor, Momentum};
use crate::kinematics::{Attachment, Marker, NodalVector, VectorKind};
use crate::shells::{ShearShellMesh, ShellMesh, SurfacePlace};

/// Body as coordinates and terms.
#[derive(Clone, Debug)]
pub enum BodyTerms {
    /// Beam or cable mesh.
    Flexible(BeamMesh),
    /// Mesh of a thin shell.
    Shell(ShellMesh),
    /// Mesh of a shear-deformable shell.
    ShearShell(ShearShellMesh),
    /// Rigid body or point mass.
    Rigid(RigidBody),
}

impl BodyTerms {
    /// Returns the mesh of a beam or cable.
    pub const fn mesh(&self) -> Option<&BeamMesh> {
        match self {
            Self::Flexible(mesh) => Some(mesh),
            Self::Shell(_) | Self::ShearShell(_) | Self::Rigid(_) => None,
        }
    }

    /// Returns the mesh of a thin shell.
    pub const fn shell(&self) -> Option<&ShellMesh> {
        match self {
            Self::Shell(mesh) => Some(mesh),
            Self::Flexible(_) | Self::ShearShell(_) | Self::Rigid(_) => None,
        }
    }

    /// Returns the mesh of a shear-deformable shell.
    pub const fn shear_shell(&self) -> Option<&ShearShellMesh> {
        match self {
            Self::ShearShell(mesh) => Some(mesh),
            Self::Flexible(_) | Self::Shell(_) | Self::Rigid(_) => None,
        }
    }

    /// Returns true for a shell of either kind.
    pub const fn is_shell(&self) -> bool {
        matches!(self, Self::Shell(_) | Self::ShearShell(_))
    }

    /// Returns the number of coordinates.
    pub fn coordinates(&self) -> usize {
        match self {
            Self::Flexible(mesh) => mesh.coordinates(),
            Self::Shell(mesh) => mesh.coordinates(),
            Self::ShearShell(mesh) => mesh.coordinates(),
            Self::Rigid(body) => body.coordinates(),
        }
    }

    /// Returns the number of multipliers of the body.
    pub const fn multipliers(&self) -> usize {
        match self {
            Self::Flexible(_) | Self::Shell(_) | Self::ShearShell(_) => 0,
            Self::Rigid(body) => body.multipliers(),
        }
    }

    /// Returns the terms of the body.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        match self {
            Self::Flexible(mesh) => mesh.terms(),
            Self::Shell(mesh) => mesh.terms(),
            Self::ShearShell(mesh) => mesh.terms(),
            Self::Rigid(body) => vec![body.term()],
        }
    }

    /// Returns the sums Σ m x over parts of the body.
    ///
    /// Multiplied by an acceleration they give the forces of a uniform field.
    pub fn mass_markers(&self) -> Vec<Marker> {
        match self {
            Self::Flexible(mesh) => mesh.mass_markers().collect(),
            Self::Shell(mesh) => mesh.mass_markers().collect(),
            Self::ShearShell(mesh) => mesh.mass_markers().collect(),
            Self::Rigid(body) => vec![body.mass_marker()],
        }
    }

    /// Visits the elements, or the rigid body, with their nodal vectors in a state and their compact mass matrices.
    pub fn visit_masses(&self, s: &State, visit: &mut MassVisitor<'_>) {
        match self {
            Self::Flexible(mesh) => mesh.visit_masses(s, visit),
            Self::Shell(mesh) => mesh.visit_masses(s, visit),
            Self::ShearShell(mesh) => mesh.visit_masses(s, visit),
            Self::Rigid(body) => {
                let vectors: Vec<NodalVector> = body.vectors(s).collect();
                visit(&vectors, &|a, b| body.mass_entry(a, b));
            }
        }
    }

    /// Computes the momentum in a state.
    pub fn momentum(&self, s: &State) -> Momentum {
        let mut sum = Momentum::default();
        self.visit_masses(s, &mut |vectors, mass| sum += Momentum::of(vectors, mass, s));
        sum
    }

    /// Returns the attachment of joints, loads and probes.
    ///
    /// A beam is attached at an arc length, a thin shell at the parameters (u, v) in `point`, a shear-deformable one at (ξ, η, number
    /// of the element), and a rigid body at a point of the reference state.
    pub fn attachment(&self, s: f64, point: Vector3<f64>) -> Attachment {
        match self {
            Self::Flexible(mesh) => mesh.attachment(s),
            Self::Shell(mesh) => mesh.attachment([point.x, point.y]),
            Self::ShearShell(mesh) => {
                mesh.attachment(SurfacePlace { element: point.z as usize, at: [point.x, point.y] })
            }
            Self::Rigid(body) => body.attachment(point),
        }
    }

    /// Returns all nodal vectors in a state, in the order of the coordinates.
    pub fn vectors(&self, s: &State) -> Vec<NodalVector> {
        match self {
            Self::Flexible(mesh) => mesh.vectors(s).collect(),
            Self::Shell(mesh) => mesh.vectors(s).collect(),
            Self::ShearShell(mesh) => mesh.vectors(s).collect(),
            Self::Rigid(body) => body.vectors(s).collect(),
        }
    }

    /// Returns the node, if any, and the kind of vector to which a coordinate of this body belongs.
    pub fn locate_coordinate(&self, coordinate: usize) -> Option<(Option<usize>, VectorKind)> {
        match self {
            Self::Flexible(mesh) => mesh.locate_coordinate(coordinate).map(|(node, kind)| (Some(node), kind)),
            Self::Shell(mesh) => mesh.locate_coordinate(coordinate).map(|(node, kind)| (Some(node), kind)),
            Self::ShearShell(mesh) => {
                mesh.locate_coordinate(coordinate).map(|(node, kind)| (Some(node), kind))
            }
            Self::Rigid(body) => body.locate_coordinate(coordinate).map(|kind| (None, kind)),
        }
    }

    /// Returns the arc length of a node in the reference state. It is 0 for a body without nodes.
    pub fn arc_length(&self, node: usize) -> f64 {
        self.mesh().map_or(0.0, |mesh| {
            let nodes = mesh.coordinates() / (3 * mesh.node_kinds().len());
            mesh.length() * node as f64 / (nodes - 1).max(1) as f64
        })
    }

    /// Returns the strain energy by part. That of a shell has no parts.
    pub fn strain_energy(&self, state: &State) -> StrainEnergy {
        match self {
            Self::Flexible(mesh) => mesh.strain_energy(state),
            Self::Shell(mesh) => {
                StrainEnergy { volume: mesh.strain_energy(state), ..StrainEnergy::default() }
            }
            Self::ShearShell(mesh) => {
                StrainEnergy { volume: mesh.strain_energy(state), ..StrainEnergy::default() }
            }
            Self::Rigid(_) => StrainEnergy::default(),
        }
    }
}
