//! Functions and forces that a program supplies, beside what is built in.

use std::f64::consts::TAU;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};

use crate::common::models::held::{DYNAMICS, STATICS, body, model};
use crate::common::solutions::{Run, distance};
use ancf::function::{External, ForceFunction, Instant};
use ancf::model::ModelErrors;
use ancf::record::Series;
use ancf::{Error, Model, Outcome, Scales, simulate};
use nalgebra::Vector3;

/// A soft cantilever of so many elements with a probe at its tip.
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

/// Units that are none of the user's, no powers of two, and those that the program chooses.
const SCALES: [&str; 3] = [
    "",
    "scales = { kind = \"given\", length = 3, force = 0.7, time = 0.13 }\n",
    "scales = { kind = \"auto\" }\n",
];

fn sine(frequency: f64, phase: f64) -> External {
    External::new(move |t| {
        let omega = TAU * frequency;
        let (sin, cos) = (omega * t + phase).sin_cos();
        Instant { value: sin, rate: omega * cos, acceleration: -omega * omega * sin }
    })
}

fn supplied(mut model: Model, name: &str, function: &External) -> Model {
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

/// All columns of two runs but their counts of iterations.
fn assert_alike(a: &Run, b: &Run, tolerance: f64) {
    for (name, a) in a.columns().filter(|(name, _)| !name.contains("iterations")) {
        let size = a.iter().fold(1.0, |size: f64, a| size.max(a.abs()));
        for (a, b) in a.iter().zip(b.column(name)) {
            assert!((a - b).abs() <= tolerance * size, "{name}: {a} and {b}");
        }
    }
}

/// A load and a drive by functions of the program, in whatever units, are those that are built in.
#[test]
fn functions_are_those_that_are_built_in() {
    for scales in SCALES {
        let shaken = |time: &str| {
            let load = format!(
                "[[loads]]\nkind = \"force\"\non = {{ body = \"arm\", at = \"end\" }}\nforce = [0, 1, 2]\ntime = {time}\n"
            );
            model(&(String::from(scales) + &cantilever(3) + &load + DYNAMICS))
        };
        let built_in = Run::of(&shaken("{ kind = \"sine\", frequency = 1.5, phase = 0.3 }"));
        let own = shaken("{ kind = \"external\", name = \"shaker\" }");
        let own = Run::of(&supplied(own, "shaker", &sine(1.5, 0.3)));
        let tolerance = if scales.is_empty() { 0.0 } else { 1e-9 };
        assert_alike(&built_in, &own, tolerance);

        let driven = |time: &str| {
            let keys =
                format!("kind = \"revolute\"\naxis = [0, 0, 1]\ndrive = {{ angle = 0.4, time = {time} }}\n");
            model(&(String::from(scales) + &body(&keys) + DYNAMICS))
        };
        let built_in =
            Run::of(&driven("{ kind = \"expression\", text = \"sin(2*pi*2000*t)\", unit = 1e-3 }"));
        let own = driven("{ kind = \"external\", name = \"motor\", unit = 1e-3 }");
        assert_alike(&built_in, &Run::of(&supplied(own, "motor", &sine(2000.0, 0.0))), 1e-9);
    }
}

/// A spring of the program between the tip and a point: −k (l − L₀) d/l.
fn spring() -> ForceFunction {
    ForceFunction::new(|_, x, _| {
        let apart = Vector3::from(x) - Vector3::new(1.1, 0.2, 0.4);
        let length = apart.norm();
        (apart * (-30.0 * (length - 0.3) / length)).into()
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

fn sprung(text: &str, analysis: &str, scales: &str) -> Model {
    let clamp = "[[joints]]\nkind = \"clamp\"\nname = \"root\"\na = { body = \"arm\", at = \"start\" }\n";
    let beam: String = cantilever(3)
        .lines()
        .filter(|line| !line.starts_with("joints"))
        .map(|line| format!("{line}\n"))
        .collect();
    model(&(String::from(scales) + &beam + clamp + text + analysis))
}

/// Motion with a spring of the program is that with a spring: Newton's method ends where it would, whatever the units.
#[test]
fn a_spring_of_the_program_moves_as_a_spring() {
    let tight =
        DYNAMICS.replace("step = 1e-3", "step = 1e-3\nstop = { rule = \"energy\", tolerance = 1e-9 }");
    for scales in SCALES {
        let built_in = Run::of(&sprung(SPRING, &tight, scales));
        let own = Run::of(&forced(sprung(FORCE, &tight, scales), "spring", &spring()));
        let [a, b] = [&built_in, &own].map(|run| run.vectors("tip."));
        assert!(distance(&a, &b) < 1e-9, "{scales}: {:e}", distance(&a, &b));
        let (a, b) = (built_in.summary.iterations, own.summary.iterations);
        assert!(b <= a + a / 100, "{b} iterations for {a}");
        let most = |name| own.column(name).iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(most("balance") < 1e-3 * most("work") && most("work") > 0.1);
    }
}

/// So is its equilibrium, and so are vibrations about it.
#[test]
fn a_spring_of_the_program_stands_as_a_spring() {
    for scales in SCALES {
        let of = |analysis: &str| {
            let built_in = Run::of(&sprung(SPRING, analysis, scales));
            (built_in, Run::of(&forced(sprung(FORCE, analysis, scales), "spring", &spring())))
        };
        let (built_in, own) = of(STATICS);
        let [a, b] = [&built_in, &own].map(|run| *run.vectors("tip.").last().unwrap());
        assert!((a - b).norm() < 1e-9, "{a} {b}");
        let (built_in, own) = of("[analysis]\nkind = \"modes\"\ncount = 6\nabout = \"equilibrium\"\n");
        for (a, b) in built_in.column("frequency").iter().zip(own.column("frequency")) {
            assert!((a - b).abs() < 1e-9 * a, "{a} {b}");
        }
    }
}

/// In statics the time is 1, in the units of the program, the velocity 0, and the force grows with the load.
#[test]
fn forces_in_statics() {
    let met = Arc::new(Mutex::new(Vec::new()));
    let seen = Arc::clone(&met);
    let force = ForceFunction::new(move |t, _, v| {
        seen.lock().unwrap().push((t, v));
        [4.0 * t, v[0].exp(), 0.0]
    });
    let dead = "[[loads]]\nkind = \"force\"\non = { body = \"arm\", at = \"end\" }\nforce = [4, 1, 0]\n";
    for scales in SCALES {
        let analysis = STATICS.replace("statics\"", "statics\"\nload = 0.5");
        let built_in = Run::of(&sprung(dead, &analysis, scales));
        let own = Run::of(&forced(sprung(FORCE, &analysis, scales), "spring", &force));
        let [a, b] = [&built_in, &own].map(|run| *run.vectors("tip.").last().unwrap());
        assert!((a - b).norm() < 1e-9, "{a} {b}");
    }
    assert!(met.lock().unwrap().iter().all(|(t, v)| (t - 1.0).abs() < 1e-15 && *v == [0.0; 3]));
}

/// A mass that the program brakes by −c v comes to rest as exp(−c t/m), and what it loses is in the books.
#[test]
fn a_damper_of_the_program() {
    let text = r#"
bodies = [{ kind = "mass", name = "puck", center = [1, 0, 0], mass = 2, motion = { velocity = [1, -2, 0.5] } }]
loads = [{ kind = "external", name = "brake", on = { body = "puck", at = "center" } }]
probes = [{ name = "puck", on = { body = "puck", at = "center" } }]
"#;
    let brake = ForceFunction::new(|_, _, v| v.map(|v| -6.0 * v));
    for scales in SCALES {
        let run = Run::of(&forced(model(&(String::from(scales) + text + DYNAMICS)), "brake", &brake));
        let start = Vector3::new(1.0, -2.0, 0.5);
        for ((t, v), work) in run.column("t").iter().zip(run.vectors("puck.v")).zip(run.column("work")) {
            assert!((v - start * (-3.0 * t).exp()).norm() < 3e-6, "at {t}: {v}");
            let lost = start.norm_squared() * ((-6.0 * t).exp() - 1.0);
            assert!((work - lost).abs() < 3e-5, "at {t}: {work} for {lost}");
        }
        assert!(run.column("work").windows(2).all(|pair| pair[1] < pair[0]));
        assert!(run.column("balance").iter().all(|x| x.abs() < 3e-5));
        assert!(run.summary.iterations < 3 * run.summary.steps, "{} iterations", run.summary.iterations);
    }
}

/// A model that is printed in other units meets the program in its own.
#[test]
fn a_printed_model_asks_in_the_units_of_the_program() {
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
    let own = model(&(String::from(text) + DYNAMICS));
    let scales = Scales { length: 0.25, time: 4.0, force: 0.5 };
    let other = complete(model(&toml::to_string(&own.scaled(&scales)).unwrap()));
    let own = complete(own);
    let there = other.vectors("puck.").iter().map(|x| x * scales.length).collect::<Vec<_>>();
    assert!(distance(&own.vectors("puck."), &there) < 1e-12);
}

/// A beam with a damper of the program at its tip comes to rest, and its books balance to second order.
#[test]
fn a_damped_beam_keeps_its_books() {
    let damper = ForceFunction::new(|_, _, v| v.map(|v| -0.5 * v));
    let of = |step: &str| {
        let analysis = DYNAMICS.replace("step = 1e-3", &format!("step = {step}"));
        let run = Run::of(&forced(sprung(FORCE, &analysis, ""), "spring", &damper));
        assert!(run.column("work").windows(2).all(|pair| pair[1] <= pair[0]));
        [run.column("balance"), run.column("work")]
            .map(|x| x.iter().fold(0.0, |most: f64, x| most.max(x.abs())))
    };
    let ([coarse, work], [fine, _]) = (of("2e-3"), of("1e-3"));
    assert!(fine < 2e-3 * work, "{fine:e} of {work:e}");
    assert!(fine < 0.35 * coarse, "{fine:e} after {coarse:e}");
}

/// Loads of one function ask the program once for each time.
#[test]
fn one_call_for_each_time() {
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
    let wave = External::new(move |t| {
        seen.lock().unwrap().push(t);
        Instant { value: t * t, rate: 2.0 * t, acceleration: 2.0 }
    });
    let run = Run::of(&supplied(model(&(cantilever(100) + loads + &analysis)), "wave", &wave));
    assert_eq!(run.summary.steps, 20);
    let calls = calls.lock().unwrap();
    assert!(calls.windows(2).all(|pair| pair[0] != pair[1]), "{calls:?}");
    // The start, two instants by which the scheme gets start values, the ends of the steps.
    assert!(calls.len() <= 23, "{} calls in 20 steps: {calls:?}", calls.len());
}

/// Nothing runs without its functions, and all that are missing are told at once, wherever somebody tries.
#[test]
fn what_is_not_supplied_is_refused() {
    let mut model =
        Model::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/external.toml")))
            .unwrap();
    let wanted = "wanted a function that the program supplies under this name";
    let all = [
        format!("loads[0].time.name: found the external function \"gust\", {wanted}"),
        format!("joints[0].drive.time.name: found the external function \"motor\", {wanted}"),
        format!("joints[1].time.name: found the external function \"winch\", {wanted}"),
        format!("loads[1].name: found the external force \"magnet\", {wanted}"),
        format!("loads[2].name: found the external force \"wind\", {wanted}"),
    ];
    assert_eq!(model.check(), Ok(()));
    let Err(Error::Model(errors)) = simulate(&model, &mut Series::new()) else { panic!("it runs") };
    assert_eq!(texts(&errors), all);
    assert_eq!(texts(&model.assemble().map(|_| ()).unwrap_err()), all);
    assert_eq!(texts(&model.assemble_static().map(|_| ()).unwrap_err()), all);
    assert_eq!(texts(&model.diagnose().map(|_| ()).unwrap_err()), all);
    assert!(!model.supply("magnet", sine(1.0, 0.0)), "it is a force");
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

/// Functions that are supplied obey the rules of those that are stated.
#[test]
fn what_is_supplied_is_checked() {
    let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/external.toml"));
    let mut model = Model::parse(text).unwrap();
    let constant = |value| External::new(move |_| Instant { value, ..Instant::default() });
    model.supply("motor", constant(0.2));
    model.supply("winch", constant(0.3));
    model.supply("gust", constant(f64::NAN));
    let wanted = [
        "loads[0].time.name: found a function that is NaN at t = 0, wanted one that is a number",
        "joints[0].drive.time: found angle 0.1 at t = 0, wanted a motion that starts from the undeformed state, at 0",
        "joints[1].time: found a change of 0.03 at t = 0, wanted a motion that starts from the undeformed state, at 0",
    ];
    assert_eq!(texts(&model.check().unwrap_err()), wanted);
}

/// Whether drives contradict each other is judged by what they do, and not before that is known.
#[test]
fn drives_of_the_program_may_agree() {
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
            let Instant { value, rate, acceleration } = own.at(t);
            Instant { value: sign * value, rate: sign * rate, acceleration: sign * acceleration }
        };
        supplied(model(&text), "motor", &External::new(turned))
    };
    assert_eq!(turned(-1.0).check(), Ok(()));
    Run::of(&turned(-1.0));
    let errors = texts(&turned(1.0).check().unwrap_err());
    assert!(errors[0].starts_with("couplings[0]: found equations that contradict `h1`, `h2`"), "{errors:?}");
}

/// What is no number later on, or no longer, ends the run with all before it; the program may panic and go on.
#[test]
fn functions_that_fail() {
    let text = r#"
bodies = [{ kind = "mass", name = "bob", center = [1, 0, 0], mass = 2 }]
loads = [
  { kind = "force", on = { body = "bob", at = "center" }, force = [1, 0, 0], time = { kind = "external", name = "push" } },
  { kind = "external", on = { body = "bob", at = "center" }, name = "field" },
]
"#;
    let until = |end: f64| move |t: f64| if t < end { 1.0 } else { f64::NAN };
    for (push, field) in [(until(0.5), until(2.0)), (until(2.0), until(0.5))] {
        let push = External::new(move |t| Instant { value: push(t), ..Instant::default() });
        let field = ForceFunction::new(move |t, _, _| [0.0, field(t), 0.0]);
        let mut series = Series::new();
        let model = forced(supplied(model(&(String::from(text) + DYNAMICS)), "push", &push), "field", &field);
        let summary = simulate(&model, &mut series).unwrap();
        let Outcome::Failed { time, .. } = summary.outcome else { panic!("{:?}", summary.outcome) };
        assert!((time - 0.5).abs() < 2e-3);
        assert!(series.column("t").unwrap().last().is_some_and(|t| (t - 0.5).abs() < 2e-3));
    }
    let moody = External::new(|t| {
        assert!(t < 1.0, "that late?");
        Instant { value: t, ..Instant::default() }
    });
    assert!(catch_unwind(AssertUnwindSafe(|| moody.at(2.0))).is_err());
    assert_eq!(moody.at(0.5).value, 0.5);
}
