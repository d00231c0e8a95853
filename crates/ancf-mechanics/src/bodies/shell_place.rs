use nalgebra::Vector3;

use crate::shells::SurfacePlace;

/// Place on a shell of either kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShellPlace {
    /// Parameters (u, v) of a patch.
    Patch([f64; 2]),
    /// Element of a mesh, and (ξ, η) in it.
    Element(SurfacePlace),
}

impl ShellPlace {
    /// Returns the place as the vector of [`BodyTerms::attachment`](crate::bodies::BodyTerms::attachment).
    pub fn parameters(self) -> Vector3<f64> {
        match self {
            Self::Patch([u, v]) => Vector3::new(u, v, 0.0),
            Self::Element(SurfacePlace { element, at: [x, y] }) => Vector3::new(x, y, element as f64),
        }
    }

    /// Returns (u, v) of a patch.
    pub fn patch(self) -> Option<[f64; 2]> {
        if let Self::Patch(at) = self { Some(at) } else { None }
    }
}
