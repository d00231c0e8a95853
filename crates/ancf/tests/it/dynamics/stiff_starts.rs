//! Starts of stiff bodies: with spin and without strain, and under sudden loads.

use ancf::Model;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Free strip of 0.2 × 0.1 × 0.004 in the plane of x and y that spins about y by 12 radians per second.
fn spinning(body: &str, young: f64, keys: &str, step: f64) -> Model {
    let text = format!(
        "materials.m = {{ young = {young:e}, poisson = 0.3, density = 1200 }}\n\
         sections.s = {{ kind = \"rectangle\", height = 0.004, width = 0.1 }}\n\
         sections.c = {{ kind = \"circle\", diameter = 0.01 }}\n\
         [[bodies]]\nname = \"s\"\nmaterial = \"m\"\n{body}\nmotion = {{ spin = [0, 12, 0], about = [0, 0, 0] }}\n\
         [output]\nmomentum = true\n[analysis]\nkind = \"dynamics\"\nduration = 0.1\nstep = {step}\n{keys}\n"
    );
    parse(&text)
}

const BODIES: [&str; 4] = [
    "kind = \"cable\"\nfrom = [-0.1, 0, 0]\nto = [0.1, 0, 0]\nelements = 2\nsection = \"c\"",
    "kind = \"beam\"\nfrom = [-0.1, 0, 0]\nto = [0.1, 0, 0]\nelements = 2\nup = [0, 0, 1]\nsection = \"s\"",
    "kind = \"shell\"\nelements = [4, 1]\nthickness = 0.004\n\
     surface = { kind = \"flat\", corner = [-0.1, 0, 0], side_u = [0.2, 0, 0], side_v = [0, 0.1, 0] }",
    "kind = \"shear_shell\"\nthickness = 0.004\nmesh = { nodes = [[-0.1, 0, 0], [0, 0, 0], [0.1, 0, 0], [-0.1, 0.1, 0], [0, 0.1, 0], [0.1, 0.1, 0]], \
     elements = [[0, 1, 4, 3], [1, 2, 5, 4]] }",
];

/// Angular momentum about y after the first step and at the end, relative to that at the start.
fn kept(model: &Model) -> [f64; 2] {
    let run = Run::of(model);
    let momentum = run.column("s.ly");
    [momentum[1] / momentum[0], momentum[momentum.len() - 1] / momentum[0]]
}

/// The first step keeps the angular momentum for every stiffness. Before, an error in the rate of the accelerations changed its sign.
#[test]
fn stiff_bodies_keep_their_spin_in_the_first_step() {
    for body in BODIES {
        for young in [1e8, 1e10, 2e12] {
            let [first, _] = kept(&spinning(body, young, "", 0.01));
            assert!((first - 1.0).abs() < 2e-2, "{body}, {young:e}: {first}");
        }
    }
}

/// The error falls with the second power of the step or faster.
#[test]
fn the_momentum_converges_with_the_step() {
    for body in BODIES {
        let errors = [0.01, 0.005].map(|step| (kept(&spinning(body, 1e10, "", step))[1] - 1.0).abs());
        assert!(errors[1] < 0.02 && errors[1] < 0.5 * errors[0], "{body}: {errors:?}");
    }
}

/// A sudden force at the end of a steel rod excites vibrations that the steps do not resolve. Accelerations extrapolated over a step have
/// thousands of times the energy of the motion in a fine mesh. The numbers of iterations and of divided steps are those of a coarse mesh.
#[test]
fn iterations_after_a_sudden_load_do_not_grow_with_the_mesh() {
    for formulation in ["linked", "continuum"] {
        let [coarse, fine] = [10, 120].map(|elements| {
            Run::of(&parse(&format!(
                r#"
gravity = [0, 0, -9.81]
materials.steel = {{ density = 7850, young = 2.1e11, poisson = 0.3 }}
sections.bar = {{ kind = "circle", diameter = 0.02 }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, formulation = "{formulation}", section = "bar", material = "steel" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "b", at = "start" }} }}]
loads = [{{ kind = "force", on = {{ body = "b", at = "end" }}, force = [1000, 500, 0] }}]
probes = [{{ name = "tip", on = {{ body = "b", at = "end" }} }}]
analysis = {{ kind = "dynamics", duration = 0.02, step = 1e-3, scheme = {{ spectral_radius = 0.8 }} }}
"#
            )))
        });
        assert!(fine.summary.divided_steps <= coarse.summary.divided_steps, "{formulation}");
        let [of_coarse, of_fine] = [&coarse, &fine].map(|run| run.summary.iterations as f64);
        assert!(of_fine < 1.15 * of_coarse, "{formulation}: {of_fine} and {of_coarse} iterations");
        let [coarse, fine] = [&coarse, &fine].map(|run| run.last_vector("tip."));
        assert!((fine - coarse).norm() < 5e-3 * fine.y, "{formulation}: {fine} and {coarse}");
    }
}

