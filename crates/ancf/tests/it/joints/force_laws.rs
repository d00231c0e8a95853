//! Force laws of joints by formulas, against closed forms.

use std::f64::consts::PI;

use ancf::Model;
use ancf::mechanics::laws::{LawNumber, LawState, LawValue, UserForceLaw};

use crate::common::models::jointed_body::STATICS;
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Mass of 2 on a straight guide, with the keys of the joint, its initial velocity, the duration and the keys of the analysis.
fn slider(keys: &str, velocity: f64, duration: f64, analysis: &str) -> String {
    format!(
        r#"
bodies = [{{ kind = "rigid", name = "block", center = [0, 0, 0], mass = 2, inertia = [1, 1, 1], motion = {{ velocity = [{velocity}, 0, 0] }} }}]
[[joints]]
kind = "prismatic"
name = "guide"
a = {{ body = "block", at = "center" }}
axis = [1, 0, 0]
{keys}
[analysis]
kind = "dynamics"
duration = {duration}
step = 1e-3
{analysis}
"#
    )
}

/// Complete elliptic integral K(k) by the arithmetic-geometric mean.
fn elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    for _ in 0..20 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    0.5 * PI / a
}

/// x'' + 4 x + 30 x³ = 0 with the amplitude A: period 4 K(k)/ω, ω² = 4 + 30 A², k² = 30 A²/(2 ω²).
const AMPLITUDE: f64 = 0.7;

fn duffing_period() -> f64 {
    let hardening = 30.0 * AMPLITUDE * AMPLITUDE;
    let omega = (4.0 + hardening).sqrt();
    4.0 * elliptic((0.5 * hardening).sqrt() / omega) / omega
}

/// Speed in the middle for the amplitude.
fn duffing_speed() -> f64 {
    (4.0 * AMPLITUDE.powi(2) + 15.0 * AMPLITUDE.powi(4)).sqrt()
}

const DUFFING: &str = "force = { kind = \"expression\", text = \"-2*(4*x + 30*x^3)\" }";

#[test]
fn duffing_oscillator_has_the_period_of_the_elliptic_integral() {
    let (period, speed) = (duffing_period(), duffing_speed());
    for scheme in
        ["scheme = \"average_acceleration\"", "scheme = { spectral_radius = 0.8 }", "scheme = \"energy\""]
    {
        let run = Run::of(&parse(&slider(DUFFING, speed, period, scheme)));
        let end = run.last("guide.displacement");
        assert!(end.abs() < 3e-5 * AMPLITUDE, "{scheme}: {end}");
        let largest = run.largest("guide.displacement");
        assert!((largest / AMPLITUDE - 1.0).abs() < 2e-5, "{scheme}: {largest}");
        let energy = speed * speed;
        let strain = run.largest("strain");
        assert!((strain / energy - 1.0).abs() < 1e-5, "{scheme}: {strain} for {energy}");
        let bound = if scheme.contains("energy") { 1e-9 } else { 2e-3 * energy };
        assert!(run.largest("balance") < bound, "{scheme}: balance {}", run.largest("balance"));
        assert_eq!(run.largest("work"), 0.0);
    }
}

/// The error of the average-acceleration method is of second order in the step.
#[test]
fn convergence_is_of_second_order() {
    let end = |step: &str| {
        let text = slider(DUFFING, duffing_speed(), 1.0, "scheme = \"average_acceleration\"");
        Run::of(&parse(&text.replace("step = 1e-3", step))).last("guide.displacement")
    };
    let [coarse, middle, fine] = ["step = 4e-3", "step = 2e-3", "step = 1e-3"].map(end);
    let ratio = (coarse - middle) / (middle - fine);
    assert!((ratio - 4.0).abs() < 0.1, "{ratio}");
}

