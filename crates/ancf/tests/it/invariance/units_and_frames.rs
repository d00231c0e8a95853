//! Invariance to units, slope coordinates, scales, the frame of reference and the order of bodies and joints.
//!
//! Each test runs a model and an equivalent model and compares motions, reactions and iterations. Lengths are compared
//! relative to L, forces relative to the weight.

use ancf::model::{
    At, Body, Clamp, ClampedGradients, End, Joint, Load, Material, NamedPosition, Place, PointForce,
    PointMoment, Probe, Revolute, ScaleChoice, Section, Slopes, Spherical, Start, Step, TimeFunction,
    Varying,
};
use ancf::{Model, Scales};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

use crate::common::models::rod;
use crate::common::solutions::{Run, SOLVER_COLUMNS, assert_same_columns, distance};

/// ρAgL of the rod, in newtons.
const WEIGHT: f64 = 24.74767621716784;

/// The three systems of the paper, soft, with large displacements and deformations in a short time.
fn paper_systems() -> [Model; 3] {
    [rod::cantilever(3), rod::revolute(3), rod::spherical(3)].map(|mut model| {
        rod::material(&mut model).young = 193e6;
        rod::settings(&mut model).duration = 0.3;
        model
    })
}

/// Two hinged beams without symmetry: rectangular section, oblique axes, ν > 0, loads at the end.
fn linkage() -> Model {
    let mut model = rod::revolute(2);
    let beam = rod::beam(&mut model);
    (beam.to, beam.up) = ([0.6, 0.5, -0.2], Some([0.1, 0.2, 1.0]));
    let mut second = beam.clone();
    (second.name, second.from, second.to, second.elements) = ("second".into(), beam.to, [1.1, 0.4, 0.1], 1);
    model.bodies.push(Body::Beam(second));
    let place = |body: &str, at| Place::new(body, At::Named(at));
    let tip = place("second", NamedPosition::End);
    model.joints.push(Joint::Revolute(Revolute {
        name: "elbow".into(),
        a: place("second", NamedPosition::Start),
        b: End::Place(rod::end()),
        axis: [0.3, -0.1, 0.9],
        drive: None,
        spring: None,
        friction: None,
        moment: None,
        stops: None,
    }));
    model.probes = vec![Probe::of_motion("tip", tip.clone())];
    model.loads = loads(tip);
    model.sections.insert("circle".into(), Section::rectangle(0.03, 0.02));
    *rod::material(&mut model) = Material::elastic(8030.0, 193e6, 0.3);
    let settings = rod::settings(&mut model);
    (settings.duration, settings.start) = (0.3, Start::Consistent);
    model
}

/// Forces and moments with fixed and following directions and all functions of time.
fn loads(on: Place) -> Vec<Load> {
    let place = || on.clone();
    let varying = TimeFunction::Varying;
    let (times, values) = (vec![0.0, 0.1, 0.15], vec![1.0, -0.5, 0.7]);
    let formula = Varying::Expression { text: "if(t < 0.2, t^2/0.04, cos(3*(t - 0.2)))".into(), unit: 1.0 };
    vec![
        Load::force(place(), [3.0, 1.0, 5.0]),
        Load::Force(PointForce {
            on: place(),
            force: [0.5, -1.0, 1.5],
            follower: true,
            time: varying(Varying::Table { times, values }),
        }),
        Load::Moment(PointMoment {
            on: place(),
            moment: [0.1, 0.2, -0.3],
            follower: false,
            time: varying(Varying::Sine { frequency: 2.0, phase: 0.5 }),
        }),
        Load::Moment(PointMoment {
            on: place(),
            moment: [-0.1, 0.1, 0.2],
            follower: true,
            time: varying(formula),
        }),
        Load::Moment(PointMoment {
            on: place(),
            moment: [0.0, 0.05, 0.1],
            follower: false,
            time: varying(Varying::Ramp { start: 0.05, end: 0.2 }),
        }),
        Load::Force(PointForce {
            on: place(),
            force: [0.2, 0.0, 0.3],
            follower: false,
            time: varying(Varying::Step { at: 0.0703, until: Some(0.2104) }),
        }),
    ]
}

