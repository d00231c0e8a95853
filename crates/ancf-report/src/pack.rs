//! The parts of a scene in the words of its container.

use ancf::scales::Dimension;
use nalgebra::Vector3;
use serde_json::{Value, json};

use crate::container::Blob;
use crate::frame::Frame;
use crate::instants::Instants;
use crate::obstacle::Obstacle;
use crate::stage::{self, Stage};
use crate::{Drawn, Geometry, Placement, Quantity, Recording};

/// By how much a cylinder without end reaches beyond the bodies, over the size of the model.
const BEYOND: f64 = 0.04;

/// The box about everything in all frames.
pub(crate) fn bounds(stage: &Stage<'_>, geometry: &Geometry<'_>, instants: &Instants<'_>) -> Value {
    let unit = stage.length();
    let placed = instants.placed.iter().chain([&instants.reference]);
    let centres = placed.flat_map(|placed| placed.centres.iter().copied());
    let states = || instants.states.iter();
    let marks = states().flat_map(|s| stage.markers.iter().map(|marker| marker.at(s) * unit));
    let ends = states().flat_map(|s| stage.links.iter().flat_map(|link| link.ends(s)).map(|end| end * unit));
    let [low, high] = stage::bounds(centres.chain(marks).chain(ends));
    let thick = geometry.bodies.iter().map(thickness).fold(0.0, f64::max);
    let corner = |x: Vector3<f64>, by: f64| <[f64; 3]>::from(x.add_scalar(by));
    json!([corner(low, -thick), corner(high, thick)])
}

/// How far a body may reach from its stations.
fn thickness(drawn: &Drawn) -> f64 {
    let outline = drawn.outline.as_ref().map_or(0.0, |outline| outline.half[0].hypot(outline.half[1]));
    let scale = drawn.scale.iter().flatten().flatten().copied().fold(1.0, f64::max);
    drawn.half_edges.map_or(outline * scale, |[x, y, z]| x.max(y).max(z))
}

pub(crate) fn body(drawn: &Drawn, blob: &mut Blob) -> Value {
    let outline = drawn.outline.as_ref();
    let scale = drawn.scale.as_ref().map(|scale| blob.f32(scale.iter().flatten().copied()));
    let first = drawn.stations.start;
    let nodes: Vec<usize> = drawn.nodes.iter().map(|node| first + node).collect();
    json!({
        "name": drawn.name,
        "kind": drawn.kind.word(),
        "first": first,
        "count": drawn.stations.len(),
        "outline": outline.map_or(&[] as &[_], |outline| &outline.outer),
        "inner": outline.and_then(|outline| outline.inner.as_ref()),
        "scale": scale,
        "nodes": nodes,
        "box": drawn.half_edges,
    })
}

pub(crate) fn centres(placed: &[Placement], blob: &mut Blob) -> Value {
    blob.f32(placed.iter().flat_map(|placed| placed.centres.iter().copied().flat_map(three)))
}

pub(crate) fn directors(placed: &[Placement], blob: &mut Blob) -> Value {
    blob.i16(placed.iter().flat_map(|placed| placed.directors.iter().copied().flat_map(nine)))
}

pub(crate) fn field(recording: &Recording<'_>, field: &Quantity, blob: &mut Blob) -> Value {
    let finite = || field.values.iter().copied().filter(|x| x.is_finite()).map(f64::from);
    let range = [finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max)];
    json!({
        "name": field.name,
        "symbol": field.symbol,
        "unit": recording.unit(field.dimension),
        "diverging": field.diverging,
        "range": range,
        "values": blob.u16(field.values.iter().copied().map(f64::from), range),
    })
}

pub(crate) fn markers(stage: &Stage<'_>, instants: &Instants<'_>, blob: &mut Blob) -> Value {
    let unit = stage.length();
    let of = |marker: &crate::marker::Marker| {
        let at = blob.f32(instants.states.iter().flat_map(|s| three(marker.at(s) * unit)));
        let reference = three(marker.at(&instants.about) * unit);
        let (name, kind, detail) = (&marker.name, marker.kind, &marker.detail);
        json!({ "name": name, "kind": kind, "detail": detail, "at": at, "reference": reference })
    };
    stage.markers.iter().map(of).collect()
}

