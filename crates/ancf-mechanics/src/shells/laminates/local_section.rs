use std::fmt;
use std::sync::Arc;

use nalgebra::Vector3;

/// Section of a shell at a point, relative to the section of the whole shell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalSection {
    /// Thickness, relative to that of the whole shell. All plies have the same ratio.
    pub scale: f64,
    /// Axis whose projection on the surface is the first direction of the section; `None` for that of the whole shell.
    pub axis: Option<Vector3<f64>>,
    /// Angle about the normal by which the first direction is turned from the projection, in radians.
    pub turn: f64,
}

impl LocalSection {
    /// Section of the whole shell.
    pub const WHOLE: Self = Self { scale: 1.0, axis: None, turn: 0.0 };

    /// Returns the axis of the first direction at a point with reference tangents; `None` for the direction of r_ξ.
    ///
    /// `whole` is the axis of the whole shell.
    pub(crate) fn axis_at(
        &self,
        whole: Option<Vector3<f64>>,
        [t, s]: [&Vector3<f64>; 2],
    ) -> Option<Vector3<f64>> {
        let axis = self.axis.or(whole);
        if self.turn == 0.0 {
            return axis;
        }
        let (normal, axis) = (t.cross(s).normalize(), axis.unwrap_or(*t));
        let first = (axis - normal * axis.dot(&normal)).normalize();
        let (sin, cos) = self.turn.sin_cos();
        Some(first * cos + normal.cross(&first) * sin)
    }
}

/// Sections at the points of a shell, by the element and (ξ, η) in it.
#[derive(Clone)]
pub struct SectionField(Arc<dyn Fn(usize, [f64; 2]) -> LocalSection + Send + Sync>);

impl fmt::Debug for SectionField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SectionField").finish_non_exhaustive()
    }
}

impl SectionField {
    /// Creates a field from a function of the element and (ξ, η) in it.
    pub fn new(field: impl Fn(usize, [f64; 2]) -> LocalSection + Send + Sync + 'static) -> Self {
        Self(Arc::new(field))
    }

    /// Returns the section at a point of an element.
    pub fn at(&self, element: usize, at: [f64; 2]) -> LocalSection {
        (self.0)(element, at)
    }

    /// Returns the sections at some points of an element; none without a field.
    pub(crate) fn of_element<P: Iterator<Item = [f64; 2]>>(
        field: Option<&Self>,
        element: usize,
        places: impl FnOnce() -> P,
    ) -> Vec<LocalSection> {
        field.map_or_else(Vec::new, |field| places().map(|at| field.at(element, at)).collect())
    }
}
