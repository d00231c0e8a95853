//! Bending vibrations of slender beams with different supports.

use std::f64::consts::TAU;

use crate::reference::root;
use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "pinned_beam_modes",
        title: "Bending vibrations of a beam with two hinges",
        source: "Euler-Bernoulli beam, βL = nπ",
        sketch: r"
      o=================o     L = 1 m, L/d = 10 000, E = 210 GPa",
        goal: "Three frequencies in the plane of the hinges within 1e-3 with 16 elements, the first within 1e-5. Fourth order",
        run: || beam(PINNED, |x| x.sin()),
    },
    Problem {
        name: "clamped_beam_modes",
        title: "Bending vibrations of a beam with two clamps",
        source: "Euler-Bernoulli beam, cos βL cosh βL = 1",
        sketch: r"
    |/|=================|/|   L = 1 m, L/d = 10 000, E = 210 GPa",
        goal: "Three frequencies within 1e-3 with 16 elements, the first within 1e-5. Fourth order",
        run: || beam(CLAMPED, |x| x.cos() - 1.0 / x.cosh()),
    },
    Problem {
        name: "propped_beam_modes",
        title: "Bending vibrations of a beam with a clamp and a hinge",
        source: "Euler-Bernoulli beam, tan βL = tanh βL",
        sketch: r"
    |/|=================o     L = 1 m, L/d = 10 000, E = 210 GPa",
        goal: "Three frequencies in the plane of the hinge within 1e-3 with 16 elements, the first within 1e-5. Fourth order",
        run: || beam(PROPPED, |x| x.sin() - x.tanh() * x.cos()),
    },
    Problem {
        name: "free_beam_modes",
        title: "Bending vibrations of a free beam",
        source: "Euler-Bernoulli beam, cos βL cosh βL = 1",
        sketch: r"
      ===================     L = 1 m, L/d = 1000, E = 210 GPa",
        goal: "Three frequencies after the rigid modes within 1e-3 with 16 elements, the first within 1e-5. Fourth order",
        run: free_beam,
    },
    Problem {
        name: "beam_with_tip_mass",
        title: "Bending vibration of a cantilever with a mass at its tip",
        source: "Euler-Bernoulli beam: 1 + cos βL cosh βL = μ βL (sin βL cosh βL − cos βL sinh βL), μ = 2",
        sketch: r"
    |/|=================O     L = 1 m, L/d = 10 000, mass 2 ρAL",
        goal: "Three frequencies within 1e-3 with 16 elements, the first within 1e-5. Fourth order",
        run: tip_mass,
    },
];

const PINNED: &str = r#"
    { kind = "revolute", name = "left", a = { body = "rod", at = "start" }, axis = [0, 0, 1] },
    { kind = "revolute", name = "right", a = { body = "rod", at = "end" }, axis = [0, 0, 1] },
"#;
const CLAMPED: &str = r#"
    { kind = "clamp", name = "left", a = { body = "rod", at = "start" } },
    { kind = "clamp", name = "right", a = { body = "rod", at = "end" } },
"#;
const PROPPED: &str = r#"
    { kind = "clamp", name = "left", a = { body = "rod", at = "start" } },
    { kind = "revolute", name = "right", a = { body = "rod", at = "end" }, axis = [0, 0, 1] },
"#;

/// Slender beam. `EXTRA` is a further body, `SUPPORTS` its joints.
const MODEL: &str = r#"
    materials.steel = { density = 7850, young = 210e9 }
    sections.round = { kind = "circle", diameter = 1e-4 }
    bodies = [
      { kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "round", material = "steel" },
      EXTRA
    ]
    joints = [SUPPORTS]
    probes = [{ name = "p", on = { body = "rod", at = 0.2 } }, { name = "q", on = { body = "rod", at = 0.45 } }]
    analysis = { kind = "modes", count = 12 }
"#;

/// Returns the frequency of number `k` that is not zero, of modes in the plane of x and y.
fn in_plane(k: usize) -> impl Fn(&SolvedModel) -> Result<f64, VerificationError> {
    move |s| {
        let column = |name: &str| s.column(name);
        let [py, pz, qy, qz] = ["p.y", "p.z", "q.y", "q.z"].map(column);
        let (py, pz, qy, qz) = (py?, pz?, qy?, qz?);
        let all = column("frequency")?.iter().copied().enumerate().filter(|&(_, f)| f > 0.0);
        let spatial = all.collect::<Vec<_>>();
        // The sections are round: modes of both planes have equal frequencies if the supports are equal in both.
        let lies = |i: usize| py[i].hypot(qy[i]) > pz[i].hypot(qz[i]);
        let plane: Vec<f64> = spatial.iter().filter(|&&(i, _)| lies(i)).map(|&(_, f)| f).collect();
        plane.get(k).copied().ok_or_else(|| VerificationError::Missing(format!("mode {}", k + 1)))
    }
}

/// Returns the frequencies of the three smallest roots βL.
fn exact(characteristic: impl Fn(f64) -> f64) -> [f64; 3] {
    let unit = (210e9 / 7850.0 / 16e8f64).sqrt() / TAU;
    let mut found = Vec::new();
    let mut x = 0.5;
    while found.len() < 3 {
        if characteristic(x) * characteristic(x + 0.1) < 0.0 {
            found.push(root(&characteristic, x, x + 0.1).powi(2) * unit);
        }
        x += 0.1;
    }
    [found[0], found[1], found[2]]
}

/// Beam of a tenth of the slenderness: the rounding error of its free rotation about the axis grows with the slenderness.
fn free_beam() -> Result<Findings, VerificationError> {
    let model =
        MODEL.replace("SUPPORTS", "").replace("EXTRA", "").replace("diameter = 1e-4", "diameter = 1e-3");
    study(&model, exact(|x| x.cos() - 1.0 / x.cosh()).map(|frequency| 10.0 * frequency))
}

fn beam(supports: &str, characteristic: fn(f64) -> f64) -> Result<Findings, VerificationError> {
    study(&MODEL.replace("SUPPORTS", supports).replace("EXTRA", ""), exact(characteristic))
}

fn study(model: &str, [first, second, third]: [f64; 3]) -> Result<Findings, VerificationError> {
    Refinement::elements(model, &[4, 8, 16])
        .value("first frequency, Hz", in_plane(0), first, 1e-5)
        .value("second frequency, Hz", in_plane(1), second, 1e-3)
        .order(4.0)
        .value("third frequency, Hz", in_plane(2), third, 1e-3)
        .order(4.0)
        .run()
}

fn tip_mass() -> Result<Findings, VerificationError> {
    let mass = 2.0 * 7850.0 * 0.25e-8 * std::f64::consts::PI;
    let body = format!("{{ kind = \"mass\", name = \"tip\", center = [1, 0, 0], mass = {mass:?} }},");
    let supports = r#"
        { kind = "clamp", name = "left", a = { body = "rod", at = "start" } },
        { kind = "spherical", name = "eye", a = { body = "tip", at = "center" }, b = { body = "rod", at = "end" } },
    "#;
    let characteristic = |x: f64| 1.0 / x.cosh() + x.cos() - 2.0 * x * (x.sin() - x.cos() * x.tanh());
    study(&MODEL.replace("SUPPORTS", supports).replace("EXTRA", &body), exact(characteristic))
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
