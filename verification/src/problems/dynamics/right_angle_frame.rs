use crate::problems::models::{Rod, clamp, clamped, end_probe, tip_load};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Two legs at a right angle, loaded normal to their plane.
pub const PROBLEM: Problem = Problem {
    name: "right_angle_frame",
    title: "Right-angle cantilever: bending and torsion of two legs, in space",
    source: "Simo & Vu-Quoc (1988), who print curves; extrema by Gerstmayr (2026), geometrically exact beam of EXUDYN, \
             40 elements per leg, steps of 5 ms",
    sketch: r"
                  | 10      legs of 10, E A = G A = 1e6, E I = G J = 1e3
  |/|             |         ρ A = 1, ρ I = diag(20, 10, 10)
  |/|=============+ P(t)    P out of the plane: 0, 50, 0 at t = 0, 1, 2
         10",
    goal: "Extrema of the tip and of the elbow out of the plane within 1 % of 10, the length of a leg, and their times \
           within 0.1, by 8 quadratic elements per leg; the displacements are as large as the legs",
    run,
};

/// Point, true for a minimum, displacement, time.
const EXTREMA: [(&str, bool, f64, f64); 3] =
    [("tip", false, 8.25, 7.44), ("tip", true, -9.73, 15.87), ("elbow", true, -4.06, 10.87)];

/// Returns the text of the model.
fn model() -> String {
    let leg = |name, from, to| Rod { name, element: "quadratic", from, to, elements: 8, keys: "" };
    let elbow = [10.0, 0.0, 0.0];
    format!(
        r#"
        materials.material = {{ density = 1, young = 1e6 }}

        [sections.section]
        kind = "general"
        area = 1
        iy = 1e-3
        iz = 1e-3
        j = 2e-3
        ky = 2
        kz = 2
        mass_iy = 10
        mass_iz = 10
        {first}{second}{root}{corner}fix = "section"
        {load}time = {{ kind = "table", times = [0, 1, 2], values = [0, 1, 0] }}
        {elbow_probe}{tip_probe}
        [analysis]
        kind = "dynamics"
        duration = 30
        step = 0.02
        scheme = {{ spectral_radius = 0.8 }}
        "#,
        first = leg("first", [0.0; 3], elbow),
        second = leg("second", elbow, [10.0, 10.0, 0.0]),
        root = clamped("first"),
        corner = clamp("corner", "second", "{ body = \"first\", at = \"end\" }"),
        load = tip_load("first", [0.0, 0.0, 50.0]),
        elbow_probe = end_probe("elbow", "first"),
        tip_probe = end_probe("tip", "second")
    )
}

/// Returns time and value of the largest or smallest displacement of a point out of the plane.
fn extremum(solved: &SolvedModel, point: &str, is_minimum: bool) -> Result<[f64; 2], VerificationError> {
    let points = solved.points("t", &format!("{point}.z"))?;
    let value = |row: &[f64; 2]| if is_minimum { -row[1] } else { row[1] };
    let found = points.into_iter().max_by(|a, b| value(a).total_cmp(&value(b)));
    found.ok_or_else(|| VerificationError::Missing(format!("row of {point}")))
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let solved = solve(&model())?;
    for (point, is_minimum, z, t) in EXTREMA {
        let name = format!("{}, {point}", if is_minimum { "minimum" } else { "maximum" });
        let [when, value] = extremum(&solved, point, is_minimum)?;
        findings.compare(name.clone(), value, z, 10.0, 0.01);
        findings.compare(format!("time of the {name}"), when, t, 1.0, 0.1);
    }
    let extrema_of = |name: &str| {
        let found = EXTREMA.iter().filter(|(point, ..)| *point == name);
        found.map(|&(.., z, t)| [t, z]).collect()
    };
    let mut plot = Plot::new("Displacement out of the plane", ["t", "z"], Vec::new());
    for point in ["tip", "elbow"] {
        let ours = solved.points("t", &format!("{point}.z"))?;
        plot.curves.push(PlotCurve::line(point, ours));
        let name = format!("{point}, geometrically exact beam");
        plot.curves.push(PlotCurve::points(name, extrema_of(point)));
    }
    findings.plot(plot);
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
