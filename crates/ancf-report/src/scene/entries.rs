//! Entries of the header of a scene, with their arrays in the blob.

use ancf::units::Dimension;
use ancf_surface::Triangles;
use nalgebra::Vector3;
use serde_json::{Value, json};

use super::container::Blob;
use super::drawn_frames::DrawnFrames;
use super::scene_layout::SceneLayout;
use crate::fields::ScalarField;
use crate::geometry::{
    BodyShape, EdgeSupport, Geometry, Link, Obstacle, Placement, ShellLoad, Symbol, Triad, bounding_box,
    edge_supports, shell_loads,
};
use crate::run::Recording;

/// Box around all objects in all frames.
pub(super) fn bounds(layout: &SceneLayout<'_>, geometry: &Geometry<'_>, frames: &DrawnFrames<'_>) -> Value {
    let placed = frames.placed.iter().chain([&frames.reference]);
    let centres = placed.flat_map(|placed| placed.centres.iter().copied());
    let states = || frames.states.iter();
    let symbols = states().flat_map(|s| layout.symbols.all.iter().map(|symbol| symbol.position(s).into()));
    let ends = states().flat_map(|s| layout.links.iter().flat_map(|link| link.ends(s)));
    let [low, high] = bounding_box(centres.chain(symbols).chain(ends));
    let margin = geometry.bodies.iter().map(max_distance).fold(0.0, f64::max);
    let corner = |x: Vector3<f64>, by: f64| <[f64; 3]>::from(x.add_scalar(by));
    json!([corner(low, -margin), corner(high, margin)])
}

/// Maximum distance of the surface of a body from its stations.
fn max_distance(shape: &BodyShape) -> f64 {
    let outline = shape.outline.as_ref();
    let outline = outline.map_or(0.0, |outline| outline.half_extents[0].hypot(outline.half_extents[1]));
    let scale = shape.scale.iter().flatten().flatten().copied().fold(1.0, f64::max);
    match shape.half_edges {
        Some([x, y, z]) if shape.surface.is_some() => x.hypot(y).hypot(z),
        Some([x, y, z]) => x.max(y).max(z),
        None => shape.grid.map_or(outline * scale, |grid| grid.half),
    }
}

pub(super) fn body(shape: &BodyShape, blob: &mut Blob) -> Value {
    let outline = shape.outline.as_ref();
    let scale = shape.scale.as_ref().map(|scale| blob.f32(scale.iter().flatten().copied()));
    let bore = shape.bore.as_ref().map(|bore| blob.f32(bore.iter().copied()));
    let first = shape.stations.start;
    let nodes: Vec<usize> = shape.nodes.iter().map(|node| first + node).collect();
    json!({
        "name": shape.name,
        "kind": shape.kind.word(),
        "first": first,
        "count": shape.stations.len(),
        "outline": outline.map_or(&[] as &[_], |outline| &outline.outer),
        "inner": outline.and_then(|outline| outline.inner.as_ref()),
        "scale": scale,
        "bore": bore,
        "grid": shape.grid.map(|grid| json!({
            "patches": grid.patches,
            "counts": grid.counts,
            "parts": grid.parts,
            "half": grid.half,
        })),
        "nodes": nodes,
        "box": shape.half_edges,
        "surface": shape.surface.as_ref().map(|triangles| surface(triangles, blob)),
    })
}

fn surface(triangles: &Triangles, blob: &mut Blob) -> Value {
    let shaded = triangles.shaded();
    json!({
        "points": blob.f32(shaded.points.iter().flatten().copied()),
        "normals": blob.i16(shaded.normals.into_iter().flatten()),
        "corners": blob.u32(shaded.corners.into_iter().flatten()),
    })
}

pub(super) fn centres(placed: &[Placement], blob: &mut Blob) -> Value {
    blob.f32(placed.iter().flat_map(|placed| placed.centres.iter().copied().flat_map(finite)))
}

pub(super) fn directors(placed: &[Placement], blob: &mut Blob) -> Value {
    blob.i16(placed.iter().flat_map(|placed| placed.directors.iter().copied().flat_map(nine)))
}

