//! Joints between a new body and an earlier one or the ground, and joints that close loops.

use ancf::nalgebra::Vector3;
use serde_json::{Value, json};

use super::draft::{Draft, Kind, Spot, list};
use crate::random::rounded;

/// Distance of a new body from its root: zero, except for rods, springs and arms.
pub(super) fn gap(draft: &mut Draft, kind: Kind, root: Option<&Spot>) -> Vector3<f64> {
    let probability = match (kind, root.map(|root| root.kind)) {
        (Kind::Mass, _) => 0.6,
        (Kind::Cable, _) | (_, Some(Kind::Cable | Kind::Mass)) => 0.0,
        (Kind::Rigid, None) => 0.1,
        _ => 0.12,
    };
    if draft.random.chance(probability) { draft.vector(0.3 * draft.sizes.length) } else { Vector3::zeros() }
}

/// Connects a new body to a place of an earlier body, or to the ground.
pub(super) fn attach(draft: &mut Draft, own: &Spot, root: Option<&Spot>) {
    let target = root.map_or(Vector3::zeros(), |root| root.point);
    let is_apart = root.is_some_and(|root| (own.point - root.point).norm() > 1e-9);
    let name = format!("j{}", draft.joints.len());
    let kind = choose(draft, own, root, is_apart);
    if is_apart && ["distance", "spring"].contains(&kind) {
        let joint = line(draft, &name, kind, own.place(), root.map_or(json!("ground"), Spot::place));
        draft.joints.push(joint);
        return;
    }
    // Without a common point, an arm of one of the bodies reaches the other one.
    let on_root =
        root.is_none_or(|root| root.kind.has_frame()) && draft.random.chance(0.5) || !own.kind.has_frame();
    let at = if is_apart && !on_root { target } else { own.point };
    let mut ends = [own.place_of(&at), root.map_or(Value::Null, |root| root.place_of(&at))];
    if root.is_some() && kind != "slide" && draft.random.chance(0.5) {
        ends.swap(0, 1);
    }
    let mut joint = json!({ "kind": kind, "name": name });
    let [a, b] = ends;
    joint["a"] = a;
    if !b.is_null() {
        joint["b"] = b;
    }
    add_keys(draft, kind, &mut joint);
    if own.kind.has_frame() && root.is_none_or(|root| root.kind.has_frame()) {
        slip_friction(draft, kind, &mut joint);
    }
    draft.joints.push(joint);
}

/// Kinds of joints that the bodies support, and that support the bodies in statics.
fn choose(draft: &mut Draft, own: &Spot, root: Option<&Spot>, is_apart: bool) -> &'static str {
    let root_kind = root.map_or(Kind::Rigid, |root| root.kind);
    let frames = own.kind.has_frame() && root_kind.has_frame();
    let masses = own.kind == Kind::Mass || root_kind == Kind::Mass;
    let is_static = draft.is_static();
    if !frames && is_apart {
        return if is_static { "spring" } else { draft.random.choose(&["distance", "spring"]) };
    }
    if masses {
        return "spherical";
    }
    let slides = root.is_some_and(|root| matches!(root.kind, Kind::Beam | Kind::Cable) && !root.is_end);
    if !frames {
        let loose = if is_static { 0.0 } else { 1.0 };
        return draft.random.weighted(&[
            (1.0, "clamp"),
            (loose, "spherical"),
            (if slides { 0.4 * loose } else { 0.0 }, "slide"),
        ]);
    }
    if is_static {
        return draft.random.weighted(&[
            (6.0, "clamp"),
            (2.0, "revolute"),
            (1.0, "bushing"),
            (0.7, "prismatic"),
            (0.5, "cylindrical"),
        ]);
    }
    draft.random.weighted(&[
        (4.0, "clamp"),
        (3.0, "revolute"),
        (1.5, "spherical"),
        (1.0, "bushing"),
        (0.8, "universal"),
        (0.8, "prismatic"),
        (0.8, "cylindrical"),
        (0.4, "planar"),
        (0.4, "point_on_line"),
        (if slides { 0.8 } else { 0.0 }, "slide"),
        (if root.is_none() && matches!(own.kind, Kind::Beam | Kind::Quadratic) { 0.8 } else { 0.0 }, "drive"),
    ])
}

