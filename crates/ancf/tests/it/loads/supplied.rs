//! Functions and forces supplied by a program, against built-in ones.

use std::f64::consts::TAU;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};

use ancf::mechanics::functions::{ExternalFunction, ForceFunction, FunctionValue};
use ancf::model::ModelErrors;
use ancf::record::Series;
use ancf::{Error, Model, Outcome, Scales, simulate};
use nalgebra::Vector3;

use crate::common::models::jointed_body::{DYNAMICS, STATICS, jointed_body};
use crate::common::models::parse;
use crate::common::solutions::{Run, assert_same_columns, distance};

/// Soft cantilever with a probe at its tip.
fn cantilever(elements: usize) -> String {
    format!(
        r#"
gravity = [0, 0, -9.81]
materials.rubber = {{ density = 1100, young = 5e7, damping = {{ strain = 1e-3 }} }}
sections.round = {{ kind = "circle", diameter = 0.03 }}
bodies = [{{ kind = "beam", name = "arm", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, formulation = "linked", section = "round", material = "rubber" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }}]
probes = [{{ name = "tip", on = {{ body = "arm", at = "end" }} }}]
"#
    )
}

/// Scales: units of the user, given ones that are no powers of two, automatic ones.
const SCALES: [&str; 3] = [
    "",
    "scales = { kind = \"given\", length = 3, force = 0.7, time = 0.13 }\n",
    "scales = { kind = \"auto\" }\n",
];

fn sine(frequency: f64, phase: f64) -> ExternalFunction {
    ExternalFunction::new(move |t| {
        let omega = TAU * frequency;
        let (sin, cos) = (omega * t + phase).sin_cos();
        FunctionValue { value: sin, rate: omega * cos, acceleration: -omega * omega * sin }
    })
}

fn supplied(mut model: Model, name: &str, function: &ExternalFunction) -> Model {
    assert!(model.supply(name, function.clone()));
    model
}

fn forced(mut model: Model, name: &str, function: &ForceFunction) -> Model {
    assert!(model.supply_force(name, function.clone()));
    model
}

fn texts(errors: &ModelErrors) -> Vec<String> {
    errors.iter().map(ToString::to_string).collect()
}

/// Load and drive by functions of the program, with all scales.
#[test]
fn supplied_functions_equal_built_in_functions() {
    for scales in SCALES {
        let shaken = |time: &str| {
            let load = format!(
                "[[loads]]\nkind = \"force\"\non = {{ body = \"arm\", at = \"end\" }}\nforce = [0, 1, 2]\ntime = {time}\n"
            );
            parse(&(String::from(scales) + &cantilever(3) + &load + DYNAMICS))
        };
        let built_in = Run::of(&shaken("{ kind = \"sine\", frequency = 1.5, phase = 0.3 }"));
        let own = shaken("{ kind = \"external\", name = \"shaker\" }");
        let own = Run::of(&supplied(own, "shaker", &sine(1.5, 0.3)));
        let tolerance = if scales.is_empty() { 0.0 } else { 1e-9 };
        assert_same_columns("load", [&built_in, &own], &["iterations"], 1.0, tolerance);

        let driven = |time: &str| {
            let keys =
                format!("kind = \"revolute\"\naxis = [0, 0, 1]\ndrive = {{ angle = 0.4, time = {time} }}\n");
            parse(&(String::from(scales) + &jointed_body(&keys) + DYNAMICS))
        };
        let built_in =
            Run::of(&driven("{ kind = \"expression\", text = \"sin(2*pi*2000*t)\", unit = 1e-3 }"));
        let own = driven("{ kind = \"external\", name = \"motor\", unit = 1e-3 }");
        let own = Run::of(&supplied(own, "motor", &sine(2000.0, 0.0)));
        assert_same_columns("drive", [&built_in, &own], &["iterations"], 1.0, 1e-9);
    }
}

