//! Strains and stresses of a shear-deformable shell at any point.

use ancf_solver::equations::State;
use nalgebra::{DVector, Vector3};

use super::any_element::ElementData;
use super::faces::{NODES, Shape};
use super::mesh::{ShearShellMesh, SurfacePlace};
use super::strains::SURFACE;
use crate::shells::laminates::to_orthonormal;
use crate::shells::prestrain::Factors;
use crate::shells::surface_stress::{PointStrains, SurfaceStrains, SurfaceStress, direction};

/// Strains of an element at its nodes, extrapolated from four integration points, or constant.
type NodalStrains = [SurfaceStrains; NODES];

/// Stresses of a shear-deformable shell in a state, for evaluation at many points.
#[derive(Clone, Debug)]
pub struct ShearStressField<'a> {
    mesh: &'a ShearShellMesh,
    elements: Vec<[NodalStrains; 2]>,
    factors: Factors,
}

/// Computes the strains at the integration points, and their rates times the retardation time, and extrapolates them to the nodes.
///
/// Membrane strains of an element with a law of the membrane are those at the nodes: extrapolated ones could be below -½, which no
/// deformation has.
fn strains(mesh: &ShearShellMesh, s: &State, element: usize) -> [NodalStrains; 2] {
    let (shape, data) = (mesh.faces()[element].shape(), mesh.elements()[element].data());
    let moved = mesh.displacements(s, element);
    let total =
        extrapolated(shape, data, &data.surface_strains(&moved), |at| data.membrane_strain(at, &moved));
    let time = data.medium().retardation;
    if time == 0.0 {
        return [total, NodalStrains::default()];
    }
    let mut rates = mesh.vectors_in(&s.v, element);
    rates.iter_mut().for_each(|rate| *rate *= time);
    let of_surface = data.surface_rates(&moved, &rates);
    [total, extrapolated(shape, data, &of_surface, |at| data.membrane_rate(at, &moved, &rates))]
}

/// Extrapolates strains from the integration points to the nodes. `at_node` returns the membrane strain at a node.
fn extrapolated(
    shape: Shape,
    data: &dyn ElementData,
    strains: &DVector<f64>,
    at_node: impl Fn([f64; 2]) -> Vector3<f64>,
) -> NodalStrains {
    let to_local = |at: [f64; 2]| {
        let [t, s] = data.tangents(at);
        to_orthonormal([&t, &s], &data.medium().axis)
    };
    let at_point = |k: usize| {
        let to_local = to_local(shape.surface_points()[k].0);
        [0, 3].map(|kind| to_local * strains.fixed_rows::<3>(SURFACE * k + kind))
    };
    let has_law = data.medium().section.surface.law.is_some();
    match shape {
        Shape::Triangle => [at_point(0); NODES],
        Shape::Quad => {
            let (low, high) = (shape.surface_points()[0].0[0], shape.surface_points()[1].0[0]);
            // Integration points are numbered along ξ first, nodes around the element.
            let values = [0, 1, 3, 2].map(at_point);
            std::array::from_fn(|a| {
                let corner = shape.corners()[a];
                let [membrane, bending] =
                    weighted(&shape.values(corner.map(|x| (x - low) / (high - low)))[0], &values);
                let at_corner = || to_local(corner) * at_node(corner);
                [if has_law { at_corner() } else { membrane }, bending]
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
        Self { mesh, elements, factors: mesh.prestrains().factors(s) }
    }

    /// Returns the stresses at a place, as [`ShearShellMesh::stress`].
    pub fn at(&self, place: SurfacePlace) -> SurfaceStress {
        self.mesh.mean_stress(place, &self.factors, |element| self.elements[element])
    }
}

impl ShearShellMesh {
    /// Returns strains, resultants and stresses at a place in a state.
    ///
    /// Strains are extrapolated from the integration points. At a node they are the means of the elements there, in the
    /// orthonormal frame whose first direction is the projection of the axis of the whole shell.
    pub fn stress(&self, s: &State, place: SurfacePlace) -> SurfaceStress {
        let factors = self.prestrains().factors(s);
        self.mean_stress(place, &factors, |element| strains(self, s, element))
    }

    fn mean_stress(
        &self,
        place: SurfacePlace,
        factors: &Factors,
        of: impl Fn(usize) -> [NodalStrains; 2],
    ) -> SurfaceStress {
        let mut mean = PointStrains::default();
        let mut add = |place: SurfacePlace, share: f64| {
            let weights = self.faces()[place.element].weights(place.at);
            let own = of(place.element).map(|strains| weighted(&weights, &strains));
            mean.add(share, &own, &self.prescribed_strains(place, factors));
        };
        match self.node_at(place) {
            Some(node) => {
                let own = self.at_node(node);
                let share = 1.0 / own.len() as f64;
                for &element in own {
                    let at = self.faces()[element].place_of(node).expect("an element at a node has it");
                    add(SurfacePlace { element, at }, share);
                }
            }
            None => add(place, 1.0),
        }
        let law = self.law_at(place);
        SurfaceStress::new(&law.section, self.direction_of(law.axis, place), mean)
    }

    /// Returns cosine and sine of the angle about the normal from the first direction of stresses to the projection of an axis.
    fn direction_of(&self, axis: Option<Vector3<f64>>, place: SurfacePlace) -> [f64; 2] {
        let data = self.elements()[place.element].data();
        let whole = data.medium().axis;
        match axis {
            Some(axis) if axis != whole => {
                let [t, s] = data.tangents(place.at);
                direction([&whole, &axis], &t.cross(&s).normalize())
            }
            _ => [1.0, 0.0],
        }
    }

    /// Returns the prescribed strains at a place, in the orthonormal frame of stresses, and their rates times the retardation time.
    fn prescribed_strains(&self, place: SurfacePlace, factors: &Factors) -> [SurfaceStrains; 2] {
        if factors.is_empty() {
            return [[Vector3::zeros(); 2]; 2];
        }
        let data = self.elements()[place.element].data();
        let (point, law) = (data.reference_point(place.at), self.law_at(place));
        let covariant = self.prestrains().at(place.element, &law, &point, factors);
        let to_local = to_orthonormal(point.tangents.each_ref(), &data.medium().axis);
        let [strains, rates] = covariant.map(|part| part.map(|strain| to_local * strain));
        [strains, rates.map(|rate| rate * data.medium().retardation)]
    }
}
