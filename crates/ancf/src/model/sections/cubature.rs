//! Points and weights for integrals over a section.

use std::f64::consts::PI;

use ancf_mechanics::sections::SectionPoint;

use super::section::Section;

impl Section {
    /// Sixteen points whose weighted sums are the integrals over the section of polynomials of degree seven in y and z;
    /// none for a general section, which has no shape.
    ///
    /// Rectangles have four Gauss points each way. Circles, tubes and, stretched, ellipses have two Gauss points in the square of
    /// the radius on eight rays. All points lie in fours, mirrored in both axes, so that no odd moment is left by rounding.
    ///
    /// Source: Abramowitz & Stegun (1964), table 25.4; Stroud (1971), chapter 2, for products in polar coordinates.
    pub fn points(&self) -> Option<Vec<SectionPoint>> {
        let quadrant = match *self {
            Self::Circle { diameter } => annulus(diameter, diameter, 0.0),
            Self::Tube { outer, inner } => annulus(outer, outer, inner / outer),
            Self::Ellipse { height, width } => annulus(height, width, 0.0),
            Self::Rectangle { height, width } => rectangle(height, width),
            Self::General { .. } => return None,
        };
        Some(quadrant.into_iter().flat_map(mirrored).collect())
    }
}

fn mirrored(point: SectionPoint) -> [SectionPoint; 4] {
    let SectionPoint { y, z, weight } = point;
    [(y, z), (-y, z), (-y, -z), (y, -z)].map(|(y, z)| SectionPoint { y, z, weight })
}

/// The points with y, z > 0 of h × w.
fn rectangle(height: f64, width: f64) -> [SectionPoint; 4] {
    let root = 2.0 * 1.2_f64.sqrt();
    let (inner, outer) = (((3.0 - root) / 7.0).sqrt(), ((3.0 + root) / 7.0).sqrt());
    let part = 30.0_f64.sqrt();
    let (heavy, light) = ((18.0 + part) / 72.0, (18.0 - part) / 72.0);
    let point = |(y, v): (f64, f64), (z, w): (f64, f64)| SectionPoint {
        y: 0.5 * height * y,
        z: 0.5 * width * z,
        weight: height * width * v * w,
    };
    let (near, far) = ((inner, heavy), (outer, light));
    [point(near, near), point(near, far), point(far, near), point(far, far)]
}

/// The points with y, z > 0 of an ellipse less its middle, of which `hole` is the relative size.
fn annulus(height: f64, width: f64, hole: f64) -> [SectionPoint; 4] {
    let share = (1.0 - hole) * (1.0 + hole);
    let weight = PI * height * width * share / 64.0;
    let point = |t: f64, angle: f64| {
        let radius = (1.0 - share * t).sqrt();
        SectionPoint { y: 0.5 * height * radius * angle.cos(), z: 0.5 * width * radius * angle.sin(), weight }
    };
    let (less, more) = (0.5 - 3.0_f64.sqrt() / 6.0, 0.5 + 3.0_f64.sqrt() / 6.0);
    let (low, high) = (PI / 8.0, 3.0 * PI / 8.0);
    [point(less, low), point(less, high), point(more, low), point(more, high)]
}
