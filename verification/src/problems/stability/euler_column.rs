use std::f64::consts::PI;

use crate::problems::models::{ROD, Rod, cantilever};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Buckling and post-buckling of a column.
pub const PROBLEM: Problem = Problem {
    name: "euler_column",
    title: "Buckling and post-buckling of a cantilever column",
    source: "Euler (1744); Engesser (1889); Reissner (1972): P(1 − P/EA + P/GA) = P_E; the elastica beyond, by \
                 elliptic integrals",
    sketch: r"
  |/|=================== <- P      L = 1 m, d = 20 mm, E = 193 GPa; or inextensible",
    goal: "Linear buckling: a slender column within 1e-4 of Euler; with shear, within 1e-6 of Engesser's P_E/(1 + \
               P_E/GA + P_E/EA), \
           whose last term is due to Green's strain; within 3 P/EA of Reissner's law. Post-buckling: tip within 1e-4 \
           of the elastica, with 32 cable \
           elements and a transverse disturbance of 1e-7 of the load",
    run,
};

/// P/P_E, tip x/L and y/L, at the tip angles 20°, 40°, 60°, 90°, 120°, 140°, 160°, 176°.
const BUCKLED: [(f64, f64, f64); 8] = [
    (1.0153968655397, 0.96973090736352, 0.2194130423956),
    (1.0636632663994, 0.88120351172601, 0.42224034012119),
    (1.1517196204691, 0.74101960607633, 0.59320764616489),
    (1.3932039296857, 0.45694658104446, 0.76275976350181),
    (1.8848008689781, 0.12315997240512, 0.80317099000746),
    (2.5422583695593, -0.10692323755357, 0.75038836608968),
    (4.0300859660499, -0.34031855885115, 0.62460351295335),
    (9.1162182978243, -0.57721110939191, 0.42144229610125),
];

const YOUNG: f64 = 193e9;
/// Euler's load for d = 20 mm, N.
const EULER: f64 = 3740.132124561166;
/// Reissner's loads for d = 20 mm, ν = 0 and .3, N.
const REISSNER: [(f64, f64); 2] = [(0.0, 3739.901442866519), (0.3, 3739.763061162994)];

/// Returns a column of one metre with a force at its tip.
fn column(
    (element, elements): (&str, u32),
    section: &str,
    [young, poisson]: [f64; 2],
    force: [f64; 3],
    analysis: &str,
) -> String {
    format!(
        r#"
        materials.material = {{ density = 8030, young = {young}, poisson = {poisson} }}
        sections.section = {section}
        {}
        [analysis]
        {analysis}
        "#,
        cantilever(&Rod { element, elements, ..ROD }, force)
    )
}

const CABLE: (&str, u32) = ("cable", 32);
const PUSH: [f64; 3] = [-1.0, 0.0, 0.0];
const BUCKLING: &str = "kind = \"buckling\"";

/// Compares a column of 2 mm with Euler, and one of 20 mm with Engesser and Reissner.
fn critical(findings: &mut Findings) -> Result<(), VerificationError> {
    let slender = "{ kind = \"circle\", diameter = 2e-3 }";
    for body in [CABLE, ("linked", 16), ("quadratic", 16)] {
        let name = body.0;
        let solved = solve(&column(body, slender, [YOUNG, 0.0], PUSH, BUCKLING))?;
        let (ours, reference) = (solved.last("factor")?, 1e-4 * EULER);
        findings.compare(format!("Euler's load in N, d = 2 mm, {name}"), ours, reference, reference, 1e-4);
    }
    let area = PI * 1e-4;
    let second = PI * 0.02_f64.powi(4) / 64.0;
    let section = format!("{{ kind = \"general\", area = {area}, iy = {second}, iz = {second} }}");
    let strain = EULER / (YOUNG * area);
    for (poisson, reissner) in REISSNER {
        let solved = solve(&column(("linked", 32), &section, [YOUNG, poisson], PUSH, BUCKLING))?;
        let ours = solved.last("factor")?;
        let linear = EULER / (1.0 + strain * (1.0 + 2.0 * (1.0 + poisson)));
        findings.compare(format!("Engesser's load in N, ν = {poisson}"), ours, linear, linear, 1e-6);
        let tolerance = 3.0 * strain;
        findings.compare(format!("Reissner's load in N, ν = {poisson}"), ours, reissner, reissner, tolerance);
    }
    Ok(())
}

/// Compares a wire of d = L/1000 and E I = 1 beyond its critical load, one model per load.
fn buckled(findings: &mut Findings) -> Result<Vec<[f64; 2]>, VerificationError> {
    let young = 64.0 / (PI * 1e-12);
    let mut path = Vec::new();
    for (ratio, x, y) in BUCKLED {
        let load = ratio * 0.25 * PI * PI;
        let force = [-load, 1e-7 * load, 0.0];
        let section = "{ kind = \"circle\", diameter = 1e-3 }";
        let analysis = "kind = \"path\"\nlargest = 1e6";
        let solved = solve(&column(CABLE, section, [young, 0.0], force, analysis))?;
        findings.compare(format!("x/L, P/P_E = {ratio:.4}"), solved.last("tip.x")?, x, 1.0, 1e-4);
        findings.compare(format!("y/L, P/P_E = {ratio:.4}"), solved.last("tip.y")?, y, 1.0, 1e-4);
        path = solved.points("tip.x", "tip.y")?;
    }
    Ok(path)
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    critical(&mut findings)?;
    let path = buckled(&mut findings)?;
    let elastica = BUCKLED.map(|(_, x, y)| [x, y]).to_vec();
    findings.plot(
        Plot::new(
            "Path of the tip beyond the critical load",
            ["x/L", "y/L"],
            vec![PlotCurve::line("ancf", path), PlotCurve::points("elastica", elastica)],
        )
        .with_equal_scales(),
    );
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
