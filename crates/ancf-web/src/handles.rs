//! Points of a model that one drags: joints and the ends of force vectors.

use ancf::Model;
use ancf::model::{At, Body, End, Load, Place};
use serde::Serialize;
use toml_edit::{DocumentMut, Item, Value};

/// Point of a model that one drags.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Handle {
    /// Name of the joints, or of the loaded body.
    pub name: String,
    /// Position in the reference state.
    pub position: [f64; 3],
    /// Force of a load; `None` for joints.
    pub force: Option<[f64; 3]>,
    /// Vectors of the model file that follow the handle.
    #[serde(skip)]
    keys: Vec<KeyPath>,
}

/// Path of a key in the model file.
type KeyPath = Vec<Step>;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    Key(&'static str),
    Index(usize),
}

/// Distance of points that coincide, relative to the length of the model.
const COINCIDENT: f64 = 1e-9;
/// Digits after the first one of the largest number.
const DIGITS: f64 = 3.0;

/// Returns the handles of a model text; none if it has errors.
///
/// A joint takes all points of bodies, joints and loads that coincide with it along.
pub fn handles(text: &str) -> Vec<Handle> {
    let Ok(model) = Model::parse(text) else { return Vec::new() };
    let mut handles: Vec<Handle> = Vec::new();
    let (points, near) = (points(&model), COINCIDENT * model.length());
    let is_near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= near);
    for joint in &model.joints {
        let (a, _) = joint.ends();
        let Some(position) = point(&model, a) else { continue };
        if let Some(known) = handles.iter_mut().find(|handle| is_near(handle.position, position)) {
            known.name = format!("{}, {}", known.name, joint.name());
            continue;
        }
        let here = points.iter().filter(|(_, point)| is_near(*point, position));
        let keys: Vec<KeyPath> = here.map(|(key, _)| key.clone()).collect();
        if !keys.is_empty() {
            handles.push(Handle { name: joint.name().to_owned(), position, force: None, keys });
        }
    }
    for (number, load) in model.loads.iter().enumerate() {
        let Load::Force(force) = load else { continue };
        let Some(position) = point(&model, &force.on) else { continue };
        let keys = vec![vec![Step::Key("loads"), Step::Index(number), Step::Key("force")]];
        handles.push(Handle { name: force.on.body.clone(), position, force: Some(force.force), keys });
    }
    handles
}

/// Returns the text of a model in which a handle has another position, or force; `None` if there is no such handle.
pub fn moved(text: &str, number: usize, to: [f64; 3]) -> Option<String> {
    let handle = handles(text).into_iter().nth(number)?;
    let mut document: DocumentMut = text.parse().ok()?;
    let size = match handle.force {
        Some(force) => force.iter().chain(&to).fold(0.0_f64, |size, x| size.max(x.abs())),
        None => Model::parse(text).ok()?.length(),
    };
    let rounded = to.map(|x| round(x, size));
    for key in &handle.keys {
        let array = found(document.as_item_mut(), key)?.as_array_mut()?;
        for (old, x) in array.iter_mut().zip(rounded) {
            let mut new = Value::from(x);
            *new.decor_mut() = old.decor().clone();
            *old = new;
        }
    }
    Some(document.to_string())
}

/// Rounds a number to the resolution of numbers of a size.
fn round(x: f64, size: f64) -> f64 {
    let digits = DIGITS - size.log10().floor();
    if !digits.is_finite() || digits.abs() > 300.0 {
        return x;
    }
    // Powers of ten are exact for positive exponents only.
    let scale = 10.0_f64.powi(digits.abs() as i32);
    let rounded = if digits < 0.0 { (x / scale).round() * scale } else { (x * scale).round() / scale };
    if rounded == 0.0 { 0.0 } else { rounded }
}

fn found<'a>(item: &'a mut Item, path: &[Step]) -> Option<&'a mut Item> {
    path.iter().try_fold(item, |item, step| match step {
        Step::Key(key) => item.get_mut(key),
        Step::Index(index) => item.get_mut(index),
    })
}

/// Reference position of a place without an arm.
fn point(model: &Model, place: &Place) -> Option<[f64; 3]> {
    let body = model.bodies.iter().find(|body| body.name() == place.body)?;
    (place.offset == [0.0; 3]).then(|| body.point(&place.at).map(Into::into)).flatten()
}

