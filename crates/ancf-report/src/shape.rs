use ancf::Field;
use ancf::system::State;

use crate::Geometry;

/// The largest displacement with which a shape is drawn, over the size of the model.
const SHOWN: f64 = 0.1;
/// The largest angle by which what only turns is turned.
const TURNED: f64 = 0.6;

/// The state displaced by its shape, which are its velocities: q + c v, with the largest displacement a tenth of the size.
///
/// What moves most may be the rim of a section or a corner of a box, as in torsion: then no direction turns by more than
/// `TURNED`, too.
pub(crate) fn displaced(geometry: &Geometry<'_>, s: &State, size: f64) -> State {
    let at_rest = |q: Vec<f64>| State { q, v: vec![0.0; s.v.len()], ..s.clone() };
    // Displacements are linear in the coordinates: those of the shape itself are the largest there can be told from.
    let shape = State { q: s.v.clone(), ..s.clone() };
    let axis = greatest(&geometry.read(Field::Displacement, &shape));
    let axis = if axis.is_finite() { axis } else { 0.0 };
    let mut factor = if axis > 0.0 { SHOWN * size / axis } else { 0.0 };
    let moved = |factor: f64| -> Vec<f64> { s.q.iter().zip(&s.v).map(|(q, v)| q + factor * v).collect() };
    // A small displacement tells how fast directions turn.
    let largest = s.v.iter().fold(0.0, |sum: f64, v| sum.max(v.abs()));
    if largest > 0.0 && largest.is_finite() {
        let small = 1e-4 / largest;
        let (about, near) = (geometry.place(s), geometry.place(&at_rest(moved(small))));
        let (mut rim, mut turn) = (0.0_f64, 0.0_f64);
        for drawn in &geometry.bodies {
            let half = drawn.half_edges.or(drawn.outline.as_ref().map(|o| [0.0, o.half[0], o.half[1]]));
            let half = half.unwrap_or([0.0; 3]);
            for (k, station) in drawn.stations.clone().enumerate() {
                let [sy, sz] = drawn.scale_at(k);
                let half = [half[0], half[1] * sy, half[2] * sz];
                for (i, half) in half.iter().enumerate() {
                    let rate = (near.directors[station][i] - about.directors[station][i]).norm() / small;
                    turn = turn.max(rate);
                    rim = rim.max(rate * half);
                }
            }
        }
        if rim > axis && turn > 0.0 {
            factor = (SHOWN * size / rim).min(TURNED / turn);
        }
    }
    at_rest(moved(factor))
}

/// The largest length of vectors of three numbers.
fn greatest(vectors: &[f64]) -> f64 {
    vectors.chunks_exact(3).map(|x| x[0].hypot(x[1]).hypot(x[2])).fold(0.0, f64::max)
}
