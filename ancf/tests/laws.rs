//! Laws that every term of the equations of motion obeys, whatever it models.
//!
//! A new element, joint or load joins the list in [`terms`] and is tested. Sections are stubby, so that no part of an
//! energy hides behind another. Most residuals are polynomials of degree three at most, so that five-point differences
//! with large steps are exact but for rounding; other smooth ones are differentiated by extrapolation.
#![cfg(test)]

#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "common/cables.rs"]
mod cables;
#[path = "common/continuum.rs"]
mod continuum;
#[path = "common/sample.rs"]
mod sample;

use std::sync::Arc;

use ancf::function::Function;
use ancf::mechanics::{
    Beam24, BeamMesh, BeamShape, Blueprint, CableDamping, Coincide, Drive, Force, Formulation, Marker,
    Medium, Node, Perpendicular, Profile,
};
use ancf::model::{Material, Section};
use ancf::system::{Energy, Local, LocalMatrix, Term, Weights};
use nalgebra::{DVector, Rotation3, SymmetricEigen, Vector3};
use sample::{
    Random, Sample, derivative, energy, extrapolated_derivative, residual, rounding, sizes, stress_stiffness,
    tangent,
};

fn assert_close(what: &str, a: &DVector<f64>, b: &DVector<f64>, tolerance: f64) {
    let (error, size) = ((a - b).amax(), a.amax().max(b.amax()).max(1.0));
    assert!(error <= tolerance * size, "{what}: {error:e} of {size:e}");
}

fn scalar(x: f64) -> DVector<f64> {
    DVector::from_element(1, x)
}

/// What kind of function of the state a residual is, and so how its derivative is to be had.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// A polynomial of degree three at most.
    Polynomial,
    /// Smooth in moderate deformation.
    Smooth,
    /// Smooth, and its tangent is the symmetric part of the derivative.
    Damped,
}

impl Kind {
    /// Coordinates are at most so large.
    fn reach(self) -> f64 {
        if self == Self::Polynomial { 1.0 } else { 0.1 }
    }

    /// Relative error of a derivative.
    fn tolerance(self) -> f64 {
        if self == Self::Polynomial { 1e-12 } else { 1e-11 }
    }

    fn derivative(self, f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
        if self == Self::Polynomial { derivative(f) } else { extrapolated_derivative(f) }
    }
}

/// A term under test.
struct Case {
    name: String,
    term: Box<dyn Term>,
    kind: Kind,
}

/// What any term must survive.
fn obeys_laws(Case { name, term, kind }: &Case, random: &mut Random) {
    let term = term.as_ref();
    let ((n, m), rest) = (sizes(term), Sample::rest(term));
    let (mut s, z) = (Sample::random(term, random), random.vector(n + m));
    s.q *= kind.reach();
    let w = Weights { q: 1.3 + random.number(), v: random.number(), a: 1.3 + random.number() };

    // The tangent is the derivative of the residual, its constraint rows divided by w_q.
    let mut product = tangent(term, &s, w) * &z;
    product.rows_mut(n, m).scale_mut(w.q);
    let mut slope = kind.derivative(|h| residual(term, &s.moved(&z, h, w)));
    if *kind == Kind::Damped {
        // z·Kz sees the symmetric part, all of it as z goes through all directions.
        (product, slope) = (scalar(product.dot(&z)), scalar(slope.dot(&z)));
    }
    assert_close(&format!("{name}: tangent"), &product, &slope, kind.tolerance());

    // Moved by q and v at once, the energy changes as the residual of conservative forces with v in the place of a has it:
    // dU = f dq, dT = M v dv.
    let both = Weights { q: 1.0, v: 1.0, a: 0.0 };
    let power = kind.derivative(|h| scalar(energy(term, &s.moved(&z, h, both)).total()));
    let at_rest = Sample { v: DVector::zeros(n), a: s.v.clone(), lambda: DVector::zeros(m), ..s.clone() };
    let work = scalar(residual(term, &at_rest).rows(0, n).dot(&z.rows(0, n)));
    assert_close(&format!("{name}: energy"), &power, &work, kind.tolerance());
    assert_eq!(energy(term, &rest), Energy::default(), "{name}: energy of the reference state");

    // The mass matrix is constant and not negative.
    let mass = tangent(term, &s, Weights { q: 0.0, v: 0.0, a: 1.0 }).view((0, 0), (n, n)).into_owned();
    let inertia = SymmetricEigen::new(mass).eigenvalues;
    assert!(inertia.min() >= -1e-14 * inertia.max(), "{name}: negative mass");

    // An ulp more or less in the state, rounded again on the way, is within twice the bound of one rounding; and the
    // bound is one of rounding, not of more.
    let (here, bound) = (residual(term, &s), rounding(term, &s));
    for _ in 0..20 {
        let mut ulp = |x: &DVector<f64>| x.map(|x| x * (1.0 + 0.5 * f64::EPSILON * random.number().signum()));
        let near = Sample { q: ulp(&s.q), v: s.v.clone(), a: ulp(&s.a), lambda: ulp(&s.lambda) };
        let moved = (residual(term, &near) - &here).abs();
        assert!(moved <= &bound * 2.0, "{name}: rounding {} beyond its bound {}", moved.amax(), bound.amax());
    }
    assert!(bound.amax() < 1e-12 * here.amax().max(1.0), "{name}: a bound of {:e}", bound.amax());
}

