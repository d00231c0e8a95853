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

fn strip_on_foundation() -> Result<Findings, VerificationError> {
    let (young, thickness, stiffness) = (1.2e9_f64, 0.01_f64, 1e6);
    let (pressure, load, transition) = (200.0, 2.0, 1e-6);
    let beta = (stiffness / (young * thickness.powi(3) / 3.0)).powf(0.25);
    let length = 9.0 / beta;
    // Depth below the undeformed strip at which the pressure is in equilibrium.
    let rest = pressure / stiffness + 0.5 * transition;
    let surface =
        format!("kind = \"flat\", corner = [0, 0, 0], side_u = [{length}, 0, 0], side_v = [0, 0.1, 0]");
    let model = |elements: u32| {
        let strip = ShellModel {
            surface: &surface,
            elements: [elements, 1],
            thickness,
            material: [young, 0.0, 1000.0],
        };
        format!(
            "{strip}{}{}{}{}{}[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {}\n\
             [[contacts]]\nwith = {{ kind = \"plane\", point = [0, 0, {}], normal = [0, 0, 1] }}\n\
             surface_stiffness = {stiffness:e}\ntransition = {transition:e}\n[analysis]\nkind = \"statics\"\n",
            edge("u_start", "\"symmetry\""),
            edge("u_end", "\"clamped\""),
            edge_load("edge_force", "u_start", "force", [0.0, 0.0, -0.5 * load]),
            probe("load", [0.0, 0.5]),
            probe("beside", [1.0 / 9.0, 0.5]),
            -pressure,
            rest - 0.5 * thickness,
        )
    };
    let exact = |x: f64| -load * beta / (2.0 * stiffness) * (-x).exp() * (x.cos() + x.sin());
    Refinement::new("elements", &[12, 24], model)
        .last("deflection at the load, m", "load.z", exact(0.0), 1e-4)
        .order(4.0)
        .last("deflection at 1/β, m", "beside.z", exact(1.0), 1e-4)
        .scaled(exact(0.0))
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
