use nalgebra::{Matrix2, Vector2, Vector3};

/// Values of r, r_ξ, r_η, r_ξξ, r_ηη and r_ξη.
pub(crate) type SurfaceValues = [Vector3<f64>; 6];

const ITERATIONS: usize = 40;
/// Increment below which the next increment of Newton's method is a rounding error.
const QUADRATIC: f64 = 1e-9;
/// Part of the metric above which the second derivative of the squared distance is used. The iteration is Newton's method then.
pub(crate) const CONVEX: f64 = 0.1;
/// Increment of Newton's method below which the distance is not compared, since it decreases by less than its rounding error.
const NEAR: f64 = 1e-4;
/// Largest number of halvings of an increment.
const HALVINGS: usize = 30;

/// Finds (ξ, η) of the closest point of a surface r(ξ, η), 0 ≤ ξ, η ≤ 1, by Newton's method with line search from a start.
///
/// The method finds a local minimum of the distance.
pub(crate) fn closest_point(
    point: &Vector3<f64>,
    start: [f64; 2],
    surface: impl Fn([f64; 2]) -> SurfaceValues,
) -> [f64; 2] {
    let distance = |values: &SurfaceValues| (point - values[0]).norm_squared();
    least(start, surface, distance, |values| derivatives(&(point - values[0]), values))
}

/// Finds (ξ, η) of the least value of a function of some values on a surface. `slopes` returns its scaled derivatives.
pub(super) fn least<V: Copy>(
    start: [f64; 2],
    values_at: impl Fn([f64; 2]) -> V,
    value: impl Fn(&V) -> f64,
    slopes: impl Fn(&V) -> SurfaceSlopes,
) -> [f64; 2] {
    let mut at = start;
    let mut values = values_at(at);
    for _ in 0..ITERATIONS {
        let (step, is_newton) = increment(&slopes(&values), at);
        let is_near = is_newton && step.iter().all(|x| x.abs() < NEAR);
        let bound = if is_near { f64::INFINITY } else { value(&values) };
        let (mut part, mut next, mut found) = (1.0, at, values);
        for _ in 0..HALVINGS {
            next = [0, 1].map(|k| (at[k] + part * step[k]).clamp(0.0, 1.0));
            found = values_at(next);
            if value(&found) <= bound {
                break;
            }
            part *= 0.5;
        }
        if value(&found) > bound {
            break;
        }
        let moved = (0..2).map(|k| (next[k] - at[k]).abs()).fold(0.0, f64::max);
        (at, values) = (next, found);
        if moved <= if is_newton { QUADRATIC } else { f64::EPSILON } {
            break;
        }
    }
    at
}

/// Negative gradient and second derivative of a function on a surface, and the metric of the surface.
pub(crate) type SurfaceSlopes = (Vector2<f64>, Matrix2<f64>, Matrix2<f64>);

/// Computes the negative gradient d·r_α and the second derivative r_α·r_β − d·r_αβ of half the squared distance, and the metric.
pub(crate) fn derivatives(d: &Vector3<f64>, values: &SurfaceValues) -> SurfaceSlopes {
    let [_, a, b, aa, bb, ab] = values;
    let metric = Matrix2::new(a.dot(a), a.dot(b), a.dot(b), b.dot(b));
    let bent = metric - Matrix2::new(d.dot(aa), d.dot(ab), d.dot(ab), d.dot(bb));
    (Vector2::new(d.dot(a), d.dot(b)), bent, metric)
}

/// Returns for each parameter if it is free to move along the gradient of the squared distance.
fn are_free(gradient: &Vector2<f64>, at: [f64; 2]) -> [bool; 2] {
    [0, 1].map(|k| {
        let [is_before, is_beyond] = [at[k] <= 0.0 && gradient[k] < 0.0, at[k] >= 1.0 && gradient[k] > 0.0];
        !(is_before || is_beyond)
    })
}

/// Returns the increment towards the closest point, and true if it is that of Newton's method.
fn increment((gradient, bent, metric): &SurfaceSlopes, at: [f64; 2]) -> ([f64; 2], bool) {
    match are_free(gradient, at) {
        [true, true] => {
            let is_convex = bent[(0, 0)] > CONVEX * metric[(0, 0)]
                && bent.determinant() > CONVEX * CONVEX * metric.determinant();
            let matrix = if is_convex { bent } else { metric };
            let step = matrix.try_inverse().map_or_else(Vector2::zeros, |inverse| inverse * gradient);
            ([step.x, step.y], is_convex)
        }
        [false, false] => ([0.0; 2], true),
        [first, _] => {
            let k = usize::from(!first);
            let is_convex = bent[(k, k)] > CONVEX * metric[(k, k)];
            let divisor = if is_convex { bent[(k, k)] } else { metric[(k, k)] };
            let mut step = [0.0; 2];
            step[k] = gradient[k] / divisor;
            (step, is_convex)
        }
    }
}
