use crate::{Curve, Error, Findings, Plot, Problem, Solved, solve};

/// A cable hung between two points.
pub const PROBLEM: Problem = Problem {
    name: "catenary",
    title: "Cable hung between two points of one height",
    source: "Catenary in closed form, inextensible and elastic, by Newton's method in extended precision",
    sketch: r"
  o                 o       span 10, length 12, weight w per length
   \               /
     \           /          drawn in from its straight state by statics
        `--___--'",
    goal: "Sag, horizontal force, tension and slope at the ends within 1e-4 with 48 cable elements that hardly resist \
           bending; inextensible, EA/w = 1000 and 100",
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

/// Of the inextensible one, degrees.
const END_SLOPE: f64 = 51.954_360_700_51;

/// With w = 1 and E I = 1e-4: bending reaches √(E I/H) ≈ 0.005 from the ends.
fn hung(axial: f64) -> Result<Solved, Error> {
    let diameter = 4.0 * (1e-4 / axial).sqrt();
    let area = 0.25 * std::f64::consts::PI * diameter * diameter;
    let probes: String = (0..=ELEMENTS)
        .map(|node| {
            let at = LENGTH * f64::from(node) / f64::from(ELEMENTS);
            format!("[[probes]]\nname = \"p{node}\"\non = {{ body = \"cable\", at = {at:?} }}\n")
        })
        .collect();
    solve(&format!(
        r#"
        gravity = [0, -1, 0]
        materials.cable = {{ density = {:e}, young = {:e} }}
        sections.cable = {{ kind = "circle", diameter = {diameter:e} }}

        [[bodies]]
        kind = "cable"
        name = "cable"
        from = [0, 0, 0]
        to = [{LENGTH:?}, 0, 0]
        elements = {ELEMENTS}
        section = "cable"
        material = "cable"

        [[joints]]
        kind = "spherical"
        name = "left"
        a = {{ body = "cable", at = "start" }}

        [[joints]]
        kind = "spherical"
        name = "right"
        a = {{ body = "cable", at = "end" }}
        b = {{ point = [{SPAN:?}, 0, 0] }}

        {probes}

        [analysis]
        kind = "statics"
        first = 0.01
        "#,
        1.0 / area,
        axial / area
    ))
}

/// A catenary with the parameter a = H/w, inextensible.
fn catenary(a: f64) -> Curve {
    let y = |x: f64| a * (((x - 0.5 * SPAN) / a).cosh() - (0.5 * SPAN / a).cosh());
    let points = (0..=20).map(|k| 0.5 * f64::from(k)).map(|x| [x, y(x)]).collect();
    Curve::points("catenary", points)
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for (axial, [horizontal, sag, tension]) in REFERENCES {
        let solved = hung(axial)?;
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
            .collect::<Result<_, Error>>()?;
        curves.push(Curve::line(name, points));
    }
    findings.plots.push(Plot {
        title: "Shapes".into(),
        axes: ["x".into(), "y".into()],
        equal: true,
        curves,
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
