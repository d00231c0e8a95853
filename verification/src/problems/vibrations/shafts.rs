//! Torsional and axial vibrations, strings and chains.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::reference::root;
use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "shaft_with_disc",
        title: "Torsional vibration of a shaft with a disc",
        source: "β tan β = J_shaft/J_disc, ω = β √(G/ρ)/L",
        sketch: r"
    |/|=================[|]    L = 1 m, d = 20 mm, ν = 0.3, J_disc = 2 J_shaft",
        goal: "First torsional frequency within 1e-3 with 32 elements. Second order",
        run: shaft,
    },
    Problem {
        name: "bar_with_mass",
        title: "Axial vibration of a bar with a mass",
        source: "β tan β = m_bar/m, ω = β √(E/ρ)/L",
        sketch: r"
    |/|=================[ ]    L = 1 m, m = m_bar/2, the mass on a line",
        goal: "First axial frequency within 1e-3 with 32 elements. Fourth order",
        run: bar,
    },
    Problem {
        name: "taut_string",
        title: "Vibrations of a taut string with bending stiffness",
        source: "ω² = (nπ/L)² (T + EI (nπ/L)²)/ρA",
        sketch: r"
      o----------------o--> T    L = 2 m, d = 1 mm, T = 100 N, ρ = 7850 kg/m³",
        goal: "First and third frequency about the loaded equilibrium within 1e-3 with 16 elements. Fourth order",
        run: string,
    },
    Problem {
        name: "hanging_chain",
        title: "Swinging of a hanging chain",
        source: "Bernoulli (1732): ω = ½ j₀ₙ √(g/L), zeros of the Bessel function J₀",
        sketch: r"
      o
      |     L = 3 m, g |
      |",
        goal: "Three frequencies of a cable of small bending stiffness within 2e-3 with 32 elements. Second order",
        run: chain,
    },
];

/// Returns the frequency of number `k`.
fn frequency(k: usize) -> impl Fn(&SolvedModel) -> Result<f64, VerificationError> {
    move |s| {
        let found = s.column("frequency")?.get(k).copied();
        found.ok_or_else(|| VerificationError::Missing(format!("mode {}", k + 1)))
    }
}

fn shaft() -> Result<Findings, VerificationError> {
    let inertia = 7850.0 * PI * 0.02f64.powi(4) / 32.0;
    let model = format!(
        r#"
        materials.steel = {{ density = 7850, young = 210e9, poisson = 0.3 }}
        sections.round = {{ kind = "circle", diameter = 0.02 }}
        bodies = [
          {{ kind = "beam", name = "shaft", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "round", material = "steel" }},
          {{ kind = "rigid", name = "disc", center = [1, 0, 0], mass = 1e-9, inertia = [{:?}, {:?}, {:?}] }},
        ]
        joints = [
          {{ kind = "clamp", name = "root", a = {{ body = "shaft", at = "start" }} }},
          {{ kind = "clamp", name = "hub", a = {{ body = "disc", at = "center" }}, b = {{ body = "shaft", at = "end" }} }},
          {{ kind = "cylindrical", name = "bearing", a = {{ body = "disc", at = "center" }}, axis = [1, 0, 0] }},
        ]
        probes = [{{ name = "rim", on = {{ body = "disc", at = [1, 1, 0] }} }}]
        analysis = {{ kind = "modes", count = 10 }}
        "#,
        2.0 * inertia,
        1.5 * inertia,
        1.5 * inertia
    );
    // The bearing keeps the disc from bending motions: it moves in torsion only, or along the shaft.
    let torsion = |s: &SolvedModel| {
        let (x, y, z) = (s.column("rim.x")?, s.column("rim.y")?, s.column("rim.z")?);
        let size = |i: usize| z[i].abs();
        let first = (0..z.len()).find(|&i| size(i) > 1e3 * x[i].abs().max(y[i].abs()) && size(i) > 0.1);
        let found = first.and_then(|i| s.column("frequency").ok()?.get(i).copied());
        found.ok_or_else(|| VerificationError::Missing("torsional mode".into()))
    };
    let beta = root(|x| x * x.tan() - 0.5, 0.1, FRAC_PI_2 - 1e-9);
    let exact = beta * (210e9 / 2.6 / 7850.0f64).sqrt() / TAU;
    Refinement::elements(&model, &[8, 16, 32]).value("frequency, Hz", torsion, exact, 1e-3).order(2.0).run()
}

