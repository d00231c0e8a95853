//! Laws that every term of the equations of motion obeys, whatever it models.
//!
//! A new element, joint or load joins the list in [`terms`] and is tested. Sections are stubby, so that no part of an
//! energy hides behind another. Most residuals are polynomials of degree three at most, so that five-point differences
//! with large steps are exact but for rounding; other smooth ones are differentiated by extrapolation.

use super::contacts;
use super::contacts::Loss;
use super::kind::Kind;
use super::links;
use super::magnet::Magnet;
use super::tied::{ORIGIN, bodies, constraints_and_loads, mesh};
use super::wet;
use crate::common::models::beams;
use crate::common::models::beams::Make;
use crate::common::models::cables;
use crate::common::sample::{
    Random, Sample, derivative, energy, extrapolated_derivative, residual, rounding, sizes, stress_stiffness,
    tangent,
};
use ancf::function::{ForceFunction, Function};
use ancf::mechanics::{CableDamping, ExternalForce, FollowerForce, Moment, RigidBody};
use ancf::model::{Damping, MaterialLaw};
use ancf::system::{Energy, Level, Local, Power, Term, Weights};
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, SymmetricEigen, Vector3};

fn assert_close(what: &str, a: &DVector<f64>, b: &DVector<f64>, tolerance: f64) {
    let (error, size) = ((a - b).amax(), a.amax().max(b.amax()).max(1.0));
    assert!(error <= tolerance * size, "{what}: {error:e} of {size:e}");
}

fn scalar(x: f64) -> DVector<f64> {
    DVector::from_element(1, x)
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
    let (mut s, mut z) = (Sample::random(term, random), random.vector(n + m));
    // The closest point of a beam is no smooth function where its centre of curvature is near.
    s.q *= if name.starts_with("contact") { 0.5 * kind.reach() } else { kind.reach() };
    if name.starts_with("contact") {
        z *= 0.25; // So are the steps of the differences: at full length the nearest singularity costs them 10⁻⁸.
    }
    let mut w = Weights { q: 1.3 + random.number(), v: random.number(), a: 1.3 + random.number() };
    if *kind == Kind::Rubbed {
        w.q = 0.0;
    }

    // The tangent is the derivative of the residual, its constraint rows divided by w_q.
    let mut product = tangent(term, &s, w) * &z;
    product.rows_mut(n, m).scale_mut(w.q);
    let mut slope = kind.derivative(|h| residual(term, &s.moved(&z, h, w)));
    if *kind == Kind::Retarded {
        // z·B(q)ᵀ D B(v) z is half the rate of z·B(q)ᵀ D B(q) z along v.
        let damping = |h: f64| {
            let moved = Sample { q: &s.q + &s.v * h, ..s.clone() };
            scalar(z.dot(&(tangent(term, &moved, Weights { q: 0.0, v: 1.0, a: 0.0 }) * &z)))
        };
        let left_out = derivative(damping) * (0.5 * w.q);
        (product, slope) = (scalar(product.dot(&z)) + left_out, scalar(slope.dot(&z)));
    }
    if matches!(kind, Kind::Damped | Kind::Supplied) {
        // z·Kz sees the symmetric part, all of it as z goes through all directions.
        (product, slope) = (scalar(product.dot(&z)), scalar(slope.dot(&z)));
    }
    assert_close(&format!("{name}: tangent"), &product, &slope, kind.tolerance());

    // Moved by q and v at once, the energy changes as the residual of conservative forces with v in the place of a has it:
    // dU = f dq, dT = M v dv + ½ v·dM v.
    let both = Weights { q: 1.0, v: 1.0, a: 0.0 };
    let power = kind.derivative(|h| scalar(energy(term, &s.moved(&z, h, both)).total()));
    let at_rest = Sample { v: DVector::zeros(n), a: s.v.clone(), lambda: DVector::zeros(m), ..s.clone() };
    let work = scalar(residual(term, &at_rest).rows(0, n).dot(&z.rows(0, n)));
    let kinetic = |s: &Sample| 0.5 * s.v.dot(&(mass(term, s) * &s.v));
    let work = work + kind.derivative(|h| scalar(kinetic(&s.moved(&z, h, Weights::STIFFNESS))));
    if *kind != Kind::Supplied {
        assert_close(&format!("{name}: energy"), &power, &work, kind.tolerance());
    }
    if !name.starts_with("contact") {
        assert_eq!(energy(term, &rest), Energy::default(), "{name}: energy of the reference state");
    }

    // The mass matrix is not negative.
    let inertia = SymmetricEigen::new(mass(term, &s)).eigenvalues;
    assert!(inertia.min() >= -1e-14 * inertia.max(), "{name}: negative mass");

    // An ulp more or less in the state, rounded again on the way, is within twice the bound of one rounding; and the
    // bound is one of rounding, not of more.
    let (here, bound) = (residual(term, &s), rounding(term, &s));
    for _ in 0..20 {
        let mut ulp = |x: &DVector<f64>| x.map(|x| x * (1.0 + 0.5 * f64::EPSILON * random.number().signum()));
        let near = Sample { q: ulp(&s.q), v: ulp(&s.v), a: ulp(&s.a), lambda: ulp(&s.lambda) };
        let moved = (residual(term, &near) - &here).abs();
        assert!(moved <= &bound * 2.0, "{name}: rounding {} beyond its bound {}", moved.amax(), bound.amax());
    }
    assert!(bound.amax() < 1e-12 * here.amax().max(1.0), "{name}: a bound of {:e}", bound.amax());
}

