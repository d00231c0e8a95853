//! Shear-deformable shells: curved patches of quadrilaterals and triangles, attached at a node.

use ancf::nalgebra::{Rotation3, Vector3};
use serde_json::{Value, json};

use super::draft::{Draft, Kind, Spot, Task, list};
use super::{bodies, joints};
use crate::random::{Random, rounded};

/// Number that separates the random numbers of shells from those of all other parts.
const STREAM: u64 = 0x51e1_1a5e_0f5e_ed00;

/// Adds a shell to some models. It has random numbers of its own: models without a shell do not depend on this choice.
pub(super) fn add(draft: &mut Draft) {
    let mut own = Random::new(draft.random.clone().bits() ^ STREAM);
    if !own.chance(0.1) {
        return;
    }
    std::mem::swap(&mut draft.random, &mut own);
    let roots: Vec<Spot> = draft.spots.iter().filter(|spot| spot.kind.has_frame()).cloned().collect();
    let is_on_ground = roots.is_empty() || !draft.is_free && draft.random.chance(0.3);
    let root = (!is_on_ground).then(|| roots[draft.random.index(roots.len())].clone());
    let start = root.as_ref().map_or_else(Vector3::zeros, |root| root.point);
    let Patch { spots, thickness, inside } = patch(draft, start);
    if root.is_some() || !draft.is_free {
        joints::attach(draft, &spots[0], root.as_ref());
    }
    pressure(draft, &spots[0].body);
    prestrain(draft, &spots[0].body, thickness);
    gas(draft, &spots[0].body, inside);
    membrane(draft, &spots[0].body);
    draft.spots.extend(spots);
    std::mem::swap(&mut draft.random, &mut own);
}

/// Shell of a model.
struct Patch {
    /// First and last node.
    spots: Vec<Spot>,
    thickness: f64,
    /// Point below the middle, against the normal.
    inside: Vector3<f64>,
}

/// Adds a shell whose first node is at a point.
fn patch(draft: &mut Draft, start: Vector3<f64>) -> Patch {
    let name = format!("b{}", draft.bodies.len());
    let [n, m] = [1 + draft.random.index(3), 1 + draft.random.index(2)];
    let sides = [0.6, 0.4].map(|size| size * draft.sizes.length * draft.random.within(0.5, 1.0));
    let curve = draft.random.choose(&[0.0, 0.0, 0.3]) / sides[0];
    let turn = if draft.random.chance(0.4) { Rotation3::identity() } else { draft.random.rotation() };
    let jitter = 0.15 * (sides[0] / n as f64).min(sides[1] / m as f64);
    let mut nodes = Vec::new();
    for j in 0..=m {
        for i in 0..=n {
            let [x, y] = [(i, n, sides[0]), (j, m, sides[1])].map(|(k, count, side)| {
                let is_inner = k > 0 && k < count;
                side * k as f64 / count as f64
                    + if is_inner { jitter * draft.random.within(-1.0, 1.0) } else { 0.0 }
            });
            nodes.push(start + turn * Vector3::new(x, y, curve * x * x));
        }
    }
    let mut elements: Vec<Value> = Vec::new();
    for (i, j) in (0..m).flat_map(|j| (0..n).map(move |i| (i, j))) {
        let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| j * (n + 1) + i);
        if draft.random.chance(0.25) {
            elements.extend([json!([a, b, c]), json!([a, c, d])]);
        } else {
            elements.push(json!([a, b, c, d]));
        }
    }
    let thickness = rounded(draft.sizes.diameter * draft.random.within(0.3, 1.0));
    let points: Vec<Value> = nodes.iter().map(list).collect();
    let (given, turned) = fields(draft, thickness, nodes.len());
    let (material, motion) = (bodies::material(draft, true), bodies::motion(draft, true));
    draft.bodies.push(json!({
        "kind": "shear_shell", "name": name, "mesh": { "nodes": points, "elements": elements },
        "thickness": given, "fibre_angle": turned, "material": material, "fibre_axis": list(&(turn * Vector3::x())), "motion": motion,
    }));
    let spot = |node: usize| Spot {
        body: name.clone(),
        kind: Kind::Shell,
        at: json!({ "node": node }),
        point: nodes[node],
        is_end: true,
    };
    let inside = start + turn * Vector3::new(0.5 * sides[0], 0.4 * sides[1], -0.6 * sides[0]);
    Patch { spots: vec![spot(0), spot(nodes.len() - 1)], thickness, inside }
}

