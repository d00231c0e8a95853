//! Modified and full Newton method.

use ancf::model::NewtonMethod;

use crate::common::models::files::model;
use crate::common::models::parse;
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

/// Body that tumbles about its middle axis through several reversals, which amplify small errors by a factor of 10⁴.
fn tumbling(method: &str, step: f64) -> Vec<f64> {
    let run = Run::of(&parse(&format!(
        "bodies = [{{ kind = \"rigid\", name = \"top\", center = [0, 0, 0], mass = 3, inertia = [0.5, 1, 1.5], \
         motion = {{ spin = [2e-4, 4, 2e-4] }} }}]\n\
         probes = [{{ name = \"c\", on = {{ body = \"top\", at = \"center\" }}, record = [\"rotation\"] }}]\n\
         output = {{ every = 1000000 }}\n[analysis]\nkind = \"dynamics\"\nduration = 10\nstep = {step}\n\
         scheme = {{ spectral_radius = 0.5 }}\nnewton = \"{method}\"\n"
    )));
    ["c.e0", "c.e1", "c.e2", "c.e3"].map(|name| run.last(name)).into()
}

/// The error of the iteration is far below that of the scheme, although it has one sign with reused tangents.
#[test]
fn modified_newton_has_the_error_of_the_scheme() {
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let [coarse, fine] = [6.25e-4, 3.125e-4].map(|step| tumbling("full", step));
    let error = apart(&coarse, &fine) / 3.0;
    let of_newton = apart(&tumbling("modified", 3.125e-4), &fine);
    assert!(of_newton < 0.05 * error, "{of_newton:e} of {error:e}");
}
