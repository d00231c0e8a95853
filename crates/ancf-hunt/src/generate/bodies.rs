//! Bodies: a tree that grows from the ground, each body attached to an earlier one.

use ancf::nalgebra::{Rotation3, Vector3};
use serde_json::{Value, json};

use super::draft::{Draft, Kind, Spot, list};
use super::joints;
use crate::random::rounded;

/// Adds one to four bodies with the joints that connect them.
pub(super) fn add(draft: &mut Draft) {
    let count = draft.random.weighted(&[(0.4, 1), (0.35, 2), (0.2, 3), (0.05, 4)]);
    for number in 0..count {
        let root = if number == 0 { None } else { Some(draft.random.index(draft.spots.len())) };
        let root = root.map(|index| draft.spots[index].clone());
        let kind = choose_kind(draft, root.as_ref());
        let base = match &root {
            Some(spot) => spot.point,
            None if draft.random.chance(0.6) => Vector3::zeros(),
            None => draft.vector(1.0),
        };
        let gap = joints::gap(draft, kind, root.as_ref());
        let start = base + gap;
        let spots = body(draft, kind, start);
        let own = spots[0].clone();
        if number > 0 || !draft.is_free {
            joints::attach(draft, &own, root.as_ref());
        }
        draft.spots.extend(spots);
    }
}

fn choose_kind(draft: &mut Draft, root: Option<&Spot>) -> Kind {
    let is_static = draft.is_static();
    let under_cable = root.is_some_and(|root| !root.kind.has_frame());
    let kinds = [
        (5.0, Kind::Beam),
        (2.0, Kind::Quadratic),
        (if is_static { 0.3 } else { 1.2 }, Kind::Cable),
        (1.8, Kind::Rigid),
        (if root.is_some() { 0.6 } else { 0.15 }, Kind::Mass),
    ];
    let kind = draft.random.weighted(&kinds);
    if is_static && under_cable { Kind::Mass } else { kind }
}

/// Adds a body that begins at a point. Returns its places; the first one is at the point.
fn body(draft: &mut Draft, kind: Kind, start: Vector3<f64>) -> Vec<Spot> {
    let name = format!("b{}", draft.bodies.len());
    match kind {
        Kind::Beam | Kind::Quadratic => beam(draft, name, kind, start),
        Kind::Cable => cable(draft, name, start),
        Kind::Rigid => rigid(draft, name, start),
        Kind::Shell => unreachable!("shells have a generator of their own"),
        Kind::Mass => {
            let mass = draft.random.spread(0.1, 2.0) * draft.sizes.mass();
            let motion = motion(draft, false);
            draft.bodies.push(json!({ "kind": "mass", "name": name, "center": list(&start), "mass": rounded(mass), "motion": motion }));
            vec![Spot { body: name, kind, at: json!("center"), point: start, is_end: true }]
        }
    }
}

/// Initial motion: none in most cases.
pub(super) fn motion(draft: &mut Draft, can_spin: bool) -> Value {
    // Joints that stop an initial velocity cause an impulse, whose waves the steps do not resolve.
    let probability = if draft.is_free { 0.8 } else { 0.06 };
    if draft.is_static() || !draft.random.chance(probability) {
        return json!({});
    }
    let rate = if draft.is_free { 0.6 } else { 0.03 } / draft.sizes.period();
    let velocity = draft.vector(rate * draft.sizes.length);
    let spin = if can_spin { draft.vector(rate) } else { Vector3::zeros() };
    json!({ "velocity": list(&velocity), "spin": list(&spin) })
}

pub(super) fn material(draft: &mut Draft, poisson: bool) -> String {
    let name = format!("m{}", draft.materials.len());
    let poisson = if poisson { draft.random.choose(&[0.0, 0.3, 0.45]) } else { 0.0 };
    let mut data = json!({ "density": draft.sizes.density, "young": draft.sizes.young, "poisson": poisson });
    if draft.random.chance(0.2) {
        let strain = rounded(0.01 * draft.sizes.period());
        let mass = rounded(0.3 / draft.sizes.period());
        data["damping"] = draft.random.choose(&[[strain, 0.0], [0.0, mass], [strain, mass]]).to_vec().into();
        data["damping"] = json!({ "strain": data["damping"][0], "mass": data["damping"][1] });
    }
    draft.materials.insert(name.clone(), data);
    name
}

