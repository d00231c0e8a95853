//! Paths of equilibria through limit points: a truss in closed form, Lee's frame, a column beyond its buckling load.
#![cfg(test)]

#[path = "common/rod.rs"]
#[expect(dead_code, reason = "other test binaries use the rest")]
mod rod;

use std::ops::ControlFlow;

use ancf::Model;
use ancf::analysis::{ArcSteps, Left, Limit, Newton, Path, PathPoint, Stop, Until};
use ancf::mechanics::{BeamMesh, Coincide, Force, Marker, Perpendicular};
use ancf::model::{Assembly, Beam, Body, Formulation, Load, Material, ScaleChoice, Section};
use ancf::system::{Energy, EquationsOfMotion, Local, LocalMatrix, State, System, Term, Weights};
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

/// The shallow truss of von Mises: two bars from (±a, 0) to the apex (0, h), pushed down through a spring.
///
/// ```text
///            P = load × `push`
///            v
///            <  spring, its upper end sinks by q[2]
///            o  apex (q[0], h − q[1])
///        /       \
///     /             \
///   ^                 ^
/// ```
///
/// Green's strain ε = (l² − L²)/2L² and energy ½ EA L ε² of each bar give P = EA (h² − z²) z / L³ at the height z, limits
/// at z = ±h/√3. With a mass of one at each point.
struct Truss {
    a: f64,
    h: f64,
    stiffness: f64,
    spring: f64,
    push: f64,
}

impl Truss {
    fn system(self) -> System {
        System::new(3, 0, vec![Box::new(self)])
    }

    fn cube(&self) -> f64 {
        self.a.hypot(self.h).powi(3)
    }

    /// The load at a height of the apex.
    fn load(&self, z: f64) -> f64 {
        self.stiffness * (self.h * self.h - z * z) * z / self.cube()
    }

    /// Vectors from the supports to the apex.
    fn bars(&self, q: &[f64]) -> [[f64; 2]; 2] {
        [[self.a + q[0], self.h - q[1]], [q[0] - self.a, self.h - q[1]]]
    }

    /// l² − L² of a bar.
    fn growth(&self, [x, z]: [f64; 2]) -> f64 {
        x * x + z * z - self.a * self.a - self.h * self.h
    }
}

