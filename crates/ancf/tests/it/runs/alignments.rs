//! Joints that begin after their bodies have turned: their equations also hold in other orientations, which are refused.

use ancf::record::Series;
use ancf::{Simulation, Stepper};

use super::given_states::States;
use crate::common::models::parse;

/// Rigid body that has an angular velocity, with joints and an analysis.
fn body(spin: [f64; 3], joints: &str, analysis: &str) -> String {
    format!(
        "bodies = [{{ kind = \"rigid\", name = \"w\", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1], \
         motion = {{ spin = {spin:?} }} }}]\njoints = [{joints}]\n\
         probes = [{{ name = \"p\", on = {{ body = \"w\", at = [1, 2, 3] }} }}]\n{analysis}\n"
    )
}

const MOTION: &str =
    "[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-2\nscheme = { spectral_radius = 0.9 }";

/// Joint that keeps an axis across z, or all axes.
fn joint(kind: &str) -> String {
    format!("{{ name = \"lock\", a = {{ body = \"w\", at = \"center\" }}, {kind} }}")
}

const KINDS: [&str; 7] = [
    "kind = \"clamp\"",
    "kind = \"revolute\", axis = [1, 0, 0]",
    "kind = \"cylindrical\", axis = [1, 0, 0]",
    "kind = \"planar\", normal = [1, 0, 0]",
    "kind = \"prismatic\", axis = [0, 1, 0]",
    "kind = \"generic\", displacements = [\"locked\", \"locked\", \"free\"], rotations = [\"locked\", \"locked\", \"locked\"]",
    "kind = \"generic\", displacements = [\"locked\", \"locked\", \"locked\"], rotations = [\"free\", \"locked\", \"locked\"]",
];

/// After a rotation below a right angle the body returns to its place. After a larger one, or exactly half a turn, the analysis fails.
#[test]
fn bodies_return_to_the_orientation_of_the_joint_or_fail() {
    let statics = "[analysis]\nkind = \"statics\"";
    for spin in [[0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [0.0, 0.0, std::f64::consts::PI], [0.6, 1.1, 1.7]] {
        let first = Simulation::new(&parse(&body(spin, "", MOTION))).unwrap();
        let mut turned = States::default();
        let _ = first.run(&mut turned).unwrap();
        let given = first.given_state(turned.states.last().unwrap(), "the motion before");
        for kind in KINDS {
            for analysis in [MOTION, statics] {
                let is_static = analysis != MOTION;
                if is_static && kind != KINDS[0] {
                    continue;
                }
                let text = body([0.0; 3], &joint(kind), analysis);
                let simulation = Simulation::new(&parse(&text)).unwrap();
                let start = simulation.start_from(&given).unwrap();
                let mut series = Series::new();
                let summary = simulation.run_from(&start, &mut series).unwrap();
                let finished = summary.outcome.is_finished();
                let angle = spin.iter().map(|w| w * w).sum::<f64>().sqrt();
                assert_eq!(finished, angle < 1.5, "{kind} {spin:?}: {:?}", summary.outcome);
                if finished {
                    for (name, expected) in [("p.x", 1.0), ("p.y", 2.0), ("p.z", 3.0)] {
                        let found = *series.column(name).unwrap().first().unwrap();
                        let found =
                            if is_static { *series.column(name).unwrap().last().unwrap() } else { found };
                        assert!((found - expected).abs() < 1e-6, "{kind} {spin:?} {name}: {found}");
                    }
                } else {
                    let message = format!("{:?}", summary.outcome);
                    assert!(message.contains("lock") || message.contains("no equilibrium"), "{message}");
                }
            }
        }
    }
}

/// A given state of a stepper states the rotation of its correction, or is rejected.
#[test]
fn corrected_rotations_of_given_states_are_reported() {
    let mut stepper = Stepper::new(&parse(&body([0.0; 3], &joint(KINDS[0]), MOTION))).unwrap();
    let state = stepper.state();
    let layout = stepper.layout().remove(0);
    for angle in [0.5_f64, 2.0, std::f64::consts::PI] {
        let (cos, sin) = (angle.cos(), angle.sin());
        let mut turned = state.clone();
        for (k, reference) in layout.reference.iter().enumerate().filter(|(k, _)| !layout.are_positions[*k]) {
            let [x, y, _] = *reference;
            let own = layout.first + 3 * k;
            turned.coordinates[own] = cos * x - sin * y - x;
            turned.coordinates[own + 1] = sin * x + cos * y - y;
        }
        let projection = stepper.set_state(&turned);
        match projection {
            Ok(projection) => {
                assert!(angle < 1.0 && projection.moved < 1e-9, "{angle}: {projection:?}");
                // The chord of the rotation.
                assert!((projection.turned - 2.0 * (0.5 * angle).sin()).abs() < 0.05, "{projection:?}");
            }
            Err(error) => {
                assert!(angle > 1.0 && error.to_string().contains("lock"), "{angle}: {error}");
            }
        }
    }
}
