//! Small deflections of straight beams.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::reference::integral;
use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(in crate::problems) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "propped_cantilever",
        title: "Propped cantilever under a uniform load",
        source: "Linear beam: 3qL/8 at the prop, moment qL²/8 at the clamp",
        sketch: r"
    |/|================    L = 2 m, q = 1e-3 N/m
       v v v v v v v v o",
        goal: "Reactions of the statically indeterminate beam within 1e-4, which is the shear, on any mesh",
        run: propped,
    },
    Problem {
        name: "fixed_beam",
        title: "Beam with two clamps under an eccentric force",
        source: "Linear beam: moments P a b²/L² and P a² b/L²",
        sketch: r"
             | P
    |/|======v==========|/|    L = 2 m, a = 0.5 m",
        goal: "Moments of both clamps within 1e-4, which is the shear",
        run: fixed,
    },
    Problem {
        name: "two_spans",
        title: "Continuous beam of two spans under a uniform load",
        source: "Linear beam: 5qL/8 of the whole load qL on the middle support, 3qL/16 on the outer ones",
        sketch: r"
      ==================    L = 2 m
      o        o        o",
        goal: "Reactions within 1e-4, which is the shear",
        run: two_spans,
    },
    Problem {
        name: "triangular_load",
        title: "Cantilever under a load that increases towards its tip",
        source: "Linear beam: 11 q L⁴/120EI + q L²/3GA",
        sketch: r"
    |/|================    from 0 at the clamp to q at the tip
             . . v v V",
        goal: "Deflection of the tip, exact on any mesh, within 1e-6",
        run: triangular,
    },
    Problem {
        name: "distributed_torque",
        title: "Shaft under a distributed torque",
        source: "t L²/2GJ, St. Venant's J of a square by its series",
        sketch: r"
    |/|================    20 × 20 mm, ν = 0.3, t = 1e-2 N
        ) ) ) ) ) ) )",
        goal: "Twist of the end, within 1e-5",
        run: torque,
    },
    Problem {
        name: "tapered_cantilever",
        title: "Tapered cantilever under a force at its tip",
        source: "P ∫ (L − x)²/EI(x) dx + P ∫ dx/kGA(x), by quadrature",
        sketch: r"
    |/|====______
    |/|====------          width from 20 mm to 5 mm, height 10 mm",
        goal: "Deflection with 8 elements within 1e-3. Fourth order",
        run: tapered,
    },
    Problem {
        name: "twisted_beam",
        title: "Twisted beam of MacNeal and Harder",
        source: "MacNeal & Harder (1985): 5.424e-3 and 1.754e-3; thin rod P ∫ (L − x)² (cos²φ/EI₁ + sin²φ/EI₂) dx",
        sketch: r"
    |/|=====  twisted by 90°    L = 12, 1.1 × 0.32, E = 29e6, ν = 0.22",
        goal: "Both deflections within 2 % of the published numbers, and within 1e-3 of the rod. Fourth order",
        run: twisted,
    },
    Problem {
        name: "portal_frame",
        title: "Portal frame under a lateral force",
        source: "Kleinlogel (1914): moment of a foot H h (3k + 1)/(2 (6k + 1)), k = h/l for equal sections",
        sketch: r"
     H ->+========+
         ||      ||    h = 1 m, l = 1.5 m, d = 2 mm
        -++-    -++-",
        goal: "Moments of both feet within 1e-4, which is the extension, with one linked element per leg",
        run: portal_frame,
    },
];

/// Slender round beam of two metres along x: EI = 49.087 N m².
const BEAM: &str = r#"
    materials.m = { density = 1000, young = 1e11 }
    sections.s = { kind = "circle", diameter = 0.01 }
    bodies = [{ kind = "beam", name = "beam", from = [0, 0, 0], to = [2, 0, 0], elements = ELEMENTS, section = "s", material = "m" }]
    analysis = { kind = "statics", stop = { rule = "energy", tolerance = 1e-10 } }
"#;
const CLAMP: &str = r#"{ kind = "clamp", name = "root", a = { body = "beam", at = "start" } },"#;
const PROP: &str =
    r#"{ kind = "point_on_line", name = "prop", a = { body = "beam", at = "end" }, axis = [1, 0, 0] },"#;
const UNIFORM: &str = r#"{ kind = "distributed_force", body = "beam", force = [0, -1e-3, 0] }"#;

/// Returns the model with joints, loads and a probe at the end.
fn beam(joints: &str, loads: &str) -> String {
    let probe = r#"probes = [{ name = "tip", on = { body = "beam", at = "end" } }]"#;
    format!("joints = [{joints}]\nloads = [{loads}]\n{probe}\n{BEAM}")
}

