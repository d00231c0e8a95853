use std::borrow::Cow;

use nalgebra::{Rotation3, Unit, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::spline_surface::SplineSurface;
use super::sweep::sweep;
use crate::units::Scaled;

/// Middle surface of a shell as a map of (u, v). The normal is that of the directions of u and v by the right-hand rule.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ShellSurface {
    /// Rectangle or parallelogram.
    Flat {
        /// Corner with u = v = 0, length.
        #[unit(length)]
        corner: [f64; 3],
        /// Side from the corner along u, length.
        #[unit(length)]
        side_u: [f64; 3],
        /// Side from the corner along v, length.
        #[unit(length)]
        side_v: [f64; 3],
    },
    /// Line that rotates about an axis: part of a cylinder, a cone or an annulus. u is along the rotation, v along the line.
    ///
    /// The edges of a full turn are connected by a seam only.
    Revolved {
        /// Start of the line with u = v = 0, length.
        #[unit(length)]
        from: [f64; 3],
        /// End of the line with u = 0, v = 1, length.
        #[unit(length)]
        to: [f64; 3],
        /// Point of the axis, length.
        #[unit(length)]
        center: [f64; 3],
        /// Direction of the axis. The rotation follows the right-hand rule.
        #[unit(none)]
        axis: [f64; 3],
        /// Angle of the rotation, in radians.
        #[unit(radian)]
        angle: f64,
    },
    /// Part of a sphere: u is along the parallels, v along the meridians.
    Sphere {
        /// Centre, length.
        #[unit(length)]
        center: [f64; 3],
        /// Point of the equator on the meridian u = 0, length. It determines the radius.
        #[unit(length)]
        equator: [f64; 3],
        /// Direction from the centre to the pole, normal to the direction of `equator`.
        #[unit(none)]
        axis: [f64; 3],
        /// Angle between the meridians u = 0 and u = 1, in radians.
        #[unit(radian)]
        angle: f64,
        /// Latitudes of the parallels v = 0 and v = 1, in radians. The poles are not allowed.
        #[unit(radian)]
        latitudes: [f64; 2],
    },
    /// Strip whose width rotates about its axis.
    ///
    /// u is along the axis, v along the width, with the axis at v = ½.
    Twisted {
        /// Start of the axis, length.
        #[unit(length)]
        from: [f64; 3],
        /// End of the axis, length.
        #[unit(length)]
        to: [f64; 3],
        /// Width at the start, a vector normal to the axis, length.
        #[unit(length)]
        width: [f64; 3],
        /// Rotation of the width from start to end, in radians.
        #[unit(radian)]
        twist: f64,
    },
    /// Smooth surface through curves: u is along the curves, v from the first to the last one.
    ///
    /// Cubic splines in both directions. Curves whose first and last points coincide are closed without a kink.
    Lofted {
        /// Points of each curve, length. All curves have the same number of points.
        #[unit(length)]
        #[schemars(length(min = 2), inner(length(min = 2)))]
        sections: Vec<Vec<[f64; 3]>>,
    },
    /// Curve that moves along a path without rotation about it: u is along the curve, v along the path.
    ///
    /// Cubic splines through the points; two points are a straight line.
    Swept {
        /// Points of the curve at the start of the path, length.
        #[unit(length)]
        #[schemars(length(min = 2))]
        profile: Vec<[f64; 3]>,
        /// Points of the path, length. The curve has the same position to its start as to that of the first point.
        #[unit(length)]
        #[schemars(length(min = 2))]
        path: Vec<[f64; 3]>,
    },
}

