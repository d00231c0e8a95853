//! Rigid bodies and point masses touch obstacles with their surfaces.

use ancf::record::Series;
use ancf::{Model, simulate};

/// Motion of a body of 2 kg under gravity 10 above an obstacle.
fn run(body: &str, obstacle: &str, key: &str, duration: f64) -> Series {
    let text = format!(
        r#"
        gravity = [0, 0, -10]
        bodies = [{{ name = "body", mass = 2, {body} }}]
        probes = [{{ name = "body", on = {{ body = "body", at = "center" }} }}]
        contacts = [{{ with = {{ {obstacle} }}, stiffness = 4e5, damping = 3{key} }}]
        analysis = {{ kind = "dynamics", duration = {duration}, step = 5e-4, scheme = {{ spectral_radius = 0.6 }} }}
        "#
    );
    let (model, mut series) = (Model::parse(&text).unwrap(), Series::new());
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{body}: {:?}", summary.outcome);
    series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

const PLANE: &str = r#"kind = "plane", point = [0, 0, 0], normal = [0, 0, 1]"#;
const BALL: &str =
    r#"kind = "rigid", center = [0, 0, 0.13], inertia = [0.01, 0.01, 0.01], surface = { radius = 0.12 }"#;

/// Depth d of a body of the length L under its weight 20 = k d²/(2δ) L.
fn depth(transition: f64, length: f64) -> f64 {
    (20.0 * 2.0 * transition / 4e5 / length).sqrt()
}

/// A ball and a point mass come to rest on a plane.
#[test]
fn balls_land_on_a_plane() {
    let mass = r#"kind = "mass", center = [0, 0, 0.13], surface = { radius = 0.12 }"#;
    for body in [BALL, mass] {
        let series = run(body, PLANE, ", transition = 0.002", 1.0);
        let z = 0.12 - depth(0.002, 0.24);
        assert!((last(&series, "body.z") - z).abs() < 2e-5, "{}", last(&series, "body.z"));
    }
}

/// A box lands on four corners.
#[test]
fn box_lands_on_its_corners() {
    let body = r#"kind = "rigid", center = [0, 0, 0.11], inertia = [0.01, 0.02, 0.02], surface = { edges = [0.4, 0.3, 0.2] }"#;
    let series = run(body, PLANE, ", transition = 0.002", 1.0);
    // Half of the corners carry the weight, each with an eighth of the diagonal.
    let diagonal = f64::sqrt(0.4 * 0.4 + 0.3 * 0.3 + 0.2 * 0.2);
    let z = 0.1 - depth(0.002, 0.5 * diagonal);
    assert!((last(&series, "body.z") - z).abs() < 2e-5, "{} not {z}", last(&series, "body.z"));
}

/// A ball that falls on top of a sphere and of a cylinder rests there or rolls off, but does not enter.
#[test]
fn balls_do_not_enter_spheres_and_cylinders() {
    let body = BALL.replace("[0, 0, 0.13]", "[0.01, 0, 0.63]");
    let sphere = r#"kind = "sphere", center = [0, 0, 0], radius = 0.5"#;
    let cylinder = r#"kind = "cylinder", point = [0, 0, 0], axis = [0, 1, 0], radius = 0.5"#;
    for obstacle in [sphere, cylinder] {
        let series = run(&body, obstacle, "", 0.5);
        let (x, z) = (series.column("body.x").unwrap(), series.column("body.z").unwrap());
        let nearest = x.iter().zip(z).map(|(x, z)| x.hypot(*z)).fold(f64::INFINITY, f64::min);
        assert!(nearest > 0.61, "{nearest}");
    }
    // Inside a hollow sphere it stays inside.
    let hollow = r#"kind = "sphere", center = [0, 0, 0.5], radius = 0.6, inside = true"#;
    let z = last(&run(BALL, hollow, "", 1.5), "body.z");
    assert!((z - 0.02).abs() < 5e-3, "{z}");
}

/// A contact that no body can touch, a rigid body without surface and a box on a cylinder are errors.
#[test]
fn contacts_without_effect_are_errors() {
    let model = |surface: &str, bodies: &str, obstacle: &str| {
        let text = format!(
            r#"
            bodies = [{{ kind = "rigid", name = "body", center = [0, 0, 1], mass = 1, inertia = [1, 1, 1]{surface} }}]
            contacts = [{{ with = {{ {obstacle} }}, stiffness = 1e5{bodies} }}]
            analysis = {{ kind = "dynamics", duration = 1, step = 1e-3 }}
            "#
        );
        Model::parse(&text).unwrap_err().to_string()
    };
    let cylinder = r#"kind = "cylinder", point = [0, 0, 0], axis = [0, 1, 0], radius = 0.5"#;
    for (found, expected) in [
        (model("", "", PLANE), "no body that can touch it"),
        (model("", r#", bodies = ["body"]"#, PLANE), "which is rigid and has no `surface`"),
        (model(", surface = { edges = [1, 1, 1] }", "", cylinder), "only the corners"),
        (model(", surface = { edges = [1, 1, 1] }", "", r#"kind = "bodies""#), "no body that can touch it"),
        (model(", surface = {}", "", PLANE), "a surface without size"),
        (model(", surface = { edges = [1, 0, 1] }", "", PLANE), "three numbers > 0"),
        (
            model(", surface = { edges = [1, 1, 1], points = [[0, 0, 0]] }", "", PLANE),
            "both `edges` and `points`",
        ),
    ] {
        assert!(found.contains(expected), "{found}");
    }
}