fn mass(term: &dyn Term, s: &Sample) -> DMatrix<f64> {
    let n = s.q.len();
    tangent(term, s, Weights::MASS).view((0, 0), (n, n)).into_owned()
}

/// Beams of every formulation, without and with damping.
fn beams(gravity: Vector3<f64>) -> impl Iterator<Item = Case> {
    let damped = |make: &Make| Make { damping: Damping { strain: 0.2, mass: 0.7 }, ..*make };
    let makes = beams::makes();
    let damped: Vec<Make> = makes.iter().filter(|make| make.tilted).map(damped).collect();
    makes.into_iter().chain(damped).map(move |make| {
        let kind = match (make.damping == Damping::default(), make.law) {
            (true, MaterialLaw::StVenantKirchhoff) => Kind::Polynomial,
            (true, MaterialLaw::NeoHookean) => Kind::Smooth,
            (false, _) => Kind::Retarded,
        };
        let specimen = make.specimen(gravity);
        Case { name: specimen.name, term: specimen.term, kind }
    })
}

/// Loads that turn with sections, and moments that stay.
fn followers() -> impl Iterator<Item = Case> {
    let (_, mesh) = wet::meshes().swap_remove(0);
    let ([_, d, e], vector) = (mesh.axes(1.3), Vector3::new(0.3, -2.0, 0.7));
    let force = FollowerForce::in_section(&mesh.point(1.3), [&d, &e], vector, Function::ONE);
    let terms: [(&str, Box<dyn Term>); 3] = [
        ("follower force", Box::new(force)),
        ("follower moment", Box::new(Moment::in_section([&d, &e], vector, Function::ONE))),
        ("moment", Box::new(Moment::new([&d, &e], vector, Function::ONE))),
    ];
    terms.into_iter().map(|(name, term)| Case { name: name.to_owned(), term, kind: Kind::Supplied })
}

/// A force that a program computes, quadratic in position and velocity: in a model so long that its steps are, differences
/// are exact but for rounding.
fn external() -> Case {
    let law = |t: f64, x: [f64; 3], v: [f64; 3]| {
        let [x, v] = [x, v].map(Vector3::from);
        let field = Vector3::new(0.3 * t, -2.0, 0.7);
        (field - x * 3.0 - v * 0.4 + field.cross(&v) + x * x.dot(&v) * 0.2 - v * x.y * 0.1).into()
    };
    let term = ExternalForce::new(&bodies()[1].point(0.31), ForceFunction::new(law), 1e6);
    Case { name: "external force".into(), term: Box::new(term), kind: Kind::Supplied }
}

/// Every kind of term there is.
fn terms() -> Vec<Case> {
    let gravity = Vector3::new(0.3, -2.0, 0.7);
    let others = constraints_and_loads().into_iter().map(|(name, term)| Case {
        name: name.to_owned(),
        term,
        kind: Kind::Polynomial,
    });
    let cables = [(CableDamping::default(), Kind::Smooth), (cables::DAMPING, Kind::Rubbed)];
    let cables = cables.into_iter().flat_map(|(damping, kind)| {
        let case = move |cable: cables::Cable| Case { name: cable.name, term: Box::new(cable.term), kind };
        cables::cables(damping, gravity).into_iter().map(case)
    });
    let [a, b] = bodies();
    let links = links::links(&a, &b).into_iter();
    let links = links.map(|(name, term, kind)| Case { name: name.to_owned(), term, kind });
    let inertia = Matrix3::new(2.0, 0.1, 0.2, 0.1, 1.5, -0.3, 0.2, -0.3, 1.8);
    let rigid = RigidBody::new([0, 5], Vector3::new(0.3, 0.2, 0.1), 3.0, inertia, gravity).terms();
    let point = RigidBody::point(0, Vector3::x(), 3.0, gravity).terms();
    let rigid = rigid.into_iter().chain(point).enumerate().map(|(k, term)| Case {
        name: format!("rigid body, term {k}"),
        term,
        kind: Kind::Polynomial,
    });
    let wet = wet::terms(gravity).into_iter().map(|(name, term, flows)| {
        let kind = if flows { Kind::Supplied } else { Kind::Damped };
        Case { name, term: Box::new(term), kind }
    });
    let a = mesh(0, ORIGIN, Rotation3::identity());
    let b = mesh(36, Vector3::new(0.61, -0.68, 0.2), Rotation3::from_euler_angles(0.4, -0.3, 1.1));
    let contacts = contacts::contacts(&a, &b, 0.31).into_iter();
    let contacts = contacts.map(|(name, term, loss)| Case {
        name,
        term,
        kind: match loss {
            Loss::None => Kind::Smooth,
            Loss::Damping => Kind::Damped,
            Loss::Friction => Kind::Rubbed,
        },
    });
    let free = beams(gravity).chain(others).chain(followers()).chain(cables).chain(wet);
    free.chain(links).chain(rigid).chain(contacts).chain([external()]).collect()
}