fn propped() -> Result<Findings, VerificationError> {
    let model = beam(&format!("{CLAMP}{PROP}"), UNIFORM);
    Refinement::elements(&model, &[2, 4, 8])
        .last("force of the prop, N", "prop.fy", 0.75e-3, 1e-4)
        .last("force of the clamp, N", "root.fy", 1.25e-3, 1e-4)
        .last("moment of the clamp, N m", "root.mz", 0.5e-3, 1e-4)
        .run()
}

fn fixed() -> Result<Findings, VerificationError> {
    let far = r#"{ kind = "clamp", name = "far", a = { body = "beam", at = "end" } },"#;
    let force = r#"{ kind = "force", on = { body = "beam", at = 0.5 }, force = [0, -1e-3, 0] }"#;
    let model = beam(&format!("{CLAMP}{far}"), force);
    let (near, away) = (1e-3 * 0.5 * 2.25 / 4.0, 1e-3 * 0.25 * 1.5 / 4.0);
    Refinement::elements(&model, &[4, 8])
        .last("moment near the force, N m", "root.mz", near, 1e-4)
        .last("moment away from the force, N m", "far.mz", -away, 1e-4)
        .run()
}

fn two_spans() -> Result<Findings, VerificationError> {
    let left =
        r#"{ kind = "revolute", name = "left", a = { body = "beam", at = "start" }, axis = [0, 0, 1] },"#;
    let middle =
        r#"{ kind = "point_on_line", name = "middle", a = { body = "beam", at = 1.0 }, axis = [1, 0, 0] },"#;
    let model = beam(&format!("{left}{middle}{PROP}"), UNIFORM);
    Refinement::elements(&model, &[2, 4, 8])
        .last("force of the middle, N", "middle.fy", 1.25e-3, 1e-4)
        .last("force of the end, N", "prop.fy", 0.375e-3, 1e-4)
        .run()
}

fn triangular() -> Result<Findings, VerificationError> {
    let load =
        r#"{ kind = "distributed_force", body = "beam", force = [0, 0, 0], force_end = [0, -1e-3, 0] }"#;
    let (bending, shear) = (1e11 * PI * 1e-8 / 64.0, 6.0 / 7.0 * 0.5e11 * PI * 0.25e-4);
    let deflection = 1e-3 * (11.0 * 16.0 / (120.0 * bending) + 4.0 / (3.0 * shear));
    Refinement::elements(&beam(CLAMP, load), &[1, 2, 4])
        .last("deflection of the tip, m", "tip.y", -deflection, 1e-6)
        .last("moment of the clamp, N m", "root.mz", 1e-3 * 4.0 / 3.0, 1e-6)
        .run()
}

fn torque() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e11, poisson = 0.3 }
        sections.s = { kind = "rectangle", height = 0.02, width = 0.02 }
        bodies = [{ kind = "beam", name = "beam", from = [0, 0, 0], to = [2, 0, 0], elements = ELEMENTS, section = "s", material = "m" }]
        joints = [{ kind = "clamp", name = "root", a = { body = "beam", at = "start" } }]
        loads = [{ kind = "distributed_moment", body = "beam", moment = [1e-2, 0, 0] }]
        probes = [{ name = "p", on = { body = "beam", at = "end" }, offset = [1e-2, 0] }]
        analysis = { kind = "statics", stop = { rule = "energy", tolerance = 1e-10 } }
    "#;
    let term = |k: u32| {
        let n = f64::from(2 * k + 1);
        (0.5 * n * PI).tanh() / n.powi(5)
    };
    let constant = 0.02f64.powi(4) / 3.0 * (1.0 - 192.0 / PI.powi(5) * (0..20).map(term).sum::<f64>());
    let angle = 1e-2 * 4.0 / (2.0 * 1e11 / 2.6 * constant);
    Refinement::elements(MODEL, &[2, 4, 8])
        .value("twist of the end, rad", |s| Ok(s.last("p.z")? / 1e-2), angle, 1e-5)
        .run()
}

fn tapered() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e11 }
        sections.root = { kind = "rectangle", height = 0.01, width = 0.02 }
        sections.tip = { kind = "rectangle", height = 0.01, width = 0.005 }
        bodies = [{ kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "root", section_end = "tip", material = "m" }]
        joints = [{ kind = "clamp", name = "root", a = { body = "beam", at = "start" } }]
        loads = [{ kind = "force", on = { body = "beam", at = "end" }, force = [0, -1e-3, 0] }]
        probes = [{ name = "tip", on = { body = "beam", at = "end" } }]
        analysis = { kind = "statics", stop = { rule = "energy", tolerance = 1e-10 } }
    "#;
    let width = |x: f64| 0.02 - 0.015 * x;
    let bending = |x: f64| (1.0 - x).powi(2) / (1e11 * width(x) * 1e-6 / 12.0);
    let shear = |x: f64| 1.0 / (5.0 / 6.0 * 0.5e11 * width(x) * 0.01);
    let deflection = 1e-3 * integral(|x| bending(x) + shear(x), 0.0, 1.0);
    Refinement::elements(MODEL, &[2, 4, 8]).last("deflection, m", "tip.y", -deflection, 1e-3).order(4.0).run()
}

