//! All kinds of joints, couplings and drives against closed forms.

use std::f64::consts::{PI, TAU};

use ancf::Model;
use ancf::model::ScaleChoice;
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{EquationsOfMotion, Level};
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::common::models::jointed_body::{DYNAMICS, STATICS, jointed_body};
use crate::common::models::parse;
use crate::common::solutions::{Run, SOLVER_COLUMNS, assert_same_columns};

/// Keys of all joints between one body and the ground, with the number of free motions.
const KINDS: [(&str, usize); 13] = [
    ("kind = \"clamp\"", 0),
    ("kind = \"revolute\"\naxis = [1, 2, 0.5]", 1),
    (
        "kind = \"revolute\"\naxis = [1, 2, 0.5]\ndrive = { angle = 2, time = { kind = \"sine\", frequency = 0.5 } }",
        0,
    ),
    ("kind = \"revolute\"\naxis = [1, 2, 0.5]\nfriction = { moment = 0.5, rate = 0.01 }", 1),
    ("kind = \"spherical\"", 3),
    ("kind = \"universal\"\naxis_a = [1, 0, 0.2]\naxis_b = [0, 1, 0.3]", 2),
    ("kind = \"cylindrical\"\naxis = [1, 2, 0.5]", 2),
    ("kind = \"cylindrical\"\naxis = [1, 2, 0.5]\ndrive = { rate = 3 }\nfeed = { speed = 0.2 }", 0),
    ("kind = \"prismatic\"\naxis = [1, 2, 0.5]", 1),
    ("kind = \"planar\"\nnormal = [0.1, 0.2, 1]", 3),
    ("kind = \"point_on_line\"\naxis = [1, 2, 0.5]", 4),
    ("kind = \"distance\"\nb = { point = [0, 0.3, 1] }", 5),
    (
        "kind = \"distance\"\nb = { point = [0, 0.3, 1] }\nchange = 0.2\ntime = { kind = \"sine\", frequency = 1 }",
        5,
    ),
];

/// Mobility of each joint.
#[test]
fn every_joint_leaves_its_free_motions() {
    for (keys, count) in KINDS {
        let assembly = parse(&(jointed_body(keys) + DYNAMICS)).assemble().unwrap();
        let free = assembly.free_motions(&assembly.rest()).unwrap();
        let words: Vec<_> = free.iter().map(ToString::to_string).collect();
        assert_eq!(free.len(), count, "{keys}: {words:?}");
    }
}

/// Asserts Euler's equation: the moment of the joint about the centre is the rate of R J Rᵀ ω.
fn assert_euler(keys: &str, run: &Run) {
    let inertia = Matrix3::new(0.05, 0.01, 0.0, 0.01, 0.07, 0.005, 0.0, 0.005, 0.06);
    let [e0, e1, e2, e3] = ["e0", "e1", "e2", "e3"].map(|name| run.column(&format!("center.{name}")));
    let turned = |k: usize| {
        let rotation = UnitQuaternion::new_normalize(Quaternion::new(e0[k], e1[k], e2[k], e3[k]));
        rotation.to_rotation_matrix().into_inner()
    };
    let (omega, force, moment) = (run.vectors("center.w"), run.vectors("joint.f"), run.vectors("joint.m"));
    let momentum = |k: usize| turned(k) * inertia * turned(k).transpose() * omega[k];
    for k in (100..1900).step_by(50) {
        let rate = (momentum(k + 1) - momentum(k - 1)) / 1e-3;
        let arm = turned(k) * Vector3::new(-0.4, -0.1, 0.2);
        let about = moment[k] + arm.cross(&force[k]);
        assert!((rate - about).norm() < 1e-2 * (1.0 + about.norm()), "{keys}, {k}: {about} for {rate}");
    }
}

/// Motion under gravity: constraints hold to rounding, joint forces obey Newton's law, the energy balance holds to the order
/// of the scheme.
#[test]
fn joint_forces_and_moments_obey_newton_and_euler() {
    for (keys, _) in KINDS {
        let text = String::from("gravity = [0, 0, -9.81]\n") + &jointed_body(keys) + DYNAMICS;
        let mut swing = parse(&text);
        if let Some(dynamics) = swing.analysis.dynamics_mut() {
            dynamics.step = ancf::model::Step::Fixed(5e-4);
        }
        let run = Run::of(&swing);
        assert_euler(keys, &run);
        let (force, acceleration) = (run.vectors("joint.f"), run.vectors("center.a"));
        for (k, (force, a)) in force.iter().zip(&acceleration).enumerate() {
            let expected = (a + Vector3::z() * 9.81) * 2.0;
            assert!(
                (force - expected).norm() < 1e-6 * (20.0 + expected.norm()),
                "{keys}, {k}: {force} {expected}"
            );
        }
        let (balance, size) = (run.largest("balance"), run.largest("kinetic").max(1.0));
        assert!(balance < 1e-3 * size, "{keys}: {balance:e} of {size}");
        let assembly = swing.assemble().unwrap();
        let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
        let scheme = SchemeCoefficients::generalized_alpha(0.8);
        let mut dynamics = TimeStepper::new(&assembly.system, scheme, newton, 4, assembly.rest());
        dynamics.restart(0.0).unwrap();
        let mut phi = vec![0.0; assembly.system.multipliers()];
        for k in 1..=500 {
            dynamics.advance(f64::from(k) * 2e-3).unwrap();
            assembly.system.constraints(dynamics.state(), Level::Position, &mut phi);
            assert!(phi.iter().all(|x| x.abs() < 1e-10), "{keys}: {phi:?}");
        }
    }
}

