//! Newton's and Euler's laws of complete systems: reactions, constraints, energy balance.
//!
//! ```text
//!   |/|=======+============  the rod, clamped ("root")
//!   |/|  0.35  \             joint ("fork") inside an element
//!               \            the branch
//! ```

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model;
use ancf::model::{At, Body, Clamp, ClampedGradients, End, Joint, NamedPosition, Place, Revolute, Start};
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper, consistent_accelerations};
use ancf::solver::equations::{EquationsOfMotion, Inadmissibility, State, Weights};
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::{DMatrix, DVector, Vector3};

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::Run;
use crate::common::solutions::equilibrium;

/// ρAgL of the rod, in newtons.
const WEIGHT: f64 = 24.74767621716784;
/// Position of the branch on the rod, inside an element.
const FORK: f64 = 0.35;
/// Axis of the revolute joint.
const AXIS: [f64; 3] = [0.8, 0.3, 0.1];
/// Length of an element of the rod and of the branch.
const ELEMENT: f64 = 0.5;

/// Rod with a branch of half its length along a unit vector, connected by a joint.
fn branched(along: [f64; 3], joint: impl FnOnce(Place, End) -> Joint) -> Model {
    let mut model = rod::cantilever(2);
    let mut branch = rod::beam(&mut model).clone();
    branch.name = "branch".into();
    (branch.from, branch.elements) = ([FORK, 0.0, 0.0], 1);
    branch.to = std::array::from_fn(|i| branch.from[i] + ELEMENT * along[i]);
    let place = |body: &str, at| Place::new(body, at);
    let start = place(&branch.name, At::Named(NamedPosition::Start));
    model.joints.push(joint(start, End::Place(place("rod", At::Length(FORK)))));
    model.bodies.push(Body::Beam(branch));
    model
}

fn clamp(fix: ClampedGradients) -> impl FnOnce(Place, End) -> Joint {
    move |a, b| Joint::Clamp(Clamp { name: "fork".into(), a, b, fix: Some(fix) })
}

/// Soft systems, one for each kind of joint.
fn forks() -> [(&'static str, Model); 4] {
    let along = [0.0, 0.6, 0.8];
    [
        ("clamp", branched(along, clamp(ClampedGradients::All))),
        ("clamp of the section", branched(along, clamp(ClampedGradients::Section))),
        ("spherical", branched(along, |a, b| Joint::spherical("fork", a, b))),
        (
            "revolute",
            branched(along, |a, b| {
                Joint::Revolute(Revolute {
                    name: "fork".into(),
                    a,
                    b,
                    axis: AXIS,
                    drive: None,
                    spring: None,
                    friction: None,
                    moment: None,
                    stops: None,
                })
            }),
        ),
    ]
    .map(|(name, mut model)| {
        rod::material(&mut model).young /= 1000.0;
        (name, model)
    })
}

fn mass(assembly: &Assembly) -> DMatrix<f64> {
    let (system, mut k) = (&assembly.system, assembly.system.matrix());
    system.tangent(&assembly.rest(), Weights { q: 0.0, v: 0.0, a: 1.0 }, &mut k);
    let dense = k.dense();
    DMatrix::from_fn(system.coordinates(), system.coordinates(), |i, j| dense[i][j])
}

/// dq of a rigid-body motion: nodal vectors rotate by `turn`, points also translate by `shift`.
fn rigid(assembly: &Assembly, s: &State, turn: Vector3<f64>, shift: Vector3<f64>) -> DVector<f64> {
    let mut dq = Vec::new();
    for (body, elements) in [("rod", 2), ("branch", 1)] {
        let mesh = assembly.mesh(body).unwrap();
        for node in 0..=elements {
            let at = ELEMENT * f64::from(node);
            dq.extend(&(turn.cross(&mesh.point(at).value(s)) + shift));
            for direction in mesh.axes(at) {
                dq.extend(&turn.cross(&direction.value(s)));
            }
        }
    }
    DVector::from_vec(dq)
}

/// Asserts that gravity and the root reactions are the rates of linear and angular momentum about the origin.
fn assert_balance(name: &str, assembly: &Assembly, s: &State, gravity: Vector3<f64>) {
    let (mass, a) = (mass(assembly), DVector::from_column_slice(&s.a));
    let root = assembly.reactions(s).next().unwrap();
    let none = Vector3::zeros();
    let falling = rigid(assembly, s, none, gravity);
    for axis in 0..3 {
        let unit = Vector3::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 });
        let pushed = mass.tr_mul(&rigid(assembly, s, none, unit));
        let error = pushed.dot(&a) - pushed.dot(&falling) - root.force[axis];
        assert!(error.abs() < 1e-7, "{name}: {error:e} N along axis {axis}");
        let turned = mass.tr_mul(&rigid(assembly, s, unit, none));
        let error = turned.dot(&a) - turned.dot(&falling) - root.moment[axis];
        assert!(error.abs() < 1e-7, "{name}: {error:e} N m about axis {axis}");
    }
}

