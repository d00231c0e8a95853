//! Signals of force laws and sensors between places: controllers that read other parts of a model.

use ancf::record::Series;
use ancf::{Model, Simulation, Stepper};
use nalgebra::{DMatrix, Matrix5, Vector5};

use crate::common::models::parse;
use crate::runs::given_states::States;

const MASSES: [f64; 2] = [2.0, 3.0];

/// Two masses on guides along x. A law acts on the first one, a spring of stiffness 30 and damping 1 on the second one.
fn pair(law: &str, more: &str, step: f64) -> String {
    let body = |name: &str, y: f64, mass: f64, speed: f64| {
        format!(
            "{{ kind = \"rigid\", name = \"{name}\", center = [0, {y}, 0], mass = {mass}, inertia = [0.1, 0.2, 0.3], motion = {{ velocity = [{speed}, 0, 0] }} }}"
        )
    };
    let guide = |name: &str, body: &str, action: &str| {
        format!(
            "{{ kind = \"prismatic\", name = \"{name}\", a = {{ body = \"{body}\", at = \"center\" }}, axis = [1, 0, 0], {action} }}"
        )
    };
    format!(
        "bodies = [{}, {}]\njoints = [{}, {}]\n\
         probes = [{{ name = \"far\", on = {{ body = \"other\", at = \"center\" }} }}]\n\
         analysis = {{ kind = \"dynamics\", duration = 1, step = {step}, scheme = {{ spectral_radius = 0.8 }} }}\n{more}",
        body("own", 0.0, MASSES[0], 0.0),
        body("other", 1.0, MASSES[1], 1.0),
        guide("one", "own", law),
        guide("two", "other", "spring = { stiffness = 30, damping = 1 }"),
    )
}

fn run_model(model: &Model) -> Series {
    let mut states = States::default();
    let summary = Simulation::new(model).unwrap().run(&mut states).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    states.series
}