/// Joints without mobility carry the weight and its moment about the joint.
#[test]
fn fixed_joints_carry_the_weight() {
    let fixed = [
        "kind = \"clamp\"",
        "kind = \"revolute\"\naxis = [1, 2, 0.5]\ndrive = { rate = 1 }",
        "kind = \"cylindrical\"\naxis = [1, 2, 0.5]\ndrive = { rate = 1 }\nfeed = { speed = 1 }",
        "kind = \"prismatic\"\naxis = [1, 2, 0.5]\ndrive = { speed = 1 }",
    ];
    for keys in fixed {
        let run =
            Run::of(&parse(&(String::from("gravity = [1, 2, -9.81]\n") + &jointed_body(keys) + STATICS)));
        let weight = Vector3::new(1.0, 2.0, -9.81) * 2.0;
        let (force, moment) = (run.last_vector("joint.f"), run.last_vector("joint.m"));
        let expected = Vector3::new(0.4, 0.1, -0.2).cross(&weight);
        assert!((force + weight).norm() < 1e-9, "{keys}: {force:?}");
        assert!((moment + expected).norm() < 1e-9, "{keys}: {moment:?} for {expected}");
    }
}

/// A planar joint carries the weight and its moment.
#[test]
fn planar_joint_carries_the_weight_at_rest() {
    let gravity = "gravity = [0, 0, -10]\n".to_owned();
    let run = Run::of(&parse(
        &(gravity.clone() + &jointed_body("kind = \"planar\"\nnormal = [0, 0, 1]") + DYNAMICS),
    ));
    let (force, moment) = (run.vectors("joint.f"), run.vectors("joint.m"));
    assert!((force[500] - Vector3::new(0.0, 0.0, 20.0)).norm() < 1e-9, "{}", force[500]);
    // Moment about the origin of the weight at (0.4, 0.1).
    assert!((moment[500] - Vector3::new(2.0, -8.0, 0.0)).norm() < 1e-9, "{}", moment[500]);
}

/// Ratio of output to input velocity of a Cardan joint at the angle β: cos β/(1 − sin² β cos² θ).
#[test]
fn cardan_joint_has_its_velocity_ratio() {
    let (sin, cos) = 0.5_f64.sin_cos();
    let run = Run::of(&parse(&format!(
        r#"
bodies = [
  {{ kind = "rigid", name = "input", center = [-0.2, 0, 0], mass = 1, inertia = [0.01, 0.02, 0.02] }},
  {{ kind = "rigid", name = "output", center = [{x}, {y}, 0], mass = 1, inertia = [0.01, 0.01, 0.01] }},
]
joints = [
  {{ kind = "revolute", name = "bearing", a = {{ body = "input", at = [-0.4, 0, 0] }}, axis = [1, 0, 0], drive = {{ rate = 3 }} }},
  {{ kind = "universal", name = "cross", a = {{ body = "output", at = [0, 0, 0] }}, b = {{ body = "input", at = [0, 0, 0] }}, axis_a = [0, 0, 1], axis_b = [0, 1, 0] }},
  {{ kind = "point_on_line", name = "end", a = {{ body = "output", at = [{x}, {y}, 0] }}, axis = [{x}, {y}, 0] }},
]
probes = [{{ name = "out", on = {{ body = "output", at = "center" }}, record = ["rotation"] }}]
{DYNAMICS}"#,
        x = 0.4 * cos,
        y = 0.4 * sin,
    )));
    for (k, omega) in run.vectors("out.w").iter().enumerate().skip(20) {
        let angle = 3.0 * run.column("t")[k];
        assert!((run.column("bearing.angle")[k] - angle).abs() < 1e-9);
        let expected = 3.0 * cos / (1.0 - (sin * angle.cos()).powi(2));
        let found = omega.dot(&Vector3::new(cos, sin, 0.0));
        assert!((found - expected).abs() < 2e-4, "{k}: {found} for {expected}");
    }
}