#[test]
fn every_term_obeys_the_laws() {
    for case in terms() {
        // By the name, so that what a term meets does not depend on the terms before it.
        let mut random =
            Random(case.name.bytes().fold(2017, |seed, byte| 31 * seed % (1 << 40) + u64::from(byte)));
        for _ in 0..10 {
            obeys_laws(&case, &mut random);
        }
    }
}

/// In any motion, what a term takes, v·r, is stored as energy or lost, less what it is supplied with: dE/dt = v·r + work − loss.
#[test]
fn every_term_keeps_its_books() {
    let mut random = Random(1666);
    for Case { name, term, kind } in terms().into_iter().filter(|case| case.term.multipliers().is_empty()) {
        let term = term.as_ref();
        for _ in 0..10 {
            let mut s = Sample::random(term, &mut random);
            s.q *= kind.reach();
            // Set points move by functions of time that are no polynomials; the load factor is 1 where time goes on.
            let kind = if name.starts_with("preloaded") { Kind::Smooth } else { kind };
            let stored = kind.derivative(|h| {
                let later = Sample { q: &s.q + &s.v * h, v: &s.v + &s.a * h, ..s.clone() };
                let at = later.local();
                scalar(term.energy(&Local { t: at.t + h, load: 1.0, ..at }).total())
            });
            let now = Local { load: 1.0, ..s.local() };
            let mut r = s.q.clone() * 0.0;
            term.residual(&now, r.as_mut_slice());
            let Power { work, dissipation } = term.power(&now);
            let taken = scalar(s.v.dot(&r) + work - dissipation);
            assert_close(&format!("{name}: books"), &stored, &taken, kind.tolerance());
            assert!(dissipation >= 0.0, "{name}: a loss of {dissipation:e}");
        }
    }
}

/// Constraints at the levels of velocity and acceleration are derivatives in time along q + v h, t + h.
#[test]
fn levels_of_constraints_are_derivatives() {
    let mut random = Random(1988);
    for Case { name, term, kind } in terms() {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        let mut s = Sample::random(term, &mut random);
        s.q *= kind.reach();
        let along = |level: Level, h: f64| {
            let q = &s.q + &s.v * h;
            let at = Local { q: q.as_slice(), t: 0.3 + h, load: 1.0, ..s.local() };
            let mut phi = DVector::zeros(m);
            term.constraints(&at, level, phi.as_mut_slice());
            phi
        };
        for (level, next) in [(Level::Position, Level::Velocity), (Level::Velocity, Level::Acceleration)] {
            let slope = extrapolated_derivative(|h| along(level, h));
            assert_close(&format!("{name}, {next:?} of {n}"), &along(next, 0.0), &slope, 1e-10);
        }
    }
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

/// The third derivative of the energy and of λ·Φ is what stresses and what displacements add to the stiffness. With T the
/// stiffness of initial stresses, D³(x, y, z) = x·T(z)y + y·T(x)z + z·T(y)x, if the strains are quadratic; those of other terms,
/// in the reference state.
#[test]
fn stress_stiffness_is_a_third_of_the_third_derivative() {
    let mut random = Random(1961);
    for Case { name, term, kind } in terms() {
        let (term, (n, m)) = (term.as_ref(), sizes(term.as_ref()));
        if name.contains("NeoHookean") || name.starts_with("contact") {
            // The stress is not linear in the strain: tests/hyperelastic.rs has that one; contacts start without stress.
            continue;
        }
        if kind == Kind::Supplied {
            continue; // It is no derivative of an energy, and not dead.
        }
        if name.starts_with("preloaded") {
            continue; // It is stressed in the reference state, and by the load factor.
        }
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

/// Per load factor, whatever the load so far.
#[test]
fn loads_have_their_stiffness_without_being_asked() {
    let s = Sample::random(&Magnet, &mut Random(1));
    assert_eq!(stress_stiffness(&Magnet, &s, &scalar(0.2), 2.0)[(0, 0)], -6.0);
}

/// A small translation and rotation of a deformed element causes no stress.
#[test]
fn rigid_motion_adds_no_stress() {
    let mut random = Random(25);
    for make in beams::makes().into_iter().filter(|make| make.law == MaterialLaw::StVenantKirchhoff) {
        let specimen = make.specimen(Vector3::zeros());
        let (name, term) = (&specimen.name, specimen.term.as_ref());
        let (s, shift, spin) = (Sample::random(term, &mut random), random.vector3(), random.vector3());
        let z = specimen.spinning(&s.q, spin, shift);
        let size = stress_stiffness(term, &s, &random.vector(z.len()), 0.0).amax();
        let rigid = stress_stiffness(term, &s, &z, 0.0).amax();
        assert!(rigid < 1e-12 * size, "{name}: {rigid:e} of {size:e}");
    }
}