fn run(text: &str) -> Series {
    run_model(&parse(text))
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// Controller of the first mass that reads the second one, with a filter of the signal.
const CONTROLLER: &str = "force = { kind = \"expression\", text = \"-50*(x - y) - 4*(v - dy) - 8*z\", \
     states = [{ name = \"z\", rate = \"(y - z)/0.3\", size = 0.1 }], signals = [";

/// Matrix of the linear equations of x₁, x₂, z, v₁, v₂ with this controller.
fn exact_matrix() -> Matrix5<f64> {
    let [a, b] = MASSES;
    Matrix5::from_rows(&[
        [0.0, 0.0, 0.0, 1.0, 0.0].into(),
        [0.0, 0.0, 0.0, 0.0, 1.0].into(),
        [0.0, 1.0 / 0.3, -1.0 / 0.3, 0.0, 0.0].into(),
        [-50.0 / a, 50.0 / a, -8.0 / a, -4.0 / a, 4.0 / a].into(),
        [0.0, -30.0 / b, 0.0, 0.0, -1.0 / b].into(),
    ])
}

fn controlled(value: &str, rate: &str, step: f64) -> String {
    let signals = format!(
        "{CONTROLLER}{{ name = \"y\", value = \"{value}\" }}, {{ name = \"dy\", value = \"{rate}\" }}] }}"
    );
    pair(&signals, "", step)
}

/// The motion is that of the linear equations, with an error of second order, for signals of a joint and of a probe.
#[test]
fn controllers_read_other_bodies() {
    let exact = exact_matrix().exp() * Vector5::new(0.0, 0.0, 0.0, 0.0, 1.0);
    let error = |value: &str, rate: &str, step: f64| {
        let series = run(&controlled(value, rate, step));
        let names = ["one.displacement", "two.displacement", "one.z", "one.speed", "two.speed"];
        let found = names.map(|name| last(&series, name));
        (Vector5::from(found) - exact).amax()
    };
    for (value, rate) in [("two.displacement", "two.speed"), ("far.x", "far.vx")] {
        let [coarse, fine] = [0.01, 0.0025].map(|step| error(value, rate, step));
        assert!(coarse < 2e-3, "{coarse:e}");
        assert!(fine < coarse / 12.0, "{coarse:e} and {fine:e}");
    }
}

/// The linear model has the poles of the linear equations, without poles of the coordinates of states.
#[test]
fn linear_models_contain_signals_and_states() {
    for scales in ["", "scales = { kind = \"given\", length = 0.02, force = 30, time = 0.4 }\n"] {
        let text = format!("{scales}{}", controlled("two.displacement", "two.speed", 0.01));
        let mut stepper = Stepper::new(&parse(&text)).unwrap();
        let linear = stepper.linearise(&["one.z", "two.displacement", "one.z_rate"]).unwrap();
        assert_eq!(linear.a.shape(), (5, 5));
        let poles = |a: &DMatrix<f64>| {
            let mut poles: Vec<_> = a.complex_eigenvalues().iter().copied().collect();
            poles.sort_by(|p, q| p.re.total_cmp(&q.re).then(p.im.total_cmp(&q.im)));
            poles
        };
        let exact = exact_matrix();
        let exact = DMatrix::from_iterator(5, 5, exact.iter().copied());
        for (found, expected) in poles(&linear.a).into_iter().zip(poles(&exact)) {
            assert!((found - expected).norm() < 1e-6, "{found} and {expected}");
        }
        // The rate of the state is (y - z)/0.3.
        let row = |k: usize| linear.c.row(k).into_owned();
        let expected = (row(1) - row(0)) / 0.3;
        assert!((row(2) - expected).amax() < 1e-6 * row(2).amax(), "{}", linear.c);
        assert!(linear.state_of(&stepper).unwrap().amax() < 1e-12);
    }
}

/// Results do not depend on the units of the solver, nor on those of the model.
#[test]
fn signals_do_not_depend_on_units() {
    let text = controlled("far.x", "two.speed", 0.01);
    let own = parse(&text);
    let scaled =
        parse(&format!("{text}scales = {{ kind = \"given\", length = 0.02, force = 30, time = 0.4 }}\n"));
    let converted = own.scaled(&ancf::Scales { length: 0.5, time: 4.0, force: 0.25 });
    let [a, b, c] = [own, scaled, converted].map(|model| run_model(&model));
    for (name, unit) in [("one.displacement", 0.5), ("two.displacement", 0.5), ("one.z", 1.0)] {
        let expected = last(&a, name);
        assert!((last(&b, name) - expected).abs() < 1e-8 * expected.abs(), "{name}");
        assert!((last(&c, name) * unit - expected).abs() < 1e-8 * expected.abs(), "{name}");
    }
}

/// A body that tumbles freely, another one that hinges, and sensors between them.
const TUMBLING: &str = "gravity = [0, -9.81, 0]\n\
     bodies = [{ kind = \"rigid\", name = \"top\", center = [1, 0, 0], mass = 1, inertia = [0.3, 0.5, 0.7], motion = { spin = [0.3, 0.2, 9] } },\n\
     { kind = \"rigid\", name = \"arm\", center = [0, -0.5, 0], mass = 2, inertia = [0.2, 0.2, 0.2], motion = { velocity = [0.5, 0, 0], spin = [0, 0, 1] } }]\n\
     probes = [{ name = \"top\", on = { body = \"top\", at = [1.2, 0.1, 0] } }, { name = \"arm\", on = { body = \"arm\", at = [0, -1, 0] }, record = [\"motion\", \"rotation\"] }]\n\
     analysis = { kind = \"dynamics\", duration = 2, step = 2e-3, scheme = { spectral_radius = 0.9 } }\n";

fn sensors(more: &str) -> String {
    format!(
        "{TUMBLING}joints = [{{ kind = \"revolute\", name = \"pin\", a = {{ body = \"arm\", at = [0, 0, 0] }}, axis = [0, 0, 1] {more} }},\n\
         {{ kind = \"sensor\", name = \"gap\", a = {{ body = \"top\", at = [1.2, 0.1, 0] }}, b = {{ body = \"arm\", at = [0, -1, 0] }}, measure = \"distance\" }},\n\
         {{ kind = \"sensor\", name = \"rise\", a = {{ body = \"top\", at = [1.2, 0.1, 0] }}, b = {{ body = \"arm\", at = [0, -1, 0] }}, measure = \"displacement\", axis = [0, 2, 0] }},\n\
         {{ kind = \"sensor\", name = \"turn\", a = {{ body = \"top\", at = \"center\" }}, b = {{ point = [0, 0, 0] }}, measure = \"angle\", axis = [0, 0, 1] }},\n\
         {{ kind = \"sensor\", name = \"relative\", a = {{ body = \"top\", at = \"center\" }}, b = {{ body = \"arm\", at = \"center\" }}, measure = \"angle\", axis = [0, 0, 1] }}]\n"
    )
}

/// Sensors agree with the positions of probes, and their rates with differences.
#[test]
fn sensors_measure_distances_displacements_and_angles() {
    let series = run(&sensors(""));
    let column = |name: &str| series.column(name).unwrap().to_vec();
    let (gap, rise, turn) = (column("gap.length"), column("rise.displacement"), column("turn.angle"));
    let apart =
        |i: usize| ["x", "y", "z"].map(|c| column(&format!("top.{c}"))[i] - column(&format!("arm.{c}"))[i]);
    let angle = column("pin.angle");
    for i in [0, 300, 700, 1000] {
        let [x, y, z] = apart(i);
        assert!((gap[i] - (x * x + y * y + z * z).sqrt()).abs() < 1e-12, "{i}");
        // Along the y-axis of the arm, less its initial value 1.1.
        let along = -angle[i].sin() * x + angle[i].cos() * y;
        assert!((rise[i] - (along - 1.1)).abs() < 1e-9, "{i}: {} {}", rise[i], along - 1.1);
    }
    // The angle counts turns: about 9 rad/s for 2 s.
    assert!((turn[1000] - 18.0).abs() < 1.0, "{}", turn[1000]);
    let relative = column("relative.angle");
    for (name, rate, values) in [
        ("gap", "gap.speed", &gap),
        ("rise", "rise.speed", &rise),
        ("turn", "turn.rate", &turn),
        ("relative", "relative.rate", &relative),
    ] {
        let rates = column(rate);
        for i in [100, 500, 900] {
            let difference = (values[i + 1] - values[i - 1]) / 4e-3;
            assert!((rates[i] - difference).abs() < 5e-3 * (1.0 + rates[i].abs()), "{name} {i}");
        }
    }
    let forces = ["gap.fx", "turn.mz", "rise.my"].map(|name| column(name)[500]);
    assert_eq!(forces, [0.0; 3]);
    assert!(last(&series, "balance").abs() < 1e-3);
}

/// A law that reads an angle beyond a turn and a distance. A sensor that a law reads measures the same.
#[test]
fn laws_read_angles_with_turns_and_distances() {
    let law = |text: &str| {
        format!(
            ", moment = {{ kind = \"expression\", text = \"{text}\", signals = [{{ name = \"theta\", value = \"turn.angle\" }}, {{ name = \"d\", value = \"gap.length\" }}, {{ name = \"dd\", value = \"gap.speed\" }}, {{ name = \"omega\", value = \"turn.rate\" }}] }}"
        )
    };
    let idle = run(&sensors(&law("0*theta")));
    let (free, without) = (run(&sensors("")), |name: &str| name.to_owned());
    for name in ["turn.angle", "turn.rate", "relative.angle", "gap.length", "pin.angle"].map(without) {
        let (a, b) = (last(&idle, &name), last(&free, &name));
        // A coordinate satisfies its definition at the ends of steps; its rate does with an error of the order of the step squared.
        let tolerance = if name.ends_with("rate") { 1e-4 } else { 1e-9 };
        assert!((a - b).abs() < tolerance * (1.0 + b.abs()), "{name}: {a} and {b}");
    }
    // The reaction of the ground about the pin is the moment: that of the law on the arm.
    let series = run(&sensors(&law("0.3*theta - 2*d + 0.1*dd + 0.05*omega")));
    let at = |name: &str, i: usize| series.column(name).unwrap()[i];
    for i in [200, 600, 1000] {
        let expected = 0.3 * at("turn.angle", i) - 2.0 * at("gap.length", i)
            + 0.1 * at("gap.speed", i)
            + 0.05 * at("turn.rate", i);
        assert!((at("pin.mz", i) - expected).abs() < 1e-6, "{i}: {} {expected}", at("pin.mz", i));
    }
}

#[test]
fn errors_of_signals_have_their_places() {
    let law =
        |signals: &str| format!("force = {{ kind = \"expression\", text = \"-y\", signals = [{signals}] }}");
    let message = |signals: &str, more: &str| {
        let text = pair(&law(signals), more, 0.01);
        let model = match Model::parse(&text) {
            Ok(model) => model,
            Err(errors) => return errors.to_string(),
        };
        Simulation::new(&model).unwrap_err().to_string()
    };
    for unknown in ["far.q", "two.angle", "three.displacement", "kinetic", "far.ax"] {
        let text = message(&format!("{{ name = \"y\", value = \"{unknown}\" }}"), "");
        let expected = format!("joints[0].force.signals[0].value: found \"{unknown}\"");
        assert!(text.contains(&expected), "{text}");
    }
    let taken = message("{ name = \"y\", value = \"far.x\" }, { name = \"y\", value = \"far.y\" }", "");
    assert!(taken.contains("joints[0].force.signals[1].name: found \"y\", expected another name"), "{taken}");
    let y = "{ name = \"y\", value = \"far.x\" }";
    let errors = message(y, "output = { errors = true }\n");
    assert!(errors.contains("output.errors: found true"), "{errors}");
    let equilibrium = message(y, "initial = { from = \"equilibrium\" }\n");
    assert!(equilibrium.contains("joints[0].force.signals: found a law with signals"), "{equilibrium}");
    let distance = format!(
        "{TUMBLING}joints = [{{ kind = \"sensor\", name = \"s\", a = {{ body = \"top\", at = \"center\" }}, b = {{ body = \"arm\", at = \"center\" }}, measure = \"angle\" }}]\n"
    );
    let axis = Model::parse(&distance).unwrap_err().to_string();
    assert!(axis.contains("joints[0].axis: found no axis"), "{axis}");
}