/// Thickness and angle of the fibres: fields in some cases. They have random numbers of their own.
fn fields(draft: &mut Draft, thickness: f64, nodes: usize) -> (Value, Value) {
    let mut own = Random::new(draft.random.clone().bits() ^ STREAM.rotate_left(13));
    let length = draft.sizes.length;
    let varies = own.chance(0.4);
    let given = match varies.then(|| own.index(2)) {
        None => json!(thickness),
        Some(0) => {
            let values: Vec<f64> = (0..nodes).map(|_| rounded(thickness * own.within(0.5, 1.5))).collect();
            json!({ "kind": "nodes", "values": values })
        }
        Some(_) => {
            let part = rounded(thickness / length);
            json!({ "kind": "expression", "text": format!("{part}*(1 + 0.4*sin(3*x - 2*y + z))"), "unit": length })
        }
    };
    let angle = match own.index(4) {
        0 => json!({ "kind": "expression", "text": "0.8*x - 0.5*y*z", "unit": length }),
        1 => json!(rounded(own.within(-1.5, 1.5))),
        _ => json!(0.0),
    };
    (given, angle)
}

/// Adds prescribed strains and curvatures in some cases. They have random numbers of their own, as shells.
fn prestrain(draft: &mut Draft, body: &str, thickness: f64) {
    let mut own = Random::new(draft.random.clone().bits() ^ STREAM);
    if !own.chance(0.3) {
        return;
    }
    std::mem::swap(&mut draft.random, &mut own);
    let time = draft.time(false);
    let strain = list(&draft.vector(0.02));
    let mut load = json!({ "kind": "surface_prestrain", "body": body, "strain": strain, "time": time });
    if draft.random.chance(0.5) {
        load["curvature"] = list(&draft.vector(0.02 / thickness));
    }
    if draft.random.chance(0.3) {
        load["axis"] = list(&draft.random.direction());
    }
    draft.loads.push(load);
    std::mem::swap(&mut draft.random, &mut own);
}

/// Adds a law of the membrane forces to some shells. It has random numbers of its own.
fn membrane(draft: &mut Draft, body: &str) {
    let mut own = Random::new(draft.random.clone().bits() ^ STREAM.rotate_left(13));
    if !own.chance(0.3) {
        return;
    }
    let law = own.choose(&["linear", "neo_hookean"]);
    let has_field = law == "linear" || own.chance(0.5);
    let slack = own.choose(&[1e-4, 1e-2, 0.5]);
    if let Some(shell) = draft.bodies.iter_mut().find(|other| other["name"] == body) {
        shell["membrane"] = json!({ "law": law, "tension_field": has_field });
        if has_field {
            shell["membrane"]["slack"] = json!(slack);
        }
    }
}

/// Adds a gas between the shell and a point in some cases. It has random numbers of its own.
fn gas(draft: &mut Draft, body: &str, apex: Vector3<f64>) {
    let mut own = Random::new(draft.random.clone().bits() ^ STREAM.rotate_left(7));
    if draft.is_free || !own.chance(0.3) {
        return;
    }
    std::mem::swap(&mut draft.random, &mut own);
    let unit = draft.sizes.force() / draft.sizes.length.powi(2);
    let [pressure, ambient] = [0.0; 2].map(|_: f64| rounded(draft.random.spread(0.01, 0.3) * unit));
    let exponent = draft.random.choose(&[0.0, 1.0, 1.4]);
    draft.loads.push(json!({
        "kind": "gas", "name": format!("gas_{body}"), "surfaces": [{ "body": body }], "pressure": pressure, "ambient": ambient,
        "exponent": exponent, "apex": list(&apex),
    }));
    std::mem::swap(&mut draft.random, &mut own);
}

/// Adds a pressure, a force per area or a fluid in some cases.
fn pressure(draft: &mut Draft, body: &str) {
    if draft.is_free || !draft.random.chance(0.4) {
        return;
    }
    let size = draft.random.spread(0.01, 0.3) * draft.sizes.force() / draft.sizes.length.powi(2);
    let time = draft.time(false);
    let load = if draft.task == Task::Dynamics && draft.random.chance(0.3) {
        // Current with the stated dynamic pressure.
        let speed = draft.sizes.length / draft.sizes.period();
        let density = rounded(2.0 * size / speed.powi(2));
        let added = rounded(0.1 * draft.sizes.length);
        json!({
            "kind": "surface_fluid", "body": body, "density": density, "current": list(&draft.vector(speed)), "time": time,
            "drag": [1.5, 0.05], "lift": 3.0, "added_mass": added,
        })
    } else if draft.random.chance(0.5) {
        json!({ "kind": "surface_pressure", "body": body, "pressure": rounded(size), "time": time })
    } else {
        json!({ "kind": "surface_force", "body": body, "force": list(&draft.vector(size)), "time": time })
    };
    draft.loads.push(load);
}
