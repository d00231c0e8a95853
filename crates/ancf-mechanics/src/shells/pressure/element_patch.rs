use std::sync::{Arc, LazyLock};

use ancf_solver::equations::{LOCAL, Term};
use nalgebra::Vector3;

use super::surface_patch::{PatchPoint, SurfacePatch};
use super::surface_pressure::SurfacePressure;
use crate::functions::Function;
use crate::kinematics::gauss;
use crate::shells::mesh::ShellMesh;
use crate::shells::shear::{Face, Shape, ShearShellMesh};
use crate::shells::thin::{VECTORS, bicubic};

/// Middle surface of an element of either kind of shell.
#[derive(Clone, Debug)]
pub enum ElementPatch {
    /// Bicubic surface of a thin shell.
    Thin(SurfacePatch<VECTORS>),
    /// Triangle of a shear-deformable shell.
    Triangle(SurfacePatch<3>),
    /// Quadrilateral of a shear-deformable shell.
    Quad(SurfacePatch<4>),
}

/// Integrals over a patch in the reference state.
#[derive(Clone, Copy, Debug, Default)]
pub struct PatchMeasures {
    /// ⅓ ∫ r · n dA, with r relative to the origin of the patch.
    pub volume: f64,
    /// ∫ n dA.
    pub normal: Vector3<f64>,
    /// ∫ dA.
    pub area: f64,
}

/// Points of bicubic patches. The integrand of the volume has degree eight in each direction.
static BICUBIC: LazyLock<Arc<[PatchPoint<VECTORS>]>> = LazyLock::new(|| {
    let points = gauss().into_iter().flat_map(|(y, of_y)| gauss().map(|(x, of_x)| ([x, y], of_x * of_y)));
    let point =
        |(at, weight)| PatchPoint { weight, shapes: [[0, 0], [1, 0], [0, 1]].map(|k| bicubic(at, k)) };
    points.map(point).collect()
});

static QUAD: LazyLock<Arc<[PatchPoint<4>]>> = LazyLock::new(|| face_points(Shape::Quad));
static TRIANGLE: LazyLock<Arc<[PatchPoint<3>]>> = LazyLock::new(|| face_points(Shape::Triangle));

/// Points of the faces of shear-deformable shells, with N nodes.
fn face_points<const N: usize>(shape: Shape) -> Arc<[PatchPoint<N>]> {
    let point = |(at, weight): &([f64; 2], f64)| {
        let shapes = shape.values(*at).map(|values| std::array::from_fn(|a| values[a]));
        PatchPoint { weight: *weight, shapes }
    };
    shape.points().iter().map(point).collect()
}

impl ElementPatch {
    /// Creates the patch of an element of a thin shell, with positions relative to `origin`.
    pub fn thin(mesh: &ShellMesh, element: usize, origin: Vector3<f64>) -> Self {
        let vectors = mesh.patch_vectors(element);
        let reference = std::array::from_fn(|a| {
            let (_, reference) = vectors[a];
            if a.is_multiple_of(4) { reference - origin } else { reference }
        });
        Self::Thin(SurfacePatch::new(vectors.map(|(first, _)| first), &reference, Arc::clone(&BICUBIC)))
    }

    /// Creates the patch of an element of a shear-deformable shell, with positions relative to `origin`.
    pub fn face(mesh: &ShearShellMesh, element: usize, origin: Vector3<f64>) -> Self {
        let of = |node: usize| mesh.nodal(node, 0);
        match mesh.faces()[element] {
            Face::Triangle(nodes) => Self::Triangle(SurfacePatch::new(
                nodes.map(|node| of(node).0),
                &nodes.map(|node| of(node).1 - origin),
                Arc::clone(&TRIANGLE),
            )),
            Face::Quad(nodes) => Self::Quad(SurfacePatch::new(
                nodes.map(|node| of(node).0),
                &nodes.map(|node| of(node).1 - origin),
                Arc::clone(&QUAD),
            )),
        }
    }

    /// Returns a pressure on the patch that follows its normal, times a function of time.
    pub fn pressure(self, pressure: f64, function: &Function) -> Box<dyn Term> {
        match self {
            Self::Thin(patch) => Box::new(SurfacePressure::new(patch, pressure, function)),
            Self::Triangle(patch) => Box::new(SurfacePressure::new(patch, pressure, function)),
            Self::Quad(patch) => Box::new(SurfacePressure::new(patch, pressure, function)),
        }
    }

    /// Returns integrals over the patch in the reference state.
    pub fn measures(&self) -> PatchMeasures {
        match self {
            Self::Thin(patch) => measures(patch),
            Self::Triangle(patch) => measures(patch),
            Self::Quad(patch) => measures(patch),
        }
    }
}

fn measures<const N: usize>(patch: &SurfacePatch<N>) -> PatchMeasures {
    let mut sum = PatchMeasures::default();
    patch.each(&[0.0; LOCAL], |_, weight, [r, t, s]| {
        let normal = t.cross(&s) * weight;
        sum.volume += r.dot(&normal) / 3.0;
        sum.normal += normal;
        sum.area += normal.norm();
    });
    sum
}
