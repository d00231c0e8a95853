//! Paths of equilibria through limit points: a truss in closed form, Lee's frame, a column beyond its buckling load.

use std::ops::ControlFlow;

use super::truss::Truss;
use crate::common::models::rod;
use ancf::Model;
use ancf::analysis::{ArcSteps, Left, Limit, Newton, Path, PathPoint, Stop, Until};
use ancf::mechanics::{BeamMesh, Coincide, Force, Marker, Perpendicular};
use ancf::model::{Beam, Body, Formulation, Material, Section};
use ancf::system::{EquationsOfMotion, State, System};
use nalgebra::Vector3;

fn newton(system: &System) -> Newton {
    Newton::new(system.matrix(), Stop::Energy(1e-10), 50).unwrap()
}

fn unloaded(system: &System) -> State {
    State { load: 0.0, ..State::rest(system.coordinates(), system.multipliers()) }
}

/// The points of a path from the unloaded state, and why it ended.
fn follow(system: &System, steps: ArcSteps, until: Until) -> (Vec<(State, PathPoint)>, Left) {
    let mut path = Path::new(system, newton(system), steps, unloaded(system)).unwrap();
    let mut points = Vec::new();
    let left = path.follow(&until, |s, point| {
        points.push((s.clone(), *point));
        ControlFlow::Continue(())
    });
    (points, left.unwrap())
}

const fn until_load(load: f64) -> Until {
    Until { load: Some(load), points: 1000, length: f64::INFINITY }
}

fn assert_relative(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = (value / reference - 1.0).abs();
    assert!(error <= tolerance, "{what}: {value} instead of {reference}, {error:e} off");
}

/// With stiff springs the apex snaps through, with soft ones the point that is pushed snaps back as well.
fn truss(spring: f64) -> Truss {
    Truss { a: 10.0, h: 1.0, stiffness: 2000.0, spring, push: 1.0 }
}

#[test]
fn von_mises_truss() {
    for spring in [50.0, 0.8] {
        let exact = truss(spring);
        let peak = exact.load(1.0 / 3.0_f64.sqrt());
        let (points, left) =
            follow(&truss(spring).system(), ArcSteps::from(0.2 * peak), until_load(2.0 * peak));
        assert_eq!(left, Left::Load);
        let limits: Vec<_> = points.iter().filter_map(|(s, p)| Some((p.limit?, s.load, s.q[1]))).collect();
        let [(Limit::Maximum, up, at_up), (Limit::Minimum, down, at_down)] = limits[..] else {
            panic!("limits {limits:?}")
        };
        assert_relative("largest load", up, peak, 1e-9);
        assert_relative("least load", down, -peak, 1e-9);
        // The place of an extremum is known to the root of the error of its value.
        assert_relative("place of the largest", at_up, 1.0 - 1.0 / 3.0_f64.sqrt(), 1e-4);
        assert_relative("place of the least", at_down, 1.0 + 1.0 / 3.0_f64.sqrt(), 1e-4);
        for (s, _) in &points {
            let z = exact.h - s.q[1];
            assert!((s.load - exact.load(z)).abs() <= 1e-8 * peak, "off the path at {z}");
            assert!((s.q[2] - s.q[1] - s.load / spring).abs() <= 1e-8, "off the spring's path");
            assert!(s.q[0].abs() <= 1e-9, "off the symmetric path");
        }
        assert_eq!(points[points.len() - 1].0.load, 2.0 * peak, "lands exactly");
    }
}

/// Between its limit points the path is unstable in one direction, and the soft spring's end turns back.
#[test]
fn snapping_is_unstable() {
    let peak = truss(1.0).load(1.0 / 3.0_f64.sqrt());
    let mut turns = Vec::new();
    for spring in [50.0, 0.8] {
        let (points, _) = follow(&truss(spring).system(), ArcSteps::from(0.1 * peak), until_load(2.0 * peak));
        for (s, point) in points.iter().filter(|(_, point)| point.limit.is_none()) {
            let inside = (s.q[1] - 1.0).abs() < 1.0 / 3.0_f64.sqrt();
            assert_eq!(point.equilibrium.unstable, Some(usize::from(inside)), "at {}", s.q[1]);
        }
        turns.push(points.windows(2).any(|pair| pair[1].0.q[2] < pair[0].0.q[2]));
        assert!(points.windows(2).all(|pair| pair[1].0.q[1] > pair[0].0.q[1]), "the apex sinks all the way");
    }
    assert_eq!(turns, [false, true]);
}

/// A path ends by the number of points, by its length and by the receiver; it has two directions.
#[test]
fn ends_of_a_path() {
    let system = truss(50.0).system();
    let until = Until { load: None, points: 7, length: f64::INFINITY };
    let (points, left) = follow(&system, ArcSteps::from(0.05), until);
    assert_eq!((points.len(), left), (7, Left::Points));
    let (points, left) =
        follow(&system, ArcSteps::from(0.05), Until { load: None, points: 1000, length: 0.3 });
    assert_eq!(left, Left::Length);
    assert!((points[points.len() - 1].1.length - 0.3).abs() < 1e-12);
    let mut path = Path::new(&system, newton(&system), ArcSteps::from(0.05), unloaded(&system)).unwrap();
    let left = path.follow(&until_load(10.0), |_, _| ControlFlow::Break(()));
    assert_eq!(left.unwrap(), Left::Broken);
    // Upwards the bars are pulled and the load has no limit.
    let mut path =
        Path::new(&system, newton(&system), ArcSteps::from(0.05), unloaded(&system)).unwrap().reversed();
    let mut limits = 0;
    let left = path.follow(&until_load(-3.0), |_, point| {
        limits += usize::from(point.limit.is_some());
        ControlFlow::Continue(())
    });
    assert_eq!((left.unwrap(), limits, path.state().load), (Left::Load, 0, -3.0));
}

