use std::f64::consts::PI;

use ancf::Field;
use ancf::solver::equations::State;

use super::clearance::largest_factor;
use crate::geometry::Geometry;

/// Maximum displacement of a drawn shape, relative to the size of the model.
const MAX_DISPLACEMENT: f64 = 0.1;
/// Maximum rotation of a shape that mainly rotates, in radians.
const MAX_ROTATION: f64 = 0.6;

/// Smallest imaginary part of a shape that is drawn, relative to the real part.
const NEGLIGIBLE: f64 = 1e-3;
/// Number of phases of half a period at which the displacements of a complex shape are limited.
const PHASES: usize = 4;

/// States displaced by the shape of a state.
#[derive(Debug)]
pub(crate) struct DisplacedStates {
    /// State displaced by the shape, or by its real part.
    pub real: State,
    /// State displaced by the imaginary part of the shape of a damped mode; `None` if the shape is real.
    pub imaginary: Option<State>,
}

impl DisplacedStates {
    /// Displaces a state by both parts of its shape, with the factor of the shape ([`shape_factor`]).
    pub(crate) fn new(geometry: &Geometry<'_>, s: &State, size: f64) -> Self {
        let factor = shape_factor(geometry, s, size);
        let imaginary = imaginary_part(geometry, s).map(|part| moved(s, &part, factor));
        Self { real: moved(s, &s.v, factor), imaginary }
    }
}

/// Returns the imaginary part of the shape of a damped mode, in the units of its real part; `None` if it is negligible.
fn imaginary_part(geometry: &Geometry<'_>, s: &State) -> Option<Vec<f64>> {
    let largest = |x: &[f64]| x.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let unit = geometry.fields.scales().time.recip();
    let part: Vec<f64> = s.a.iter().map(|a| a * unit).collect();
    (largest(&part) > NEGLIGIBLE * largest(&s.v)).then_some(part)
}

/// State at rest with the coordinates q + c x.
fn moved(s: &State, shape: &[f64], factor: f64) -> State {
    let q = s.q.iter().zip(shape).map(|(q, x)| q + factor * x).collect();
    State { q, v: vec![0.0; s.v.len()], a: vec![0.0; s.a.len()], ..s.clone() }
}

/// Returns the factor of the shape of a state in figures: the maximum displacement is a tenth of the size of the model.
///
/// The displacement is smaller if bodies would cross each other. Complex shapes are limited at several phases of their period.
///
/// In torsion, the largest displacement is that of the rim of a section or the corner of a box. Then the rotation of directors is
/// limited, too.
pub fn shape_factor(geometry: &Geometry<'_>, s: &State, size: f64) -> f64 {
    let Some(imaginary) = imaginary_part(geometry, s) else { return factor_of(geometry, s, size) };
    let at = |phase: usize| {
        let (sin, cos) = (PI * phase as f64 / PHASES as f64).sin_cos();
        let v = s.v.iter().zip(&imaginary).map(|(x, y)| x * cos - y * sin).collect();
        factor_of(geometry, &State { v, ..s.clone() }, size)
    };
    (0..PHASES).map(at).fold(f64::INFINITY, f64::min)
}

/// Returns the factor of the real shape of a state.
fn factor_of(geometry: &Geometry<'_>, s: &State, size: f64) -> f64 {
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
        let (about, near) = (geometry.place(s), geometry.place(&moved(s, &s.v, small)));
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
