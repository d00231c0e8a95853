//! States at rest: statics from equilibria, motions of bodies that joints hold.

use ancf::record::Series;
use ancf::simulate;
use nalgebra::Vector3;

use super::sequences::{last, run_all};
use crate::common::models::parse;
use crate::common::random::Random;

/// A motion of a driven body without forces ends in its equilibrium. Statics from there changes nothing, alone and beside a sprung mass.
#[test]
fn statics_of_a_state_in_equilibrium_converges() {
    let sprung = [
        ", { kind = \"mass\", name = \"w\", center = [0, 2, 0], mass = 1 }",
        ", { kind = \"spring\", name = \"s\", a = { body = \"w\", at = \"center\" }, b = { point = [0, 0, 0] }, stiffness = 100, damping = 1 }",
        "loads = [{ kind = \"force\", on = { body = \"w\", at = \"center\" }, force = [0, 5, 0] }]",
    ];
    for [mass, spring, load] in [[""; 3], sprung] {
        let runs = run_all(&format!(
            r#"
bodies = [{{ kind = "rigid", name = "b", center = [0.3, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }}{mass}]
joints = [{{ kind = "revolute", name = "h", a = {{ body = "b", at = [0, 0, 0] }}, axis = [0, 0, 1], drive.rate = 2.0 }}{spring}]
{load}
probes = [{{ name = "b", on = {{ body = "b", at = "center" }} }}]
analysis = [{{ kind = "dynamics", name = "turn", duration = 0.8, step = 1e-3 }}, {{ kind = "statics" }}]
"#
        ));
        let [before, after] = [0, 1].map(|k| ["b.x", "b.y"].map(|name| last(&runs[k].0, name)));
        for (before, after) in before.iter().zip(after) {
            assert!((before - after).abs() < 1e-12, "{before} {after}");
        }
    }
}

/// Rigid bodies that joints hold under their weight: the only energies are rounding errors. A motor that begins later, two hinges, three
/// ball joints, and a drive about and along an axis.
#[test]
fn held_bodies_rest_without_warnings() {
    let mut random = Random(11);
    for case in 0..10 {
        let [center, place, axis, far, farther] = std::array::from_fn(|_| random.vector3() * 2.0);
        let list = |x: Vector3<f64>| format!("[{}, {}, {}]", x.x, x.y, x.z);
        let at = |x: Vector3<f64>| format!("a = {{ body = \"arm\", at = {} }}", list(x));
        let later = "time = { kind = \"ramp\", start = 0.1, end = 0.2 }";
        let hinge = |name: &str, place, axis, drive: &str| {
            format!(
                "{{ kind = \"revolute\", name = \"{name}\", {}, axis = {}{drive} }}",
                at(place),
                list(axis)
            )
        };
        let ball =
            |name: &str, place| format!("{{ kind = \"spherical\", name = \"{name}\", {} }}", at(place));
        let joints = [
            hinge("motor", place, axis, &format!(", drive = {{ angle = 1, {later} }}")),
            format!("{}, {}", hinge("a", place, axis, ""), hinge("b", place + axis, axis + far, "")),
            format!("{}, {}, {}", ball("a", place), ball("b", place + axis), ball("c", place + farther)),
            format!(
                "{{ kind = \"cylindrical\", name = \"screw\", {}, axis = {}, drive = {{ angle = 1, {later} }}, feed = {{ displacement = 1, {later} }} }}",
                at(place),
                list(axis)
            ),
        ];
        for joints in joints {
            let model = parse(&format!(
                "gravity = [0, 0, -9.81]\n\
                 bodies = [{{ kind = \"rigid\", name = \"arm\", center = {}, mass = 1, inertia = [0.1, 0.2, 0.15], products = [0.01, 0.02, -0.01] }}]\n\
                 joints = [{joints}]\nanalysis = {{ kind = \"dynamics\", duration = 0.05, step = 1e-3 }}\n",
                list(center)
            ));
            let summary = simulate(&model, &mut Series::new()).unwrap();
            assert!(summary.outcome.is_finished(), "{case}, {joints}: {:?}", summary.outcome);
            let of_energy = summary.warnings.iter().find(|text| text.contains("energy"));
            assert!(of_energy.is_none(), "{case}, {joints}: {of_energy:?}");
            assert!(
                summary.iterations <= 250,
                "{case}, {joints}, {center:?}: {} iterations",
                summary.iterations
            );
        }
    }
}
