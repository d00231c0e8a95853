//! Curved and bent beams: arc, ring, helix, follower force.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::reference::runge_kutta;
use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(in crate::problems) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "quarter_arc",
        title: "Quarter of a circle, loaded out of its plane",
        source: "Timoshenko: P R³ (π/4EI + (3π/4 − 2)/GJ) + P R π/2kGA",
        sketch: r"
    |/|====-._
              '.        R = 1 m, d = 20 mm, ν = 0.3
                x P",
        goal: "Deflection of the tip with 32 elements within 1e-3. Second order",
        run: quarter_arc,
    },
    Problem {
        name: "pinched_ring",
        title: "Thin ring, loaded by two opposite forces",
        source: "Timoshenko: P R³/EI (π/4 − 2/π), a quarter with symmetric supports: joints `prismatic`",
        sketch: r"
          | P
        .-v-.
       (     )     R = 1 m, R/d = 1000
        '-^-'
          | P",
        goal: "Approach of the forces with 32 elements in a quarter within 1e-3. Second order",
        run: pinched_ring,
    },
    Problem {
        name: "helical_spring",
        title: "Helical spring under an axial force",
        source: "Rod: P R² l (cos²α/GJ + sin²α/EI) + P l (cos²α/kGA + sin²α/EA), the force on the axis",
        sketch: r"
       (   )
       (   ) | P    R = 0.5 m, two turns, height 0.4 m, d = 20 mm, ν = 0.3
       (   )",
        goal: "Elongation with 128 elements within 1e-2. Second order",
        run: helical_spring,
    },
    Problem {
        name: "follower_elastica",
        title: "Cantilever under a transverse follower force",
        source: "Elastica from its tip, where the force has a given direction, by a Runge-Kutta integration",
        sketch: r"
                     _/ ^ P follows the tip
    |/|=========---''       P L²/EI = 3, L/d = 1000",
        goal: "Tip with 32 elements within 1e-3 of the length. Second order",
        run: follower_elastica,
    },
];

/// Young's modulus and diameter of the arc and the helix.
const YOUNG: f64 = 2e11;
const DIAMETER: f64 = 0.02;

/// Returns EI, GJ, EA and kGA for ν = 0.3.
fn stiffness() -> [f64; 4] {
    let (area, second) = (PI * DIAMETER.powi(2) / 4.0, PI * DIAMETER.powi(4) / 64.0);
    let shear = YOUNG / 2.6;
    [YOUNG * second, shear * 2.0 * second, YOUNG * area, 7.8 / 8.8 * shear * area]
}

fn quarter_arc() -> Result<Findings, VerificationError> {
    let middle = FRAC_PI_4.sin();
    let model = format!(
        r#"
        materials.m = {{ density = 1000, young = 2e11, poisson = 0.3 }}
        sections.s = {{ kind = "circle", diameter = 0.02 }}
        bodies = [{{ kind = "beam", name = "arc", from = [0, 1, 0], to = [1, 0, 0], shape = {{ kind = "arc", through = [{middle:?}, {middle:?}, 0] }}, up = [0, 0, 1], elements = ELEMENTS, section = "s", material = "m" }}]
        joints = [{{ kind = "clamp", name = "root", a = {{ body = "arc", at = "start" }} }}]
        loads = [{{ kind = "force", on = {{ body = "arc", at = "end" }}, force = [0, 0, 1e-3] }}]
        probes = [{{ name = "tip", on = {{ body = "arc", at = "end" }} }}]
        analysis = {{ kind = "statics", stop = {{ rule = "energy", tolerance = 1e-10 }} }}
        "#
    );
    let [bending, torsion, _, shear] = stiffness();
    let deflection = 1e-3 * (FRAC_PI_4 / bending + (0.75 * PI - 2.0) / torsion + FRAC_PI_2 / shear);
    Refinement::elements(&model, &[8, 16, 32])
        .last("deflection, m", "tip.z", deflection, 1e-3)
        .order(2.0)
        .run()
}

