//! Small oscillations of bodies and point masses, by `modes`.

use std::f64::consts::{PI, TAU};

use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "double_pendulum_modes",
        title: "Small oscillations of a double pendulum of two masses",
        source: "ω² = (g/L) (2 ∓ √2) for equal masses and lengths",
        sketch: r"
      o---
      |  L
      O  g |     L = 0.7 m, rods of constant length
      |
      O",
        goal: "Both frequencies, each in two planes, to 1e-8",
        run: double_pendulum,
    },
    Problem {
        name: "bifilar_pendulum",
        title: "Bifilar suspension of a rod",
        source: "Rotation about the vertical: ω² = m g b²/J L; swinging in the plane: g/L; swinging across: double pendulum",
        sketch: r"
      o         o
      |    L    |     L = 1.2 m, b = 0.4 m, m = 2 kg, J = 0.3 kg m²
      |-b-|-b---|     the rods end h = 0.1 m above the centre, J = 0.05 kg m² about the rod
      ===========     g |",
        goal: "Frequencies of rotation and of swinging, to 1e-7",
        run: bifilar,
    },
    Problem {
        name: "spring_chain",
        title: "Chain of five masses and six springs",
        source: "ω_j = 2 √(k/m) sin(jπ/12), Lagrange",
        sketch: r"
     |~[m]~[m]~[m]~[m]~[m]~|    m = 2 kg, k = 300 N/m",
        goal: "Five frequencies, to 1e-10",
        run: spring_chain,
    },
    Problem {
        name: "hinged_body_modes",
        title: "Physical pendulum with a torsion spring, hanging and standing",
        source: "ω² = (k ± m g l)/(J + m l²) about the equilibrium",
        sketch: r"
      ~o~        k = 30 N m/rad, m = 2 kg, l = 0.5 m, J = 0.2 kg m²
       |
       O   g |",
        goal: "Both frequencies, to 1e-9",
        run: hinged_body,
    },
];

/// Returns the value `k` of the column of frequencies.
fn frequency(k: usize) -> impl Fn(&SolvedModel) -> Result<f64, VerificationError> {
    move |s| {
        let found = s.column("frequency")?.get(k).copied();
        found.ok_or_else(|| VerificationError::Missing(format!("mode {}", k + 1)))
    }
}

fn double_pendulum() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [
          { kind = "mass", name = "upper", center = [0, 0, -0.7], mass = 2 },
          { kind = "mass", name = "lower", center = [0, 0, -1.4], mass = 2 },
        ]
        joints = [
          { kind = "distance", name = "first", a = { body = "upper", at = "center" }, b = { point = [0, 0, 0] } },
          { kind = "distance", name = "second", a = { body = "lower", at = "center" }, b = { body = "upper", at = "center" } },
        ]
        analysis = { kind = "modes", count = 4, about = "equilibrium" }
    "#;
    let exact = |sign: f64| (9.81 / 0.7 * (2.0 + sign * 2f64.sqrt())).sqrt() / TAU;
    Refinement::single(MODEL.to_owned())
        .value("first mode, Hz", frequency(0), exact(-1.0), 1e-8)
        .value("first mode in the other plane, Hz", frequency(1), exact(-1.0), 1e-8)
        .value("second mode, Hz", frequency(2), exact(1.0), 1e-8)
        .value("second mode in the other plane, Hz", frequency(3), exact(1.0), 1e-8)
        .run()
}

