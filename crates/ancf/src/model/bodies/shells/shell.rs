use nalgebra::{Rotation3, Unit, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::layer::Layer;
use super::layup::Layup;
use crate::model::bodies::parts::{EdgeName, InitialMotion};
use crate::units::Scaled;

/// Thin shell or plate of bicubic Hermite elements on a patch 0 ≤ u, v ≤ 1, by the Kirchhoff-Love theory.
///
/// Without transverse shear and rotary inertia: the thickness should be below a tenth of the shortest half-wave of the deformation.
///
/// Source: Bogner, Fox & Schmit (1965); Dmitrochenko & Pogorelov (2003).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Shell {
    /// Name of the shell in joints, loads and probes.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Middle surface in the reference state, which is free of stress.
    pub surface: ShellSurface,
    /// Numbers of elements along u and v.
    #[schemars(inner(range(min = 1)))]
    #[unit(none)]
    pub elements: [u32; 2],
    /// Thickness, length.
    #[unit(length)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: f64,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// Layers from the lower to the upper side in the direction of the normal; by default a single one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// Axis whose projection on the surface has the fibre angle zero; by default the direction of u.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(none)]
    pub fibre_axis: Option<[f64; 3]>,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

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
}

impl Shell {
    /// Thickness, material and layers.
    pub fn layup(&self) -> Layup<'_> {
        Layup { thickness: self.thickness, material: &self.material, layers: &self.layers }
    }

    /// Layers with their thicknesses, from the lower to the upper side.
    pub(crate) fn layers(&self) -> Vec<(&str, f64, f64)> {
        self.layup().plies()
    }

    /// Point of the surface that positions are relative to: r(0, 0).
    pub(crate) fn origin(&self) -> Vector3<f64> {
        match &self.surface {
            ShellSurface::Flat { corner, .. } => Vector3::from(*corner),
            ShellSurface::Revolved { center, .. } | ShellSurface::Sphere { center, .. } => {
                Vector3::from(*center)
            }
            ShellSurface::Twisted { from, .. } => Vector3::from(*from),
        }
    }

    /// Values of r, ∂r/∂u, ∂r/∂v and ∂²r/∂u∂v at (u, v), r relative to the [`origin`](Self::origin).
    ///
    /// They are not finite if an axis has no direction.
    pub(crate) fn map(&self, [u, v]: [f64; 2]) -> [Vector3<f64>; 4] {
        match &self.surface {
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
        }
    }

    /// Point of the surface in the reference state.
    pub fn point(&self, at: [f64; 2]) -> Vector3<f64> {
        self.origin() + self.map(at)[0]
    }

    /// Opposite corners of the box around points of the surface.
    pub(crate) fn corners(&self) -> [[f64; 3]; 2] {
        const PARTS: usize = 8;
        let mut corners = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for (i, j) in (0..=PARTS).flat_map(|i| (0..=PARTS).map(move |j| (i, j))) {
            let point = self.point([i as f64 / PARTS as f64, j as f64 / PARTS as f64]);
            for k in 0..3 {
                corners[0][k] = corners[0][k].min(point[k]);
                corners[1][k] = corners[1][k].max(point[k]);
            }
        }
        corners
    }

    /// Length of the shell: the diagonal of the box around it.
    pub(crate) fn extent(&self) -> f64 {
        let [low, high] = self.corners().map(Vector3::from);
        (high - low).norm()
    }

    /// True if the lines across an edge meet it at right angles to one plane, in which the edge lies.
    pub(crate) fn is_plane_edge(&self, edge: &EdgeName) -> bool {
        const PARTS: usize = 8;
        let edge = edge.edge();
        let fixed = if edge.at_end { 1.0 } else { 0.0 };
        let at = |k: usize| {
            let t = k as f64 / PARTS as f64;
            let [_, a, b, _] = self.map(if edge.along_v { [fixed, t] } else { [t, fixed] });
            if edge.along_v { [a.normalize(), b.normalize()] } else { [b.normalize(), a.normalize()] }
        };
        let [normal, _] = at(0);
        (0..=PARTS)
            .map(at)
            .all(|[across, along]| (across - normal).norm() < 1e-9 && along.dot(&normal).abs() < 1e-9)
    }

    /// Area of the middle surface, by Simpson's rule.
    pub fn area(&self) -> f64 {
        const PARTS: usize = 32;
        let weight = |k: usize| match k {
            0 | PARTS => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let sum: f64 = (0..=PARTS)
            .flat_map(|i| (0..=PARTS).map(move |j| (i, j)))
            .map(|(i, j)| {
                let [_, a, b, _] = self.map([i as f64 / PARTS as f64, j as f64 / PARTS as f64]);
                weight(i) * weight(j) * a.cross(&b).norm()
            })
            .sum();
        sum / (3 * PARTS).pow(2) as f64
    }
}

/// Rotation about a unit vector.
fn rotation(axis: &Vector3<f64>, angle: f64) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Unit::new_unchecked(*axis), angle)
}