/// Adds the keys of a kind of joint.
fn add_keys(draft: &mut Draft, kind: &str, joint: &mut Value) {
    let sizes = draft.sizes;
    match kind {
        "clamp" if draft.random.chance(0.3) => joint["fix"] = "section".into(),
        "revolute" | "cylindrical" => {
            joint["axis"] = list(&draft.vector(1.0));
            angle_actions(draft, kind, joint);
        }
        "prismatic" | "point_on_line" | "slide" => {
            if kind != "slide" {
                joint["axis"] = list(&draft.vector(1.0));
            }
            if kind != "point_on_line" {
                displacement_actions(draft, kind, joint);
            }
        }
        "planar" => joint["normal"] = list(&draft.vector(1.0)),
        "universal" => {
            let a = draft.random.direction();
            let b = a.cross(&draft.random.direction()).normalize();
            (joint["axis_a"], joint["axis_b"]) = (list(&a), list(&b));
        }
        "bushing" => {
            let (k, c) = (sizes.force() / sizes.length, sizes.moment());
            let isotropic = draft.random.chance(0.6);
            let factors: Vec<f64> = (0..6).map(|_| draft.random.spread(5.0, 50.0)).collect();
            let factor = |i: usize| if isotropic { factors[i / 3 * 3] } else { factors[i] };
            let stiffness: Vec<f64> =
                (0..6).map(|i| rounded(factor(i) * if i < 3 { k } else { c })).collect();
            let rate = 0.02 * sizes.period();
            joint["damping"] = stiffness.iter().map(|k| rounded(k * rate)).collect::<Vec<_>>().into();
            joint["stiffness"] = stiffness.into();
        }
        "drive" => {
            joint["axis"] = list(&draft.vector(1.0));
            joint["angle"] = draft.random.within(-1.0, 1.0).into();
            joint["time"] = draft.time(true);
            if draft.random.chance(0.3) {
                joint["displacement"] = list(&draft.vector(0.2 * sizes.length));
            }
        }
        _ => {}
    }
}

/// Friction of several components of slip, also by the reaction.
fn slip_friction(draft: &mut Draft, kind: &str, joint: &mut Value) {
    let (sizes, slips) = (draft.sizes, ["spherical", "universal", "cylindrical", "point_on_line", "planar"]);
    if draft.is_static() || !slips.contains(&kind) || !draft.random.chance(0.3) {
        return;
    }
    let (radius, rate) = (0.02 * sizes.length, 0.3 / sizes.period());
    let mut friction = if ["spherical", "universal"].contains(&kind) {
        json!({ "moment": rounded(0.05 * sizes.moment()), "rate": rounded(rate), "radius": rounded(radius) })
    } else {
        json!({ "force": rounded(0.05 * sizes.force()), "speed": rounded(rate * sizes.length) })
    };
    if kind == "cylindrical" {
        friction["radius"] = rounded(radius).into();
    }
    if draft.random.chance(0.5) {
        friction["coefficient"] = rounded(draft.random.within(0.05, 0.2)).into();
    }
    joint["friction"] = friction;
}

/// Drive, spring or friction of an angle. Statics has one of the first two.
fn angle_actions(draft: &mut Draft, kind: &str, joint: &mut Value) {
    let (sizes, is_static) = (draft.sizes, draft.is_static());
    let choice = if is_static { draft.random.index(2) } else { draft.random.index(6) };
    let moment = sizes.moment();
    match choice {
        0 => {
            let stiffness = rounded(moment * draft.random.spread(0.5, 20.0));
            let damping = rounded(0.05 * stiffness * sizes.period());
            joint["spring"] = json!({ "stiffness": stiffness, "damping": damping, "angle": draft.random.within(-0.3, 0.3) });
        }
        1 => joint["drive"] = json!({ "angle": draft.random.within(-1.0, 1.0), "time": draft.time(true) }),
        2 if kind == "revolute" => {
            joint["friction"] =
                json!({ "moment": rounded(0.05 * moment), "rate": rounded(0.3 / sizes.period()) });
        }
        _ => {}
    }
    if kind == "cylindrical" && (is_static || draft.random.chance(0.3)) {
        let displacement = rounded(sizes.length * draft.random.within(-0.2, 0.2));
        joint["feed"] = json!({ "displacement": displacement, "time": draft.time(true) });
    }
}

