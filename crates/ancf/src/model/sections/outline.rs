use std::f64::consts::TAU;

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
}
