//! Motions that start in states of other simulations.

use std::io;
use std::ops::ControlFlow;

use ancf::model::Joint;
use ancf::record::{Series, Sink};
use ancf::solver::equations::State;
use ancf::{InitialReport, Model, Observer, Simulation, Summary};

use crate::common::models::parse;

/// Observer of rows and states.
#[derive(Default)]
pub(crate) struct States {
    pub(crate) series: Series,
    pub(crate) states: Vec<State>,
}

impl Observer for States {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.series, columns)
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        self.states.push(state.clone());
        Sink::record(&mut self.series, row)
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl States {
    fn column(&self, name: &str) -> &[f64] {
        self.series.column(name).unwrap()
    }

    fn last(&self, name: &str) -> f64 {
        *self.column(name).last().unwrap()
    }
}

fn run(simulation: &Simulation) -> States {
    let mut states = States::default();
    assert!(simulation.run(&mut states).unwrap().outcome.is_finished());
    states
}

/// Runs a model from the state of another simulation.
fn run_from(model: &Model, other: &Simulation, state: &State) -> (States, Summary) {
    let simulation = Simulation::new(model).unwrap();
    let start = simulation.start_from(&other.given_state(state, "the state before")).unwrap();
    let mut states = States::default();
    let summary = simulation.run_from(&start, &mut states).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (states, summary)
}

/// Falling beam on a hinge with a spring, and a rigid body at its tip.
fn pendulum(duration: f64, step: f64, more: &str) -> Model {
    parse(&format!(
        "gravity = [0, 0, -9.81]\nmaterials.m = {{ density = 1000, young = 2e7 }}\n\
         sections.s = {{ kind = \"rectangle\", height = 0.02, width = 0.03 }}\n\
         bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 3, section = \"s\", material = \"m\" }},\n\
         {{ kind = \"rigid\", name = \"end\", center = [1.1, 0, 0], mass = 0.2, inertia = [1e-3, 2e-3, 3e-3] }}]\n\
         joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"b\", at = \"start\" }}, axis = [0, 1, 0], spring = {{ stiffness = 1 }} }},\n\
         {{ kind = \"clamp\", name = \"tip\", a = {{ body = \"end\", at = [1, 0, 0] }}, b = {{ body = \"b\", at = \"end\" }}, fix = \"section\" }}]\n\
         probes = [{{ name = \"p\", on = {{ body = \"end\", at = \"center\" }} }}]\n\
         analysis = {{ kind = \"dynamics\", duration = {duration}, step = {step}, scheme = {{ spectral_radius = 0.8 }} }}\n{more}"
    ))
}

/// A restart changes the motion by an error of second order in the step, as the steps themselves.
#[test]
fn restarts_converge_with_the_steps() {
    let difference = |step: f64| {
        let first = Simulation::new(&pendulum(0.2, step, "")).unwrap();
        let (half, complete) = (run(&first), run(&Simulation::new(&pendulum(0.4, step, "")).unwrap()));
        let (rest, summary) = run_from(&pendulum(0.2, step, ""), &first, half.states.last().unwrap());
        let Some(InitialReport::Given { moved, corrected, source }) = summary.initial else {
            panic!("a report")
        };
        assert!(moved < 1e-9 && corrected < 1e-4 && source == "the state before", "{moved} {corrected}");
        assert_eq!(rest.column("p.z")[0].to_bits() >> 16, half.last("p.z").to_bits() >> 16);
        assert!((rest.column("hinge.angle")[0] - half.last("hinge.angle")).abs() < 1e-9);
        assert!((rest.column("kinetic")[0] / half.last("kinetic") - 1.0).abs() < 1e-3);
        (rest.last("p.z") - complete.last("p.z")).abs()
    };
    let [coarse, fine] = [4e-3, 1e-3].map(difference);
    assert!(coarse < 1e-3, "{coarse:e}");
    assert!(fine < coarse / 10.0, "{coarse:e} and {fine:e}");
}

/// States do not depend on the units in which the equations are solved.
#[test]
fn units_of_the_solver_may_differ() {
    let first = Simulation::new(&pendulum(0.1, 2e-3, "")).unwrap();
    let scaled = Simulation::new(&pendulum(0.1, 2e-3, "scales = { kind = \"auto\" }\n")).unwrap();
    let (own, other) = (run(&first), run(&scaled));
    let model = pendulum(0.1, 2e-3, "");
    let (a, _) = run_from(&model, &first, own.states.last().unwrap());
    let (b, _) = run_from(&model, &scaled, other.states.last().unwrap());
    for name in ["p.x", "p.z", "p.vx", "p.vz", "hinge.angle"] {
        assert!((a.last(name) - b.last(name)).abs() < 1e-7, "{name}");
        assert!((b.column(name)[0] - other.last(name)).abs() < 1e-3, "{name}");
    }
}