/// The same oscillator as a spring between points, with the length in the formula, in other units of the formula and of the solver.
#[test]
fn tension_of_a_spring_has_the_same_period_in_all_units() {
    let formulas = [
        ("2*(4*x + 30*x^3)", ""),
        ("2*(4*(length - 3) + 30*(length - 3)^3)", ""),
        // Millimetres, milliseconds and kilonewtons.
        ("1e-3*2*(4*x/1000 + 30*(x/1000)^3) + 0*t", ", units = { length = 1000, time = 1000, force = 1e-3 }"),
    ];
    for (text, units) in formulas {
        for scales in ["", "scales = { kind = \"given\", length = 3, force = 0.7, time = 0.13 }\n"] {
            let run = Run::of(&parse(&format!(
                r#"
{scales}
bodies = [{{ kind = "mass", name = "ball", center = [{start}, 0, 0], mass = 2 }}]
joints = [{{ kind = "spring", name = "spring", a = {{ body = "ball", at = "center" }}, b = {{ point = [0, 0, 0] }}, length = 3, tension = {{ kind = "expression", text = "{text}"{units} }} }}]
analysis = {{ kind = "dynamics", duration = {duration}, step = 1e-3, scheme = "average_acceleration" }}
"#,
                start = 3.0 + AMPLITUDE,
                duration = duffing_period(),
            )));
            let (end, speed) = (run.last("spring.length") - 3.0, run.last("spring.speed"));
            assert!((end - AMPLITUDE).abs() < 1e-4 && speed.abs() < 5e-3, "{text}{units}: {end}, {speed}");
            let force = run.column("spring.fx")[0];
            let expected = -2.0 * (4.0 * AMPLITUDE + 30.0 * AMPLITUDE.powi(3));
            assert!((force / expected - 1.0).abs() < 1e-12, "{text}: {force} for {expected}");
        }
    }
}

/// θ'' − (1 − θ²) θ' + θ = 0: limit cycle of the amplitude 2.008 620 and the period 6.663 287.
///
/// Source: Amore et al. (2018), high-order analysis of the limit cycle of the van der Pol oscillator.
#[test]
fn van_der_pol_oscillator_reaches_its_limit_cycle() {
    let text = |moment: &str| {
        format!(
            r#"
bodies = [{{ kind = "rigid", name = "wheel", center = [0, 0, 0], mass = 1, inertia = [1, 1, 0.5], motion = {{ spin = [0, 0, 0.3] }} }}]
joints = [{{ kind = "revolute", name = "shaft", a = {{ body = "wheel", at = "center" }}, axis = [0, 0, 1], moment = {{ kind = "expression", text = "{moment}" }} }}]
analysis = {{ kind = "dynamics", duration = 40, step = 2e-3, scheme = {{ spectral_radius = 0.8 }} }}
"#
        )
    };
    for moment in ["0.5*((1 - x^2)*v - x)", "((1 - angle^2)*rate - angle)/2"] {
        let run = Run::of(&parse(&text(moment)));
        let (t, angle) = (run.column("t"), run.column("shaft.angle"));
        let late = t.iter().position(|t| *t > 25.0).unwrap();
        let largest = angle[late..].iter().fold(0.0_f64, |a, x| a.max(x.abs()));
        assert!((largest - 2.008_620).abs() < 2e-5, "{largest}");
        let crossings: Vec<f64> = (late..t.len())
            .filter(|&k| angle[k - 1] < 0.0 && angle[k] >= 0.0)
            .map(|k| t[k] - angle[k] / (angle[k] - angle[k - 1]) * (t[k] - t[k - 1]))
            .collect();
        let period = crossings[1] - crossings[0];
        assert!((period - 6.663_287).abs() < 1e-4, "{period}");
        assert!(run.largest("balance") < 1e-3, "{}", run.largest("balance"));
    }
}

/// Static equilibrium k x + k₃ x³ = F, and ω² = (k + 3 k₃ x²)/m about it.
#[test]
fn statics_and_modes_use_the_derivatives_of_the_law() {
    let text = |law: &str, push: f64, analysis: &str| {
        format!(
            r#"
bodies = [{{ kind = "mass", name = "ball", center = [1, 0, 0], mass = 2 }}]
joints = [
  {{ kind = "point_on_line", name = "wire", a = {{ body = "ball", at = "center" }}, axis = [1, 0, 0] }},
  {{ kind = "spring", name = "spring", a = {{ body = "ball", at = "center" }}, b = {{ point = [0, 0, 0] }}, tension = {{ kind = "expression", text = "{law}" }} }},
]
loads = [{{ kind = "force", on = {{ body = "ball", at = "center" }}, force = [{push}, 0, 0] }}]
{analysis}"#
        )
    };
    let (law, at) = ("100*x + 4e4*x^3", 0.1);
    let push = 100.0 * at + 4e4 * at * at * at;
    let length = Run::of(&parse(&text(law, push, STATICS))).last("spring.length");
    assert!((length - 1.1).abs() < 1e-10, "{length}");
    let modes = "analysis = { kind = \"modes\", count = 1, about = \"equilibrium\" }\n";
    let found = Run::of(&parse(&text(law, push, modes))).column("squared")[0];
    let expected = (100.0 + 3.0 * 4e4 * at * at) / 2.0;
    assert!((found / expected - 1.0).abs() < 1e-8, "{found} for {expected}");
    // A preload is applied with the load factor, and damping has no effect at rest.
    let preloaded = Run::of(&parse(&text("100*(x + 0.02) + 3*v", 0.0, STATICS))).last("spring.length");
    assert!((preloaded - 0.98).abs() < 1e-10, "{preloaded}");
}

