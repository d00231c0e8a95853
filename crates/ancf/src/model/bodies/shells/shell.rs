use ancf_mechanics::shells::ShellProfile;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fields::{
    FibreAngle, FibreAxis, FieldPlace, FieldPoint, FieldShell, GivenFields, ShellThickness, is_parallel,
};
use super::layer::Layer;
use super::layup::Layup;
use super::membrane::Membrane;
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
    /// Thickness, length: a number or a field.
    pub thickness: ShellThickness,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// Layers from the lower to the upper side in the direction of the normal; by default a single one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// Axis whose projection on the surface has the fibre angle zero, a vector or a field; by default the direction of u.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_axis: Option<FibreAxis>,
    /// Angle about the normal by which all fibres are turned, in radians: a number or a field; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_angle: Option<FibreAngle>,
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
        let (thickness, varies) = (self.thickness_range().mean, self.has_varying_thickness());
        Layup { thickness, varies, material: &self.material, layers: &self.layers }
    }

    /// Layers with their thicknesses, from the lower to the upper side.
    pub(crate) fn layers(&self) -> Vec<(&str, f64, f64)> {
        self.layup().plies()
    }

    /// Element of a point (u, v), and (ξ, η) in it.
    pub(crate) fn element_at(&self, at: [f64; 2]) -> (usize, [f64; 2]) {
        let of = |k: usize| {
            let (count, x) = (self.elements[k] as usize, at[k] * f64::from(self.elements[k]));
            let element = (x.max(0.0) as usize).min(count - 1);
            (element, x - element as f64)
        };
        let ((i, x), (j, y)) = (of(0), of(1));
        (j * self.elements[0] as usize + i, [x, y])
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

/// Largest number of cells in a direction on which the range of the thickness is evaluated.
const CELLS: usize = 16;

impl FieldShell for Shell {
    fn given(&self) -> GivenFields<'_> {
        GivenFields {
            thickness: &self.thickness,
            angle: self.fibre_angle.as_ref(),
            axis: self.fibre_axis.as_ref(),
            is_patch: true,
        }
    }

    fn field_points(&self) -> Box<dyn Fn(usize, [f64; 2]) -> FieldPoint + Send + Sync> {
        let (geometry, [n, m]) = (self.geometry().into_owned(), self.elements.map(|count| count as usize));
        Box::new(move |element, [x, y]| {
            let parameters = [((element % n) as f64 + x) / n as f64, ((element / n) as f64 + y) / m as f64];
            let [r, a, b, _] = geometry.map(parameters);
            let position = geometry.origin() + r;
            FieldPoint { position, parameters: Some(parameters), normal: a.cross(&b), nodes: [(0, 0.0); 4] }
        })
    }

    fn field_places(&self) -> Box<dyn Iterator<Item = FieldPlace> + '_> {
        let places = ShellProfile::section_places();
        let elements = 0..self.elements.iter().map(|count| *count as usize).product();
        Box::new(
            elements.flat_map(move |k| places.clone().into_iter().map(move |(at, weight)| (k, at, weight))),
        )
    }

    fn describe_point(&self, element: usize, point: &FieldPoint) -> String {
        let [u, v] = point.parameters.unwrap_or_default().map(number);
        let n = self.elements[0] as usize;
        format!("[u, v] = [{u}, {v}], element {}, {}", element % n + 1, element / n + 1)
    }

    fn range_places(&self) -> Box<dyn Iterator<Item = FieldPlace> + '_> {
        let cells = self.elements.map(|count| (count as usize).min(CELLS));
        let all = (0..cells[1]).flat_map(move |j| (0..cells[0]).map(move |i| [i, j]));
        let places = ShellProfile::section_places();
        let of_cell = move |cell: [usize; 2]| {
            let place = move |(at, weight): ([f64; 2], f64)| {
                let of = |k: usize| (cell[k] as f64 + at[k]) / cells[k] as f64;
                let (element, local) = self.element_at([of(0), of(1)]);
                (element, local, weight)
            };
            places.clone().into_iter().map(place)
        };
        Box::new(all.flat_map(of_cell))
    }
}
