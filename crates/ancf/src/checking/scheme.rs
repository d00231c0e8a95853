//! Checks of the time step, of the integration scheme and of the estimate of errors.

use crate::errors::{Finding, finding, number};
use crate::joints::Joint;
use crate::model::{Analysis, Body, Dynamics, EndCondition, IndexedModel, Origin, Scheme, Step};

/// Upper limit on the number of steps. Larger values are assumed to be typing errors.
const MAX_STEPS: f64 = 1e9;

/// Checks that an analysis has at least one step and at most the limit, and that conditions of its end have limits.
pub(crate) fn time(model: &IndexedModel<'_>) -> Vec<Finding> {
    let Some(Dynamics { duration, step, until, .. }) = model.analysis.dynamics() else { return Vec::new() };
    let sizes = match *step {
        Step::Fixed(step) => [("analysis.step", Some(step)), ("analysis.step.largest", None)],
        Step::Adaptive { initial, largest, .. } => {
            [("analysis.step.initial", initial), ("analysis.step.largest", largest)]
        }
    };
    let intervals = [("output.interval", model.output.interval)];
    let unlimited = |(i, one): (usize, &EndCondition)| {
        let path = format!("analysis.until[{i}]");
        let is_unlimited = one.above.is_none() && one.below.is_none();
        is_unlimited.then(|| finding(path, "a value without a limit", "`above` or `below`"))
    };
    let of = |(path, size): (&str, Option<f64>)| rule_of_time(path, size?, *duration);
    let of_sizes = sizes.into_iter().chain(intervals).filter_map(of);
    of_sizes.chain(until.iter().enumerate().filter_map(unlimited)).collect()
}

fn rule_of_time(path: &str, size: f64, duration: f64) -> Option<Finding> {
    let error = if size > duration {
        finding(path.into(), number(size), format!("at most the duration, {}", number(duration)))
    } else if duration / size > MAX_STEPS {
        let found = format!("{:.1e} steps", duration / size);
        finding(path.into(), found, format!("at most {MAX_STEPS:e} steps"))
    } else {
        return None;
    };
    Some(error.rests_on(["analysis.duration".into()]))
}

/// Checks that the scheme is implicit and stable with the joints of the model, and of second order for error-controlled steps.
pub(crate) fn scheme(model: &IndexedModel<'_>) -> Vec<Finding> {
    let Some(Dynamics { scheme, step, .. }) = model.analysis.dynamics() else { return Vec::new() };
    let numbers = scheme.numbers();
    let (path, key) = path_and_found(*scheme);
    let is_constraint =
        |joint: &Joint| !matches!(joint, Joint::Spring(_) | Joint::Bushing(_) | Joint::MatrixBushing(_));
    let constraints = model.joints.iter().any(is_constraint)
        || model.bodies.iter().any(|body| matches!(body, Body::Rigid(_)));
    let found = |what: &str| if key == "0" { key.clone() } else { format!("{key}, which has {what}") };
    let error = |found: String, expected: &str, hint: &str| finding(path.into(), found, expected).hint(hint);
    let rule = if numbers.beta == 0.0 {
        let reason = "an explicit scheme leaves the reactions of joints undetermined, since their rows β h² Φ_q vanish";
        error(found("β = 0"), "β > 0, as in \"average_acceleration\" or \"adams\"", reason)
    } else if numbers.is_newmark() && numbers.gamma < 0.5 {
        let found = number(numbers.gamma);
        finding("analysis.scheme.gamma".into(), found, "γ ≥ 1/2")
            .hint("with less, every vibration grows from step to step, however small the step is")
    } else if constraints && 2.0 * numbers.beta < numbers.gamma * (1.0 - 1e-12) {
        let reason = "with less, the forces of constraints grow from step to step, by a factor of \
                      3.7 for γ = 1/2, β = 1/6";
        let expected = "2β ≥ γ in a model with joints or rigid bodies";
        error(found("2β < γ"), expected, reason).rests_on(["joints".into(), "bodies".into()])
    } else if step.fixed().is_none() && numbers.averaging.is_some() {
        let expected = "a generalized-α scheme, such as { spectral_radius = 0.6 }, or a fixed `step`";
        error(
            key,
            expected,
            "the energy-momentum scheme does not damp the disturbance that each change of the step makes",
        )
        .rests_on(["analysis.step".into()])
    } else if step.fixed().is_none() && !numbers.is_second_order() {
        let expected = "a scheme of second order, such as { spectral_radius = 0.8 }";
        error(key, expected, "adaptive steps go by an error that is of third order in the step")
            .rests_on(["analysis.step".into()])
    } else if step.fixed().is_none() && constraints && numbers.gamma <= 0.5 {
        let expected = "a scheme that damps, such as { spectral_radius = 0.8 }";
        error(
            key,
            expected,
            "without damping every change of the step makes the forces of constraints alternate",
        )
        .rests_on(["analysis.step".into(), "joints".into(), "bodies".into()])
    } else {
        return Vec::new();
    };
    let numbers = ["alpha", "beta", "energy_damping", "gamma", "spectral_radius"];
    let numbers = numbers.map(|key| format!("analysis.scheme.{key}"));
    let rests_on = [rule.rests_on.clone(), numbers.to_vec()].concat();
    vec![rule.rests_on(rests_on)]
}

