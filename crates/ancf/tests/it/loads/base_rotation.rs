//! Rotation of the ground against closed forms and against motions in a frame at rest.

use ancf::mechanics::bodies::BodyTerms;
use ancf::mechanics::elements::RigidBody;
use ancf::mechanics::functions::Function;
use ancf::mechanics::inertia::{FrameInertia, FrameRotation};
use ancf::solver::equations::{Local, State, Term};
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, Vector3};
use std::sync::Arc;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Angular velocity of the ground, and a point of its axis.
const OMEGA: [f64; 3] = [0.4, -0.7, 1.1];
const POINT: [f64; 3] = [0.3, 0.2, -0.5];

/// A rigid body without forces in a frame at rest moves along a circle in the rotating frame.
#[test]
fn a_body_at_rest_circles_in_the_rotating_frame() {
    let (omega, point) = (Vector3::from(OMEGA), Vector3::from(POINT));
    let center = Vector3::new(1.0, 0.5, 0.2);
    let spin = -omega;
    let velocity = spin.cross(&(center - point));
    let run = Run::of(&parse(&format!(
        r#"
bodies = [{{ kind = "rigid", name = "body", center = [1.0, 0.5, 0.2], mass = 2, inertia = [0.3, 0.2, 0.4], motion = {{ velocity = {:?}, spin = {:?} }} }}]
loads = [{{ kind = "base_rotation", angular_velocity = {OMEGA:?}, point = {POINT:?} }}]
probes = [{{ name = "corner", on = {{ body = "body", at = "center", offset = [0.1, 0.2, 0.3] }} }}]
[analysis]
kind = "dynamics"
duration = 2
step = 0.002
"#,
        velocity.as_slice(),
        spin.as_slice(),
    )));
    let start = center + Vector3::new(0.1, 0.2, 0.3) - point;
    for (k, t) in run.column("t").iter().enumerate() {
        let expected = point + Rotation3::new(spin * *t) * start;
        let found = ["x", "y", "z"].map(|axis| run.column(&format!("corner.{axis}"))[k]);
        assert!((Vector3::from(found) - expected).norm() < 2e-5, "at {t}");
    }
    assert!(run.column("balance").iter().all(|x| x.abs() < 1e-6));
}

/// Cantilever on a hub that spins up: in the rotating frame, and turned by a drive in a frame at rest.
#[test]
fn a_blade_that_spins_up_equals_one_that_a_drive_turns() {
    let text = |joints: &str, loads: &str| {
        parse(&format!(
            r#"
materials.steel = {{ density = 7850, young = 2e9, damping = {{ strain = 1e-3 }} }}
sections.strip = {{ kind = "rectangle", height = 0.04, width = 0.02 }}
bodies = [{{ kind = "beam", name = "blade", from = [0.1, 0, 0], to = [1.1, 0, 0], elements = 4, section = "strip", material = "steel" }}]
probes = [{{ name = "tip", on = {{ body = "blade", at = "end" }} }}]
{loads}
{joints}
[analysis]
kind = "dynamics"
duration = 1.0
step = 0.001
"#
        ))
    };
    // Ω = 6 t² (1 − t/1.5) for t < 1, and its integral.
    let turning = Run::of(&text(
        "joints = [{ kind = \"clamp\", name = \"hub\", a = { body = \"blade\", at = \"start\" } }]",
        "loads = [{ kind = \"base_rotation\", angular_velocity = [0, 0, 6], time = { kind = \"expression\", text = \"t^2*(1 - t/1.5)\" } }]",
    ));
    let driven = Run::of(&text(
        "joints = [{ kind = \"revolute\", name = \"hub\", a = { body = \"blade\", at = \"start\", offset = [-0.1, 0, 0] }, b = { point = [0, 0, 0] }, axis = [0, 0, 1], drive = { angle = 1, time = { kind = \"expression\", text = \"6*(t^3/3 - t^4/6)\" } } }]",
        "",
    ));
    let mut largest = 0.0_f64;
    for (k, t) in turning.column("t").iter().enumerate() {
        let angle = 6.0 * (t.powi(3) / 3.0 - t.powi(4) / 6.0);
        let of = |run: &Run| Vector3::from(["x", "y", "z"].map(|axis| run.column(&format!("tip.{axis}"))[k]));
        let back = Rotation3::from_axis_angle(&Vector3::z_axis(), -angle) * of(&driven);
        assert!((of(&turning) - back).norm() < 2e-4, "at {t}: {} and {back}", of(&turning));
        largest = largest.max((of(&turning) - Vector3::new(1.1, 0.0, 0.0)).norm());
    }
    assert!(largest > 0.01, "the blade bends by {largest}");
}

