use crate::{Curve, Error, Findings, Plot, Problem, Solved, solve};

/// Two legs at a right angle, struck out of their plane.
pub const PROBLEM: Problem = Problem {
    name: "right_angle_frame",
    title: "Right-angle cantilever: bending and torsion of two legs, in space",
    source: "Simo & Vu-Quoc (1988), who print curves; extrema as Gerstmayr (2026) has them of EXUDYN's geometrically exact \
             beam, 40 elements a leg, steps of 5 ms",
    sketch: r"
                  | 10      legs of 10, E A = G A = 1e6, E I = G J = 1e3
  |/|             |         ρ A = 1, ρ I = diag(20, 10, 10)
  |/|=============+ P(t)    P out of the plane: 0, 50, 0 at t = 0, 1, 2
         10",
    goal: "Extrema of the tip and of the elbow out of the plane within 1 % of 10, the length of a leg, and their times \
           within 0.1, by 8 quadratic elements a leg; swings are as large as the legs are long",
    run,
};

/// Point, whether it is a minimum, displacement, time.
const EXTREMA: [(&str, bool, f64, f64); 3] =
    [("tip", false, 8.25, 7.44), ("tip", true, -9.73, 15.87), ("elbow", true, -4.06, 10.87)];

const MODEL: &str = r#"
    materials.stuff = { density = 1, young = 1e6 }

    [sections.leg]
    kind = "general"
    area = 1
    iy = 1e-3
    iz = 1e-3
    j = 2e-3
    ky = 2
    kz = 2
    mass_iy = 10
    mass_iz = 10

    [[bodies]]
    kind = "beam"
    name = "first"
    formulation = "quadratic"
    from = [0, 0, 0]
    to = [10, 0, 0]
    elements = 8
    section = "leg"
    material = "stuff"

    [[bodies]]
    kind = "beam"
    name = "second"
    formulation = "quadratic"
    from = [10, 0, 0]
    to = [10, 10, 0]
    elements = 8
    section = "leg"
    material = "stuff"

    [[joints]]
    kind = "clamp"
    name = "root"
    a = { body = "first", at = "start" }

    [[joints]]
    kind = "clamp"
    name = "corner"
    a = { body = "second", at = "start" }
    b = { body = "first", at = "end" }
    fix = "section"

    [[loads]]
    kind = "force"
    on = { body = "first", at = "end" }
    force = [0, 0, 50]
    time = { kind = "table", times = [0, 1, 2], values = [0, 1, 0] }

    [[probes]]
    name = "elbow"
    on = { body = "first", at = "end" }

    [[probes]]
    name = "tip"
    on = { body = "second", at = "end" }

    [analysis]
    kind = "dynamics"
    duration = 30
    step = 0.02
    scheme = { spectral_radius = 0.8 }
    "#;

/// The largest or smallest displacement of a point out of the plane, and when.
fn extremum(solved: &Solved, point: &str, is_minimum: bool) -> Result<[f64; 2], Error> {
    let points = solved.points("t", &format!("{point}.z"))?;
    let value = |row: &[f64; 2]| if is_minimum { -row[1] } else { row[1] };
    let found = points.into_iter().max_by(|a, b| value(a).total_cmp(&value(b)));
    found.ok_or_else(|| Error::Missing(format!("row of {point}")))
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let solved = solve(MODEL)?;
    for (point, is_minimum, z, t) in EXTREMA {
        let name = format!("{}, {point}", if is_minimum { "minimum" } else { "maximum" });
        let [when, value] = extremum(&solved, point, is_minimum)?;
        findings.compare(name.clone(), value, z, 10.0, 0.01);
        findings.compare(format!("time of the {name}"), when, t, 1.0, 0.1);
    }
    let of = |wanted: &str| {
        let found = EXTREMA.iter().filter(|(point, ..)| *point == wanted);
        found.map(|&(.., z, t)| [t, z]).collect()
    };
    let mut plot = Plot {
        title: "Displacement out of the plane".into(),
        axes: ["t".into(), "z".into()],
        ..Plot::default()
    };
    for point in ["tip", "elbow"] {
        let ours = solved.points("t", &format!("{point}.z"))?;
        plot.curves.push(Curve::line(point, ours));
        let name = format!("{point}, geometrically exact beam");
        plot.curves.push(Curve::points(name, of(point)));
    }
    findings.plots.push(plot);
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        super::super::assert_holds(&super::PROBLEM);
    }
}
