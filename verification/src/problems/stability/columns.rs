//! Critical loads of columns and strips.

use std::f64::consts::PI;

use crate::reference::{root, runge_kutta};
use crate::{Findings, Plot, PlotCurve, Problem, Refinement, VerificationError, solve};

/// Problems of this file.
pub(in crate::problems) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "column_pinned",
        title: "Buckling of a column with two hinges",
        source: "Euler (1744): π² EI/L²",
        sketch: r"
      o================o <- P    L = 1 m, L/d = 10 000",
        goal: "Critical load within 1e-4 with 8 elements. Fourth order",
        run: || column(HINGE, LINE, PI * PI),
    },
    Problem {
        name: "column_propped",
        title: "Buckling of a column with a clamp and a hinge",
        source: "Euler: x² EI/L² with tan x = x, 20.1907 EI/L²",
        sketch: r"
    |/|================o <- P    L = 1 m, L/d = 10 000",
        goal: "Critical load within 1e-4 with 8 elements. Fourth order",
        run: || column(CLAMP, LINE, root(|x| x.sin() - x * x.cos(), 4.0, 4.6).powi(2)),
    },
    Problem {
        name: "column_clamped",
        title: "Buckling of a column with two clamps",
        source: "Euler: 4π² EI/L²",
        sketch: r"
    |/|================|/| <- P   L = 1 m, L/d = 10 000, the right clamp slides",
        goal: "Critical load within 1e-3 with 8 elements. Fourth order",
        run: || column(CLAMP, SLIDER, 4.0 * PI * PI),
    },
    Problem {
        name: "heavy_column",
        title: "Buckling of a column under its own weight",
        source: "Greenhill (1881): q L³/EI = 7.8373, by a Runge-Kutta integration of EI θ'' + q s θ = 0",
        sketch: r"
      |
      |  g |    L = 1 m, L/d = 10 000
      |
     ---",
        goal: "Critical weight within 1e-3 with 16 elements. Fourth order",
        run: heavy_column,
    },
    Problem {
        name: "becks_column",
        title: "Flutter of a column under a follower force",
        source: "Beck (1952): P = 20.05 EI/L²",
        sketch: r"
    |/|================ <- P follows the tip",
        goal: "Load at which the two lowest frequencies meet, by bisection of loads, within 2e-3 with 16 elements",
        run: becks_column,
    },
    Problem {
        name: "ziegler_pendulum",
        title: "Flutter of Ziegler's double pendulum under a follower force",
        source: "Ziegler (1952), Herrmann & Bungay (1964): P = (7/2 − √2) k/l for the masses 2m and m",
        sketch: r"
      ~o=======~O=======O <- P follows the tip     l = 1 m, k = 10 N m/rad
       k       k 2m     m",
        goal: "Load at which both frequencies meet, by bisection of loads, within 1e-4",
        run: ziegler_pendulum,
    },
    Problem {
        name: "lateral_uniform",
        title: "Lateral buckling of a cantilever strip under a uniform load",
        source: "Prandtl (1899): q L³ = 12.8538 √(EI GJ)",
        sketch: r"
  |/|===========================   L = 1 m, 10 × 1 mm on edge, E = 71.7 GPa, ν = .31
  |/| | | | | | | | | | | | | | q",
        goal: "Critical load within 1e-3 with 64 elements. Second order",
        run: || strip("", UNIFORM, 12.853_763_321_383_32),
    },
    Problem {
        name: "lateral_middle",
        title: "Lateral buckling of a simply supported strip under a force in the middle",
        source: "Timoshenko & Gere (1961): P L² = 16.9361 √(EI GJ), ends without torsion",
        sketch: r"
                | P
                v
      +==================+   L = 1 m, 10 × 1 mm on edge, E = 71.7 GPa, ν = .31
      ^                  ^",
        goal: "Critical load within 1e-3 with 64 elements. Second order. Joints `universal` to the ground at both ends",
        run: || strip(FORKS, MIDDLE, 16.936_132_150_465_91),
    },
];

