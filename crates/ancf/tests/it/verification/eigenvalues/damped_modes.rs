//! Damped modes and modes on a rotating ground, against closed forms and published values.

use std::f64::consts::TAU;

use ancf::Model;
use ancf::model::{Analysis, Modes};

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Mass on three springs and dampers along the axes.
fn mass(stiffness: [f64; 3], damping: [f64; 3], more: &str, count: u32) -> Run {
    let spring = |k: usize| {
        let point = [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 });
        format!(
            "{{ kind = \"spring\", name = \"spring {k}\", a = {{ body = \"bob\", at = \"center\" }}, b = {{ point = {point:?} }}, \
             stiffness = {}, damping = {} }}",
            stiffness[k], damping[k]
        )
    };
    let about = if more.is_empty() { "reference" } else { "equilibrium" };
    Run::of(&parse(&format!(
        "bodies = [{{ kind = \"mass\", name = \"bob\", center = [0, 0, 0], mass = 2 }}]\n\
         joints = [{}, {}, {}]\n{more}\n[analysis]\nkind = \"modes\"\nabout = \"{about}\"\ncount = {count}\ndamped = true\n",
        spring(0),
        spring(1),
        spring(2)
    )))
}

/// λ² m + λ c + k = 0: weak, critical-like strong and no damping.
#[test]
fn oscillators_have_their_closed_forms() {
    let run = mass([200.0, 800.0, 50.0], [4.0, 0.0, 30.0], "", 4);
    // By |λ|: two real eigenvalues of the third spring, the first and the second spring.
    let root = (30.0_f64 * 30.0 - 4.0 * 2.0 * 50.0).sqrt();
    let expected = [
        (0.0, (-30.0 + root) / 4.0),
        ((100.0_f64 - 1.0).sqrt() / TAU, -1.0),
        (0.0, (-30.0 - root) / 4.0),
        (20.0 / TAU, 0.0),
    ];
    for (k, (frequency, growth)) in expected.into_iter().enumerate() {
        let found = [run.column("frequency")[k], run.column("growth_rate")[k]];
        assert!((found[0] - frequency).abs() < 1e-9 * (1.0 + frequency), "{found:?} not {frequency}");
        assert!((found[1] - growth).abs() < 1e-8 * (1.0 + growth.abs()), "{found:?} not {growth}");
        let ratio = -growth / (frequency * TAU).hypot(growth);
        assert!((run.column("damping_ratio")[k] - ratio).abs() < 1e-9);
    }
}

/// Equal springs on a ground that rotates about z: frequencies |ω₀ ± Ω| across the axis and ω₀ along it (Foucault's pendulum).
#[test]
fn rotation_splits_equal_frequencies() {
    for omega in [1.0, 6.0, 9.0] {
        let rotation =
            format!("loads = [{{ kind = \"base_rotation\", angular_velocity = [0, 0, {omega}] }}]");
        let run = mass([200.0; 3], [0.0; 3], &rotation, 3);
        let mut expected = [10.0 - omega, 10.0, 10.0 + omega];
        expected.sort_by(f64::total_cmp);
        for (found, expected) in run.column("frequency").iter().zip(expected) {
            assert!((found * TAU - expected).abs() < 1e-7, "{found} at {omega}");
        }
        assert!(run.column("growth_rate").iter().all(|x| *x == 0.0));
    }
}

/// Damping in the frame of a shaft makes it unstable above the critical speed ω₀ (Kimball 1924).
#[test]
fn damping_of_a_rotor_is_unstable_above_the_critical_speed() {
    for (omega, is_unstable) in [(9.0, false), (11.0, true)] {
        let rotation =
            format!("loads = [{{ kind = \"base_rotation\", angular_velocity = [0, 0, {omega}] }}]");
        let run = mass([200.0; 3], [4.0, 4.0, 4.0], &rotation, 3);
        let grows = run.column("growth_rate").iter().any(|x| *x > 0.0);
        assert_eq!(grows, is_unstable, "{:?}", run.column("growth_rate"));
    }
}

fn damped_beam(tau: f64) -> Model {
    parse(&format!(
        r#"
materials.steel = {{ density = 7850, young = 2e11, damping = {{ strain = {tau} }} }}
sections.round = {{ kind = "rectangle", height = 0.03, width = 0.02 }}
bodies = [{{ kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = 6, section = "round", material = "steel" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "beam", at = "start" }} }}]
[analysis]
kind = "modes"
count = 6
"#
    ))
}

