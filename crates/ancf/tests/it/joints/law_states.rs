//! States of force laws: filters, controllers, viscoelastic elements, hysteresis.

use ancf::record::Series;
use ancf::solver::equations::State;
use ancf::{Model, Simulation, Summary};
use nalgebra::{Matrix3, Vector3};

use crate::common::models::parse;
use crate::common::solutions::Run;
use crate::runs::given_states::States;

/// Mass 2 on a guide along x with a force law.
fn guided(law: &str, more: &str, analysis: &str) -> String {
    format!(
        "bodies = [{{ kind = \"rigid\", name = \"r\", center = [0, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.3] }}]\n\
         joints = [{{ kind = \"prismatic\", name = \"guide\", a = {{ body = \"r\", at = \"center\" }}, axis = [1, 0, 0], {law} }}]\n\
         analysis = {{ {analysis} }}\n{more}"
    )
}

fn motion(duration: f64, step: f64) -> String {
    format!("kind = \"dynamics\", duration = {duration}, step = {step}, scheme = {{ spectral_radius = 0.8 }}")
}

fn run(text: &str) -> (Series, Summary) {
    run_model(&parse(text))
}

fn run_model(model: &Model) -> (Series, Summary) {
    let mut states = States::default();
    let summary = Simulation::new(model).unwrap().run(&mut states).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (states.series, summary)
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// The output of a filter of a prescribed motion follows its closed form, with an error of second order in the step.
#[test]
fn filters_converge_with_second_order() {
    let error = |step: f64| {
        let law = "drive = { displacement = 0.1, time = { kind = \"expression\", text = \"sin(3*t)^2\" } }, \
                   force = { kind = \"expression\", text = \"z\", states = [{ name = \"z\", rate = \"(x - z)/0.2\", size = 0.1 }] }";
        let (series, _) = run(&guided(law, "", &motion(1.0, step)));
        // z' = (x - z)/tau with x = 0.05 (1 - cos 6 t).
        let (tau, w, t) = (0.2_f64, 6.0_f64, 1.0_f64);
        let (c, s) = ((w * t).cos(), (w * t).sin());
        let a = 0.05 / (1.0 + (w * tau).powi(2));
        let exact = 0.05 - a * (c + w * tau * s) + (a - 0.05) * (-t / tau).exp();
        (last(&series, "guide.z") - exact).abs()
    };
    let [coarse, fine] = [0.01, 0.0025].map(error);
    assert!(coarse < 1e-4, "{coarse:e}");
    assert!(fine < coarse / 12.0, "{coarse:e} and {fine:e}");
}

/// A spring in series with a damper: the motion is that of the linear equations of third order.
#[test]
fn viscoelastic_elements_follow_linear_equations() {
    let (k, tau, mass) = (50.0, 0.3, 2.0);
    let law = format!(
        "force = {{ kind = \"expression\", text = \"-20*x - z\", states = [{{ name = \"z\", rate = \"{k}*v - z/{tau}\", start = 0.5 }}] }}"
    );
    let error = |step: f64| {
        let text = guided(&law, "", &motion(1.0, step));
        let text = text.replace("mass = 2,", "mass = 2, motion = { velocity = [1, 0, 0] },");
        let (series, _) = run(&text);
        let a = Matrix3::new(0.0, 1.0, 0.0, -20.0 / mass, 0.0, -1.0 / mass, 0.0, k, -1.0 / tau);
        let exact = a.exp() * Vector3::new(0.0, 1.0, 0.5);
        let balance = last(&series, "balance").abs();
        assert!(balance < 1e-3, "{balance:e}");
        [("displacement", exact.x), ("z", exact.z)]
            .map(|(name, exact)| (last(&series, &format!("guide.{name}")) - exact).abs())
    };
    let [coarse, fine] = [0.01, 0.0025].map(error);
    for i in 0..2 {
        assert!(coarse[i] < 2e-2, "{coarse:?}");
        assert!(fine[i] < coarse[i] / 10.0, "{coarse:?} and {fine:?}");
    }
}

/// An integral controller holds a load at its set point. Without the integral a deviation remains.
#[test]
fn integral_controllers_leave_no_deviation() {
    let law = |integral: &str| {
        format!(
            "force = {{ kind = \"expression\", text = \"-40*(x - 0.1) - 20*v{integral}\", states = [{{ name = \"sum\", rate = \"x - 0.1\", size = 0.1 }}] }}"
        )
    };
    let gravity = "gravity = [-9.81, 0, 0]\n";
    let (with, _) = run(&guided(&law(" - 60*sum"), gravity, &motion(20.0, 0.01)));
    let (without, _) = run(&guided(&law(""), gravity, &motion(20.0, 0.01)));
    assert!((last(&with, "guide.displacement") - 0.1).abs() < 1e-6);
    assert!((last(&with, "guide.sum") + 2.0 * 9.81 / 60.0).abs() < 1e-5);
    assert!((last(&without, "guide.displacement") - 0.1 + 2.0 * 9.81 / 40.0).abs() < 1e-6);
}

/// Hysteresis of Bouc and Wen under a prescribed motion: the force is that of an independent integration.
#[test]
fn hysteresis_follows_an_independent_integration() {
    let rate = |v: f64, z: f64| v - 0.5 * v.abs() * z.abs() * z / 0.01 - 0.5 * v * z * z / 0.01;
    let x = |t: f64| 0.04 * (2.0 * t).sin();
    let v = |t: f64| 0.08 * (2.0 * t).cos();
    let law = "drive = { displacement = 0.04, time = { kind = \"expression\", text = \"sin(2*t)\" } }, force = { kind = \"expression\", \
               text = \"-1000*x - 4000*z\", states = [{ name = \"z\", size = 0.01, rate = \"v - 50*abs(v)*abs(z)*z - 50*v*z^2\" }] }";
    // The drive starts with a velocity, which the state of the body has not.
    let (series, _) = run(&guided(law, "", &motion(6.0, 0.002)));
    let (n, mut z) = (60_000, 0.0_f64);
    let h = 6.0 / f64::from(n);
    for i in 0..n {
        let t = f64::from(i) * h;
        let k1 = rate(v(t), z);
        let k2 = rate(v(t + 0.5 * h), z + 0.5 * h * k1);
        let k3 = rate(v(t + 0.5 * h), z + 0.5 * h * k2);
        let k4 = rate(v(t + h), z + h * k3);
        z += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    let found = last(&series, "guide.z");
    assert!((found - z).abs() < 1e-4 * 0.01, "{found} and {z}");
    assert!((last(&series, "guide.displacement") - x(6.0)).abs() < 1e-12);
}

/// Results do not depend on the units of the solver, nor on those of the model.
#[test]
fn states_do_not_depend_on_units() {
    let law = "force = { kind = \"expression\", text = \"-40*(x - 0.1) - 5*v - 60*sum\", states = [{ name = \"sum\", rate = \"x - 0.1\", start = 0.02, size = 0.1 }] }";
    let own = parse(&guided(law, "gravity = [-9.81, 0, 0]\n", &motion(1.0, 0.01)));
    let scaled = parse(&guided(
        law,
        "gravity = [-9.81, 0, 0]\nscales = { kind = \"given\", length = 0.02, force = 30, time = 0.4 }\n",
        &motion(1.0, 0.01),
    ));
    let converted = own.scaled(&ancf::Scales { length: 0.5, time: 4.0, force: 0.25 });
    let (a, b, c) = (run_model(&own).0, run_model(&scaled).0, run_model(&converted).0);
    let names = [("guide.displacement", 0.5, 1e-8), ("guide.sum", 1.0, 1e-8), ("guide.sum_rate", 0.25, 1e-6)];
    for (name, unit, tolerance) in names {
        let expected = last(&a, name);
        assert!((last(&b, name) - expected).abs() < tolerance * expected.abs(), "{name}");
        assert!((last(&c, name) * unit - expected).abs() < tolerance * expected.abs(), "{name}");
    }
    assert_eq!(a.column("guide.sum").unwrap()[0], 0.02);
}

/// Motions that start from an equilibrium or from another motion have the states of force laws. Statics keeps their values at the
/// start.
#[test]
fn states_start_with_the_motion() {
    let law = "force = { kind = \"expression\", text = \"-40*x - 5*v - 60*sum\", states = [{ name = \"sum\", rate = \"x\", start = 0.02, size = 0.1 }] }";
    let gravity = "gravity = [-9.81, 0, 0]\n";
    let (still, _) = run(&guided(law, gravity, "kind = \"statics\""));
    let held = (-2.0 * 9.81 - 60.0 * 0.02) / 40.0;
    assert!((last(&still, "guide.displacement") - held).abs() < 1e-9);
    let from = format!("{gravity}initial = {{ from = \"equilibrium\" }}\n");
    let (moving, _) = run(&guided(law, &from, &motion(0.2, 0.01)));
    assert!((moving.column("guide.displacement").unwrap()[0] - held).abs() < 1e-9);
    assert_eq!(moving.column("guide.sum").unwrap()[0], 0.02);

    let model = parse(&guided(law, gravity, &motion(0.2, 0.01)));
    let simulation = Simulation::new(&model).unwrap();
    let mut half = States::default();
    assert!(simulation.run(&mut half).unwrap().outcome.is_finished());
    let state: &State = half.states.last().unwrap();
    let start = simulation.start_from(&simulation.given_state(state, "before")).unwrap();
    let mut rest = States::default();
    assert!(simulation.run_from(&start, &mut rest).unwrap().outcome.is_finished());
    let (whole, _) = run(&guided(law, gravity, &motion(0.4, 0.01)));
    assert!((rest.series.column("guide.sum").unwrap()[0] - last(&half.series, "guide.sum")).abs() < 1e-15);
    assert!((last(&whole, "guide.sum") - last(&rest.series, "guide.sum")).abs() < 1e-4);
}

/// A beam under a controller of its hinge: no warning of instability, and the energy balance is closed.
#[test]
fn controlled_beams_have_closed_balances() {
    let text = "gravity = [0, 0, -9.81]\nmaterials.m = { density = 1000, young = 2e8 }\n\
         sections.s = { kind = \"circle\", diameter = 0.03 }\n\
         bodies = [{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = \"s\", material = \"m\" }]\n\
         joints = [{ kind = \"revolute\", name = \"hinge\", a = { body = \"b\", at = \"start\" }, axis = [0, -1, 0],\n\
         moment = { kind = \"expression\", text = \"-20*(angle - 0.5*min(t, 1)^2) - 3*rate - 40*sum\", states = [{ name = \"sum\", rate = \"angle - 0.5*min(t, 1)^2\" }] } }]\n\
         analysis = { kind = \"dynamics\", duration = 8, step = 2e-3 }\n\
         probes = [{ name = \"tip\", on = { body = \"b\", at = \"end\" } }]\n";
    let (series, summary) = run(text);
    assert!((last(&series, "hinge.angle") - 0.5).abs() < 1e-3, "{}", last(&series, "hinge.angle"));
    assert!(summary.warnings.is_empty(), "{:?}", summary.warnings);
    let largest = series.column("kinetic").unwrap().iter().copied().fold(0.0, f64::max);
    assert!(last(&series, "balance").abs() < 1e-3 * largest, "{} {largest}", last(&series, "balance"));
}

/// Gaps close in a model with states, as in one without them. Coordinates of later joints keep their meaning.
#[test]
fn gaps_close_with_states() {
    let text = |law: &str| {
        format!(
            "assemble = true\n\
             bodies = [{{ kind = \"rigid\", name = \"a\", center = [0.5, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }}, {{ kind = \"rigid\", name = \"b\", center = [1.51, 0.3, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }}]\n\
             joints = [{{ kind = \"revolute\", name = \"m\", a = {{ body = \"a\", at = [0, 0, 0] }}, axis = [0, 0, 1], moment = {{ kind = \"expression\", {law} }} }},\n\
             {{ kind = \"revolute\", name = \"k\", a = {{ body = \"b\", at = [1.01, 0.3, 0] }}, b = {{ body = \"a\", at = [1, 0, 0] }}, axis = [0, 0, 1], spring = {{ stiffness = 2, angle = 0.3 }} }}]\n\
             analysis = {{ {} }}\n",
            motion(0.2, 1e-3)
        )
    };
    let (with, _) =
        run(&text("text = \"-3*angle - 0*z\", states = [{ name = \"z\", rate = \"angle - z\" }]"));
    let (without, _) = run(&text("text = \"-3*angle\""));
    for name in ["m.angle", "k.angle", "k.rate"] {
        let (found, expected) = (last(&with, name), last(&without, name));
        assert!((found - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{name}: {found} and {expected}");
    }
    assert!(last(&with, "k.angle").abs() > 1e-3);
}

#[test]
fn errors_of_states_have_their_places() {
    let message = |states: &str, more: &str| {
        let law = format!("force = {{ kind = \"expression\", text = \"-z\", states = [{states}] }}");
        Model::parse(&guided(&law, more, &motion(1.0, 0.01))).unwrap_err().to_string()
    };
    let syntax = message("{ name = \"z\", rate = \"x +\" }", "");
    assert!(syntax.contains("joints[0].force.states[0].rate: found its end at character 4"), "{syntax}");
    let taken = message("{ name = \"z\", rate = \"x\" }, { name = \"v\", rate = \"x\" }", "");
    assert!(taken.contains("joints[0].force.states[1].name: found \"v\", expected another name"), "{taken}");
    for name in ["a b", "a.b", "1a", "\u{e9}", "a\\nb"] {
        let word = message(&format!("{{ name = \"{name}\", rate = \"x\" }}"), "");
        assert!(
            word.contains("joints[0].force.states[0].name: found") && word.contains("a word of formulas"),
            "{word}"
        );
    }
    let infinite = message("{ name = \"z\", rate = \"1/x\" }", "");
    assert!(infinite.contains("states[0].rate: found a formula that is inf at the start"), "{infinite}");
    let errors = message("{ name = \"z\", rate = \"x\" }", "output = { errors = true }\n");
    assert!(errors.contains("output.errors: found true"), "{errors}");
}

/// Rigid bodies without gravity have no rate of their own: the number of iterations does not depend on the unit of time.
#[test]
fn states_of_laws_do_not_depend_on_the_unit_of_time() {
    let text = |t: f64| {
        format!(
            r#"bodies = [{{ kind = "rigid", name = "arm", center = [0.5, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }}]
            [[joints]]
            kind = "revolute"
            name = "motor"
            a = {{ body = "arm", at = [0, 0, 0] }}
            axis = [0, 0, 1]
            moment = {{ kind = "expression", units = {{ length = 1.0, time = {:?}, force = {:?} }}, text = "30*(1 - angle) + 20*sum - 5*slope",
                states = [{{ name = "sum", rate = "1 - angle" }}, {{ name = "slope", rate = "(rate - slope)/0.005" }}] }}
            [analysis]
            kind = "dynamics"
            duration = {:?}
            step = {:?}"#,
            1.0 / t,
            t * t,
            0.5 * t,
            1e-3 * t
        )
    };
    let runs = [1.0, 1e3, 1e6, 1e-3].map(|unit| Run::of(&parse(&text(unit))));
    let [first, others @ ..] = &runs;
    for other in others {
        let ratio = other.summary.iterations as f64 / first.summary.iterations as f64;
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
        let [own, reference] = [other, first].map(|run| *run.column("motor.angle").last().unwrap());
        assert!((own - reference).abs() < 1e-9, "{own} {reference}");
    }
}