const LENGTH: f64 = 0.7;

/// An element with its reference coordinates.
struct Element {
    name: String,
    term: Beam24,
    reference: [Vector3<f64>; 8],
    slope: f64,
    section: Section,
    material: Material,
}

/// One element for every choice of section, Poisson's ratio, slope length and frame.
fn elements(gravity: Vector3<f64>) -> Vec<Element> {
    let tilted = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let mut elements = Vec::new();
    let sections = [
        Section::Circle { diameter: 0.3 },
        Section::Tube { outer: 0.3, inner: 0.2 },
        Section::Rectangle { height: 0.3, width: 0.2 },
        Section::Ellipse { height: 0.2, width: 0.3 },
    ];
    for section in sections {
        for poisson in [0.0, 0.3] {
            for slope in [1.0, LENGTH] {
                for rotation in [Rotation3::identity(), tilted] {
                    elements.push(element(section, poisson, slope, rotation, gravity));
                }
            }
        }
    }
    elements
}

fn element(section: Section, poisson: f64, slope: f64, r: Rotation3<f64>, gravity: Vector3<f64>) -> Element {
    let material = Material::elastic(2.0, 30.0, poisson);
    let shape = BeamShape { length: LENGTH, slope };
    let profile = Profile::new(shape, material.lame(), material.density, section.moments(), gravity);
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| r * axis);
    let [x, y, z] = frame.map(|axis| axis * slope);
    Element {
        name: format!("{section:?}, nu = {poisson}, slope length {slope}, frame {:.1}", frame[0].transpose()),
        term: Beam24::new(0..24, frame, Arc::new(profile)),
        reference: [Vector3::zeros(), x, y, z, frame[0] * LENGTH, x, y, z],
        slope,
        section,
        material,
    }
}

/// Constraints and loads on two tilted bodies of two elements each, at nodes and between them.
fn constraints_and_loads() -> Vec<(&'static str, Box<dyn Term>)> {
    let mesh = |first, rotation: Rotation3<f64>| {
        let section = Section::Circle { diameter: 0.3 }.cross_section(0.3);
        let lame = Material::elastic(2.0, 30.0, 0.3).lame();
        let medium = Medium {
            lame,
            neo_hookean: false,
            density: 2.0,
            retardation: 0.0,
            drag: 0.0,
            gravity: Vector3::zeros(),
        };
        let of = |_| section.clone();
        let origin = Vector3::new(0.1, -0.2, 0.3);
        let blueprint = Blueprint {
            first,
            origin,
            length: LENGTH,
            slope: LENGTH,
            medium: &medium,
            section: &of,
            prismatic: true,
        };
        let frame = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| rotation * axis);
        let nodes = [0.0, 1.0, 2.0].map(|k| Node { position: frame[0] * (k * LENGTH), frame });
        BeamMesh::two_node(&blueprint, &nodes, Formulation::Continuum)
    };
    let (a, b) = (mesh(0, Rotation3::identity()), mesh(36, Rotation3::from_euler_angles(0.4, -1.1, 2.3)));
    let (along, across) = (Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.48, 0.8, -0.36));
    let ground = Marker::fixed(across);
    let (point_a, point_b) = (a.point(0.31), b.point(LENGTH));
    let (direction_a, direction_b) = (a.direction(0.31, along), b.direction(2.0 * LENGTH, across));
    vec![
        ("points", Box::new(Coincide::points(&point_a, &point_b, 5))),
        ("point and ground", Box::new(Coincide::points(&point_a, &ground, 5))),
        ("points of one body", Box::new(Coincide::points(&point_a, &a.point(0.0), 5))),
        ("directions", Box::new(Coincide::directions(&direction_a, &direction_b, 5))),
        ("direction and ground", Box::new(Coincide::directions(&direction_a, &ground, 5))),
        ("perpendicular", Box::new(Perpendicular::new(&direction_a, &direction_b, 5))),
        ("perpendicular to the ground", Box::new(Perpendicular::new(&direction_a, &ground, 5))),
        (
            "perpendicular within a body",
            Box::new(Perpendicular::new(&direction_a, &a.direction(0.0, across), 5)),
        ),
        ("toward a point", Box::new(Coincide::toward(&point_a, across, 5))),
        (
            "drive",
            Box::new(Drive::new(&direction_a, Vector3::z(), 2.0, Function::Ramp { start: 0.0, end: 2.0 }, 5)),
        ),
        ("force", Box::new(Force::new(&point_a, Vector3::new(0.3, -2.0, 0.7)))),
    ]
}

