//! Prescribed strains against closed forms.

use std::f64::consts::PI;

use ancf::Model;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// EA = 2e5, EI = 166.7 (square of 0.1), GJ by Saint-Venant.
const YOUNG: f64 = 2e7;
const SIDE: f64 = 0.1;
const INERTIA: f64 = SIDE * SIDE * SIDE * SIDE / 12.0;

/// Beam or cable of length 1 along x with further keys of the model.
fn rod(body: &str, elements: u32, rest: &str) -> Model {
    damped(body, elements, "", rest)
}

fn damped(body: &str, elements: u32, damping: &str, rest: &str) -> Model {
    parse(&format!(
        r#"
{rest}
[materials]
rubber = {{ density = 1000, young = {YOUNG}, poisson = 0.3{damping} }}
[sections]
square = {{ kind = "rectangle", height = {SIDE}, width = {SIDE} }}
[[bodies]]
{body}
name = "rod"
from = [0, 0, 0]
to = [1, 0, 0]
elements = {elements}
section = "square"
material = "rubber"
[[probes]]
name = "tip"
on = {{ body = "rod", at = "end" }}
[[probes]]
name = "middle"
on = {{ body = "rod", at = "center" }}
record = ["motion", "section_forces", "stress"]
"#
    ))
}

const BODIES: [&str; 5] = [
    "kind = \"beam\"\nformulation = \"continuum\"",
    "kind = \"beam\"\nformulation = \"enhanced\"",
    "kind = \"beam\"\nformulation = \"linked\"",
    "kind = \"beam\"\nformulation = \"quadratic\"",
    r#"kind = "cable""#,
];

/// Clamps of sections: the stretch of the axis is free there.
const CLAMPED: &str =
    r#"joints = [{ kind = "clamp", name = "root", a = { body = "rod", at = "start" }, fix = "section" }]"#;
const BOTH: &str = r#"joints = [{ kind = "clamp", name = "root", a = { body = "rod", at = "start" }, fix = "section" }, { kind = "clamp", name = "far", a = { body = "rod", at = "end" }, fix = "section" }]"#;
const STATICS: &str = "analysis = { kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-14 } }";

/// A free end moves by the integral of the strain, without stress.
#[test]
fn a_free_body_takes_the_prescribed_strain() {
    for body in BODIES {
        for (strain, expected) in [("strain = 0.03", 1.03), ("strain = 0.02, strain_end = -0.06", 0.98)] {
            let loads = format!("loads = [{{ kind = \"prestrain\", body = \"rod\", {strain} }}]");
            let run = Run::of(&rod(body, 4, &format!("{loads}\n{CLAMPED}\n{STATICS}")));
            let is_exact = !strain.contains("end") || body.contains("cable");
            // The axis between the nodes is interpolated.
            let tolerance = if is_exact { 1e-10 } else { 1e-4 };
            assert!((run.last("tip.x") - expected).abs() < tolerance, "{body}: {}", run.last("tip.x"));
            if is_exact && !strain.contains("end") {
                assert!(run.last("middle.N").abs() < 1e-7, "{body}: {}", run.last("middle.N"));
                assert!(run.last("middle.sxx").abs() < 1e-5, "{body}: {}", run.last("middle.sxx"));
                assert!(run.last("strain").abs() < 1e-12, "{body}: {}", run.last("strain"));
            }
        }
    }
}

/// A heated body between walls carries −EA ε⁰, and a stretched one its tension. The energy is that of the stress.
#[test]
fn a_held_body_carries_the_stress() {
    let area = SIDE * SIDE;
    for body in BODIES {
        let is_cable = body.contains("cable");
        let strain: f64 = -0.01;
        let own = if is_cable { strain } else { strain + 0.5 * strain * strain };
        for (load, force) in
            [(format!("strain = {strain}"), -YOUNG * area * own), ("tension = 1500".to_owned(), 1500.0)]
        {
            let loads = format!("loads = [{{ kind = \"prestrain\", body = \"rod\", {load} }}]");
            let run = Run::of(&rod(body, 4, &format!("{loads}\n{BOTH}\n{STATICS}")));
            let found = run.last("middle.N");
            // Clamped ends prevent the lateral contraction of the continuum.
            let tolerance = if body.contains("continuum") { 5e-2 } else { 1e-9 };
            assert!((found / force - 1.0).abs() < tolerance, "{body}, {load}: {found}, not {force}");
            let energy = 0.5 * force * force / (YOUNG * area);
            assert!((run.last("strain") / energy - 1.0).abs() < 2.0 * tolerance, "{body}, {load}: energy");
            if !body.contains("continuum") {
                assert!((run.last("middle.sxx") / (force / area) - 1.0).abs() < 1e-9, "{body}: stress");
            }
        }
    }
}

