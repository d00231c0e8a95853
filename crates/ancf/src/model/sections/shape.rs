use std::f64::consts::PI;

use ancf_mechanics::sections::{Moments, SectionPoint};

use super::outline::SectionOutline;
use crate::errors::Finding;

/// Kind of cross-section: stiffness, inertia, outline and checks of its data.
///
/// Each kind implements this trait in its own file, and one line in `section.rs` registers it. All lengths are in the unit
/// of length of the data.
pub trait SectionShape {
    /// Moments of area up to the fourth degree.
    fn moments(&self) -> Moments;

    /// Moments that give the inertia per length when multiplied by the density.
    fn mass_moments(&self) -> Moments {
        self.moments()
    }

    /// St. Venant's torsion constant J, length⁴. The twist per length under a torque M is M/(G J).
    fn torsion_constant(&self) -> f64;

    /// Gradient (∂ω/∂y, ∂ω/∂z) of St. Venant's warping function at (y, z), length: a twist κ causes the shear strains
    /// 2E_xy = κ (∂ω/∂y − z) and 2E_xz = κ (∂ω/∂z + y).
    ///
    /// Zero by default: that of round sections, and of sections whose geometry is unknown.
    fn warping_gradient(&self, _at: [f64; 2]) -> [f64; 2] {
        [0.0; 2]
    }

    /// Shear factors [k_y, k_z] for Poisson's ratio ν: the shear stiffness along y is k_y G A.
    fn shear_factors(&self, poisson: f64) -> [f64; 2];

    /// Integration points, exact for polynomials of degree seven in y and z; none if the geometry is unknown.
    ///
    /// Points are symmetric about both axes, so that odd moments vanish without rounding errors.
    fn points(&self) -> Option<Vec<SectionPoint>> {
        None
    }

    /// Outline for drawings, exact if there are integration points; an ellipse with the same radii of gyration by default.
    fn outline(&self) -> SectionOutline {
        let Moments { area, yy, zz, .. } = self.moments();
        SectionOutline::ellipse([yy, zz].map(|second| 2.0 * (second / area).sqrt()))
    }

    /// Outer radius of a section that is round outside, for contact and flow.
    fn outer_radius(&self) -> Option<f64> {
        None
    }

    /// Area of the fluid that the section displaces, bore included, if the section is round outside.
    fn displaced_area(&self) -> Option<f64> {
        self.outer_radius().map(disk_area)
    }

    /// Section at a fraction of the way to another one of the same kind: dimensions vary linearly.
    #[must_use]
    fn towards(&self, end: &Self, fraction: f64) -> Self
    where
        Self: Sized;

    /// Findings of checks beyond the schema. `path` is the path of the section in the model.
    fn check(&self, _path: &str) -> Vec<Finding> {
        Vec::new()
    }
}

/// Interpolates a dimension linearly.
pub(super) fn interpolate(start: f64, end: f64, fraction: f64) -> f64 {
    start + (end - start) * fraction
}

/// Area of a disk.
pub(crate) fn disk_area(radius: f64) -> f64 {
    PI * (radius * radius)
}
