//! Known defects, by which findings are sorted.

use ancf::Model;
use ancf::model::{Analysis, Body, End, Formulation, Joint, Load, Place};

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
        name: "reversal of beams on equilibrium paths, not yet explained",
        is_cause: |model, finding| finding.law == "reversal" && matches!(model.analysis, Analysis::Path(_)),
    },
    Known {
        name: "mesh dependence of arms on sections, not yet explained",
        is_cause: |model, _| has_arm(model),
    },
    Known {
        name: "frame of the section forces of cables",
        is_cause: |model, finding| is_section_force_of_cable(model, &finding.quantity),
    },
    Known {
        name: "mesh dependence of corners, not yet explained",
        is_cause: |model, finding| {
            ["elements", "rotation", "axes"].contains(&finding.law) && has_corner(model)
        },
    },
    Known {
        name: "exchange of the ends of clamps between unlike bodies, not yet explained",
        is_cause: |model, finding| finding.law == "exchange" && has_mixed_clamp(model),
    },
    Known {
        name: "equilibria near rounding errors are not found",
        is_cause: |model, finding| {
            finding.quantity == "verdict"
                && matches!(model.analysis, Analysis::Path(_) | Analysis::Statics(_))
        },
    },
    Known {
        name: "frequencies near rounding errors are not found",
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

/// True with a rigid arm on a deformable section.
fn has_arm(model: &Model) -> bool {
    let is_arm = |place: &Place| place.offset != [0.0; 3] && is_beam(model, &place.body);
    let of_joints = model.joints.iter().any(|joint| {
        let (a, b) = joint.ends();
        is_arm(a) || matches!(b, End::Place(place) if is_arm(place))
    });
    of_joints || model.loads.iter().any(|load| matches!(load, Load::Force(force) if is_arm(&force.on)))
}

/// Bodies of the two ends of a clamp between bodies.
fn clamped<'a>(model: &'a Model, joint: &'a Joint) -> Option<([&'a Body; 2], bool)> {
    let Joint::Clamp(clamp) = joint else { return None };
    let End::Place(b) = &clamp.b else { return None };
    let body = |place: &Place| model.bodies.iter().find(|body| body.name() == place.body);
    Some(([body(&clamp.a)?, body(b)?], clamp.fix.is_none()))
}

fn has_corner(model: &Model) -> bool {
    let mut clamps = model.joints.iter().filter_map(|joint| clamped(model, joint));
    clamps.any(|(bodies, _)| bodies.iter().all(|body| matches!(body, Body::Beam(_))))
}

fn has_mixed_clamp(model: &Model) -> bool {
    let is_continuum =
        |body: &Body| matches!(body, Body::Beam(beam) if beam.formulation == Formulation::Continuum);
    let mut clamps = model.joints.iter().filter_map(|joint| clamped(model, joint));
    clamps.any(|([a, b], is_default)| is_default && is_continuum(a) != is_continuum(b))
}

fn is_section_force_of_cable(model: &Model, column: &str) -> bool {
    let Some((probe, suffix)) = column.rsplit_once('.') else { return false };
    let probe = model.probes.iter().find(|other| other.name == probe);
    let on_cable = probe.and_then(|probe| model.bodies.iter().find(|body| body.name() == probe.on.body));
    matches!(on_cable, Some(Body::Cable(_))) && ["Qy", "Qz", "My", "Mz", "T"].contains(&suffix)
}
