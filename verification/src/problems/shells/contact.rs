//! Plates in contact and in fluids.

use super::models::{ShellModel, edge, edge_load, probe};
use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "strip_on_foundation",
        title: "Long plate strip on a plane, pressed by a line load",
        source: "Hetényi (1946): w = q/k + P β/(2k) exp(−βx) (cos βx + sin βx), β⁴ = k/4D. Contact with a plane is an elastic foundation",
        sketch: r"
           | P
  =========v=========   h = 10 mm, E = 1.2e9, ν = 0, k = 1e6 N/m³
  ///////////////////   q = 200 N/m², P = 2 N/m",
        goal: "Deflection at the load and at x = 1/β, within 1e-4. Fourth order",
        run: strip_on_foundation,
    },
    Problem {
        name: "strip_on_shell",
        title: "Long plate strip on a stiff plate of shear-deformable elements, pressed by a line load",
        source: "Hetényi (1946): w = q/k + P β/(2k) exp(−βx) (cos βx + sin βx), β⁴ = k/4D. The lines of both meshes differ",
        sketch: r"
           | P
  =========v=========   h = 10 mm, E = 1.2e9, ν = 0, k = 1e6 N/m³
  ===================   q = 50 N/m², P = 2 N/m; both with half of k",
        goal: "Deflection at the load and at x = 1/β, within 2e-4",
        run: strip_on_shell,
    },
    Problem {
        name: "sinking_plate",
        title: "Plate that sinks flat: drag, added mass and buoyancy of a shell",
        source: "v = v∞ tanh(t/τ), v∞² = 2 (ρ − ρ_f) h g/(ρ_f C), τ = (ρ h + ρ_f a) v∞/((ρ − ρ_f) h g)",
        sketch: r"
      ==========     h = 10 mm, ρ = 2000, ρ_f = 800 kg/m³
       | v  | g      C = 1.2, a = 20 mm",
        goal: "Velocity up to 0.97 of the terminal velocity. Second order",
        run: sinking_plate,
    },
];

/// Young's modulus and thickness of the strip.
const STRIP: [f64; 2] = [1.2e9, 0.01];
/// Stiffness k of the contact, and the depth of its transition.
const FOUNDATION: [f64; 2] = [1e6, 1e-6];
/// Line load P.
const LOAD: f64 = 2.0;

/// Decay β of the deflection, β⁴ = k/4D.
fn decay() -> f64 {
    let [young, thickness] = STRIP;
    (FOUNDATION[0] / (young * thickness.powi(3) / 3.0)).powf(0.25)
}

/// Length of the strip, from the plane of symmetry under the load.
fn length() -> f64 {
    9.0 / decay()
}

/// Depth below the undeformed strip at which a pressure is in equilibrium.
fn rest(pressure: f64) -> f64 {
    pressure / FOUNDATION[0] + 0.5 * FOUNDATION[1]
}

/// Deflection at βx.
fn deflection(x: f64) -> f64 {
    -LOAD * decay() / (2.0 * FOUNDATION[0]) * (-x).exp() * (x.cos() + x.sin())
}

/// Strip under a pressure and the line load, with the probes `load` and `beside`, in contact with a partner.
fn pressed_strip(elements: u32, pressure: f64, partner: &str) -> String {
    let ([young, thickness], [stiffness, transition]) = (STRIP, FOUNDATION);
    let length = length();
    let surface =
        format!("kind = \"flat\", corner = [0, 0, 0], side_u = [{length}, 0, 0], side_v = [0, 0.1, 0]");
    let strip =
        ShellModel { surface: &surface, elements: [elements, 1], thickness, material: [young, 0.0, 1000.0] };
    format!(
        "{strip}{}{}{}{}{}[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {}\n\
         [[contacts]]\nwith = {{ {partner} }}\nsurface_stiffness = {stiffness:e}\ntransition = {transition:e}\n\
         [analysis]\nkind = \"statics\"\n",
        edge("u_start", "\"symmetry\""),
        edge("u_end", "\"clamped\""),
        edge_load("edge_force", "u_start", "force", [0.0, 0.0, -0.5 * LOAD]),
        probe("load", [0.0, 0.5]),
        probe("beside", [1.0 / 9.0, 0.5]),
        -pressure,
    )
}

