//! Hinge angles count turns in every step, for any output.

use ancf::{Model, Summary};

use super::recorder::{Recorder, read, resumed, run};
use super::sequences::{last, run_all};
use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;

const SCHEME: &str = "scheme = { spectral_radius = 0.8 }";

/// Wheel on a hinge with a spin about the axis, in rad/s, for 3 s.
fn wheel(spin: f64, output: &str, step: &str) -> Model {
    parse(&format!(
        "bodies = [{{ kind = \"rigid\", name = \"wheel\", center = [0, 0, 0], mass = 3, inertia = [0.02, 0.03, 0.04], \
         motion = {{ spin = [0, {spin}, 0] }} }}]\n\
         joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"wheel\", at = \"center\" }}, axis = [0, 1, 0] }}]\n\
         {output}\n[analysis]\nkind = \"dynamics\"\nduration = 3\nstep = {step}\n{SCHEME}\n"
    ))
}

fn column(recorder: &Recorder, name: &str) -> Vec<f64> {
    let at = recorder.columns.iter().position(|column| column == name).unwrap();
    recorder.rows.iter().map(|row| f64::from_bits(row[at])).collect()
}

fn last_angle((recorder, summary): &(Recorder, Summary)) -> f64 {
    assert!(summary.outcome.is_finished() && summary.warnings.is_empty(), "{summary:?}");
    *column(recorder, "hinge.angle").last().unwrap()
}

/// Free wheel: the angle is ω t, also if a row follows after many turns.
#[test]
fn angles_do_not_depend_on_the_output_interval() {
    for spin in [26.0, -31.0] {
        let every_step = last_angle(&run(&wheel(spin, "", "2e-3"), false));
        // Phase error ω³h²t/12 of the scheme, with a factor of less than 3.
        let error = 3.0 * spin.powi(3).abs() * 4e-6 * 3.0 / 12.0;
        assert_near("each step", every_step, 3.0 * spin, error);
        for interval in [0.24, 0.3, 0.75, 1.5, 3.0] {
            let run = run(&wheel(spin, &format!("output = {{ interval = {interval} }}"), "2e-3"), false);
            for (t, angle) in column(&run.0, "t").into_iter().zip(column(&run.0, "hinge.angle")) {
                assert_near(&format!("interval {interval}, t = {t}"), angle, spin * t, error);
            }
            assert_near("last row", last_angle(&run), every_step, 1e-9);
        }
    }
}

#[test]
fn angles_count_turns_in_error_controlled_steps() {
    let run = run(&wheel(-23.0, "output = { interval = 0.6 }", "{ tolerance = 1e-3 }"), false);
    assert_near("angle", last_angle(&run), -69.0, 0.02);
}

#[test]
fn angles_of_resumed_runs_count_all_turns() {
    let model = wheel(19.0, "output = { interval = 1.1 }", "5e-3");
    let whole = run(&model, true);
    assert_near("angle", last_angle(&whole), 57.0, 0.2);
    for from in whole.0.checkpoints.iter().step_by(97) {
        let rest = resumed(&model, from);
        assert!(rest.0.rows == whole.0.rows[read(from).rows() as usize..], "at t = {}", read(from).time());
        assert_eq!(rest.1, whole.1);
    }
}

/// Wheel that falls from rest under the constant torque T: θ = T t²/2J, the rate grows within the output intervals.
#[test]
fn angles_of_accelerated_wheels_count_turns() {
    let (torque, inertia) = (-0.7, 0.03);
    let text = format!(
        "bodies = [{{ kind = \"rigid\", name = \"wheel\", center = [0, 0, 0], mass = 3, inertia = [0.02, {inertia}, 0.04] }}]\n\
         joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"wheel\", at = \"center\" }}, axis = [0, 1, 0] }}]\n\
         loads = [{{ kind = \"moment\", on = {{ body = \"wheel\", at = \"center\" }}, moment = [0, {torque}, 0] }}]\n\
         output = {{ interval = 0.9 }}\n[analysis]\nkind = \"dynamics\"\nduration = 2.7\nstep = 1e-3\n{SCHEME}\n"
    );
    let run = run(&parse(&text), false);
    for (t, angle) in column(&run.0, "t").into_iter().zip(column(&run.0, "hinge.angle")) {
        assert_near(&format!("t = {t}"), angle, 0.5 * torque / inertia * t * t, 0.1);
    }
}

