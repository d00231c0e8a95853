//! The modified and the full Newton method find the same motion.

use std::path::Path;

use crate::common::solutions::{Run, distance};
use ancf::Model;
use ancf::model::NewtonMethod;

/// The first `steps` steps of a model.
fn run_of(name: &str, method: NewtonMethod, steps: f64) -> Run {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../models/{name}.toml"));
    let mut model = Model::read(&path).unwrap();
    let settings = model.analysis.dynamics_mut().unwrap();
    settings.newton = method;
    let step = settings.step.fixed().unwrap();
    settings.duration = settings.duration.min(steps * step);
    Run::of(&model)
}

/// Small vibrations, stiff ones on joints, a mechanism, a fast rotation.
#[test]
fn same_motion() {
    for (name, probe) in [
        ("cantilever", "tip."),
        ("revolute_pendulum", "tip."),
        ("spherical_pendulum", "tip."),
        ("spin_up", "tip."),
    ] {
        let [full, modified] =
            [NewtonMethod::Full, NewtonMethod::Modified].map(|method| run_of(name, method, 500.0));
        let apart = distance(&full.vectors(probe), &modified.vectors(probe));
        let size = full.vectors(probe).iter().map(|x| x.norm()).fold(0.0, f64::max);
        assert!(apart < 1e-8 * size, "{name}: {apart:e} of {size}");
    }
}

/// Old tangents are to save time: small vibrations take no more than twice the iterations, each of a third of the cost.
#[test]
fn iterations() {
    let [full, modified] =
        [NewtonMethod::Full, NewtonMethod::Modified].map(|m| run_of("cantilever", m, 500.0));
    assert!(modified.summary.iterations < 2 * full.summary.iterations);
    assert!(modified.column("iterations").iter().all(|n| *n <= 6.0));
}
