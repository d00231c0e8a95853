//! Motions that nothing holds, by name.

use ancf::Model;
use ancf::analysis::{Interrupt, modes};
use ancf::model::{At, Beam, Body, Clamped, End, Joint, Motion, Named, Place};
use ancf::system::State;

use crate::common::models::rod;
use crate::common::solutions::equilibrium;

/// The free motions of a model in its reference state, in words; as many as there are modes without stiffness.
fn words(model: &Model) -> Vec<String> {
    let assembly = model.assemble().unwrap();
    let rest = assembly.rest();
    let motions = assembly.free_motions(&rest);
    let modes = modes(&assembly.system, assembly.system.matrix(), &rest, 14, &Interrupt::default()).unwrap();
    assert_eq!(modes.rigid, motions.len(), "{motions:?}");
    motions.iter().map(ToString::to_string).collect()
}

/// A second rod of half a metre from the end of the first one on, in a direction, with joints of its own.
fn with_second(mut model: Model, [x, y, z]: [f64; 3], joints: Vec<Joint>) -> Model {
    let from = [rod::LENGTH, 0.0, 0.0];
    let to = [from[0] + 0.5 * x, 0.5 * y, 0.5 * z];
    let second = Beam { name: "second".into(), from, to, ..rod::beam(&mut model).clone() };
    model.bodies.push(Body::Beam(second));
    model.joints.extend(joints);
    model
}

fn second(end: Named) -> Place {
    Place::new("second", At::Named(end))
}

fn elbow() -> Joint {
    let (a, b) = (second(Named::Start), End::Place(rod::end()));
    Joint::Revolute {
        name: "elbow".into(),
        a,
        b,
        axis: [0.0, 0.0, 1.0],
        drive: None,
        spring: None,
        friction: None,
    }
}

#[test]
fn a_free_rod_has_six() {
    assert_eq!(
        words(&rod::free(2)),
        [
            "body `rod` can translate along x",
            "body `rod` can translate along y",
            "body `rod` can translate along z",
            "body `rod` can rotate about the axis through (0.5, 0, 0) along x",
            "body `rod` can rotate about the axis through (0.5, 0, 0) along y",
            "body `rod` can rotate about the axis through (0.5, 0, 0) along z",
        ]
    );
}

#[test]
fn pendulums() {
    let about = |axis| format!("body `rod` can rotate about the axis through (0, 0, 0) along {axis}");
    assert_eq!(words(&rod::spherical(2)), ["x", "y", "z"].map(about));
    assert_eq!(words(&rod::revolute(2)), [about("z")]);
    let mut skew = rod::revolute(2);
    rod::beam(&mut skew).up = Some([0.0, 0.3, 1.0]);
    let Joint::Revolute { axis, .. } = &mut skew.joints[0] else { panic!("a hinge") };
    *axis = [0.0, 3.0, 4.0];
    assert_eq!(words(&skew), [about("(0, 0.6, 0.8)")]);
}

/// Hung by balls at both ends it turns about the line through them, here askew to all axes.
#[test]
fn between_two_balls() {
    let mut model = rod::spherical(3);
    rod::beam(&mut model).to = [2.0, -1.0, 2.0];
    model.joints.push(Joint::Spherical { name: "far".into(), a: rod::end(), b: End::Ground });
    let axis = "(0.6667, -0.3333, 0.6667)";
    assert_eq!(
        words(&model),
        [format!("body `rod` can rotate about the axis through (0, 0, 0) along {axis}")]
    );
}

#[test]
fn held_rods_have_none() {
    for fix in [Clamped::All, Clamped::Section] {
        assert!(words(&rod::clamped(2, fix)).is_empty());
    }
    let mut propped = rod::revolute(2);
    propped.joints.push(Joint::Spherical { name: "far".into(), a: rod::end(), b: End::Ground });
    assert!(words(&propped).is_empty());
}

#[test]
fn a_chain_names_all_that_moves() {
    let chain = with_second(rod::revolute(2), [1.0, 0.0, 0.0], vec![elbow()]);
    assert_eq!(
        words(&chain),
        [
            "body `rod` can rotate about the axis through (0, 0, 0) along z; with it body `second` translates along y",
            "body `second` can rotate about the axis through (1, 0, 0) along z",
        ]
    );
    let hinged_to_a_clamped = with_second(rod::cantilever(2), [0.0, 1.0, 0.0], vec![elbow()]);
    assert_eq!(
        words(&hinged_to_a_clamped),
        ["body `second` can rotate about the axis through (1, 0, 0) along z"]
    );
}

