//! Energy balance as a guard: motions in which the scheme makes or loses energy are halved, rejected or reported.

use std::f64::consts::TAU;

use ancf::record::Series;
use ancf::{Model, Outcome, Summary, simulate};

use crate::common::models::parse;
use crate::common::solutions::Run;

fn run(model: &Model) -> (Summary, Series) {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    (summary, series)
}

fn largest(series: &Series, columns: &[&str]) -> f64 {
    let columns: Vec<&[f64]> = columns.iter().map(|name| series.column(name).unwrap()).collect();
    (0..columns[0].len()).map(|k| columns.iter().map(|column| column[k]).sum::<f64>()).fold(0.0, f64::max)
}

/// Free body that spins about its axis of largest inertia, which is stable, with a number of steps per turn.
fn spinning(radius: f64, steps: f64, turns: f64, keys: &str) -> Model {
    let rate = 8.0;
    let step = TAU / rate / steps;
    parse(&format!(
        "bodies = [{{ kind = \"rigid\", name = \"top\", center = [0, 0, 0], mass = 2, inertia = [0.5, 0.9, 1.2], \
         motion = {{ spin = [0.02, 0.02, {rate}] }} }}]\n\
         [analysis]\nkind = \"dynamics\"\nduration = {}\nstep = {step}\nscheme = {{ spectral_radius = {radius} }}\n{keys}\n",
        turns * steps * step
    ))
}

/// Rotations beyond 0.7 (1 − ρ) rad per step are linearly unstable. The energy stays within the guard, and the run has a warning with
/// the body and the largest step.
#[test]
fn unresolved_rotations_are_reported() {
    for (radius, steps) in [(0.8, 31.0), (0.9, 63.0), (0.9, 24.0)] {
        let (summary, series) = run(&spinning(radius, steps, 60.0, ""));
        let before = series.column("kinetic").unwrap()[0];
        assert!(largest(&series, &["kinetic"]) < 1.12 * before, "ρ = {radius}, {steps} steps a turn");
        if summary.outcome.is_finished() {
            let warnings = summary.warnings.join(" ");
            assert!(warnings.contains("`top` rotates by"), "ρ = {radius}, {steps} steps a turn: {warnings}");
            let (_, rest) = warnings.split_once("a step of at most ").unwrap();
            let found: f64 = rest.split_once(',').unwrap().0.parse().unwrap();
            let limit = 0.7 * (1.0 - radius) / 8.0;
            assert!((found / limit - 1.0).abs() < 0.02, "{warnings}, expected {limit}");
        }
    }
    // Without numerical damping there is no stable step.
    let (summary, _) = run(&spinning(1.0, 63.0, 60.0, ""));
    let warnings = summary.warnings.join(" ");
    assert!(warnings.contains("all rotations are unstable") || !summary.outcome.is_finished(), "{warnings}");
}

/// Resolved rotations make no energy. A loss by numerical damping above 5 % has a warning.
#[test]
fn resolved_rotations_make_no_energy() {
    for (radius, steps) in [(0.8, 63.0), (0.9, 128.0), (0.6, 31.0), (0.5, 20.0)] {
        let (summary, series) = run(&spinning(radius, steps, 60.0, ""));
        let warnings = summary.warnings.join(" ");
        assert!(
            summary.outcome.is_finished() && !warnings.contains("rotates by"),
            "{radius}, {steps}: {summary:?}"
        );
        let kinetic = series.column("kinetic").unwrap();
        assert!(kinetic.iter().all(|now| now / kinetic[0] < 1.001), "{radius}, {steps}");
        let lost = 1.0 - kinetic.last().unwrap() / kinetic[0];
        assert!(
            (lost > 0.05) == warnings.contains("numerical damping"),
            "{radius}, {steps}: {lost}: {warnings}"
        );
    }
}