/// A body that is beside its hinge is moved onto it, and its velocity is projected. The distance is reported.
#[test]
fn inconsistent_states_are_projected() {
    let body = |motion: &str, joints: &str| {
        parse(&format!(
            "bodies = [{{ kind = \"rigid\", name = \"r\", center = [0, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.3]{motion} }}]\n{joints}\
             probes = [{{ name = \"r\", on = {{ body = \"r\", at = \"center\" }} }}]\n\
             analysis = {{ kind = \"dynamics\", duration = 0.1, step = 0.01 }}\n"
        ))
    };
    let free = Simulation::new(&body(", motion = { velocity = [0, 0.1, 0] }", "")).unwrap();
    let moved = run(&free);
    let ball =
        "joints = [{ kind = \"spherical\", name = \"ball\", a = { body = \"r\", at = \"center\" } }]\n";
    let (_, summary) = run_from(&body("", ball), &free, moved.states.last().unwrap());
    let Some(InitialReport::Given { moved, corrected, .. }) = summary.initial else { panic!("a report") };
    assert!((moved - 0.01).abs() < 1e-12, "{moved}");
    assert!((corrected - 1.0).abs() < 1e-9, "{corrected}");
    assert!(
        summary.warnings.iter().any(|text| text.contains("moves a point by 0.01")),
        "{:?}",
        summary.warnings
    );
    assert!(summary.warnings.iter().any(|text| text.contains("100 % of the kinetic energy")));
}

/// Joints with other coordinates belong to another structure; other materials, loads and further joints do not.
#[test]
fn structures_are_compared() {
    let first = Simulation::new(&pendulum(0.02, 2e-3, "")).unwrap();
    let states = run(&first);
    let given = first.given_state(states.states.last().unwrap(), "the state before");
    let mut model = pendulum(0.02, 2e-3, "");
    model.gravity = [1.0, 0.0, 0.0];
    model.materials.get_mut("m").unwrap().young = 1e8;
    assert!(Simulation::new(&model).unwrap().start_from(&given).is_ok());
    let mut other = pendulum(0.02, 2e-3, "");
    let Joint::Revolute(hinge) = &mut other.joints[0] else { panic!("a hinge") };
    hinge.spring = None;
    let unsprung = Simulation::new(&other).unwrap();
    let state = run(&unsprung).states.pop().unwrap();
    let errors =
        Simulation::new(&model).unwrap().start_from(&unsprung.given_state(&state, "the state before"));
    let message = errors.unwrap_err().to_string();
    assert!(
        message.contains("the state before, which has 0 coordinates of joint \"hinge\", not 1"),
        "{message}"
    );
}

/// A flat plate has the mixed derivative zero in its reference state. Modes about the equilibrium of a state in other units are those
/// about the same equilibrium.
#[test]
fn equilibrium_of_a_thin_plate_is_given() {
    let plate = |analysis: &str, scales: &str| {
        parse(&format!(
            r#"{scales}
            materials.m = {{ young = 1.2e6, poisson = 0.3, density = 1000 }}
            bodies = [{{ kind = "shell", name = "s", elements = [3, 2], thickness = 0.1, material = "m",
              surface = {{ kind = "flat", corner = [0, 0, 0], side_u = [10, 0, 0], side_v = [1, 2, 0] }} }}]
            joints = [{{ kind = "support", name = "root", a = {{ body = "s", at = {{ edge = "u_start" }} }}, condition = "clamped" }}]
            loads = [{{ kind = "edge_force", body = "s", edge = "u_end", force = [0, 0, 2] }}]
            probes = [{{ name = "p", on = {{ body = "s", at = [1, 0.5] }} }}]
            analysis = {{ {analysis} }}"#
        ))
    };
    let modes = r#"kind = "modes", about = "equilibrium", count = 3"#;
    let statics = Simulation::new(&plate(r#"kind = "statics""#, "")).unwrap();
    let bent = run(&statics);
    assert!(bent.last("p.z") > 1.0, "a large deflection: {}", bent.last("p.z"));
    let model = plate(modes, r#"scales = { kind = "given", length = 0.01, time = 3, force = 700 }"#);
    let (given, _) = run_from(&model, &statics, bent.states.last().unwrap());
    let own = run(&Simulation::new(&plate(modes, "")).unwrap());
    for (given, own) in given.column("frequency").iter().zip(own.column("frequency")) {
        assert!((given / own - 1.0).abs() < 1e-6, "{given} and {own}");
    }
}