/// Every kind of term there is.
fn terms() -> Vec<Case> {
    let gravity = Vector3::new(0.3, -2.0, 0.7);
    let beams = elements(gravity).into_iter().map(|e| (e.name, Box::new(e.term) as Box<dyn Term>));
    let others = constraints_and_loads().into_iter().map(|(name, term)| (name.to_owned(), term));
    let polynomials = beams.chain(others).map(|(name, term)| Case { name, term, kind: Kind::Polynomial });
    let cables = [(CableDamping::default(), Kind::Smooth), (cables::DAMPING, Kind::Damped)];
    let cables = cables.into_iter().flat_map(|(damping, kind)| {
        let case = move |cable: cables::Cable| Case { name: cable.name, term: Box::new(cable.term), kind };
        cables::cables(damping, gravity).into_iter().map(case)
    });
    polynomials.chain(cables).collect()
}

#[test]
fn every_term_obeys_the_laws() {
    let mut random = Random(2017);
    for case in terms() {
        for _ in 0..10 {
            obeys_laws(&case, &mut random);
        }
    }
}

/// The third derivative of the energy and of λ·Φ is what stresses and what displacements add to the stiffness. With T the
/// stiffness of initial stresses, D³(x, y, z) = x·T(z)y + y·T(x)z + z·T(y)x, if the strains are quadratic; those of other terms,
/// in the reference state.
#[test]
fn stress_stiffness_is_a_third_of_the_third_derivative() {
    let mut random = Random(1961);
    for Case { name, term, kind } in terms() {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        for _ in 0..5 {
            let mut s = Sample::rest(term);
            if kind == Kind::Polynomial {
                s = Sample { v: s.v, a: s.a, ..Sample::random(term, &mut random) };
            }
            let [x, y, z] = std::array::from_fn(|_| random.vector(n + m));
            let k = |h: f64| tangent(term, &s.moved(&z, h, Weights::STIFFNESS), Weights::STIFFNESS);
            let third = kind.derivative(|h| scalar(x.dot(&(k(h) * &y))));
            let of = |z, x: &DVector<f64>, y| x.dot(&(stress_stiffness(term, &s, z, 0.0) * y));
            let sum = scalar(of(&z, &x, &y) + of(&x, &y, &z) + of(&y, &z, &x));
            assert_close(&format!("{name}: stress stiffness"), &sum, &third, 1e-11);
            let dead = stress_stiffness(term, &s, &DVector::zeros(n + m), 1.0).amax();
            assert_eq!(dead, 0.0, "{name}: loads are dead");
        }
    }
}

/// A load that grows with its point's displacement, beside a spring.
struct Magnet;

impl Term for Magnet {
    fn coordinates(&self) -> &[usize] {
        &[0]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += (5.0 - 3.0 * at.load) * at.q[0];
    }

    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.q * (5.0 - 3.0 * at.load));
    }
}

/// Per load factor, whatever the load so far.
#[test]
fn loads_have_their_stiffness_without_being_asked() {
    let s = Sample::random(&Magnet, &mut Random(1));
    assert_eq!(stress_stiffness(&Magnet, &s, &scalar(0.2), 2.0)[(0, 0)], -6.0);
}

#[test]
fn every_term_names_its_coordinates_once() {
    for Case { name, term, .. } in terms() {
        let mut coordinates = term.coordinates().to_vec();
        coordinates.sort_unstable();
        coordinates.dedup();
        assert_eq!(coordinates.len(), term.coordinates().len(), "{name}");
    }
}

/// Translation and rotation of any size: no energy, no elastic force.
#[test]
fn rigid_motion_costs_nothing() {
    let mut random = Random(24);
    for Element { name, term, reference, slope, section, material, .. } in elements(Vector3::zeros()) {
        let stiffness = material.young * section.moments().area;
        for _ in 0..10 {
            let (turn, shift) = (Rotation3::new(random.vector3() * 3.0), random.vector3() * 10.0);
            let mut at = Sample::rest(&term);
            for (k, e) in reference.iter().enumerate() {
                let moved = turn * e - e + if k % 4 == 0 { shift } else { Vector3::zeros() };
                at.q.rows_mut(3 * k, 3).copy_from(&moved);
            }
            let force = residual(&term, &at).amax() / slope;
            assert!(force < 1e-10 * stiffness, "{name}: force {force:e}");
            let strain = energy(&term, &at).strain;
            assert!(strain < 1e-20 * stiffness * LENGTH, "{name}: energy {strain:e}");
        }
    }
}