/// Systems of the paper and the linkage.
fn all_systems() -> impl Iterator<Item = Model> {
    paper_systems().into_iter().chain([linkage()])
}

/// Asserts that `other` has the motion, reactions and iterations of `model`.
///
/// `back` maps vectors of `other` to the frame of `model`; `[length, force]` are the values of one metre and one newton.
fn assert_equivalent(
    model: &Model,
    other: &Model,
    back: impl Fn(Vector3<f64>) -> Vector3<f64>,
    [length, force]: [f64; 2],
) {
    let (a, b) = (Run::of(model), Run::of(other));
    let moved = |run: &Run, unit: f64| -> Vec<_> {
        let tip = run.vectors("tip.");
        tip.iter().map(|x| (x - tip[0]) / unit).collect()
    };
    let mapped: Vec<_> = moved(&b, length).into_iter().map(&back).collect();
    let error = distance(&moved(&a, 1.0), &mapped);
    assert!(error < 1e-9 * rod::LENGTH, "distance {error:e}");
    let reactions: Vec<_> = b.vectors("root.f").iter().map(|f| back(f / force)).collect();
    let error = distance(&a.vectors("root.f"), &reactions);
    assert!(error < 1e-9 * WEIGHT, "reactions: distance {error:e}");
    let (a, b) = (a.summary.iterations as f64, b.summary.iterations as f64);
    assert!((a / b - 1.0).abs() < 0.01, "{a} and {b} iterations");
}

fn identity(x: Vector3<f64>) -> Vector3<f64> {
    x
}

/// Millimetre-tonne-second units, written explicitly, and arbitrary units.
#[test]
fn units_do_not_change_the_motion() {
    for model in paper_systems() {
        let mut millimetres = model.clone();
        millimetres.gravity = model.gravity.map(|g| 1e3 * g);
        rod::beam(&mut millimetres).to[0] *= 1e3;
        millimetres.sections.insert("circle".into(), Section::circle(20.0));
        let material = rod::material(&mut millimetres);
        (material.density, material.young) = (8.03e-9, 193.0);
        assert_equivalent(&model, &millimetres, identity, [1e3, 1.0]);
    }
    for model in all_systems() {
        let odd = Scales { length: 0.037, time: 13.0, force: 2.9e5 };
        assert_equivalent(&model, &model.scaled(&odd), identity, [1.0 / odd.length, 1.0 / odd.force]);
    }
}

/// Slope coordinates: gradients, or gradients times the element length.
#[test]
fn slope_coordinates_do_not_change_the_motion() {
    for model in all_systems() {
        let mut other = model.clone();
        for beam in other.bodies.iter_mut().filter_map(beam) {
            beam.slopes = Slopes::Length;
        }
        assert_equivalent(&model, &other, identity, [1.0; 2]);
    }
}

/// Scales of the paper, automatic and given scales.
#[test]
fn scales_do_not_change_the_motion() {
    for model in paper_systems() {
        assert_equivalent(&model, &Model { scales: ScaleChoice::Paper, ..model.clone() }, identity, [1.0; 2]);
    }
    for model in all_systems() {
        for scales in [
            ScaleChoice::Auto,
            ScaleChoice::Given { length: 0.2, force: 7e4, time: None },
            ScaleChoice::Given { length: 12.0, force: 1e-3, time: Some(0.3) },
        ] {
            let other = Model { scales, ..model.clone() };
            assert_equivalent(&model, &other, identity, [1.0; 2]);
            let runs = [&model, &other].map(Run::of);
            assert_same_columns("scales", runs.each_ref(), &SOLVER_COLUMNS, 1.0, 1e-9);
        }
    }
}