/// Rods at right angles, pinned to each other and to the ground at both ends, are a truss: only along z can it flap, and
/// with balls each rod can spin.
#[test]
fn a_truss_flaps_about_its_diagonal() {
    let ball = |name: &str, a, b| Joint::Spherical { name: name.into(), a, b };
    let top = ball("top", second(Named::End), End::Ground);
    let elbow = ball("elbow", second(Named::Start), End::Place(rod::end()));
    let truss = with_second(rod::spherical(2), [0.0, 2.0, 0.0], vec![elbow, top]);
    let assembly = truss.assemble().unwrap();
    let motions = assembly.free_motions(&assembly.rest());
    assert_eq!(motions.len(), 3, "{motions:?}");
    assert!(words(&truss).iter().all(|words| words.contains("rotate")));
    let diagonal = motions.iter().filter(|motion| motion.moves.len() == 2).count();
    assert_eq!(diagonal, 1, "one motion moves both");
}

/// A hanging pendulum is held by its weight.
#[test]
fn weight_holds_a_pendulum() {
    let hung = |mut model: Model| {
        rod::beam(&mut model).to = [0.0, -rod::LENGTH, 0.0];
        model
    };
    let (_, held) = equilibrium(&hung(rod::clamped(2, Clamped::Section)), 1);
    let assembly = hung(rod::revolute(2)).assemble().unwrap();
    let hanging = State { q: held.q, ..assembly.rest() };
    assert_eq!(assembly.free_motions(&assembly.rest()).len(), 1);
    assert!(assembly.free_motions(&hanging).is_empty());
}

/// Turned by a quarter, the axis is where it was.
#[test]
fn in_a_turned_state() {
    let assembly = rod::revolute(2).assemble().unwrap();
    let rest = assembly.rest();
    let mut turned: State = rest.clone();
    for vector in assembly.mesh("rod").unwrap().vectors(&rest) {
        let (x, y) = (vector.value.x, vector.value.y);
        turned.q[vector.first] = -y - x;
        turned.q[vector.first + 1] = x - y;
    }
    let motions = assembly.free_motions(&turned);
    let rotation = Motion::Rotation { through: [0.0; 3], along: [0.0, 0.0, 1.0] };
    assert_eq!(motions.len(), 1);
    assert_eq!(motions[0].moves, [("rod".to_owned(), rotation)]);
    let motion = motions[0].clone().scaled(1000.0);
    assert_eq!(motion.to_string(), "body `rod` can rotate about the axis through (0, 0, 0) along z");
}

/// Units and slope coordinates have no say.
#[test]
fn in_other_units() {
    let model = rod::spherical(3);
    let scales = ancf::Scales { length: 1e-3, time: 10.0, force: 1e6 };
    let mut other = model.scaled(&scales);
    rod::beam(&mut other).slopes = ancf::model::Slopes::Length;
    assert_eq!(words(&model), words(&other));
}

/// A hundred rods in a row, each hinged to the one before: a motion for each hinge, that moves all rods beyond.
#[test]
fn a_long_chain() {
    let mut model = rod::revolute(1);
    let first = rod::beam(&mut model).clone();
    for k in 1..100_u32 {
        let (x, before) = (f64::from(k), model.bodies[k as usize - 1].name().to_owned());
        let name = format!("link {k}");
        let link = Beam { name: name.clone(), from: [x, 0.0, 0.0], to: [x + 1.0, 0.0, 0.0], ..first.clone() };
        model.bodies.push(Body::Beam(link));
        let a = Place::new(&name, At::Named(Named::Start));
        let b = End::Place(Place::new(&before, At::Named(Named::End)));
        model.joints.push(Joint::Revolute {
            name: format!("hinge {k}"),
            a,
            b,
            axis: [0.0, 0.0, 1.0],
            drive: None,
            spring: None,
            friction: None,
        });
    }
    let assembly = model.assemble().unwrap();
    let motions = assembly.free_motions(&assembly.rest());
    let moving: Vec<usize> = motions.iter().map(|motion| motion.moves.len()).collect();
    assert_eq!(moving, (1..=100).rev().collect::<Vec<_>>());
}
