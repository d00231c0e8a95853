use std::f64::consts::TAU;

use ancf::Model;
use ancf::model::{Body, OutlineCurve, Section, SectionOutline};

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
/// A general section is drawn as an ellipse with the same radii of gyration: semi-axes 2 √(I_z/A) along y and
/// 2 √(I_y/A) along z.
///
/// ```
/// use ancf::model::{Circle, Rectangle, Section};
/// use ancf_report::geometry::outline;
///
/// let bar = outline(&Section::from(Rectangle { height: 0.02, width: 0.01 }), 24);
/// assert_eq!(bar.half_extents, [0.01, 0.005]);
/// // Four sides, each with two points of its own.
/// assert_eq!((bar.outer.len(), bar.edges().len()), (8, 4));
///
/// let rod = outline(&Section::from(Circle { diameter: 0.1 }), 12);
/// assert_eq!((rod.outer.len(), rod.edges().len()), (12, 12));
/// ```
pub fn outline(section: &Section, sides: usize) -> Outline {
    let sides = sides.max(3);
    let SectionOutline { outer, bore } = section.shape().outline();
    let inner = bore.map(|bore| points(&bore, sides));
    let (half_extents, is_round) = match &outer {
        OutlineCurve::Ellipse(semi_axes) => (*semi_axes, true),
        OutlineCurve::Polygon(corners) => (extents(corners), false),
    };
    Outline { outer: points(&outer, sides), inner, half_extents, is_round }
}

/// Half of the extents along y and z of a polygon about the origin.
fn extents(corners: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|axis| corners.iter().fold(0.0, |largest: f64, corner| largest.max(corner[axis].abs())))
}

/// Points and outward normals of a closed curve.
fn points(curve: &OutlineCurve, sides: usize) -> Vec<[f64; 4]> {
    match curve {
        OutlineCurve::Ellipse(semi_axes) => ellipse(*semi_axes, sides),
        OutlineCurve::Polygon(corners) => polygon(corners),
    }
}

/// Both ends of each side, with the normal of the side.
fn polygon(corners: &[[f64; 2]]) -> Vec<[f64; 4]> {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    let side = |(start, end): (&[f64; 2], &[f64; 2])| {
        let (ny, nz) = (end[1] - start[1], start[0] - end[0]);
        let length = ny.hypot(nz);
        [*start, *end].map(|[y, z]| [y, z, ny / length, nz / length])
    };
    ends.flat_map(side).collect()
}

/// Returns the outline of the section of a body at a fraction of its length from 0 to 1; `None` if the body is rigid.
///
/// Sizes of a tapered beam are interpolated as in the computation.
pub fn outline_at(model: &Model, body: &Body, fraction: f64, sides: usize) -> Option<Outline> {
    model.section_at(body, fraction).map(|section| outline(&section, sides))
}

impl Outline {
    /// Radius of the bore of a tube; 0 of other sections.
    pub fn bore(&self) -> f64 {
        self.inner.as_deref().and_then(|inner| inner.first()).map_or(0.0, |&[y, z, ..]| y.hypot(z))
    }

    /// Returns the sides of the outer outline as pairs of point numbers; sides of the bore have the same numbers.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let count = self.outer.len();
        let step = if self.is_round { 1 } else { 2 };
        (0..count).step_by(step).map(|k| [k, (k + 1) % count]).collect()
    }

    /// Returns the maximum of |c_y y + c_z z| over the outline, with both extents multiplied by factors.
    pub fn reach(&self, [cy, cz]: [f64; 2], [sy, sz]: [f64; 2]) -> f64 {
        let size = |y: f64, z: f64| (cy * y * sy, cz * z * sz);
        if self.is_round {
            let (y, z) = size(self.half_extents[0], self.half_extents[1]);
            return y.hypot(z);
        }
        let corners = self.outer.iter().map(|&[y, z, ..]| size(y, z)).map(|(y, z)| (y + z).abs());
        // In contrast to `f64::max`, NaN is returned.
        corners.fold(0.0, |largest, x| if x <= largest { largest } else { x })
    }
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