/// Beam on a hinge in its origin with a moment there. Without gravity the reaction is the rate of its momentum.
fn driven_beam(formulation: &str, axis: &str, load: &str, analysis: &str) -> Run {
    Run::of(&parse(&format!(
        r#"
materials.m = {{ density = 2700, young = 7e9, poisson = 0.3, damping.strain = 1e-3 }}
sections.s = {{ kind = "rectangle", height = 0.02, width = 0.012 }}
output.momentum = true
analysis = {{ kind = "dynamics", duration = 0.025, {analysis} }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [0.8, 0.1, 0.05], elements = 4, section = "s", material = "m", formulation = "{formulation}" }}]
joints = [{{ kind = "revolute", name = "hinge", a = {{ body = "b", at = "start" }}, axis = {axis} }}]
loads = [{{ kind = "moment", on = {{ body = "b", at = "start" }}, {load} }}]
"#
    )))
}

/// Magnitudes of the reaction at the ends of steps of 1 ms, from a time on.
fn reactions(run: &Run, stride: usize, from: usize) -> Vec<f64> {
    let [x, y, z] = ["hinge.fx", "hinge.fy", "hinge.fz"].map(|name| run.column(name));
    (from..from + 5).map(|k| f64::hypot(x[k * stride], y[k * stride]).hypot(z[k * stride])).collect()
}

/// A sudden moment at a hinge accelerates motions of the end of a beam that steps of 1 ms do not resolve. Reactions are those of steps of
/// 10 µs for every spectral radius, at the start and within the motion. Before, they were 5 to 70 times as large for tens of steps.
#[test]
fn reactions_after_a_sudden_moment_are_those_of_small_steps() {
    let sudden = "moment = [0.9, 0, 0]";
    let stepped = "moment = [0.9, 0, 0], time = { kind = \"step\", at = 0.01 }";
    for formulation in ["linked", "quadratic"] {
        let fine = driven_beam(formulation, "[1, 0, 0]", sudden, "step = 1e-5");
        let fine = reactions(&fine, 100, 1);
        for radius in [0.0, 0.5, 0.8, 0.9] {
            for (load, from) in [(sudden, 1), (stepped, 11)] {
                let analysis = format!("step = 1e-3, scheme.spectral_radius = {radius}");
                let coarse = reactions(&driven_beam(formulation, "[1, 0, 0]", load, &analysis), 1, from);
                for (found, expected) in coarse.iter().zip(&fine) {
                    let error = found / expected - 1.0;
                    assert!(error.abs() < 0.1, "{formulation}, {radius}, {from}: {coarse:?} {fine:?}");
                }
            }
        }
    }
}

/// The centripetal accelerations of a beam that already turns remain, and the impulse of the reaction is the change of the momentum.
#[test]
fn a_sudden_moment_on_a_turning_beam_changes_its_momentum_by_the_impulse_of_the_reaction() {
    for radius in [0.5, 0.9] {
        let analysis = format!("step = 1e-3, scheme.spectral_radius = {radius}");
        let load = "moment = [0, 0, 2], time = { kind = \"step\", at = 0.01 }";
        let load = &format!(
            "{load} }}, {{ kind = \"moment\", on = {{ body = \"b\", at = \"start\" }}, moment = [0, 0, 4]"
        );
        let run = driven_beam("linked", "[0, 0, 1]", load, &analysis);
        let [fx, px] = [run.column("hinge.fx"), run.column("b.px")];
        for k in 12..24 {
            let rate = (px[k + 1] - px[k - 1]) / 2e-3;
            assert!((fx[k] - rate).abs() < 0.1 * rate.abs().max(20.0), "{radius}, {k}: {} {rate}", fx[k]);
        }
    }
}
