//! Free motions of models, by name.

use ancf::Model;
use ancf::diagnosis::RigidMotion;
use ancf::model::{At, Beam, Body, ClampedGradients, End, Joint, NamedPosition, Place, Revolute};
use ancf::solver::eigen::modes;
use ancf::solver::equations::State;
use ancf::solver::newton::Interrupt;

use crate::common::models::{parse, rod};
use crate::common::solutions::equilibrium;

/// Free motions of a model in its reference state, in words. Asserts that modes without stiffness are as many.
fn motion_names(model: &Model) -> Vec<String> {
    let assembly = model.assemble().unwrap();
    let rest = assembly.rest();
    let free = assembly.free_motions(&rest).unwrap();
    let modes = modes(&assembly.system, assembly.system.matrix(), &rest, 14, &Interrupt::default()).unwrap();
    assert_eq!(modes.rigid, free.len(), "{free:?}");
    free.iter().map(ToString::to_string).collect()
}

/// Adds a rod of 0.5 m at the end of the first one, in a given direction, with its joints.
fn with_second(mut model: Model, [x, y, z]: [f64; 3], joints: Vec<Joint>) -> Model {
    let from = [rod::LENGTH, 0.0, 0.0];
    let to = [from[0] + 0.5 * x, 0.5 * y, 0.5 * z];
    let second = Beam { name: "second".into(), from, to, ..rod::beam(&mut model).clone() };
    model.bodies.push(Body::Beam(second));
    model.joints.extend(joints);
    model
}

fn second(end: NamedPosition) -> Place {
    Place::new("second", At::Named(end))
}

fn elbow() -> Joint {
    let (a, b) = (second(NamedPosition::Start), End::Place(rod::end()));
    Joint::Revolute(Revolute {
        name: "elbow".into(),
        a,
        b,
        axis: [0.0, 0.0, 1.0],
        drive: None,
        spring: None,
        friction: None,
        moment: None,
        stops: None,
    })
}

