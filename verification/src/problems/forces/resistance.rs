//! Damping and fluids.

use std::f64::consts::{PI, TAU};

use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "sinking_rod",
        title: "Rod that sinks: drag, added mass and buoyancy",
        source: "v = v∞ tanh(t/τ), v∞² = 2 (ρ − ρ_f) A g/(ρ_f d C), τ = (ρ + C_a ρ_f) A v∞/((ρ − ρ_f) A g)",
        sketch: r"
      ==========     d = 50 mm, ρ = 3000, ρ_f = 1000 kg/m³
       | v  | g      C = 1.2, C_a = 1",
        goal: "Velocity up to 0.97 of the terminal velocity. Second order",
        run: sinking_rod,
    },
    Problem {
        name: "mass_damping",
        title: "Rod that falls with mass-proportional damping",
        source: "v = (g/α) (1 − exp(−αt))",
        sketch: r"
      ==========     α = 3 1/s
       | v  | g",
        goal: "Velocity over two time constants. Second order",
        run: mass_damping,
    },
    Problem {
        name: "strain_damping",
        title: "Damped axial vibration of a mass on a bar",
        source: "Kelvin-Voigt: ζ = τω/2, ω² = EA/L (m + m_bar/3), step response",
        sketch: r"
    |/|--------------[ m ]--> F     L = 1 m, EA = 1e4 N, m = 10 kg,
                                    m_bar = 1e-4 kg, ζ = 0.1",
        goal: "Displacement after a sudden force over two periods. Second order",
        run: strain_damping,
    },
    Problem {
        name: "submerged_modes",
        title: "Cantilever in water: frequency with added mass",
        source: "Frequencies in proportion to 1/√(1 + C_a ρ_f/ρ) for motion across the axis",
        sketch: r"
    |/|================    ρ = 2000 kg/m³, ρ_f = 1000 kg/m³, C_a = 1",
        goal: "Ratio of the frequencies in water and in air, within 1e-5, which is the rotary inertia",
        run: submerged_modes,
    },
    Problem {
        name: "rod_in_current",
        title: "Cantilever in a current",
        source: "Linear beam under q = ½ ρ_f d C v²: q L⁴/8EI + q L²/2kGA, k = 6/7",
        sketch: r"
    |/|================    d = 50 mm, L = 2 m, C = 1.2, v = 0.05 m/s
        ^   ^   ^   ^",
        goal: "Deflection of the tip, exact on any mesh, within 1e-6",
        run: rod_in_current,
    },
];