/// Points of the model that the file states as vectors, with their keys.
fn points(model: &Model) -> Vec<(KeyPath, [f64; 3])> {
    let mut points = Vec::new();
    let mut add = |table, number, keys: &[&'static str], point| {
        let first = [Step::Key(table), Step::Index(number)];
        points.push((first.into_iter().chain(keys.iter().map(|key| Step::Key(key))).collect(), point));
    };
    for (number, body) in model.bodies.iter().enumerate() {
        let [from, to] = body.span();
        match body {
            Body::Beam(_) | Body::Cable(_) => {
                add("bodies", number, &["from"], from);
                add("bodies", number, &["to"], to);
            }
            Body::Mass(_) => add("bodies", number, &["center"], from),
            _ => {}
        }
    }
    for (number, joint) in model.joints.iter().enumerate() {
        let (a, b) = joint.ends();
        if let At::Point(point) = a.at {
            add("joints", number, &["a", "at"], point);
        }
        match b {
            End::Place(Place { at: At::Point(point), .. }) => add("joints", number, &["b", "at"], *point),
            End::Point(ground) => add("joints", number, &["b", "point"], ground.point),
            End::Ground | End::Place(_) => {}
        }
    }
    for (number, load) in model.loads.iter().enumerate() {
        if let Some(Place { at: At::Point(point), .. }) = load.on() {
            add("loads", number, &["on", "at"], *point);
        }
    }
    for (number, probe) in model.probes.iter().enumerate() {
        if let At::Point(point) = probe.on.at {
            add("probes", number, &["on", "at"], point);
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    const PENDULUM: &str = r#"
materials.steel = { density = 7850, young = 2e11 }
sections.round = { kind = "circle", diameter = 0.02 }
bodies = [
    { kind = "beam", name = "upper", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = "round", material = "steel" },
    # The lower arm.
    { kind = "cable", name = "lower", from = [1.0, 0, 0 ], to = [2, 0, 0], elements = 2, section = "round", material = "steel" },
]

[[joints]]
kind = "spherical"
name = "pivot"
a = { body = "upper", at = "start" }

[[joints]]
kind = "spherical"
name = "elbow"
a = { body = "upper", at = "end" }
b = { body = "lower", at = "start" }

[[loads]]
kind = "force"
on = { body = "lower", at = "end" }
force = [0, 12, 0] # N

[analysis]
kind = "statics"
"#;

    #[test]
    fn joints_and_forces_have_handles() {
        let handles = handles(PENDULUM);
        let names: Vec<_> = handles.iter().map(|handle| handle.name.as_str()).collect();
        assert_eq!(names, ["pivot", "elbow", "lower"]);
        assert_eq!(handles[1].position, [1.0, 0.0, 0.0]);
        assert_eq!(handles[2].force, Some([0.0, 12.0, 0.0]));
    }

    #[test]
    fn an_elbow_takes_both_arms_along_and_keeps_the_rest_of_the_text() {
        let text = moved(PENDULUM, 1, [1.2, -0.123456, 0.0]).unwrap();
        let model = Model::parse(&text).unwrap();
        let spans: Vec<_> = model.bodies.iter().map(Body::span).collect();
        assert_eq!(spans, [[[0.0; 3], [1.2, -0.123, 0.0]], [[1.2, -0.123, 0.0], [2.0, 0.0, 0.0]]]);
        assert!(text.contains("# The lower arm."));
        assert!(text.contains("from = [1.2, -0.123, 0.0 ]"), "{text}");
        let lines = |text: &str| text.lines().count();
        assert_eq!(lines(&text), lines(PENDULUM));
    }

    #[test]
    fn a_force_changes_alone() {
        let text = moved(PENDULUM, 2, [-2.71234, 0.0, 25.0]).unwrap();
        assert_eq!(text, PENDULUM.replace("[0, 12, 0]", "[-2.71, 0.0, 25.0]"));
    }

    #[test]
    fn texts_with_errors_have_no_handles() {
        assert_eq!(handles("bodies = 3"), []);
        assert_eq!(moved(PENDULUM, 9, [0.0; 3]), None);
    }
}
