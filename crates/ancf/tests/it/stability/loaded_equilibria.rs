//! Vibrations about equilibria that are stable by their loads only.

use std::f64::consts::PI;

use ancf::model::ScaleChoice;
use ancf::record::Series;
use ancf::{Model, Outcome, simulate};

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Body of 1 kg and 0.01 kg m² with its centre 0.3 m from the origin.
fn bob(center: [f64; 3], joints: &str) -> Model {
    let text = format!(
        "gravity = [0, 0, -9.81]
        bodies = [{{ kind = \"rigid\", name = \"bob\", center = {center:?}, mass = 1, inertia = [0.01, 0.01, 0.01] }}]
        joints = [{joints}]
        probes = [{{ name = \"bob\", on = {{ body = \"bob\", at = \"center\" }} }}]
        analysis = {{ kind = \"modes\", count = 3, about = \"equilibrium\" }}"
    );
    parse(&text)
}

/// ω = √(m g a/(J + m a²)) from any initial position. With a spherical joint the spin is free and the analysis fails.
#[test]
fn pendulum_has_its_natural_frequency() {
    let exact = (9.81 * 0.3 / (0.01 + 0.3_f64.powi(2))).sqrt() / (2.0 * PI);
    let hinge =
        "kind = \"revolute\", name = \"hook\", a = { body = \"bob\", at = [0, 0, 0] }, axis = [0, 1, 0]";
    let ball = "kind = \"spherical\", name = \"ball\", a = { body = \"bob\", at = [0, 0, 0] }";
    for center in [[0.0, 0.0, -0.3], [0.18, 0.0, -0.24], [0.3, 0.0, 0.0]] {
        for scales in [ScaleChoice::None, ScaleChoice::Auto] {
            let model = |joint: &str| Model { scales, ..bob(center, &format!("{{ {joint} }}")) };
            let hinged = Run::of(&model(hinge));
            let found = hinged.column("frequency")[0];
            assert!((found / exact - 1.0).abs() < 1e-9, "{center:?}: {found} not {exact}");
            let summary = simulate(&model(ball), &mut Series::new()).unwrap();
            assert!(!summary.outcome.is_finished(), "{center:?}: the spin is free");
        }
    }
}

#[test]
fn falling_body_has_no_equilibrium() {
    let summary = simulate(&bob([0.0, 0.0, 0.0], ""), &mut Series::new()).unwrap();
    let Outcome::Failed { reason, at, .. } = summary.outcome else { panic!("{:?}", summary.outcome) };
    assert!(reason.contains("a motion is unsupported") && at.contains("translate along z"), "{reason} {at}");
}

/// ω = Ω √(m a r/(J + m a²)) with the distance r from the axis of rotation, for any Ω: nothing but the unit of time changes.
#[test]
fn pendulum_in_a_centrifugal_field_does_not_depend_on_the_unit_of_time() {
    let exact = (3.0_f64 / 1.01).sqrt() / (2.0 * PI);
    for rate in [1e-6, 0.1, 0.3, 0.5, 1.0, 2.0, 3.0, 10.0, 100.0, 1e5] {
        for center in [[0.6, 0.0, -0.8], [0.8, 0.0, -0.6], [-0.3, 0.0, -0.9539392014169456]] {
            let text = format!(
                "loads = [{{ kind = \"base_rotation\", angular_velocity = [{rate:?}, 0, 0], point = [0, 0, 2] }}]
                bodies = [{{ kind = \"rigid\", name = \"b\", center = {center:?}, mass = 1, inertia = [1e-2, 1e-2, 1e-2] }}]
                joints = [{{ kind = \"revolute\", name = \"j\", a = {{ body = \"b\", at = [0, 0, 0] }}, axis = [0, 1, 0] }}]
                analysis = {{ kind = \"modes\", about = \"equilibrium\", damped = true, count = 2 }}"
            );
            let found = Run::of(&parse(&text)).column("frequency")[0] / rate;
            assert!((found / exact - 1.0).abs() < 1e-8, "{rate} {center:?}: {found} not {exact}");
        }
    }
}

/// ω = √(F a/(J + m a²)) of a pendulum under a force of any size, from below and from above its hinge.
#[test]
fn pendulum_under_a_force_does_not_depend_on_its_size() {
    for size in [1e-6_f64, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6] {
        for center in [[0.6, 0.0, -0.8], [0.8, 0.0, 0.6]] {
            let loads = [
                format!(
                    "kind = \"force\", on = {{ body = \"b\", at = \"center\" }}, force = [0, 0, {:?}]",
                    -size
                ),
                format!("kind = \"base_acceleration\", acceleration = [0, 0, {size:?}]"),
            ];
            for load in loads {
                let text = format!(
                    "loads = [{{ {load} }}]
                    bodies = [{{ kind = \"rigid\", name = \"b\", center = {center:?}, mass = 1, inertia = [1e-2, 1e-2, 1e-2] }}]
                    joints = [{{ kind = \"revolute\", name = \"j\", a = {{ body = \"b\", at = [0, 0, 0] }}, axis = [0, 1, 0] }}]
                    analysis = {{ kind = \"modes\", about = \"equilibrium\", count = 1 }}"
                );
                let found = Run::of(&parse(&text)).column("frequency")[0];
                let exact = (size / 1.01).sqrt() / (2.0 * PI);
                assert!((found / exact - 1.0).abs() < 1e-8, "{size} {center:?} {load}: {found} not {exact}");
            }
        }
    }
}

/// Flap of a blade with a hinge at a tenth of the radius: Ω √(1 + 3 e/(2 (1 − e))) for a rigid blade, from an angle above its plane.
#[test]
fn hinged_blade_finds_its_plane() {
    for rate in [1.0_f64, 30.0, 100.0, 300.0] {
        let text = format!(
            "materials.m = {{ density = 2000, young = 1e10 }}
            sections.s = {{ kind = \"rectangle\", height = 0.02, width = 0.05 }}
            bodies = [{{ kind = \"beam\", name = \"b\", from = [0.1, 0, 0], to = [0.9820599, 0, 0.1788024], elements = 8, section = \"s\", material = \"m\" }}]
            joints = [{{ kind = \"revolute\", name = \"j\", a = {{ body = \"b\", at = \"start\" }}, axis = [0, 1, 0] }}]
            loads = [{{ kind = \"base_rotation\", angular_velocity = [0, 0, {rate:?}] }}]
            analysis = {{ kind = \"modes\", about = \"equilibrium\", damped = true, count = 3 }}"
        );
        let run = Run::of(&parse(&text));
        let found = run.column("frequency").iter().map(|f| f * 2.0 * PI / rate);
        let nearest = found.min_by(|a, b| (a - 1.08).abs().total_cmp(&(b - 1.08).abs())).unwrap();
        assert!((nearest - 1.0801).abs() < 2e-3, "{rate}: {nearest}");
        assert!(run.summary.warnings.is_empty(), "{:?}", run.summary.warnings);
    }
}

/// An equilibrium that Coriolis forces alone stabilise has a warning.
#[test]
fn statically_unstable_equilibrium_of_damped_modes_has_a_warning() {
    // A mass on springs, rotating faster than its natural frequency.
    let text = "loads = [{ kind = \"base_rotation\", angular_velocity = [0, 0, 3] }]
        bodies = [{ kind = \"rigid\", name = \"m\", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1] }]
        joints = [{ kind = \"bushing\", name = \"k\", a = { body = \"m\", at = \"center\" }, stiffness = [1, 1, 1, 100, 100, 100] }]
        analysis = { kind = \"modes\", about = \"equilibrium\", damped = true, count = 3 }";
    let run = Run::of(&parse(text));
    let warnings = &run.summary.warnings;
    assert!(
        warnings.iter().any(|text| text.contains("unstable without velocities in 2 directions")),
        "{warnings:?}"
    );
}
