use std::f64::consts::TAU;

use ancf::model::{OutlineCurve, Section};

/// Points about a round outline.
const SIDES: usize = 24;

/// The outline of a section, which is swept along the axis of a body.
///
/// Points (y, z, n_y, n_z) go about the first axis of the section by the right-hand rule, from y towards z, and the last one
/// is joined with the first; normals are of length 1 and point away from the axis. A corner is two points with two normals.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The outer outline.
    pub outer: Vec<[f64; 4]>,
    /// That of the bore of a tube.
    pub inner: Option<Vec<[f64; 4]>>,
    /// Half of the extents along y and z.
    pub half: [f64; 2],
    /// Whether it has no corners.
    pub round: bool,
}

impl Outline {
    /// Outline of a section in its own unit of length.
    pub fn of(section: &Section) -> Self {
        let outline = section.shape().outline();
        let (half, round) = match &outline.outer {
            OutlineCurve::Ellipse(semi_axes) => (*semi_axes, true),
            OutlineCurve::Polygon(corners) => (extents(corners), false),
        };
        Self { outer: points(&outline.outer), inner: outline.bore.as_ref().map(points), half, round }
    }

    /// The largest |c_y y + c_z z| over the outline, with its extents times a factor each.
    pub fn reach(&self, [cy, cz]: [f64; 2], [sy, sz]: [f64; 2]) -> f64 {
        let (y, z) = (cy * self.half[0] * sy, cz * self.half[1] * sz);
        if self.round { y.hypot(z) } else { y.abs() + z.abs() }
    }
}

/// Half of the extents along y and z of a polygon about the origin.
fn extents(corners: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|axis| corners.iter().fold(0.0, |largest: f64, corner| largest.max(corner[axis].abs())))
}

/// Points and outward normals of a closed curve.
fn points(curve: &OutlineCurve) -> Vec<[f64; 4]> {
    match curve {
        OutlineCurve::Ellipse(semi_axes) => ellipse(*semi_axes),
        OutlineCurve::Polygon(corners) => polygon(corners),
    }
}

/// Both ends of each side, with the normal of the side.
fn polygon(corners: &[[f64; 2]]) -> Vec<[f64; 4]> {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let side = |(start, end): (&[f64; 2], &[f64; 2])| {
        let (ny, nz) = (end[1] - start[1], start[0] - end[0]);
        let length = ny.hypot(nz);
        [start, end].map(|[y, z]| [*y, *z, ny / length, nz / length])
    };
    ends.flat_map(side).collect()
}

fn ellipse([a, b]: [f64; 2]) -> Vec<[f64; 4]> {
    let at = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / SIDES as f64).sin_cos();
        // The normal is along the gradient of (y/a)² + (z/b)².
        let (ny, nz) = (b * cos, a * sin);
        let length = ny.hypot(nz);
        [a * cos, b * sin, ny / length, nz / length]
    };
    (0..SIDES).map(at).collect()
}
