//! Equilibrium paths through limit points: von Mises truss in closed form, Lee's frame.

use std::ops::ControlFlow;

use ancf::Model;
use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::constraints::{CoincidenceConstraint, ConstantAngle};
use ancf::mechanics::forces::Force;
use ancf::mechanics::kinematics::Marker;
use ancf::model::{Beam, Body, Formulation, Material, Section};
use ancf::solver::equations::{EquationsOfMotion, State, System};
use ancf::solver::newton::{Newton, StopRule};
use ancf::solver::statics::{ArcLength, ArcLengthSteps, EndConditions, EndReason, LimitPoint, PathPoint};
use nalgebra::Vector3;

use super::truss::Truss;
use crate::common::assertions::assert_relative;
use crate::common::models::rod;

fn newton(system: &System) -> Newton {
    Newton::new(system.matrix(), StopRule::Energy(1e-10), 50).unwrap()
}

fn unloaded(system: &System) -> State {
    State { load: 0.0, ..State::rest(system.coordinates(), system.multipliers()) }
}

/// Points of a path from the unloaded state, and the reason for its end.
fn follow(
    system: &System,
    steps: ArcLengthSteps,
    until: EndConditions,
) -> (Vec<(State, PathPoint)>, EndReason) {
    let mut path = ArcLength::new(system, newton(system), steps, unloaded(system)).unwrap();
    let mut points = Vec::new();
    let left = path.follow(&until, |s, point| {
        points.push((s.clone(), *point));
        ControlFlow::Continue(())
    });
    (points, left.unwrap())
}

/// Ends a path at a load factor.
const fn until_load(load: f64) -> EndConditions {
    EndConditions { load: Some(load), points: 1000, length: f64::INFINITY }
}

/// Stiff springs cause snap-through of the apex; soft ones also cause snap-back of the loaded point.
fn truss(spring: f64) -> Truss {
    Truss { a: 10.0, h: 1.0, stiffness: 2000.0, spring, push: 1.0 }
}

#[test]
fn von_mises_truss_has_its_closed_path() {
    for spring in [50.0, 0.8] {
        let exact = truss(spring);
        let peak = exact.load(1.0 / 3.0_f64.sqrt());
        let (points, left) =
            follow(&truss(spring).system(), ArcLengthSteps::from(0.2 * peak), until_load(2.0 * peak));
        assert_eq!(left, EndReason::Load);
        let limits: Vec<_> = points.iter().filter_map(|(s, p)| Some((p.limit?, s.load, s.q[1]))).collect();
        let [(LimitPoint::Maximum, up, at_up), (LimitPoint::Minimum, down, at_down)] = limits[..] else {
            panic!("limits {limits:?}")
        };
        assert_relative("largest load", up, peak, 1e-9);
        assert_relative("least load", down, -peak, 1e-9);
        // The error of the position of an extremum is the square root of the error of its value.
        assert_relative("place of the largest", at_up, 1.0 - 1.0 / 3.0_f64.sqrt(), 1e-4);
        assert_relative("place of the least", at_down, 1.0 + 1.0 / 3.0_f64.sqrt(), 1e-4);
        for (s, _) in &points {
            let z = exact.h - s.q[1];
            assert!((s.load - exact.load(z)).abs() <= 1e-8 * peak, "not on the path at {z}");
            assert!((s.q[2] - s.q[1] - s.load / spring).abs() <= 1e-8, "spring force");
            assert!(s.q[0].abs() <= 1e-9, "not on the symmetric path");
        }
        assert_eq!(points[points.len() - 1].0.load, 2.0 * peak, "the last load is exact");
    }
}

/// One unstable direction between the limit points; the end of the soft spring reverses its motion.
#[test]
fn path_is_unstable_between_limit_points() {
    let peak = truss(1.0).load(1.0 / 3.0_f64.sqrt());
    let mut reversals = Vec::new();
    for spring in [50.0, 0.8] {
        let (points, _) =
            follow(&truss(spring).system(), ArcLengthSteps::from(0.1 * peak), until_load(2.0 * peak));
        for (s, point) in points.iter().filter(|(_, point)| point.limit.is_none()) {
            let inside = (s.q[1] - 1.0).abs() < 1.0 / 3.0_f64.sqrt();
            assert_eq!(point.equilibrium.unstable, Some(usize::from(inside)), "at {}", s.q[1]);
        }
        reversals.push(points.windows(2).any(|pair| pair[1].0.q[2] < pair[0].0.q[2]));
        assert!(
            points.windows(2).all(|pair| pair[1].0.q[1] > pair[0].0.q[1]),
            "the apex moves down monotonically"
        );
    }
    assert_eq!(reversals, [false, true]);
}

