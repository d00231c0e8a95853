use std::ops::Range;
use std::sync::Arc;

use ancf::Model;
use ancf::model::Body;
use ancf_surface::Triangles;

use super::inertia_box::{BOX_EDGE, inertia_box, point_mass_radius};
use super::outline::{Outline, SIDES, outline_at};

/// Kind of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyKind {
    /// Beam.
    Beam,
    /// Cable.
    Cable,
    /// Shell.
    Shell,
    /// Rigid body.
    Rigid,
    /// Point mass.
    PointMass,
}

impl BodyKind {
    const fn of(body: &Body) -> Self {
        match body {
            Body::Beam(_) => Self::Beam,
            Body::Cable(_) => Self::Cable,
            Body::Shell(_) | Body::ShearShell(_) => Self::Shell,
            Body::Rigid(_) => Self::Rigid,
            Body::Mass(_) => Self::PointMass,
        }
    }

    /// Word in the scene.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Beam => "beam",
            Self::Cable => "cable",
            Self::Shell => "shell",
            Self::Rigid => "rigid",
            Self::PointMass => "point",
        }
    }
}

/// Grid of the stations of a shell. A mesh has a grid for each element, one after another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceGrid {
    /// Number of grids: 1 for a patch, the number of elements for a mesh.
    pub patches: usize,
    /// Numbers of stations along u and v. Stations are ordered along u first.
    pub counts: [usize; 2],
    /// Cells per element in each direction.
    pub parts: usize,
    /// Half of the thickness; of one that varies, half of the largest at the stations.
    pub half: f64,
}

impl SurfaceGrid {
    /// Corners of each cell, counter-clockwise as seen from the side of the normal, counted from the first station of the body.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 4]> + use<> {
        let [n, m] = self.counts;
        let corners =
            move |i: usize, j: usize| [j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i];
        (0..self.patches).flat_map(move |patch| {
            let cell = move |i: usize, j: usize| corners(i, j).map(|k| patch * n * m + k);
            (0..m.saturating_sub(1)).flat_map(move |j| (0..n.saturating_sub(1)).map(move |i| cell(i, j)))
        })
    }

    /// Stations of the boundary of a grid, counter-clockwise as seen from the side of the normal, counted from its first station.
    pub fn boundary(&self) -> Vec<usize> {
        let [n, m] = self.counts;
        let (last, top) = (n - 1, m - 1);
        let ahead = (0..last).chain((0..top).map(|j| j * n + last));
        let back = (1..=last).rev().map(|i| top * n + i).chain((1..=top).rev().map(|j| j * n));
        ahead.chain(back).collect()
    }
}

/// Shape of a body: an outline swept along its stations, a surface between them, or a box at its only station.
#[derive(Clone, Debug)]
pub struct BodyShape {
    /// Name of the body.
    pub name: String,
    /// Kind of the body.
    pub kind: BodyKind,
    /// Stations of the body.
    pub stations: Range<usize>,
    /// Outline of the section at the start of a flexible body.
    pub outline: Option<Outline>,
    /// Factors of y and z of the outline at each station of a tapered body.
    pub scale: Option<Vec<[f64; 2]>>,
    /// Factor of the bore at each station of a tapered tube.
    pub bore: Option<Vec<f64>>,
    /// Grid of the stations of a shell.
    pub grid: Option<SurfaceGrid>,
    /// Stations at nodes of the mesh, counted from the first station of the body.
    pub nodes: Vec<usize>,
    /// Surface of a rigid body, in components along its directors from its centre.
    pub surface: Option<Arc<Triangles>>,
    /// Half of the edges of the box of a rigid body along its three directors, which contains its surface, or three times the
    /// radius of a point mass.
    pub half_edges: Option<[f64; 3]>,
    /// Principal axes of a rigid body, as components along its directors.
    pub axes: [[f64; 3]; 3],
}

