use std::f64::consts::PI;

use crate::{Curve, Error, Findings, Plot, Problem, solve};

/// A column that buckles, and what it does then.
pub const PROBLEM: Problem = Problem {
    name: "euler_column",
    title: "Buckling and post-buckling of a cantilever column",
    source: "Euler (1744); Engesser (1889); Reissner (1972): P(1 − P/EA + P/GA) = P_E; the elastica beyond, by elliptic integrals",
    sketch: r"
  |/|=================== <- P      L = 1 m, d = 20 mm, E = 193 GPa; or inextensible",
    goal: "Linear buckling: a slender column within 1e-4 of Euler; with shear, within 1e-6 of Engesser's P_E/(1 + P_E/GA + P_E/EA), \
           whose last term is Green's strain of fibres: within 3 P/EA of Reissner's law. Beyond, tip within 1e-4 of the elastica, with 32 cable elements and a \
           disturbance across of 1e-7 of the load",
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
/// Euler's and Reissner's loads for d = 20 mm, ν = 0 and .3, in N.
const EULER: f64 = 3740.132124561166;
const REISSNER: [(f64, f64); 2] = [(0.0, 3739.901442866519), (0.3, 3739.763061162994)];

/// A column of a metre with a force at its tip.
fn column(body: &str, section: &str, [young, poisson]: [f64; 2], force: [f64; 3], analysis: &str) -> String {
    format!(
        r#"
        materials.steel = {{ density = 8030, young = {young}, poisson = {poisson} }}
        sections.round = {section}

        [[bodies]]
        {body}
        name = "column"
        from = [0, 0, 0]
        to = [1, 0, 0]
        section = "round"
        material = "steel"

        [[joints]]
        kind = "clamp"
        name = "root"
        a = {{ body = "column", at = "start" }}

        [[loads]]
        kind = "force"
        on = {{ body = "column", at = "end" }}
        force = {force:?}

        [[probes]]
        name = "tip"
        on = {{ body = "column", at = "end" }}

        [analysis]
        {analysis}
        "#
    )
}

const CABLE: &str = "kind = \"cable\"\nelements = 32";
const PUSH: [f64; 3] = [-1.0, 0.0, 0.0];
const BUCKLING: &str = "kind = \"buckling\"";

/// A beam of a formulation.
fn beam(formulation: &str, elements: u32) -> String {
    format!("kind = \"beam\"\nformulation = \"{formulation}\"\nelements = {elements}")
}

/// A column of 2 mm against Euler, one of 20 mm against Engesser and Reissner.
fn critical(findings: &mut Findings) -> Result<(), Error> {
    let slender = "{ kind = \"circle\", diameter = 2e-3 }";
    for (name, body) in
        [("cable", CABLE.into()), ("linked", beam("linked", 16)), ("quadratic", beam("quadratic", 16))]
    {
        let solved = solve(&column(&body, slender, [YOUNG, 0.0], PUSH, BUCKLING))?;
        let (ours, reference) = (solved.last("factor")?, 1e-4 * EULER);
        findings.compare(format!("Euler's load in N, d = 2 mm, {name}"), ours, reference, reference, 1e-4);
    }
    let area = PI * 1e-4;
    let second = PI * 0.02_f64.powi(4) / 64.0;
    let section = format!("{{ kind = \"general\", area = {area}, iy = {second}, iz = {second} }}");
    let strain = EULER / (YOUNG * area);
    for (poisson, reissner) in REISSNER {
        let solved = solve(&column(&beam("linked", 32), &section, [YOUNG, poisson], PUSH, BUCKLING))?;
        let ours = solved.last("factor")?;
        let linear = EULER / (1.0 + strain * (1.0 + 2.0 * (1.0 + poisson)));
        findings.compare(format!("Engesser's load in N, ν = {poisson}"), ours, linear, linear, 1e-6);
        let tolerance = 3.0 * strain;
        findings.compare(format!("Reissner's load in N, ν = {poisson}"), ours, reissner, reissner, tolerance);
    }
    Ok(())
}

/// A wire of d = L/1000 and E I = 1 beyond its critical load, one model a load.
fn buckled(findings: &mut Findings) -> Result<Vec<[f64; 2]>, Error> {
    let young = 64.0 / (PI * 1e-12);
    let mut way = Vec::new();
    for (ratio, x, y) in BUCKLED {
        let load = ratio * 0.25 * PI * PI;
        let force = [-load, 1e-7 * load, 0.0];
        let section = "{ kind = \"circle\", diameter = 1e-3 }";
        let analysis = "kind = \"path\"\nlargest = 1e6";
        let solved = solve(&column(CABLE, section, [young, 0.0], force, analysis))?;
        findings.compare(format!("x/L, P/P_E = {ratio:.4}"), solved.last("tip.x")?, x, 1.0, 1e-4);
        findings.compare(format!("y/L, P/P_E = {ratio:.4}"), solved.last("tip.y")?, y, 1.0, 1e-4);
        way = solved.points("tip.x", "tip.y")?;
    }
    Ok(way)
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    critical(&mut findings)?;
    let way = buckled(&mut findings)?;
    let elastica = BUCKLED.map(|(_, x, y)| [x, y]).to_vec();
    findings.plots.push(Plot {
        title: "Way of the tip beyond the critical load".into(),
        axes: ["x/L".into(), "y/L".into()],
        equal: true,
        curves: vec![Curve::line("ours", way), Curve::points("elastica", elastica)],
        ..Plot::default()
    });
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        super::super::assert_holds(&super::PROBLEM);
    }
}
