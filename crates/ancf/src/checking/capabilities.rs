//! What a body cannot do it is not asked to: a cable has a tangent only, a point mass no directions, a rigid body no strain.

use super::findings::{body, named, places_of};
use crate::errors::{Finding, finding, quoted};
use crate::model::{Body, End, Joint, Model, Quantity, joints_of, loads_of};

/// What is asked of a place.
enum Ability {
    /// To tie a direction.
    Direction,
    /// To turn about any axis.
    Section,
    /// To be turned by a driven clamp.
    Driven,
    /// To carry section forces, strain and stress.
    Strain,
}

pub(crate) fn abilities(model: &Model) -> Vec<Finding> {
    let joints = joints_of(model).flat_map(|(path, joint)| {
        let (a, b) = joint.ends();
        let [of_a, of_b] = asked(joint);
        let b = if let End::Place(b) = b { Some((format!("{path}.b"), b, of_b)) } else { None };
        let ends = [(format!("{path}.a"), a, of_a)].into_iter().chain(b);
        ends.filter_map(|(path, place, wanted)| {
            let (ability, what) = wanted?;
            rule(model, format!("{path}.body"), &place.body, &ability, what)
        })
        .collect::<Vec<_>>()
    });
    let loads = loads_of(model).filter_map(|(path, load)| {
        let what = match (load.is_moment(), load.is_follower()) {
            (true, _) => "a moment",
            (false, true) => "a follower",
            (false, false) => return None,
        };
        let (key, name) = match (load.on(), load.stretch()) {
            (Some(place), _) => ("on.body", place.body.as_str()),
            (None, Some(stretch)) => ("body", stretch.body),
            (None, None) => return None,
        };
        rule(model, format!("{path}.{key}"), name, &Ability::Section, what)
    });
    let probes = model.probes.iter().enumerate().flat_map(|(i, probe)| {
        let path = format!("probes[{i}].on");
        let of = |quantity: &Quantity| match quantity {
            Quantity::Motion => None,
            Quantity::Rotation => Some((Ability::Section, "a rotation")),
            Quantity::SectionForces => Some((Ability::Strain, "section forces")),
            Quantity::Strain => Some((Ability::Strain, "strain")),
            Quantity::Stress => Some((Ability::Strain, "stress")),
        };
        let rules = probe.record.iter().filter_map(of);
        rules
            .filter_map(|(ability, what)| rule(model, format!("{path}.body"), &probe.on.body, &ability, what))
            .collect::<Vec<_>>()
    });
    joints.chain(loads).chain(probes).chain(arms(model)).collect()
}

/// What a joint asks of its ends.
fn asked(joint: &Joint) -> [Option<(Ability, &'static str)>; 2] {
    let both = |ability: fn() -> Ability, what| [Some((ability(), what)), Some((ability(), what))];
    let section = |what| both(|| Ability::Section, what);
    match joint {
        Joint::Spherical { .. } | Joint::Distance(_) | Joint::Slide(_) | Joint::Spring(_) => [None, None],
        Joint::Clamp { .. } => both(|| Ability::Direction, "a clamp"),
        Joint::Revolute { .. } => section("a hinge"),
        Joint::Drive { axis: Some(_), .. } => both(|| Ability::Driven, "a drive"),
        Joint::Drive { axis: None, .. } => [None, None],
        Joint::Universal(_) => section("a universal joint"),
        Joint::Cylindrical(_) => section("a cylindrical joint"),
        Joint::Prismatic(_) => section("a prismatic joint"),
        Joint::Planar(_) => section("a planar joint"),
        Joint::Bushing(_) => section("a bushing"),
        Joint::PointOnLine(_) => [None, Some((Ability::Section, "a guide line"))],
    }
}

fn rule(model: &Model, path: String, name: &str, ability: &Ability, what: &str) -> Option<Finding> {
    let (_, body) = named(model, name)?;
    let (found, wanted) = match (body, ability) {
        (Body::Cable(_), Ability::Section | Ability::Driven) => {
            (format!("{what} of a cable, which has no section to turn"), "a beam or a rigid body")
        }
        (Body::Mass(_), Ability::Direction) => (
            format!("{what} of a point mass, which has no directions"),
            "a \"spherical\" joint, or another body",
        ),
        (Body::Mass(_), Ability::Section | Ability::Driven) => {
            (format!("{what} of a point mass, which has no directions"), "a beam or a rigid body")
        }
        (Body::Rigid(_), Ability::Driven) => {
            (format!("{what} that clamps a rigid body"), "a beam, or a driven \"revolute\" joint")
        }
        (Body::Rigid(_) | Body::Mass(_), Ability::Strain) => {
            (format!("{what} of {}, which is rigid", quoted(body.name())), "a beam or a cable")
        }
        _ => return None,
    };
    Some(finding(path, found, wanted).rests_on(["bodies".into()]))
}

/// Arms are fixed to sections and to rigid bodies.
fn arms(model: &Model) -> Vec<Finding> {
    let armed = places_of(model).filter(|(_, place)| place.offset != [0.0; 3]);
    let unfit = armed.filter_map(|(path, place)| match body(model, place)?.1 {
        Body::Beam(_) | Body::Rigid(_) => None,
        Body::Cable(_) | Body::Mass(_) => {
            let error = finding(
                format!("{path}.offset"),
                "an arm on a body without sections",
                "a beam or a rigid body",
            );
            Some(error.rests_on(["bodies".into()]))
        }
    });
    unfit.collect()
}
