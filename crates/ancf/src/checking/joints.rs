//! Checks of joints, of drives, springs and friction, and of couplings.

use ancf_solver::equations::LOCAL;

use super::findings::{COINCIDENT, body};
use crate::errors::{Finding, finding, is_direction, no_direction, number, quoted};
use crate::joints::{Coupled, End, Joint, JointActions, JointCoordinate};
use crate::model::{Analysis, IndexedModel, Place, TimeFunction, Varying, joints_of};
use crate::schema::unknown;

/// Checks that axes are directions.
pub(crate) fn axes(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, joint) in joints_of(model) {
        let wrong = joint.kind().axes().into_iter().filter(|(_, axis)| !is_direction(*axis));
        findings.extend(wrong.map(|(key, axis)| no_direction(format!("{path}.{key}"), axis)));
    }
    findings
}

/// Checks of the kinds of joints.
pub(crate) fn kinds(model: &IndexedModel<'_>) -> Vec<Finding> {
    joints_of(model).flat_map(|(path, joint)| joint.kind().check(&path, model)).collect()
}

/// Checks that joints between two points have distinct points, and that other joints have no ground point unless they accept one.
pub(crate) fn spans(model: &IndexedModel<'_>) -> Vec<Finding> {
    let rule = |(path, joint): (String, &Joint)| {
        let (a, b) = joint.ends();
        let key = format!("{path}.b");
        let drawn = joint.kind().accepts_ground_point();
        let expected = "a place on another body or a point of the ground, `{ point = [x, y, z] }`";
        match (joint.kind().spans(), b) {
            (true, End::Ground) if !joint.kind().may_coincide() => Some(finding(key, "\"ground\"", expected)),
            (true, b) if !joint.kind().may_coincide() => {
                let (_, body) = body(model, a)?;
                let length = if body.is_flexible() { body.length() } else { model.length() };
                let apart = initial_distance(model, a, b)?;
                let rests_on = ["bodies".to_owned(), format!("{path}.a")];
                let expected = "one that is elsewhere; \"bushing\" is a spring between points that coincide";
                (apart <= COINCIDENT * length)
                    .then(|| finding(key, "the point of `a`", expected).rests_on(rests_on))
            }
            (false, End::Point(_)) if !drawn => {
                let expected = "\"ground\" or a place on a body";
                Some(finding(key, "a point of the ground", expected))
            }
            _ => None,
        }
    };
    joints_of(model).filter_map(rule).collect()
}

/// Returns the distance of the ends of a joint in the undeformed state; `None` for the ground without a point.
fn initial_distance(model: &IndexedModel<'_>, a: &Place, b: &End) -> Option<f64> {
    Some((model.point(a)? - model.end_point(b)?).norm())
}

/// Number of instants at which lengths that vary in time are checked.
const INSTANTS: u32 = 1000;

/// Checks that rods keep a positive length: the initial distance and its change.
pub(crate) fn lengths(model: &IndexedModel<'_>) -> Vec<Finding> {
    let rule = |(path, joint): (String, &Joint)| {
        let Joint::Distance(rod) = joint else { return None };
        let initial = initial_distance(model, &rod.a, &rod.b)?;
        let factors: Vec<f64> = match &model.analysis {
            Analysis::Dynamics(own) => {
                let function = rod.time.compile().ok()?;
                let instant =
                    |k: u32| model.initial.start_time + own.duration * f64::from(k) / f64::from(INSTANTS);
                let end = instant(INSTANTS);
                let breaks =
                    function.breaks().into_iter().filter(|t| (model.initial.start_time..=end).contains(t));
                (0..=INSTANTS).map(instant).chain(breaks).map(|t| function.value(t)).collect()
            }
            Analysis::Statics(own) => vec![own.load],
            _ => vec![1.0],
        };
        let least = factors.into_iter().map(|f| initial + rod.change * f).fold(f64::INFINITY, f64::min);
        (least <= 0.0).then(|| {
            let found = format!("a length of down to {}", number(least));
            let expected = format!(
                "a change that leaves a positive length of the initial distance, {}",
                number(initial)
            );
            let rests_on =
                ["bodies".into(), format!("{path}.a"), format!("{path}.b"), format!("{path}.time")];
            finding(format!("{path}.change"), found, expected).rests_on(rests_on)
        })
    };
    joints_of(model).filter_map(rule).collect()
}

/// Checks that drives state one amplitude, start at the undeformed state and are continuous, and that rates can be integrated.
pub(crate) fn drives(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, joint) in joints_of(model) {
        let [angle, displacement] = joint.kind().actions();
        for (actions, names) in [(angle, ["angle", "rate"]), (displacement, ["displacement", "speed"])] {
            findings.extend(rule_of_drive(model, &format!("{path}.{}", actions.table), &actions, names));
        }
    }
    findings
}