/// Adds a section; returns its name and its kind.
fn section(draft: &mut Draft, is_round: bool) -> String {
    let name = format!("s{}", draft.sections.len());
    let d = draft.sizes.diameter;
    let other = rounded(d * draft.random.within(0.5, 1.5));
    let data = match if is_round { draft.random.index(2) } else { draft.random.index(5) } {
        0 => json!({ "kind": "circle", "diameter": d }),
        1 => json!({ "kind": "tube", "outer": d, "inner": rounded(d * 0.7) }),
        2 => json!({ "kind": "rectangle", "height": d, "width": other }),
        3 => json!({ "kind": "ellipse", "height": d, "width": other }),
        _ => {
            let (area, second) = (rounded(0.8 * d * d), d.powi(4) * 0.05);
            json!({ "kind": "general", "area": area, "iy": rounded(second), "iz": rounded(second * (other / d).powi(2)), "ky": 0.8, "kz": 0.9 })
        }
    };
    draft.sections.insert(name.clone(), data);
    name
}

/// Section at the other end, of the same kind.
fn taper(draft: &mut Draft, section: &str) -> String {
    let mut data = draft.sections[section].clone();
    let factor = draft.random.within(0.6, 0.95);
    if let Value::Object(keys) = &mut data {
        for (key, value) in keys {
            if let (Some(x), false) = (value.as_f64(), ["ky", "kz"].contains(&key.as_str())) {
                *value = json!(rounded(x * factor));
            }
        }
    }
    let name = format!("s{}", draft.sections.len());
    draft.sections.insert(name.clone(), data);
    name
}

fn beam(draft: &mut Draft, name: String, kind: Kind, start: Vector3<f64>) -> Vec<Spot> {
    let length = draft.sizes.length * draft.random.within(0.5, 1.0);
    let end = start + draft.vector(length);
    let formulation = match kind {
        Kind::Quadratic => "quadratic",
        _ => draft.random.weighted(&[(1.0, "continuum"), (1.0, "enhanced"), (1.5, "linked")]),
    };
    let section = section(draft, false);
    let material = material(draft, true);
    let elements = 1 + draft.random.index(4);
    let mut data = json!({
        "kind": "beam", "name": name, "from": list(&start), "to": list(&end), "elements": elements,
        "section": section, "material": material, "formulation": formulation, "motion": motion(draft, true),
    });
    if draft.random.chance(0.2) {
        data["section_end"] = taper(draft, &section).into();
    }
    if draft.random.chance(0.2) {
        data["twist"] = draft.random.within(-1.0, 1.0).into();
    }
    if draft.random.chance(0.5) {
        data["up"] = list(&across(draft, &(end - start)));
    }
    if draft.random.chance(0.2) {
        data["slopes"] = "length".into();
    }
    let is_straight = draft.random.chance(0.75);
    if !is_straight {
        data["shape"] = shape(draft, &start, &end);
    }
    draft.bodies.push(data);
    let spot = |at: Value, point, is_end| Spot { body: name.clone(), kind, at, point, is_end };
    let mut spots = vec![spot(json!("start"), start, true), spot(json!("end"), end, true)];
    if is_straight && elements.is_multiple_of(2) {
        spots.push(spot(json!("center"), start + 0.5 * (end - start), false));
    }
    spots
}

/// Random direction transverse to an axis.
fn across(draft: &mut Draft, axis: &Vector3<f64>) -> Vector3<f64> {
    loop {
        let x = draft.vector(1.0);
        if x.cross(&axis.normalize()).norm() > 0.5 {
            return x;
        }
    }
}