fn bifilar() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [{ kind = "rigid", name = "rod", center = [0, 0, -1.3], mass = 2, inertia = [0.05, 0.3, 0.3] }]
        joints = [
          { kind = "distance", name = "left", a = { body = "rod", at = [-0.4, 0, -1.2] }, b = { point = [-0.4, 0, 0] } },
          { kind = "distance", name = "right", a = { body = "rod", at = [0.4, 0, -1.2] }, b = { point = [0.4, 0, 0] } },
        ]
        probes = [{ name = "p", on = { body = "rod", at = [0.4, 0, -1.2] } }]
        analysis = { kind = "modes", count = 4, about = "equilibrium" }
    "#;
    let swing = (9.81 / 1.2f64).sqrt() / TAU;
    let turn = (2.0 * 9.81 * 0.16 / (0.3 * 1.2f64)).sqrt() / TAU;
    // Double pendulum of the rods' plane and the body: M = m [L², L h; L h, h² + J/m], K = m g [L, 0; 0, h].
    let (a, b, c) =
        (1.44 * (0.01 + 0.025) - 0.0144, 9.81 * (1.2 * 0.035 + 0.1 * 1.44), 9.81f64.powi(2) * 0.12);
    let across = |sign: f64| ((b + sign * (b * b - 4.0 * a * c).sqrt()) / (2.0 * a)).sqrt() / TAU;
    Refinement::single(MODEL.to_owned())
        .value("swinging across, Hz", frequency(0), across(-1.0), 1e-7)
        .value("swinging in the plane, Hz", frequency(1), swing, 1e-7)
        .value("rotation about the vertical, Hz", frequency(2), turn, 1e-7)
        .value("swinging across, second mode, Hz", frequency(3), across(1.0), 1e-7)
        .run()
}

fn spring_chain() -> Result<Findings, VerificationError> {
    let mut model = String::from("analysis = { kind = \"modes\", count = 5 }\n");
    for k in 1..=5 {
        model += &format!(
            "[[bodies]]\nkind = \"mass\"\nname = \"m{k}\"\ncenter = [{k}, 0, 0]\nmass = 2\n\
             [[joints]]\nkind = \"point_on_line\"\nname = \"guide{k}\"\na = {{ body = \"m{k}\", at = \"center\" }}\naxis = [1, 0, 0]\n"
        );
    }
    for k in 0..=5 {
        let (a, b) = match k {
            0 => ("m1".to_owned(), "{ point = [0, 0, 0] }".to_owned()),
            5 => ("m5".to_owned(), "{ point = [6, 0, 0] }".to_owned()),
            _ => (format!("m{}", k + 1), format!("{{ body = \"m{k}\", at = \"center\" }}")),
        };
        model += &format!(
            "[[joints]]\nkind = \"spring\"\nname = \"s{k}\"\na = {{ body = \"{a}\", at = \"center\" }}\nb = {b}\nstiffness = 300\n"
        );
    }
    let exact = |j: f64| 2.0 * 150f64.sqrt() * (j * PI / 12.0).sin() / TAU;
    Refinement::single(model)
        .value("mode 1, Hz", frequency(0), exact(1.0), 1e-10)
        .value("mode 2, Hz", frequency(1), exact(2.0), 1e-10)
        .value("mode 3, Hz", frequency(2), exact(3.0), 1e-10)
        .value("mode 4, Hz", frequency(3), exact(4.0), 1e-10)
        .value("mode 5, Hz", frequency(4), exact(5.0), 1e-10)
        .run()
}

fn hinged_body() -> Result<Findings, VerificationError> {
    let model = |gravity: f64| {
        format!(
            r#"
            gravity = [0, {gravity:?}, 0]
            bodies = [{{ kind = "rigid", name = "body", center = [0, -0.5, 0], mass = 2, inertia = [0.2, 0.2, 0.2] }}]
            joints = [{{ kind = "revolute", name = "hinge", a = {{ body = "body", at = [0, 0, 0] }}, axis = [0, 0, 1], spring = {{ stiffness = 30 }} }}]
            analysis = {{ kind = "modes", count = 1, about = "equilibrium" }}
            "#
        )
    };
    let exact = |sign: f64| ((30.0 + sign * 2.0 * 9.81 * 0.5) / 0.7f64).sqrt() / TAU;
    let hanging =
        Refinement::single(model(-9.81)).value("hanging, Hz", frequency(0), exact(1.0), 1e-9).run()?;
    let mut findings =
        Refinement::single(model(9.81)).value("standing, Hz", frequency(0), exact(-1.0), 1e-9).run()?;
    findings.comparisons.extend(hanging.comparisons);
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
