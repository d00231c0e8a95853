//! Redundant joints: their names, the distribution of their forces, and unchanged motions.

use std::time::Instant;

use ancf::model::{
    Analysis, At, Beam, Body, Buckling, Clamp, ClampedGradients, DrivenClamp, End, Formulation, Ground,
    Joint, Load, Modes, NamedPosition, Path, Place, Statics, TimeFunction, Varying,
};
use ancf::record::Series;
use ancf::solver::factor::{SparseVector, dependences, sparse_row};
use ancf::{Model, Outcome, simulate};
use nalgebra::{DMatrix, Vector3};
use proptest::prelude::*;

use crate::common::models::rod;
use crate::common::solutions::{Run, distance};

fn ball(name: &str, a: Place) -> Joint {
    Joint::spherical(name, a, End::Ground)
}

fn clamp(name: &str, a: Place, fix: ClampedGradients) -> Joint {
    Joint::Clamp(Clamp { name: name.into(), a, b: End::Ground, fix: Some(fix) })
}

fn short(mut model: Model) -> Model {
    rod::settings(&mut model).duration = 0.2;
    model
}

fn with(mut model: Model, joints: impl IntoIterator<Item = Joint>) -> Model {
    model.joints.extend(joints);
    model
}

/// Names of the redundant equations.
fn redundant(model: &Model) -> Vec<String> {
    model.assemble().unwrap().redundant().iter().map(ToString::to_string).collect()
}

/// Two clamps of one end carry half of the reactions each; the motion is that with one clamp.
#[test]
fn two_clamps_share_the_reaction_equally() {
    for fix in [ClampedGradients::All, ClampedGradients::Section] {
        let one = short(rod::clamped(4, fix));
        let two = with(one.clone(), [clamp("again", rod::start(), fix)]);
        let (one, two) = (Run::of(&one), Run::of(&two));
        assert!(distance(&one.vectors("tip."), &two.vectors("tip.")) < 1e-9 * rod::LENGTH);
        for part in ["f", "m"] {
            let whole = one.vectors(&format!("root.{part}"));
            let [a, b] = ["root", "again"].map(|joint| two.vectors(&format!("{joint}.{part}")));
            let size = whole.iter().map(Vector3::norm).fold(0.0, f64::max);
            assert!(distance(&a, &b) < 1e-6 * size, "{fix:?}, {part}: halves");
            let sum: Vec<_> = a.iter().zip(&b).map(|(a, b)| a + b).collect();
            assert!(
                distance(&whole, &sum) < 1e-6 * size,
                "{fix:?}, {part}: sum {:e}",
                distance(&whole, &sum) / size
            );
        }
    }
}

/// Equilibrium with three joints, of which the third constrains a part of what the clamps constrain.
#[test]
fn redundant_joints_do_not_change_equilibria() {
    let load = |mut model: Model| {
        model.analysis = Analysis::Statics(Statics::default());
        model
    };
    let one = load(rod::clamped(4, ClampedGradients::Section));
    let two = with(
        one.clone(),
        [clamp("again", rod::start(), ClampedGradients::Section), ball("third", rod::start())],
    );
    assert_eq!(redundant(&two).len(), 9);
    let (one, two) = (Run::of(&one), Run::of(&two));
    assert!(distance(&one.vectors("tip."), &two.vectors("tip.")) < 1e-9 * rod::LENGTH);
    let [whole, a, b, c] = [(&one, "root"), (&two, "root"), (&two, "again"), (&two, "third")]
        .map(|(run, joint)| run.last_vector(&format!("{joint}.f")));
    for part in [a, b, c] {
        assert!((part * 3.0 - whole).norm() < 1e-6 * whole.norm(), "{part} of {whole}");
    }
    let (whole, half) = (one.last_vector("root.m"), two.last_vector("again.m"));
    assert!((half * 2.0 - whole).norm() < 1e-6 * whole.norm(), "{half} of {whole}");
    assert_eq!(two.last_vector("third.m"), Vector3::zeros());
}