/// States over 0.2 s by the scheme and the step of the paper.
fn instants(model: &Model) -> (Assembly, Vec<State>) {
    let assembly = model.assemble().unwrap();
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-8), 50).unwrap();
    let mut dynamics =
        TimeStepper::new(&assembly.system, SchemeCoefficients::ADAMS, newton, 0, assembly.rest());
    let states = (1..=200).map(|step| {
        dynamics.advance(1e-3 * f64::from(step)).unwrap();
        dynamics.state().clone()
    });
    let states = states.collect();
    (assembly, states)
}

/// Largest |Φ|.
fn violation(assembly: &Assembly, s: &State) -> f64 {
    let (n, m) = (assembly.system.coordinates(), assembly.system.multipliers());
    let mut r = vec![0.0; n + m];
    assembly.system.residual(s, &mut r);
    r[n..].iter().fold(0.0, |largest, phi| phi.abs().max(largest))
}

#[test]
fn joint_constraints_hold_to_rounding() {
    let single = [rod::cantilever(5), rod::revolute(5), rod::spherical(5)].map(|model| ("single", model));
    for (name, model) in forks().into_iter().chain(single) {
        let (assembly, states) = instants(&model);
        let largest = states.iter().map(|s| violation(&assembly, s)).fold(0.0, f64::max);
        assert!(largest < 1e-10, "{name}: {largest:e}");
        assert!(states.iter().any(|s| s.q.iter().any(|q| q.abs() > 1e-3)), "{name} moves");
    }
}

#[test]
fn root_reactions_are_rates_of_momenta() {
    let [.., (_, mut hinged)] = forks();
    hinged.joints[0] = Joint::Revolute(Revolute {
        name: "root".into(),
        a: rod::start(),
        b: End::Ground,
        axis: AXIS,
        drive: None,
        spring: None,
        friction: None,
        moment: None,
        stops: None,
    });
    for (name, model) in forks().into_iter().chain([("hinged at the root", hinged)]) {
        let (assembly, states) = instants(&model);
        for s in states.iter().step_by(20) {
            assert_balance(name, &assembly, s, Vector3::from(model.gravity));
        }
    }
}

/// At the fork a clamp keeps the frames aligned, a revolute joint the axis, a spherical joint nothing.
#[test]
fn joints_constrain_the_relative_rotation() {
    let angle = |a: Vector3<f64>, b: Vector3<f64>| a.normalize().cross(&b.normalize()).norm();
    for (name, model) in forks() {
        let (assembly, states) = instants(&model);
        let [rod, branch] = ["rod", "branch"].map(|body| {
            let (mesh, s) = (assembly.mesh(body).unwrap(), states.last().unwrap());
            let at = if body == "rod" { FORK } else { 0.0 };
            let frame = mesh.frame(at).unwrap().at(&s.q);
            // Rotation of the section, and the material direction, which also contains strain.
            move |x: Vector3<f64>| [frame.turned(&x), mesh.direction(at, x).value(s)]
        });
        let axis = Vector3::from(AXIS);
        let first = axis.cross(&Vector3::x());
        let between = |x| [0, 1].map(|k| angle(branch(x)[k], rod(x)[k]));
        let ([off_axis, _], [turned, strained]) = (between(axis), between(first));
        match name {
            "spherical" => assert!(off_axis > 0.01 && turned > 0.01, "{off_axis:e}, {turned:e}"),
            "revolute" => assert!(off_axis < 1e-9 && turned > 0.01, "{off_axis:e}, {turned:e}"),
            "clamp" => assert!(strained < 1e-9, "{name}: {strained:e}"),
            // Sections at an angle rotate together and change their shapes independently.
            _ => assert!(difference(&assembly, states.last().unwrap()) < 1e-9, "{name}"),
        }
    }
}