/// End by the number of points, by the length and by the receiver; reversed direction.
#[test]
fn path_ends_by_points_length_or_receiver() {
    let system = truss(50.0).system();
    let until = EndConditions { load: None, points: 7, length: f64::INFINITY };
    let (points, left) = follow(&system, ArcLengthSteps::from(0.05), until);
    assert_eq!((points.len(), left), (7, EndReason::Points));
    let (points, left) =
        follow(&system, ArcLengthSteps::from(0.05), EndConditions { load: None, points: 1000, length: 0.3 });
    assert_eq!(left, EndReason::Length);
    assert!((points[points.len() - 1].1.length - 0.3).abs() < 1e-12);
    let mut path =
        ArcLength::new(&system, newton(&system), ArcLengthSteps::from(0.05), unloaded(&system)).unwrap();
    let left = path.follow(&until_load(10.0), |_, _| ControlFlow::Break(()));
    assert_eq!(left.unwrap(), EndReason::Stopped);
    // Upward loads stretch the bars; the path has no limit point.
    let mut path = ArcLength::new(&system, newton(&system), ArcLengthSteps::from(0.05), unloaded(&system))
        .unwrap()
        .reversed();
    let mut limits = 0;
    let left = path.follow(&until_load(-3.0), |_, point| {
        limits += usize::from(point.limit.is_some());
        ControlFlow::Continue(())
    });
    assert_eq!((left.unwrap(), limits, path.state().load), (EndReason::Load, 0, -3.0));
}

/// Lee's frame: two legs of length 120 with the section h × 24/h³, EI = 1.44e7, hinged at their far ends.
///
/// P = load × 10⁴ acts downwards on the girder at the distance 24 from the corner.
///
/// ```text
///        24  | P
///      o-----v--------------------^
///      |        girder, 120
///      |
///      | column, 120
///      ^
/// ```
///
/// The corner constrains the right angle between the sections. A clamp would couple r_y of one beam to r_x of the other,
/// which is free inside the element: with finer meshes the corner would become a hinge.
fn lees_frame(elements: u32, formulation: Formulation, height: f64) -> (System, Marker) {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let leg = |name: &str, ends, up: Vector3<f64>| {
        let straight = Beam::straight(name, ends, elements, "section", "material");
        Body::Beam(Beam { up: Some(up.into()), formulation, ..straight })
    };
    let section = Section::rectangle(height, 24.0 / height.powi(3));
    let model = Model {
        gravity: [0.0; 3],
        materials: [("material".into(), Material::elastic(1.0, 7.2e6, 0.0))].into(),
        sections: [("section".into(), section)].into(),
        bodies: vec![
            leg("column", [[0.0; 3], [0.0, 120.0, 0.0]], x),
            leg("girder", [[0.0, 120.0, 0.0], [120.0, 120.0, 0.0]], y),
        ],
        probes: Vec::new(),
        ..rod::free(1)
    };
    let assembly = model.assemble().unwrap();
    let [column, girder] = ["column", "girder"].map(|name| assembly.mesh(name).unwrap());
    let mut terms = [column.terms(), girder.terms()].into_iter().flatten().collect::<Vec<_>>();
    let mut multipliers = 0;
    let mut perpendicular = |a: &Marker, b: &Marker| {
        terms.push(Box::new(ConstantAngle::new(a, b, multipliers)));
        multipliers += 1;
    };
    let direction = |mesh: &BeamMesh, s, of| mesh.direction(s, of);
    for (mesh, s) in [(column, 0.0), (girder, 120.0)] {
        perpendicular(&direction(mesh, s, z), &Marker::fixed(x));
        perpendicular(&direction(mesh, s, z), &Marker::fixed(y));
    }
    perpendicular(&girder.direction(0.0, y), &column.direction(120.0, x));
    perpendicular(&girder.direction(0.0, y), &column.direction(120.0, z));
    perpendicular(&column.direction(120.0, x), &girder.direction(0.0, z));
    let ground = |point: Marker| (Marker::fixed(point.reference()), point);
    let corner = (girder.point(0.0), column.point(120.0));
    for (a, b) in [ground(column.point(0.0)), ground(girder.point(120.0)), corner] {
        terms.push(Box::new(CoincidenceConstraint::points(&b, &a, multipliers)));
        multipliers += 3;
    }
    let loaded = girder.point(24.0);
    terms.push(Box::new(Force::new(&loaded, Vector3::new(0.0, -1e4, 0.0))));
    let coordinates = column.coordinates() + girder.coordinates();
    (System::new(coordinates, multipliers, terms), loaded)
}

