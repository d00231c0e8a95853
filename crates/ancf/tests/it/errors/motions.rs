//! Errors of motions: ratios of estimated and true errors, invariance, and what has no estimate.

use ancf::estimate::MotionErrors;
use ancf::record::Series;
use ancf::{Model, Simulation, simulate};

use super::{BODIES, CLAMPED, beam};
use crate::common::models::{files, parse};

/// Runs a motion with its errors, or without.
pub(super) fn run(text: &str, has_errors: bool) -> (Series, Option<MotionErrors>) {
    let mut model: Model = parse(text);
    model.output.errors = has_errors;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (series, summary.motion_errors)
}

/// Motion of the beam of [`beam`] in steps h.
fn motion(body: &str, elements: u32, rest: &str, h: f64) -> String {
    let statics = "kind = \"statics\"\n        stop = { rule = \"energy\", tolerance = 1e-12 }";
    let dynamics =
        format!("kind = \"dynamics\"\nduration = 0.8\nstep = {h:e}\nscheme = {{ spectral_radius = 0.8 }}");
    beam(body, elements, rest).replace(statics, &dynamics)
}

/// Root of the mean squares.
fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), x| (sum + x * x, count + 1.0));
    f64::sqrt(sum / count)
}

/// Ratio of the estimated error of a column to the difference from a reference with `factor` times as many rows, and the relative
/// size of this difference.
pub(super) fn ratio(found: &Series, fine: &Series, factor: usize, column: &str) -> [f64; 2] {
    let [value, error, exact] = [
        found.column(column).unwrap(),
        found.column(&format!("{column}_error")).unwrap(),
        fine.column(column).unwrap(),
    ];
    assert_eq!(factor * (value.len() - 1), exact.len() - 1);
    let differences = value.iter().enumerate().map(|(k, value)| exact[factor * k] - value);
    let amplitude = value.iter().map(|x| (x - value[0]).abs()).fold(0.0, f64::max);
    let size = rms(differences);
    [rms(error.iter().copied()) / size, size / amplitude]
}

/// The dropped cantilever of all formulations: errors of steps and mesh together.
#[test]
fn errors_of_free_vibrations() {
    let gravity = format!("gravity = [0, -9.81, 0]\n{CLAMPED}");
    let fine = run(&motion(BODIES[2], 24, &gravity, 1.25e-3), false).0;
    for (body, elements, h) in [
        (BODIES[1], 4, 5e-3),
        (BODIES[1], 8, 1e-2),
        (BODIES[2], 2, 1e-2),
        (BODIES[2], 4, 5e-3),
        (BODIES[3], 2, 1e-2),
        (BODIES[4], 3, 1e-2),
    ] {
        let (found, errors) = run(&motion(body, elements, &gravity, h), true);
        let [ratio, size] = ratio(&found, &fine, (h / 1.25e-3) as usize, "tip.y");
        assert!((0.5..2.0).contains(&ratio), "{body}, {elements}, {h}: {ratio} of {size}");
        let errors = errors.unwrap();
        assert!(errors.are_steps_known && errors.is_mesh_known && !errors.is_rough);
        assert_eq!(errors.values.iter().find(|value| value.column == "tip.y").map(|v| v.error), {
            found.column("tip.y_error").unwrap().last().copied()
        });
    }
}

/// Mass on a spring: ratio to the exact motion, for schemes of both orders and error-controlled steps.
#[test]
fn errors_of_an_oscillator() {
    // ω = √(k/m) = 20 rad/s.
    let model = |scheme: &str, step: &str| {
        format!(
            r#"bodies = [{{ kind = "rigid", name = "m", center = [1, 0, 0], mass = 2, inertia = [1, 1, 1],
                motion = {{ velocity = [1, 0, 0] }} }}]
            joints = [{{ kind = "prismatic", name = "guide", a = {{ body = "m", at = "center" }}, axis = [1, 0, 0],
                spring = {{ stiffness = 800 }} }}]
            probes = [{{ name = "p", on = {{ body = "m", at = "center" }} }}]
            analysis = {{ kind = "dynamics", duration = 2, step = {step}, scheme = {scheme} }}"#
        )
    };
    for (scheme, step) in [
        ("\"average_acceleration\"", "2e-3"),
        ("\"average_acceleration\"", "1e-2"),
        ("\"adams\"", "2e-4"),
        ("{ spectral_radius = 0.8 }", "5e-3"),
        ("{ spectral_radius = 0.0 }", "2e-3"),
        ("{ alpha = -0.1 }", "5e-3"),
        ("{ spectral_radius = 0.8 }", "{ tolerance = 1e-3 }"),
    ] {
        let (found, errors) = run(&model(scheme, step), true);
        let [t, x, error] = ["t", "p.x", "p.x_error"].map(|name| found.column(name).unwrap());
        let exact = |t: f64| 1.0 + (20.0 * t).sin() / 20.0;
        let size = rms(t.iter().zip(x).map(|(t, x)| exact(*t) - x));
        let left = rms(t.iter().zip(x).zip(error).map(|((t, x), error)| exact(*t) - x - error));
        assert!(left < 0.15 * size, "{scheme}, {step}: {left} of {size}");
        assert!(errors.unwrap().probes[0].mesh == 0.0);
    }
}

