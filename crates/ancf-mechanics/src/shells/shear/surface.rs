use nalgebra::{Matrix2, Vector2, Vector3};

use super::forms::{NODES, bilinear};
use super::mesh::SurfacePlace;

/// Iterations of the projection on an element.
const ITERATIONS: usize = 20;

/// Point of a mesh of quadrilaterals nearest to a given point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPoint {
    /// Place on the mesh.
    pub place: SurfacePlace,
    /// Distance from the given point.
    pub distance: f64,
}

/// Sum of the nodes with the weights of a shape function.
fn sum(shape: &[f64; NODES], x: &[Vector3<f64>; NODES]) -> Vector3<f64> {
    (0..NODES).map(|a| x[a] * shape[a]).sum()
}

/// Projects a point on a bilinear element, by Newton's method with ξ and η in the unit square.
fn project(point: &Vector3<f64>, x: &[Vector3<f64>; NODES]) -> ([f64; 2], f64) {
    let twist = x[0] - x[1] + x[2] - x[3];
    let mut at = Vector2::new(0.5, 0.5);
    for _ in 0..ITERATIONS {
        let [n, of_x, of_y] = bilinear([at.x, at.y]);
        let (gap, t, s) = (sum(&n, x) - point, sum(&of_x, x), sum(&of_y, x));
        let mixed = t.dot(&s) + gap.dot(&twist);
        let (hessian, gradient) =
            (Matrix2::new(t.dot(&t), mixed, mixed, s.dot(&s)), Vector2::new(gap.dot(&t), gap.dot(&s)));
        let gauss = Matrix2::new(t.dot(&t), t.dot(&s), t.dot(&s), s.dot(&s));
        let matrix = if hessian.determinant() > 0.1 * gauss.determinant() { hessian } else { gauss };
        let Some(inverse) = matrix.try_inverse() else { break };
        let mut step = -(inverse * gradient);
        // At a bound, the free direction alone is minimised.
        for i in 0..2 {
            if (at[i] <= 0.0 && step[i] < 0.0) || (at[i] >= 1.0 && step[i] > 0.0) {
                step[i] = 0.0;
                step[1 - i] = -gradient[1 - i] / matrix[(1 - i, 1 - i)];
            }
        }
        let next = (at + step).map(|x| x.clamp(0.0, 1.0));
        let change = (next - at).amax();
        at = next;
        if change < 1e-15 {
            break;
        }
    }
    let [n, ..] = bilinear([at.x, at.y]);
    ([at.x, at.y], (sum(&n, x) - point).norm())
}

impl NearestPoint {
    /// Finds the nearest point of a mesh. `None` for a mesh without elements.
    pub fn of(nodes: &[Vector3<f64>], elements: &[[usize; NODES]], point: &Vector3<f64>) -> Option<Self> {
        let mut best: Option<Self> = None;
        for (element, own) in elements.iter().enumerate() {
            let x = own.map(|node| nodes[node]);
            let middle = x.iter().sum::<Vector3<f64>>() * 0.25;
            let radius = x.iter().map(|x| (x - middle).norm()).fold(0.0, f64::max);
            if best.is_some_and(|best| (point - middle).norm() - radius > best.distance) {
                continue;
            }
            let (at, distance) = project(point, &x);
            if best.is_none_or(|best| distance < best.distance) {
                best = Some(Self { place: SurfacePlace { element, at: at.map(snapped) }, distance });
            }
        }
        best
    }
}

/// Distance from an edge of the unit square that counts as rounding.
const ON_EDGE: f64 = 1e-9;

/// Rounds a coordinate of the unit square to 0 or 1 if it is nearly there.
fn snapped(x: f64) -> f64 {
    if x < ON_EDGE {
        0.0
    } else if x > 1.0 - ON_EDGE {
        1.0
    } else {
        x
    }
}