#[test]
fn free_rod_has_six_motions() {
    assert_eq!(
        motion_names(&rod::free(2)),
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
fn pendulums_rotate_about_their_joints() {
    let about = |axis| format!("body `rod` can rotate about the axis through (0, 0, 0) along {axis}");
    assert_eq!(motion_names(&rod::spherical(2)), ["x", "y", "z"].map(about));
    assert_eq!(motion_names(&rod::revolute(2)), [about("z")]);
    let mut skew = rod::revolute(2);
    rod::beam(&mut skew).up = Some([0.0, 0.3, 1.0]);
    let Joint::Revolute(Revolute { axis, .. }) = &mut skew.joints[0] else {
        panic!("the root is a revolute joint")
    };
    *axis = [0.0, 3.0, 4.0];
    assert_eq!(motion_names(&skew), [about("(0, 0.6, 0.8)")]);
}

/// Rotation about the line through both joints, oblique to all axes.
#[test]
fn rod_between_two_spherical_joints_spins() {
    let mut model = rod::spherical(3);
    rod::beam(&mut model).to = [2.0, -1.0, 2.0];
    model.joints.push(Joint::spherical("far", rod::end(), End::Ground));
    let axis = "(0.6667, -0.3333, 0.6667)";
    assert_eq!(
        motion_names(&model),
        [format!("body `rod` can rotate about the axis through (0, 0, 0) along {axis}")]
    );
}

#[test]
fn clamped_and_propped_rods_have_no_free_motion() {
    for fix in [ClampedGradients::All, ClampedGradients::Section] {
        assert!(motion_names(&rod::clamped(2, fix)).is_empty());
    }
    let mut propped = rod::revolute(2);
    propped.joints.push(Joint::spherical("far", rod::end(), End::Ground));
    assert!(motion_names(&propped).is_empty());
}

#[test]
fn motions_of_a_chain_name_all_moving_bodies() {
    let chain = with_second(rod::revolute(2), [1.0, 0.0, 0.0], vec![elbow()]);
    assert_eq!(
        motion_names(&chain),
        [
            "body `rod` can rotate about the axis through (0, 0, 0) along z; with it body `second` translates along y",
            "body `second` can rotate about the axis through (1, 0, 0) along z",
        ]
    );
    let hinged_to_a_clamped = with_second(rod::cantilever(2), [0.0, 1.0, 0.0], vec![elbow()]);
    assert_eq!(
        motion_names(&hinged_to_a_clamped),
        ["body `second` can rotate about the axis through (1, 0, 0) along z"]
    );
}

/// Two rods at right angles with spherical joints: one rotation of the truss about its diagonal, one spin of each rod.
#[test]
fn truss_rotates_about_its_diagonal() {
    let ball = |name: &str, a, b| Joint::spherical(name, a, b);
    let top = ball("top", second(NamedPosition::End), End::Ground);
    let elbow = ball("elbow", second(NamedPosition::Start), End::Place(rod::end()));
    let truss = with_second(rod::spherical(2), [0.0, 2.0, 0.0], vec![elbow, top]);
    let assembly = truss.assemble().unwrap();
    let motions = assembly.free_motions(&assembly.rest()).unwrap();
    assert_eq!(motions.len(), 3, "{motions:?}");
    assert!(motion_names(&truss).iter().all(|motion| motion.contains("rotate")));
    let diagonal = motions.iter().filter(|motion| motion.moves.len() == 2).count();
    assert_eq!(diagonal, 1, "one motion moves both rods");
}

/// The geometric stiffness of the weight restrains a hanging pendulum.
#[test]
fn weight_restrains_a_hanging_pendulum() {
    let hanging = |mut model: Model| {
        rod::beam(&mut model).to = [0.0, -rod::LENGTH, 0.0];
        model
    };
    let (_, loaded) = equilibrium(&hanging(rod::clamped(2, ClampedGradients::Section)), 1);
    let assembly = hanging(rod::revolute(2)).assemble().unwrap();
    let state = State { q: loaded.q, ..assembly.rest() };
    assert_eq!(assembly.free_motions(&assembly.rest()).unwrap().len(), 1);
    assert!(assembly.free_motions(&state).unwrap().is_empty());
}

/// The axis of rotation is unchanged after a rotation by 90°.
#[test]
fn motions_are_found_in_a_rotated_state() {
    let assembly = rod::revolute(2).assemble().unwrap();
    let rest = assembly.rest();
    let mut turned: State = rest.clone();
    for vector in assembly.mesh("rod").unwrap().vectors(&rest) {
        let (x, y) = (vector.value.x, vector.value.y);
        turned.q[vector.first] = -y - x;
        turned.q[vector.first + 1] = x - y;
    }
    let motions = assembly.free_motions(&turned).unwrap();
    let rotation = RigidMotion::Rotation { through: [0.0; 3], along: [0.0, 0.0, 1.0] };
    assert_eq!(motions.len(), 1);
    assert_eq!(motions[0].moves, [("rod".to_owned(), rotation)]);
    let motion = motions[0].clone().scaled(1000.0);
    assert_eq!(motion.to_string(), "body `rod` can rotate about the axis through (0, 0, 0) along z");
}

/// Free motions do not depend on units and slope coordinates.
#[test]
fn motions_do_not_depend_on_units() {
    let model = rod::spherical(3);
    let scales = ancf::Scales { length: 1e-3, time: 10.0, force: 1e6 };
    let mut other = model.scaled(&scales);
    rod::beam(&mut other).slopes = ancf::model::Slopes::Length;
    assert_eq!(motion_names(&model), motion_names(&other));
}

/// Chain of 100 hinged rods: one motion for each hinge, which moves all rods beyond.
#[test]
fn long_chain_has_one_motion_per_hinge() {
    let mut model = rod::revolute(1);
    let first = rod::beam(&mut model).clone();
    for k in 1..100_u32 {
        let (x, before) = (f64::from(k), model.bodies[k as usize - 1].name().to_owned());
        let name = format!("link {k}");
        let link = Beam { name: name.clone(), from: [x, 0.0, 0.0], to: [x + 1.0, 0.0, 0.0], ..first.clone() };
        model.bodies.push(Body::Beam(link));
        let a = Place::new(&name, At::Named(NamedPosition::Start));
        let b = End::Place(Place::new(&before, At::Named(NamedPosition::End)));
        model.joints.push(Joint::Revolute(Revolute {
            name: format!("hinge {k}"),
            a,
            b,
            axis: [0.0, 0.0, 1.0],
            drive: None,
            spring: None,
            friction: None,
            moment: None,
            stops: None,
        }));
    }
    let assembly = model.assemble().unwrap();
    let motions = assembly.free_motions(&assembly.rest()).unwrap();
    let moving: Vec<usize> = motions.iter().map(|motion| motion.moves.len()).collect();
    assert_eq!(moving, (1..=100).rev().collect::<Vec<_>>());
    let text = motions[0].to_string();
    assert!(text.contains(", and 91 more bodies move"), "{text}");
}

/// Chains with too many coefficients of free motions are diagnosed without them.
#[test]
fn free_motions_of_long_chains_are_not_determined() {
    let body = |i: usize| {
        format!(
            "[[bodies]]\nkind = \"rigid\"\nname = \"b{i}\"\ncenter = [{i}, 0.5, 0]\nmass = 2\ninertia = [0.1, 0.2, 0.25]\n"
        )
    };
    let joint = |i: usize| {
        let before = i - 1;
        format!(
            "[[joints]]\nkind = \"spherical\"\nname = \"j{i}\"\na = {{ body = \"b{i}\", at = \"center\" }}\n\
            b = {{ body = \"b{before}\", at = \"center\", offset = [1, 0, 0] }}\n"
        )
    };
    let model = |bodies: usize| {
        let text: String = (0..bodies).map(body).chain((1..bodies).map(joint)).collect();
        parse(&format!("{text}[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 0.1\n"))
    };
    let short = model(30).diagnose().unwrap();
    assert_eq!(short.motions.as_ref().map(Vec::len), Some(3 * 30 + 3));
    assert!(short.to_string().contains("and 73 more free motions"), "{short}");
    let long = model(1200).diagnose().unwrap();
    assert_eq!((long.motions.is_some(), long.freedoms), (false, 3 * 1200 + 3));
    assert!(long.to_string().contains("unknown number of free motions"));
}

/// The search for free motions is linear in the number of free bodies.
#[test]
fn each_of_many_free_bodies_has_six_motions() {
    let body = |i: usize| {
        format!(
            "[[bodies]]\nkind = \"rigid\"\nname = \"b{i}\"\ncenter = [{i}, 0.5, 0]\nmass = 2\ninertia = [0.1, 0.2, 0.25]\n"
        )
    };
    let bodies: String = (0..700).map(body).collect();
    let model = parse(&format!("analysis = {{ kind = \"statics\" }}\n{bodies}"));
    let assembly = model.assemble().unwrap();
    assert_eq!(assembly.free_motions(&assembly.rest()).unwrap().len(), 6 * 700);
}