/// Difference of the rotations of the sections of rod and branch at the fork.
fn difference(assembly: &Assembly, s: &State) -> f64 {
    let [rod, branch] = [("rod", FORK), ("branch", 0.0)].map(|(body, at)| {
        let frame = assembly.mesh(body).unwrap().frame(at).unwrap();
        frame.at(&s.q).rotation()
    });
    (rod - branch).amax()
}

/// Φ(q + h v + ½ h² a) is of third order for Φ_q v = 0 and consistent accelerations.
#[test]
fn consistent_start_satisfies_constraints_to_third_order() {
    let model = branched([0.0, 0.6, 0.8], |a, b| {
        Joint::Revolute(Revolute {
            name: "fork".into(),
            a,
            b,
            axis: AXIS,
            drive: None,
            spring: None,
            friction: None,
            moment: None,
            stops: None,
        })
    });
    let assembly = Model { joints: model.joints[1..].to_vec(), ..model }.assemble().unwrap();
    let mut s = assembly.rest();
    // All bodies rotate about one axis, the branch also about its hinge.
    let spin = rigid(&assembly, &s, Vector3::new(3.0, -5.0, 4.0), Vector3::zeros());
    let hinge = rigid(
        &assembly,
        &s,
        Vector3::from(AXIS) * 7.0,
        -Vector3::from(AXIS).cross(&Vector3::x()) * 7.0 * FORK,
    );
    let branch = 36;
    s.v =
        spin.iter().zip(&hinge).enumerate().map(|(i, (a, b))| if i < branch { *a } else { a + b }).collect();
    consistent_accelerations(&assembly.system, &mut assembly.system.matrix(), &mut s).unwrap();
    let ahead = |h: f64| {
        let mut ahead = s.clone();
        for i in 0..ahead.q.len() {
            ahead.q[i] += h * s.v[i] + 0.5 * h * h * s.a[i];
        }
        violation(&assembly, &ahead)
    };
    let order = (ahead(1e-3) / ahead(5e-4)).log2();
    assert!((order - 3.0).abs() < 0.1, "order {order}");
}

/// Root: weight and its moment. Fork: weight of the branch.
#[test]
fn reactions_at_rest_are_the_weights() {
    let (assembly, state) = equilibrium(&rod::cantilever(5), 1);
    let root = assembly.reactions(&state).next().unwrap();
    assert_near("force", root.force.y / WEIGHT, 1.0, 1e-9);
    assert_near("force across", root.force.x.hypot(root.force.z), 0.0, 1e-8);
    // The deflection of 2 mm shifts the weight inwards by micrometres.
    assert_near("moment", root.moment.z / (0.5 * WEIGHT * rod::LENGTH), 1.0, 1e-5);

    let model = branched([0.0, -1.0, 0.0], clamp(ClampedGradients::All));
    let (assembly, state) = equilibrium(&model, 1);
    let [root, fork] = [0, 1].map(|joint| assembly.reactions(&state).nth(joint).unwrap());
    assert_near("force", root.force.y / (1.5 * WEIGHT), 1.0, 1e-9);
    assert_near("force on the branch", fork.force.y / (0.5 * WEIGHT), 1.0, 1e-9);
    // The slope of 2e-3 at the fork rotates the branch inwards.
    let moment = 0.5 * WEIGHT * rod::LENGTH + 0.5 * WEIGHT * FORK;
    assert_near("moment", root.moment.z / moment, 1.0, 1e-3);
    assert_balance("at rest", &assembly, &state, Vector3::from(model.gravity));
}

