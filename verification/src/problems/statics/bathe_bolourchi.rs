use crate::problems::models::{ROD, Rod, cantilever};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Circular bend of 45° under a dead load normal to its plane.
pub const PROBLEM: Problem = Problem {
    name: "bathe_bolourchi",
    title: "45° bend under a dead load out of its plane",
    source: "Bathe & Bolourchi (1979); the tips by shooting of the geometrically exact rod on the true circular arc \
                 with k = 1",
    sketch: r"
            ___ tip, P along z      R = 100, square 1 × 1, E = 10⁷, ν = 0
        .--'
  |/|--'                            in the x–y plane, clamped",
    goal: "Tip within 1e-4 + 2P/EA of its distance from the root, with 64 elements, for the torsion constants I₂ + I₃ \
               (that of \
           a continuum without warping) and .140577 (St. Venant). In the law of St. Venant and Kirchhoff the strain ε of the \
           axis changes the bending stiffness to EI(1 + 2ε), in the reference it does not: hence 2P/EA",
    run,
};

type Tip = (f64, [f64; 3]);

/// P and tip for J = I₂ + I₃ = 1/6.
const POLAR: [Tip; 4] = [
    (300.0, [58.7791224897, 22.2447809454, 40.1918916701]),
    (450.0, [52.2385580112, 18.5081789254, 48.5029273441]),
    (600.0, [47.1504385736, 15.6848005340, 53.4748587918]),
    (3000.0, [23.0243082248, 4.2328759165, 68.5390894931]),
];

/// P and tip for J = .140577.
const ST_VENANT: [Tip; 3] = [
    (300.0, [58.5359326208, 22.1126145205, 40.4802615804]),
    (450.0, [51.9697173552, 18.3692756429, 48.7047886277]),
    (600.0, [46.8919247814, 15.5577858240, 53.6073692657]),
];

/// EA.
const AXIAL: f64 = 1e7;

fn bend(formulation: &str, torsion: f64, load: f64) -> String {
    let at = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [100.0 * sin, 100.0 * (1.0 - cos), 0.0]
    };
    let shape = format!("shape = {{ kind = \"arc\", through = {:?} }}", at(22.5));
    let rod = Rod { element: formulation, to: at(45.0), elements: 64, keys: &shape, ..ROD };
    let second = 1.0 / 12.0;
    format!(
        r#"
        materials.material = {{ density = 1, young = 1e7 }}
        sections.section = {{ kind = "general", area = 1, iy = {second}, iz = {second}, j = {torsion} }}
        {}
        [analysis]
        kind = "statics"
        first = 0.1
        "#,
        cantilever(&rod, [0.0, 0.0, load])
    )
}

/// Adds the comparisons of the tip. The scale is the distance of the tip from the root.
fn compare(
    findings: &mut Findings,
    what: &str,
    solved: &SolvedModel,
    (load, tip): Tip,
) -> Result<(), VerificationError> {
    let tolerance = 1e-4 + 2.0 * load / AXIAL;
    let scale = tip.iter().map(|x| x * x).sum::<f64>().sqrt();
    for (axis, reference) in ["x", "y", "z"].into_iter().zip(tip) {
        let ours = solved.last(&format!("tip.{axis}"))?;
        findings.compare(format!("{axis}, {what}"), ours, reference, scale, tolerance);
    }
    Ok(())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for formulation in ["linked", "quadratic"] {
        for (name, torsion, tips) in
            [("1/6", 1.0 / 6.0, POLAR.as_slice()), (".140577", 0.140577, ST_VENANT.as_slice())]
        {
            let mut path = Vec::new();
            for &(load, tip) in tips {
                let solved = solve(&bend(formulation, torsion, load))?;
                compare(
                    &mut findings,
                    &format!("P = {load}, J = {name}, {formulation}"),
                    &solved,
                    (load, tip),
                )?;
                path = solved.points("tip.x", "tip.z")?;
            }
            curves.push(PlotCurve::line(format!("{formulation}, J = {name}"), path));
        }
    }
    let exact = POLAR.iter().chain(&ST_VENANT).map(|&(_, [x, _, z])| [x, z]).collect();
    curves.push(PlotCurve::points("exact rod", exact));
    findings.plot(
        Plot::new("Path of the tip with increasing load, seen along y", ["x", "z"], curves)
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