/// A curvature of 2π/L rolls a straight beam up to a circle without stress. The order of convergence is that of the element.
#[test]
fn a_curvature_rolls_a_beam_up_without_stress() {
    for body in &BODIES[1..4] {
        let gaps = [8, 16].map(|elements| {
            let kappa = 2.0 * PI;
            let loads =
                format!("loads = [{{ kind = \"prestrain\", body = \"rod\", curvature = [0, 0, {kappa}] }}]");
            let run = Run::of(&rod(body, elements, &format!("{loads}\n{CLAMPED}\n{STATICS}")));
            let energy = 0.5 * YOUNG * INERTIA * kappa * kappa;
            (run.last("tip.x").hypot(run.last("tip.y")), run.last("strain") / energy)
        });
        let [(coarse, energy), (fine, less)] = gaps;
        assert!(fine < 4e-3 && coarse / fine > 6.0, "{body}: {coarse:e} and {fine:e}");
        assert!(less < 2e-3 && energy / less > 6.0, "{body}: energies {energy:e} and {less:e}");
    }
}

/// A prescribed twist turns the free end, a bending about y moves it along −z.
#[test]
fn twist_and_bending_have_the_axes_of_the_section() {
    let loads = r#"loads = [{ kind = "prestrain", body = "rod", curvature = [0.4, 0, 0] }, { kind = "prestrain", body = "rod", curvature = [0, 1e-3, 2e-3] }]"#;
    let mut model = rod(BODIES[2], 8, &format!("{loads}\n{CLAMPED}\n{STATICS}"));
    model.probes[0].record = vec![ancf::model::Quantity::Motion, ancf::model::Quantity::Rotation];
    let run = Run::of(&model);
    let turn = 2.0 * run.last("tip.e1").atan2(run.last("tip.e0"));
    assert!((turn - 0.4).abs() < 2e-3, "{turn}");
    // The axes of bending turn with the twist: y″ = κ_z cos θ + κ_y sin θ with θ = 0.4 x, to first order of κ.
    let integral =
        |f: &dyn Fn(f64) -> f64| (0..1000).map(|k| f((f64::from(k) + 0.5) * 1e-3) * 1e-3).sum::<f64>();
    let y = integral(&|x| (1.0 - x) * (2e-3 * (0.4 * x).cos() + 1e-3 * (0.4 * x).sin()));
    let z = integral(&|x| (1.0 - x) * (2e-3 * (0.4 * x).sin() - 1e-3 * (0.4 * x).cos()));
    assert!((run.last("tip.y") - y).abs() < 2e-5, "{} not {y}", run.last("tip.y"));
    assert!((run.last("tip.z") - z).abs() < 2e-5, "{} not {z}", run.last("tip.z"));
}

