//! Loads: forces, moments, line loads, prestrain, base acceleration, fluids.

use serde_json::{Value, json};

use super::draft::{Draft, Spot, list};
use crate::random::rounded;

/// Adds up to three loads.
pub(super) fn add(draft: &mut Draft) {
    if draft.is_free && draft.random.chance(0.6) {
        return;
    }
    let least = usize::from(draft.is_static());
    let count = least + draft.random.weighted(&[(0.5, 0), (0.35, 1), (0.15, 2)]);
    let spots = draft.spots.clone();
    for _ in 0..count {
        let spot = spots[draft.random.index(spots.len())].clone();
        let load = load(draft, &spot);
        draft.loads.push(load);
    }
    if draft.random.chance(0.1) {
        prestrain(draft);
    }
    let is_wet = draft.loads.iter().any(|load| load["kind"] == "surface_fluid");
    if draft.random.chance(0.1) && !draft.is_static() && !is_wet {
        let acceleration = draft.vector(0.3 * draft.sizes.force() / draft.sizes.mass());
        let time = draft.time(false);
        draft
            .loads
            .push(json!({ "kind": "base_acceleration", "acceleration": list(&acceleration), "time": time }));
    } else if draft.random.chance(0.12) {
        fluid(draft);
    }
}

/// Magnitude of a load relative to one that bends a beam by a radian.
fn magnitude(draft: &mut Draft) -> f64 {
    draft.random.spread(0.01, 0.7)
}

fn load(draft: &mut Draft, spot: &Spot) -> Value {
    let line = if spot.kind.is_flexible() { 1.0 } else { 0.0 };
    let frame = if spot.kind.has_frame() { 1.0 } else { 0.0 };
    let flexible_frame = line * frame;
    let kinds = [
        (3.0, "force"),
        (1.5 * frame, "moment"),
        (1.2 * line, "distributed_force"),
        (0.6 * flexible_frame, "distributed_moment"),
    ];
    let kind = draft.random.weighted(&kinds);
    let factor = magnitude(draft);
    let follower = spot.kind.has_frame() && draft.random.chance(0.25);
    let time = draft.time(false);
    let (force, moment, length) = (draft.sizes.force(), draft.sizes.moment(), draft.sizes.length);
    match kind {
        "force" => {
            let mut on = spot.place();
            if spot.kind.has_frame() && draft.random.chance(0.2) {
                on["offset"] = list(&draft.vector(0.1 * length));
            }
            json!({ "kind": kind, "on": on, "force": list(&draft.vector(factor * force)), "follower": follower, "time": time })
        }
        "moment" => {
            json!({ "kind": kind, "on": spot.place(), "moment": list(&draft.vector(factor * moment)), "follower": follower, "time": time })
        }
        _ => {
            let is_force = kind == "distributed_force";
            let unit = if is_force { force / length } else { moment / length };
            let key = if is_force { "force" } else { "moment" };
            let mut load = json!({ "kind": kind, "body": spot.body, "follower": follower, "time": time });
            load[key] = list(&draft.vector(2.0 * factor * unit));
            if draft.random.chance(0.4) {
                load[format!("{key}_end")] = list(&draft.vector(factor * unit));
            }
            if draft.random.chance(0.3) {
                load["from"] = json!(rounded(0.1 * length));
                load["to"] = json!(rounded(0.4 * length));
            }
            load
        }
    }
}

/// Adds a prestrain of a flexible body, if there is one.
fn prestrain(draft: &mut Draft) {
    let spots: Vec<Spot> = draft.spots.iter().filter(|spot| spot.kind.is_flexible()).cloned().collect();
    if spots.is_empty() {
        return;
    }
    let spot = &spots[draft.random.index(spots.len())];
    let time = draft.time(false);
    let strain = rounded(draft.random.within(-0.02, 0.02));
    let mut load = json!({ "kind": "prestrain", "body": spot.body, "strain": strain, "time": time });
    if draft.random.chance(0.4) {
        load["strain_end"] = json!(rounded(draft.random.within(-0.02, 0.02)));
    }
    if spot.kind.has_frame() && draft.random.chance(0.6) {
        let size = magnitude(draft) / draft.sizes.length;
        load["curvature"] = list(&draft.vector(size));
        if draft.random.chance(0.4) {
            load["curvature_end"] = list(&draft.vector(size));
        }
    }
    draft.loads.push(load);
}

/// Adds a fluid around all flexible bodies.
fn fluid(draft: &mut Draft) {
    let mut names: Vec<String> =
        draft.spots.iter().filter(|spot| spot.kind.is_flexible()).map(|spot| spot.body.clone()).collect();
    names.dedup();
    if names.is_empty() {
        return;
    }
    let speed = 0.5 * draft.sizes.length / draft.sizes.period();
    let time = draft.time(false);
    let current = draft.vector(speed);
    draft.loads.push(json!({
        "kind": "fluid", "bodies": names, "density": rounded(0.3 * draft.sizes.density), "current": list(&current),
        "drag": [1.2, 0.05], "added_mass": [1.0, 0.1], "diameter": draft.sizes.diameter, "time": time,
    }));
}
