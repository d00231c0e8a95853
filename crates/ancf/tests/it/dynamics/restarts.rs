//! Restarts and starts of flexible parts that rotate: reactions of sections that joints hold, with stiff and damped strains.

use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Steel arm of 0.9 m that is clamped to a hub of 1 kg on a hinge, with a retardation time of its strains.
fn hub(retardation: f64, joint: &str, load: &str, analysis: &str) -> Run {
    Run::of(&parse(&format!(
        r#"
        materials.steel = {{ density = 7850, young = 2.1e11, poisson = 0.3, damping = {{ strain = {retardation} }} }}
        sections.flat = {{ kind = "rectangle", height = 0.01, width = 0.02 }}
        bodies = [
          {{ kind = "rigid", name = "hub", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }},
          {{ kind = "beam", name = "arm", from = [0.1, 0, 0], to = [1, 0, 0], elements = 4, section = "flat", material = "steel" }},
        ]
        joints = [
          {{ kind = "revolute", name = "hinge", a = {{ body = "hub", at = "center" }}, axis = [0, 0, 1]{joint} }},
          {{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }}, b = {{ body = "hub", at = [0.1, 0, 0] }} }},
        ]
        {load}
        probes = [{{ name = "tip", on = {{ body = "arm", at = "end" }} }}]
        analysis = {{ kind = "dynamics", {analysis} }}
        "#
    )))
}

fn moment(time: &str) -> String {
    format!(
        r#"loads = [{{ kind = "moment", on = {{ body = "hub", at = "center" }}, moment = [0, 0, 10], follower = true, time = {time} }}]"#
    )
}

/// Largest force and moment of the root.
fn largest(run: &Run) -> [f64; 2] {
    ["f", "m"].map(|kind| {
        let [x, y, z] = ["x", "y", "z"].map(|axis| run.column(&format!("root.{kind}{axis}")));
        let sizes = (0..x.len()).map(|i| (x[i].powi(2) + y[i].powi(2) + z[i].powi(2)).sqrt());
        sizes.fold(0.0, f64::max)
    })
}

/// A table with points in each step restarts the integration. A constant table is a constant moment.
#[test]
fn restarts_do_not_change_a_motion() {
    let analysis = "duration = 0.6, step = 2e-3";
    let times: Vec<String> = (0..=300).map(|i| format!("{:.3}", 0.002 * f64::from(i))).collect();
    let table = format!(
        r#"{{ kind = "table", times = [{}], values = [{}] }}"#,
        times.join(", "),
        vec!["1"; times.len()].join(", ")
    );
    for retardation in [0.0, 1e-3] {
        let reference = hub(retardation, "", &moment("1"), analysis);
        let run = hub(retardation, "", &moment(&table), analysis);
        let [force, torque] = largest(&reference);
        let [ours, own] = largest(&run);
        assert!(force > 50.0 && force < 200.0, "{force}");
        assert_relative("force", ours, force, 1e-2);
        assert_relative("moment", own, torque, 1e-2);
        assert_relative("angle", run.last("hinge.angle"), reference.last("hinge.angle"), 2e-4);
        assert_relative("energy", run.last("kinetic"), reference.last("kinetic"), 1e-3);
    }
}

