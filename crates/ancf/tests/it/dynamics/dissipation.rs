//! Dissipated energy in steps of any size: the energy that damping removes, against closed forms.

use ancf::Model;

use crate::common::assertions::assert_near;
use crate::common::models::parse;
use crate::common::solutions::Run;

const SCHEMES: [&str; 8] = [
    "\"adams\"",
    "\"average_acceleration\"",
    "{ gamma = 0.6, beta = 0.31 }",
    "{ alpha = -0.2 }",
    "{ spectral_radius = 0.0 }",
    "{ spectral_radius = 0.5 }",
    "{ spectral_radius = 0.8 }",
    "{ spectral_radius = 1.0 }",
];

fn dynamics(scheme: &str, duration: f64, step: &str) -> String {
    format!("[analysis]\nkind = \"dynamics\"\nduration = {duration}\nstep = {step}\nscheme = {scheme}\n")
}

/// Mass of 3 kg that is thrown with 2 m/s along a damper and a spring.
fn damped_mass(damping: f64, stiffness: f64, analysis: &str) -> Model {
    parse(&format!(
        "bodies = [{{ kind = \"mass\", name = \"m\", center = [9, 0, 0], mass = 3, motion = {{ velocity = [2, 0, 0] }} }}]\n\
         joints = [{{ kind = \"spring\", name = \"d\", a = {{ body = \"m\", at = \"center\" }}, b = {{ point = [0, 0, 0] }}, \
         stiffness = {stiffness}, damping = {damping} }}]\n{analysis}"
    ))
}

/// Rod that is thrown broadside with 3 m/s, with a damped material or in a fluid at rest.
fn thrown_rod(body: &str, damping: &str, loads: &str, analysis: &str) -> Model {
    parse(&format!(
        "materials.m = {{ density = 500, young = 1e7{damping} }}\nsections.s = {{ kind = \"circle\", diameter = 0.04 }}\n\
         bodies = [{{ {body}, name = \"rod\", from = [0, 0, 0], to = [0.7, 0, 0], elements = 2, section = \"s\", \
         material = \"m\", motion = {{ velocity = [0, 0, 3] }} }}]\n{loads}\n{analysis}"
    ))
}

const BODIES: [&str; 3] = [
    "kind = \"beam\", formulation = \"linked\"",
    "kind = \"beam\", formulation = \"continuum\"",
    "kind = \"cable\"",
];

/// Asserts that damping alone changes the kinetic energy: the dissipated energy is its loss, at all times.
fn assert_exact(what: &str, run: &Run) {
    assert!(run.summary.outcome.is_finished(), "{what}: {:?}", run.summary);
    let (kinetic, dissipated) = (run.column("kinetic"), run.column("dissipated"));
    let start = kinetic[0];
    for (t, (kinetic, dissipated)) in run.column("t").iter().zip(kinetic.iter().zip(dissipated)) {
        assert_near(&format!("{what}, t = {t}"), *dissipated, start - kinetic, 1e-7 * start);
        assert!(*dissipated <= start * (1.0 + 1e-7), "{what}, t = {t}: {dissipated} of {start}");
    }
}

/// Steps from a hundredth to a thousand times the time constant m/c = 6 ms.
#[test]
fn damper_dissipates_the_kinetic_energy_in_steps_of_any_size() {
    for scheme in SCHEMES {
        for step in [6e-5, 6e-3, 0.04, 0.25, 6.0] {
            let analysis = dynamics(scheme, 40.0 * step, &step.to_string());
            let run = Run::of(&damped_mass(500.0, 0.0, &analysis));
            assert_near("start", run.column("kinetic")[0], 6.0, 1e-12);
            assert_exact(&format!("{scheme}, step {step}"), &run);
        }
    }
}

/// Resolved decay: ½ m v² (1 − exp(−2ct/m)).
#[test]
fn dissipation_of_a_damper_follows_the_closed_form() {
    for scheme in ["{ spectral_radius = 0.8 }", "{ alpha = -0.1 }", "\"average_acceleration\""] {
        let run = Run::of(&damped_mass(500.0, 0.0, &dynamics(scheme, 0.03, "1e-4")));
        for (t, dissipated) in run.column("t").iter().zip(run.column("dissipated")) {
            assert_near(scheme, *dissipated, 6.0 * (1.0 - (-2.0 * t / 6e-3).exp()), 1e-3);
        }
    }
}

