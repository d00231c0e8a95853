use crate::problems::models::{Cantilever, KIM};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Heavy elastica: a cantilever under its own weight.
pub const PROBLEM: Problem = Problem {
    name: "heavy_elastica",
    title: "Cantilever under its own weight, from stiff to soft",
    source: "Heavy elastica, qL³/EI = 0.1 to 50, by shooting (inextensible); Reissner's rod with shear factor one, by \
                 shooting",
    sketch: r"
  |/|==========___
  |/|   | | | |   \__      weight q, qL³/EI = 0.1, 1, 5, 10, 20, 50
        v v v v   |  \
                  v  v",
    goal: "Tip of 128 cable elements within 1e-6 L of the inextensible elastica; the axial strain is below 2e-7. Beams have \
           Green's strain over the section, softer than Reissner's rod by the order of (κd)²: the rod of Kim et al. \
           (2017) with \
           E/1000 within 1e-3 L for d/L = 1/50, and with smaller d/L at equal weight and E I within 1e-5 L and 1e-6 L",
    run,
};

const STATICS: &str = "first = 0.05\nstop = { rule = \"energy\", tolerance = 1e-11 }";

/// q L³/EI, x/L and drop/L.
const TIPS: [(f64, f64, f64); 6] = [
    (0.1, 0.9999107322241, 0.012_498_437_848),
    (1.0, 0.9912463953466352, 0.1234714019833511),
    (5.0, 0.8466571799543, 0.4959050446224),
    (10.0, 0.6563537612385987, 0.7001997155143126),
    (20.0, 0.4452320522396, 0.8298814434393),
    (50.0, 0.245_014_756_320_6, 0.9079171234773),
];

/// x and drop of the rod of Kim et al. with E/1000: inextensible, and Reissner's rod with ν = 0.
const SOFT: [[f64; 2]; 2] = [[0.503_940_370_930, 0.800_310_986_762], [0.503_917_404_445, 0.800_577_428_674]];

/// Factors of the diameter, and tolerances. The difference of Green's strain to Reissner's rod falls with their square.
const SLENDER: [(f64, f64); 3] = [(1.0, 1e-3), (0.1, 1e-5), (0.01, 1e-6)];

/// Returns the path of the tip of a nearly inextensible wire: E I = 1, length one, d = 2e-4.
fn wire(weight: f64) -> Result<Vec<[f64; 2]>, VerificationError> {
    let area = std::f64::consts::PI * 1e-8;
    let young = 4.0 * std::f64::consts::PI / (area * area);
    let cantilever = Cantilever {
        element: "cable",
        elements: 128,
        section: "{ kind = \"circle\", diameter = 2e-4 }",
        material: &format!("{{ density = {:e}, young = {young:e} }}", 1.0 / area),
        gravity: weight,
        statics: STATICS,
        ..KIM
    };
    solve(&cantilever.model())?.points("tip.x", "tip.y")
}

/// Returns the tip of the rod with a smaller diameter and equal weight and E I.
fn soft(formulation: &str, part: f64) -> Result<[f64; 2], VerificationError> {
    let (area, second) = (3.141592653589793e-4 * part.powi(2), 7.853981633974483e-9 * part.powi(4));
    let (density, young) = (8030.0 / part.powi(2), 193e6 / part.powi(4));
    let cantilever = Cantilever {
        element: formulation,
        elements: 128,
        section: &format!("{{ kind = \"general\", area = {area:e}, iy = {second:e}, iz = {second:e} }}"),
        material: &format!("{{ density = {density:e}, young = {young:e} }}"),
        statics: STATICS,
        ..KIM
    };
    let solved = solve(&cantilever.model())?;
    Ok([solved.last("tip.x")?, solved.last("tip.y")?])
}

/// Compares beams. The contributions of axial strain and shear to the tip are proportional to the square of the diameter.
fn beams(findings: &mut Findings) -> Result<(), VerificationError> {
    for formulation in ["linked", "quadratic"] {
        for (part, tolerance) in SLENDER {
            let [x, y] = soft(formulation, part)?;
            let [[x0, drop0], [x1, drop1]] = SOFT;
            let square = part * part;
            let what = |axis: &str| format!("{axis}/L, {formulation}, d/L = {:e}", 0.02 * part);
            findings.compare(what("x"), x, x0 + (x1 - x0) * square, 1.0, tolerance);
            findings.compare(what("drop"), -y, drop0 + (drop1 - drop0) * square, 1.0, tolerance);
        }
    }
    Ok(())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut path = Vec::new();
    for (weight, x, drop) in TIPS {
        path = wire(weight)?;
        let tip = path.last().ok_or_else(|| VerificationError::Missing("rows".into()))?;
        findings.compare(format!("x/L, qL³/EI = {weight}"), tip[0], x, 1.0, 1e-6);
        findings.compare(format!("drop/L, qL³/EI = {weight}"), -tip[1], drop, 1.0, 1e-6);
    }
    beams(&mut findings)?;
    findings.plot(
        Plot::new(
            "Path of the tip up to qL³/EI = 50",
            ["x/L", "y/L"],
            vec![
                PlotCurve::line("ancf", path),
                PlotCurve::points("heavy elastica", TIPS.map(|(_, x, drop)| [x, -drop]).to_vec()),
            ],
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