#[test]
fn redundant_joints_do_not_change_modes() {
    let of = |mut model: Model| {
        model.analysis = Analysis::Modes(Modes { count: 6, ..Modes::default() });
        Run::of(&model).column("squared").to_vec()
    };
    let one = of(rod::cantilever(3));
    let two = of(with(rod::cantilever(3), [clamp("again", rod::start(), ClampedGradients::All)]));
    assert!(one.iter().zip(&two).all(|(a, b)| (a - b).abs() < 1e-8 * a), "{one:?} {two:?}");
}

#[test]
fn redundant_joints_do_not_change_paths_and_critical_loads() {
    let pushed = |mut model: Model, analysis| {
        model.gravity = [0.0; 3];
        model.loads.push(Load::force(rod::end(), [-1000.0, 1.0, 0.0]));
        model.analysis = analysis;
        model
    };
    let path = || Analysis::Path(Path { load: 3.0, ..Path::default() });
    let buckling = || Analysis::Buckling(Buckling { count: 3, ..Buckling::default() });
    let again = || clamp("again", rod::start(), ClampedGradients::Section);
    let one = pushed(rod::clamped(4, ClampedGradients::Section), path());
    let (one, two) = (Run::of(&one), Run::of(&with(one, [again()])));
    assert_eq!(one.summary.steps, two.summary.steps);
    assert!(distance(&one.vectors("tip."), &two.vectors("tip.")) < 1e-9 * rod::LENGTH);
    let same = |(a, b): (&f64, &f64)| a == b || a.is_nan() && b.is_nan();
    assert!(one.column("unstable").iter().zip(two.column("unstable")).all(same));
    let one = pushed(rod::clamped(4, ClampedGradients::Section), buckling());
    let (one, two) = (Run::of(&one), Run::of(&with(one, [again()])));
    let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-8 * a.abs();
    assert!(one.column("factor").iter().zip(two.column("factor")).all(near));
}

/// The message names the later joint, the equation and the earlier joints.
#[test]
fn message_names_the_later_joint() {
    let axes = ["x", "y", "z"];
    let later = |joint: &str, earlier: &str| {
        axes.map(|axis| format!("joint `{joint}`: position along {axis}, follows from joint `{earlier}`"))
    };
    assert_eq!(redundant(&with(rod::cantilever(2), [ball("ball", rod::start())])), later("ball", "root"));
    let swapped = with(rod::spherical(2), [clamp("clamp", rod::start(), ClampedGradients::All)]);
    assert_eq!(redundant(&swapped), later("clamp", "root"));
    let hinge = |name: &str| Joint::revolute(name, rod::start(), End::Ground, [0.0, 0.0, 2.0]);
    let twice = redundant(&with(rod::free(2), [hinge("one"), hinge("two")]));
    assert_eq!(twice[..3], later("two", "one"));
    assert_eq!(twice[3], "joint `two`: hinge axis, first equation, follows from joint `one`");
    assert_eq!(twice[4], "joint `two`: hinge axis, second equation, follows from joint `one`");
}

/// A joint inside an element with two clamped nodes is redundant.
#[test]
fn joint_between_two_clamped_nodes_is_redundant() {
    let middle = Place::new("rod", At::Length(0.5));
    let clamped =
        with(rod::cantilever(1), [clamp("far", rod::end(), ClampedGradients::All), ball("middle", middle)]);
    let found = redundant(&clamped);
    assert_eq!(found.len(), 3);
    assert_eq!(found[0], "joint `middle`: position along x, follows from joints `root` and `far`");
    let mut model = short(clamped);
    rod::settings(&mut model).duration = 0.01;
    let run = Run::of(&model);
    let tip = run.vectors("tip.");
    assert!(tip.iter().all(|tip| (tip - Vector3::x()).norm() < 1e-12));
}

/// Redundancy does not depend on units and slope coordinates.
#[test]
fn redundancy_does_not_depend_on_units() {
    let model = with(
        rod::cantilever(3),
        [clamp("again", rod::start(), ClampedGradients::Section), ball("far", rod::end())],
    );
    for length in [1e-4, 1.0, 1e4] {
        let mut other = model.scaled(&ancf::Scales { length, time: 10.0, force: 1e6 });
        assert_eq!(redundant(&other), redundant(&model));
        rod::beam(&mut other).slopes = ancf::model::Slopes::Length;
        assert_eq!(redundant(&other), redundant(&model));
        assert_eq!(redundant(&other).len(), 6);
    }
}