pub(super) fn field(recording: &Recording<'_>, field: &ScalarField, blob: &mut Blob) -> Value {
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

pub(super) fn symbols(layout: &SceneLayout<'_>, frames: &DrawnFrames<'_>, blob: &mut Blob) -> Value {
    let of = |symbol: &Symbol| {
        let at = blob.f32(frames.states.iter().flat_map(|s| finite(symbol.position(s).into())));
        let reference = finite(symbol.position(&frames.reference_state).into());
        let (name, kind, detail) = (&symbol.name, symbol.kind.word(), &symbol.detail);
        json!({ "name": name, "kind": kind, "detail": detail, "at": at, "reference": reference })
    };
    layout.symbols.all.iter().map(of).collect()
}

/// Forces and moments of joints on their ends `a`. Mode shapes have none, because their amplitude is arbitrary.
pub(super) fn reactions(layout: &SceneLayout<'_>, frames: &DrawnFrames<'_>, blob: &mut Blob) -> Value {
    if layout.recording.is_modal() {
        return Value::Array(Vec::new());
    }
    let (assembly, scales) = (layout.recording.simulation.assembly(), layout.recording.scales());
    let units = [scales.unit(Dimension::FORCE), scales.unit(Dimension::ENERGY)];
    let all: Vec<Vec<_>> = frames.states.iter().map(|s| assembly.reactions(s).collect()).collect();
    let names = assembly.joints().zip(&layout.symbols.of_joints).enumerate();
    let of = |(joint, (name, symbol)): (usize, (&str, &Option<usize>))| {
        let symbol = (*symbol)?;
        let force = blob.f32(all.iter().flat_map(|wrenches| finite(wrenches[joint].force * units[0])));
        let moment = blob.f32(all.iter().flat_map(|wrenches| finite(wrenches[joint].moment * units[1])));
        Some(json!({ "name": name, "marker": symbol, "force": force, "moment": moment }))
    };
    names.filter_map(of).collect()
}

/// Stations along the edges that joints support.
pub(super) fn supports(layout: &SceneLayout<'_>, geometry: &Geometry<'_>) -> Value {
    let of = |support: EdgeSupport| {
        let marker = layout.symbols.of_joints.get(support.joint).copied().flatten();
        json!({ "marker": marker, "stations": support.stations })
    };
    edge_supports(layout.recording.model, &geometry.bodies).into_iter().map(of).collect()
}

/// Arrows of the loads on shells. Mode shapes have none.
pub(super) fn loads(
    layout: &SceneLayout<'_>,
    geometry: &Geometry<'_>,
    frames: &DrawnFrames<'_>,
    blob: &mut Blob,
) -> Value {
    let undeformed = geometry.place(&layout.recording.simulation.assembly().rest());
    let of = |load: ShellLoad| {
        let all = frames.states.iter().zip(&frames.placed).zip(&frames.positions);
        let vectors = all.flat_map(|((s, placed), time)| load.vectors([placed, &undeformed], s, *time));
        let vectors = blob.f32(vectors.flat_map(finite));
        json!({ "kind": load.noun, "moment": load.is_moment, "stations": load.stations, "vectors": vectors })
    };
    let loads = shell_loads(layout.recording.model, &geometry.bodies).into_iter();
    loads.filter(|_| !layout.recording.is_modal()).map(of).collect()
}

pub(super) fn links(layout: &SceneLayout<'_>, frames: &DrawnFrames<'_>, blob: &mut Blob) -> Value {
    let of = |link: &Link| {
        let ends = blob.f32(frames.states.iter().flat_map(|s| link.ends(s)).flat_map(finite));
        let reference = link.ends(&frames.reference_state).map(finite);
        json!({ "name": link.name, "kind": link.kind, "ends": ends, "reference": reference })
    };
    layout.links.iter().map(of).collect()
}

pub(super) fn obstacles(layout: &SceneLayout<'_>, frames: &DrawnFrames<'_>, blob: &mut Blob) -> Value {
    let initial = layout.recording.simulation.assembly().initial();
    let of = |obstacle: &Obstacle| {
        let part = obstacle.drawn_part(&initial, &frames.reference, layout.size);
        let count = if obstacle.moves { frames.states.len() } else { 1 };
        let pose = frames.states.iter().take(count).flat_map(|s| {
            let (point, axes) = obstacle.pose(s);
            let middle = part.map_or(0.0, |[middle, _]| middle);
            finite(point + axes[0] * middle).into_iter().chain(nine(axes))
        });
        json!({
            "name": obstacle.name,
            "kind": obstacle.kind.word(),
            "radius": obstacle.radius,
            "length": part.map(|[_, length]| length),
            "inside": obstacle.inside,
            "pose": blob.f32(pose),
        })
    };
    layout.obstacles.iter().map(of).collect()
}

/// Components of a vector, with 0 in place of those that are not finite.
fn finite(x: Vector3<f64>) -> [f64; 3] {
    <[f64; 3]>::from(x).map(|x| if x.is_finite() { x } else { 0.0 })
}

fn nine(axes: Triad) -> impl Iterator<Item = f64> {
    axes.into_iter().flat_map(finite)
}