impl ShellSurface {
    /// Surface for evaluation at many points.
    pub(crate) fn geometry(&self) -> SurfaceGeometry<'_> {
        let spline = match self {
            Self::Lofted { sections } => {
                let origin = self.origin();
                let row = |points: &Vec<[f64; 3]>| {
                    points.iter().map(|point| Vector3::from(*point) - origin).collect()
                };
                SplineSurface::new(&sections.iter().map(row).collect::<Vec<_>>())
            }
            Self::Swept { profile, path } => sweep(profile, path),
            _ => None,
        };
        SurfaceGeometry { surface: Cow::Borrowed(self), spline }
    }

    /// Point to which positions are relative.
    fn origin(&self) -> Vector3<f64> {
        match self {
            Self::Flat { corner, .. } => Vector3::from(*corner),
            Self::Revolved { center, .. } | Self::Sphere { center, .. } => Vector3::from(*center),
            Self::Twisted { from, .. } => Vector3::from(*from),
            Self::Lofted { sections } => Vector3::from(
                sections.first().and_then(|section| section.first()).copied().unwrap_or_default(),
            ),
            Self::Swept { profile, .. } => Vector3::from(profile.first().copied().unwrap_or_default()),
        }
    }
}

/// Middle surface in the reference state.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceGeometry<'a> {
    surface: Cow<'a, ShellSurface>,
    /// Spline relative to the origin; `None` for other surfaces and for points without a spline.
    spline: Option<SplineSurface>,
}

impl SurfaceGeometry<'_> {
    /// Surface without references to the model.
    pub(crate) fn into_owned(self) -> SurfaceGeometry<'static> {
        SurfaceGeometry { surface: Cow::Owned(self.surface.into_owned()), spline: self.spline }
    }

    /// Point to which positions are relative.
    pub(crate) fn origin(&self) -> Vector3<f64> {
        self.surface.origin()
    }

    /// Point of the surface.
    pub(crate) fn point(&self, at: [f64; 2]) -> Vector3<f64> {
        self.origin() + self.map(at)[0]
    }

    /// Values of r, ∂r/∂u, ∂r/∂v and ∂²r/∂u∂v at (u, v), r relative to the [`origin`](Self::origin).
    ///
    /// They are not finite if an axis has no direction, or if points of curves coincide.
    pub(crate) fn map(&self, [u, v]: [f64; 2]) -> [Vector3<f64>; 4] {
        match &*self.surface {
            ShellSurface::Flat { side_u, side_v, .. } => {
                let [a, b] = [side_u, side_v].map(|side| Vector3::from(*side));
                [a * u + b * v, a, b, Vector3::zeros()]
            }
            ShellSurface::Revolved { from, to, center, axis, angle } => {
                let [from, to] = [from, to].map(|point| Vector3::from(*point) - Vector3::from(*center));
                let axis = Vector3::from(*axis).normalize();
                let (point, line) = (from + (to - from) * v, to - from);
                let turn = rotation(&axis, angle * u);
                let spin = axis * *angle;
                let (r, of_v) = (turn * point, turn * line);
                [r, spin.cross(&r), of_v, spin.cross(&of_v)]
            }
            ShellSurface::Sphere { center, equator, axis, angle, latitudes } => {
                let radius = Vector3::from(*equator) - Vector3::from(*center);
                let pole = Vector3::from(*axis).normalize() * radius.norm();
                let rate = latitudes[1] - latitudes[0];
                let (sin, cos) = (latitudes[0] + rate * v).sin_cos();
                let out = rotation(&pole.normalize(), angle * u) * radius;
                let along = pole.normalize().cross(&out) * *angle;
                [out * cos + pole * sin, along * cos, (pole * cos - out * sin) * rate, along * (-sin * rate)]
            }
            ShellSurface::Twisted { from, to, width, twist } => {
                let line = Vector3::from(*to) - Vector3::from(*from);
                let axis = line.normalize();
                let width = rotation(&axis, twist * u) * Vector3::from(*width);
                let rate = axis.cross(&width) * *twist;
                let s = v - 0.5;
                [line * u + width * s, line + rate * s, width, rate]
            }
            ShellSurface::Lofted { .. } | ShellSurface::Swept { .. } => {
                self.spline.as_ref().map_or([Vector3::repeat(f64::NAN); 4], |spline| spline.at([u, v]))
            }
        }
    }
}

/// Rotation about a unit vector.
fn rotation(axis: &Vector3<f64>, angle: f64) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Unit::new_unchecked(*axis), angle)
}