fn drive(name: &str, text: &str) -> Joint {
    let time = TimeFunction::Varying(Varying::Expression { text: text.into(), unit: 1.0 });
    let (axis, fix) = ([0.0, 0.0, 1.0], Some(ClampedGradients::Section));
    Joint::Drive(DrivenClamp {
        name: name.into(),
        a: rod::start(),
        axis: Some(axis),
        angle: 1.0,
        displacement: [0.0; 3],
        time,
        fix,
    })
}

/// Equal drives are redundant; different drives are rejected with a message.
#[test]
fn contradicting_joints_are_rejected() {
    let agree = short(with(rod::free(2), [drive("one", "t^2"), drive("two", "t*t")]));
    assert_eq!(redundant(&agree).len(), 6);
    Run::of(&agree);
    let model = short(with(rod::free(2), [drive("one", "t^3"), drive("two", "2*t^3")]));
    let errors = model.check().unwrap_err();
    assert_eq!(errors.len(), 1);
    assert_eq!(
        errors[0].to_string(),
        "joints[1]: found equations that contradict `one`: driven normal of the section, first equation, \
         expected joints that agree where they constrain the same motion"
    );
    let held = short(with(rod::clamped(2, ClampedGradients::Section), [drive("motor", "t^3")]));
    assert!(
        held.check().unwrap_err()[0]
            .found
            .starts_with("equations that contradict `root`: driven normal of the section")
    );
    let point = |point| End::Point(Ground { point });
    let pull = |name: &str, to| Joint::spherical(name, rod::end(), point(to));
    let mut pulled =
        with(rod::cantilever(2), [pull("here", [0.9, 0.1, 0.0]), pull("there", [0.9, 0.2, 0.0])]);
    pulled.analysis = Analysis::Statics(Statics::default());
    assert!(pulled.check().unwrap_err()[0].found == "equations that contradict `here`: position along y");
}

/// The run finds contradictions of short duration between the instants of the check, which include kinks of formulas.
#[test]
fn short_contradictions_fail_the_run() {
    let jerk = "exp(-((t - 0.101)/0.00002)^2)";
    let mut model = short(with(rod::clamped(2, ClampedGradients::Section), [drive("motor", jerk)]));
    rod::settings(&mut model).max_halvings = 2;
    let summary = simulate(&model, &mut Series::new()).unwrap();
    let Outcome::Failed { time, reason, at, .. } = summary.outcome else { panic!("{:?}", summary.outcome) };
    assert!(reason.starts_with("joints contradict each other: "), "{reason}");
    assert!(
        at.starts_with(
            "joint `motor`: driven normal of the section, first equation, follows from joint `root`"
        ),
        "{at}"
    );
    assert!((time - 0.1005).abs() < 6e-4, "{time}");
}

/// Planar linkage of beams with hinges in space: over-constrained by Grübler's count, but not with deformable bodies.
#[test]
fn four_bar_linkage_of_beams_is_not_redundant() {
    let mut model = rod::free(2);
    let first = rod::beam(&mut model).clone();
    let points = [[0.0, 0.0, 0.0], [0.1, 0.5, 0.0], [1.1, 0.9, 0.0], [1.2, 0.0, 0.0]];
    let names = ["crank", "coupler", "rocker"];
    model.bodies = (0..3)
        .map(|k| {
            let (from, to, name) = (points[k], points[k + 1], names[k].to_owned());
            Body::Beam(Beam { name, from, to, formulation: Formulation::Linked, ..first.clone() })
        })
        .collect();
    let place = |k: usize, end| Place::new(names[k], At::Named(end));
    let hinge = |name: &str, a, b| Joint::revolute(name, a, b, [0.0, 0.0, 1.0]);
    model.joints = vec![
        hinge("o", place(0, NamedPosition::Start), End::Ground),
        hinge("a", place(1, NamedPosition::Start), End::Place(place(0, NamedPosition::End))),
        hinge("b", place(2, NamedPosition::Start), End::Place(place(1, NamedPosition::End))),
        hinge("c", place(2, NamedPosition::End), End::Ground),
    ];
    model.probes[0].on = place(1, NamedPosition::End);
    let diagnosis = model.diagnose().unwrap();
    assert_eq!(
        (diagnosis.gruebler, diagnosis.motions.as_ref().unwrap().len(), diagnosis.redundant.len()),
        (-2, 1, 0)
    );
    assert!(
        diagnosis.motions.as_ref().unwrap()[0]
            .starts_with("body `crank` can rotate about the axis through (0, 0, 0) along z")
    );
    // A second hinge beside the first carries half of the force; the motion is unchanged.
    let one = short(model);
    let two = with(one.clone(), [hinge("again", place(0, NamedPosition::Start), End::Ground)]);
    assert_eq!(redundant(&two).len(), 5);
    let (one, two) = (Run::of(&one), Run::of(&two));
    assert!(distance(&one.vectors("tip."), &two.vectors("tip.")) < 1e-9);
    let (whole, half) = (one.vectors("o.f"), two.vectors("again.f"));
    let doubled: Vec<_> = half.iter().map(|half| half * 2.0).collect();
    let size = whole.iter().map(Vector3::norm).fold(0.0, f64::max);
    assert!(distance(&whole, &doubled) < 1e-6 * size);
}

