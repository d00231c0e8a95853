use std::f64::consts::TAU;

use ancf::model::Section;

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
    /// The outline of a section in its own units of length.
    ///
    /// A section that is known by its numbers only is drawn as the ellipse with its radii of gyration: semi-axes
    /// 2 √(I_z/A) along y and 2 √(I_y/A) along z.
    pub fn of(section: &Section) -> Self {
        match *section {
            Section::Circle { diameter } => Self::ellipse([0.5 * diameter; 2]),
            Section::Tube { outer, inner } => {
                Self { inner: Some(ellipse([0.5 * inner; 2])), ..Self::ellipse([0.5 * outer; 2]) }
            }
            Section::Ellipse { height, width } => Self::ellipse([0.5 * height, 0.5 * width]),
            Section::General { area, iy, iz, .. } => {
                Self::ellipse([iz, iy].map(|second| 2.0 * (second / area).sqrt()))
            }
            Section::Rectangle { height, width } => Self::rectangle([0.5 * height, 0.5 * width]),
        }
    }

    fn ellipse(half: [f64; 2]) -> Self {
        Self { outer: ellipse(half), inner: None, half, round: true }
    }

    fn rectangle(half: [f64; 2]) -> Self {
        let [a, b] = half;
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
        Self { outer, inner: None, half, round: false }
    }

    /// The largest |c_y y + c_z z| over the outline, with its extents times a factor each.
    pub fn reach(&self, [cy, cz]: [f64; 2], [sy, sz]: [f64; 2]) -> f64 {
        let (y, z) = (cy * self.half[0] * sy, cz * self.half[1] * sz);
        if self.round { y.hypot(z) } else { y.abs() + z.abs() }
    }
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