/// Rotates all points, directions and forces of a model, then shifts the points.
fn moved(mut model: Model, turn: Rotation3<f64>, shift: Vector3<f64>) -> Model {
    let direction = |x: [f64; 3]| <[f64; 3]>::from(turn * Vector3::from(x));
    let point = |x| <[f64; 3]>::from(Vector3::from(direction(x)) + shift);
    model.gravity = direction(model.gravity);
    for beam in model.bodies.iter_mut().filter_map(beam) {
        (beam.from, beam.to) = (point(beam.from), point(beam.to));
        beam.up = Some(direction(beam.up.unwrap_or([0.0, 1.0, 0.0])));
    }
    for joint in &mut model.joints {
        if let Joint::Revolute(Revolute { axis, .. }) = joint {
            *axis = direction(*axis);
        }
    }
    for load in &mut model.loads {
        match load {
            Load::Force(load) => load.force = direction(load.force),
            Load::Moment(load) => load.moment = direction(load.moment),
            _ => {}
        }
    }
    model
}

#[test]
fn rotation_of_the_frame_rotates_the_motion() {
    let turn = Rotation3::from_euler_angles(0.7, -1.2, 2.5);
    for model in all_systems() {
        let turned = moved(model.clone(), turn, Vector3::zeros());
        assert_equivalent(&model, &turned, |x| turn.inverse() * x, [1.0; 2]);
    }
}

/// Origin at a distance of 1000 lengths: equal to the rounding of the recorded position, 2000 ε.
#[test]
fn translation_of_the_frame_shifts_the_motion() {
    let shift = Vector3::new(1000.0, -2000.0, 500.0);
    for model in paper_systems() {
        let shifted = moved(model.clone(), Rotation3::identity(), shift);
        let (here, there) = (Run::of(&model), Run::of(&shifted));
        let shifted: Vec<_> = there.vectors("tip.").iter().map(|x| x - shift).collect();
        let error = distance(&here.vectors("tip."), &shifted);
        assert!(error < 1e-12 * rod::LENGTH, "distance {error:e}");
        assert_eq!(here.summary.iterations, there.summary.iterations);
    }
}

/// Start and end of all beams are exchanged.
#[test]
fn direction_of_beams_does_not_change_the_motion() {
    for model in all_systems() {
        let mut reversed = model.clone();
        for beam in reversed.bodies.iter_mut().filter_map(beam) {
            std::mem::swap(&mut beam.from, &mut beam.to);
        }
        let swap = |place: &mut Place| {
            place.at = match place.at {
                At::Named(NamedPosition::Start) => At::Named(NamedPosition::End),
                At::Named(NamedPosition::End) => At::Named(NamedPosition::Start),
                _ => panic!("joints and probes are at the ends"),
            }
        };
        for joint in &mut reversed.joints {
            let (Joint::Clamp(Clamp { a, b, .. })
            | Joint::Revolute(Revolute { a, b, .. })
            | Joint::Spherical(Spherical { a, b, .. })) = joint
            else {
                panic!("the systems have no other joints");
            };
            swap(a);
            if let End::Place(b) = b {
                swap(b);
            }
        }
        reversed.probes.iter_mut().for_each(|probe| swap(&mut probe.on));
        for load in &mut reversed.loads {
            match load {
                Load::Force(load) => swap(&mut load.on),
                Load::Moment(load) => swap(&mut load.on),
                _ => {}
            }
        }
        assert_equivalent(&model, &reversed, identity, [1.0; 2]);
    }
}

/// A step divided into quarters equals four steps of a quarter. Iterations of failed attempts are counted.
#[test]
fn divided_step_equals_its_parts() {
    let run = |step| {
        let mut model = paper_systems()[2].clone();
        let settings = rod::settings(&mut model);
        (settings.duration, settings.step) = (0.02, Step::Fixed(step));
        (settings.max_iterations, settings.max_halvings) = (3, 2);
        Run::of(&model)
    };
    let (divided, quarters) = (run(0.02), run(0.005));
    assert_eq!((divided.summary.divided_steps, quarters.summary.divided_steps), (1, 0));
    assert_eq!(divided.summary.iterations, quarters.summary.iterations + 2 * 3);
    let last = |run: &Run| [run.vectors("tip.")[run.column("t").len() - 1]];
    assert!(distance(&last(&divided), &last(&quarters)) < 1e-12 * rod::LENGTH);
}