/// Beam of a material with retardation τ: λ² + τ ω² λ + ω² = 0 for each undamped ω.
#[test]
fn strain_damping_of_a_beam_has_its_closed_form() {
    let tau = 2e-4;
    let mut model = damped_beam(tau);
    let undamped = Run::of(&model).column("frequency").to_vec();
    model.analysis = Analysis::Modes(Modes { count: 6, damped: true, ..Modes::default() });
    let run = Run::of(&model);
    for (k, frequency) in undamped.into_iter().enumerate() {
        let omega = TAU * frequency;
        let zeta = 0.5 * tau * omega;
        let expected = [omega * (1.0 - zeta * zeta).sqrt() / TAU, zeta];
        let found = ["frequency", "damping_ratio"].map(|name| run.column(name)[k]);
        assert!((found[0] / expected[0] - 1.0).abs() < 1e-6, "{k}: {found:?} not {expected:?}");
        assert!((found[1] - expected[1]).abs() < 1e-6, "{k}: {found:?} not {expected:?}");
    }
}

/// Real eigenvalues accumulate at −1/τ: only the modes below are known, and a warning says so.
#[test]
fn accumulating_eigenvalues_are_reported() {
    let mut model = damped_beam(2e-3);
    model.analysis = Analysis::Modes(Modes { count: 8, damped: true, ..Modes::default() });
    let run = Run::of(&model);
    let count = run.column("frequency").len();
    assert!((2..8).contains(&count), "{count}");
    assert!(
        run.summary.warnings.iter().any(|text| text.contains("of 8 damped modes")),
        "{:?}",
        run.summary.warnings
    );
}

/// Frequency parameters of a rotating cantilever with flapping motion, Ω² ρA L⁴/EI = η² (Wright, Smith, Thresher & Wang 1982).
const FLAP: [(f64, f64); 5] = [(0.0, 3.5160), (2.0, 4.1373), (4.0, 5.5850), (8.0, 9.2568), (12.0, 13.1702)];

/// Flap and lag frequencies of a rotating cantilever: ω² of lag = ω² of flap − Ω². Also on a fine mesh.
#[test]
fn rotating_cantilever_has_published_frequencies() {
    let blade = |eta: f64, elements: u32| {
        // Unit frequency: EI = 1, ρA = 1, L = 1, slender.
        let side = 0.002_f64;
        let (young, density) = (12.0 / side.powi(4), 1.0 / side.powi(2));
        Run::of(&parse(&format!(
            r#"
materials.steel = {{ density = {density:e}, young = {young:e} }}
sections.square = {{ kind = "rectangle", height = {side}, width = {side} }}
bodies = [{{ kind = "cable", name = "blade", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, section = "square", material = "steel" }}]
joints = [{{ kind = "clamp", name = "hub", a = {{ body = "blade", at = "start" }} }}]
loads = [{{ kind = "base_rotation", angular_velocity = [0, 0, {eta}] }}]
[analysis]
kind = "modes"
about = "equilibrium"
count = 2
damped = true
"#
        )))
        .column("frequency")
        .iter()
        .map(|x| x * TAU)
        .collect::<Vec<f64>>()
    };
    for (eta, flap) in FLAP {
        let found = blade(eta, 16);
        let lag = (flap * flap - eta * eta).sqrt();
        assert!((found[1] - flap).abs() < 1e-4 * flap, "η = {eta}: {found:?}, flap {flap}");
        assert!((found[0] - lag).abs() < 5e-4 * lag, "η = {eta}: {found:?}, lag {lag}");
    }
    let (coarse, fine) = (blade(4.0, 20), blade(4.0, 200));
    assert!((coarse[0] - fine[0]).abs() < 1e-5 * fine[0], "{coarse:?} {fine:?}");
    assert!((coarse[1] - fine[1]).abs() < 1e-5 * fine[1], "{coarse:?} {fine:?}");
}

/// A free motion has the eigenvalue 0, twice without a damper, which is one row. With a damper the second one is −c/m.
#[test]
fn free_motions_have_zero_eigenvalues() {
    let run = mass([200.0, 0.0, 0.0], [0.0, 4.0, 0.0], "", 4);
    let (frequency, growth) = (run.column("frequency"), run.column("growth_rate"));
    let zeros = (0..frequency.len()).filter(|&k| frequency[k] == 0.0 && growth[k] == 0.0).count();
    assert_eq!(zeros, 2, "{frequency:?} {growth:?}");
    assert!(growth.iter().any(|x| (x + 2.0).abs() < 1e-6), "{growth:?}");
    assert!(frequency.iter().any(|x| (x * TAU - 10.0).abs() < 1e-6), "{frequency:?}");
}