/// Frequencies of a string with a prescribed tension: f_n = n/2 √(T/ρA) for a thin cable, with EI small.
#[test]
fn a_pretensioned_cable_vibrates_as_a_string() {
    let tension = 400.0;
    let text = format!(
        r#"
materials.steel = {{ density = 7800, young = 2e11, poisson = 0.3 }}
sections.wire = {{ kind = "circle", diameter = 0.001 }}
bodies = [{{ kind = "cable", name = "string", from = [0, 0, 0], to = [1, 0, 0], elements = 40, section = "wire", material = "steel" }}]
joints = [{{ kind = "spherical", name = "a", a = {{ body = "string", at = "start" }} }}, {{ kind = "spherical", name = "b", a = {{ body = "string", at = "end" }} }}]
loads = [{{ kind = "prestrain", body = "string", tension = {tension} }}]
[analysis]
kind = "modes"
count = 6
about = "equilibrium"
"#
    );
    let run = Run::of(&parse(&text));
    let (area, inertia) = (PI * 0.0005_f64.powi(2), PI * 0.0005_f64.powi(4) / 4.0);
    let line = 7800.0 * area;
    for (k, found) in run.column("frequency").iter().enumerate() {
        let n = (k / 2 + 1) as f64 * PI;
        let omega = (n * n * tension / line + n.powi(4) * 2e11 * inertia / line).sqrt();
        let expected = omega / (2.0 * PI);
        assert!((found / expected - 1.0).abs() < 1e-5, "mode {}: {found}, not {expected}", k + 1);
    }
}

/// Euler's load of a heated beam between clamps: EA (ε + ½ε²) = 4π² EI/L².
#[test]
fn a_heated_beam_buckles_at_eulers_load() {
    let loads = r#"loads = [{ kind = "prestrain", body = "rod", strain = 1e-4 }]"#;
    let text = |elements| {
        let mut model =
            rod(BODIES[2], elements, &format!("{loads}\n{BOTH}\nanalysis = {{ kind = \"buckling\" }}"));
        let section = model.sections.get_mut("square").unwrap();
        *section = ancf::model::Section::from(ancf::model::Rectangle { height: 0.01, width: 0.02 });
        model
    };
    let run = Run::of(&text(20));
    let euler = 4.0 * PI * PI * 0.01_f64.powi(2) / 12.0;
    let found = run.column("factor")[0] * 1e-4;
    assert!((found / euler - 1.0).abs() < 3e-3, "{found}, not {euler}");
}

/// A rate of the strain does work: the energy balance is closed, with and without damping.
#[test]
fn shrinking_in_time_closes_the_energy_balance() {
    for body in [BODIES[1], BODIES[2], BODIES[3], BODIES[4]] {
        for damping in ["", ", damping = { strain = 0.002, mass = 0.3 }"] {
            let curvature = if body.contains("cable") { "" } else { ", curvature = [0.5, 0.4, 0.8]" };
            let loads = format!(
                "gravity = [0, -9.81, 0]\nloads = [{{ kind = \"prestrain\", body = \"rod\", strain = -0.05{curvature}, time = {{ kind = \"expression\", text = \"sin(30*t)^2\" }} }}]"
            );
            for scheme in ["{ spectral_radius = 0.9 }", "\"energy\""] {
                let text = format!(
                    "{loads}\n{CLAMPED}\nanalysis = {{ kind = \"dynamics\", duration = 0.2, step = 2e-4, scheme = {scheme} }}\n"
                );
                let run = Run::of(&damped(body, 4, damping, &text));
                let largest = |name: &str| run.column(name).iter().fold(0.0_f64, |a, b| a.max(b.abs()));
                let size = largest("kinetic").max(largest("strain"));
                let worst = largest("balance");
                assert!(worst < 2e-3 * size, "{body}{damping}, {scheme}: {worst:e} of {size:e}");
            }
        }
    }
}

/// A heated body at rest in its stress-free equilibrium remains there. Strain energies of elements and prescribed strains cancel: their
/// rounding errors are no energy that the steps make or lose.
#[test]
fn heated_bodies_remain_at_rest() {
    let root = "joints = [{ kind = \"clamp\", name = \"c\", a = { body = \"rod\", at = \"start\" } }]";
    for (body, strain) in [(BODIES[2], 0.01), (BODIES[4], 0.01), (BODIES[2], 1e-4)] {
        let text = format!(
            "loads = [{{ kind = \"prestrain\", body = \"rod\", strain = {strain:?} }}]\n{root}\ninitial = {{ from = \"equilibrium\" }}\n\
             analysis = {{ kind = \"dynamics\", duration = 0.05, step = 1e-3 }}\n"
        );
        let run = Run::of(&rod(body, 5, &text));
        assert!(run.summary.warnings.is_empty(), "{body}, {strain}: {:?}", run.summary.warnings);
    }
}