/// Mass that meets a stop, or pulls a rope taut, within a step: the errors state the steps without their kinks.
#[test]
fn kinks_of_force_laws_are_stated() {
    let rope =
        r#"kind = "spring", b = { point = [0, 0, 0] }, length = 1.05, stiffness = 800, tension_only = true"#;
    let stop = r#"kind = "prismatic", axis = [1, 0, 0], stops = { upper = 0.05, stiffness = 800, transition = 1e-3 }"#;
    let spring = r#"kind = "prismatic", axis = [1, 0, 0], spring = { stiffness = 800 }"#;
    for (joint, least) in [(rope, 2), (stop, 2), (spring, 0)] {
        let text = format!(
            r#"bodies = [{{ kind = "rigid", name = "m", center = [1, 0, 0], mass = 2, inertia = [1, 1, 1],
                motion = {{ velocity = [1, 0, 0] }} }}]
            joints = [{{ name = "j", a = {{ body = "m", at = "center" }}, {joint} }}]
            probes = [{{ name = "p", on = {{ body = "m", at = "center" }} }}]
            analysis = {{ kind = "dynamics", duration = 0.4, step = 4e-3, scheme = {{ spectral_radius = 0.8 }} }}"#
        );
        let errors = run(&text, true).1.unwrap();
        let kinked = errors.kinked_steps;
        assert!((least..=6).contains(&kinked) && (least > 0 || kinked == 0), "{joint}: {kinked}");
        let says =
            errors.sentence().contains(&format!("without the kinks of force laws in {kinked} steps, mesh"));
        assert_eq!(says, least > 0, "{}", errors.sentence());
    }
}

/// Mechanisms and joints: a double pendulum, a shaft that a drive spins up, and a robot arm.
#[test]
fn errors_of_mechanisms() {
    let text = |name: &str, step: f64, duration: f64| {
        let mut model = files::model(name);
        let dynamics = model.analysis.dynamics_mut().unwrap();
        dynamics.duration = duration;
        dynamics.step = ancf::model::Step::Fixed(step);
        model
    };
    let run = |mut model: Model, has_errors: bool| {
        model.output.errors = has_errors;
        let mut series = Series::new();
        assert!(simulate(&model, &mut series).unwrap().outcome.is_finished());
        series
    };
    for (name, step, duration, column) in [
        ("double_pendulum", 1e-3, 0.3, "tip.y"),
        ("double_pendulum", 1e-3, 0.3, "elbow.angle"),
        ("spin_up", 0.02, 10.0, "tip.y"),
        ("spherical_pendulum", 2e-3, 0.4, "tip.z"),
        ("rotor", 1e-4, 0.03, "middle.z"),
    ] {
        let found = run(text(name, step, duration), true);
        let mut fine = text(name, step / 4.0, duration);
        fine.bodies.iter_mut().for_each(|body| body.set_elements(2 * body.elements()));
        let [ratio, size] = ratio(&found, &run(fine, false), 4, column);
        assert!((0.3..3.0).contains(&ratio), "{name}, {column}: {ratio} of {size}");
    }
}

/// The estimate does not change the motion.
#[test]
fn motions_with_and_without_errors_are_equal() {
    let gravity = format!("gravity = [0, -9.81, 0]\n{CLAMPED}");
    let text = motion(BODIES[3], 3, &gravity, 4e-3);
    let [with, without] = [true, false].map(|has_errors| run(&text, has_errors).0);
    for (column, values) in without.columns() {
        assert!(with.column(column) == Some(values), "{column}");
    }
}

