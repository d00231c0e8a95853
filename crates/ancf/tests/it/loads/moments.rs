//! Moments, follower loads and drives on rotated, stretched and skewed sections.

use ancf::mechanics::constraints::RotationDrive;
use ancf::mechanics::forces::{FollowerForce, Moment};
use ancf::mechanics::functions::{Function, TimeTable};
use ancf::mechanics::kinematics::{BodyVector, Marker, SectionFrame};
use ancf::solver::equations::{LOCAL, Local, LocalMatrix, Term, Weights};
use nalgebra::{DMatrix, DVector, Rotation3, Vector3};
use proptest::prelude::*;

/// Markers of a node: point r and directors d and e, each with its own coordinates.
fn markers() -> [Marker; 3] {
    let d = Vector3::new(0.1, 0.9, 0.2);
    let e = Vector3::new(-0.2, 0.1, 1.1);
    [(0, Vector3::zeros()), (3, d), (6, e)].map(|(first, reference)| Marker::new([(first, 1.0)], reference))
}

/// Directors that are orthonormal in the reference state.
fn orthonormal() -> [Marker; 3] {
    let axes = [Vector3::zeros(), Vector3::y(), Vector3::z()];
    let mut first = 0;
    axes.map(|axis| {
        first += 3;
        Marker::new([(first - 3, 1.0)], axis)
    })
}

fn constant() -> Function {
    Function::ONE
}

/// Moments with fixed direction, follower moments and follower forces on given markers.
fn terms(markers: &[Marker; 3], vector: Vector3<f64>) -> Vec<(&'static str, Box<dyn Term>)> {
    let frame = frame(markers);
    let along = BodyVector::turned(&frame, vector);
    vec![
        ("moment", Box::new(Moment::new(&frame, vector, constant()))),
        ("follower moment", Box::new(Moment::follower(&frame, vector, constant()))),
        ("follower force", Box::new(FollowerForce::new(&markers[0], along, constant()))),
    ]
}

/// Section frame of unequal weights.
fn frame([_, d, e]: &[Marker; 3]) -> SectionFrame {
    SectionFrame::new([d, e], 0.3)
}

/// Extracts the coordinates of a term from the nine.
fn local(term: &dyn Term, q: &DVector<f64>) -> DVector<f64> {
    DVector::from_iterator(term.coordinates().len(), term.coordinates().iter().map(|&c| q[c]))
}

fn at(q: &DVector<f64>, t: f64, load: f64) -> Local<'_> {
    const ZERO: [f64; 9] = [0.0; 9];
    let zero = &ZERO[..q.len()];
    Local { q: q.as_slice(), v: zero, a: zero, lambda: &[], t, load }
}

/// Forces −r on all nine coordinates.
fn forces(term: &dyn Term, q: &DVector<f64>) -> DVector<f64> {
    let own = local(term, q);
    let mut r = DVector::zeros(own.len());
    term.residual(&at(&own, 0.0, 1.0), r.as_mut_slice());
    let mut all = DVector::zeros(9);
    term.coordinates().iter().zip(&r).for_each(|(&c, r)| all[c] -= r);
    all
}

/// −∂r/∂q of the term on all nine coordinates.
fn stiffness(term: &dyn Term, q: &DVector<f64>) -> DMatrix<f64> {
    let own = local(term, q);
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(own.len(), &mut storage);
    term.tangent(&at(&own, 0.0, 1.0), Weights::STIFFNESS, &mut k);
    let mut all = DMatrix::zeros(9, 9);
    for (i, &a) in term.coordinates().iter().enumerate() {
        for (j, &b) in term.coordinates().iter().enumerate() {
            all[(a, b)] = -k.get(i.max(j), i.min(j));
        }
    }
    all
}

/// ∂f/∂q by differences of fourth order.
fn differences(term: &dyn Term, q: &DVector<f64>) -> DMatrix<f64> {
    let h = 1e-3;
    let column = |j: usize| {
        let f = |x: f64| {
            let mut moved = q.clone();
            moved[j] += x;
            forces(term, &moved)
        };
        ((f(h) - f(-h)) * 8.0 - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)
    };
    DMatrix::from_columns(&(0..9).map(column).collect::<Vec<_>>())
}

fn vectors(markers: &[Marker; 3], q: &DVector<f64>) -> [Vector3<f64>; 3] {
    markers.each_ref().map(|marker| marker.reference() + marker.sum(q.as_slice()))
}

/// Coordinates of a rotation of all markers about the origin.
fn rotated(markers: &[Marker; 3], turn: Rotation3<f64>) -> DVector<f64> {
    let q = markers.each_ref().map(|marker| turn * marker.reference() - marker.reference());
    DVector::from_iterator(9, q.iter().flat_map(|q| q.iter().copied()))
}

fn part(x: &DVector<f64>, first: usize) -> Vector3<f64> {
    x.fixed_rows::<3>(first).into_owned()
}