/// Two gears of inertia 0.5 and 0.3, and a rack of mass 2 on the second.
fn gears(keys: &str) -> Model {
    parse(&format!(
        r#"
bodies = [
  {{ kind = "rigid", name = "first", center = [0, 0, 0], mass = 1, inertia = [0.3, 0.3, 0.5] }},
  {{ kind = "rigid", name = "second", center = [1, 0, 0], mass = 1, inertia = [0.2, 0.2, 0.3] }},
  {{ kind = "rigid", name = "rack", center = [1, 1, 0], mass = 2, inertia = [0.1, 0.1, 0.1] }},
]
joints = [
  {{ kind = "revolute", name = "one", a = {{ body = "first", at = "center" }}, axis = [0, 0, 1] {keys} }},
  {{ kind = "revolute", name = "two", a = {{ body = "second", at = "center" }}, axis = [0, 0, 1] }},
  {{ kind = "prismatic", name = "guide", a = {{ body = "rack", at = "center" }}, axis = [1, 0, 0] }},
]
couplings = [
  {{ name = "teeth", joints = [{{ joint = "one", factor = 1 }}, {{ joint = "two", factor = 2 }}] }},
  {{ name = "pinion", joints = [{{ joint = "two", factor = 1 }}, {{ joint = "guide", factor = -4 }}] }},
]
{DYNAMICS}"#
    ))
}

/// Gear ratios over ten turns, and the reflected inertia of all bodies at the motor.
#[test]
fn gear_train_keeps_its_ratios_and_reflects_inertia() {
    let driven = gears(&format!(", drive = {{ rate = {} }}", 20.0 * PI));
    let run = Run::of(&driven);
    assert!((run.last("one.angle") - 10.0 * TAU).abs() < 1e-9);
    assert!((run.last("two.angle") + 5.0 * TAU).abs() < 1e-9);
    assert!((run.last("guide.displacement") + 1.25 * TAU).abs() < 1e-9);
    // θ₁ = t³: the moment about the axis is (0.5 + 0.3/4 + 2/64) θ̈₁.
    let angle = r#", drive = { angle = 1, time = { kind = "expression", text = "t^3" } }"#;
    for scales in [ScaleChoice::None, ScaleChoice::Given { length: 0.3, force: 7.0, time: Some(0.2) }] {
        let run = Run::of(&Model { scales, ..gears(angle) });
        assert!((run.last("two.angle") + 0.5).abs() < 1e-9);
        assert!((run.last("guide.displacement") + 0.125).abs() < 1e-9);
        assert!((run.last("one.rate") - 3.0).abs() < 1e-4);
        let kinetic = 0.5 * (0.5 + 0.3 / 4.0 + 2.0 / 64.0) * 9.0;
        assert!((run.last("kinetic") - kinetic).abs() < 1e-3 * kinetic);
        assert!((run.last("work") - kinetic).abs() < 1e-3 * kinetic);
    }
}

/// Reactions of a Cardan joint and of a guide between sections of flexible beams follow from statics.
#[test]
fn joints_between_beams_transmit_static_reactions() {
    let text = |joint: &str| {
        format!(
            r#"
materials.steel = {{ density = 7850, young = 2e11 }}
sections.round = {{ kind = "circle", diameter = 0.05 }}
bodies = [
  {{ kind = "beam", name = "first", from = [0, 0, 0], to = [1, 0, 0], elements = 2, formulation = "linked", section = "round", material = "steel" }},
  {{ kind = "beam", name = "second", from = [1, 0, 0], to = [2, 0, 0], elements = 2, formulation = "linked", section = "round", material = "steel" }},
]
loads = [{{ kind = "force", on = {{ body = "second", at = "center" }}, force = [0, 10, 20] }}]
[[joints]]
kind = "clamp"
name = "left"
a = {{ body = "first", at = "start" }}
[[joints]]
kind = "clamp"
name = "right"
a = {{ body = "second", at = "end" }}
[[joints]]
name = "middle"
a = {{ body = "second", at = "start" }}
b = {{ body = "first", at = "end" }}
{joint}
{STATICS}"#
        )
    };
    // A Cardan joint transmits no moment about its axes, a guide no force along its axis.
    let cardan = Run::of(&parse(&text("kind = \"universal\"\naxis_a = [0, 1, 0]\naxis_b = [0, 0, 1]")));
    let guide = Run::of(&parse(&text("kind = \"prismatic\"\naxis = [0, 1, 0]")));
    for name in ["middle.my", "middle.mz"] {
        assert!(cardan.last(name).abs() < 1e-2, "{name}: {}", cardan.last(name));
    }
    assert!(guide.last("middle.fy").abs() < 1e-3, "{}", guide.last("middle.fy"));
    // Clamped-clamped beam with a joint in the middle: shear force 5/32 of a load at the quarter point.
    assert!((cardan.last("middle.fz") + 20.0 * 5.0 / 32.0).abs() < 1e-2, "{}", cardan.last("middle.fz"));
    for run in [&cardan, &guide] {
        let sum = run.last_vector("left.f") + run.last_vector("right.f");
        assert!((sum + Vector3::new(0.0, 10.0, 20.0)).norm() < 1e-6, "{sum}");
    }
}