fn strip_on_foundation() -> Result<Findings, VerificationError> {
    let pressure = 200.0;
    let height = rest(pressure) - 0.5 * STRIP[1];
    let partner = format!("kind = \"plane\", point = [0, 0, {height}], normal = [0, 0, 1]");
    let model = |elements: u32| pressed_strip(elements, pressure, &partner);
    Refinement::new("elements", &[12, 24], model)
        .last("deflection at the load, m", "load.z", deflection(0.0), 1e-4)
        .order(4.0)
        .last("deflection at 1/β, m", "beside.z", deflection(1.0), 1e-4)
        .scaled(deflection(0.0))
        .run()
}

/// Stiff plate `t` of n × 2 quadrilaterals, 0.1 wide and 0.01 thick, with both ends clamped.
fn stiff_plate(n: usize, length: f64, z: f64) -> String {
    let (columns, mut nodes, mut elements) = (n + 1, Vec::new(), Vec::new());
    for j in 0..3 {
        nodes.extend((0..columns).map(|i| [length * i as f64 / n as f64, 0.05 * f64::from(j), z]));
    }
    for first in (0..n).chain(columns..columns + n) {
        elements.push([first, first + 1, first + 1 + columns, first + columns]);
    }
    let clamp = |name: &str, i: usize| {
        let edge = [i, i + columns, i + 2 * columns];
        let joint = format!(
            "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"t\", at = {{ edge = \"{name}\" }} }}\n\
             condition = \"clamped\"\n"
        );
        (format!("{name} = {{ edges = [{edge:?}] }}"), joint)
    };
    let [(start, of_start), (end, of_end)] = [clamp("start", 0), clamp("end", n)];
    format!(
        "[[bodies]]\nkind = \"shear_shell\"\nname = \"t\"\nthickness = 0.01\nmaterial = \"stiff\"\n\
         mesh = {{ nodes = {nodes:?}, elements = {elements:?}, groups = {{ {start}, {end} }} }}\n{of_start}{of_end}"
    )
}

fn strip_on_shell() -> Result<Findings, VerificationError> {
    let pressure = 50.0;
    let model = |elements: u32| {
        let plate = stiff_plate(elements as usize * 7 / 12, length(), rest(pressure) - STRIP[1]);
        let strip = pressed_strip(elements, pressure, "kind = \"bodies\"");
        format!("materials.stiff = {{ density = 1, young = 1e18, poisson = 0 }}\n{strip}{plate}")
    };
    Refinement::new("elements", &[12, 24], model)
        .last("deflection at the load, m", "load.z", deflection(0.0), 2e-4)
        .last("deflection at 1/β, m", "beside.z", deflection(1.0), 2e-4)
        .scaled(deflection(0.0))
        .run()
}

fn sinking_plate() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        materials.m = { density = 2000, young = 1e9 }
        probes = [{ name = "p", on = { body = "plate", at = [0.5, 0.5] } }]
        loads = [{ kind = "surface_fluid", body = "plate", density = 800, drag = [1.2, 0.02], added_mass = 0.02 }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
        [[bodies]]
        kind = "shell"
        name = "plate"
        surface = { kind = "flat", corner = [0, 0, 0], side_u = [0.4, 0, 0], side_v = [0, 0.3, 0] }
        elements = [2, 2]
        thickness = 0.01
        material = "m"
    "#;
    let weight = 1200.0 * 0.01 * 9.81;
    let terminal = (2.0 * weight / (800.0 * 1.2_f64)).sqrt();
    let time = (2000.0 * 0.01 + 800.0 * 0.02) * terminal / weight;
    Refinement::steps(MODEL, 2.0 * time, &[50, 100])
        .curve("velocity, m/s", ["t", "p.vz"], |t| -terminal * (t / time).tanh(), terminal, 1e-3)
        .order(2.0)
        .run()
}