/// Axes of bodies without principal axes.
const GLOBAL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl BodyShape {
    /// Shape of a body of a model in the user's units, with `parts` stations per element and the `size` of the model.
    pub(crate) fn new(
        model: &Model,
        body: &Body,
        surface: Option<Arc<Triangles>>,
        stations: Range<usize>,
        parts: usize,
        size: f64,
    ) -> Self {
        let bounds = surface.as_ref().and_then(|surface| surface.bounds());
        let (half_edges, axes) = match body {
            Body::Rigid(_) if let Some([low, high]) = bounds => {
                (Some([0, 1, 2].map(|k| high[k].max(-low[k]))), GLOBAL)
            }
            Body::Rigid(rigid) => {
                let drawn = inertia_box(rigid, BOX_EDGE * size);
                (Some(drawn.edges.map(|edge| 0.5 * edge)), drawn.axes)
            }
            Body::Mass(mass) => (Some([point_mass_radius(mass, size); 3]), GLOBAL),
            Body::Beam(_) | Body::Cable(_) | Body::Shell(_) | Body::ShearShell(_) => (None, GLOBAL),
        };
        let outline = outline_at(model, body, 0.0, SIDES);
        let count = stations.len();
        Self {
            name: body.name().to_owned(),
            kind: BodyKind::of(body),
            stations,
            scale: taper(model, body, count, |outline| outline.half_extents),
            bore: taper(model, body, count, |outline| [outline.bore()]).map(Vec::into_flattened),
            outline,
            grid: grid(body, parts),
            nodes: nodes(body, parts, count),
            surface,
            half_edges,
            axes,
        }
    }

    /// Shape of a shell with the thickness at its stations.
    #[must_use]
    pub(crate) fn with_thickness(mut self, thickness: &[f64]) -> Self {
        let largest = thickness.iter().copied().fold(0.0, f64::max);
        if let Some(grid) = &mut self.grid
            && thickness.iter().any(|h| *h != largest)
        {
            grid.half = 0.5 * largest;
            self.scale = Some(thickness.iter().map(|h| [h / largest; 2]).collect());
        }
        self
    }

    /// Factor of the bore of a tube at a station, counted from the first station of the body.
    pub fn bore_at(&self, station: usize) -> f64 {
        self.bore.as_ref().and_then(|bore| bore.get(station).copied()).unwrap_or(1.0)
    }

    /// Factors of y and z, or of the thickness, at a station, counted from the first station of the body.
    pub fn scale_at(&self, station: usize) -> [f64; 2] {
        self.scale.as_ref().and_then(|scale| scale.get(station).copied()).unwrap_or([1.0; 2])
    }
}

/// Sizes of the section at the stations of a body, relative to the first one; `None` if they are equal.
fn taper<const N: usize>(
    model: &Model,
    body: &Body,
    count: usize,
    sizes: impl Fn(&Outline) -> [f64; N],
) -> Option<Vec<[f64; N]>> {
    let sizes = |fraction| Some(sizes(&outline_at(model, body, fraction, SIDES)?));
    let start = sizes(0.0)?;
    if sizes(1.0)? == start {
        return None;
    }
    let at = |k: usize| -> Option<[f64; N]> {
        let own = sizes(k as f64 / (count - 1).max(1) as f64)?;
        Some(std::array::from_fn(|i| own[i] / start[i]))
    };
    (0..count).map(at).collect()
}

/// Grid of the stations of a shell.
fn grid(body: &Body, parts: usize) -> Option<SurfaceGrid> {
    match body {
        Body::Shell(shell) => {
            let counts = shell.elements.map(|count| count as usize * parts + 1);
            Some(SurfaceGrid { patches: 1, counts, parts, half: 0.5 * shell.layup().thickness })
        }
        Body::ShearShell(shell) => {
            let patches = shell.mesh.elements.len();
            Some(SurfaceGrid { patches, counts: [parts + 1; 2], parts, half: 0.5 * shell.layup().thickness })
        }
        _ => None,
    }
}

/// Stations at nodes: the ends of elements, and the middle node of quadratic elements if it has a station.
fn nodes(body: &Body, parts: usize, count: usize) -> Vec<usize> {
    if let Some(SurfaceGrid { patches, counts: [n, m], .. }) = grid(body, parts) {
        let row = |patch: usize, j: usize| (0..n).step_by(parts).map(move |i| (patch * m + j) * n + i);
        let rows = (0..patches).flat_map(|patch| (0..m).step_by(parts).map(move |j| (patch, j)));
        return rows.flat_map(|(patch, j)| row(patch, j)).collect();
    }
    let is_quadratic = matches!(body, Body::Beam(beam) if beam.formulation.has_middle_node());
    let stride = if is_quadratic && parts.is_multiple_of(2) { parts / 2 } else { parts };
    (0..count).step_by(stride.max(1)).collect()
}