fn any_vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

/// Random rotation and random strains up to 0.3.
fn any_state() -> impl Strategy<Value = DVector<f64>> {
    (any_vector(3.0), prop::collection::vec(-0.3..0.3, 9))
        .prop_map(|(turn, strain)| rotated(&markers(), Rotation3::new(turn)) + DVector::from_vec(strain))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Power m·ω for the angular velocity ω of a section of any shape; no force on the point.
    #[test]
    fn moment_is_a_couple(q in any_state(), m in any_vector(2.0), omega in any_vector(1.0)) {
        let markers = markers();
        let [_, d, e] = vectors(&markers, &q);
        let moment = Moment::new(&frame(&markers), m, constant());
        let f = forces(&moment, &q);
        prop_assert_eq!(part(&f, 0), Vector3::zeros());
        let power = part(&f, 3).dot(&omega.cross(&d)) + part(&f, 6).dot(&omega.cross(&e));
        prop_assert!((power - m.dot(&omega)).abs() < 1e-13, "{power} and {}", m.dot(&omega));
        // Stretch of the section has no power.
        prop_assert!((part(&f, 3).dot(&d) + part(&f, 6).dot(&e)).abs() < 1e-13);
    }

        #[test]
    fn tangent_is_the_symmetric_part_of_the_derivative(q in any_state(), vector in any_vector(2.0)) {
        for (name, term) in terms(&markers(), vector) {
            let slope = differences(term.as_ref(), &q);
            let symmetric = (&slope + slope.transpose()) * 0.5;
            let error = (stiffness(term.as_ref(), &q) - &symmetric).amax();
            prop_assert!(error < 1e-7 * (1.0 + symmetric.amax()), "{name}: {error:e}");
        }
    }

        #[test]
    fn follower_loads_rotate_with_the_body(vector in any_vector(2.0), turn in any_vector(3.0)) {
        let (markers, turn) = (markers(), Rotation3::new(turn));
        let q = rotated(&markers, turn);
        let [_, d, e] = vectors(&markers, &q);
        let total = |f: &DVector<f64>| d.cross(&part(f, 3)) + e.cross(&part(f, 6));
        for (name, term) in terms(&markers, vector) {
            let f = forces(term.as_ref(), &q);
            let (found, expected) = match name {
                "moment" => (total(&f), vector),
                "follower moment" => (total(&f), turn * vector),
                _ => (part(&f, 0), turn * vector),
            };
            prop_assert!((found - expected).norm() < 1e-13, "{name}: {found}, not {expected}");
        }
    }

    /// Changes of the state by one ulp change the forces by at most twice the bound. The bound is of the order of rounding.
    #[test]
    fn rounding_error_is_within_its_bound(q in any_state(), vector in any_vector(2.0), signs in prop::collection::vec(any::<bool>(), 9)) {
        for (name, term) in terms(&markers(), vector) {
            let ulp = |(q, up): (&f64, &bool)| q * (1.0 + 0.5 * f64::EPSILON * if *up { 1.0 } else { -1.0 });
            let near = DVector::from_iterator(9, q.iter().zip(&signs).map(ulp));
            let moved = (forces(term.as_ref(), &near) - forces(term.as_ref(), &q)).abs();
            let own = local(term.as_ref(), &q);
            let mut floor = DVector::zeros(own.len());
            term.rounding(&at(&own, 0.0, 1.0), floor.as_mut_slice());
            for (&c, bound) in term.coordinates().iter().zip(&floor) {
                prop_assert!(moved[c] <= 2.0 * bound, "{name}: {} above {bound}", moved[c]);
                prop_assert!(*bound < 1e-12 * vector.norm().max(1.0), "{name}: {bound}");
            }
        }
    }
}

/// Potential −Mθ for motions in the plane: the tangent is the derivative. Out of the plane the derivative is not symmetric.
#[test]
fn moment_is_conservative_in_a_plane() {
    let markers = orthonormal();
    let q = rotated(&markers, Rotation3::new(Vector3::z() * 2.1)) * 1.1;
    let term = Moment::new(&frame(&markers), Vector3::z() * 1.7, constant());
    let slope = differences(&term, &q);
    // Displacements of d in the plane.
    let plane = |k: &DMatrix<f64>| k.view((3, 3), (2, 2)).into_owned();
    assert!((plane(&slope) - plane(&slope).transpose()).amax() < 1e-9);
    assert!((plane(&slope) - plane(&stiffness(&term, &q))).amax() < 1e-9);
    assert!(plane(&slope).amax() > 1.0);
    assert!((&slope - slope.transpose()).amax() > 0.1);
}

