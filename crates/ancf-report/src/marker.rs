use ancf::mechanics::Attachment;
use ancf::model::{Joint, Load, Probe, Quantity};
use ancf::system::State;
use nalgebra::Vector3;

use crate::place::Places;

/// A point that is marked: a joint, a probe, a load.
pub(crate) struct Marker {
    pub name: String,
    pub kind: &'static str,
    pub detail: String,
    held: Attachment,
}

impl Marker {
    /// Where it is, in the solver's units.
    pub fn at(&self, s: &State) -> Vector3<f64> {
        self.held.point.value(s)
    }

    /// Where it is in the undeformed state.
    pub fn reference(&self) -> Vector3<f64> {
        self.held.point.reference()
    }
}

/// The marks of a model, and of each joint the number of its mark.
pub(crate) fn markers(places: Places<'_>) -> (Vec<Marker>, Vec<Option<usize>>) {
    let mut all = Vec::new();
    let mut of_joints = Vec::new();
    for joint in &places.model.joints {
        let held = places.attachment(joint.ends().0);
        of_joints.push(held.is_some().then_some(all.len()));
        let (name, detail) = (joint.name().to_owned(), word(joint).to_owned());
        all.extend(held.map(|held| Marker { name, kind: "joint", detail, held }));
    }
    // Where a probe is does not depend on what it records.
    let point = |probe: &Probe| {
        let measure = places.assembly.measures.iter().find(|measure| measure.name == probe.name);
        measure.map(|measure| measure.place.clone()).or_else(|| places.attachment(&probe.on))
    };
    for probe in &places.model.probes {
        let (name, detail) = (probe.name.clone(), recorded(probe));
        all.extend(point(probe).map(|held| Marker { name, kind: "probe", detail, held }));
    }
    for (number, load) in places.model.loads.iter().enumerate() {
        let held = load.on().and_then(|place| places.attachment(place));
        let (name, detail) = acting(number, load);
        all.extend(held.map(|held| Marker { name, kind: "load", detail, held }));
    }
    (all, of_joints)
}

fn recorded(probe: &Probe) -> String {
    let words = probe.record.iter().map(|quantity| match quantity {
        Quantity::Motion => "motion",
        Quantity::Rotation => "rotation",
        Quantity::SectionForces => "section forces",
        Quantity::Strain => "strain",
        Quantity::Stress => "stress",
    });
    words.collect::<Vec<_>>().join(", ")
}

/// Name and kind of a load.
fn acting(number: usize, load: &Load) -> (String, String) {
    let word = match load {
        Load::Force { follower: false, .. } => "force",
        Load::Force { follower: true, .. } => "following force",
        Load::Moment { follower: false, .. } => "moment",
        Load::Moment { follower: true, .. } => "following moment",
        Load::External { name, .. } => return (name.clone(), "supplied force".to_owned()),
        _ => "load",
    };
    (format!("loads[{number}]"), word.to_owned())
}

/// The kind of a joint, as model files have it.
const fn word(joint: &Joint) -> &'static str {
    match joint {
        Joint::Clamp { .. } => "clamp",
        Joint::Revolute { .. } => "revolute",
        Joint::Spherical { .. } => "spherical",
        Joint::Drive { .. } => "drive",
        Joint::Universal(_) => "universal",
        Joint::Cylindrical(_) => "cylindrical",
        Joint::Prismatic(_) => "prismatic",
        Joint::Planar(_) => "planar",
        Joint::PointOnLine(_) => "point_on_line",
        Joint::Distance(_) => "distance",
        Joint::Slide(_) => "slide",
        Joint::Bushing(_) => "bushing",
        Joint::Spring(_) => "spring",
    }
}