fn bar() -> Result<Findings, VerificationError> {
    let mass = 0.5 * 7850.0 * PI * 0.01f64.powi(2);
    let model = format!(
        r#"
        materials.steel = {{ density = 7850, young = 210e9 }}
        sections.round = {{ kind = "circle", diameter = 0.02 }}
        bodies = [
          {{ kind = "beam", name = "bar", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "round", material = "steel" }},
          {{ kind = "mass", name = "block", center = [1, 0, 0], mass = {mass:?} }},
        ]
        joints = [
          {{ kind = "clamp", name = "root", a = {{ body = "bar", at = "start" }} }},
          {{ kind = "spherical", name = "eye", a = {{ body = "block", at = "center" }}, b = {{ body = "bar", at = "end" }} }},
          {{ kind = "point_on_line", name = "line", a = {{ body = "block", at = "center" }}, axis = [1, 0, 0] }},
        ]
        probes = [{{ name = "p", on = {{ body = "block", at = "center" }} }}]
        analysis = {{ kind = "modes", count = 20 }}
        "#
    );
    let axial = |s: &SolvedModel| {
        let first = s.column("p.x")?.iter().position(|x| x.abs() > 0.1);
        let found = first.and_then(|i| s.column("frequency").ok()?.get(i).copied());
        found.ok_or_else(|| VerificationError::Missing("axial mode".into()))
    };
    let beta = root(|x| x * x.tan() - 2.0, 0.1, FRAC_PI_2 - 1e-9);
    let exact = beta * (210e9 / 7850.0f64).sqrt() / TAU;
    Refinement::elements(&model, &[8, 16, 32]).value("frequency, Hz", axial, exact, 1e-3).order(4.0).run()
}

fn string() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.steel = { density = 7850, young = 210e9 }
        sections.wire = { kind = "circle", diameter = 1e-3 }
        bodies = [{ kind = "cable", name = "string", from = [0, 0, 0], to = [2, 0, 0], elements = ELEMENTS, section = "wire", material = "steel" }]
        joints = [
          { kind = "spherical", name = "left", a = { body = "string", at = "start" } },
          { kind = "point_on_line", name = "right", a = { body = "string", at = "end" }, axis = [1, 0, 0] },
        ]
        loads = [{ kind = "force", on = { body = "string", at = "end" }, force = [100, 0, 0] }]
        analysis = { kind = "modes", count = 6, about = "equilibrium" }
    "#;
    let (area, bending) = (PI * 0.25e-6, 210e9 * PI * 1e-12 / 64.0);
    let length = 2.0 * (1.0 + 100.0 / (210e9 * area));
    let exact = |n: f64| {
        let wave = n * PI / length;
        let line = 7850.0 * area * 2.0 / length;
        wave * ((100.0 + bending * wave * wave) / line).sqrt() / TAU
    };
    Refinement::elements(MODEL, &[4, 8, 16])
        .value("first frequency, Hz", frequency(0), exact(1.0), 1e-3)
        .value("third frequency, Hz", frequency(4), exact(3.0), 1e-3)
        .order(4.0)
        .run()
}

fn chain() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        materials.steel = { density = 7850, young = 210e9 }
        sections.wire = { kind = "general", area = 1e-6, iy = 1e-17, iz = 1e-17 }
        bodies = [{ kind = "cable", name = "chain", from = [0, 0, 0], to = [0, 0, -3], elements = ELEMENTS, section = "wire", material = "steel" }]
        joints = [{ kind = "spherical", name = "top", a = { body = "chain", at = "start" } }]
        analysis = { kind = "modes", count = 6, about = "equilibrium" }
    "#;
    let exact = |zero: f64| 0.5 * zero * (9.81 / 3.0f64).sqrt() / TAU;
    Refinement::elements(MODEL, &[8, 16, 32])
        .value("first frequency, Hz", frequency(0), exact(2.404_825_557_695_773), 2e-3)
        .value("second frequency, Hz", frequency(2), exact(5.520_078_110_286_311), 2e-3)
        .value("third frequency, Hz", frequency(4), exact(8.653_727_912_911_013), 2e-3)
        .order(2.0)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
