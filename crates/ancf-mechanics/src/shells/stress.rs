//! Strains and stresses of a shell at any point.

use std::sync::LazyLock;

use ancf_solver::equations::State;
use nalgebra::Vector3;
use smallvec::SmallVec;

use super::laminates::to_orthonormal;
use super::mesh::ShellMesh;
use super::prestrain::{Factors, ReferencePoint, SurfaceLaw};
use super::surface_stress::{
    PointStrains, SurfaceStrains, SurfaceStress, direction, membrane_rate, membrane_strain,
};
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
    /// Reference values and displacements of the nodal vectors, and their velocities times the retardation time.
    vectors: [[Vector3<f64>; VECTORS]; 3],
    /// Strains, and their rates times the retardation time.
    membrane: [[f64; MEMBRANE]; 2],
}

impl ElementStrains {
    fn new(mesh: &ShellMesh, s: &State, element: usize) -> Self {
        let [reference, moved] = mesh.reference_and_displacements(s, element);
        let time = mesh.elements()[element].profile().medium.retardation;
        let retarded = match time {
            0.0 => [Vector3::zeros(); VECTORS],
            _ => mesh.vectors_in(&s.v, element).map(|v| v * time),
        };
        let vectors = [reference, moved, retarded];
        let mut membrane = [[0.0; MEMBRANE]; 2];
        for (k, (component, shapes)) in SAMPLES.iter().enumerate() {
            let [a, u, v] = vectors.each_ref().map(|x| shapes.each_ref().map(|shape| sum(shape, x)));
            membrane[0][k] = membrane_strain([a, u])[*component];
            membrane[1][k] = membrane_rate([[a[0] + u[0], a[1] + u[1]], v])[*component];
        }
        Self { vectors, membrane }
    }

    /// Returns membrane strains and changes of curvature at a point of the element, in the orthonormal frame, and their rates times the
    /// retardation time.
    fn at(&self, at: [f64; 2]) -> [SurfaceStrains; 2] {
        let (mut strains, mut sample) = ([Vector3::zeros(); 2], 0);
        each_sample(|component, [along, across], [i, j]| {
            let weight = lagrange(along, i, at[0]) * lagrange(across, j, at[1]);
            for (strain, membrane) in strains.iter_mut().zip(&self.membrane) {
                strain[component] += weight * membrane[sample];
            }
            sample += 1;
        });
        let shapes = surface_derivatives(at);
        let [a, u, v] = self.vectors.each_ref().map(|x| shapes.each_ref().map(|shape| sum(shape, x)));
        let to_local = to_orthonormal([&a[0], &a[1]], &a[0]);
        let curvatures = [curvature(&a, &u), curvature_rate(&std::array::from_fn(|k| a[k] + u[k]), &v)];
        [0, 1].map(|k| [to_local * strains[k], to_local * curvatures[k]])
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

/// Computes the rate of −b with the factors of [`VOIGT`] from the derivatives of the surface and their rates. The normal turns at the
/// rate (I − n nᵀ)(ṙ_ξ × r_η + r_ξ × ṙ_η)/|r_ξ × r_η|.
fn curvature_rate(r: &[Vector3<f64>; 5], v: &[Vector3<f64>; 5]) -> Vector3<f64> {
    let cross = r[0].cross(&r[1]);
    let area = cross.norm();
    let (normal, change) = (cross / area, (v[0].cross(&r[1]) + r[0].cross(&v[1])) / area);
    let turning = change - normal * normal.dot(&change);
    let of = |k: usize| -VOIGT[k] * (v[k + 2].dot(&normal) + r[k + 2].dot(&turning));
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
    /// Returns strains, resultants and stresses at (u, v) in a state.
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
        strains: impl Fn(usize, [f64; 2]) -> [SurfaceStrains; 2],
    ) -> SurfaceStress {
        let ((element, local), [n, _]) = (self.locate(at), self.divisions());
        let cell = [element % n, element / n];
        let mut elements = SmallVec::<[(usize, [f64; 2]); 4]>::new();
        for back in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            // A point with ξ = 0 is also on the element before.
            if (0..2).all(|k| back[k] == 0 || (local[k] == 0.0 && cell[k] > 0)) {
                let [i, j] = [cell[0] - back[0], cell[1] - back[1]];
                let own = [0, 1].map(|k| if back[k] == 1 { 1.0 } else { local[k] });
                elements.push((j * n + i, own));
            }
        }
        let (mut mean, share) = (PointStrains::default(), 1.0 / elements.len() as f64);
        for (element, own) in elements {
            mean.add(share, &strains(element, own), &self.prescribed_strains((at, own), element, factors));
        }
        let law = self.law_at(element, local);
        let [t, s] = [[1, 0], [0, 1]].map(|order| self.derivative(at, order).reference());
        let turned = |axis| direction([&t, &axis], &t.cross(&s).normalize());
        let direction = law.axis.map_or([1.0, 0.0], turned);
        SurfaceStress::new(&law.section, direction, mean)
    }

    /// Returns the law of the section at a point of an element.
    fn law_at(&self, element: usize, local: [f64; 2]) -> SurfaceLaw {
        let section = self.sections.as_ref().map(|field| field.at(element, local));
        let [t, s] = self.tangents(element, local);
        self.elements()[element].profile().medium.law(section.as_ref(), [&t, &s])
    }

    /// Returns the prescribed strains of an element at (u, v), in the orthonormal frame of stresses, and their rates times the retardation
    /// time.
    fn prescribed_strains(
        &self,
        (at, local): ([f64; 2], [f64; 2]),
        element: usize,
        factors: &Factors,
    ) -> [SurfaceStrains; 2] {
        if factors.is_empty() {
            return [[Vector3::zeros(); 2]; 2];
        }
        let orders = [[1, 0], [0, 1], [2, 0], [0, 2], [1, 1]];
        let point = ReferencePoint::of_surface(orders.map(|order| self.derivative(at, order).reference()));
        let law = self.law_at(element, local);
        let covariant = self.prestrains().at(element, &law, &point, factors);
        let to_local = to_orthonormal(point.tangents.each_ref(), &point.tangents[0]);
        let time = self.elements()[element].profile().medium.retardation;
        let [strains, rates] = covariant.map(|part| part.map(|strain| to_local * strain));
        [strains, rates.map(|rate| rate * time)]
    }
}
