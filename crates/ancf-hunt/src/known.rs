//! Known defects, by which findings are sorted.

use ancf::Model;
use ancf::model::{Analysis, Body, End, Joint, Load, Place};

use crate::compare::Finding;

/// Known defect: findings for which the predicate is true are counted, but do not fail a hunt.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    /// Name of the defect.
    pub name: &'static str,
    /// True for findings of the defect.
    pub is_cause: fn(&Model, &Finding) -> bool,
}

/// Known defects. An entry without findings in the test is an error: remove it when the defect is mended.
pub const KNOWN: &[Known] = &[
    Known {
        name: "joints on sections in steps that do not resolve the motion, not yet explained",
        is_cause: |model, _| model.joints.iter().any(|j| distorts(model, j)),
    },
    Known {
        name: "angular rates of rigid bodies in steps that do not resolve the motion, not yet explained",
        is_cause: |model, finding| {
            let suffix = finding.quantity.rsplit_once('.').map_or("", |(_, suffix)| suffix);
            let is_frame =
                ["rotation", "axes"].contains(&finding.law) && ["wx", "wy", "wz", "rate"].contains(&suffix);
            is_frame && model.bodies.iter().any(|body| matches!(body, Body::Rigid(_)))
        },
    },
    Known {
        name: "energy of damped motions, not yet explained",
        is_cause: |model, finding| finding.law == "energy" && is_damped(model),
    },
    Known {
        name: "stiff motions of bodies split in two, with exchanged ends or other tangents, that the steps do not resolve",
        is_cause: |model, finding| {
            matches!(model.analysis, Analysis::Dynamics(_))
                && ["split", "exchange", "tangents"].contains(&finding.law)
        },
    },
    Known {
        name: "frequencies of free structures near rounding errors are not found",
        is_cause: |model, finding| {
            finding.quantity == "verdict" && matches!(model.analysis, Analysis::Modes(_))
        },
    },
];

/// Known defect of a finding.
pub fn cause(model: &Model, finding: &Finding) -> Option<&'static str> {
    KNOWN.iter().find(|known| (known.is_cause)(model, finding)).map(|known| known.name)
}

fn is_beam(model: &Model, name: &str) -> bool {
    model.bodies.iter().any(|body| body.name() == name && matches!(body, Body::Beam(_)))
}

/// True for joints that constrain directions of a deformable section.
fn distorts(model: &Model, joint: &Joint) -> bool {
    let on_beam = |place: &Place| is_beam(model, &place.body);
    let second = |end: &End| matches!(end, End::Place(place) if on_beam(place));
    let (a, b) = joint.ends();
    match joint {
        Joint::Clamp(_)
        | Joint::Spherical(_)
        | Joint::Drive(_)
        | Joint::Distance(_)
        | Joint::Spring(_)
        | Joint::Slide(_) => false,
        Joint::PointOnLine(_) => second(b),
        _ => on_beam(a) || second(b),
    }
}

fn is_damped(model: &Model) -> bool {
    let of_materials =
        model.materials.values().any(|material| material.damping.strain + material.damping.mass > 0.0);
    let of_loads = model.loads.iter().any(|load| matches!(load, Load::Fluid(_)));
    of_materials || of_loads || !model.joints.is_empty()
}