/// Checks that stops enclose the undeformed state.
pub(crate) fn stops(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (path, joint) in joints_of(model) {
        for stops in joint.kind().actions().into_iter().filter_map(|actions| actions.stops) {
            let [lower, upper] = stops.at;
            if stops.at == [None; 2] {
                let expected = "at least one of `lower` and `upper`";
                findings.push(finding(format!("{path}.stops"), "neither `lower` nor `upper`", expected));
            }
            for (key, value, beyond, side) in [
                ("lower", lower, lower > Some(0.0), "at most 0"),
                ("upper", upper, upper.is_some_and(|upper| upper < 0.0), "at least 0"),
            ] {
                let expected = format!("{side}, the value in the undeformed state");
                let error = || finding(format!("{path}.stops.{key}"), number(value.unwrap_or(0.0)), expected);
                findings.extend(beyond.then(error));
            }
        }
    }
    findings
}

fn rule_of_drive(
    model: &IndexedModel<'_>,
    path: &str,
    actions: &JointActions<'_>,
    [own, rate]: [&str; 2],
) -> Option<Finding> {
    let drive = actions.drive?;
    let expected = || format!("either `{own}` or `{rate}`");
    match drive.amounts {
        [Some(_), Some(_)] => Some(finding(path.into(), format!("both `{own}` and `{rate}`"), expected())),
        [None, None] => Some(finding(path.into(), format!("neither `{own}` nor `{rate}`"), expected())),
        [None, Some(_)] => {
            let open = drive.time.compile().is_ok_and(|function| function.integral().is_none());
            let what = match drive.time {
                TimeFunction::Varying(Varying::External { .. }) => "an external function",
                _ => "a formula",
            };
            let expected = format!("a function with an integral in closed form, or {what} of the `{own}`");
            open.then(|| finding(format!("{path}.time"), format!("{what} of a rate"), expected))
        }
        [Some(amount), None] => {
            let function = drive.time.compile().ok()?;
            let key = format!("{path}.time");
            if drive.time.jumps(model.end_time()) {
                return Some(finding(key, "a function that jumps", "a continuous function"));
            }
            let start = amount * function.value(0.0);
            (model.starts_undeformed() && start.abs() > 1e-6 * scale(model, own)).then(|| {
                let found = format!("{own} {} at t = 0", number(start));
                let error = finding(key, found, "a motion that starts from the undeformed state, at 0");
                Finding { absence: true, ..error.rests_on([format!("{path}.{own}")]) }
            })
        }
    }
}

/// Reference magnitude for the tolerance of an angle or a displacement.
fn scale(model: &IndexedModel<'_>, own: &str) -> f64 {
    if own == "angle" { 1.0 } else { model.length() }
}

/// Checks that couplings name free coordinates of joints, each once, with nonzero factors.
pub(crate) fn couplings(model: &IndexedModel<'_>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (i, coupling) in model.couplings.iter().enumerate() {
        let (count, most) = (coupling.joints.len(), LOCAL - 1);
        if count > most {
            let (found, expected) =
                (format!("{count} joints"), format!("at most {most}, or several couplings"));
            findings.push(finding(format!("couplings[{i}].joints"), found, expected));
        }
        for (k, part) in coupling.joints.iter().enumerate() {
            let path = format!("couplings[{i}].joints[{k}]");
            findings.extend(rule_of_part(model, &path, part, &coupling.joints[..k]));
        }
    }
    findings
}

fn rule_of_part(model: &IndexedModel<'_>, path: &str, part: &Coupled, before: &[Coupled]) -> Option<Finding> {
    let key = format!("{path}.joint");
    let Some(joint) = model.joint_number(&part.joint).map(|joint| &model.joints[joint]) else {
        let names = model.joints.iter().map(Joint::name).collect();
        return Some(unknown(key, "joint", &part.joint, names).rests_on(["joints".into()]));
    };
    let listed = match joint.kind().free_coordinates() {
        [] => None,
        [JointCoordinate::Angle] => Some("\"angle\""),
        [JointCoordinate::Displacement] => Some("\"displacement\""),
        _ => Some("\"angle\" or \"displacement\""),
    };
    let Some(listed) = listed else {
        let found = format!("{}, which has no single angle or displacement", quoted(&part.joint));
        let expected = "a \"revolute\", \"cylindrical\", \"prismatic\" or \"slide\" joint";
        return Some(finding(key, found, expected).rests_on(["joints".into()]));
    };
    if model.coupled_coordinate(part).is_none() {
        let found = "a coordinate that the joint does not have";
        return Some(finding(format!("{path}.of"), found, listed).rests_on(["joints".into(), key]));
    }
    if part.factor == 0.0 {
        return Some(finding(format!("{path}.factor"), "0", "a factor that is not 0"));
    }
    let again = before.iter().any(|other| model.coupled_coordinate(other) == model.coupled_coordinate(part));
    again.then(|| {
        finding(key.clone(), format!("{} a second time", quoted(&part.joint)), "each coordinate once")
    })
}
