use std::ops::AddAssign;

use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::body_terms::BodyTerms;
use super::mesh::BeamMesh;
use crate::kinematics::{NodalVector, VectorKind};

/// Mass, first moment, momentum and kinetic energy of a body in a state.
///
/// Positions are r = Σ_a S_a e_a with nodal vectors e_a, and p_a = Σ_b M_ab ė_b with the compact mass matrix M. Translations
/// and rotations of the body are those of its nodal vectors:
///
/// ∫ ρ ṙ dV = Σ_a p_a over the position vectors,   ∫ ρ r × ṙ dV = Σ_a e_a × p_a,   T = ½ Σ_a ė_a·p_a.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Momentum {
    /// Mass m.
    pub mass: f64,
    /// First moment ∫ ρ r dV: mass times position of the mass centre.
    pub first_moment: Vector3<f64>,
    /// Linear momentum ∫ ρ ṙ dV.
    pub linear: Vector3<f64>,
    /// Angular momentum ∫ ρ r × ṙ dV about the origin.
    pub angular: Vector3<f64>,
    /// Kinetic energy.
    pub kinetic: f64,
}

impl AddAssign for Momentum {
    fn add_assign(&mut self, other: Self) {
        self.mass += other.mass;
        self.first_moment += other.first_moment;
        self.linear += other.linear;
        self.angular += other.angular;
        self.kinetic += other.kinetic;
    }
}

impl Momentum {
    /// Position of the mass centre.
    pub fn center(&self) -> Vector3<f64> {
        self.first_moment / self.mass
    }

    /// Computes the momentum of nodal vectors with the compact mass matrix M_ab.
    fn of(vectors: &[NodalVector], mass: impl Fn(usize, usize) -> f64, s: &State) -> Self {
        let mut sum = Self::default();
        let velocity =
            |vector: &NodalVector| Vector3::from_column_slice(&s.v[vector.first..vector.first + 3]);
        for (a, own) in vectors.iter().enumerate() {
            let mut p = Vector3::zeros();
            for (b, other) in vectors.iter().enumerate() {
                let mass = mass(a, b);
                p += velocity(other) * mass;
                if own.kind == VectorKind::Position {
                    sum.first_moment += other.value * mass;
                    sum.mass += if other.kind == VectorKind::Position { mass } else { 0.0 };
                }
            }
            if own.kind == VectorKind::Position {
                sum.linear += p;
            }
            sum.angular += own.value.cross(&p);
            sum.kinetic += 0.5 * velocity(own).dot(&p);
        }
        sum
    }
}

impl BeamMesh {
    /// Computes the momentum in a state.
    pub fn momentum(&self, s: &State) -> Momentum {
        let vectors: Vec<NodalVector> = self.vectors(s).collect();
        let mut sum = Momentum::default();
        for element in 0..self.count() {
            let first = element * self.stride();
            let own = &vectors[first..first + self.elements.first_moments(element).len()];
            sum += Momentum::of(own, |a, b| self.elements.mass(element, a, b), s);
        }
        sum
    }
}

impl BodyTerms {
    /// Computes the momentum in a state.
    pub fn momentum(&self, s: &State) -> Momentum {
        match self {
            Self::Flexible(mesh) => mesh.momentum(s),
            Self::Shell(mesh) => {
                let mut sum = Momentum::default();
                for (k, element) in mesh.elements().iter().enumerate() {
                    let profile = element.profile();
                    sum += Momentum::of(&mesh.element_vectors(s, k), |a, b| profile.mass(a, b), s);
                }
                sum
            }
            Self::Rigid(body) => {
                let vectors: Vec<NodalVector> = body.vectors(s).collect();
                Momentum::of(&vectors, |a, b| body.mass_entry(a, b), s)
            }
        }
    }
}