#[test]
fn damper_dissipates_the_kinetic_energy_in_controlled_steps_and_from_a_start_without_accelerations() {
    for scheme in &SCHEMES[3..7] {
        let analysis = dynamics(scheme, 0.4, "{ tolerance = 1e-4 }");
        assert_exact(&format!("{scheme}, controlled"), &Run::of(&damped_mass(500.0, 0.0, &analysis)));
    }
    for scheme in SCHEMES {
        let analysis = dynamics(scheme, 0.4, "0.01") + "start = \"zero\"\n";
        assert_exact(&format!("{scheme}, zero start"), &Run::of(&damped_mass(500.0, 0.0, &analysis)));
    }
}

#[test]
fn mass_damping_and_drag_dissipate_the_kinetic_energy_in_steps_of_any_size() {
    let fluid = "loads = [{ kind = \"fluid\", bodies = [\"rod\"], density = 1000, drag = [90, 0.1], added_mass = [0, 0] }]";
    for body in BODIES {
        for scheme in ["\"adams\"", "{ spectral_radius = 0.8 }", "{ alpha = -0.2 }"] {
            for step in [1e-4, 2e-3, 0.05] {
                let analysis = dynamics(scheme, 20.0 * step, &step.to_string());
                let damped = thrown_rod(body, ", damping = { mass = 400 }", "", &analysis);
                assert_exact(&format!("{body}, {scheme}, step {step}, mass"), &Run::of(&damped));
                let immersed = thrown_rod(body, "", fluid, &analysis);
                assert_exact(&format!("{body}, {scheme}, step {step}, drag"), &Run::of(&immersed));
            }
        }
    }
}

/// Energy lost by a damped vibration of a mass on a spring, x = (v₀/ω) exp(−δt) sin ωt: error of the order of the scheme.
#[test]
fn dissipation_has_the_order_of_the_scheme() {
    let (damping, stiffness, mass, speed, end) = (6.0_f64, 300.0_f64, 3.0, 2.0_f64, 0.6_f64);
    let decay = damping / (2.0 * mass);
    let omega = (stiffness / mass - decay * decay).sqrt();
    let (sin, cos) = (omega * end).sin_cos();
    let envelope = (-decay * end).exp() * speed;
    let (x, v) = (envelope * sin / omega, envelope * (cos - decay / omega * sin));
    let exact = 0.5 * mass * (speed * speed - v * v) - 0.5 * stiffness * x * x;
    for (scheme, order) in [("{ spectral_radius = 0.8 }", 4.0), ("{ alpha = -0.3 }", 4.0), ("\"adams\"", 2.0)]
    {
        let error = |step: &str| {
            let run = Run::of(&damped_mass(damping, stiffness, &dynamics(scheme, end, step)));
            (run.last("dissipated") - exact).abs()
        };
        let [coarse, fine] = ["2e-3", "1e-3"].map(error);
        assert!(fine < 0.02 * exact, "{scheme}: {fine:e} of {exact}");
        assert!((0.8 * order..1.25 * order).contains(&(coarse / fine)), "{scheme}: {coarse:e}, {fine:e}");
    }
}

/// Hinge with a damper, time constant J/d = 4 ms: at the end of the spin its energy is dissipated.
#[test]
fn damped_hinge_dissipates_the_energy_of_the_spin() {
    for step in ["1e-4", "1e-3", "8e-3", "0.03"] {
        let text = "bodies = [{ kind = \"rigid\", name = \"w\", center = [0, 0, 0], mass = 1, inertia = [0.2, 0.2, 0.04], \
             motion = { spin = [0, 0, 3] } }]\n\
             joints = [{ kind = \"revolute\", name = \"h\", a = { body = \"w\", at = \"center\" }, axis = [0, 0, 1], \
             spring = { stiffness = 0, damping = 10 } }]\n";
        let run = Run::of(&parse(&format!("{text}{}", dynamics("{ spectral_radius = 0.7 }", 0.6, step))));
        assert_near(&format!("step {step}"), run.last("dissipated"), 0.5 * 0.04 * 9.0, 0.02 * 0.18);
    }
}
