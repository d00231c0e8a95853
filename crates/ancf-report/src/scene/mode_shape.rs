use ancf::Field;
use ancf::solver::equations::State;

use super::clearance::largest_factor;
use crate::geometry::Geometry;

/// Maximum displacement of a drawn shape, relative to the size of the model.
const MAX_DISPLACEMENT: f64 = 0.1;
/// Maximum rotation of a shape that mainly rotates, in radians.
const MAX_ROTATION: f64 = 0.6;

/// Returns the state displaced by its shape: q + c v, with the factor of the shape ([`shape_factor`]).
pub(crate) fn displaced(geometry: &Geometry<'_>, s: &State, size: f64) -> State {
    moved(s, shape_factor(geometry, s, size))
}

/// State at rest with the coordinates q + c v.
fn moved(s: &State, factor: f64) -> State {
    let q = s.q.iter().zip(&s.v).map(|(q, v)| q + factor * v).collect();
    State { q, v: vec![0.0; s.v.len()], ..s.clone() }
}

/// Returns the factor of the shape of a state in figures: the maximum displacement is a tenth of the size of the model.
///
/// The displacement is smaller if bodies would cross each other.
///
/// In torsion, the largest displacement is that of the rim of a section or the corner of a box. Then the rotation of directors is
/// limited, too.
pub fn shape_factor(geometry: &Geometry<'_>, s: &State, size: f64) -> f64 {
    // Displacements are linear in the coordinates.
    let shape = State { q: s.v.clone(), ..s.clone() };
    let displacements = geometry.read(Field::Displacement, &shape);
    let axis = max_length(&displacements);
    let axis = if axis.is_finite() { axis } else { 0.0 };
    let mut factor = if axis > 0.0 { MAX_DISPLACEMENT * size / axis } else { 0.0 };
    let largest = s.v.iter().fold(0.0, |sum: f64, v| sum.max(v.abs()));
    if largest > 0.0 && largest.is_finite() {
        // Rotation rates by a difference quotient with a small displacement.
        let small = 1e-4 / largest;
        let (about, near) = (geometry.place(s), geometry.place(&moved(s, small)));
        let (mut rim, mut turn) = (0.0_f64, 0.0_f64);
        for shape in &geometry.bodies {
            let of_outline = || shape.outline.as_ref().map(|o| [0.0, o.half_extents[0], o.half_extents[1]]);
            let half = shape.half_edges.or_else(of_outline).unwrap_or([0.0; 3]);
            for (k, station) in shape.stations.clone().enumerate() {
                let [sy, sz] = shape.scale_at(k);
                let half = [half[0], half[1] * sy, half[2] * sz];
                for (i, half) in half.iter().enumerate() {
                    let rate = (near.directors[station][i] - about.directors[station][i]).norm() / small;
                    turn = turn.max(rate);
                    rim = rim.max(rate * half);
                }
            }
        }
        if rim > axis && turn > 0.0 {
            factor = (MAX_DISPLACEMENT * size / rim).min(MAX_ROTATION / turn);
        }
    }
    factor.min(largest_factor(geometry, &geometry.place(s).centres, &displacements))
}

/// Maximum length of vectors of three numbers.
fn max_length(vectors: &[f64]) -> f64 {
    vectors.chunks_exact(3).map(|x| x[0].hypot(x[1]).hypot(x[2])).fold(0.0, f64::max)
}