/// A small translation and rotation of a deformed element causes no stress.
#[test]
fn rigid_motion_adds_no_stress() {
    let mut random = Random(25);
    for Element { name, term, reference, .. } in elements(Vector3::zeros()) {
        let (s, shift, spin) = (Sample::random(&term, &mut random), random.vector3(), random.vector3());
        let mut z = DVector::zeros(24);
        for (k, e) in reference.iter().enumerate() {
            let moved = spin.cross(&(e + s.q.fixed_rows::<3>(3 * k)));
            z.rows_mut(3 * k, 3).copy_from(&(moved + if k % 4 == 0 { shift } else { Vector3::zeros() }));
        }
        let size = stress_stiffness(&term, &s, &random.vector(24), 0.0).amax();
        let rigid = stress_stiffness(&term, &s, &z, 0.0).amax();
        assert!(rigid < 1e-13 * size, "{name}: {rigid:e} of {size:e}");
    }
}

/// A free element has six motions without stiffness, three translations and three rotations, and no other.
#[test]
fn stiffness_has_six_free_motions_and_mass_none() {
    for Element { name, term, .. } in elements(Vector3::zeros()) {
        let rest = Sample::rest(&term);
        let eigenvalues = |w| {
            let mut values = SymmetricEigen::new(tangent(&term, &rest, w)).eigenvalues.data.as_vec().clone();
            values.sort_unstable_by(f64::total_cmp);
            values
        };
        let (stiffness, mass) = (eigenvalues(Weights::STIFFNESS), eigenvalues(Weights::MASS));
        assert!(stiffness[0] > -1e-13 * stiffness[23], "{name}: {stiffness:?}");
        assert!(stiffness[5] < 1e-13 * stiffness[23], "{name}: {stiffness:?}");
        assert!(stiffness[6] > 1e-5 * stiffness[23], "{name}: {stiffness:?}");
        assert!(mass[0] > 1e-5 * mass[23], "{name}: {mass:?}");
    }
}

/// ½∫(λ tr² E + 2G E:E) dV over the volume, by 125 points and more, is what the element makes of moments of area.
#[test]
fn strain_energy_is_that_of_the_continuum() {
    let mut random = Random(31);
    for Element { name, term, reference, slope, section, material, .. } in elements(Vector3::zeros()) {
        let lame = material.lame();
        for _ in 0..5 {
            let at = Sample::random(&term, &mut random);
            let e = std::array::from_fn(|k| reference[k] + at.q.fixed_rows::<3>(3 * k));
            let density = |x: [f64; 3]| {
                let gradients = continuum::shape_gradients(LENGTH, slope, x);
                let strain = continuum::green_strain(&continuum::deformation_gradient(&e, &gradients));
                0.5 * lame.lambda * strain.trace().powi(2) + lame.shear * strain.norm_squared()
            };
            let (brute, exact) = (continuum::integrate(LENGTH, section, density), energy(&term, &at).strain);
            assert!((exact / brute - 1.0).abs() < 1e-13, "{name}: {exact} and {brute}");
        }
    }
}

/// ½∫ρ v·v dV and −∫ρ g·u dV likewise.
#[test]
fn kinetic_and_potential_energy_are_those_of_the_continuum() {
    let (mut random, gravity) = (Random(18), Vector3::new(0.3, -2.0, 0.7));
    for Element { name, term, slope, section, material, .. } in elements(gravity) {
        let at = Sample::random(&term, &mut random);
        let field = |nodes: &DVector<f64>, x| -> Vector3<f64> {
            let values = continuum::shape_values(LENGTH, slope, x);
            values.iter().enumerate().map(|(k, s)| nodes.fixed_rows::<3>(3 * k) * *s).sum()
        };
        let kinetic = |x| 0.5 * material.density * field(&at.v, x).norm_squared();
        let potential = |x| -at.local().load * material.density * gravity.dot(&field(&at.q, x));
        let exact = energy(&term, &at);
        let brute = continuum::integrate(LENGTH, section, kinetic);
        assert!((exact.kinetic / brute - 1.0).abs() < 1e-13, "{name}: {} and {brute}", exact.kinetic);
        let brute = continuum::integrate(LENGTH, section, potential);
        assert!((exact.potential - brute).abs() < 1e-14, "{name}: {} and {brute}", exact.potential);
    }
}
