//! Probes at the ends of all bodies.

use serde_json::json;

use super::draft::{Draft, Kind, Task};

/// Adds a probe at the last place of each body, and section forces or strain of beams.
pub(super) fn add(draft: &mut Draft) {
    let is_eigen = matches!(draft.task, Task::Modes | Task::Buckling);
    let spots = draft.spots.clone();
    for spot in spots.iter().filter(|spot| spot.at != json!("start")) {
        let name = format!("p{}", draft.probes.len());
        let mut record = vec!["motion"];
        if spot.kind.has_frame() && !is_eigen {
            record.push("rotation");
        }
        draft.probes.push(json!({ "name": name, "on": spot.place(), "record": record }));
        if is_eigen || !spot.kind.is_flexible() || spot.at != json!("end") {
            continue;
        }
        let length = draft.sizes.length * draft.random.within(0.05, 0.45);
        let d = draft.sizes.diameter;
        // In the wall of tubes, and in narrow sections.
        let offset = if spot.kind == Kind::Cable { [0.0, 0.0] } else { [0.355 * d, 0.05 * d] };
        let quantity = draft.random.choose(&["section_forces", "section_forces", "strain", "stress"]);
        let offset = if quantity == "section_forces" { [0.0, 0.0] } else { offset };
        draft.probes.push(json!({
            "name": format!("q{}", draft.probes.len()), "on": { "body": spot.body, "at": length },
            "offset": offset, "record": [quantity],
        }));
    }
}
