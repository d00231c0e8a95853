//! Contact of flexible bodies and shells with a plane, a sphere or a cylinder below them.

use ancf::nalgebra::Vector3;
use serde_json::json;

use super::draft::{Draft, Kind, Task, list};
use crate::random::rounded;

/// Adds a contact to some models of dynamics.
pub(super) fn add(draft: &mut Draft) {
    let is_flexible = draft.spots.iter().any(|spot| spot.kind.is_flexible());
    let is_shell = draft.spots.iter().any(|spot| spot.kind == Kind::Shell);
    if draft.task != Task::Dynamics || !(is_flexible || is_shell) || !draft.random.chance(0.12) {
        return;
    }
    let lowest = draft.spots.iter().map(|spot| spot.point.z).fold(f64::INFINITY, f64::min);
    let radius = 0.5 * draft.sizes.diameter;
    let gap = draft.sizes.length * draft.random.within(0.02, 0.1);
    let top = Vector3::new(draft.spots[0].point.x, draft.spots[0].point.y, lowest - 2.0 * radius - gap)
        .map(rounded);
    let size = rounded(draft.sizes.length * draft.random.within(0.2, 0.6));
    let with = match draft.random.index(4) {
        0 => json!({ "kind": "sphere", "center": list(&(top - Vector3::z() * size)), "radius": size }),
        1 => {
            json!({ "kind": "cylinder", "point": list(&(top - Vector3::z() * size)), "axis": [1.0, 0.5, 0.0], "radius": size })
        }
        _ => json!({ "kind": "plane", "point": list(&top), "normal": [0.0, 0.0, 1.0] }),
    };
    let friction = draft.random.choose(&[0.0, 0.0, 0.4]);
    let stiffness = rounded(30.0 * draft.sizes.force() / draft.sizes.length / radius);
    let slip = rounded(0.05 * draft.sizes.length / draft.sizes.period());
    let transition = rounded(0.3 * radius);
    let mut contact = json!({ "with": with, "friction": friction, "slip_speed": slip, "transition": transition, "points": 3 });
    if is_flexible {
        contact["stiffness"] = json!(stiffness);
        contact["radius"] = json!(rounded(radius));
    }
    if is_shell {
        contact["surface_stiffness"] = json!(rounded(stiffness / draft.sizes.length));
    }
    draft.contacts.push(contact);
}