/// Angles without a joint coordinate are continuous over full revolutions, from row to row.
#[test]
fn angles_are_counted_over_full_revolutions() {
    let bodies = jointed_body("kind = \"revolute\"\naxis = [0, 0, 1]");
    let load =
        "[[loads]]\nkind = \"moment\"\non = { body = \"body\", at = \"center\" }\nmoment = [0, 0, 8]\n";
    let run = Run::of(&parse(&(bodies + load + DYNAMICS)));
    let inertia = 0.06 + 2.0 * (0.4_f64.powi(2) + 0.1_f64.powi(2));
    assert!((run.last("joint.angle") - 4.0 / inertia).abs() < 1e-3, "{}", run.last("joint.angle"));
    // Directors that rotate by ω h in a step have an error of second order in ω h.
    let (rate, h) = (8.0 / inertia, 1e-3);
    assert!((run.last("joint.rate") - rate).abs() < rate * (rate * h).powi(2), "{}", run.last("joint.rate"));
}

/// Steps of almost half a revolution converge to the correct branch.
#[test]
fn large_steps_converge_to_the_correct_branch() {
    for rate in [20.0, 40.0, 60.0] {
        let keys = format!("kind = \"revolute\"\naxis = [0, 0, 1]\ndrive = {{ rate = {rate} }}");
        let text = jointed_body(&keys) + &DYNAMICS.replace("1e-3", "0.05");
        let run = Run::of(&parse(&text));
        for (t, center) in run.column("t").iter().zip(run.vectors("center.")) {
            let (sin, cos) = (rate * t).sin_cos();
            let expected = Vector3::new(0.4 * cos - 0.1 * sin, 0.4 * sin + 0.1 * cos, -0.2);
            assert!((center - expected).norm() < 1e-8, "{rate}: {center} for {expected} at {t}");
        }
    }
}

/// Motions of all joints.
#[test]
fn scales_do_not_change_the_motion() {
    let scales = ScaleChoice::Given { length: 0.03, force: 7e4, time: Some(0.013) };
    for (keys, _) in KINDS {
        let text = String::from("gravity = [0, 0, -9.81]\n") + &jointed_body(keys) + DYNAMICS;
        let (a, b) = (Run::of(&parse(&text)), Run::of(&Model { scales, ..parse(&text) }));
        assert_same_columns(keys, [&a, &b], &SOLVER_COLUMNS, 1.0, 1e-5);
    }
}

/// Prescribed translation of a body: the drive exerts m ẍ − m g and its moment, the orientation is constant.
#[test]
fn prescribed_translation_exerts_inertia_and_weight() {
    let keys = "kind = \"drive\"\ndisplacement = [0.1, 0, 0.2]\ntime = { kind = \"expression\", text = \"1 - cos(4*t)\" }";
    let text = String::from("gravity = [0, 0, -10]\n") + &jointed_body(keys) + DYNAMICS;
    let run = Run::of(&parse(&text));
    let (force, moment, center) = (run.vectors("joint.f"), run.vectors("joint.m"), run.vectors("center."));
    for (k, t) in run.column("t").iter().enumerate().skip(20) {
        let way = Vector3::new(0.1, 0.0, 0.2);
        let expected = (way * 16.0 * (4.0 * t).cos() + Vector3::z() * 10.0) * 2.0;
        let first = Vector3::new(0.4, 0.1, -0.2);
        assert!((center[k] - first - way * (1.0 - (4.0 * t).cos())).norm() < 1e-9, "at {t}");
        assert!((force[k] - expected).norm() < 1e-3 * expected.norm(), "{} for {expected} at {t}", force[k]);
        assert!((moment[k] - first.cross(&expected)).norm() < 1e-3 * expected.norm(), "at {t}");
    }
}

/// Model with all joints, keys and couplings.
#[test]
fn scales_do_not_change_a_model_with_every_key() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/joints.toml");
    let model = Model::read(path).unwrap();
    let scales = ScaleChoice::Given { length: 0.25, force: 1024.0, time: Some(0.125) };
    let (a, b) = (Run::of(&model), Run::of(&Model { scales, ..model.clone() }));
    assert_same_columns("joints.toml", [&a, &b], &SOLVER_COLUMNS, 1.0, 1e-6);
}
