use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::layer::Layer;
use super::layup::Layup;
use super::membrane::Membrane;
use super::normal::is_parallel;
use super::surface::{ShellSurface, SurfaceGeometry};
use crate::errors::number;
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
    /// Law of the membrane forces; the linear one by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub membrane: Option<Membrane>,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
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

    /// Surface in the reference state.
    pub(crate) fn geometry(&self) -> SurfaceGeometry<'_> {
        self.surface.geometry()
    }

    /// Description of a place at which the normal has the direction of an axis.
    pub(crate) fn normal_along(&self, axis: [f64; 3]) -> Option<String> {
        const PARTS: usize = 16;
        let places =
            (0..=PARTS).flat_map(|i| (0..=PARTS).map(move |j| [i, j].map(|k| k as f64 / PARTS as f64)));
        let geometry = self.geometry();
        let is_normal = |at: &[f64; 2]| {
            let [_, a, b, _] = geometry.map(*at);
            is_parallel(&a.cross(&b), &axis)
        };
        let [u, v] = places.into_iter().find(is_normal)?.map(number);
        Some(format!("the normal of the surface at [u, v] = [{u}, {v}]"))
    }

    /// Point of the surface in the reference state.
    pub fn point(&self, at: [f64; 2]) -> Vector3<f64> {
        self.geometry().point(at)
    }

    /// Opposite corners of the box around points of the surface.
    pub(crate) fn corners(&self) -> [[f64; 3]; 2] {
        const PARTS: usize = 8;
        let (geometry, mut corners) = (self.geometry(), [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]]);
        for (i, j) in (0..=PARTS).flat_map(|i| (0..=PARTS).map(move |j| (i, j))) {
            let point = geometry.point([i as f64 / PARTS as f64, j as f64 / PARTS as f64]);
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
        let (geometry, edge) = (self.geometry(), edge.edge());
        let fixed = if edge.at_end { 1.0 } else { 0.0 };
        let at = |k: usize| {
            let t = k as f64 / PARTS as f64;
            let [_, a, b, _] = geometry.map(if edge.along_v { [fixed, t] } else { [t, fixed] });
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
        let geometry = self.geometry();
        let sum: f64 = (0..=PARTS)
            .flat_map(|i| (0..=PARTS).map(move |j| (i, j)))
            .map(|(i, j)| {
                let [_, a, b, _] = geometry.map([i as f64 / PARTS as f64, j as f64 / PARTS as f64]);
                weight(i) * weight(j) * a.cross(&b).norm()
            })
            .sum();
        sum / (3 * PARTS).pow(2) as f64
    }
}