/// Jumps of a moment and kinks of a drive: reactions are those of steps of a quarter, in each row.
#[test]
fn reactions_after_jumps_converge() {
    let jump = moment(r#"{ kind = "step", at = 0.1, until = 0.3 }"#);
    let drive = r#", drive = { rate = 5, time = { kind = "ramp", start = 0, end = 0.1 } }"#;
    for (retardation, joint, load) in [(1e-2, "", jump.as_str()), (0.0, "", jump.as_str()), (1e-3, drive, "")]
    {
        for scheme in ["{ spectral_radius = 0.6 }", "{ spectral_radius = 0.9 }"] {
            let of = |step: f64| {
                let analysis = format!(
                    "duration = 0.4, step = {step}, scheme = {scheme}, energy_guard = {{ loss = 1 }}"
                );
                largest(&hub(retardation, joint, load, &analysis))
            };
            let ([force, torque], [fine, other]) = (of(2e-3), of(5e-4));
            let what = format!("{retardation}, {joint}, {scheme}");
            assert!(force < 1.1 * fine && force > 0.9 * fine, "{what}: {force}, not {fine}");
            assert!(torque < 1.1 * other && torque > 0.9 * other, "{what}: {torque}, not {other}");
        }
    }
}

/// A bar with a rigid body at its end rotates about their common center without loads: N = m ω² r, and no moment.
#[test]
fn steady_rotations_start_without_moments() {
    for (elements, retardation, step) in [(4, 1e-2, 1e-3), (8, 1e-2, 1e-3), (1, 1e-3, 2e-3), (4, 0.0, 1e-3)] {
        let run = Run::of(&parse(&format!(
            r#"
            materials.steel = {{ density = 7850, young = 2.1e11, poisson = 0.3, damping = {{ strain = {retardation} }} }}
            sections.flat = {{ kind = "rectangle", height = 0.01, width = 0.02 }}
            bodies = [
              {{ kind = "beam", name = "bar", from = [0.1, 0, 0], to = [1, 0, 0], elements = {elements}, section = "flat", material = "steel", motion = {{ spin = [0, 0, 10], about = [0, 0, 0] }} }},
              {{ kind = "rigid", name = "body", center = [1.1, 0, 0], mass = 0.5, inertia = [0.01, 0.01, 0.01], motion = {{ spin = [0, 0, 10], about = [0, 0, 0] }} }},
            ]
            joints = [{{ kind = "clamp", name = "root", a = {{ body = "body", at = [1, 0, 0] }}, b = {{ body = "bar", at = "end" }} }}]
            analysis = {{ kind = "dynamics", duration = 0.1, step = {step} }}
            "#
        )));
        let mass = 7850.0 * 0.9 * 2e-4;
        let radius = 1.1 - (mass * 0.55 + 0.5 * 1.1) / (mass + 0.5);
        let [force, torque] = largest(&run);
        let what = format!("{elements} elements, {retardation}");
        // Without damping the bar vibrates along its axis.
        let tolerance = if retardation > 0.0 { 0.01 } else { 0.1 };
        assert_relative(&what, force, 0.5 * 100.0 * radius, tolerance);
        assert!(torque < 0.1, "{what}: moment {torque}");
        assert_near(&what, run.last("kinetic") + run.last("strain"), run.column("kinetic")[0], 1e-3);
    }
}

/// Damping forces that make energy are stated: initial velocities that break a joint, in steps too long for their decay.
#[test]
fn energy_of_damping_forces_is_stated() {
    let text = |step: f64| {
        format!(
            r#"
            materials.steel = {{ density = 7850, young = 2.1e11, poisson = 0.3, damping = {{ strain = 0.02 }} }}
            sections.flat = {{ kind = "rectangle", height = 0.01, width = 0.02 }}
            bodies = [{{ kind = "beam", name = "bar", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "flat", material = "steel", motion = {{ velocity = [0, 0.5, 0] }} }}]
            joints = [{{ kind = "clamp", name = "root", a = {{ body = "bar", at = "start" }} }}]
            analysis = {{ kind = "dynamics", duration = 0.1, step = {step} }}
            "#
        )
    };
    let run = Run::of(&parse(&text(4e-3)));
    let kinetic = run.column("kinetic");
    let energy: Vec<f64> = kinetic.iter().zip(run.column("strain")).map(|(a, b)| a + b).collect();
    let largest = energy.iter().copied().fold(0.0, f64::max);
    let is_stated = run.summary.warnings.iter().any(|one| one.contains("the integration has made"));
    assert!(
        largest < 1.05 * energy[0] || is_stated,
        "{largest} of {}: {:?}",
        energy[0],
        run.summary.warnings
    );
}
