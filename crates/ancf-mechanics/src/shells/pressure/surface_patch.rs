use std::sync::Arc;

use nalgebra::Vector3;

/// Integration point of a patch: its weight, and the shape functions N, N_ξ, N_η of the N nodal vectors.
#[derive(Clone, Debug)]
pub(super) struct PatchPoint<const N: usize> {
    pub(super) weight: f64,
    pub(super) shapes: [[f64; N]; 3],
}

/// Middle surface of an element as a function of N nodal vectors: r, r_ξ and r_η at the integration points of pressure.
///
/// The points integrate r · (r_ξ × r_η) exactly. A constant pressure on a closed surface then has no resultant.
#[derive(Clone, Debug)]
pub struct SurfacePatch<const N: usize> {
    coordinates: Vec<usize>,
    points: Arc<[PatchPoint<N>]>,
    /// Reference values of r relative to the origin of the patch, r_ξ and r_η at the points.
    reference: Arc<[[Vector3<f64>; 3]]>,
}

/// Bounds of the norms of r, r_ξ and r_η of displaced nodal vectors.
pub(super) type Sizes = [f64; 3];

impl<const N: usize> SurfacePatch<N> {
    /// Creates a patch with the first coordinate and the reference value of each nodal vector.
    pub(super) fn new(
        firsts: [usize; N],
        reference: &[Vector3<f64>; N],
        points: Arc<[PatchPoint<N>]>,
    ) -> Self {
        let at = |point: &PatchPoint<N>| point.shapes.each_ref().map(|shape| sum(shape, reference));
        Self {
            coordinates: firsts.iter().flat_map(|first| *first..first + 3).collect(),
            reference: points.iter().map(at).collect(),
            points,
        }
    }

    /// Returns the coordinates of the nodal vectors.
    pub(super) fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    /// Calls `visit` with the shape functions, the weight, and r, r_ξ and r_η of each point.
    pub(super) fn each(&self, q: &[f64], mut visit: impl FnMut(&[[f64; N]; 3], f64, [Vector3<f64>; 3])) {
        let q = vectors(q);
        for (PatchPoint { shapes, weight }, reference) in self.points.iter().zip(&*self.reference) {
            visit(shapes, *weight, std::array::from_fn(|k| reference[k] + sum(&shapes[k], &q)));
        }
    }

    /// Calls `visit` with the shape functions, the weight, and the values of another vector field at each point.
    pub(super) fn each_with(
        &self,
        q: &[f64],
        field: &[f64],
        mut visit: impl FnMut(f64, [Vector3<f64>; 3], [Vector3<f64>; 3]),
    ) {
        let field = vectors::<N>(field);
        self.each(q, |shapes, weight, surface| {
            visit(weight, surface, shapes.each_ref().map(|shape| sum(shape, &field)));
        });
    }

    /// Calls `visit` with the shape functions, the weight and the sizes of the summands of r, r_ξ and r_η of each point.
    pub(super) fn each_size(&self, q: &[f64], mut visit: impl FnMut(&[[f64; N]; 3], f64, Sizes)) {
        let q = vectors::<N>(q);
        for (PatchPoint { shapes, weight }, reference) in self.points.iter().zip(&*self.reference) {
            let size = |k: usize| -> f64 {
                let moved: f64 = shapes[k].iter().zip(&q).map(|(n, q)| n.abs() * q.norm()).sum();
                reference[k].norm() + moved
            };
            visit(shapes, *weight, [0, 1, 2].map(size));
        }
    }
}

fn vectors<const N: usize>(x: &[f64]) -> [Vector3<f64>; N] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

fn sum<const N: usize>(shape: &[f64; N], x: &[Vector3<f64>; N]) -> Vector3<f64> {
    shape.iter().zip(x).map(|(shape, x)| x * *shape).sum()
}
