//! Strains and stresses of a shell at any point.

use std::sync::LazyLock;

use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::laminates::to_orthonormal;
use super::mesh::ShellMesh;
use super::prestrain::{Factors, ReferencePoint, SurfaceLaw};
use super::surface_stress::{SurfaceStress, direction, membrane_strain};
use super::thin::{
    MEMBRANE, Shape, VECTORS, VOIGT, bicubic, each_sample, lagrange, sum, surface_derivatives,
};

/// Component and shape derivatives by ξ and η of each membrane strain of an element.
static SAMPLES: LazyLock<Vec<(usize, [Shape; 2])>> = LazyLock::new(|| {
    let mut samples = Vec::with_capacity(MEMBRANE);
    each_sample(|component, [along, across], [i, j]| {
        let at = [along[i], across[j]];
        samples.push((component, [bicubic(at, [1, 0]), bicubic(at, [0, 1])]));
    });
    samples
});

/// Element in a state: its nodal vectors and its membrane strains at the sampling points.
#[derive(Clone, Debug)]
struct ElementStrains {
    /// Reference values and displacements of the nodal vectors.
    vectors: [[Vector3<f64>; VECTORS]; 2],
    membrane: [f64; MEMBRANE],
}

impl ElementStrains {
    fn new(mesh: &ShellMesh, s: &State, element: usize) -> Self {
        let vectors = mesh.reference_and_displacements(s, element);
        let mut membrane = [0.0; MEMBRANE];
        for (strain, (component, shapes)) in membrane.iter_mut().zip(&*SAMPLES) {
            let tangents = vectors.each_ref().map(|x| shapes.each_ref().map(|shape| sum(shape, x)));
            *strain = membrane_strain(tangents)[*component];
        }
        Self { vectors, membrane }
    }

    /// Returns membrane strains and changes of curvature at a point of the element, in the orthonormal frame.
    fn at(&self, at: [f64; 2]) -> [Vector3<f64>; 2] {
        let (mut strain, mut sample) = (Vector3::zeros(), 0);
        each_sample(|component, [along, across], [i, j]| {
            let weight = lagrange(along, i, at[0]) * lagrange(across, j, at[1]);
            strain[component] += weight * self.membrane[sample];
            sample += 1;
        });
        let shapes = surface_derivatives(at);
        let [a, u] = self.vectors.each_ref().map(|x| shapes.each_ref().map(|shape| sum(shape, x)));
        let to_local = to_orthonormal([&a[0], &a[1]], &a[0]);
        [to_local * strain, to_local * curvature(&a, &u)]
    }
}

/// Computes −(b − B) with the factors of [`VOIGT`] from the reference derivatives `a` and those of the displacement `u`, without
/// cancellation.
fn curvature(a: &[Vector3<f64>; 5], u: &[Vector3<f64>; 5]) -> Vector3<f64> {
    let before = a[0].cross(&a[1]);
    let change = u[0].cross(&a[1]) + a[0].cross(&u[1]) + u[0].cross(&u[1]);
    let (rest, area) = (before.norm(), (before + change).norm());
    let stretch = (2.0 * before.dot(&change) + change.dot(&change)) / (area + rest);
    let (normal, turned) = ((before + change) / area, (change - before * (stretch / rest)) / area);
    let of = |k: usize| -VOIGT[k] * (u[k + 2].dot(&normal) + a[k + 2].dot(&turned));
    Vector3::new(of(0), of(1), of(2))
}

/// Stresses of a shell in a state, for evaluation at many points.
#[derive(Clone, Debug)]
pub struct StressField<'a> {
    mesh: &'a ShellMesh,
    elements: Vec<ElementStrains>,
    factors: Factors,
}

impl<'a> StressField<'a> {
    /// Evaluates the strains of all elements in a state.
    pub fn new(mesh: &'a ShellMesh, s: &State) -> Self {
        let elements = (0..mesh.elements().len()).map(|k| ElementStrains::new(mesh, s, k)).collect();
        Self { mesh, elements, factors: mesh.prestrains().factors(s) }
    }