/// Stretch of a rotating rod: N' = −ρA Ω² (x + u), so u = r sin κx / (κ cos κL) − x with κ² = ρ Ω²/E and small strains.
#[test]
fn statics_stretches_a_rotating_rod() {
    let (young, density, omega) = (2e9_f64, 7850.0_f64, 120.0_f64);
    let run = Run::of(&parse(&format!(
        r#"
materials.steel = {{ density = {density}, young = {young} }}
sections.round = {{ kind = "circle", diameter = 0.02 }}
bodies = [{{ kind = "cable", name = "rod", from = [0, 0, 0], to = [0, 0, 1], elements = 20, section = "round", material = "steel" }}]
joints = [{{ kind = "clamp", name = "hub", a = {{ body = "rod", at = "start" }} }}]
loads = [{{ kind = "base_rotation", angular_velocity = [0, {omega}, 0] }}]
probes = [{{ name = "tip", on = {{ body = "rod", at = "end" }} }}]
[analysis]
kind = "statics"
"#
    )));
    let kappa = (density * omega * omega / young).sqrt();
    let expected = kappa.tan() / kappa - 1.0;
    let found = run.last_vector("tip.").z - 1.0;
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} not {expected}");
}

/// Coriolis and Euler forces: the skew parts of the derivatives of the residual.
#[test]
fn skew_parts_are_those_of_the_derivatives() {
    let rotation = FrameRotation {
        velocity: Vector3::from(OMEGA),
        point: Vector3::from(POINT),
        function: Function::Sine { frequency: 0.4, phase: 0.3 },
    };
    let inertia = Matrix3::new(2.0, 0.1, 0.2, 0.1, 1.5, -0.3, 0.2, -0.3, 1.8);
    let body = BodyTerms::Rigid(RigidBody::new([0, 5], Vector3::x(), 3.0, inertia, Vector3::zeros()));
    let mut term = None;
    body.visit_masses(&State::rest(12, 6), &mut |vectors, mass| {
        term = Some(FrameInertia::new(vectors, mass, Arc::new(rotation.clone())));
    });
    let (term, zeros) = (term.unwrap(), [0.0; 12]);
    fn at<'a>(q: &'a [f64], v: &'a [f64]) -> Local<'a> {
        Local { q, v, a: &[0.0; 12], lambda: &[], t: 0.7, load: 1.0 }
    }
    let derivative = |of_velocity: bool| {
        let residual = |x: &[f64]| {
            let mut r = [0.0; 12];
            term.residual(&if of_velocity { at(&zeros, x) } else { at(x, &zeros) }, &mut r);
            DVector::from_row_slice(&r)
        };
        let unit =
            |j: usize, by: f64| -> Vec<f64> { (0..12).map(|i| if i == j { by } else { 0.0 }).collect() };
        let columns: Vec<_> =
            (0..12).map(|j| (residual(&unit(j, 1.0)) - residual(&unit(j, -1.0))) * 0.5).collect();
        DMatrix::from_columns(&columns)
    };
    for of_velocity in [false, true] {
        let exact = derivative(of_velocity);
        let exact = (&exact - exact.transpose()) * 0.5;
        let mut skew = DMatrix::<f64>::zeros(12, 12);
        let mut visit = |i: usize, j: usize, value: f64| {
            skew[(i, j)] += value;
            skew[(j, i)] -= value;
        };
        match of_velocity {
            true => term.skew_damping(&at(&zeros, &zeros), &mut visit),
            false => term.skew_stiffness(&at(&zeros, &zeros), &mut visit),
        }
        assert!((&skew - &exact).amax() < 1e-12 && exact.amax() > 1e-2, "{skew} not {exact}");
    }
}

/// A body at rest in its equilibrium on a rotating ground has no motion, but rounding errors of the work of centrifugal forces.
#[test]
fn bodies_at_rest_on_a_rotating_ground_have_no_warning() {
    for rate in [1.0, 10.0, 100.0] {
        for scheme in ["{ spectral_radius = 0.8 }", "\"energy\"", "\"average_acceleration\""] {
            for step in ["1e-2", "1e-3"] {
                let text = format!(
                    r#"loads = [{{ kind = "base_rotation", angular_velocity = [0, 0, {rate:?}] }}]
                    bodies = [{{ kind = "rigid", name = "b", center = [1, 0, 0], mass = 1, inertia = [0.01, 0.1, 0.1] }}]
                    joints = [{{ kind = "revolute", name = "j", a = {{ body = "b", at = [0, 0, 0] }}, axis = [0, 1, 0] }}]
                    probes = [{{ name = "p", on = {{ body = "b", at = "center" }} }}]
                    analysis = {{ kind = "dynamics", duration = 0.1, step = {step}, scheme = {scheme} }}"#
                );
                let run = Run::of(&parse(&text));
                assert!(
                    run.summary.warnings.is_empty(),
                    "{rate} {scheme} {step}: {:?}",
                    run.summary.warnings
                );
                assert!(run.column("p.z").iter().all(|z| z.abs() < 1e-14));
            }
        }
    }
}