/// Lee's frame: two legs of 120, h × 24/h³ across, with EI = 1.44e7, hinged at their far ends, and P = load × 10⁴ down on the girder 24 from the corner.
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
/// The corner keeps the right angle between the sections: a clamp would tie r_y of one beam to r_x of the other, which is
/// free within an ever smaller element, so that finer meshes would make the corner a hinge.
fn lees_frame(elements: u32, formulation: Formulation, height: f64) -> (System, Marker) {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let leg = |name: &str, ends, up: Vector3<f64>| {
        let straight = Beam::straight(name, ends, elements, "section", "material");
        Body::Beam(Beam { up: Some(up.into()), formulation, ..straight })
    };
    let section = Section::Rectangle { height, width: 24.0 / height.powi(3) };
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
        terms.push(Box::new(Perpendicular::new(a, b, multipliers)));
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
        terms.push(Box::new(Coincide::points(&b, &a, multipliers)));
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
    let steps = ArcSteps { largest: 0.25, ..ArcSteps::from(0.2) };
    let (points, left) = follow(&system, steps, until_load(2.5));
    assert_eq!(left, Left::Load);
    let at = |s: &State| {
        let moved = loaded.sum(&s.q);
        assert!(moved.z.abs() < 1e-6, "out of the plane");
        [1e4 * s.load, moved.x, -moved.y]
    };
    points.iter().map(|(s, point)| (at(s), *point)).collect()
}

/// P, u, w where P has its limits, for the exact rod without shear.
const TOP: [f64; 3] = [18556.727538, 26.880574, 48.7351372];
const BOTTOM: [f64; 3] = [-9414.431556, 90.195674, 58.2168153];

/// Limit points, by how much P and the displacements may differ from those of the rod.
fn assert_limits(points: &[([f64; 3], PathPoint)], force: f64, place: f64) {
    let limits: Vec<_> = points.iter().filter_map(|(at, point)| Some((point.limit?, *at))).collect();
    let [(Limit::Maximum, top), (Limit::Minimum, bottom)] = limits[..] else { panic!("limits {limits:?}") };
    for (at, reference) in [(top, TOP), (bottom, BOTTOM)] {
        for (i, tolerance) in [force, place, place].into_iter().enumerate() {
            assert_relative(["P", "u", "w"][i], at[i], reference[i], tolerance);
        }
    }
}

/// Snap-through of the load and snap-back of the point under it, against the rod without shear. Shear adds −0.04 % and
/// +0.15 % to the limits; the rest is the finite thickness of a St. Venant-Kirchhoff section, which goes with h².
///
/// Source: a planar rod by shooting, residuals below 1e-12; Lee, Manuel & Rossow (1968).
#[test]
fn lees_frame_snaps() {
    let points = lees_path(10, Formulation::Quadratic, 2.0);
    assert_limits(&points, 1e-2, 2e-3);
    // The point under the load sinks, rises while the load falls, and sinks again.
    let w: Vec<f64> = points.iter().map(|(at, _)| at[2]).collect();
    let turns: Vec<usize> =
        (1..w.len() - 1).filter(|&i| (w[i] - w[i - 1]) * (w[i + 1] - w[i]) < 0.0).collect();
    let [back, on] = turns[..] else { panic!("turns {turns:?}") };
    assert_relative("w turns back", w[back], 61.0029789, 2e-3);
    assert_relative("w turns on", w[on], 50.7462514, 2e-3);
    // Unstable in the plane between the limits, and out of it from shortly before the first to shortly before the second.
    let mut stability: Vec<_> = points.iter().filter(|(_, point)| point.limit.is_none()).collect();
    stability.dedup_by_key(|(_, point)| point.equilibrium.unstable);
    let counts: Vec<_> = stability.iter().map(|(_, point)| point.equilibrium.unstable).collect();
    assert_eq!(counts, [0, 1, 2, 1, 0].map(Some));
    for ((at, _), u) in stability[1..].iter().zip([23.5, TOP[1], 85.4, BOTTOM[1]]) {
        assert!(at[1] >= u - 0.5 && at[1] <= u + 3.0, "unstable at u = {}", at[1]);
    }
}

/// The load and the drop at places of the path, in their order.
#[test]
fn lees_frame_path() {
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
        let [(a, _), (b, _)] = pair else { panic!("a pair") };
        let part = (u - a[1]) / (b[1] - a[1]);
        let [p, _, drop] = [0, 1, 2].map(|i| a[i] + part * (b[i] - a[i]));
        assert!((p - force).abs() <= 5e-3 * TOP[0], "P = {p} at u = {u}");
        assert_relative("w", drop, w, 5e-3);
    }
}

/// The same limits with a section half as high.
#[test]
fn lees_frame_of_a_thinner_section() {
    assert_limits(&lees_path(10, Formulation::Quadratic, 1.0), 2e-3, 3e-4);
}

/// The plain element needs 40 to a leg.
#[test]
fn lees_frame_of_the_plain_element() {
    assert_limits(&lees_path(40, Formulation::Continuum, 2.0), 3e-3, 1e-3);
}
