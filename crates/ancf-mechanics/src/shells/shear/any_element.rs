//! Elements of all shapes.

use std::sync::Arc;

use ancf_solver::equations::Term;
use nalgebra::{DVector, Vector3};

use super::ShearMedium;
use super::element::{ShearElement, Shell18, Shell24};
use super::faces::{NODES, Shape};
use super::profile::{reference_point, tangents};
use super::strains::{ShearTables, Vectors};
use crate::shells::laminates::SectionField;
use crate::shells::prestrain::{ElementPrestrain, ReferencePoint, SurfacePrestrain};
use crate::shells::surface_stress::{membrane_rate, membrane_strain};

/// Element of a mesh: a quadrilateral or a triangle.
#[derive(Clone, Debug)]
pub(crate) enum AnyElement {
    Quad(Shell24),
    Triangle(Shell18),
}

/// Data of an element that do not depend on its number of nodes.
pub(crate) trait ElementData {
    /// Returns the material, inertia and loads.
    fn medium(&self) -> &ShearMedium;
    /// Returns an entry of the compact mass matrix of the vectors r₁, d₁, r₂, d₂, ..
    fn mass(&self, a: usize, b: usize) -> f64;
    /// Returns the first moments of the mass for the vectors r₁, d₁, r₂, d₂, ..
    fn first_moments(&self) -> &[f64];
    /// Returns ∫ N_a dA for the nodes.
    fn areas(&self) -> [f64; NODES];
    /// Returns the tangents of the reference surface at a point.
    fn tangents(&self, at: [f64; 2]) -> [Vector3<f64>; 2];
    /// Returns a point of the reference surface.
    fn reference_point(&self, at: [f64; 2]) -> ReferencePoint;
    /// Returns the strain energy for displacements of the nodal vectors.
    fn strain_energy(&self, u: &[Vector3<f64>]) -> f64;
    /// Returns the strains of the surface with the enhanced ones, at its integration points, for displacements of the nodal
    /// vectors.
    fn surface_strains(&self, u: &[Vector3<f64>]) -> DVector<f64>;
    /// Returns the rates of these strains, for displacements and velocities of the nodal vectors.
    fn surface_rates(&self, u: &[Vector3<f64>], v: &[Vector3<f64>]) -> DVector<f64>;
    /// Returns the rate of the membrane strain at a point without enhanced strains.
    fn membrane_rate(&self, at: [f64; 2], u: &[Vector3<f64>], v: &[Vector3<f64>]) -> Vector3<f64>;
    /// Returns the membrane strain (ξξ, ηη, 2 ξη) at a point without enhanced strains, for displacements of the nodal vectors.
    fn membrane_strain(&self, at: [f64; 2], u: &[Vector3<f64>]) -> Vector3<f64>;
}

impl<const V: usize, const S: usize, const C: usize> ElementData for ShearElement<V, S, C> {
    fn medium(&self) -> &ShearMedium {
        &self.profile.medium
    }

    fn mass(&self, a: usize, b: usize) -> f64 {
        self.profile.mass[a][b]
    }

    fn first_moments(&self) -> &[f64] {
        &self.profile.first
    }

    fn areas(&self) -> [f64; NODES] {
        let (shape, mut areas) = (self.profile.shape, [0.0; NODES]);
        for (at, weight) in shape.points() {
            let ([weights, ..], (_, area)) =
                (shape.values(*at), tangents(shape, *at, &self.profile.reference));
            areas.iter_mut().zip(weights).for_each(|(sum, own)| *sum += weight * area * own);
        }
        areas
    }

    fn tangents(&self, at: [f64; 2]) -> [Vector3<f64>; 2] {
        tangents(self.profile.shape, at, &self.profile.reference).0
    }

    fn reference_point(&self, at: [f64; 2]) -> ReferencePoint {
        reference_point(self.profile.shape, at, &self.profile.reference)
    }

    fn strain_energy(&self, u: &[Vector3<f64>]) -> f64 {
        self.strain_energy(&vectors(u))
    }

    fn surface_strains(&self, u: &[Vector3<f64>]) -> DVector<f64> {
        self.profile.enhanced(&self.strains(&vectors(u)))
    }

    fn surface_rates(&self, u: &[Vector3<f64>], v: &[Vector3<f64>]) -> DVector<f64> {
        self.profile.enhanced(&self.strain_rates(&vectors(u), &vectors(v)))
    }

    fn membrane_rate(&self, at: [f64; 2], u: &[Vector3<f64>], v: &[Vector3<f64>]) -> Vector3<f64> {
        let (rest, shape) = (self.tangents(at), self.profile.shape);
        let moved = tangents(shape, at, u).0;
        membrane_rate([[rest[0] + moved[0], rest[1] + moved[1]], tangents(shape, at, v).0])
    }

    fn membrane_strain(&self, at: [f64; 2], u: &[Vector3<f64>]) -> Vector3<f64> {
        membrane_strain([self.tangents(at), tangents(self.profile.shape, at, u).0])
    }
}

/// Returns nodal vectors as an array.
fn vectors<const V: usize>(u: &[Vector3<f64>]) -> Vectors<V> {
    std::array::from_fn(|a| u[a])
}

impl AnyElement {
    /// Creates elements with common tables of strains, from their coordinates and nodal vectors r₁, d₁, r₂, d₂, .. in the reference
    /// state. Positions are relative to any point. Sections vary if there is a field of them.
    pub(crate) fn all(
        elements: impl IntoIterator<Item = (Vec<usize>, Vec<Vector3<f64>>)>,
        medium: &ShearMedium,
        sections: Option<&SectionField>,
    ) -> Vec<Self> {
        let (quads, triangles) =
            (Arc::new(ShearTables::new(Shape::Quad)), Arc::new(ShearTables::new(Shape::Triangle)));
        let element = |(k, (coordinates, reference)): (usize, (Vec<usize>, Vec<Vector3<f64>>))| {
            let shape = if reference.len() == 6 { Shape::Triangle } else { Shape::Quad };
            let own = (medium, SectionField::of_element(sections, k, || shape.section_places()));
            match shape {
                Shape::Triangle => {
                    Self::Triangle(Shell18::new(coordinates, &vectors(&reference), &triangles, own))
                }
                Shape::Quad => Self::Quad(Shell24::new(coordinates, &vectors(&reference), &quads, own)),
            }
        };
        elements.into_iter().enumerate().map(element).collect()
    }

    /// Returns the element as a term.
    pub(crate) fn term(&self) -> Box<dyn Term> {
        match self {
            Self::Quad(element) => Box::new(element.clone()),
            Self::Triangle(element) => Box::new(element.clone()),
        }
    }

    /// Creates the term of the prescribed strains of the element.
    pub(crate) fn prestrained(&self, sources: Vec<SurfacePrestrain>) -> ElementPrestrain {
        match self {
            Self::Quad(element) => ElementPrestrain::new(element, sources),
            Self::Triangle(element) => ElementPrestrain::new(element, sources),
        }
    }

    pub(crate) fn data(&self) -> &dyn ElementData {
        match self {
            Self::Quad(element) => element,
            Self::Triangle(element) => element,
        }
    }
}
