//! Strains and stresses of a shear-deformable shell at any point.

use ancf_solver::equations::State;
use nalgebra::{SMatrix, Vector3};

use super::forms::{CORNERS, QUAD_POINTS, SURFACE, bilinear, points};
use super::mesh::{ShearShellMesh, SurfacePlace};
use super::profile::tangents;
use crate::shells::laminates::to_orthonormal;
use crate::shells::surface_stress::SurfaceStress;

/// Strains of the surface at the integration points of an element, in the orthonormal frame there.
type PointStrains = SMatrix<f64, SURFACE, 1>;

/// Stresses of a shear-deformable shell in a state, for evaluation at many points.
#[derive(Clone, Debug)]
pub struct ShearStressField<'a> {
    mesh: &'a ShearShellMesh,
    elements: Vec<PointStrains>,
}

fn strains(mesh: &ShearShellMesh, s: &State, element: usize) -> PointStrains {
    let own = &mesh.elements()[element];
    let mut strains = own.profile().enhanced(&own.strains(&mesh.displacements(s, element)));
    for (k, (at, _)) in points().into_iter().enumerate() {
        let ([t, s], _) = tangents(at, &own.profile().reference);
        let to_local = to_orthonormal([&t, &s], &own.profile().medium.axis);
        for kind in [0, 3] {
            let local = to_local * strains.fixed_rows::<3>(6 * k + kind);
            strains.fixed_rows_mut::<3>(6 * k + kind).copy_from(&local);
        }
    }
    strains
}

/// Bilinear extrapolation of the values at the integration points to a point of the element.
fn extrapolated(strains: &PointStrains, at: [f64; 2]) -> [Vector3<f64>; 2] {
    let [([low, _], _), ([high, _], _), ..] = points();
    let local = at.map(|x| (x - low) / (high - low));
    let [shape, ..] = bilinear(local);
    // Integration points are numbered along ξ first, nodes around the element.
    let order = [0, 1, 3, 2];
    [0, 3].map(|kind| {
        (0..QUAD_POINTS)
            .map(|a| strains.fixed_rows::<3>(6 * order[a] + kind) * shape[a])
            .sum::<Vector3<f64>>()
    })
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

    fn mean_stress(&self, place: SurfacePlace, of: impl Fn(usize) -> PointStrains) -> SurfaceStress {
        let local = |SurfacePlace { element, at }: SurfacePlace| extrapolated(&of(element), at);
        let places: Vec<SurfacePlace> = match self.node_at(place) {
            Some(node) => {
                let corner = |k: usize| self.quads()[k].iter().position(|n| *n == node).unwrap_or(0);
                self.at_node(node)
                    .iter()
                    .map(|&element| SurfacePlace { element, at: CORNERS[corner(element)] })
                    .collect()
            }
            None => vec![place],
        };
        let count = places.len() as f64;
        let sum = places.into_iter().map(local).fold([Vector3::zeros(); 2], |[a, b], [c, d]| [a + c, b + d]);
        let section = &self.elements()[place.element].profile().medium.section.surface;
        SurfaceStress::new(section, [1.0, 0.0], sum[0] / count, sum[1] / count)
    }
}
