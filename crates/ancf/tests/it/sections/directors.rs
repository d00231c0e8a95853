//! Sections, elastic constants and directors of the tests of section laws.

use ancf::mechanics::sections::{Directors, Lame};
use ancf::model::Section;
use nalgebra::{Rotation3, Vector3};

pub(super) const LAME: Lame = Lame { lambda: 3.0, shear: 2.0 };

pub(super) const SECTIONS: [Section; 4] =
    [Section::circle(0.3), Section::tube(0.4, 0.3), Section::rectangle(0.3, 0.2), Section::ellipse(0.2, 0.4)];

/// Directors of a straight beam.
pub(super) fn straight() -> Directors {
    let zero = Vector3::zeros();
    [Vector3::x(), zero, zero, Vector3::y(), Vector3::z(), zero, zero]
}

/// Returns g + factor × u.
pub(super) fn sum(g: &Directors, u: &Directors, factor: f64) -> Directors {
    std::array::from_fn(|i| g[i] + u[i] * factor)
}

/// Returns the directors rotated by r.
pub(super) fn rotated(r: Rotation3<f64>, g: &Directors) -> Directors {
    g.map(|g| r * g)
}