/// A spinning shaft is as unstable as a rigid body.
#[test]
fn unresolved_rotations_of_sections_are_reported() {
    let model = parse(
        "materials.m = { density = 1200, young = 1e9 }\nsections.s = { kind = \"circle\", diameter = 0.1 }\n\
         bodies = [{ kind = \"beam\", formulation = \"linked\", name = \"shaft\", from = [0, 0, 0], to = [0.4, 0, 0], elements = 2, \
         section = \"s\", material = \"m\", motion = { spin = [50, 0, 0] } }]\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1.2\nstep = 5e-3\nscheme = { spectral_radius = 0.9 }\n",
    );
    let (summary, _) = run(&model);
    let text = format!("{summary:?}");
    assert!(text.contains("`shaft`"), "{text}");
}

/// With halvings forbidden, a motion that makes energy ends with a failure that names the body.
#[test]
fn made_energy_ends_the_run() {
    let (summary, series) = run(&spinning(0.9, 24.0, 60.0, "max_halvings = 0"));
    let Outcome::Failed { time, reason, at, advice } = &summary.outcome else { panic!("{summary:?}") };
    assert!(
        reason.contains("makes energy") && at.contains("`top`") && advice.contains("step"),
        "{summary:?}"
    );
    assert!(*time > 0.0 && largest(&series, &["kinetic"]) < 1.06 * series.column("kinetic").unwrap()[0]);
    // The share is a setting.
    let (summary, _) =
        run(&spinning(0.9, 24.0, 60.0, "max_halvings = 0\nenergy_guard = { gain = 1e9, loss = 1e9 }"));
    assert!(!format!("{summary:?}").contains("makes energy"), "{summary:?}");
}

/// Cable that is thrown along itself, held at one end: nothing supplies energy.
#[test]
fn unresolved_waves_make_no_energy() {
    let model = parse(
        "materials.s = { density = 1000, young = 2e9 }\nsections.c = { kind = \"circle\", diameter = 0.008 }\n\
         bodies = [{ kind = \"cable\", name = \"c\", from = [0, 0, 0], to = [1.5, 0, 0], elements = 6, section = \"c\", material = \"s\", \
         motion = { velocity = [12, 0, 0] } }]\n\
         joints = [{ kind = \"spherical\", name = \"j\", a = { body = \"c\", at = \"start\" } }]\n\
         [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 1e-3\nscheme = { spectral_radius = 0.9 }\n",
    );
    let (_, series) = run(&model);
    let start = series.column("kinetic").unwrap()[0];
    assert!(largest(&series, &["kinetic", "strain"]) < 1.12 * start);
}

fn oscillator(scheme: &str) -> Model {
    parse(&format!(
        "bodies = [{{ kind = \"mass\", name = \"m\", center = [1, 0, 0], mass = 2, motion = {{ velocity = [1, 0, 0] }} }}]\n\
         joints = [{{ kind = \"spring\", name = \"s\", a = {{ body = \"m\", at = \"center\" }}, b = {{ point = [0, 0, 0] }}, \
         stiffness = {} }}]\n[analysis]\nkind = \"dynamics\"\nduration = 6\nstep = 1e-2\n{scheme}\n",
        2.0 * TAU * TAU
    ))
}

/// 100 steps a period, 6 periods: ADAMS removes 38 % of the energy, the default scheme 0.02 %.
#[test]
fn lost_energy_is_reported() {
    let adams = Run::of(&oscillator("scheme = \"adams\""));
    assert!(
        adams.summary.warnings.iter().any(|text| text.contains("numerical damping")),
        "{:?}",
        adams.summary
    );
    let accepted = Run::of(&oscillator("scheme = \"adams\"\nenergy_guard = { loss = 1 }"));
    assert!(accepted.summary.warnings.is_empty(), "{:?}", accepted.summary);
    let default = Run::of(&oscillator(""));
    assert!(default.summary.warnings.is_empty(), "{:?}", default.summary);
    assert!(default.last("balance").abs() < 1e-3, "{}", default.last("balance"));
}
