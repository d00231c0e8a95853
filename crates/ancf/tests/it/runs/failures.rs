//! Numerical failures: the message states time, location, reason and advice; results up to the failure are kept.

use std::path::Path;

use ancf::mechanics::functions::ForceFunction;
use ancf::model::{Analysis, Statics, Step};
use ancf::record::Series;
use ancf::{Model, Outcome, Summary, simulate};

use crate::common::models::files;

fn model(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/models/numerics/{name}.toml"));
    Model::read(path).unwrap_or_else(|errors| panic!("{name}: {errors}"))
}

fn run(model: &Model) -> (Summary, Series) {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    (summary, series)
}

/// Failure with its time, reason, location and advice.
struct Failed {
    time: f64,
    reason: String,
    at: String,
    advice: String,
    /// Last recorded time.
    last: f64,
}

fn failed(model: &Model) -> Failed {
    let (summary, series) = run(model);
    let last = series.column("t").and_then(|t| t.last().copied()).unwrap();
    failure(model, summary, last)
}

/// Failure before the first record.
fn failed_at_once(model: &Model) -> Failed {
    failure(model, run(model).0, f64::NAN)
}

fn failure(model: &Model, summary: Summary, last: f64) -> Failed {
    let sentence = summary.outcome.failure(&model.analysis).unwrap();
    let Outcome::Failed { time, reason, at, advice } = summary.outcome else {
        panic!("{:?}", summary.outcome)
    };
    assert!(!advice.is_empty() && sentence.ends_with(&format!("; try: {advice}")), "{sentence}");
    Failed { time, reason, at, advice, last }
}

/// A velocity jump at t = 0.05 that steps of 0.01 and their quarters cannot resolve.
#[test]
fn divergence_is_located() {
    let Failed { time, reason, at, advice, last } = failed(&model("divergence"));
    assert!(time > 0.05 && time <= 0.06 && last == 0.05, "{time}, {last}");
    assert!(reason.ends_with(", with the step halved 2 times"), "{reason}");
    assert!(at.starts_with("body `strip`, node ") && at.contains(" (s = "), "{at}");
    assert!(advice.contains("a shorter `analysis.step`"), "{advice}");
}

/// The stiffness of a mechanism is singular.
#[test]
fn mechanism_without_equilibrium_is_named() {
    let Failed { time, reason, at, advice, .. } = failed_at_once(&model("singular"));
    assert_eq!(time, 0.0);
    assert_eq!(reason, "the model has no equilibrium: a motion is unsupported");
    assert_eq!(at, "body `arm` can rotate about the axis through (0, 0, 0) along z");
    assert!(advice.contains("joints, springs or stiffness that support the motion"), "{advice}");
}

/// The rotation of a rigid rod about its axis has no stiffness. The rod settles on its ball joint first, with rounding errors.
#[test]
fn modes_of_a_rotation_without_stiffness_name_it() {
    for center in ["[0.5, 0, 0]", "[0.3, 0.4, 0]"] {
        let text = format!(
            "gravity = [0, 0, -9.81]\n\
             bodies = [{{ kind = \"rigid\", name = \"rod\", center = {center}, mass = 2, inertia = [0.2, 0.2, 0.2] }}]\n\
             joints = [{{ kind = \"spherical\", name = \"h\", a = {{ body = \"rod\", at = [0, 0, 0] }} }}]\n\
             analysis = {{ kind = \"modes\", count = 3, about = \"equilibrium\" }}\n"
        );
        let Failed { reason, advice, .. } = failed_at_once(&Model::parse(&text).unwrap());
        assert!(reason.contains("unsupported") || reason.contains("hardly any stiffness"), "{reason}");
        assert!(advice.contains("support the motion"), "{advice}");
    }
}

/// Coupler (√2.5) and rocker (√3.25) are in line when the joint (-sin φ, cos φ) is √2.5 + √3.25 from the pivot (2.5, 0).
#[test]
fn dead_point_fails_at_its_instant() {
    let Failed { time, at, advice, last, .. } = failed(&model("dead_point"));
    let reach = 2.5_f64.sqrt() + 3.25_f64.sqrt();
    // Squared distance 1 + 6.25 + 5 sin φ, φ = t².
    let dead = ((reach * reach - 7.25) / 5.0).asin().sqrt();
    assert!((time - dead).abs() < 1e-3 && last <= dead && last > dead - 0.01, "{time} for {dead}, {last}");
    assert!(at.starts_with("joint `") || at.starts_with("body `"), "{at}");
    assert!(advice.contains("dead point"), "{advice}");
}

#[test]
fn step_below_the_minimum_is_reported() {
    let Failed { time, reason, at, advice, last } = failed(&model("step_below_minimum"));
    assert!((time - 0.5).abs() < 1e-6 && (last - 0.5).abs() < 1e-6, "{time}, {last}");
    assert!(reason.starts_with("the step is below the smallest permitted"), "{reason}");
    assert_eq!(at, "body `ball`, its centre along x");
    assert!(advice.contains("`step.tolerance`"), "{advice}");
}

