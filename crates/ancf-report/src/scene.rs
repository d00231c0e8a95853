use nalgebra::Vector3;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use crate::container::Blob;
use crate::instants::Instants;
use crate::pack;
use crate::stage::{PARTS, Stage};
use crate::{Charts, Geometry, Quantities, Recording, message};

/// Bytes of a scene before compression, if nothing else is asked for.
pub const BUDGET: usize = 32 << 20;
/// Rows of charts.
const ROWS: usize = 4000;

/// The scene of a recording as a [`container`](crate::container) of at most about `budget` bytes: stations between nodes are
/// left out first, then frames; what is left out is said among the messages.
pub fn scene(recording: &Recording<'_>, budget: usize) -> Vec<u8> {
    let scaled = recording.model.scaled(&recording.scales());
    let stage = Stage::new(recording, &scaled);
    let mut blob = Blob::default();
    let mut header = heading(recording);
    charts(recording, budget, &mut header, &mut blob);
    bodies(&stage, budget - budget / 4, &mut header, &mut blob);
    blob.packed(&header)
}

/// What is said of the whole.
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
        "outcome": { "kind": recording.ending.kind(), "message": recording.ending.message() },
        "live": recording.live,
        "summary": recording.summary,
    })
}

fn charts(recording: &Recording<'_>, budget: usize, header: &mut Value, blob: &mut Blob) {
    let most = (budget / 4 / (4 * Charts::columns(recording))).clamp(2, ROWS);
    let Charts { abscissa, charts } = Charts::new(recording, most);
    let mut packed = Vec::new();
    for chart in charts {
        let columns = chart.columns.into_iter().map(|column| {
            let values = blob.f32(column.values);
            json!({ "name": column.name, "label": column.label, "unit": column.unit, "values": values })
        });
        let (columns, group): (Vec<_>, _) = (columns.collect(), chart.group.word());
        packed.push(json!({ "title": chart.title, "group": group, "log": chart.log, "columns": columns }));
    }
    header["charts"] = Value::Array(packed);
    let values = blob.f64(abscissa.values);
    header["abscissa"] = json!({ "name": abscissa.name, "unit": abscissa.unit, "values": values });
}

/// The bodies in all frames, and what stands beside them.
fn bodies(stage: &Stage<'_>, budget: usize, header: &mut Value, blob: &mut Blob) {
    let recording = stage.recording;
    let (parts, most) = stage.resolution(budget);
    let (assembly, scales) = (recording.simulation.assembly(), recording.scales());
    let geometry = Geometry::new(recording.model, assembly, scales, parts, stage.size);
    let mut messages = recording.messages.clone();
    if parts < PARTS && recording.model.bodies.iter().any(ancf::model::Body::is_flexible) {
        messages.push(message::coarse(parts));
    }
    let instants = Instants::new(recording, &geometry, stage.size, most, &mut messages);
    let mut quantities = Quantities::new(recording.model, assembly, scales, &geometry);
    for (s, placed) in instants.states.iter().zip(&instants.placed) {
        quantities.push(&geometry, s, placed, &instants.reference);
    }
    let fields = quantities.into_all();
    let labels = instants.labels.as_ref();
    let frames = blob.f64(instants.values.iter().copied());
    header["messages"] = json!(messages);
    header["bounds"] = pack::bounds(stage, &geometry, &instants);
    header["size"] = json!(stage.size);
    header["up"] = json!(up(recording.model.gravity));
    header["frames"] = json!({ "count": instants.states.len(), "values": frames, "labels": labels });
    header["stations"] = json!(geometry.stations());
    header["bodies"] = geometry.bodies.iter().map(|drawn| pack::body(drawn, blob)).collect();
    header["centres"] = pack::centres(&instants.placed, blob);
    header["directors"] = pack::directors(&instants.placed, blob);
    let reference = std::slice::from_ref(&instants.reference);
    header["reference"] = json!({
        "centres": pack::centres(reference, blob),
        "directors": pack::directors(reference, blob),
    });
    header["fields"] = fields.iter().map(|field| pack::field(recording, field, blob)).collect();
    header["markers"] = pack::markers(stage, &instants, blob);
    header["reactions"] = pack::reactions(stage, &instants, blob);
    header["links"] = pack::links(stage, &instants, blob);
    header["obstacles"] = pack::obstacles(stage, &instants, blob);
}

/// The axis that is most against gravity; y, if there is none.
fn up(gravity: [f64; 3]) -> [f64; 3] {
    let along = Vector3::from(gravity).iamax();
    let mut up = [0.0; 3];
    match gravity[along] {
        0.0 => up[1] = 1.0,
        down => up[along] = -down.signum(),
    }
    up
}
