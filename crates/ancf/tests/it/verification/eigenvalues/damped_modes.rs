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

/// Damping ratios of the modes of a cantilever with retardation times.
fn ratios_of_kinds(damping: &str, formulation: &str) -> Vec<f64> {
    let model = parse(&format!(
        r#"
materials.m = {{ density = 1000, young = 1e9, damping = {{ {damping} }} }}
sections.round = {{ kind = "rectangle", height = 0.1, width = 0.08 }}
bodies = [{{ kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "round", material = "m", formulation = "{formulation}" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "beam", at = "start" }} }}]
[analysis]
kind = "modes"
count = 8
damped = true
"#
    ));
    Run::of(&model).column("damping_ratio").to_vec()
}

/// Each kind of deformation has the damping of its own time: ζ = Σ_k τ_k ω U_k/2U with the strain energies U_k of a mode.
#[test]
fn retardation_times_by_kind_add_up() {
    for formulation in ["linked", "enhanced", "quadratic"] {
        let of = |damping: &str| ratios_of_kinds(damping, formulation);
        let all = of("strain = 1e-6");
        let section = "strain = 1e-6, stretch = 0, bending = 0, shear = 0, torsion = 0";
        let kinds = ["stretch = 1e-6", "bending = 1e-6", "shear = 1e-6", "torsion = 1e-6", section].map(of);
        for (mode, all) in all.iter().enumerate() {
            let shares = kinds.each_ref().map(|ratios| ratios[mode] / all);
            let sum: f64 = shares.iter().sum();
            assert!((sum - 1.0).abs() < 1e-6, "{formulation} {mode}: {shares:?}");
            let [stretch, bending, shear, torsion, section] = shares;
            assert!(section < 1e-4, "{formulation} {mode}: {shares:?}");
            // Modes of tension and torsion have one kind of strain, modes of bending two: more shear at higher frequencies.
            let is_pure = stretch.max(torsion) > 1.0 - 1e-4;
            let is_bending = stretch.max(torsion) < 1e-4 && bending > 0.5 && shear > 1e-3;
            assert!(is_pure || is_bending, "{formulation} {mode}: {shares:?}");
        }
        let has = |kind: usize| all.iter().enumerate().any(|(mode, all)| kinds[kind][mode] > 0.999 * all);
        assert!(has(0) && has(3), "{formulation}: {kinds:?}");
    }
}

/// Massless short cantilever with a tip mass: shear has the share (L/kGA)/(L/kGA + L³/3EI) of the energy.
#[test]
fn damping_of_shear_has_its_share_of_the_energy() {
    let run = Run::of(&parse(
        r#"
materials.m = { density = 1e-6, young = 1e6, damping = { shear = 1e-4 } }
sections.s = { kind = "general", area = 0.01, iy = 1e-5, iz = 1e-5, ky = 0.5, kz = 0.5 }
[[bodies]]
kind = "beam"
name = "beam"
from = [0, 0, 0]
to = [0.2, 0, 0]
elements = 4
section = "s"
material = "m"
[[bodies]]
kind = "mass"
name = "tip"
center = [0.2, 0, 0]
mass = 1
[[joints]]
kind = "clamp"
name = "root"
a = { body = "beam", at = "start" }
[[joints]]
kind = "spherical"
name = "end"
a = { body = "beam", at = "end" }
b = { body = "tip", at = "center" }
[analysis]
kind = "modes"
count = 1
damped = true
"#,
    ));
    let (length, young, area, inertia) = (0.2_f64, 1e6, 0.01, 1e-5);
    let [shear, bending] = [length / (0.5 * 0.5 * young * area), length.powi(3) / (3.0 * young * inertia)];
    let omega = (1.0 / (shear + bending)).sqrt();
    let expected = 0.5 * 1e-4 * omega * shear / (shear + bending);
    let found = run.column("damping_ratio")[0];
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} not {expected}");
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

/// Bodies without a support, in any direction: six zero eigenvalues and the frequencies of the undamped analysis. A damper between a
/// node and the ground leaves five, and mass-proportional damping none.
#[test]
fn free_bodies_have_six_zero_eigenvalues() {
    let beam = "materials.s = { density = 7850, young = 2.1e11, poisson = 0.3MORE }\nsections.w = { kind = \"circle\", diameter = 0.01 }\n\
                bodies = [{ kind = \"beam\", name = \"p\", from = [1.0, 2.0, -3.0], to = [0.5056304, 1.3078796, -3.5256946], \
                elements = 5, section = \"w\", material = \"s\" }]\n";
    let shell = "materials.s = { density = 7850, young = 2.1e11, poisson = 0.3MORE }\n\
                 bodies = [{ kind = \"shell\", name = \"p\", surface = { kind = \"flat\", corner = [0, 0, 0], side_u = [0.2, 0.2, 0.1], \
                 side_v = [0.1, -0.1, 0] }, elements = [4, 3], thickness = 0.01, material = \"s\" }]\n";
    for (body, end) in [(beam, "\"end\""), (shell, "[1, 1]")] {
        let modes = |more: &str, joint: &str, damped: bool| {
            let body = body.replace("MORE", more);
            Run::of(&parse(&format!(
                "{body}{joint}[analysis]\nkind = \"modes\"\ncount = 9\ndamped = {damped}\n"
            )))
        };
        let undamped = modes("", "", false).column("frequency").to_vec();
        let free = modes("", "", true);
        assert_eq!(free.column("growth_rate"), [0.0; 9]);
        for (k, (found, expected)) in free.column("frequency").iter().zip(&undamped).enumerate() {
            let is_rigid = k < 6;
            assert!(
                if is_rigid { *found == 0.0 } else { (found / expected - 1.0).abs() < 1e-6 },
                "{k}: {found}"
            );
        }
        let damper = format!(
            "[[joints]]\nkind = \"spring\"\nname = \"d\"\na = {{ body = \"p\", at = {end} }}\nb = {{ point = [3, 4, 5] }}\nstiffness = 0\n\
             damping = 1e-3\n"
        );
        let held = modes("", &damper, true);
        let is_zero = |k: usize| held.column("frequency")[k] == 0.0 && held.column("growth_rate")[k] == 0.0;
        // Five motions without damping, and the double one that becomes λ = 0 and a decay.
        assert_eq!((0..9).filter(|k| is_zero(*k)).count(), 6, "{:?}", held.column("growth_rate"));
        let decays =
            |k: &usize| held.column("frequency")[*k] == 0.0 && held.column("growth_rate")[*k] < -1e-6;
        assert_eq!((0..9).filter(decays).count(), 1, "{:?}", held.column("growth_rate"));
        let slowed = modes(", damping = { mass = 0.5 }", "", true);
        // λ = 0 and λ = −α of six motions.
        let rates = slowed.column("growth_rate");
        assert_eq!(rates.iter().filter(|x| **x == 0.0).count(), 6, "{rates:?}");
        assert!(rates[6..].iter().all(|x| (x + 0.5).abs() < 1e-6), "{rates:?}");
    }
}