/// Arm on a driven hinge, with a second hinge that only measures.
fn turned(angle: f64, first: &str) -> Model {
    let hinge = "kind = \"revolute\"\na = { body = \"arm\", at = [0, 0, 0] }\naxis = [0, 0, 1]\n";
    parse(&format!(
        "bodies = [{{ kind = \"rigid\", name = \"arm\", center = [0.2, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }}]\n\
         [[joints]]\nname = \"motor\"\n{hinge}drive = {{ angle = {angle} }}\n[[joints]]\nname = \"hinge\"\n{hinge}\
         [analysis]\nkind = \"statics\"\nfirst = {first}\n"
    ))
}

/// In statics the angle grows with the load factor, over many turns.
#[test]
fn angles_in_statics_count_turns() {
    for (angle, first) in [(2.0, "1"), (-1.5, "0.3"), (5.0, "0.3"), (-7.5, "0.1"), (20.0, "0.02")] {
        let run = run(&turned(angle, first), false);
        for (load, turned) in column(&run.0, "load").into_iter().zip(column(&run.0, "hinge.angle")) {
            assert_near(&format!("{angle} rad, load factor {load}"), turned, load * angle, 1e-9);
        }
        assert_near("last", last_angle(&run), angle, 1e-9);
    }
}

/// Turns along a path follow from the difference quotient of the last step.
#[test]
fn angles_along_paths_count_turns() {
    for angle in [5.0, -20.0] {
        let mut model = turned(angle, "1");
        let path = "[analysis]\nkind = \"path\"\nload = 1\nfirst = 0.02\nlargest = 0.05\n";
        let mass = "bodies = [{ kind = \"mass\", name = \"m\", center = [9, 0, 0], mass = 3 }]\n";
        model.analysis = parse(&format!("{mass}{path}")).analysis;
        assert_near("angle", last_angle(&run(&model, false)), angle, 1e-9);
    }
}

/// Flywheel with the spin w on a torsion spring of frequency 10 rad/s with the damping ratio 0.05: the angle never exceeds w/10 or the
/// run fails, although the hinge has an equilibrium in each turn.
#[test]
fn counted_angles_do_not_jump_by_turns() {
    for (spin, step) in [(50.0, "1e-3"), (80.0, "2e-2"), (100.0, "3e-2"), (120.0, "5e-2")] {
        let text = format!(
            "bodies = [{{ kind = \"rigid\", name = \"wheel\", center = [0, 0, 0], mass = 1, inertia = [0.02, 0.02, 0.02], \
             motion = {{ spin = [0, 0, {spin}] }} }}]\n\
             joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"wheel\", at = \"center\" }}, axis = [0, 0, 1], \
             spring = {{ stiffness = 2, damping = 0.02 }} }}]\n\
             [analysis]\nkind = \"dynamics\"\nduration = 2\nstep = {step}\nscheme = {{ spectral_radius = 0.3 }}\n"
        );
        let (recorder, summary) = run(&parse(&text), false);
        let largest = column(&recorder, "hinge.angle").iter().fold(0.0_f64, |x, angle| x.max(angle.abs()));
        let is_right = largest < 0.1 * spin * 1.05;
        assert!(
            is_right || !summary.outcome.is_finished(),
            "spin {spin}, step {step}: {largest}, {summary:?}"
        );
        assert!(is_right || step != "1e-3", "spin {spin}, step {step}: {largest}");
    }
}

/// Steps of more than half a turn, with a rate that the scheme does not resolve, give a warning.
#[test]
fn ambiguous_turns_give_a_warning() {
    let (_, summary) = run(&wheel(30.0, "", "0.2"), false);
    let warning = summary.warnings.join(" ");
    assert!(warning.contains("`hinge`") && warning.contains("ambiguous"), "{summary:?}");
}

/// Statics that starts in an equilibrium does not move, whatever the angle of a drive: angles of hinges and sensors remain, also over
/// several analyses, and no number of turns is ambiguous.
#[test]
fn statics_from_a_state_keeps_the_turns() {
    for angle in [0.5, 2.0, 3.2, 6.0, -9.0, 20.0] {
        let runs = run_all(&format!(
            r#"
bodies = [{{ kind = "rigid", name = "r", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }}]
joints = [
  {{ kind = "revolute", name = "d", a = {{ body = "r", at = "center" }}, axis = [0, 0, 1], drive = {{ angle = {angle} }} }},
  {{ kind = "sensor", name = "sn", a = {{ body = "r", at = "center" }}, b = "ground", measure = "angle", axis = [0, 0, 1] }},
]
analysis = [{{ name = "one", kind = "statics" }}, {{ name = "two", kind = "statics" }}, {{ name = "three", kind = "statics" }}]
"#
        ));
        for (series, summary) in &runs {
            for name in ["d.angle", "sn.angle"] {
                assert_relative(name, last(series, name), angle, 1e-9);
            }
            assert!(summary.warnings.is_empty(), "{angle}: {:?}", summary.warnings);
        }
    }
}
