use std::f64::consts::TAU;

/// Relative distance from a curve within which a point is on it.
const ROUNDING: f64 = 1e-9;

/// Outline of a cross-section in its plane, for figures.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionOutline {
    /// Outer outline.
    pub outer: OutlineCurve,
    /// Outline of the bore.
    pub bore: Option<OutlineCurve>,
}

/// Closed curve about the axis of the beam.
#[derive(Clone, Debug, PartialEq)]
pub enum OutlineCurve {
    /// Ellipse with these semi-axes along y and z.
    Ellipse([f64; 2]),
    /// Polygon with corners (y, z), counter-clockwise from y towards z.
    Polygon(Vec<[f64; 2]>),
}

impl SectionOutline {
    /// Ellipse with semi-axes along y and z, without bore.
    pub const fn ellipse(semi_axes: [f64; 2]) -> Self {
        Self { outer: OutlineCurve::Ellipse(semi_axes), bore: None }
    }

    /// Polygon without bore; see [`OutlineCurve::Polygon`] for the order of the corners.
    pub const fn polygon(corners: Vec<[f64; 2]>) -> Self {
        Self { outer: OutlineCurve::Polygon(corners), bore: None }
    }

    /// Describes a point that is not in the material; `None` in the material and on its boundary, up to rounding errors.
    pub(crate) fn place_outside(&self, point: [f64; 2]) -> Option<&'static str> {
        let [smaller, larger] = [-ROUNDING, ROUNDING].map(|part| point.map(|x| x * (1.0 + part)));
        if !self.outer.contains(smaller) {
            Some("outside of the section")
        } else if self.bore.as_ref().is_some_and(|bore| bore.contains(larger)) {
            Some("in the bore of the section")
        } else {
            None
        }
    }
}

impl OutlineCurve {
    /// Corners (y, z) of a closed polygon, counter-clockwise. An ellipse is replaced by a polygon of `sides` corners.
    pub fn corners(&self, sides: usize) -> Vec<[f64; 2]> {
        match self {
            Self::Ellipse([a, b]) => {
                let corner = |k: usize| {
                    let (sin, cos) = (TAU * k as f64 / sides as f64).sin_cos();
                    [a * cos, b * sin]
                };
                (0..sides).map(corner).collect()
            }
            Self::Polygon(corners) => corners.clone(),
        }
    }

    /// True if a point is inside.
    fn contains(&self, [y, z]: [f64; 2]) -> bool {
        match self {
            Self::Ellipse([a, b]) => (y / a).hypot(z / b) <= 1.0,
            Self::Polygon(corners) => {
                let next = corners.iter().cycle().skip(1);
                // Edges that a ray along y crosses.
                let crossed = corners.iter().zip(next).filter(|([y0, z0], [y1, z1])| {
                    (*z0 > z) != (*z1 > z) && y < y0 + (z - z0) / (z1 - z0) * (y1 - y0)
                });
                crossed.count() % 2 == 1
            }
        }
    }
}
