use std::ops::Range;

use ancf::Model;
use ancf::model::{Body, Rigid};
use nalgebra::Matrix3;

use crate::Outline;

/// The greatest edge of the box that stands for a rigid body, over the size of the model.
const BOX: f64 = 0.12;
/// The least edge over the greatest: a needle or a plate is to be seen too.
const FLAT: f64 = 0.15;
/// The radius of the ball that stands for a point mass, over the size of the model.
const BALL: f64 = 0.02;

/// What kind of body it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A beam.
    Beam,
    /// A cable.
    Cable,
    /// A rigid body.
    Rigid,
    /// A point mass.
    Point,
}

impl Kind {
    /// Its word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Beam => "beam",
            Self::Cable => "cable",
            Self::Rigid => "rigid",
            Self::Point => "point",
        }
    }
}

/// How a body is drawn: an outline swept through its stations, or a box at its only one.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Its stations.
    pub stations: Range<usize>,
    /// The outline of its section at the start, if it is flexible.
    pub outline: Option<Outline>,
    /// Factors of y and z of the outline at each of its stations, if they vary.
    pub scale: Option<Vec<[f64; 2]>>,
    /// Stations that are nodes of its mesh, counted from its first one.
    pub nodes: Vec<usize>,
    /// Half of the edges of a box along the three directors, or three times the radius of a ball.
    pub half_edges: Option<[f64; 3]>,
    /// Principal axes of a rigid body, as columns in its own axes: its directors are turned by them.
    pub axes: Matrix3<f64>,
}

impl Drawn {
    /// How a body of a model in the user's units is drawn; `parts` are the stations of an element, `size` that of the model.
    pub(crate) fn new(model: &Model, body: &Body, stations: Range<usize>, parts: usize, size: f64) -> Self {
        let kind = match body {
            Body::Beam(_) => Kind::Beam,
            Body::Cable(_) => Kind::Cable,
            Body::Rigid(_) => Kind::Rigid,
            Body::Mass(_) => Kind::Point,
        };
        let (half_edges, axes) = match body {
            Body::Rigid(rigid) => {
                let (edges, axes) = inertial(rigid, BOX * size);
                (Some(edges.map(|edge| 0.5 * edge)), axes)
            }
            Body::Mass(_) => (Some([BALL * size; 3]), Matrix3::identity()),
            Body::Beam(_) | Body::Cable(_) => (None, Matrix3::identity()),
        };
        let outline = model.section_at(body, 0.0).map(|section| Outline::of(&section));
        let count = stations.len();
        Self {
            name: body.name().to_owned(),
            kind,
            stations,
            scale: outline.as_ref().and_then(|outline| taper(model, body, outline, count)),
            outline,
            nodes: nodes(body, parts, count),
            half_edges,
            axes,
        }
    }

    /// Factors of y and z at one of its stations.
    pub fn scale_at(&self, station: usize) -> [f64; 2] {
        self.scale.as_ref().and_then(|scale| scale.get(station).copied()).unwrap_or([1.0; 2])
    }
}

/// Factors of y and z at the stations of a body with two sections.
fn taper(model: &Model, body: &Body, start: &Outline, count: usize) -> Option<Vec<[f64; 2]>> {
    let end = Outline::of(&model.section_at(body, 1.0)?);
    if end.half == start.half {
        return None;
    }
    let at = |k: usize| -> Option<[f64; 2]> {
        let part = k as f64 / (count - 1).max(1) as f64;
        let half = Outline::of(&model.section_at(body, part)?).half;
        Some([half[0] / start.half[0], half[1] / start.half[1]])
    };
    (0..count).map(at).collect()
}

/// Stations at nodes: the ends of elements, and their middles if there is a node and a station.
fn nodes(body: &Body, parts: usize, count: usize) -> Vec<usize> {
    let quadratic =
        matches!(body, Body::Beam(beam) if beam.formulation == ancf::model::Formulation::Quadratic);
    let stride = if quadratic && parts.is_multiple_of(2) { parts / 2 } else { parts };
    (0..count).step_by(stride.max(1)).collect()
}

/// Edges and axes of the box with the inertia of a rigid body, at most `greatest`.
///
/// A box of mass m with edges a, b, c has I_a = m (b² + c²)/12, so that a² = 6 (I_b + I_c − I_a)/m.
fn inertial(body: &Rigid, greatest: f64) -> ([f64; 3], Matrix3<f64>) {
    let tensor = body.tensor();
    let diagonal = tensor == Matrix3::from_diagonal(&tensor.diagonal());
    let (moments, mut axes) = if diagonal {
        (tensor.diagonal(), Matrix3::identity())
    } else {
        let eigen = tensor.symmetric_eigen();
        (eigen.eigenvalues, eigen.eigenvectors)
    };
    if axes.determinant() < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    let edge = |moment: f64| (6.0 * (moments.sum() - 2.0 * moment) / body.mass).max(0.0).sqrt();
    let edges: [f64; 3] = moments.map(edge).into();
    let longest = edges.iter().copied().fold(0.0, f64::max);
    if longest == 0.0 || !longest.is_finite() {
        return ([greatest; 3], Matrix3::identity());
    }
    let shrunk = (greatest / longest).min(1.0);
    (edges.map(|edge| edge.max(FLAT * longest) * shrunk), axes)
}