/// Spring force of the program between the tip and a point: −k (l − L₀) d/l.
fn spring() -> ForceFunction {
    ForceFunction::new(|_, x, _| {
        let relative = Vector3::from(x) - Vector3::new(1.1, 0.2, 0.4);
        let length = relative.norm();
        (relative * (-30.0 * (length - 0.3) / length)).into()
    })
}

const SPRING: &str = r#"
[[joints]]
kind = "spring"
name = "spring"
a = { body = "arm", at = "end" }
b = { point = [1.1, 0.2, 0.4] }
stiffness = 30
length = 0.3
"#;

const FORCE: &str = r#"
[[loads]]
kind = "external"
name = "spring"
on = { body = "arm", at = "end" }
"#;

/// Cantilever with a spring or an external force.
fn with_spring(text: &str, analysis: &str, scales: &str) -> Model {
    let clamp = "[[joints]]\nkind = \"clamp\"\nname = \"root\"\na = { body = \"arm\", at = \"start\" }\n";
    let beam: String = cantilever(3)
        .lines()
        .filter(|line| !line.starts_with("joints"))
        .map(|line| format!("{line}\n"))
        .collect();
    parse(&(String::from(scales) + &beam + clamp + text + analysis))
}

/// Equal motion within the tolerance of Newton's method and equal numbers of iterations, with all scales.
#[test]
fn supplied_spring_force_has_the_motion_of_a_spring() {
    let tight =
        DYNAMICS.replace("step = 1e-3", "step = 1e-3\nstop = { rule = \"energy\", tolerance = 1e-9 }");
    for scales in SCALES {
        let built_in = Run::of(&with_spring(SPRING, &tight, scales));
        let own = Run::of(&forced(with_spring(FORCE, &tight, scales), "spring", &spring()));
        let [a, b] = [&built_in, &own].map(|run| run.vectors("tip."));
        assert!(distance(&a, &b) < 1e-9, "{scales}: {:e}", distance(&a, &b));
        let (a, b) = (built_in.summary.iterations, own.summary.iterations);
        assert!(b <= a + a / 100, "{b} iterations for {a}");
        assert!(own.largest("balance") < 1e-3 * own.largest("work") && own.largest("work") > 0.1);
    }
}

/// Equilibrium and vibrations about it.
#[test]
fn supplied_spring_force_has_the_equilibrium_of_a_spring() {
    for scales in SCALES {
        let of = |analysis: &str| {
            let built_in = Run::of(&with_spring(SPRING, analysis, scales));
            (built_in, Run::of(&forced(with_spring(FORCE, analysis, scales), "spring", &spring())))
        };
        let (built_in, own) = of(STATICS);
        let [a, b] = [&built_in, &own].map(|run| run.last_vector("tip."));
        assert!((a - b).norm() < 1e-9, "{a} {b}");
        let (built_in, own) = of("[analysis]\nkind = \"modes\"\ncount = 6\nabout = \"equilibrium\"\n");
        for (a, b) in built_in.column("frequency").iter().zip(own.column("frequency")) {
            assert!((a - b).abs() < 1e-9 * a, "{a} {b}");
        }
    }
}

/// In statics external forces see the time 1 and the velocity 0, and are multiplied by the load factor.
#[test]
fn external_forces_of_statics_scale_with_the_load() {
    let arguments = Arc::new(Mutex::new(Vec::new()));
    let seen = Arc::clone(&arguments);
    let force = ForceFunction::new(move |t, _, v| {
        seen.lock().unwrap().push((t, v));
        [4.0 * t, v[0].exp(), 0.0]
    });
    let dead = "[[loads]]\nkind = \"force\"\non = { body = \"arm\", at = \"end\" }\nforce = [4, 1, 0]\n";
    for scales in SCALES {
        let analysis = STATICS.replace("statics\"", "statics\"\nload = 0.5");
        let built_in = Run::of(&with_spring(dead, &analysis, scales));
        let own = Run::of(&forced(with_spring(FORCE, &analysis, scales), "spring", &force));
        let [a, b] = [&built_in, &own].map(|run| run.last_vector("tip."));
        assert!((a - b).norm() < 1e-9, "{a} {b}");
    }
    assert!(arguments.lock().unwrap().iter().all(|(t, v)| (t - 1.0).abs() < 1e-15 && *v == [0.0; 3]));
}

