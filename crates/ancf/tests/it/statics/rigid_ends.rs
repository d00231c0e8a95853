//! Equilibrium paths of beams with rigid bodies at their tips.

use ancf::record::Series;
use ancf::{Model, simulate};
use nalgebra::{Rotation3, Vector3};

const LENGTH: f64 = 0.8;
const WIDTH: f64 = 0.03;
const YOUNG: f64 = 7e10;
const FORCE: f64 = 3.0;

/// A cantilever along the x-axis of a frame with a rigid body at the tip. A force along −z acts on the body.
fn model(kind: &str, formulation: &str, turn: Rotation3<f64>, exchanged: bool) -> Model {
    let vector = |v: Vector3<f64>| format!("{:?}", <[f64; 3]>::from(turn * v));
    let (tip, up) = (vector(Vector3::x() * LENGTH), vector(Vector3::y()));
    let force = vector(Vector3::z() * -FORCE);
    let head = r#"{ body = "head", at = "center" }"#;
    let end = r#"{ body = "arm", at = "end" }"#;
    let [a, b] = if exchanged { [end, head] } else { [head, end] };
    let text = format!(
        r#"
        materials.alloy = {{ density = 2700, young = {YOUNG} }}
        sections.bar = {{ kind = "rectangle", height = {WIDTH}, width = {WIDTH} }}
        bodies = [
          {{ kind = "beam", name = "arm", from = [0, 0, 0], to = {tip}, up = {up}, elements = 3, formulation = "{formulation}", section = "bar", material = "alloy" }},
          {{ kind = "rigid", name = "head", center = {tip}, mass = 2, inertia = [0.01, 0.02, 0.02] }},
        ]
        joints = [
          {{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }},
          {{ kind = "clamp", name = "weld", a = {a}, b = {b} }},
        ]
        loads = [{{ kind = "force", on = {head}, force = {force} }}]
        probes = [{{ name = "tip", on = {head} }}]
        analysis = {{ kind = "{kind}" }}
        "#
    );
    Model::parse(&text).unwrap()
}

fn tip(model: &Model, turn: Rotation3<f64>) -> Vector3<f64> {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    let last = |name: &str| *series.column(name).unwrap().last().unwrap();
    turn.inverse() * Vector3::new(last("tip.x"), last("tip.y"), last("tip.z"))
}

/// The path ends in the equilibrium of statics, whose deflection is F L³/(3 E I) + F L/(k G A). It is that for any direction of
/// the beam, any formulation and any order of the ends.
#[test]
fn paths_reach_the_equilibria_of_statics() {
    let (area, second) = (WIDTH * WIDTH, WIDTH.powi(4) / 12.0);
    let bending = FORCE * LENGTH.powi(3) / (3.0 * YOUNG * second);
    let shear = FORCE * LENGTH / (5.0 / 6.0 * 0.5 * YOUNG * area); // ν = 0
    let turns = [
        Rotation3::identity(),
        Rotation3::from_euler_angles(0.0, 0.0, 0.5 * std::f64::consts::PI),
        Rotation3::from_euler_angles(0.4, -1.1, 0.7),
    ];
    for formulation in ["continuum", "enhanced", "linked", "quadratic"] {
        for turn in turns {
            for exchanged in [false, true] {
                let [path, statics] =
                    ["path", "statics"].map(|kind| tip(&model(kind, formulation, turn, exchanged), turn));
                let what = format!("{formulation}, {turn}, exchanged: {exchanged}");
                assert!((path - statics).norm() < 1e-9 * LENGTH, "{what}: {path} and {statics}");
                if matches!(formulation, "linked" | "quadratic") {
                    let found = -path.z / (bending + shear);
                    assert!((found - 1.0).abs() < 1e-5, "{what}: {found}");
                }
            }
        }
    }
}