/// Drive, spring or friction of a displacement.
fn displacement_actions(draft: &mut Draft, kind: &str, joint: &mut Value) {
    let (sizes, is_static) = (draft.sizes, draft.is_static());
    let choice = if is_static { draft.random.index(2) } else { draft.random.index(4) };
    let reach = if kind == "slide" { 0.1 } else { 0.2 } * sizes.length;
    match choice {
        0 => {
            let stiffness = rounded(sizes.force() / sizes.length * draft.random.spread(3.0, 50.0));
            let damping = rounded(0.05 * stiffness * sizes.period());
            joint["spring"] =
                json!({ "stiffness": stiffness, "damping": damping, "displacement": rounded(0.3 * reach) });
        }
        1 => {
            let displacement = rounded(reach * draft.random.within(-1.0, 1.0));
            joint["drive"] = json!({ "displacement": displacement, "time": draft.time(true) });
        }
        2 => {
            let (force, speed) = (0.05 * sizes.force(), 0.3 * sizes.length / sizes.period());
            joint["friction"] = json!({ "force": rounded(force), "speed": rounded(speed) });
        }
        _ => {}
    }
}

/// Rod or spring between two places.
fn line(draft: &mut Draft, name: &str, kind: &str, a: Value, b: Value) -> Value {
    let mut joint = json!({ "kind": kind, "name": name, "a": a, "b": b });
    if kind == "spring" {
        let stiffness = rounded(draft.sizes.force() / draft.sizes.length * draft.random.spread(1.0, 30.0));
        joint["stiffness"] = stiffness.into();
        joint["damping"] = rounded(0.05 * stiffness * draft.sizes.period()).into();
        if !draft.is_static() && draft.random.chance(0.2) {
            joint["tension_only"] = true.into();
        }
    } else if draft.random.chance(0.3) {
        joint["change"] = rounded(0.1 * draft.sizes.length).into();
        joint["time"] = draft.time(true);
    }
    joint
}

/// Closes loops with springs and rods, supports masses and cables in statics, and couples hinges.
pub(super) fn close(draft: &mut Draft) {
    let spots = draft.spots.clone();
    if draft.is_static() {
        for spot in
            spots.iter().filter(|spot| spot.kind == Kind::Mass || spot.kind == Kind::Cable && spot.is_end)
        {
            for _ in 0..3 {
                to_ground(draft, "spring", spot);
            }
        }
    }
    if !draft.is_free && draft.random.chance(0.25) {
        let spot = spots[draft.random.index(spots.len())].clone();
        let kind = if draft.is_static() { "spring" } else { draft.random.choose(&["spring", "distance"]) };
        to_ground(draft, kind, &spot);
    }
    if draft.random.chance(0.15) {
        let (a, b) = (&spots[draft.random.index(spots.len())], &spots[draft.random.index(spots.len())]);
        if a.body != b.body && (a.point - b.point).norm() > 0.1 * draft.sizes.length {
            let name = format!("j{}", draft.joints.len());
            let joint = line(draft, &name, "spring", a.place(), b.place());
            draft.joints.push(joint);
        }
    }
    couple(draft);
}

fn to_ground(draft: &mut Draft, kind: &str, spot: &Spot) {
    let name = format!("j{}", draft.joints.len());
    let point = spot.point + draft.random.direction() * (0.7 * draft.sizes.length);
    let joint = line(draft, &name, kind, spot.place(), json!({ "point": list(&point.map(rounded)) }));
    draft.joints.push(joint);
}

/// Couples the angles of two hinges without drives.
fn couple(draft: &mut Draft) {
    let is_free = |joint: &&Value| joint["kind"] == "revolute" && joint["drive"].is_null();
    let names: Vec<Value> = draft.joints.iter().filter(is_free).map(|joint| joint["name"].clone()).collect();
    if names.len() > 1 && !draft.is_static() && draft.random.chance(0.4) {
        let factor = draft.random.choose(&[1.0, -0.5, 2.0]);
        draft.couplings.push(json!({
            "name": "gear",
            "joints": [{ "joint": names[0], "factor": 1.0 }, { "joint": names[1], "factor": factor }],
        }));
    }
}
