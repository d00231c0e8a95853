use ancf::Field;
use ancf::solver::equations::State;
use nalgebra::Vector3;

use crate::geometry::{Geometry, Placement, Triad};

/// Computes velocities and accelerations of the centres and directors of all stations, given the directors `here`.
///
/// Those of centres are exact. Directors d(q) are orthonormal and hence nonlinear in the coordinates: ḋ = d′ v and
/// d̈ = d′ a + d″ v v, by central differences. With rotations of 10⁻³ in a difference, relative errors are about 10⁻⁶.
pub(super) fn rates(geometry: &Geometry<'_>, s: &State, here: &[Triad]) -> [Placement; 2] {
    let centres = |field| geometry.read(field, s).chunks_exact(3).map(Vector3::from_column_slice).collect();
    let turning = slopes(geometry, s, &s.v);
    let mut turned = slopes(geometry, s, &s.a);
    let fastest = turning.iter().flatten().map(Vector3::norm).filter(|x| x.is_finite()).fold(0.0, f64::max);
    if fastest > 0.0 {
        let h = ANGLE / fastest;
        let [after, before] = [h, -h].map(|h| moved(geometry, s, &s.v, h));
        for (k, own) in turned.iter_mut().enumerate() {
            for (i, rate) in own.iter_mut().enumerate() {
                *rate += (after[k][i] - here[k][i] * 2.0 + before[k][i]) / (h * h);
            }
        }
    }
    [
        Placement { centres: centres(Field::Velocity), directors: turning },
        Placement { centres: centres(Field::Acceleration), directors: turned },
    ]
}

/// Rotation of directors in a second difference, in radians.
const ANGLE: f64 = 1e-3;
/// Step along the largest component of a direction in a first difference, in the units of the solver.
const STEP: f64 = 1e-5;

type Directors = Vec<Triad>;

/// Derivatives of the directors along a direction of the coordinates.
fn slopes(geometry: &Geometry<'_>, s: &State, along: &[f64]) -> Directors {
    let largest = along.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let h = if largest > 0.0 && largest.is_finite() { STEP / largest } else { 0.0 };
    let [mut after, before] = [h, -h].map(|h| moved(geometry, s, along, h));
    for (after, before) in after.iter_mut().flatten().zip(before.iter().flatten()) {
        *after = if h > 0.0 { (*after - before) / (2.0 * h) } else { Vector3::zeros() };
    }
    after
}

/// Directors after a displacement of the coordinates by `h` along a direction.
fn moved(geometry: &Geometry<'_>, s: &State, along: &[f64], h: f64) -> Directors {
    let q = s.q.iter().zip(along).map(|(q, x)| q + h * x).collect();
    geometry.place(&State { q, ..s.clone() }).directors
}