/// What joints exert on their ends `a`; nothing of shapes, which have no size of their own.
pub(crate) fn reactions(stage: &Stage<'_>, instants: &Instants<'_>, blob: &mut Blob) -> Value {
    if stage.recording.is_modal() {
        return Value::Array(Vec::new());
    }
    let (assembly, scales) = (stage.recording.simulation.assembly(), stage.recording.scales());
    let units = [scales.unit(Dimension::FORCE), scales.unit(Dimension::ENERGY)];
    let all: Vec<Vec<_>> = instants.states.iter().map(|s| assembly.reactions(s).collect()).collect();
    let names = assembly.joints().zip(&stage.of_joints).enumerate();
    let of = |(joint, (name, marker)): (usize, (&str, &Option<usize>))| {
        let marker = (*marker)?;
        let force = blob.f32(all.iter().flat_map(|wrenches| three(wrenches[joint].force * units[0])));
        let moment = blob.f32(all.iter().flat_map(|wrenches| three(wrenches[joint].moment * units[1])));
        Some(json!({ "name": name, "marker": marker, "force": force, "moment": moment }))
    };
    names.filter_map(of).collect()
}

pub(crate) fn links(stage: &Stage<'_>, instants: &Instants<'_>, blob: &mut Blob) -> Value {
    let unit = stage.length();
    let of = |link: &crate::link::Link| {
        let ends = instants.states.iter().flat_map(|s| link.ends(s));
        let ends = blob.f32(ends.flat_map(|end| three(end * unit)));
        let reference = link.ends(&instants.about).map(|end| three(end * unit));
        json!({ "name": link.name, "kind": link.kind, "ends": ends, "reference": reference })
    };
    stage.links.iter().map(of).collect()
}

pub(crate) fn obstacles(stage: &Stage<'_>, instants: &Instants<'_>, blob: &mut Blob) -> Value {
    let unit = stage.length();
    let of = |obstacle: &Obstacle| {
        let reach = reach(stage, obstacle, &instants.reference);
        let count = if obstacle.moves { instants.states.len() } else { 1 };
        let pose = instants.states.iter().take(count).flat_map(|s| {
            let (point, axes) = obstacle.pose(s);
            let middle = reach.map_or(0.0, |[middle, _]| middle);
            three(point * unit + axes[0] * middle).into_iter().chain(nine(axes))
        });
        json!({
            "name": obstacle.name,
            "kind": obstacle.kind,
            "radius": obstacle.radius * unit,
            "length": reach.map(|[_, length]| length),
            "inside": obstacle.inside,
            "pose": blob.f32(pose),
        })
    };
    stage.obstacles.iter().map(of).collect()
}

/// Where the middle of a cylinder is along its axis, from its point, and its length: it has no ends, and is shown where the
/// bodies are.
pub(crate) fn reach(stage: &Stage<'_>, obstacle: &Obstacle, reference: &Placement) -> Option<[f64; 2]> {
    let initial = stage.recording.simulation.assembly().initial();
    let (point, [axis, ..]) = obstacle.pose(&initial);
    let point = point * stage.length();
    let along = reference.centres.iter().map(|x| (x - point).dot(&axis)).filter(|x| x.is_finite());
    let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
    let bounded = obstacle.kind == "cylinder" && low <= high;
    bounded.then_some([0.5 * (low + high), high - low + 2.0 * BEYOND * stage.size])
}

/// Numbers that can be drawn.
fn three(x: Vector3<f64>) -> [f64; 3] {
    <[f64; 3]>::from(x).map(|x| if x.is_finite() { x } else { 0.0 })
}

fn nine(axes: Frame) -> impl Iterator<Item = f64> {
    axes.into_iter().flat_map(three)
}
