use ancf::model::Body;
use nalgebra::Vector3;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::container::Blob;
use super::drawn_frames::DrawnFrames;
use super::scene_layout::{PARTS, SceneLayout};
use super::{entries, messages};
use crate::charts::Charts;
use crate::fields::ScalarFields;
use crate::geometry::Geometry;
use crate::run::Recording;

/// Default budget of a scene in bytes, before compression.
pub const BUDGET: usize = 32 << 20;
/// Maximum number of rows of charts, about.
const ROWS: usize = 4000;

/// Builds the scene of a recording as a [`container`](super::container) of about `budget` bytes at most.
///
/// To fit into the budget, stations between nodes are omitted first, then frames. The messages of the scene report omissions.
pub fn scene(recording: &Recording<'_>, budget: usize) -> Vec<u8> {
    let scaled = recording.model.scaled(&recording.scales());
    let layout = SceneLayout::new(recording, &scaled);
    let mut blob = Blob::default();
    let mut header = heading(recording);
    add_charts(recording, budget, &mut header, &mut blob);
    add_bodies(&layout, budget - budget / 4, &mut header, &mut blob);
    blob.packed(&header)
}

/// Entries of the run as a whole.
fn heading(recording: &Recording<'_>) -> Value {
    let units = recording.model.units.as_ref();
    let units = units.map(|u| json!({ "length": u.length, "time": u.time, "force": u.force }));
    let hash: String = Sha256::digest(recording.text).iter().map(|byte| format!("{byte:02x}")).collect();
    json!({
        "program": concat!("ancf ", env!("CARGO_PKG_VERSION")),
        "title": recording.title,
        "text": recording.text,
        "sha256": hash,
        "analysis": recording.analysis(),
        "units": units,
        "outcome": { "kind": recording.ending.word(), "message": recording.ending.message() },
        "live": recording.live,
        "summary": recording.summary,
    })
}

fn add_charts(recording: &Recording<'_>, budget: usize, header: &mut Value, blob: &mut Blob) {
    let most = (budget / 4 / (4 * Charts::columns(recording))).clamp(2, ROWS);
    let Charts { abscissa, charts } = Charts::new(recording, most);
    let mut packed = Vec::new();
    for chart in charts {
        let columns = chart.columns.into_iter().map(|column| {
            let values = blob.f32(column.values);
            let (name, label, unit) = (column.name, column.label, column.unit);
            let mut packed = json!({ "name": name, "label": label, "unit": unit, "values": values });
            if !column.errors.is_empty() {
                packed["errors"] = blob.f32(column.errors);
            }
            packed
        });
        let (columns, group): (Vec<_>, _) = (columns.collect(), chart.group.word());
        packed.push(json!({ "title": chart.title, "group": group, "log": chart.log, "columns": columns }));
    }
    header["charts"] = Value::Array(packed);
    let values = blob.f64(abscissa.values);
    header["abscissa"] = json!({ "name": abscissa.name, "unit": abscissa.unit, "values": values });
}

/// Adds the bodies in all frames, symbols, reactions, links and obstacles.
fn add_bodies(layout: &SceneLayout<'_>, budget: usize, header: &mut Value, blob: &mut Blob) {
    let recording = layout.recording;
    let (parts, most) = layout.resolution(budget);
    let (assembly, scales) = (recording.simulation.assembly(), recording.scales());
    let geometry = Geometry::new(recording.model, assembly, scales, recording.surfaces, parts, layout.size);
    let mut notes = recording.messages.clone();
    let has_mesh = |body: &Body| body.is_flexible() || body.is_shell();
    if parts < PARTS && recording.model.bodies.iter().any(has_mesh) {
        notes.push(messages::coarse(parts));
    }
    let frames = DrawnFrames::new(recording, &geometry, layout.size, most, &mut notes);
    let mut fields = ScalarFields::new(recording.model, assembly, scales, &geometry, &recording.body_errors);
    for (number, s) in frames.states.iter().enumerate() {
        fields.push(&geometry, s, &frames.parts(number), &frames.reference);
    }
    let fields = fields.into_defined();
    let labels = frames.labels.as_ref();
    let positions = blob.f64(frames.positions.iter().copied());
    header["messages"] = json!(notes);
    header["bounds"] = entries::bounds(layout, &geometry, &frames);
    header["size"] = json!(layout.size);
    header["up"] = json!(up(recording.model.gravity));
    header["frames"] = json!({
        "count": frames.positions.len(),
        "values": positions,
        "labels": labels,
        "imaginary": frames.has_imaginary().then_some(&frames.imaginary),
    });
    header["stations"] = json!(geometry.stations());
    header["bodies"] = geometry.bodies.iter().map(|shape| entries::body(shape, blob)).collect();
    header["centres"] = entries::centres(&frames.placed, blob);
    header["directors"] = entries::directors(&frames.placed, blob);
    let reference = std::slice::from_ref(&frames.reference);
    header["reference"] = json!({
        "centres": entries::centres(reference, blob),
        "directors": entries::directors(reference, blob),
    });
    header["fields"] = fields.iter().map(|field| entries::field(recording, field, blob)).collect();
    header["markers"] = entries::symbols(layout, &frames, blob);
    header["reactions"] = entries::reactions(layout, &frames, blob);
    header["supports"] = entries::supports(layout, &geometry);
    header["loads"] = entries::loads(layout, &geometry, &frames, blob);
    header["links"] = entries::links(layout, &frames, blob);
    header["obstacles"] = entries::obstacles(layout, &frames, blob);
}

/// Global axis that is closest to the direction against gravity; y without gravity.
fn up(gravity: [f64; 3]) -> [f64; 3] {
    let along = Vector3::from(gravity).iamax();
    let mut up = [0.0; 3];
    match gravity[along] {
        0.0 => up[1] = 1.0,
        down => up[along] = -down.signum(),
    }
    up
}