const HINGE: &str =
    r#"{ kind = "revolute", name = "left", a = { body = "rod", at = "start" }, axis = [0, 0, 1] },"#;
const CLAMP: &str = r#"{ kind = "clamp", name = "left", a = { body = "rod", at = "start" } },"#;
const LINE: &str =
    r#"{ kind = "point_on_line", name = "right", a = { body = "rod", at = "end" }, axis = [1, 0, 0] },"#;
const SLIDER: &str =
    r#"{ kind = "prismatic", name = "right", a = { body = "rod", at = "end" }, axis = [1, 0, 0] },"#;
const UNIFORM: &str = r#"{ kind = "distributed_force", body = "rod", force = [0, -1, 0] }"#;
const MIDDLE: &str = r#"{ kind = "force", on = { body = "rod", at = 0.5 }, force = [0, -1, 0] }"#;
const FORKS: &str = r#"
    { kind = "universal", name = "left", a = { body = "rod", at = "start" }, axis_a = [0, 0, 1], axis_b = [0, 1, 0] },
    { kind = "universal", name = "right", a = { body = "rod", at = "end" }, axis_a = [0, 0, 1], axis_b = [0, 1, 0] },
"#;

/// Bending stiffness of the columns: E = 210 GPa, d = 0.1 mm.
const BENDING: f64 = 210e9 * PI * 1e-16 / 64.0;

/// Column of one metre along x.
const COLUMN: &str = r#"
    materials.steel = { density = 7850, young = 210e9 }
    sections.round = { kind = "circle", diameter = 1e-4 }
    bodies = [{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "round", material = "steel" }]
"#;

fn column(left: &str, right: &str, factor: f64) -> Result<Findings, VerificationError> {
    let model = format!(
        r#"{COLUMN}
        joints = [{left} {right}]
        loads = [{{ kind = "force", on = {{ body = "rod", at = "end" }}, force = [{:?}, 0, 0] }}]
        analysis = {{ kind = "buckling" }}
        "#,
        -BENDING
    );
    Refinement::elements(&model, &[2, 4, 8])
        .last("critical load, EI/L²", "factor", factor, if factor > 30.0 { 1e-3 } else { 1e-4 })
        .order(4.0)
        .run()
}

fn heavy_column() -> Result<Findings, VerificationError> {
    let line = 7850.0 * PI * 0.25e-8;
    let model = format!(
        r#"{COLUMN}
        gravity = [{:?}, 0, 0]
        joints = [{CLAMP}]
        analysis = {{ kind = "buckling" }}
        "#,
        -BENDING / line
    );
    // From the free end, θ(0) = 1, θ'(0) = 0; the clamp has θ(1) = 0.
    let end = |q: f64| runge_kutta(|s, y: &[f64; 2]| [y[1], -q * s * y[0]], [1.0, 0.0], 1.0, 2000)[0];
    Refinement::elements(&model, &[4, 8, 16])
        .last("critical weight, q L³/EI", "factor", root(end, 5.0, 10.0), 1e-3)
        .order(4.0)
        .run()
}

/// Returns the load between `low` and `high` beyond which frequencies are complex, by bisection.
fn flutter(model: impl Fn(f64) -> String, mut low: f64, mut high: f64) -> Result<f64, VerificationError> {
    for _ in 0..18 {
        let load = 0.5 * (low + high);
        let is_stable = solve(&model(load))?.column("frequency")?.iter().all(|f| f.is_finite());
        if is_stable { low = load } else { high = load }
    }
    Ok(0.5 * (low + high))
}