/// Straight flight has no errors.
#[test]
fn rigid_translations_are_exact() {
    let flight = |h: f64| {
        motion(BODIES[2], 3, "", h)
            .replace("name = \"b\"\n", "name = \"b\"\nmotion = { velocity = [1, 2, 3] }\n")
    };
    let (_, errors) = run(&flight(0.1), true);
    let errors = errors.unwrap();
    assert!(errors.probes[0].displacement > 1.0);
    assert!(errors.probes[0].steps + errors.probes[0].mesh < 1e-10, "{errors:?}");
}

/// Units and the direction of the world do not change relative errors.
#[test]
fn relative_errors_are_invariant() {
    let relative = |text: &str| run(text, true).1.unwrap().worst().unwrap().1;
    let own = relative(&motion(BODIES[2], 2, &format!("gravity = [0, -9.81, 0]\n{CLAMPED}"), 1e-2));
    let along_z = motion(BODIES[2], 2, &format!("gravity = [-9.81, 0, 0]\n{CLAMPED}"), 1e-2);
    let turned = relative(&along_z.replace("to = [1, 0, 0]", "to = [0, 0, 1]"));
    // Millimetres, tonnes, seconds: forces in N, stresses in MPa.
    let in_mm = motion(BODIES[2], 2, &format!("gravity = [0, -9810, 0]\n{CLAMPED}"), 1e-2)
        .replace("density = 1000, young = 1e9", "density = 1e-9, young = 1e3")
        .replace("height = 0.02, width = 0.02", "height = 20, width = 20")
        .replace("to = [1, 0, 0]", "to = [1000, 0, 0]");
    for other in [turned, relative(&in_mm)] {
        for (own, other) in own.iter().zip(other) {
            assert!((own / other - 1.0).abs() < 1e-4, "{own} {other}");
        }
    }
}

/// A joint within an element has no estimate of the mesh; the time steps have one.
#[test]
fn errors_that_are_not_known() {
    let inside = r#"gravity = [0, -9.81, 0]
        joints = [{ kind = "clamp", name = "root", a = { body = "b", at = 0.4 } }]"#;
    let (found, errors) = run(&motion(BODIES[2], 2, inside, 1e-2), true);
    let errors = errors.unwrap();
    assert!(errors.are_steps_known && !errors.is_mesh_known && errors.values.is_empty());
    assert!(errors.sentence().contains("mesh not known"), "{}", errors.sentence());
    assert!(found.column("tip.y_error").unwrap()[1..].iter().all(|error| error.is_nan()));
}

/// Each equilibrium of a load history has its errors.
#[test]
fn errors_of_all_increments() {
    let load = "loads = [{ kind = \"force\", on = { body = \"b\", at = \"end\" }, force = [0, 40, 0] }]";
    let text = beam(BODIES[2], 4, &format!("{CLAMPED}\n{load}"));
    let text = text.replace("kind = \"statics\"", "kind = \"statics\"\nfirst = 0.25\nlargest = 0.25");
    let at = |text: &str| {
        let mut model = parse(text);
        model.output.errors = true;
        let mut series = Series::new();
        let summary = simulate(&model, &mut series).unwrap();
        (series, summary.errors.unwrap())
    };
    let (series, last) = at(&text);
    let [load, error] = ["load", "tip.y_error"].map(|name| series.column(name).unwrap());
    let value = |errors: &ancf::estimate::DiscretisationErrors| super::of(errors, "tip.y")[1];
    assert_eq!(error.last().copied(), Some(value(&last)));
    let half = load.iter().position(|load| *load == 0.5).unwrap();
    let own = value(&at(&text.replace("[0, 40, 0]", "[0, 20, 0]")).1);
    assert!((error[half] / own - 1.0).abs() < 1e-3, "{} {own}", error[half]);
}

/// Errors have the units of their values.
#[test]
fn errors_are_columns_with_the_units_of_their_values() {
    let mut model = parse(&motion(BODIES[2], 2, CLAMPED, 0.1));
    model.output.errors = true;
    let columns = Simulation::new(&model).unwrap().columns();
    let dimension =
        |name: &str| columns.iter().find(|column| column.name == name).map(|column| column.dimension);
    for name in ["tip.x", "tip.z", "root.fx", "root.mz"] {
        assert_eq!(dimension(&format!("{name}_error")), dimension(name), "{name}");
        assert!(dimension(name).is_some());
    }
}