#[test]
fn order_of_bodies_and_joints_does_not_change_the_motion() {
    let model = linkage();
    let mut reversed = model.clone();
    reversed.bodies.reverse();
    reversed.joints.reverse();
    assert_equivalent(&model, &reversed, identity, [1.0; 2]);
}

/// Two beams connected by a clamp equal one beam.
#[test]
fn clamped_beams_equal_one_beam() {
    let whole = &paper_systems()[0];
    let mut halves = rod::cantilever(2);
    halves.materials = whole.materials.clone();
    halves.analysis = whole.analysis.clone();
    rod::beam(&mut halves).to[0] = 2.0 / 3.0;
    let mut second = rod::beam(&mut halves).clone();
    (second.name, second.from, second.to, second.elements) =
        ("second".into(), [2.0 / 3.0, 0.0, 0.0], [1.0, 0.0, 0.0], 1);
    halves.bodies.push(Body::Beam(second));
    let place = |at| Place::new("second", At::Named(at));
    halves.probes[0].on = place(NamedPosition::End);
    let (a, b) = (place(NamedPosition::Start), End::Place(rod::end()));
    halves.joints.push(Joint::Clamp(Clamp { name: "weld".into(), a, b, fix: Some(ClampedGradients::All) }));
    assert_equivalent(whole, &halves, identity, [1.0; 2]);
}

fn any_scales() -> impl Strategy<Value = Scales> {
    let unit = || (-6.0..6.0).prop_map(|x: f64| 10.0_f64.powf(x));
    (unit(), unit(), unit()).prop_map(|(length, time, force)| Scales { length, time, force })
}

/// Largest relative difference of the numbers of two models; infinite if they differ otherwise.
fn difference(a: &Model, b: &Model) -> f64 {
    fn compare(a: &serde_json::Value, b: &serde_json::Value) -> f64 {
        use serde_json::Value::{Array, Number, Object};
        match (a, b) {
            (Number(a), Number(b)) => {
                let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
                if a == b { 0.0 } else { (a - b).abs() / a.abs().max(b.abs()) }
            }
            (Array(a), Array(b)) if a.len() == b.len() => {
                a.iter().zip(b).map(|(a, b)| compare(a, b)).fold(0.0, f64::max)
            }
            (Object(a), Object(b)) if a.keys().eq(b.keys()) => {
                a.values().zip(b.values()).map(|(a, b)| compare(a, b)).fold(0.0, f64::max)
            }
            (a, b) if a == b => 0.0,
            _ => f64::INFINITY,
        }
    }
    compare(&serde_json::to_value(a).unwrap(), &serde_json::to_value(b).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Inverse, composition and identity of scalings.
    #[test]
    fn scaling_is_a_group(a in any_scales(), b in any_scales()) {
        let model = linkage();
        prop_assert!(difference(&model, &model.scaled(&Scales::UNIT)) == 0.0);
        prop_assert!(difference(&model, &model.scaled(&a).scaled(&a.inverse())) < 1e-14);
        let (twice, once) = (model.scaled(&a).scaled(&b), model.scaled(&a.then(&b)));
        prop_assert!(difference(&twice, &once) < 1e-14);
        prop_assert!(difference(&model, &model.scaled(&a)) > 0.0);
    }
}

fn beam(body: &mut Body) -> Option<&mut ancf::model::Beam> {
    if let Body::Beam(beam) = body { Some(beam) } else { None }
}

/// Units that differ by powers of two give bitwise equal results, since automatic scales are powers of two.
#[test]
fn units_by_powers_of_two_give_equal_bits() {
    for model in all_systems() {
        let model = Model { scales: ScaleChoice::Auto, ..model };
        let units = Scales { length: 1024.0, time: 0.125, force: 32.0 };
        let other = Model { scales: ScaleChoice::Auto, ..model.scaled(&units) };
        let (here, there) = (Run::of(&model), Run::of(&other));
        assert_eq!(here.summary.iterations, there.summary.iterations);
        for (a, b) in here.vectors("tip.").iter().zip(there.vectors("tip.")) {
            assert_eq!(*a, b * units.length);
        }
    }
}