impl Term for Truss {
    fn coordinates(&self) -> &[usize] {
        &[0, 1, 2]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        for bar in self.bars(at.q) {
            let n = 0.5 * self.stiffness / self.cube() * self.growth(bar);
            r[0] += n * bar[0];
            r[1] -= n * bar[1];
        }
        let force = self.spring * (at.q[2] - at.q[1]);
        r[1] -= force;
        r[2] += force - at.load * self.push;
        r.iter_mut().zip(at.a).for_each(|(r, a)| *r += a);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        for bar in self.bars(at.q) {
            let size = self.stiffness / self.cube() * (self.a * self.a + self.h * self.h);
            floor[0] += f64::EPSILON * size * bar[0].abs();
            floor[1] += f64::EPSILON * size * bar[1].abs();
        }
        let force = self.spring * (at.q[2].abs() + at.q[1].abs());
        floor[1] += f64::EPSILON * force;
        floor[2] += f64::EPSILON * (force + (at.load * self.push).abs());
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        for bar in self.bars(at.q) {
            let c = w.q * self.stiffness / self.cube();
            let direction = [bar[0], -bar[1]];
            for i in 0..2 {
                k.add(i, i, 0.5 * c * self.growth(bar));
                for j in 0..=i {
                    k.add(i, j, c * direction[i] * direction[j]);
                }
            }
        }
        k.add(1, 1, w.q * self.spring);
        k.add(2, 2, w.q * self.spring);
        k.add(2, 1, -w.q * self.spring);
        for i in 0..3 {
            k.add(i, i, w.a);
        }
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let square = self.a * self.a + self.h * self.h;
        let bars = self.bars(at.q).map(|bar| self.growth(bar).powi(2)).iter().sum::<f64>();
        let strain = bars * self.stiffness * square.sqrt() / (8.0 * square * square)
            + 0.5 * self.spring * (at.q[2] - at.q[1]).powi(2);
        Energy { strain, potential: -at.load * self.push * at.q[2], ..Energy::default() }
    }
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
        let (points, left) = follow(&truss(spring).system(), ArcSteps::from(0.2 * peak), until_load(2.0 * peak));
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

/// The same points, whatever the unit of the load factor and of length; ends by number, by length and by the receiver.
#[test]
fn ends_of_a_path() {
    let system = truss(50.0).system();
    let until = Until { load: None, points: 7, length: f64::INFINITY };
    let (points, left) = follow(&system, ArcSteps::from(0.05), until);
    assert_eq!((points.len(), left), (7, Left::Points));
    let (points, left) = follow(&system, ArcSteps::from(0.05), Until { load: None, points: 1000, length: 0.3 });
    assert_eq!(left, Left::Length);
    assert!((points[points.len() - 1].1.length - 0.3).abs() < 1e-12);
    let mut path = Path::new(&system, newton(&system), ArcSteps::from(0.05), unloaded(&system)).unwrap();
    let left = path.follow(&until_load(10.0), |_, _| ControlFlow::Break(()));
    assert_eq!(left.unwrap(), Left::Broken);
    // Upwards the bars are pulled and the load has no limit.
    let mut path = Path::new(&system, newton(&system), ArcSteps::from(0.05), unloaded(&system)).unwrap().reversed();
    let mut limits = 0;
    let left = path.follow(&until_load(-3.0), |_, point| {
        limits += usize::from(point.limit.is_some());
        ControlFlow::Continue(())
    });
    assert_eq!((left.unwrap(), limits, path.state().load), (Left::Load, 0, -3.0));
}

/// Lee's frame: two legs of 120, hinged at their far ends, and P = load × 10⁴ down on the girder 24 from the corner.
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
fn lees_frame(elements: u32, formulation: Formulation) -> (System, Marker) {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let leg = |name: &str, ends, up: Vector3<f64>| {
        let straight = Beam::straight(name, ends, elements, "section", "material");
        Body::Beam(Beam { up: Some(up.into()), formulation, ..straight })
    };
    let model = Model {
        gravity: [0.0; 3],
        materials: [("material".into(), Material::elastic(1.0, 7.2e6, 0.0))].into(),
        sections: [("section".into(), Section::Rectangle { height: 2.0, width: 3.0 })].into(),
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
fn lees_path(elements: u32, formulation: Formulation) -> Vec<([f64; 3], PathPoint)> {
    let (system, loaded) = lees_frame(elements, formulation);
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

fn probe(name: &str, elements: u32, formulation: Formulation) {
    let points = lees_path(elements, formulation);
    let iterations: u32 = points.iter().map(|(_, p)| p.equilibrium.iterations).sum();
    let top = points.iter().map(|(p, _)| p[2]).scan(0, |_, w| Some(w)).take(60).fold(0.0, f64::max);
    println!("{name} {elements} points {} iterations {iterations} w {top}", points.len());
    for (p, q) in points.iter().filter(|(_, p)| p.limit.is_some()) {
        println!("   {p:?} {:?}", q.limit);
    }
    let mut seen: Vec<_> = points.iter().map(|(_, p)| p.equilibrium.unstable).collect();
    seen.dedup();
    println!("   {seen:?}");
}

#[test]
fn lee() {
    for n in [10, 20, 40] {
        probe("continuum", n, Formulation::Continuum);
    }
    for n in [5, 10, 20, 40] {
        probe("linked", n, Formulation::Linked);
    }
    for n in [10, 20, 40] {
        probe("enhanced", n, Formulation::Enhanced);
    }
    for n in [5, 10, 20] {
        probe("quadratic", n, Formulation::Quadratic);
    }
}
#[test]
fn debug_truss() {
    let peak = truss(1.0).load(1.0 / 3.0_f64.sqrt());
    for spring in [50.0, 0.8] {
    let (points, _) = follow(&truss(spring).system(), ArcSteps::from(0.1 * peak), until_load(2.0 * peak));
    for (s, p) in &points {
        println!("{:.5} P {:9.5} w {:9.5} u {:9.5} slope {:9.5} {:?} it {} att {} {:?}", p.length, s.load/peak, s.q[1], s.q[2], p.slope, p.limit, p.equilibrium.iterations, p.equilibrium.attempts, p.equilibrium.unstable);
    } }
}
