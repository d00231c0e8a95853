//! Error-controlled steps land on pulses of functions of time, however narrow. Steps of both kinds end at jumps of formulas.

use std::f64::consts::PI;

use ancf::mechanics::functions::{ExternalFunction, FunctionValue};
use ancf::record::Series;
use ancf::{Model, Summary, simulate};

use crate::common::assertions::assert_relative;

fn run(text: &str) -> (Summary, Series) {
    let (model, mut series) = (Model::parse(text).unwrap(), Series::new());
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (summary, series)
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// A free mass of 2 under a force of a function of time along y.
fn pushed(force: f64, time: &str, duration: f64, step: &str) -> String {
    format!(
        r#"
        bodies = [{{ kind = "mass", name = "m", center = [0.3, 0, 0], mass = 2 }}]
        loads = [{{ kind = "force", on = {{ body = "m", at = "center" }}, force = [0, {force}, 0], time = {time} }}]
        probes = [{{ name = "m", on = {{ body = "m", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = {duration}, step = {step}, scheme = {{ spectral_radius = 0.7 }} }}
        "#
    )
}

fn formula(text: &str) -> String {
    format!(r#"{{ kind = "expression", text = "{text}" }}"#)
}

/// Asserts velocity and position after impulses at given times.
fn assert_impulses(force: f64, time: &str, duration: f64, tolerance: f64, impulses: &[(f64, f64)]) {
    let (summary, series) = run(&pushed(force, time, duration, &format!("{{ tolerance = {tolerance} }}")));
    let v: f64 = impulses.iter().map(|(_, impulse)| force * impulse / 2.0).sum();
    let y: f64 = impulses.iter().map(|(at, impulse)| force * impulse / 2.0 * (duration - at)).sum();
    // The tolerance is that of the position, relative to a length of 1. Its bound is proven for vibrations only.
    let (vy, my) = (last(&series, "m.vy"), last(&series, "m.y"));
    assert!((my - y).abs() < 3.0 * tolerance, "{time}: y = {my} not {y}, {} steps", summary.steps);
    assert!((vy - v).abs() * duration < 5.0 * tolerance, "{time}: v = {vy} not {v}, {} steps", summary.steps);
}

/// A pulse of each kind: the impulse and its effect are exact within the tolerance.
#[test]
fn pulses_of_all_kinds_give_their_impulses() {
    let width: f64 = 2e-3;
    let gauss = width * PI.sqrt();
    let kinds = [
        (formula("exp(-((t - 0.8)/2e-3)^2)"), 0.8, gauss),
        (formula("1/cosh((t - 0.61)/2e-3)"), 0.61, PI * width),
        (formula("if(t < 0.3, 0, if(t < 0.302, 1, 0))"), 0.301, width),
        (formula("(t > 1.1)*(t < 1.102)"), 1.101, width),
        (formula("max(0, 1 - abs(t - 0.7)/2e-3)"), 0.7, width),
        (formula("0.5*(sign(t - 0.4) - sign(t - 0.402))"), 0.401, width),
        (formula("if(abs(t - 0.9) < 2e-3, cos(pi*(t - 0.9)/4e-3), 0)"), 0.9, 4.0 / PI * width),
        (formula("tanh((t - 0.5)/2e-3) - tanh((t - 0.502)/2e-3)"), 0.501, 2.0 * width),
        (r#"{ kind = "step", at = 0.7, until = 0.702 }"#.into(), 0.701, width),
        (r#"{ kind = "table", times = [0.7, 0.702, 0.704], values = [0, 1, 0] }"#.into(), 0.702, width),
    ];
    for (time, at, impulse) in kinds {
        assert_impulses(120.0, &time, 1.3, 1e-3, &[(at, impulse)]);
    }
}

/// A pulse near the start, near the end, several pulses, and one of a hundred-thousandth of the duration.
#[test]
fn pulses_at_any_time_are_found() {
    let root = PI.sqrt();
    assert_impulses(90.0, &formula("exp(-((t - 0.004)/1e-3)^2)"), 2.0, 1e-3, &[(0.004, 1e-3 * root)]);
    assert_impulses(90.0, &formula("exp(-((t - 1.996)/1e-3)^2)"), 2.0, 1e-3, &[(1.996, 1e-3 * root)]);
    let several =
        formula("exp(-((t - 0.37)/1e-3)^2) - 2*exp(-((t - 1.1)/2e-3)^2) + exp(-((t - 1.13)/5e-4)^2)");
    let impulses = [(0.37, 1e-3 * root), (1.1, -4e-3 * root), (1.13, 5e-4 * root)];
    assert_impulses(90.0, &several, 2.0, 1e-3, &impulses);
    assert_impulses(2e4, &formula("exp(-((t - 0.7123)/1e-5)^2)"), 1.0, 1e-3, &[(0.7123, 1e-5 * root)]);
    assert_impulses(2e7, &formula("exp(-((t - 0.7123)/1e-8)^2)"), 1.0, 1e-2, &[(0.7123, 1e-8 * root)]);
    // A formula whose rates overflow far from the pulse.
    assert_impulses(900.0, &formula("1/cosh((t - 0.7)/1e-4)"), 1.5, 1e-3, &[(0.7, PI * 1e-4)]);
    // Beside a slow variation.
    let slow = formula("0.1*sin(pi*t) + exp(-((t - 0.7)/1e-3)^2)");
    let (_, series) = run(&pushed(90.0, &slow, 2.0, "{ tolerance = 1e-4 }"));
    let v = 45.0 * 1e-3 * root;
    assert!((last(&series, "m.vy") - v).abs() < 3e-4, "{} not {v}", last(&series, "m.vy"));
}

/// A sine whose period divides the steps: ∫ sin = 0 over whole periods, the displacement is F t/(m ω).
#[test]
fn fast_vibrations_are_not_aliased() {
    for time in [r#"{ kind = "sine", frequency = 100 }"#.to_owned(), formula("sin(200*pi*t)")] {
        let step = "{ tolerance = 1e-3, initial = 0.1 }";
        let (_, series) = run(&pushed(400.0, &time, 1.0, step));
        let y = 200.0 / (200.0 * PI);
        assert!((last(&series, "m.y") - y).abs() < 1e-3, "{time}: {} not {y}", last(&series, "m.y"));
    }
}

/// Steps end at jumps of formulas: constant accelerations between them are integrated exactly.
#[test]
fn jumps_of_formulas_end_steps() {
    let time = formula("if(t < 3.33, 0, if(t < 4.34, 1, -0.5))");
    let (summary, series) = run(&pushed(120.0, &time, 10.0, "{ tolerance = 1e-7 }"));
    let v = 60.0 * (1.01 - 0.5 * (10.0 - 4.34));
    let y = 60.0 * (0.5 * 1.01 * 1.01 + 1.01 * (10.0 - 4.34) - 0.25 * (10.0_f64 - 4.34).powi(2));
    assert!((last(&series, "m.vy") - v).abs() < 1e-9 && (last(&series, "m.y") - y).abs() < 1e-9);
    assert!(summary.steps < 30, "{}", summary.steps);
}

/// Steps of a fixed size end at jumps and kinks of formulas: the motion is that by a table, without a warning, to rounding.
#[test]
fn fixed_steps_end_at_jumps_of_formulas() {
    let jump = [
        formula("if(t < 0.3333, 1, -2)*(t >= 0.3)"),
        r#"{ kind = "table", times = [0.3, 0.3, 0.3333, 0.3333, 1], values = [0, 1, 1, -2, -2] }"#.to_owned(),
    ];
    let ramp = [
        formula("min(max((t - 0.123)/1e-3, 0), 1)"),
        r#"{ kind = "ramp", start = 0.123, end = 0.124 }"#.to_owned(),
    ];
    for scheme in ["{ spectral_radius = 0.7 }", r#""energy""#] {
        for times in [&jump, &ramp] {
            let [ours, reference] = times.each_ref().map(|time| {
                let text = pushed(120.0, time, 1.0, "0.01").replace("{ spectral_radius = 0.7 }", scheme);
                let (summary, series) = run(&text);
                assert_eq!(summary.warnings, Vec::<String>::new(), "{time}");
                ["m.vy", "m.y", "m.ay", "work"].map(|name| last(&series, name))
            });
            for (own, reference) in ours.into_iter().zip(reference) {
                assert_relative(&times[0], own, reference, 1e-11);
            }
        }
    }
}

/// A drive by a formula that jumps is rejected in steps of any kind.
#[test]
fn jumps_of_drives_by_formulas_are_rejected() {
    for step in ["0.01", "{ tolerance = 1e-4 }"] {
        for (text, jumps) in
            [("if(t < 0.3, 0, 0.1)", true), ("if(t < 0.3, t/3, 0.1)", false), ("if(t < 3, 0, 1)", false)]
        {
            let text = format!(
                r#"
                bodies = [{{ kind = "rigid", name = "r", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1] }}]
                joints = [{{ kind = "revolute", name = "j", a = {{ body = "r", at = "center" }}, axis = [0, 0, 1], drive = {{ angle = 1, time = {} }} }}]
                analysis = {{ kind = "dynamics", duration = 1, step = {step} }}
                "#,
                formula(text)
            );
            let errors = Model::parse(&text).err().map(|errors| errors.to_string()).unwrap_or_default();
            assert_eq!(errors.contains("a function that jumps"), jumps, "{text}: {errors}");
            assert_eq!(errors.is_empty(), !jumps, "{text}: {errors}");
        }
    }
}

/// Negligible pulses do not cost steps: 1e-9 of the tolerance.
#[test]
fn pulses_without_effect_are_passed() {
    let time = formula("exp(-((t - 0.8)/2e-3)^2)");
    let (summary, _) = run(&pushed(1e-9, &time, 1.3, "{ tolerance = 1e-3 }"));
    assert!(summary.steps < 20, "{}", summary.steps);
}

/// A drive that moves out and back within 2 ms is followed.
#[test]
fn pulses_of_drives_are_followed() {
    let text = r#"
        bodies = [{ kind = "mass", name = "m", center = [1, 0, 0], mass = 2 }]
        joints = [{ kind = "distance", name = "d", a = { body = "m", at = "center" }, b = { point = [0, 0, 0] }, change = 0.2, time = { kind = "expression", text = "exp(-((t - 0.63)/2e-3)^2)" } }]
        probes = [{ name = "m", on = { body = "m", at = "center" } }]
        analysis = { kind = "dynamics", duration = 1, step = { tolerance = 1e-3 }, scheme = { spectral_radius = 0.7 } }
    "#;
    let (_, series) = run(text);
    let largest = series.column("m.x").unwrap().iter().copied().fold(0.0, f64::max);
    assert!((largest - 1.2).abs() < 5e-3, "{largest}");
    assert!((last(&series, "m.x") - 1.0).abs() < 1e-6, "{}", last(&series, "m.x"));
    assert!(series.column("m.y").unwrap().iter().all(|y| y.abs() < 1e-9));
}

/// Functions of a program are sampled at a thousandth of the duration.
#[test]
fn pulses_of_external_functions_are_found() {
    let text = pushed(50.0, r#"{ kind = "external", name = "push" }"#, 2.0, "{ tolerance = 1e-3 }");
    let mut model = Model::parse(&text).unwrap();
    let push = ExternalFunction::new(|t| {
        let x = (t - 1.2345) / 5e-3;
        FunctionValue { value: (-x * x).exp(), rate: -2.0 * x / 5e-3 * (-x * x).exp(), acceleration: 0.0 }
    });
    assert!(model.supply("push", push));
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished());
    let v = 25.0 * 5e-3 * PI.sqrt();
    assert!((last(&series, "m.vy") - v).abs() < 2e-3, "{} not {v}", last(&series, "m.vy"));
}

/// Steps of a fixed size that pass over a pulse, or do not resolve a vibration, are reported by the check and by the run.
#[test]
fn fixed_steps_that_miss_a_pulse_are_reported() {
    let warnings = |time: &str, step: &str| {
        let text = pushed(3.0, time, 2.0, step);
        let found = Model::parse(&text).unwrap().diagnose().unwrap().warnings;
        let (summary, _) = run(&text);
        assert_eq!(found, summary.warnings[..found.len()]);
        found
    };
    let pulse = formula("exp(-((t - 0.7712)/1e-4)^2)");
    let found = warnings(&pulse, "1e-2");
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].contains("`loads[0].time`") && found[0].contains("t = 0.77"), "{found:?}");
    assert_eq!(warnings(&formula("sin(400*t)"), "1e-2").len(), 1);
    assert_eq!(warnings(r#"{ kind = "sine", frequency = 100 }"#, "1e-2").len(), 1);
    for time in [&pulse, &formula("sin(t) + t^2"), r#"{ kind = "ramp", start = 0.50001, end = 0.50002 }"#] {
        assert_eq!(warnings(time, "5e-5"), Vec::<String>::new(), "{time}");
    }
    assert!(warnings(&formula("sin(2*pi*t)"), "2e-2").is_empty());
    for time in ["if(t < 0.5, t, 1 - t)", "if(t < 0.505, 0, 1)", "tanh((t - 0.505)/4e-3)"] {
        assert!(!warnings(&formula(time), "1e-2").iter().any(|warning| warning.contains("time")), "{time}");
    }
    assert!(warnings(&pulse, "{ tolerance = 1e-3 }").is_empty());
}