/// A force by time and an input is supplied work; the damping dissipates.
#[test]
fn time_and_inputs_are_variables() {
    let law = "force = { kind = \"expression\", text = \"push*sin(3*t) - 8*x - 0.4*v\" }";
    let input = "inputs = [{ name = \"push\", value = 1.5 }]\n";
    let text = input.to_owned() + &slider(law, 0.0, 4.0, "scheme = \"average_acceleration\"");
    let run = Run::of(&parse(&text));
    // m x'' + c x' + k x = F sin Ωt from rest.
    let (m, c, k, force, omega) = (2.0, 0.4, 8.0, 1.5, 3.0);
    let (stiff, damped): (f64, f64) = (k - m * omega * omega, c * omega);
    let square = stiff * stiff + damped * damped;
    let (of_sin, of_cos) = (force * stiff / square, -force * damped / square);
    let decay: f64 = c / (2.0 * m);
    let free = (k / m - decay * decay).sqrt();
    let exact = |t: f64| {
        let (sin, cos) = (omega * t).sin_cos();
        let (x0, v0) = (-of_cos, -of_sin * omega);
        let (s, c) = (free * t).sin_cos();
        of_sin * sin + of_cos * cos + (-decay * t).exp() * (x0 * c + (v0 + decay * x0) / free * s)
    };
    for (t, x) in run.column("t").iter().zip(run.column("guide.displacement")) {
        assert!((x - exact(*t)).abs() < 1e-5, "{x} at {t}");
    }
    assert!(run.largest("work") > 0.1 && run.largest("balance") < 1e-4, "{}", run.largest("balance"));
}

/// Laws of a program: by dual numbers and by stated derivatives, as the formula.
#[test]
fn supplied_laws_equal_the_formula() {
    let run = |law: Option<UserForceLaw>, keys: &str| {
        let mut model: Model = parse(&slider(keys, duffing_speed(), 1.0, "scheme = \"energy\""));
        if let Some(law) = law {
            assert!(model.supply_law("own", law));
            assert!(
                !model.supply_law("other", UserForceLaw::with_derivatives(|_| LawValue::default(), true))
            );
        }
        let run = Run::of(&model);
        (run.last("guide.displacement"), run.largest("balance"), run.summary.iterations)
    };
    let dual = |_t: f64, x: LawNumber, _v: LawNumber| (x * 4.0 + x * x * x * 30.0) * -2.0;
    let stated = |LawState { x, .. }: LawState| LawValue {
        force: -2.0 * (4.0 * x + 30.0 * x.powi(3)),
        by_position: -2.0 * (4.0 + 90.0 * x * x),
        by_rate: 0.0,
    };
    let keys = "force = { kind = \"external\", name = \"own\", autonomous = true }";
    let formula = run(None, DUFFING);
    for law in [UserForceLaw::by_dual_numbers(dual, true), UserForceLaw::with_derivatives(stated, true)] {
        let found = run(Some(law), keys);
        assert!((found.0 - formula.0).abs() < 1e-10 && found.1 < 1e-9 && found.2 == formula.2, "{found:?}");
    }
    let missing = parse(&slider(keys, 0.0, 1.0, "")).check_supplies().unwrap_err().to_string();
    assert!(missing.contains("joints[0].force.name") && missing.contains("force law \"own\""), "{missing}");
}

/// Errors name the character, the variables and the inputs.
#[test]
fn errors_of_formulas_are_reported() {
    let errors = |head: &str, law: &str| {
        let law = format!("force = {{ kind = \"expression\", text = \"{law}\" }}");
        Model::parse(&(head.to_owned() + &slider(&law, 0.0, 1.0, ""))).unwrap_err().to_string()
    };
    let error = errors("", "-4*y");
    assert!(error.contains("character 4") && error.contains("`displacement`, `v`, `speed`"), "{error}");
    let error = errors("", "1/x");
    assert!(error.contains("x = 0, v = 0, t = 0"), "{error}");
    let error = errors("inputs = [{ name = \"v\" }]\n", "-4*v");
    assert!(error.contains("inputs[0].name"), "{error}");
    let error = errors("inputs = [{ name = \"push\" }]\n", "-4*v");
    assert!(error.contains("no force law uses"), "{error}");
    let statics = slider("force = { kind = \"expression\", text = \"-4*x + t\" }", 0.0, 1.0, "");
    let statics = statics.split("[analysis]").next().unwrap().to_owned() + STATICS;
    let error = Model::parse(&statics).unwrap_err().to_string();
    assert!(error.contains("no time"), "{error}");
}
