//! Strains and stresses of a shear-deformable shell at any point.

use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::face::{NODES, Shape};
use super::forms::SURFACE;
use super::mesh::{ShearShellMesh, SurfacePlace};
use crate::shells::laminates::to_orthonormal;
use crate::shells::surface_stress::SurfaceStress;

/// Membrane strains and curvatures of the surface, in an orthonormal frame.
type SurfaceStrains = [Vector3<f64>; 2];

/// Strains of an element at its nodes: extrapolated from four integration points, or constant.
type NodalStrains = [SurfaceStrains; NODES];

/// Stresses of a shear-deformable shell in a state, for evaluation at many points.
#[derive(Clone, Debug)]
pub struct ShearStressField<'a> {
    mesh: &'a ShearShellMesh,
    elements: Vec<NodalStrains>,
}

/// Computes the strains at the integration points, and extrapolates them to the nodes.
fn strains(mesh: &ShearShellMesh, s: &State, element: usize) -> NodalStrains {
    let (shape, data) = (mesh.faces()[element].shape(), mesh.elements()[element].data());
    let strains = data.surface_strains(&mesh.displacements(s, element));
    let at_point = |k: usize| {
        let [t, s] = data.tangents(shape.surface_points()[k].0);
        let to_local = to_orthonormal([&t, &s], &data.medium().axis);
        [0, 3].map(|kind| to_local * strains.fixed_rows::<3>(SURFACE * k + kind))
    };
    match shape {
        Shape::Triangle => [at_point(0); NODES],
        Shape::Quad => {
            let (low, high) = (shape.surface_points()[0].0[0], shape.surface_points()[1].0[0]);
            // Integration points are numbered along ξ first, nodes around the element.
            let values = [0, 1, 3, 2].map(at_point);
            std::array::from_fn(|a| {
                let local = shape.corners()[a].map(|x| (x - low) / (high - low));
                weighted(&shape.values(local)[0], &values)
            })
        }
    }
}

fn weighted(weights: &[f64; NODES], values: &NodalStrains) -> SurfaceStrains {
    [0, 1].map(|kind| weights.iter().zip(values).map(|(w, value)| value[kind] * *w).sum())
}

impl<'a> ShearStressField<'a> {
    /// Evaluates the strains of all elements in a state.
    pub fn new(mesh: &'a ShearShellMesh, s: &State) -> Self {
        let elements = (0..mesh.elements().len()).map(|k| strains(mesh, s, k)).collect();
        Self { mesh, elements }
    }

    /// Returns the stresses at a place, as [`ShearShellMesh::stress`].
    pub fn at(&self, place: SurfacePlace) -> SurfaceStress {
        self.mesh.mean_stress(place, |element| self.elements[element])
    }
}

impl ShearShellMesh {
    /// Returns strains, resultants and stresses at a place in a state, without those of the damping.
    ///
    /// Strains are extrapolated from the integration points. At a node they are the means of the elements there, in the
    /// orthonormal frame whose first direction is the projection of the axis of the section.
    pub fn stress(&self, s: &State, place: SurfacePlace) -> SurfaceStress {
        self.mean_stress(place, |element| strains(self, s, element))
    }

    fn mean_stress(&self, place: SurfacePlace, of: impl Fn(usize) -> NodalStrains) -> SurfaceStress {
        let [mut membrane, mut bending] = [Vector3::zeros(); 2];
        let mut add = |element: usize, at: [f64; 2], share: f64| {
            let [own, curvature] = weighted(&self.faces()[element].weights(at), &of(element));
            membrane += own * share;
            bending += curvature * share;
        };
        match self.node_at(place) {
            Some(node) => {
                let own = self.at_node(node);
                let share = 1.0 / own.len() as f64;
                let at = |element: usize| self.faces()[element].place_of(node).unwrap_or_default();
                own.iter().for_each(|&element| add(element, at(element), share));
            }
            None => add(place.element, place.at, 1.0),
        }
        let section = &self.elements()[place.element].data().medium().section.surface;
        SurfaceStress::new(section, [1.0, 0.0], membrane, bending)
    }
}