/// Damping of strains is no error of the mesh: the estimate of a driven, damped beam falls with the mesh as the error does.
#[test]
fn damping_is_no_error_of_the_mesh() {
    let force = format!(
        "{CLAMPED}\nloads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, force = [0, 1, 0], \
         time = {{ kind = \"sine\", frequency = 3 }} }}]"
    );
    let text = |body: &str, elements, rate: f64| {
        let damping = format!("young = 1e9, damping = {{ strain = {rate} }}");
        motion(body, elements, &force, 1e-2).replace("young = 1e9", &damping)
    };
    let quadratic = run(&text(BODIES[3], 3, 1e-2), true).1.unwrap();
    assert!(quadratic.are_steps_known && !quadratic.is_mesh_known);
    for (body, elements) in [(BODIES[1], 8), (BODIES[2], 3), (BODIES[4], 3)] {
        let mesh = |text: &str| run(text, true).1.unwrap().worst().unwrap().1[1];
        let [damped, free] = [1e-2, 0.0].map(|rate| mesh(&text(body, elements, rate)));
        assert!(damped < 3.0 * free, "{body}: {damped} with damping, {free} without");
    }
}

/// Beam of four elements with material damping, under extreme conditions of the estimate.
fn damped_beam(elements: u32, retardation: f64, rest: &str, [duration, step]: [f64; 2]) -> String {
    format!(
        "materials.s = {{ density = 1500, young = 5e8, poisson = 0.3, damping = {{ strain = {retardation:e} }} }}\n\
         sections.a = {{ kind = \"rectangle\", height = 0.02, width = 0.03 }}\n\
         bodies = [{{ kind = \"beam\", name = \"r\", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, section = \"a\", material = \"s\", motion = {{ spin = [0, 0, SPIN] }} }}]\n\
         {rest}\n\
         analysis = {{ kind = \"dynamics\", duration = {duration}, step = {step:e} }}\n"
    )
}

/// A constant pretension, which the tangents of the start do not contain, a damper whose moment decays within the first step, and
/// prescribed curvatures whose rate causes viscous moments. Before, the estimates were 800, 800 and 600 times the errors.
#[test]
fn errors_with_pretension_dampers_and_rates_of_prestrains() {
    let clamp = |end: &str| {
        format!("{{ kind = \"clamp\", name = \"{end}\", a = {{ body = \"r\", at = \"{end}\" }} }}")
    };
    let probe = |at: &str| format!("probes = [{{ name = \"p\", on = {{ body = \"r\", at = \"{at}\" }} }}]");
    let tension = format!(
        "joints = [{}, {}]\nloads = [{{ kind = \"prestrain\", body = \"r\", tension = 500.0 }}, {{ kind = \"distributed_force\", body = \"r\", force = [0, 3, 0], time = {{ kind = \"expression\", text = \"sin(40*t)\" }} }}]\n{}",
        clamp("start"),
        clamp("end"),
        probe("center")
    );
    let damper = format!(
        "joints = [{{ kind = \"revolute\", name = \"k\", a = {{ body = \"r\", at = \"start\" }}, axis = [0, 0, 1], spring = {{ damping = 5 }} }}]\n{}",
        probe("end")
    );
    let curvature = format!(
        "joints = [{}]\nloads = [{{ kind = \"prestrain\", body = \"r\", curvature = [0, 0.5, 0], time = {{ kind = \"expression\", text = \"sin(8*t)^2\" }} }}]\n{}",
        clamp("start"),
        probe("end")
    );
    for (rest, spin, retardation, [duration, step], fine, column, largest) in [
        (&tension, "0", 1e-3, [0.2, 4e-3], 4, "p.y", 4.0),
        (&damper, "3", 1e-3, [0.2, 2e-3], 4, "p.y", 40.0),
        (&curvature, "0", 2e-2, [0.4, 2e-3], 16, "p.z", 4.0),
    ] {
        let text =
            |elements, step| damped_beam(elements, retardation, rest, [duration, step]).replace("SPIN", spin);
        let (found, _) = run(&text(4, step), true);
        let reference = run(&text(fine, step / 8.0), false).0;
        let [ratio, size] = ratio(&found, &reference, 8, column);
        assert!((0.3..largest).contains(&ratio), "{column}: {ratio} of {size}");
    }
}
