//! Modified and full Newton method.

use ancf::model::NewtonMethod;

use crate::common::models::files::model;
use crate::common::solutions::{Run, distance};

/// Runs the first steps of a model.
fn run_of(name: &str, method: NewtonMethod, steps: f64) -> Run {
    let mut model = model(name);
    let settings = model.analysis.dynamics_mut().unwrap();
    settings.newton = method;
    let step = settings.step.fixed().unwrap();
    settings.duration = settings.duration.min(steps * step);
    Run::of(&model)
}

/// Small vibrations, pendulums and a fast rotation.
#[test]
fn newton_methods_find_the_same_motion() {
    for (name, probe) in [
        ("cantilever", "tip."),
        ("revolute_pendulum", "tip."),
        ("spherical_pendulum", "tip."),
        ("spin_up", "tip."),
    ] {
        let [full, modified] =
            [NewtonMethod::Full, NewtonMethod::Modified].map(|method| run_of(name, method, 500.0));
        let error = distance(&full.vectors(probe), &modified.vectors(probe));
        let size = full.vectors(probe).iter().map(|x| x.norm()).fold(0.0, f64::max);
        assert!(error < 1e-8 * size, "{name}: {error:e} of {size}");
    }
}

/// An iteration without a new tangent takes a third of the time, hence at most twice the iterations are acceptable.
#[test]
fn modified_newton_needs_at_most_twice_the_iterations() {
    let [full, modified] =
        [NewtonMethod::Full, NewtonMethod::Modified].map(|m| run_of("cantilever", m, 500.0));
    assert!(modified.summary.iterations < 2 * full.summary.iterations);
    assert!(modified.column("iterations").iter().all(|n| *n <= 6.0));
}
