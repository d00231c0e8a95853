//! Shells in a fluid: terminal velocity, angle of attack, energy balance, units and errors.

use ancf::record::Series;
use ancf::{Model, Scales, simulate};

use crate::common::assertions::{assert_near, assert_relative};

fn run(model: &Model) -> Series {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

fn parse(text: &str) -> Model {
    Model::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap_or_else(|| panic!("no column {name}")).last().unwrap()
}

/// A plate of 0.4 × 0.3 in the plane of x and y.
fn plate(kind: &str) -> String {
    let mesh = if kind == "shell" {
        "elements = [2, 2]\nsurface = { kind = \"flat\", corner = [0, 0, 0], side_u = [0.4, 0, 0], side_v = [0, 0.3, 0] }\n"
    } else {
        "mesh = { nodes = [[0, 0, 0], [0.4, 0, 0], [0.4, 0.3, 0], [0, 0.3, 0]], elements = [[0, 1, 2], [0, 2, 3]] }\n"
    };
    format!(
        "[[bodies]]\nkind = \"{kind}\"\nname = \"s\"\nthickness = 0.01\nmaterial = \"m\"\n{mesh}\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {} }}\n",
        if kind == "shell" { "[0.5, 0.5]" } else { "[0.2, 0.15, 0]" }
    )
}

/// Falling flat from rest, v = v_t tanh(g′t/v_t) with g′ = (ρₛ − ρ) h g/(ρₛh + ρa) and v_t² = 2 (ρₛ − ρ) h g/(ρ C_n).
#[test]
fn plates_fall_with_the_terminal_velocity() {
    for kind in ["shell", "shear_shell"] {
        let text = format!(
            "gravity = [0, 0, -10]\nmaterials.m = {{ density = 2000, young = 1e9 }}\n{}\
             [[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\ndensity = 800\ndrag = [1.2, 0.05]\nlift = 3\nadded_mass = 0.02\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.2\nstep = 1e-3\n",
            plate(kind)
        );
        let weight = (2000.0 - 800.0) * 0.01 * 10.0;
        let acceleration = weight / (2000.0 * 0.01 + 800.0 * 0.02);
        let terminal = f64::sqrt(2.0 * weight / (800.0 * 1.2));
        let speed = terminal * f64::tanh(acceleration * 0.2 / terminal);
        assert!(speed > 0.7 * terminal);
        assert_relative(kind, last(&run(&parse(&text)), "p.vz"), -speed, 2e-5);
    }
}

/// A stiff plate on a rigid holder in a current at the angle α: N = ½ρ w² A (C_n sin²α + C_l sin α cos α), T = ½ρ w² A C_t cos²α.
#[test]
fn plates_at_an_angle_have_drag_and_lift() {
    let (alpha, speed, area) = (0.3_f64, 4.0, 0.12);
    let text = format!(
        "materials.m = {{ density = 2000, young = 1e12 }}\n{}\
         [[joints]]\nkind = \"support\"\nname = \"j\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\n\
         condition = \"clamped\"\n\
         [[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\ndensity = 1.2\ndrag = [1.8, 0.02]\nlift = 6.2\n\
         current = [{}, 0, {}]\n[analysis]\nkind = \"statics\"\n",
        plate("shell"),
        speed * alpha.cos(),
        speed * alpha.sin()
    );
    let series = run(&parse(&text));
    let pressure = 0.5 * 1.2 * speed * speed * area;
    let normal = pressure * (1.8 * alpha.sin().powi(2) + 6.2 * alpha.sin() * alpha.cos());
    assert_relative("normal force", last(&series, "j.fz"), -normal, 2e-5);
    assert_relative("friction", last(&series, "j.fx"), -pressure * 0.02 * alpha.cos().powi(2), 5e-4);
}

/// A flag in a gust.
fn flag(step: f64) -> Model {
    parse(&format!(
        "materials.m = {{ density = 400, young = 2e6 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\nthickness = 0.005\nmaterial = \"m\"\nelements = [4, 2]\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [0.4, 0, 0.02], side_v = [0, 0.3, 0.05] }}\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [1, 1] }}\n\
         [[joints]]\nkind = \"support\"\nname = \"j\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\n\
         condition = \"clamped\"\n\
         [[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\ndensity = 1.2\ndrag = [1.5, 0.02]\nlift = 4\nadded_mass = 0.2\n\
         current = [6, 0, 3]\ntime = {{ kind = \"expression\", text = \"1 + 0.5*sin(9*t)\" }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 0.4\nstep = {step}\n\
         scheme = {{ spectral_radius = 1 }}\n"
    ))
}

/// The error of the energy balance is of second order in the step.
#[test]
fn energy_balance_of_a_flag_is_of_second_order() {
    let errors = [4e-3, 2e-3].map(|step| {
        let series = run(&flag(step));
        let largest = series.column("balance").unwrap().iter().map(|x| x.abs()).fold(0.0, f64::max);
        largest / last(&series, "work")
    });
    assert!(errors[1] < 0.35 * errors[0] && errors[1] < 1e-2, "{errors:?}");
}

/// Lengths, times and forces in other units.
#[test]
fn units_do_not_change_flags() {
    let (model, units) = (flag(4e-3), Scales { length: 0.037, time: 13.0, force: 2.9e5 });
    let (a, b) = (run(&model), run(&model.scaled(&units)));
    for column in ["p.x", "p.y", "p.z"] {
        assert_near(column, last(&b, column) * units.length, last(&a, column), 1e-8);
    }
    assert!((last(&a, "p.z") - 0.07).abs() > 0.01, "{}", last(&a, "p.z"));
}

/// Regions of a mesh may be in different fluids if they have no common element.
#[test]
fn regions_are_in_one_fluid_each() {
    let model = |elements: &str| {
        let mesh = plate("shear_shell").replace(
            "elements = [[0, 1, 2], [0, 2, 3]]",
            &format!("elements = [[0, 1, 2], [0, 2, 3]], groups = {{ a = {{ elements = [0] }}, b = {{ elements = {elements} }} }}"),
        );
        let load = |region: &str| {
            format!(
                "[[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\nregion = \"{region}\"\ndensity = 1\ndrag = [1, 0]\n"
            )
        };
        Model::parse(&format!(
            "materials.m = {{ density = 2000, young = 1e9 }}\n{mesh}{}{}[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\n",
            load("a"),
            load("b")
        ))
    };
    assert!(model("[1]").is_ok(), "{:?}", model("[1]").err());
    let error = model("[0, 1]").unwrap_err().to_string();
    assert!(error.contains("each body in one fluid, once"), "{error}");
}

/// A shell is in one fluid, and beams have another load.
#[test]
fn fluids_on_other_bodies_are_errors() {
    let error = |load: &str| {
        let text = format!(
            "materials.m = {{ density = 2000, young = 1e9 }}\n{}\
             [[bodies]]\nkind = \"mass\"\nname = \"w\"\ncenter = [0, 0, 1]\nmass = 1\n{load}\
             [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\n",
            plate("shell")
        );
        Model::parse(&text).unwrap_err().to_string()
    };
    let load = "[[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\ndensity = 1\ndrag = [1, 0]\n";
    for (found, expected) in [
        (error(&format!("{load}{load}")), "each body in one fluid, once"),
        (error(&load.replace("\"s\"", "\"w\"")), "a shell"),
        (
            error("[[loads]]\nkind = \"fluid\"\nbodies = [\"s\"]\ndensity = 1\ndrag = [1, 0]\n"),
            "surface_fluid",
        ),
        (
            error(&format!("{load}[[loads]]\nkind = \"base_acceleration\"\nacceleration = [1, 0, 0]\n")),
            "an accelerating ground in a model with a fluid",
        ),
    ] {
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}
