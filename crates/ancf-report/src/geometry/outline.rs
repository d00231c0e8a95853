use std::f64::consts::TAU;

use ancf::Model;
use ancf::model::{Body, Section};

/// Number of sides of a round outline in pages and ParaView files.
pub const SIDES: usize = 24;

/// Outline of a cross-section, which is swept along the axis of a body.
///
/// Points (y, z, n_y, n_z) are counter-clockwise about the first axis of the section, from y towards z. The last point is joined
/// to the first one. Normals have length 1 and point away from the axis. A corner consists of two points with two normals.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Outer outline.
    pub outer: Vec<[f64; 4]>,
    /// Outline of the bore of a tube, with as many points.
    pub inner: Option<Vec<[f64; 4]>>,
    /// Half of the extents along y and z.
    pub half_extents: [f64; 2],
    /// True if the outline has no corners.
    pub is_round: bool,
}

/// Returns the outline of a section in the unit of length of the section, with `sides` sides (at least 3) if it is round.
///
/// A general section is drawn as an ellipse with the same radii of gyration: semi-axes 2 √(I_z/A) along y and 2 √(I_y/A) along z.
///
/// ```
/// use ancf::model::Section;
/// use ancf_report::geometry::outline;
///
/// let bar = outline(&Section::Rectangle { height: 0.02, width: 0.01 }, 24);
/// assert_eq!(bar.half_extents, [0.01, 0.005]);
/// // Four sides, each with two points of its own.
/// assert_eq!((bar.outer.len(), bar.edges().len()), (8, 4));
///
/// let rod = outline(&Section::Circle { diameter: 0.1 }, 12);
/// assert_eq!((rod.outer.len(), rod.edges().len()), (12, 12));
/// ```
pub fn outline(section: &Section, sides: usize) -> Outline {
    let sides = sides.max(3);
    match *section {
        Section::Circle { diameter } => elliptic([0.5 * diameter; 2], sides),
        Section::Tube { outer, inner } => {
            let inner = ellipse([0.5 * inner; 2], sides);
            Outline { inner: Some(inner), ..elliptic([0.5 * outer; 2], sides) }
        }
        Section::Ellipse { height, width } => elliptic([0.5 * height, 0.5 * width], sides),
        Section::General { area, iy, iz, .. } => {
            elliptic([iz, iy].map(|second| 2.0 * (second / area).sqrt()), sides)
        }
        Section::Rectangle { height, width } => rectangular([0.5 * height, 0.5 * width]),
    }
}

/// Returns the outline of the section of a body at a fraction of its length from 0 to 1; `None` if the body is rigid.
///
/// Sizes of a tapered beam are interpolated as in the computation.
pub fn outline_at(model: &Model, body: &Body, fraction: f64, sides: usize) -> Option<Outline> {
    model.section_at(body, fraction).map(|section| outline(&section, sides))
}

impl Outline {
    /// Returns the sides of the outer outline as pairs of point numbers; sides of the bore have the same numbers.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let count = self.outer.len();
        let step = if self.is_round { 1 } else { 2 };
        (0..count).step_by(step).map(|k| [k, (k + 1) % count]).collect()
    }

    /// Returns the maximum of |c_y y + c_z z| over the outline, with both extents multiplied by factors.
    pub fn reach(&self, [cy, cz]: [f64; 2], [sy, sz]: [f64; 2]) -> f64 {
        let (y, z) = (cy * self.half_extents[0] * sy, cz * self.half_extents[1] * sz);
        if self.is_round { y.hypot(z) } else { y.abs() + z.abs() }
    }
}

fn elliptic(half_extents: [f64; 2], sides: usize) -> Outline {
    Outline { outer: ellipse(half_extents, sides), inner: None, half_extents, is_round: true }
}

fn rectangular(half_extents: [f64; 2]) -> Outline {
    let [a, b] = half_extents;
    let outer = vec![
        [a, -b, 1.0, 0.0],
        [a, b, 1.0, 0.0],
        [a, b, 0.0, 1.0],
        [-a, b, 0.0, 1.0],
        [-a, b, -1.0, 0.0],
        [-a, -b, -1.0, 0.0],
        [-a, -b, 0.0, -1.0],
        [a, -b, 0.0, -1.0],
    ];
    Outline { outer, inner: None, half_extents, is_round: false }
}

fn ellipse([a, b]: [f64; 2], sides: usize) -> Vec<[f64; 4]> {
    let at = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / sides as f64).sin_cos();
        // The normal is along the gradient of (y/a)² + (z/b)².
        let (ny, nz) = (b * cos, a * sin);
        let length = ny.hypot(nz);
        [a * cos, b * sin, ny / length, nz / length]
    };
    (0..sides).map(at).collect()
}