/// Velocity exp(−c t/m) of a mass with the damping force −c v; the work is in the energy balance.
#[test]
fn supplied_damping_decays_exponentially() {
    let text = r#"
bodies = [{ kind = "mass", name = "puck", center = [1, 0, 0], mass = 2, motion = { velocity = [1, -2, 0.5] } }]
loads = [{ kind = "external", name = "brake", on = { body = "puck", at = "center" } }]
probes = [{ name = "puck", on = { body = "puck", at = "center" } }]
"#;
    let brake = ForceFunction::new(|_, _, v| v.map(|v| -6.0 * v));
    for scales in SCALES {
        let run = Run::of(&forced(parse(&(String::from(scales) + text + DYNAMICS)), "brake", &brake));
        let start = Vector3::new(1.0, -2.0, 0.5);
        for ((t, v), work) in run.column("t").iter().zip(run.vectors("puck.v")).zip(run.column("work")) {
            assert!((v - start * (-3.0 * t).exp()).norm() < 3e-6, "at {t}: {v}");
            let expected = start.norm_squared() * ((-6.0 * t).exp() - 1.0);
            assert!((work - expected).abs() < 3e-5, "at {t}: {work} for {expected}");
        }
        assert!(run.column("work").windows(2).all(|pair| pair[1] < pair[0]));
        assert!(run.column("balance").iter().all(|x| x.abs() < 3e-5));
        assert!(run.summary.iterations < 3 * run.summary.steps, "{} iterations", run.summary.iterations);
    }
}

/// A model printed in other units calls the functions of the program in its original units.
#[test]
fn printed_models_call_functions_in_their_original_units() {
    let text = r#"
bodies = [{ kind = "mass", name = "puck", center = [1, 0, 0], mass = 2, motion = { velocity = [1, -2, 0.5] } }]
loads = [
  { kind = "external", name = "brake", on = { body = "puck", at = "center" } },
  { kind = "force", force = [0, 0, 6], on = { body = "puck", at = "center" }, time = { kind = "external", name = "push" } },
]
probes = [{ name = "puck", on = { body = "puck", at = "center" } }]
"#;
    let complete = |model: Model| {
        let brake = ForceFunction::new(|t, x, v| v.map(|v| -(6.0 + t + 2.0 * x[1]) * v));
        Run::of(&forced(supplied(model, "push", &sine(2.0, 0.3)), "brake", &brake))
    };
    let own = parse(&(String::from(text) + DYNAMICS));
    let scales = Scales { length: 0.25, time: 4.0, force: 0.5 };
    let other = complete(parse(&toml::to_string(&own.scaled(&scales)).unwrap()));
    let own = complete(own);
    let there = other.vectors("puck.").iter().map(|x| x * scales.length).collect::<Vec<_>>();
    assert!(distance(&own.vectors("puck."), &there) < 1e-12);
}

/// Beam with a damping force of the program at its tip: negative work, energy balance of second order.
#[test]
fn energy_balance_with_supplied_damping_is_of_second_order() {
    let damper = ForceFunction::new(|_, _, v| v.map(|v| -0.5 * v));
    let of = |step: &str| {
        let analysis = DYNAMICS.replace("step = 1e-3", &format!("step = {step}"));
        let run = Run::of(&forced(with_spring(FORCE, &analysis, ""), "spring", &damper));
        assert!(run.column("work").windows(2).all(|pair| pair[1] <= pair[0]));
        [run.column("balance"), run.column("work")]
            .map(|x| x.iter().fold(0.0, |largest: f64, x| largest.max(x.abs())))
    };
    let ([coarse, work], [fine, _]) = (of("2e-3"), of("1e-3"));
    assert!(fine < 2e-3 * work, "{fine:e} of {work:e}");
    assert!(fine < 0.35 * coarse, "{fine:e} after {coarse:e}");
}