#[test]
fn formulas_that_become_infinite_fail() {
    let Failed { time, reason, at, advice, last } = failed(&model("not_a_number"));
    assert!((time - 1.0).abs() < 0.01 && last == 0.99, "{time}, {last}");
    assert!(reason.starts_with("the value of `loads[0].time` became -inf: "), "{reason}");
    assert!(at == "`loads[0].time`" && advice.contains("finite at all times"), "{at}; {advice}");
}

/// A drive with an infinite rate at the start, and an external force that becomes NaN.
#[test]
fn rates_and_external_forces_that_become_nan_fail() {
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/numerics/dead_point.toml"),
    );
    let infinite_rate = Model::parse(&text.unwrap().replace("t^2", "sqrt(t)")).unwrap();
    let mut series = Series::new();
    let summary = simulate(&infinite_rate, &mut series).unwrap();
    let Outcome::Failed { reason, at, .. } = summary.outcome else { panic!("{:?}", summary.outcome) };
    assert!(reason.starts_with("the rate of `joints[0].drive.time` became inf"), "{reason}");
    assert_eq!(at, "`joints[0].drive.time`");

    let mut forced = model("not_a_number");
    let ancf::model::Load::Force(force) = forced.loads.remove(0) else { panic!("the load is a force") };
    forced.loads.push(ancf::model::Load::external(force.on, "field"));
    let field = |t: f64, _: [f64; 3], _: [f64; 3]| if t < 1.0 { [1.0, 0.0, 0.0] } else { [f64::NAN; 3] };
    assert!(forced.supply_force("field", ForceFunction::new(field)));
    let Failed { time, at, .. } = failed(&forced);
    assert!((time - 1.0).abs() < 0.01 && at == "`loads[0]`", "{time}, {at}");
}

#[test]
fn redundant_joints_are_listed() {
    let (summary, _) = run(&model("redundant"));
    assert!(summary.outcome.is_finished());
    assert_eq!(summary.redundant.len(), 5);
    assert!(
        summary
            .redundant
            .iter()
            .all(|one| one.starts_with("joint `lower`: ") && one.ends_with("joint `upper`"))
    );
}

/// Contradictions between nonlinear constraints of rotations are found when the motion starts.
#[test]
fn contradicting_joints_are_named() {
    let Failed { time, reason, at, advice, last } = failed(&model("contradiction"));
    assert!(time < 0.01 && last == 0.0, "{time}, {last}");
    assert!(reason.starts_with("joints contradict each other: "), "{reason}");
    assert!(at.contains("joint `motor`: drive, follows from joints `wall` and `motor`"), "{at}");
    assert!(advice.contains("leave one of them out"), "{advice}");
}

/// The column reaches Euler's load at t = 10 and leaves the straight shape within about 3 s; the run continues.
#[test]
fn buckling_is_a_warning() {
    let (summary, series) = run(&model("buckling"));
    assert!(summary.outcome.is_finished());
    let [damping, warning] = summary.warnings.as_slice() else { panic!("{:?}", summary.warnings) };
    assert!(damping.starts_with("the numerical damping of the scheme has removed"), "{damping}");
    let since: f64 =
        warning.strip_prefix("from about t = ").unwrap().split(' ').next().unwrap().parse().unwrap();
    // Stability is checked every second.
    assert!((10.0..11.5).contains(&since), "{warning}");
    assert!(warning.contains("2 directions") && warning.contains("`column`, node 8 (s = 2)"), "{warning}");
    assert!(series.column("top.x").unwrap().last().unwrap() > &0.5, "the column has buckled");
    // No warning below Euler's load.
    let mut short = model("buckling");
    short.analysis.dynamics_mut().unwrap().duration = 9.5;
    assert!(run(&short).0.warnings.is_empty());
}

/// Buckling with steps that cannot resolve it.
#[test]
fn buckling_is_the_reason_of_a_failure() {
    let mut column = model("buckling");
    let dynamics = column.analysis.dynamics_mut().unwrap();
    (dynamics.step, dynamics.max_halvings, dynamics.max_iterations) = (Step::Fixed(0.1), 0, 5);
    let Failed { time, reason, at, advice, .. } = failed(&column);
    assert!(time > 10.0, "{time}");
    assert!(reason.starts_with("the last state is unstable in "), "{reason}");
    assert!(at.starts_with("body `column`, node ") && advice.contains("\"buckling\""), "{at}; {advice}");
}

/// Statics fails at a limit point and recommends the analysis `path`.
#[test]
fn limit_point_of_statics_recommends_a_path() {
    let mut frame = files::model("lees_frame");
    frame.analysis = Analysis::Statics(Statics { load: 2.5, max_iterations: 12, ..Statics::default() });
    let (summary, _) = run(&frame);
    if let Outcome::Failed { time, at, advice, .. } = summary.outcome {
        assert!(time > 1.8 && at.starts_with("body `"), "{time}, {at}");
        assert!(advice.contains("\"path\""), "{advice}");
    }
}
