use ancf::Field;
use ancf::solver::equations::State;
use nalgebra::Vector3;

use crate::geometry::{Geometry, Placement, Triad};

/// Computes velocities and accelerations of the centres and directors of all stations, given the directors `here`.
///
/// Those of centres are exact. Directors d(q) are orthonormal and hence nonlinear in the coordinates: ḋ = d′ v and
/// d̈ = d′ a + d″ v v, by central differences. With rotations of 10⁻³ in a difference, relative errors are about
/// 10⁻⁶.
pub(super) fn rates(geometry: &Geometry<'_>, s: &State, here: &[Triad]) -> [Placement; 2] {
    let centres = |field| geometry.read(field, s).chunks_exact(3).map(Vector3::from_column_slice).collect();
    let time = geometry.fields.scales().time;
    let mut turning = slopes(geometry, s, &s.v);
    let mut turned = slopes(geometry, s, &s.a);
    let fastest = largest(&turning);
    if fastest > 0.0 {
        let h = ANGLE / fastest;
        let [after, before] = [h, -h].map(|h| moved(geometry, s, &s.v, h));
        for (k, own) in turned.iter_mut().enumerate() {
            for (i, rate) in own.iter_mut().enumerate() {
                *rate += (after[k][i] - here[k][i] * 2.0 + before[k][i]) / (h * h);
            }
        }
    }
    // The coordinates have rates in the time unit of the solver.
    turning.iter_mut().flatten().for_each(|rate| *rate /= time);
    turned.iter_mut().flatten().for_each(|rate| *rate /= time * time);
    [
        Placement { centres: centres(Field::Velocity), directors: turning },
        Placement { centres: centres(Field::Acceleration), directors: turned },
    ]
}

/// Rotation of directors in a difference, in radians.
const ANGLE: f64 = 1e-3;
/// First displacement along the largest component of a direction, in the units of the solver.
const STEP: f64 = 1e-5;
/// Maximum number of changes of that displacement.
const CHANGES: usize = 4;
/// Largest factor of a change.
const LARGEST_CHANGE: f64 = 1e6;

type Directors = Vec<Triad>;

/// Derivatives of the directors along a direction of the coordinates.
///
/// The fastest director turns by about [`ANGLE`] in the difference: positions may move by any distance meanwhile.
fn slopes(geometry: &Geometry<'_>, s: &State, along: &[f64]) -> Directors {
    let fastest = along.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if fastest == 0.0 || !fastest.is_finite() {
        return vec![[Vector3::zeros(); 3]; geometry.stations()];
    }
    let mut h = STEP / fastest;
    let mut changes = differences(geometry, s, along, h);
    for _ in 0..CHANGES {
        let turned = largest(&changes);
        if turned == 0.0 || (0.1 * ANGLE..10.0 * ANGLE).contains(&turned) {
            break;
        }
        h *= (ANGLE / turned).min(LARGEST_CHANGE);
        changes = differences(geometry, s, along, h);
    }
    changes.iter_mut().flatten().for_each(|change| *change /= h);
    changes
}

/// Half the difference of the directors after displacements by h and −h.
fn differences(geometry: &Geometry<'_>, s: &State, along: &[f64], h: f64) -> Directors {
    let [mut after, before] = [h, -h].map(|h| moved(geometry, s, along, h));
    for (after, before) in after.iter_mut().flatten().zip(before.iter().flatten()) {
        *after = (*after - before) * 0.5;
    }
    after
}

/// Largest magnitude of a vector.
fn largest(all: &Directors) -> f64 {
    all.iter().flatten().map(Vector3::norm).filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// Directors after a displacement of the coordinates by `h` along a direction.
fn moved(geometry: &Geometry<'_>, s: &State, along: &[f64], h: f64) -> Directors {
    let q = s.q.iter().zip(along).map(|(q, x)| q + h * x).collect();
    geometry.place(&State { q, ..s.clone() }).directors
}