/// Several loads with one function: one call for each instant.
#[test]
fn supplied_functions_are_called_once_per_instant() {
    let loads = r#"
[[loads]]
kind = "distributed_force"
body = "arm"
force = [0, 1, 0]
time = { kind = "external", name = "wave" }

[[loads]]
kind = "force"
on = { body = "arm", at = "end" }
force = [0, 0, 1]
time = { kind = "external", name = "wave" }
"#;
    let analysis = DYNAMICS.replace("duration = 1", "duration = 0.02");
    let calls = Arc::new(Mutex::new(Vec::new()));
    let seen = Arc::clone(&calls);
    let wave = ExternalFunction::new(move |t| {
        seen.lock().unwrap().push(t);
        FunctionValue { value: t * t, rate: 2.0 * t, acceleration: 2.0 }
    });
    let run = Run::of(&supplied(parse(&(cantilever(100) + loads + &analysis)), "wave", &wave));
    assert_eq!(run.summary.steps, 20);
    let calls = calls.lock().unwrap();
    assert!(calls.windows(2).all(|pair| pair[0] != pair[1]), "{calls:?}");
    // Start, two instants for the start values of the scheme, ends of the steps.
    assert!(calls.len() <= 23, "{} calls in 20 steps: {calls:?}", calls.len());
}

/// Runs, assembly and diagnosis report all missing functions at once.
#[test]
fn missing_functions_are_rejected() {
    let mut model =
        Model::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/external.toml")))
            .unwrap();
    let expected = "expected a function that the program supplies under this name";
    let all = [
        format!("loads[0].time.name: found the external function \"gust\", {expected}"),
        format!("joints[0].drive.time.name: found the external function \"motor\", {expected}"),
        format!("joints[1].time.name: found the external function \"winch\", {expected}"),
        format!("loads[1].name: found the external force \"magnet\", {expected}"),
        format!("loads[2].name: found the external force \"wind\", {expected}"),
    ];
    assert_eq!(model.check(), Ok(()));
    let Err(Error::Model(errors)) = simulate(&model, &mut Series::new()) else {
        panic!("the run is accepted")
    };
    assert_eq!(texts(&errors), all);
    assert_eq!(texts(&model.assemble().map(|_| ()).unwrap_err()), all);
    assert_eq!(texts(&model.assemble_static().map(|_| ()).unwrap_err()), all);
    assert_eq!(texts(&model.diagnose().map(|_| ()).unwrap_err()), all);
    assert!(!model.supply("magnet", sine(1.0, 0.0)), "magnet is a force");
    assert!(!model.supply("moter", sine(1.0, 0.0)));
    for name in ["motor", "winch", "gust"] {
        assert!(model.supply(name, sine(1.0, 0.0)));
    }
    assert!(model.supply_force("wind", spring()));
    assert_eq!(texts(&model.check_supplies().unwrap_err()), all[3..4]);
    assert!(model.supply_force("magnet", spring()));
    let settings = model.analysis.dynamics_mut().unwrap();
    settings.duration = 0.01;
    Run::of(&model);
}