fn twisted() -> Result<Findings, VerificationError> {
    let model = |force: &'static str| {
        format!(
            r#"
            materials.m = {{ density = 1, young = 29e6, poisson = 0.22 }}
            sections.s = {{ kind = "rectangle", height = 1.1, width = 0.32 }}
            bodies = [{{ kind = "beam", name = "beam", from = [0, 0, 0], to = [12, 0, 0], elements = ELEMENTS, section = "s", material = "m", up = [0, 0, 1], twist = {FRAC_PI_2:?} }}]
            joints = [{{ kind = "clamp", name = "root", a = {{ body = "beam", at = "start" }} }}]
            loads = [{{ kind = "force", on = {{ body = "beam", at = "end" }}, force = {force} }}]
            probes = [{{ name = "tip", on = {{ body = "beam", at = "end" }} }}]
            analysis = {{ kind = "statics", stop = {{ rule = "energy", tolerance = 1e-10 }} }}
            "#
        )
    };
    // The long side of the root section is along z, that of the tip section along y.
    let (stiff, soft) = (29e6 * 0.32 * 1.1f64.powi(3) / 12.0, 29e6 * 1.1 * 0.32f64.powi(3) / 12.0);
    let factor = 10.0 * 1.22 / (12.0 + 11.0 * 0.22);
    let shear = 12.0 / (factor * 29e6 / 2.44 * 1.1 * 0.32);
    let deflection = |root: f64, tip: f64| {
        let along = |x: f64| {
            let (sin, cos) = (FRAC_PI_2 * x / 12.0).sin_cos();
            (12.0 - x).powi(2) * (cos * cos / root + sin * sin / tip)
        };
        integral(along, 0.0, 12.0) + shear
    };
    let along_z = model("[0, 0, 1e-3]");
    let flat = Refinement::elements(&along_z, &[8, 16, 32])
        .last("deflection along z at 1e-3", "tip.z", 1e-3 * deflection(stiff, soft), 1e-3)
        .order(4.0)
        .last("deflection along z at 1e-3, published", "tip.z", 1.754e-6, 2e-2)
        .run()?;
    let along_y = model("[0, 1e-3, 0]");
    let mut findings = Refinement::elements(&along_y, &[8, 16, 32])
        .last("deflection along y at 1e-3", "tip.y", 1e-3 * deflection(soft, stiff), 1e-3)
        .order(4.0)
        .last("deflection along y at 1e-3, published", "tip.y", 5.424e-6, 2e-2)
        .run()?;
    findings.comparisons.extend(flat.comparisons);
    Ok(findings)
}

fn portal_frame() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e11 }
        sections.s = { kind = "circle", diameter = 2e-3 }
        bodies = [
          { kind = "beam", name = "left", from = [0, 0, 0], to = [0, 1, 0], elements = 1, section = "s", material = "m", up = [1, 0, 0] },
          { kind = "beam", name = "beam", from = [0, 1, 0], to = [1.5, 1, 0], elements = 1, section = "s", material = "m" },
          { kind = "beam", name = "right", from = [1.5, 0, 0], to = [1.5, 1, 0], elements = 1, section = "s", material = "m", up = [1, 0, 0] },
        ]
        joints = [
          { kind = "clamp", name = "first", a = { body = "left", at = "start" } },
          { kind = "clamp", name = "second", a = { body = "right", at = "start" } },
          { kind = "clamp", name = "corner", a = { body = "beam", at = "start" }, b = { body = "left", at = "end" } },
          { kind = "clamp", name = "other corner", a = { body = "beam", at = "end" }, b = { body = "right", at = "end" } },
        ]
        loads = [{ kind = "force", on = { body = "left", at = "end" }, force = [1e-6, 0, 0] }]
        analysis = { kind = "statics", stop = { rule = "energy", tolerance = 1e-10 } }
    "#;
    let ratio = 1.0 / 1.5;
    let moment = 0.5e-6 * (3.0 * ratio + 1.0) / (6.0 * ratio + 1.0);
    Refinement::single(MODEL.to_owned())
        .last("moment of the left foot, N m", "first.mz", moment, 1e-4)
        .last("moment of the right foot, N m", "second.mz", moment, 1e-4)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
