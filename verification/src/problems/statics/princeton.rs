use crate::problems::models::{ROD, Rod, cantilever};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Strip bent about both axes and twisted.
pub const PROBLEM: Problem = Problem {
    name: "princeton",
    title: "Strip of the Princeton experiment: bent about both axes and twisted",
    source: "Dowell & Traybar (1975); the tips by shooting of Reissner's rod with k = 1, ν = 0 and the polar moment \
                 of area in \
             torsion",
    sketch: r"
  |/|=====================  L = 0.508 m, 12.377 × 3.2024 mm, E = 71.7 GPa
  |/|                    \\  P at an angle from the stiff direction",
    goal: "Tip within 1e-4 of the largest deflection, with 32 elements. The torsion constant is I₂ + I₃, as of a continuum \
           without warping, five times that of the strip: the reference is the rod, not the experiment",
    run,
};

/// P in N, angle in degrees, displacement along the axis, the stiff and the soft direction in m.
const TIPS: [(f64, f64, [f64; 3]); 3] = [
    (4.448, 45.0, [-0.0037222610, -0.0037961771, 0.0558921198]),
    (8.896, 45.0, [-0.0140523899, -0.0076267295, 0.1079407501]),
    (13.345, 30.0, [-0.0158577397, -0.0140146701, 0.1139637134]),
];

const LENGTH: f64 = 0.508;
const HEIGHT: f64 = 12.377e-3;
const WIDTH: f64 = 3.2024e-3;

fn strip(formulation: &str, load: f64, degrees: f64) -> String {
    let area = HEIGHT * WIDTH;
    let [iy, iz] = [area * WIDTH * WIDTH / 12.0, area * HEIGHT * HEIGHT / 12.0];
    let (sin, cos) = degrees.to_radians().sin_cos();
    let rod = Rod { element: formulation, to: [LENGTH, 0.0, 0.0], elements: 32, ..ROD };
    format!(
        r#"
        materials.material = {{ density = 2700, young = 71.7e9 }}
        sections.section = {{ kind = "general", area = {area}, iy = {iy}, iz = {iz} }}
        {}
        [analysis]
        kind = "statics"
        first = 0.1
        "#,
        cantilever(&rod, [0.0, -load * cos, load * sin])
    )
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for formulation in ["linked", "quadratic"] {
        for (load, degrees, tip) in TIPS {
            let solved = solve(&strip(formulation, load, degrees))?;
            let from = [LENGTH, 0.0, 0.0];
            for ((axis, from), reference) in ["x", "y", "z"].into_iter().zip(from).zip(tip) {
                let ours = solved.last(&format!("tip.{axis}"))? - from;
                let what = format!("u{axis} in m, {load} N at {degrees}°, {formulation}");
                findings.compare(what, ours, reference, tip[2], 1e-4);
            }
            let path = solved.points("tip.z", "tip.y")?;
            let name = format!("{formulation}, {load} N at {degrees}°");
            curves.push(PlotCurve::line(name, path));
        }
    }
    let points = TIPS.map(|(_, _, [_, y, z])| [z, y]).to_vec();
    curves.push(PlotCurve::points("Reissner's rod", points));
    findings.plot(Plot::new(
        "Path of the tip with increasing load, seen along the axis",
        ["soft direction in m", "stiff direction in m"],
        curves,
    ));
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
