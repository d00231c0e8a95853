//! Statics from states that are in equilibrium already.

use super::sequences::{last, run_all};

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