/// Loads are proportional to their function of time and to the load factor.
#[test]
fn loads_scale_with_time_function_and_load_factor() {
    let (frame, [r, ..]) = (frame(&markers()), &markers());
    let function = || Function::Table(TimeTable::new([[0.0, 0.0], [2.0, 3.0]]));
    let vector = Vector3::new(0.3, -0.4, 1.1);
    let varying: [Box<dyn Term>; 3] = [
        Box::new(Moment::new(&frame, vector, function())),
        Box::new(Moment::follower(&frame, vector, function())),
        Box::new(FollowerForce::new(r, BodyVector::turned(&frame, vector), function())),
    ];
    for (term, (name, steady)) in varying.iter().zip(terms(&markers(), vector)) {
        let q = DVector::from_element(term.coordinates().len(), 0.1);
        let residual = |term: &dyn Term, t, load| {
            let mut r = DVector::zeros(q.len());
            term.residual(&at(&q, t, load), r.as_mut_slice());
            r
        };
        let (a, b) = (residual(term.as_ref(), 1.0, 0.2), residual(steady.as_ref(), 7.0, 0.3));
        assert!((a - b).amax() < 1e-15, "{name}");
    }
}

/// Constraints vanish at the prescribed rotation; rates and accelerations are time derivatives.
#[test]
fn drive_rates_are_time_derivatives() {
    let axis = Vector3::new(0.48, 0.6, -0.64);
    let direction = Vector3::new(0.2, -1.1, 0.3);
    let marker = Marker::new([(0, 0.5), (3, 0.5)], direction);
    let sine = || Function::Sine { frequency: 0.3, phase: 0.2 };
    let drive = RotationDrive::new(&marker, axis, 2.5, sine(), 0);
    let residual = |t: f64, load: f64, q: Vector3<f64>| {
        let q = [q.x, q.y, q.z, q.x, q.y, q.z];
        let mut r = [0.0; 9];
        let zero = [0.0; 6];
        drive.residual(&Local { q: &q, v: &zero, a: &zero, lambda: &[0.0; 3], t, load }, &mut r);
        Vector3::new(r[6], r[7], r[8])
    };
    for (t, load) in [(0.0, 1.0), (0.4, 1.0), (1.7, 1.0), (2.9, 0.3)] {
        let turn = Rotation3::new(axis * (2.5 * load * sine().value(t)));
        let reached = turn * direction - direction;
        assert!(residual(t, load, reached).norm() < 1e-15, "{t}");
    }
    let gap = |t: f64| residual(t, 1.0, Vector3::zeros());
    let h = 1e-3;
    for t in [0.0, 0.4, 1.7, 2.9] {
        let (mut rates, mut accelerations) = ([0.0; 3], [0.0; 3]);
        drive.drive(t, &mut rates, &mut accelerations);
        let slope = ((gap(t + h) - gap(t - h)) * 8.0 - (gap(t + 2.0 * h) - gap(t - 2.0 * h))) / (12.0 * h);
        let sums = (gap(t + h) + gap(t - h)) * 16.0 - (gap(t + 2.0 * h) + gap(t - 2.0 * h));
        let curvature = (sums - gap(t) * 30.0) / (12.0 * h * h);
        assert!((slope - Vector3::from(rates)).norm() < 1e-9, "{t}");
        assert!((curvature - Vector3::from(accelerations)).norm() < 1e-7, "{t}");
    }
}

/// The skew stiffness is the skew part of the derivative of the residual.
#[test]
fn skew_stiffness_is_the_skew_part_of_the_derivative() {
    let q: Vec<f64> = (0..9).map(|i| 0.1 * (f64::from(i) * 1.7).sin()).collect();
    for (name, term) in terms(&markers(), Vector3::new(0.7, -1.3, 0.4)) {
        let coordinates: Vec<f64> = term.coordinates().iter().map(|&c| q[c]).collect();
        let n = coordinates.len();
        let (zeros, step) = (vec![0.0; n], 1e-6);
        let residual = |q: &[f64]| {
            let mut r = vec![0.0; n];
            let at = Local { q, v: &zeros, a: &zeros, lambda: &[], t: 0.0, load: 1.0 };
            term.residual(&at, &mut r);
            DVector::from_vec(r)
        };
        let mut derivative = DMatrix::zeros(n, n);
        for j in 0..n {
            let moved = |by: f64| {
                let mut q = coordinates.clone();
                q[j] += by;
                residual(&q)
            };
            derivative.set_column(j, &((moved(step) - moved(-step)) / (2.0 * step)));
        }
        let mut skew = DMatrix::<f64>::zeros(n, n);
        let at = Local { q: &coordinates, v: &zeros, a: &zeros, lambda: &[], t: 0.0, load: 1.0 };
        term.skew_stiffness(&at, &mut |i, j, value| {
            skew[(i, j)] += value;
            skew[(j, i)] -= value;
        });
        let exact = (&derivative - derivative.transpose()) * 0.5;
        assert!((&skew - &exact).amax() < 1e-8 && exact.amax() > 1e-2, "{name}: {skew} not {exact}");
    }
}