/// Supplied functions satisfy the rules of built-in functions.
#[test]
fn supplied_functions_are_checked() {
    let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/external.toml"));
    let mut model = Model::parse(text).unwrap();
    let constant =
        |value| ExternalFunction::new(move |_| FunctionValue { value, ..FunctionValue::default() });
    model.supply("motor", constant(0.2));
    model.supply("winch", constant(0.3));
    model.supply("gust", constant(f64::NAN));
    let expected = [
        "loads[0].time.name: found a function that is NaN at t = 0, expected one that is a number",
        "joints[0].drive.time: found angle 0.1 at t = 0, expected a motion that starts from the undeformed state, at 0",
        "joints[1].time: found a change of 0.03 at t = 0, expected a motion that starts from the undeformed state, at 0",
    ];
    assert_eq!(texts(&model.check().unwrap_err()), expected);
}

/// Contradictions between drives are determined by the values of their functions.
#[test]
fn supplied_drives_are_checked_for_contradictions() {
    let drive = |time: &str| format!("drive = {{ angle = 0.5, time = {{ {time} }} }}");
    let text = format!(
        r#"
bodies = [
  {{ kind = "rigid", name = "w1", center = [0, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }},
  {{ kind = "rigid", name = "w2", center = [1, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }},
]
joints = [
  {{ kind = "revolute", name = "h1", a = {{ body = "w1", at = "center" }}, axis = [0, 0, 1], {} }},
  {{ kind = "revolute", name = "h2", a = {{ body = "w2", at = "center" }}, axis = [0, 0, 1], {} }},
]
couplings = [{{ name = "gear", joints = [{{ joint = "h1", factor = 1 }}, {{ joint = "h2", factor = 1 }}] }}]
{DYNAMICS}"#,
        drive("kind = \"sine\", frequency = 1"),
        drive("kind = \"external\", name = \"motor\"")
    );
    let turned = |sign: f64| {
        let own = sine(1.0, 0.0);
        let turned = move |t| {
            let FunctionValue { value, rate, acceleration } = own.at(t);
            FunctionValue { value: sign * value, rate: sign * rate, acceleration: sign * acceleration }
        };
        supplied(parse(&text), "motor", &ExternalFunction::new(turned))
    };
    assert_eq!(turned(-1.0).check(), Ok(()));
    Run::of(&turned(-1.0));
    let errors = texts(&turned(1.0).check().unwrap_err());
    assert!(errors[0].starts_with("couplings[0]: found equations that contradict `h1`, `h2`"), "{errors:?}");
}

/// Values that become NaN end the run with the results so far. A function can be called again after a panic.
#[test]
fn failing_functions_end_the_run() {
    let text = r#"
bodies = [{ kind = "mass", name = "bob", center = [1, 0, 0], mass = 2 }]
loads = [
  { kind = "force", on = { body = "bob", at = "center" }, force = [1, 0, 0], time = { kind = "external", name = "push" } },
  { kind = "external", on = { body = "bob", at = "center" }, name = "field" },
]
"#;
    let until = |end: f64| move |t: f64| if t < end { 1.0 } else { f64::NAN };
    for (push, field) in [(until(0.5), until(2.0)), (until(2.0), until(0.5))] {
        let push =
            ExternalFunction::new(move |t| FunctionValue { value: push(t), ..FunctionValue::default() });
        let field = ForceFunction::new(move |t, _, _| [0.0, field(t), 0.0]);
        let mut series = Series::new();
        let model = forced(supplied(parse(&(String::from(text) + DYNAMICS)), "push", &push), "field", &field);
        let summary = simulate(&model, &mut series).unwrap();
        let Outcome::Failed { time, .. } = summary.outcome else { panic!("{:?}", summary.outcome) };
        assert!((time - 0.5).abs() < 2e-3);
        assert!(series.column("t").unwrap().last().is_some_and(|t| (t - 0.5).abs() < 2e-3));
    }
    let panicking = ExternalFunction::new(|t| {
        assert!(t < 1.0, "t is too large");
        FunctionValue { value: t, ..FunctionValue::default() }
    });
    assert!(catch_unwind(AssertUnwindSafe(|| panicking.at(2.0))).is_err());
    assert_eq!(panicking.at(0.5).value, 0.5);
}