/// (P, u, w) of the points of Lee's frame up to P = 25 000, with the limits.
fn lees_path(elements: u32, formulation: Formulation, height: f64) -> Vec<([f64; 3], PathPoint)> {
    let (system, loaded) = lees_frame(elements, formulation, height);
    let steps = ArcLengthSteps { largest: 0.25, ..ArcLengthSteps::from(0.2) };
    let (points, left) = follow(&system, steps, until_load(2.5));
    assert_eq!(left, EndReason::Load);
    let at = |s: &State| {
        let moved = loaded.sum(&s.q);
        assert!(moved.z.abs() < 1e-6, "displacement out of the plane");
        [1e4 * s.load, moved.x, -moved.y]
    };
    points.iter().map(|(s, point)| (at(s), *point)).collect()
}

/// P, u, w at the limit points of the exact rod without shear.
const TOP: [f64; 3] = [18556.727538, 26.880574, 48.7351372];
const BOTTOM: [f64; 3] = [-9414.431556, 90.195674, 58.2168153];

/// Asserts the limit points within relative tolerances of P and of the displacements.
fn assert_limits(points: &[([f64; 3], PathPoint)], force: f64, place: f64) {
    let limits: Vec<_> = points.iter().filter_map(|(at, point)| Some((point.limit?, *at))).collect();
    let [(LimitPoint::Maximum, top), (LimitPoint::Minimum, bottom)] = limits[..] else {
        panic!("limits {limits:?}")
    };
    for (at, reference) in [(top, TOP), (bottom, BOTTOM)] {
        for (i, tolerance) in [force, place, place].into_iter().enumerate() {
            assert_relative(["P", "u", "w"][i], at[i], reference[i], tolerance);
        }
    }
}

/// Snap-through of the load and snap-back of the loaded point, against the rod without shear.
///
/// Shear changes the limit loads by −0.04 % and +0.15 %. The remaining error is due to the finite thickness of the
/// St. Venant-Kirchhoff section, of the order h².
///
/// Source: a planar rod by shooting, residuals below 1e-12; Lee, Manuel & Rossow (1968).
#[test]
fn lees_frame_has_its_limit_points() {
    let points = lees_path(10, Formulation::Quadratic, 2.0);
    assert_limits(&points, 1e-2, 2e-3);
    // The loaded point moves down, up while the load decreases, and down again.
    let w: Vec<f64> = points.iter().map(|(at, _)| at[2]).collect();
    let turns: Vec<usize> =
        (1..w.len() - 1).filter(|&i| (w[i] - w[i - 1]) * (w[i + 1] - w[i]) < 0.0).collect();
    let [largest, smallest] = turns[..] else { panic!("turns {turns:?}") };
    assert_relative("maximum of w", w[largest], 61.0029789, 2e-3);
    assert_relative("minimum of w", w[smallest], 50.7462514, 2e-3);
    // Instability in the plane between the limits, and out of the plane from shortly before the first to shortly before the
    // second limit.
    let mut stability: Vec<_> = points.iter().filter(|(_, point)| point.limit.is_none()).collect();
    stability.dedup_by_key(|(_, point)| point.equilibrium.unstable);
    let counts: Vec<_> = stability.iter().map(|(_, point)| point.equilibrium.unstable).collect();
    assert_eq!(counts, [0, 1, 2, 1, 0].map(Some));
    for ((at, _), u) in stability[1..].iter().zip([23.5, TOP[1], 85.4, BOTTOM[1]]) {
        assert!(at[1] >= u - 0.5 && at[1] <= u + 3.0, "unstable at u = {}", at[1]);
    }
}

/// Load and vertical displacement at given horizontal displacements, in the order of the path.
#[test]
fn lees_frame_has_its_path() {
    let points = lees_path(10, Formulation::Quadratic, 2.0);
    let mut rest = points.windows(2);
    for (u, force, w) in [
        (10.0, 15829.825191, 29.4368128),
        (20.0, 18159.703621, 42.6565341),
        (40.0, 17413.334037, 56.2415489),
        (60.0, 12545.351650, 60.9643858),
        (80.0, -1700.053370, 51.5705736),
        (90.0, -9412.201523, 57.9378957),
    ] {
        let pair = rest.find(|pair| pair[0].0[1] <= u && pair[1].0[1] > u).unwrap();
        let [(a, _), (b, _)] = pair else { panic!("two points") };
        let fraction = (u - a[1]) / (b[1] - a[1]);
        let [p, _, vertical] = [0, 1, 2].map(|i| a[i] + fraction * (b[i] - a[i]));
        assert!((p - force).abs() <= 5e-3 * TOP[0], "P = {p} at u = {u}");
        assert_relative("w", vertical, w, 5e-3);
    }
}

/// Limit points with half the section height.
#[test]
fn lees_frame_with_a_thin_section_has_its_limit_points() {
    assert_limits(&lees_path(10, Formulation::Quadratic, 1.0), 2e-3, 3e-4);
}

/// Limit points with 40 elements of the continuum formulation per leg.
#[test]
fn lees_frame_of_continuum_elements_has_its_limit_points() {
    assert_limits(&lees_path(40, Formulation::Continuum, 2.0), 3e-3, 1e-3);
}