/// Free fall gt²/2 without strain; average acceleration conserves energy to rounding.
#[test]
fn free_fall_conserves_energy() {
    let mut model = rod::free(3);
    let settings = rod::settings(&mut model);
    (settings.scheme, settings.start) = (model::Scheme::AverageAcceleration, Start::Consistent);
    let run = Run::of(&model);
    let kinetic = run.column("kinetic").last().unwrap();
    for (t, y) in run.column("t").iter().zip(run.column("tip.y")) {
        assert_near("fall", *y, -0.5 * rod::GRAVITY * t * t, 1e-12 * rod::GRAVITY);
    }
    for ((t, v), a) in run.column("t").iter().zip(run.vectors("tip.v")).zip(run.vectors("tip.a")) {
        assert!((v - Vector3::new(0.0, -rod::GRAVITY * t, 0.0)).norm() < 1e-10, "velocity {v}");
        // After 20 m the rounding error EA ε q/l per mass of a node is about 1e-6 m/s².
        assert!((a - Vector3::new(0.0, -rod::GRAVITY, 0.0)).norm() < 1e-5, "acceleration {a}");
    }
    assert_near("kinetic energy", *kinetic / (WEIGHT * 0.5 * rod::GRAVITY * 4.0), 1.0, 1e-12);
    for (dissipated, strain) in run.column("balance").iter().zip(run.column("strain")) {
        assert!(dissipated.abs() < 1e-12 * kinetic && *strain < 1e-12 * kinetic, "{dissipated:e} {strain:e}");
    }
}

/// γ > 1/2 dissipates energy; the change with γ = 1/2, β = 1/4 is smaller by a factor of 100.
#[test]
fn adams_dissipates_and_average_acceleration_does_not() {
    let dissipated = |scheme| {
        let mut model = rod::spherical(3);
        let settings = rod::settings(&mut model);
        (settings.scheme, settings.duration) = (scheme, 0.5);
        settings.start = Start::Consistent;
        let run = Run::of(&model);
        let exchanged = run.column("kinetic").iter().copied().fold(0.0, f64::max);
        run.column("balance").last().unwrap() / exchanged
    };
    let adams = dissipated(model::Scheme::Adams);
    let average = dissipated(model::Scheme::AverageAcceleration);
    assert!(adams > 0.0 && average.abs() < 0.01 * adams, "{adams:e} and {average:e}");
}

/// Steps of 20 to 100 ms, longer than the period of the rod, converge to the equilibrium under weight and tip force.
///
/// q L⁴/8EI + F L³/3EI less the locking of 20 elements is 4.2374 mm. The error of the predictor for a stiff beam must not
/// affect the stopping rule.
#[test]
fn long_steps_end_at_the_equilibrium() {
    let with_force = |step: f64, duration: f64| {
        let mut model = rod::cantilever(20);
        let on = Place::new(model.bodies[0].name(), At::Named(NamedPosition::End));
        model.loads.push(model::Load::force(on, [0.0, -10.0, 0.0]));
        let settings = rod::settings(&mut model);
        *settings = model::Dynamics::new(duration, step); // consistent start, halved steps where needed
        settings.scheme = model::Scheme::Adams; // damps vibrations that the steps do not resolve
        model
    };
    let (assembly, state) = equilibrium(&with_force(1e-3, 1.0), 1);
    let exact = assembly.probes[0].1.value(&state).y;
    for step in [0.02, 0.05, 0.1] {
        let mut series = ancf::record::Series::new();
        let summary = ancf::simulate(&with_force(step, 20.0), &mut series).unwrap();
        assert!(summary.outcome.is_finished(), "{step}: {:?}", summary.outcome);
        let tip = series.columns().find(|(name, _)| name.ends_with(".y")).unwrap().1;
        assert_near("tip", *tip.last().unwrap(), exact, 1e-7);
    }
}

/// A reflection has no strain energy but det J < 0; a rotation by 180° is admissible.
#[test]
fn inverted_elements_are_inadmissible() {
    let assembly = rod::free(2).assemble().unwrap();
    let mut state = assembly.rest();
    assert_eq!(assembly.system.inadmissible(&state), None);
    let mirror = |state: &mut State, axes: &[usize]| {
        for node in 0..3 {
            for &axis in axes {
                let coordinate = 12 * node + 3 * (axis + 1) + axis;
                state.q[coordinate] = -2.0;
            }
        }
    };
    mirror(&mut state, &[1, 2]);
    assert_eq!(assembly.system.inadmissible(&state), None, "rotation by 180° about the axis");
    state = assembly.rest();
    mirror(&mut state, &[2]);
    assert_eq!(
        assembly.system.inadmissible(&state),
        Some((0, Inadmissibility::InvertedElement)),
        "reflection of z"
    );
    assert!(assembly.system.energy(&state).strain.abs() < 1e-6, "strain energy of a reflection");
}