/// Checks that errors are estimated only where an estimate exists.
pub(crate) fn errors(model: &IndexedModel<'_>) -> Vec<Finding> {
    let is_averaged = |own: &Dynamics| own.scheme.numbers().averaging.is_some();
    let (found, rests_on) = match &model.analysis {
        _ if !model.output.errors => return Vec::new(),
        Analysis::Path(_) => ("true for a path", "analysis.kind"),
        Analysis::Dynamics(own) if is_averaged(own) => {
            ("true with an energy-momentum scheme", "analysis.scheme")
        }
        Analysis::Dynamics(_) if !model.contacts.is_empty() => ("true with contacts", "contacts"),
        // The estimate begins without errors, but an equilibrium has those of its mesh. A second motion has its own equilibrium.
        Analysis::Dynamics(_)
            if !(model.starts_undeformed()
                || model.has_shells() && model.initial.from == Origin::Equilibrium) =>
        {
            ("true with `initial.from`", "initial.from")
        }
        _ => return Vec::new(),
    };
    let expected = "false; errors are estimated in statics, and in dynamics from the undeformed state, with shells also from an equilibrium, \
                    with generalized-α schemes without contacts";
    vec![finding("output.errors".into(), found, expected).rests_on([rests_on.into()])]
}

/// Key of a scheme and its description, for findings.
fn path_and_found(scheme: Scheme) -> (&'static str, String) {
    let name = |name: &str| ("analysis.scheme", format!("\"{name}\""));
    match scheme {
        Scheme::Adams => name("adams"),
        Scheme::AverageAcceleration => name("average_acceleration"),
        Scheme::LinearAcceleration => name("linear_acceleration"),
        Scheme::CentralDifference => name("central_difference"),
        Scheme::Pair { beta: 0.0, .. } => ("analysis.scheme.beta", "0".into()),
        Scheme::Pair { gamma, beta } => {
            ("analysis.scheme", format!("γ = {}, β = {}", number(gamma), number(beta)))
        }
        Scheme::GeneralizedAlpha { spectral_radius } => {
            ("analysis.scheme", format!("a spectral radius of {}", number(spectral_radius)))
        }
        Scheme::Hht { alpha } => ("analysis.scheme", format!("α = {}", number(alpha))),
        Scheme::Energy => name("energy"),
        Scheme::DampedEnergy { energy_damping } => {
            ("analysis.scheme", format!("an energy-momentum scheme with χ = {}", number(energy_damping)))
        }
    }
}
