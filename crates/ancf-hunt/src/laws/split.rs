//! A beam is equal to two beams that are clamped to each other.

use ancf::model::{At, Beam, Body, Clamp, ClampedGradients, End, Joint, NamedPosition, Place, Shape};
use ancf::nalgebra::{Rotation3, Unit, Vector3};

use super::law::{Check, EQUAL, Law, check_twin};
use crate::compare::Case;
use crate::random::Random;

/// Division of a straight beam of constant section at a node. All coordinates of the node are shared, so that the model is the same.
/// Steps by error control differ, since the estimates of the error count the coordinates of the node twice.
///
/// No clamp shares the coordinates of three-node elements: `"section"` leaves the size of both sections free, and `"all"`
/// constrains the axial gradient, which is no coordinate of the node.
pub(super) struct Split;

impl Law for Split {
    fn name(&self) -> &'static str {
        "split"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        let twin = split(case, random).filter(|_| !case.has_controlled_steps());
        check_twin(self.name(), case, twin, |_| {}, EQUAL)
    }
}

fn split(case: &Case, random: &mut Random) -> Option<ancf::Model> {
    let mut twin = case.model.clone();
    let is_fit = |body: &Body| matches!(body, Body::Beam(beam) if beam.elements > 1 && !beam.formulation.has_middle_node() && beam.shape == Shape::Straight && beam.section_end.is_none());
    let index = twin.bodies.iter().position(is_fit)?;
    let length = twin.bodies[index].length();
    let name = twin.bodies[index].name().to_owned();
    // Loads per length, fluids and contacts would have to be divided too.
    let is_loaded = twin.loads.iter().any(|load| load.on().is_none()) || !twin.contacts.is_empty();
    if is_loaded {
        return None;
    }
    // A slider cannot leave the part on which it starts.
    let is_on = |joint: &Joint| matches!(joint, Joint::Slide(slide) if matches!(&slide.b, End::Place(place) if place.body == name));
    if twin.joints.iter().any(is_on) {
        return None;
    }
    let up = twin.bodies[index].up()?;
    let Body::Beam(first) = &mut twin.bodies[index] else { return None };
    let node = 1 + random.index(first.elements as usize - 1) as u32;
    let part = f64::from(node) / f64::from(first.elements);
    let second = divide(first, node, &up);
    let other = second.name.clone();
    twin.bodies.push(Body::Beam(second));
    let cut = part * length;
    let map = |place: &mut Place| {
        if place.body != name {
            return Some(());
        }
        let s = match place.at {
            At::Named(NamedPosition::Start) => 0.0,
            At::Named(NamedPosition::Center) => 0.5 * length,
            At::Named(NamedPosition::End) => length,
            At::Length(s) => s,
            _ => return None,
        };
        // At the node itself, the sides differ for strain.
        if s <= cut {
            place.at = At::Length(s.min(cut));
        } else {
            place.body.clone_from(&other);
            place.at = if s == length { At::Named(NamedPosition::End) } else { At::Length(s - cut) };
        }
        Some(())
    };
    for place in super::reversal::all_places(&mut twin) {
        map(place)?;
    }
    twin.joints.push(Joint::Clamp(Clamp {
        name: "weld".into(),
        a: Place::new(&other, At::Named(NamedPosition::Start)),
        b: End::Place(Place::new(&name, At::Named(NamedPosition::End))),
        fix: Some(ClampedGradients::All),
    }));
    Some(twin)
}

/// Shortens a beam to its first elements and returns the rest.
fn divide(first: &mut Beam, node: u32, up: &Vector3<f64>) -> Beam {
    let part = f64::from(node) / f64::from(first.elements);
    let (from, to) = (Vector3::from(first.from), Vector3::from(first.to));
    let at = from + part * (to - from);
    let mut second = first.clone();
    second.name = format!("{}-second", first.name);
    second.from = at.into();
    second.elements = first.elements - node;
    second.motion.about = first.motion.about.or(Some(first.from));
    let axis = Unit::new_normalize(to - from);
    second.up = Some((Rotation3::from_axis_angle(&axis, part * first.twist) * up).into());
    second.twist = (1.0 - part) * first.twist;
    first.up = Some((*up).into());
    (first.to, first.elements, first.twist) = (at.into(), node, part * first.twist);
    second
}