/// Returns a column of the diameter 1 mm under a follower force in EI/L².
fn follower(elements: u32, load: f64) -> String {
    let model = format!(
        r#"{COLUMN}
        joints = [{CLAMP}]
        loads = [{{ kind = "force", on = {{ body = "rod", at = "end" }}, force = [{:?}, 0, 0], follower = true }}]
        analysis = {{ kind = "modes", count = 4, about = "equilibrium" }}
        "#,
        -load * 1e4 * BENDING
    );
    model.replace("ELEMENTS", &elements.to_string()).replace("diameter = 1e-4", "diameter = 1e-3")
}

fn ziegler_pendulum() -> Result<Findings, VerificationError> {
    let model = |load: f64| {
        format!(
            r#"
            bodies = [
              {{ kind = "rigid", name = "first", center = [1, 0, 0], mass = 2, inertia = [1e-6, 1e-6, 1e-6] }},
              {{ kind = "rigid", name = "second", center = [2, 0, 0], mass = 1, inertia = [1e-6, 1e-6, 1e-6] }},
            ]
            joints = [
              {{ kind = "revolute", name = "foot", a = {{ body = "first", at = [0, 0, 0] }}, axis = [0, 0, 1], spring = {{ stiffness = 10 }} }},
              {{ kind = "revolute", name = "knee", a = {{ body = "second", at = [1, 0, 0] }}, b = {{ body = "first", at = [1, 0, 0] }}, axis = [0, 0, 1], spring = {{ stiffness = 10 }} }},
            ]
            loads = [{{ kind = "force", on = {{ body = "second", at = [2, 0, 0] }}, force = [{:?}, 0, 0], follower = true }}]
            analysis = {{ kind = "modes", count = 2, about = "equilibrium" }}
            "#,
            -load
        )
    };
    let (load, exact) = (flutter(model, 11.0, 30.0)?, 10.0 * (3.5 - 2f64.sqrt()));
    let mut findings = Findings::default();
    findings.compare("flutter load, N", load, exact, exact, 1e-4);
    let mut points = Vec::new();
    for k in 0..=20 {
        let load = 0.05 * f64::from(k) * exact * 0.999;
        points.extend(solve(&model(load))?.column("frequency")?.iter().map(|&f| [load, f]));
    }
    findings.plot(Plot::new(
        "Frequencies against the load",
        ["P, N", "frequency, Hz"],
        vec![PlotCurve::points("both modes", points)],
    ));
    Ok(findings)
}

fn becks_column() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut points = Vec::new();
    for (elements, tolerance) in [(8, 1e-2), (16, 2e-3)] {
        let load = flutter(|load| follower(elements, load), 15.0, 25.0)?;
        findings.compare(
            format!("flutter load, EI/L², {elements} elements"),
            load,
            20.0509,
            20.0509,
            tolerance,
        );
        points.push([f64::from(elements), load]);
    }
    let curves = vec![
        PlotCurve::line("ancf", points),
        PlotCurve::points("Beck", vec![[8.0, 20.0509], [16.0, 20.0509]]),
    ];
    findings.plot(Plot::new("Flutter load", ["elements", "P L²/EI"], curves));
    Ok(findings)
}

fn strip(supports: &str, load: &str, factor: f64) -> Result<Findings, VerificationError> {
    let joints = if supports.is_empty() { CLAMP } else { supports };
    let model = format!(
        r#"
        materials.alloy = {{ density = 2700, young = 71.7e9, poisson = 0.31 }}
        sections.strip = {{ kind = "rectangle", height = 0.01, width = 0.001 }}
        bodies = [{{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "strip", material = "alloy" }}]
        joints = [{joints}]
        loads = [{load}]
        analysis = {{ kind = "buckling" }}
        "#
    );
    let bending = 71.7e9 * 0.01 * 0.001f64.powi(3) / 12.0;
    let torsion = 71.7e9 / 2.62 * 1.952_031_484_506_2e-9 / 625.0;
    let critical = factor * (bending * torsion).sqrt();
    Refinement::elements(&model, &[16, 32, 64])
        .last("critical load, N", "factor", critical, 1e-3)
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