/// 1000 joints, half of them redundant, and a ring of 1000 links are analysed in well below 1 s.
#[test]
fn thousand_joints_are_analysed_within_a_second() {
    let mut model = rod::free(1);
    let first = rod::beam(&mut model).clone();
    model.bodies.clear();
    for k in 0..500 {
        let (y, name) = (f64::from(k), format!("rod {k}"));
        let place = Place::new(&name, At::Named(NamedPosition::Start));
        model.bodies.push(Body::Beam(Beam { name, from: [0.0, y, 0.0], to: [1.0, y, 0.0], ..first.clone() }));
        for n in 0..2 {
            model.joints.push(clamp(&format!("clamp {k} {n}"), place.clone(), ClampedGradients::All));
        }
    }
    model.probes.clear();
    let assembly = model.assemble().unwrap();
    let (rest, clock) = (assembly.rest(), Instant::now());
    assert_eq!(assembly.redundant_in(&rest, 1e-8).len(), 6000);
    let clamps = clock.elapsed().as_secs_f64();
    let ring = (0..3000).map(|k| sparse_row(vec![(k, 1.0), ((k + 3) % 3000, -1.0)])).collect();
    let clock = Instant::now();
    assert_eq!(dependences(ring, 1e-8).len(), 3);
    let ring = clock.elapsed().as_secs_f64();
    assert!(clamps < 1.0 && ring < 1.0, "{clamps} s and {ring} s, expected about 0.1 s");
}

fn rank(rows: &[SparseVector], columns: usize) -> usize {
    let matrix = DMatrix::from_fn(rows.len(), columns, |i, j| rows[i].get(&j).copied().unwrap_or(0.0));
    if rows.is_empty() { 0 } else { matrix.rank(1e-9) }
}

proptest! {
    /// The number of dependences is the rank deficiency. Each combination vanishes, and its last row depends on earlier rows.
    #[test]
    fn dependences_of_random_rows(
        entries in prop::collection::vec((0_usize..9, 0_usize..6, -3_i32..4), 0..24),
        units in prop::collection::vec(-6_i32..7, 15),
    ) {
        let mut plain = vec![SparseVector::new(); 9];
        for (i, j, x) in entries.into_iter().filter(|(.., x)| *x != 0) {
            plain[i].insert(j, f64::from(x));
        }
        let unit = |i: usize| 10_f64.powi(units[i]);
        let scaled = |i: usize| plain[i].iter().map(|(&j, x)| (j, x * unit(i) * unit(9 + j))).collect();
        let rows: Vec<SparseVector> = (0..9).map(scaled).collect();
        let found = dependences(rows.iter().map(|row| row.clone().into_iter().collect()).collect(), 1e-8);
        prop_assert_eq!(found.len(), 9 - rank(&plain, 6));
        for dependence in &found {
            let row = dependence.row();
            prop_assert_eq!(rank(&plain[..=row], 6), rank(&plain[..row], 6));
            for j in 0..6 {
                let entry = |i: usize| rows[i].get(&j).copied().unwrap_or(0.0);
                let terms = dependence.coefficients.iter().map(|(&i, c)| c * entry(i));
                let (sum, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
                prop_assert!(sum.abs() <= 1e-8 * size, "{} of {}", sum, size);
            }
        }
    }
}