/// Arc, spline or helix between two points.
fn shape(draft: &mut Draft, start: &Vector3<f64>, end: &Vector3<f64>) -> Value {
    let span = end - start;
    let side = across(draft, &span);
    let side = (side - span.normalize() * span.normalize().dot(&side)).normalize() * span.norm();
    match draft.random.index(3) {
        0 => json!({ "kind": "arc", "through": list(&(start + 0.4 * span + 0.15 * side)) }),
        1 => {
            json!({ "kind": "spline", "through": [list(&(start + 0.3 * span + 0.08 * side)), list(&(start + 0.7 * span - 0.05 * side))] })
        }
        _ => {
            // The rotation about the axis through the centre moves the start to the end, with a rise along the axis.
            let angle = draft.random.within(0.5, 1.5);
            let axis = side.cross(&span).normalize();
            let half = 0.5 * span.norm();
            let height = half / (0.5 * angle).tan();
            let rise = 0.0;
            let center = start + 0.5 * span - side.normalize() * height + axis * rise;
            let axis = if (Rotation3::new(axis * angle) * (start - center) - (end - center)).norm() < half {
                axis
            } else {
                -axis
            };
            json!({ "kind": "helix", "center": list(&center), "axis": list(&axis), "turns": angle / std::f64::consts::TAU })
        }
    }
}

fn cable(draft: &mut Draft, name: String, start: Vector3<f64>) -> Vec<Spot> {
    let length = draft.sizes.length * draft.random.within(0.5, 1.0);
    let end = start + draft.vector(length);
    let (section, material) = (section(draft, true), material(draft, false));
    let elements = 1 + draft.random.index(5);
    let motion = motion(draft, true);
    let mut data = json!({
        "kind": "cable", "name": name, "from": list(&start), "to": list(&end), "elements": elements,
        "section": section, "material": material, "motion": motion,
    });
    // With random numbers of its own: the models of a seed differ in this key only from those without it.
    let stream = draft.random.clone();
    if draft.random.chance(0.5) {
        data["up"] = list(&across(draft, &(end - start)));
    }
    draft.random = stream;
    draft.bodies.push(data);
    let spot = |at: &str, point, is_end| Spot {
        body: name.clone(),
        kind: Kind::Cable,
        at: json!(at),
        point,
        is_end,
    };
    let mut spots = vec![spot("start", start, true), spot("end", end, true)];
    if elements > 2 {
        spots.push(spot("center", start + 0.5 * (end - start), false));
    }
    spots
}

fn rigid(draft: &mut Draft, name: String, start: Vector3<f64>) -> Vec<Spot> {
    let mass = rounded(draft.random.spread(0.1, 2.0) * draft.sizes.mass());
    let size = draft.sizes.length * draft.random.within(0.1, 0.4);
    let second = Vector3::from_fn(|_, _| mass * (size * (0.1 + draft.random.unit())).powi(2));
    let principal = Vector3::new(second.y + second.z, second.x + second.z, second.x + second.y);
    let turn = if draft.random.chance(0.5) { draft.random.rotation() } else { Rotation3::identity() };
    let tensor =
        turn.matrix() * ancf::nalgebra::Matrix3::from_diagonal(&principal) * turn.matrix().transpose();
    let center = if draft.random.chance(0.4) { start } else { start + draft.vector(size) };
    let motion = motion(draft, true);
    draft.bodies.push(json!({
        "kind": "rigid", "name": name, "center": list(&center), "mass": mass,
        "inertia": [tensor[(0, 0)], tensor[(1, 1)], tensor[(2, 2)]],
        "products": [tensor[(0, 1)], tensor[(0, 2)], tensor[(1, 2)]], "motion": motion,
    }));
    let spot = |at: Value, point| Spot { body: name.clone(), kind: Kind::Rigid, at, point, is_end: true };
    let far = center + draft.vector(size);
    vec![spot(list(&start), start), spot(list(&far), far), spot(json!("center"), center)]
}