fn sinking_rod() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        materials.m = { density = 3000, young = 1e9 }
        sections.s = { kind = "circle", diameter = 0.05 }
        bodies = [{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = "s", material = "m" }]
        loads = [{ kind = "fluid", bodies = ["rod"], density = 1000, drag = [1.2, 0], added_mass = [1, 0] }]
        probes = [{ name = "p", on = { body = "rod", at = 0.5 } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let area = PI * 0.025f64.powi(2);
    let weight = 2000.0 * area * 9.81;
    let terminal = (2.0 * weight / (1000.0 * 0.05 * 1.2)).sqrt();
    let time = 4000.0 * area * terminal / weight;
    Refinement::steps(MODEL, 2.0 * time, &[50, 100])
        .curve("velocity, m/s", ["t", "p.vz"], |t| -terminal * (t / time).tanh(), terminal, 1e-3)
        .order(2.0)
        .run()
}

fn mass_damping() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        materials.m = { density = 3000, young = 1e9, damping = { mass = 3 } }
        sections.s = { kind = "circle", diameter = 0.05 }
        bodies = [{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = "s", material = "m" }]
        probes = [{ name = "p", on = { body = "rod", at = 0.5 } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let law = |t: f64| -9.81 / 3.0 * (1.0 - (-3.0 * t).exp());
    Refinement::steps(MODEL, 2.0 / 3.0, &[50, 100])
        .curve("velocity, m/s", ["t", "p.vz"], law, 3.27, 1e-3)
        .order(2.0)
        .run()
}

fn strain_damping() -> Result<Findings, VerificationError> {
    let omega = (1e4 / (10.0 + 1e-4 / 3.0f64)).sqrt();
    let retardation = 0.2 / omega;
    let model = format!(
        r#"
        materials.m = {{ density = 1, young = 1e8, damping = {{ strain = {retardation:?} }} }}
        sections.s = {{ kind = "general", area = 1e-4, iy = 1e-9, iz = 1e-9 }}
        bodies = [
          {{ kind = "beam", name = "bar", from = [0, 0, 0], to = [1, 0, 0], elements = 1, section = "s", material = "m" }},
          {{ kind = "mass", name = "block", center = [1, 0, 0], mass = 10 }},
        ]
        joints = [
          {{ kind = "clamp", name = "root", a = {{ body = "bar", at = "start" }} }},
          {{ kind = "spherical", name = "eye", a = {{ body = "block", at = "center" }}, b = {{ body = "bar", at = "end" }} }},
        ]
        loads = [{{ kind = "force", on = {{ body = "block", at = "center" }}, force = [0.01, 0, 0] }}]
        probes = [{{ name = "p", on = {{ body = "block", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#
    );
    let (rate, damped) = (0.1 * omega, omega * 0.99f64.sqrt());
    let law = |t: f64| {
        let (sin, cos) = (damped * t).sin_cos();
        1.0 + 1e-6 * (1.0 - (-rate * t).exp() * (cos + rate / damped * sin))
    };
    Refinement::steps(&model, 2.0 * TAU / omega, &[200, 400])
        .curve("position, m", ["t", "p.x"], law, 1e-6, 1e-3)
        .order(2.0)
        .run()
}

fn submerged_modes() -> Result<Findings, VerificationError> {
    let model = |fluid: &str| {
        format!(
            r#"
            materials.m = {{ density = 2000, young = 1e9 }}
            sections.s = {{ kind = "circle", diameter = 1e-3 }}
            bodies = [{{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "s", material = "m" }}]
            joints = [{{ kind = "clamp", name = "root", a = {{ body = "rod", at = "start" }} }}]
            loads = [{fluid}]
            analysis = {{ kind = "modes", count = 4 }}
            "#
        )
    };
    let water = r#"{ kind = "fluid", bodies = ["rod"], density = 1000, drag = [0, 0], added_mass = [1, 0] }"#;
    let air = crate::solve(&model(""))?.column("frequency")?.to_vec();
    let ratio = |k: usize| {
        let air = air[k];
        move |s: &SolvedModel| Ok(s.column("frequency")?[k] / air)
    };
    let exact = 1.0 / 1.5f64.sqrt();
    Refinement::single(model(water))
        .value("ratio of the first frequencies", ratio(0), exact, 1e-5)
        .value("ratio of the second frequencies", ratio(2), exact, 1e-5)
        .run()
}

fn rod_in_current() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e9 }
        sections.s = { kind = "circle", diameter = 0.05 }
        bodies = [{ kind = "beam", name = "rod", from = [0, 0, 0], to = [2, 0, 0], elements = ELEMENTS, section = "s", material = "m" }]
        joints = [{ kind = "clamp", name = "root", a = { body = "rod", at = "start" } }]
        loads = [{ kind = "fluid", bodies = ["rod"], density = 1000, current = [0, 0.05, 0], drag = [1.2, 0] }]
        probes = [{ name = "tip", on = { body = "rod", at = "end" } }]
        analysis = { kind = "statics" }
    "#;
    let load = 0.5 * 1000.0 * 0.05 * 1.2 * 0.0025;
    let (bending, shear) = (1e9 * PI * 0.05f64.powi(4) / 64.0, 6.0 / 7.0 * 0.5e9 * PI * 0.025f64.powi(2));
    let deflection = load * (16.0 / (8.0 * bending) + 4.0 / (2.0 * shear));
    Refinement::elements(MODEL, &[4, 8, 16])
        .last("deflection, m", "tip.y", deflection, 1e-6)
        .last("force of the clamp, N", "root.fy", -2.0 * load, 1e-6)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
