//! Drives and gaps that statics closes.

use ancf::Model;
use ancf::mechanics::constraints::CoincidenceConstraint;
use ancf::mechanics::kinematics::Marker;
use ancf::model::ScaleChoice;
use ancf::solver::equations::{EquationsOfMotion, State, System, Term, Weights};
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::Vector3;

use crate::common::models::parse;
use crate::common::solutions::{Run, distance};

/// Stiff rod along x with a drive about z.
fn arm(text: &str, joint: &str) -> Model {
    let model = format!(
        r#"
        materials.stiff = {{ density = 1000, young = 1e11 }}
        sections.round = {{ kind = "circle", diameter = 0.05 }}
        probes = [{{ name = "tip", on = {{ body = "arm", at = "end" }} }}]

        [[bodies]]
        kind = "beam"
        name = "arm"
        from = [0, 0, 0]
        to = [0.5, 0, 0]
        elements = 2
        formulation = "continuum"
        section = "round"
        material = "stiff"

        [[joints]]
        kind = "drive"
        name = "motor"
        a = {{ body = "arm", at = "start" }}
        axis = [0, 0, 2]
        {joint}
        time = {{ kind = "expression", text = "{text}" }}

        [analysis]
        kind = "dynamics"
        duration = 1.0
        step = 2e-3
        start = "consistent"
        "#
    );
    parse(&model)
}

/// θ = 2 t³: motor torque J θ̈, bearing force m L/2 (θ̈, −θ̇²).
#[test]
fn stiff_arm_follows_its_drive_with_rigid_body_reactions() {
    for fix in ["all", "section"] {
        let run = Run::of(&arm("t^3", &format!("angle = 2\nfix = \"{fix}\"")));
        let (length, radius) = (0.5, 0.025_f64);
        let mass = 1000.0 * std::f64::consts::PI * radius.powi(2) * length;
        let inertia = mass * (length.powi(2) / 3.0 + radius.powi(2) / 4.0);
        let (tip, force, moment) =
            (run.vectors("tip."), run.vectors("motor.f"), run.column("motor.mz").to_vec());
        for (i, &t) in run.column("t").iter().enumerate() {
            let (theta, omega, alpha) = (2.0 * t.powi(3), 6.0 * t * t, 12.0 * t);
            let (x, y) =
                (Vector3::new(theta.cos(), theta.sin(), 0.0), Vector3::new(-theta.sin(), theta.cos(), 0.0));
            assert!((tip[i] - x * length).norm() < 2e-4 * length, "{fix}, tip at {t}");
            // Transient of Newmark's scheme, of first order, after the jump of the third derivative at t = 0.
            if t > 0.1 {
                let expected = (y * alpha - x * omega * omega) * (0.5 * mass * length);
                assert!((force[i] - expected).norm() < 0.02 * 8.0 * mass * length, "{fix}, force at {t}");
                assert!((moment[i] - inertia * alpha).abs() < 0.02 * 12.0 * inertia, "{fix}, moment at {t}");
            }
        }
    }
}

/// Angle and time in other units.
#[test]
fn scales_do_not_change_a_driven_motion() {
    let model = arm("1 - cos(3*t)", "angle = 0.7");
    let mut scaled = model.clone();
    scaled.scales = ScaleChoice::Given { length: 0.03, force: 7e4, time: Some(0.013) };
    let (a, b) = (Run::of(&model), Run::of(&scaled));
    assert!(distance(&a.vectors("tip."), &b.vectors("tip.")) < 1e-9);
    assert_eq!(a.summary.outcome, b.summary.outcome);
}

/// The gap between the tip of a cantilever and a point closes in proportion to the load factor.
#[test]
fn statics_closes_a_gap_in_proportion_to_the_load() {
    let assembly = arm("0", "").assemble_static().unwrap();
    let mesh = assembly.mesh("arm").unwrap();
    let (end, target) = (mesh.point(0.5), Vector3::new(0.48, 0.1, 0.03));
    let multipliers = assembly.system.multipliers();
    let mut terms: Vec<Box<dyn Term>> = mesh.terms();
    for (i, direction) in [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().enumerate() {
        let ground = Marker::fixed(direction);
        terms.push(Box::new(CoincidenceConstraint::directions(
            mesh.direction(0.0, direction),
            &ground,
            3 + 3 * i,
        )));
    }
    let start = mesh.point(0.0);
    terms.push(Box::new(CoincidenceConstraint::points(&start, Marker::fixed(start.reference()), 0)));
    terms.push(Box::new(CoincidenceConstraint::toward(&end, target, multipliers)));
    let system = System::new(assembly.system.coordinates(), multipliers + 3, terms);
    let mut state = State::rest(system.coordinates(), system.multipliers());
    for step in 1..=4 {
        state.load = f64::from(step) / 4.0;
        let mut newton = Newton::new(system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
        newton.solve(&system, &mut state, Weights::STIFFNESS).unwrap();
        let expected = end.reference() + (target - end.reference()) * state.load;
        assert!((end.value(&state) - expected).norm() < 1e-12);
    }
}

/// In statics the angle of a drive is proportional to the load factor, independent of its function of time.
#[test]
fn statics_rotates_a_drive_in_proportion_to_the_load() {
    let assembly = arm("t^3", "angle = 1.2").assemble_static().unwrap();
    let mut state = assembly.rest();
    for step in 1..=4 {
        state.load = f64::from(step) / 4.0;
        // A rigid rotation has no energy for the energy rule.
        let mut newton = Newton::new(assembly.system.matrix(), StopRule::Increment(1e-11), 50).unwrap();
        newton.solve(&assembly.system, &mut state, Weights::STIFFNESS).unwrap();
        let (sin, cos) = (1.2 * state.load).sin_cos();
        let tip = assembly.probes[0].1.value(&state);
        assert!((tip - Vector3::new(cos, sin, 0.0) * 0.5).norm() < 1e-10, "{tip}");
    }
    assert!(assembly.breaks().is_empty());
}
