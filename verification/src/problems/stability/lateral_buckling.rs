use crate::problems::models::{ROD, Rod, cantilever};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Lateral-torsional buckling of a strip under a load at its tip.
pub const PROBLEM: Problem = Problem {
    name: "lateral_buckling",
    title: "Lateral-torsional buckling of a cantilever strip",
    source: "Prandtl (1899), Michell (1899): P L² = 4.012599343578901 √(E I G J); with the bending before buckling, the \
             geometrically exact rod, bent in its plane by shooting and perturbed out of it",
    sketch: r"
  |/|===========================   L = 1 m, 50 × 5 mm on edge, E = 71.7 GPa, ν = .31
  |/|                          | P",
    goal: "Within 1e-3 of the classical load by linear buckling, and of the geometrically exact rod by the change of \
               stability \
           along the path, with 64 quadratic elements; for St. Venant's torsion constant and for I₂ + I₃, five times \
           the load",
    run,
};

const HEIGHT: f64 = 0.05;
const WIDTH: f64 = 0.005;

fn strip(section: &str, analysis: &str) -> String {
    format!(
        r#"
        materials.material = {{ density = 2700, young = 71.7e9, poisson = 0.31 }}
        sections.section = {section}
        {}
        [analysis]
        {analysis}
        "#,
        cantilever(&Rod { element: "quadratic", elements: 64, ..ROD }, [0.0, -1.0, 0.0])
    )
}

/// Returns the load between the last stable and the first unstable point.
fn loss_of_stability(solved: &SolvedModel) -> Result<f64, VerificationError> {
    let rows = solved.points("load", "unstable")?;
    let first = rows.iter().position(|&[_, unstable]| unstable > 0.5);
    let pair = first.and_then(|first| rows.get(first.checked_sub(1)?..=first));
    let Some(&[[before, _], [beyond, _]]) = pair else {
        return Err(VerificationError::Missing("loss of stability".into()));
    };
    Ok(0.5 * (before + beyond))
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let area = HEIGHT * WIDTH;
    let [iy, iz] = [area * WIDTH * WIDTH / 12.0, area * HEIGHT * HEIGHT / 12.0];
    let solid = format!("{{ kind = \"rectangle\", height = {HEIGHT}, width = {WIDTH} }}");
    let polar = format!("{{ kind = \"general\", area = {area}, iy = {iy}, iz = {iz} }}");
    let mut curves = Vec::new();
    for (name, section, classical, exact) in [
        ("St. Venant's J", solid, 179.22025978431, 181.8436838),
        ("J = I₂ + I₃", polar, 930.36586, 1325.88653),
    ] {
        let ours = solve(&strip(&section, "kind = \"buckling\""))?.last("factor")?;
        findings.compare(format!("classical load in N, {name}"), ours, classical, classical, 1e-3);
        let [end, first] = [1.02 * exact, 0.1 * exact];
        let path = format!("kind = \"path\"\nload = {end}\nfirst = {first}\nlargest = {first}");
        let solved = solve(&strip(&section, &path))?;
        let ours = loss_of_stability(&solved)?;
        findings.compare(format!("load of the exact rod in N, {name}"), ours, exact, exact, 1e-3);
        curves.push(PlotCurve::line(name, solved.points("load", "unstable")?));
        let points = vec![[exact, 0.0], [exact, 1.0]];
        curves.push(PlotCurve::points(format!("exact rod, {name}"), points));
    }
    findings.plot(Plot::new("Unstable directions of the plane path", ["P in N", "number"], curves));
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