fn pinched_ring() -> Result<Findings, VerificationError> {
    let middle = FRAC_PI_4.sin();
    let model = format!(
        r#"
        materials.m = {{ density = 1000, young = 2e11 }}
        sections.s = {{ kind = "circle", diameter = 1e-3 }}
        bodies = [{{ kind = "beam", name = "arc", from = [0, 1, 0], to = [1, 0, 0], shape = {{ kind = "arc", through = [{middle:?}, {middle:?}, 0] }}, up = [0, 0, 1], elements = ELEMENTS, section = "s", material = "m" }}]
        joints = [
          {{ kind = "prismatic", name = "top", a = {{ body = "arc", at = "start" }}, axis = [0, 1, 0] }},
          {{ kind = "prismatic", name = "side", a = {{ body = "arc", at = "end" }}, axis = [1, 0, 0] }},
        ]
        loads = [{{ kind = "force", on = {{ body = "arc", at = "start" }}, force = [0, -1e-6, 0] }}]
        analysis = {{ kind = "statics", stop = {{ rule = "energy", tolerance = 1e-10 }} }}
        "#
    );
    let bending = 2e11 * PI * 1e-12 / 64.0;
    Refinement::elements(&model, &[8, 16, 32])
        .last(
            "displacement of a force, m",
            "top.displacement",
            -1e-6 / bending * (FRAC_PI_4 - 2.0 / PI),
            1e-3,
        )
        .order(2.0)
        .last("displacement of the side, m", "side.displacement", 1e-6 / bending * (2.0 / PI - 0.5), 1e-3)
        .order(2.0)
        .run()
}

fn helical_spring() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 2e11, poisson = 0.3 }
        sections.s = { kind = "circle", diameter = 0.02 }
        bodies = [{ kind = "beam", name = "spring", from = [0.5, 0, 0], to = [0.5, 0, 0.4], shape = { kind = "helix", center = [0, 0, 0], axis = [0, 0, 1], turns = 2 }, up = [0, 0, 1], elements = ELEMENTS, section = "s", material = "m" }]
        joints = [{ kind = "clamp", name = "root", a = { body = "spring", at = "start" } }]
        loads = [{ kind = "force", on = { body = "spring", at = "end", offset = [-0.5, 0, 0] }, force = [0, 0, 1e-3] }]
        probes = [{ name = "eye", on = { body = "spring", at = "end", offset = [-0.5, 0, 0] } }]
        analysis = { kind = "statics", stop = { rule = "energy", tolerance = 1e-10 } }
    "#;
    let around = 2.0 * PI;
    let length = around.hypot(0.4);
    let (sin, cos) = (0.4 / length, around / length);
    let [bending, torsion, tension, shear] = stiffness();
    let couples = 0.25 * (cos * cos / torsion + sin * sin / bending);
    let elongation = 1e-3 * length * (couples + cos * cos / shear + sin * sin / tension);
    Refinement::elements(MODEL, &[32, 64, 128])
        .value("elongation, m", |s| Ok(s.last("eye.z")? - 0.4), elongation, 1e-2)
        .order(2.0)
        .run()
}

fn follower_elastica() -> Result<Findings, VerificationError> {
    let bending = 2e11 * PI * 1e-12 / 64.0;
    let model = format!(
        r#"
        materials.m = {{ density = 1000, young = 2e11 }}
        sections.s = {{ kind = "circle", diameter = 1e-3 }}
        bodies = [{{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "s", material = "m" }}]
        joints = [{{ kind = "clamp", name = "root", a = {{ body = "rod", at = "start" }} }}]
        loads = [{{ kind = "force", on = {{ body = "rod", at = "end" }}, force = [0, {:?}, 0], follower = true }}]
        probes = [{{ name = "tip", on = {{ body = "rod", at = "end" }} }}]
        analysis = {{ kind = "statics", first = 0.25 }}
        "#,
        3.0 * bending
    );
    // Rotation relative to the tip, and distance from the tip along its tangent and normal.
    let rates = |_: f64, y: &[f64; 3]| [3.0 * y[1], y[0].cos(), y[0].sin()];
    let [angle, along, across] = runge_kutta(rates, [0.0; 3], 1.0, 2000);
    let (sin, cos) = angle.sin_cos();
    let exact = [cos * along + sin * across, sin * along - cos * across];
    let error = move |s: &SolvedModel| Ok((s.last("tip.x")? - exact[0]).hypot(s.last("tip.y")? - exact[1]));
    Refinement::elements(&model, &[8, 16, 32])
        .value("distance of the tip from the elastica, m", error, 0.0, 1e-3)
        .scaled(1.0)
        .order(2.0)
        .last("y of the tip, m", "tip.y", exact[1], 1e-3)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
