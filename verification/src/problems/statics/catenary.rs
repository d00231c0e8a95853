use crate::problems::models::{ROD, Rod, joint};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Cable suspended between two points.
pub const PROBLEM: Problem = Problem {
    name: "catenary",
    title: "Cable suspended between two points of equal height",
    source: "Catenary in closed form, inextensible and elastic, by Newton's method in extended precision",
    sketch: r"
  o                 o       span 10, length 12, weight w per length
   \               /
     \           /          moved from the straight state by statics
        `--___--'",
    goal: "Sag, horizontal force, tension and slope at the ends within 1e-4 with 48 cable elements of small bending \
           stiffness; inextensible, EA/w = 1000 and 100",
    run,
};

const SPAN: f64 = 10.0;
const LENGTH: f64 = 12.0;
const ELEMENTS: u32 = 48;

/// EA/w, H/w, sag and T/w at the ends.
const REFERENCES: [(f64, [f64; 3]); 3] = [
    (1e7, [4.695_415_231_265_281, 2.923_437_976_009_288, 7.618_853_207_274_569]),
    (1e3, [4.597_764_795_843_918, 2.979_298_712_151_081, 7.559_063_507_994_999]),
    (1e2, [3.955_270_427_525_548, 3.411_116_992_789_205, 7.186_387_420_314_753]),
];

/// Slope at the ends of the inextensible cable, degrees.
const END_SLOPE: f64 = 51.954_360_700_51;

/// Solves a cable with w = 1 and E I = 1e-4. Bending is confined to √(E I/H) ≈ 0.005 from the ends.
fn solve_cable(axial: f64) -> Result<SolvedModel, VerificationError> {
    let diameter = 4.0 * (1e-4 / axial).sqrt();
    let area = 0.25 * std::f64::consts::PI * diameter * diameter;
    let probes: String = (0..=ELEMENTS)
        .map(|node| {
            let at = LENGTH * f64::from(node) / f64::from(ELEMENTS);
            format!("[[probes]]\nname = \"p{node}\"\non = {{ body = \"cable\", at = {at:?} }}\n")
        })
        .collect();
    let rod = Rod { name: "cable", element: "cable", to: [LENGTH, 0.0, 0.0], elements: ELEMENTS, ..ROD };
    let support =
        |name, at: &str| joint("spherical", name, &format!("{{ body = \"cable\", at = \"{at}\" }}"));
    solve(&format!(
        r#"
        gravity = [0, -1, 0]
        materials.material = {{ density = {:e}, young = {:e} }}
        sections.section = {{ kind = "circle", diameter = {diameter:e} }}
        {rod}{left}{right}b = {{ point = [{SPAN:?}, 0, 0] }}
        {probes}
        [analysis]
        kind = "statics"
        first = 0.01
        "#,
        1.0 / area,
        axial / area,
        left = support("left", "start"),
        right = support("right", "end"),
    ))
}

/// Returns the inextensible catenary with the parameter a = H/w.
fn catenary(a: f64) -> PlotCurve {
    let y = |x: f64| a * (((x - 0.5 * SPAN) / a).cosh() - (0.5 * SPAN / a).cosh());
    let points = (0..=20).map(|k| 0.5 * f64::from(k)).map(|x| [x, y(x)]).collect();
    PlotCurve::points("catenary", points)
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for (axial, [horizontal, sag, tension]) in REFERENCES {
        let solved = solve_cable(axial)?;
        let name = if axial > 1e6 { "inextensible".into() } else { format!("EA/w = {axial}") };
        let (fx, fy) = (solved.last("right.fx")?, solved.last("right.fy")?);
        let middle = solved.last(&format!("p{}.y", ELEMENTS / 2))?;
        findings.compare(format!("H/w, {name}"), fx, horizontal, horizontal, 1e-4);
        findings.compare(format!("T/w at the ends, {name}"), fx.hypot(fy), tension, tension, 1e-4);
        findings.compare(format!("sag, {name}"), -middle, sag, sag, 1e-4);
        if axial > 1e6 {
            findings.compare(
                "slope at the ends, degrees",
                fy.atan2(fx).to_degrees(),
                END_SLOPE,
                END_SLOPE,
                1e-4,
            );
            curves.push(catenary(horizontal));
        }
        let points = (0..=ELEMENTS)
            .map(|node| Ok([solved.last(&format!("p{node}.x"))?, solved.last(&format!("p{node}.y"))?]))
            .collect::<Result<_, VerificationError>>()?;
        curves.push(PlotCurve::line(name, points));
    }
    findings.plot(Plot::new("Shapes", ["x", "y"], curves).with_equal_scales());
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