    /// Returns the stresses at (u, v), as [`ShellMesh::stress`].
    pub fn at(&self, at: [f64; 2]) -> SurfaceStress {
        self.mesh.mean_stress(at, &self.factors, |element, local| self.elements[element].at(local))
    }
}

impl ShellMesh {
    /// Returns strains, resultants and stresses at (u, v) in a state, without those of the damping.
    ///
    /// Membrane strains are the interpolated ones of the elements, whose membrane stresses do not lock. They are continuous.
    /// Curvatures are those of the surface. The errors of both fall with the second power of the size of the elements, those of
    /// curvatures faster at (½ ± 1/√12) of the elements. On the edges of elements, strains and curvatures are the means of the adjacent elements.
    pub fn stress(&self, s: &State, at: [f64; 2]) -> SurfaceStress {
        let factors = self.prestrains().factors(s);
        self.mean_stress(at, &factors, |element, local| ElementStrains::new(self, s, element).at(local))
    }

    /// Returns the stresses of the mean strains of all elements at a point.
    fn mean_stress(
        &self,
        at: [f64; 2],
        factors: &Factors,
        strains: impl Fn(usize, [f64; 2]) -> [Vector3<f64>; 2],
    ) -> SurfaceStress {
        let ((element, local), [n, _]) = (self.locate(at), self.divisions());
        let cell = [element % n, element / n];
        let (mut total, mut prescribed, mut count) = ([Vector3::zeros(); 2], [Vector3::zeros(); 2], 0.0);
        for back in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            // A point with ξ = 0 is also on the element before.
            if (0..2).all(|k| back[k] == 0 || (local[k] == 0.0 && cell[k] > 0)) {
                let [i, j] = [cell[0] - back[0], cell[1] - back[1]];
                let own = [0, 1].map(|k| if back[k] == 1 { 1.0 } else { local[k] });
                let element = j * n + i;
                total.iter_mut().zip(strains(element, own)).for_each(|(sum, own)| *sum += own);
                let own = self.prescribed_strains((at, own), element, factors);
                prescribed.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
                count += 1.0;
            }
        }
        let law = self.law_at(element, local);
        let [t, s] = [[1, 0], [0, 1]].map(|order| self.derivative(at, order).reference());
        let turned = |axis| direction([&t, &axis], &t.cross(&s).normalize());
        let direction = law.axis.map_or([1.0, 0.0], turned);
        let [total, prescribed] = [total, prescribed].map(|sum| sum.map(|x| x / count));
        SurfaceStress::new(&law.section, direction, total, prescribed)
    }

    /// Returns the law of the section at a point of an element.
    fn law_at(&self, element: usize, local: [f64; 2]) -> SurfaceLaw {
        let section = self.sections.as_ref().map(|field| field.at(element, local));
        let [t, s] = self.tangents(element, local);
        self.elements()[element].profile().medium.law(section.as_ref(), [&t, &s])
    }

    /// Returns the prescribed strains of an element at (u, v), in the orthonormal frame of stresses.
    fn prescribed_strains(
        &self,
        (at, local): ([f64; 2], [f64; 2]),
        element: usize,
        factors: &Factors,
    ) -> [Vector3<f64>; 2] {
        if factors.is_empty() {
            return [Vector3::zeros(); 2];
        }
        let orders = [[1, 0], [0, 1], [2, 0], [0, 2], [1, 1]];
        let point = ReferencePoint::of_surface(orders.map(|order| self.derivative(at, order).reference()));
        let law = self.law_at(element, local);
        let covariant = self.prestrains().at(element, &law, &point, factors);
        let to_local = to_orthonormal(point.tangents.each_ref(), &point.tangents[0]);
        covariant.map(|strain| to_local * strain)
    }
}
