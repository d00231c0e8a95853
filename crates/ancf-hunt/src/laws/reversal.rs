//! Results do not depend on the direction of the axis of a body.

use ancf::Model;
use ancf::model::{At, Beam, Body, End, Joint, Load, NamedPosition, Place, Shape};
use ancf::nalgebra::{Rotation3, Unit, Vector3};

use super::law::{Check, EQUAL, Law, check_twin};
use crate::compare::Case;
use crate::frames::{align, scale};
use crate::random::Random;
use crate::run::Run;

/// Exchange of start and end of all straight beams and of all cables.
///
/// The normal and the z-axis of each section change their sign, the y-axis does not.
pub(super) struct Reversal;

impl Law for Reversal {
    fn name(&self) -> &'static str {
        "reversal"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let model = &case.model;
        let mut twin = model.clone();
        if twin.joints.iter().any(|joint| matches!(joint, Joint::Slide(_))) {
            return Check::Inapplicable;
        }
        let mut reversed = Vec::new();
        for body in &mut twin.bodies {
            let length = body.length();
            if reverse(body).is_some() {
                reversed.push((body.name().to_owned(), length));
            }
        }
        for place in all_places(&mut twin) {
            if let Some((_, length)) = reversed.iter().find(|(name, _)| *name == place.body) {
                place.at = opposite(&place.at, *length);
            }
        }
        for load in &mut twin.loads {
            line_load(load, &reversed);
            prestrain(load, &reversed);
        }
        let mut owners = Vec::new();
        for probe in &mut twin.probes {
            if reversed.iter().any(|(name, _)| *name == probe.on.body) {
                probe.offset[1] = -probe.offset[1];
                let is_cable =
                    model.bodies.iter().any(|b| b.name() == probe.on.body && matches!(b, Body::Cable(_)));
                owners.push((probe.name.clone(), is_cable));
            }
        }
        let back = |run: &mut Run| {
            for (owner, is_cable) in &owners {
                for name in ["Qy", "My", "exy", "eyz", "sxy", "syz"] {
                    scale(run, owner, name, -1.0);
                }
                // The frame of a cable is carried from its start, the other end of the twin.
                if *is_cable {
                    align(&case.base, run, owner);
                }
            }
        };
        check_twin(self.name(), case, (!reversed.is_empty()).then_some(twin), back, EQUAL)
    }
}

fn reverse(body: &mut Body) -> Option<()> {
    let up = body.up()?;
    match body {
        Body::Beam(beam) => reverse_beam(beam, &up),
        Body::Cable(cable) => {
            cable.up = Some(up.into());
            cable.motion.about = cable.motion.about.or(Some(cable.from));
            std::mem::swap(&mut cable.from, &mut cable.to);
            Some(())
        }
        Body::Shell(_) | Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => None,
    }
}

/// The rotation of the sections from start to end keeps its sign: axis and sense are both reversed.
fn reverse_beam(beam: &mut Beam, up: &Vector3<f64>) -> Option<()> {
    if beam.shape != Shape::Straight {
        return None;
    }
    let axis = Unit::new_normalize(Vector3::from(beam.to) - Vector3::from(beam.from));
    beam.up = Some((Rotation3::from_axis_angle(&axis, beam.twist) * up).into());
    beam.motion.about = beam.motion.about.or(Some(beam.from));
    std::mem::swap(&mut beam.from, &mut beam.to);
    if let Some(end) = &mut beam.section_end {
        std::mem::swap(end, &mut beam.section);
    }
    Some(())
}

fn opposite(at: &At, length: f64) -> At {
    match at {
        At::Named(NamedPosition::Start) => At::Named(NamedPosition::End),
        At::Named(NamedPosition::End) => At::Named(NamedPosition::Start),
        At::Length(s) => At::Length(length - s),
        other => other.clone(),
    }
}

fn place_of_load(load: &mut Load) -> Option<&mut Place> {
    match load {
        Load::Force(load) => Some(&mut load.on),
        Load::Moment(load) => Some(&mut load.on),
        _ => None,
    }
}

fn line_load(load: &mut Load, reversed: &[(String, f64)]) {
    let (body, from, to, start, end, follower) = match load {
        Load::DistributedForce(l) => {
            (&l.body, &mut l.from, &mut l.to, &mut l.force, &mut l.force_end, l.follower)
        }
        Load::DistributedMoment(l) => {
            (&l.body, &mut l.from, &mut l.to, &mut l.moment, &mut l.moment_end, l.follower)
        }
        _ => return,
    };
    let Some((_, length)) = reversed.iter().find(|(name, _)| name == body) else { return };
    (*from, *to) = (opposite(to, *length), opposite(from, *length));
    if let Some(end) = end {
        std::mem::swap(start, end);
    }
    if follower {
        let map = |x: &mut [f64; 3]| *x = [-x[0], x[1], -x[2]];
        map(start);
        end.iter_mut().for_each(map);
    }
}

/// A curvature changes its sign, and so do the axes x and z of the section.
fn prestrain(load: &mut Load, reversed: &[(String, f64)]) {
    let Load::Prestrain(load) = load else { return };
    let Some((_, length)) = reversed.iter().find(|(name, _)| *name == load.body) else { return };
    (load.from, load.to) = (opposite(&load.to, *length), opposite(&load.from, *length));
    if let Some(end) = &mut load.strain_end {
        std::mem::swap(&mut load.strain, end);
    }
    if let Some(end) = &mut load.curvature_end {
        std::mem::swap(&mut load.curvature, end);
    }
    load.curvature[1] = -load.curvature[1];
    load.curvature_end.iter_mut().for_each(|end| end[1] = -end[1]);
}

/// Places of joints, loads and probes.
pub(super) fn all_places(model: &mut Model) -> impl Iterator<Item = &mut Place> {
    places(&mut model.joints)
        .chain(model.loads.iter_mut().filter_map(place_of_load))
        .chain(model.probes.iter_mut().map(|probe| &mut probe.on))
}

/// Places of all joints.
fn places(joints: &mut [Joint]) -> impl Iterator<Item = &mut Place> {
    joints.iter_mut().flat_map(|joint| {
        let (a, b) = match joint {
            Joint::Clamp(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Revolute(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Spherical(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Drive(j) => (&mut j.a, None),
            Joint::Universal(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Cylindrical(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Prismatic(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Planar(j) => (&mut j.a, Some(&mut j.b)),
            Joint::PointOnLine(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Distance(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Slide(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Bushing(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Generic(j) => (&mut j.a, Some(&mut j.b)),
            Joint::MatrixBushing(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Spring(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Sensor(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Support(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Seam(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Bond(j) => (&mut j.a, Some(&mut j.b)),
            Joint::Custom(_) => return Vec::new(),
        };
        let second = b.and_then(|end| if let End::Place(place) = end { Some(place) } else { None });
        [a].into_iter().chain(second).collect()
    })
}
