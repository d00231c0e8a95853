use crate::problems::models::{ROD, Rod, cantilever};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Elastica: a cantilever under a dead load at its tip.
pub const PROBLEM: Problem = Problem {
    name: "elastica",
    title: "Cantilever under a dead load at its tip",
    source: "Euler's elastica: Bisshopp & Drucker (1945), by elliptic integrals and by shooting, equal to 1e-14",
    sketch: r"
  |/|============________
  |/|                    \____     P L²/EI = 1, 2, 5, 10, along −y
                              \
                               | P",
    goal: "Tip within 1e-5 of the inextensible elastica with 32 cable elements of L/d = 1000, one model per load",
    run,
};

/// P L²/EI, tip x/L and y/L.
const TIPS: [(f64, f64, f64); 4] = [
    (1.0, 0.943566763716623, 0.301720773799814),
    (2.0, 0.839358279174833, 0.493457480396712),
    (5.0, 0.61237163927557, 0.713791523611913),
    (10.0, 0.445004402246249, 0.810609024880296),
];

/// Returns a wire of length one with E I = 1 and d = 1/1000, which is nearly inextensible.
fn model(load: f64) -> String {
    let area: f64 = std::f64::consts::PI * 0.25e-6;
    let young = 1.0 / (area * area / (4.0 * std::f64::consts::PI));
    format!(
        r#"
        materials.material = {{ density = 1, young = {young} }}
        sections.section = {{ kind = "circle", diameter = 1e-3 }}
        {}
        [analysis]
        kind = "statics"
        first = 0.1
        "#,
        cantilever(&Rod { element: "cable", elements: 32, ..ROD }, [0.0, -load, 0.0])
    )
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut ours = Vec::new();
    for (load, x, y) in TIPS {
        let solved = solve(&model(load))?;
        findings.compare(format!("x/L, PL²/EI = {load}"), solved.last("tip.x")?, x, 1.0, 1e-5);
        findings.compare(format!("−y/L, PL²/EI = {load}"), -solved.last("tip.y")?, y, 1.0, 1e-5);
        ours = solved.points("tip.x", "tip.y")?;
    }
    findings.plot(
        Plot::new(
            "Path of the tip up to P L²/EI = 10",
            ["x/L", "y/L"],
            vec![
                PlotCurve::line("ancf", ours),
                PlotCurve::points("elastica", TIPS.map(|(_, x, y)| [x, -y]).to_vec()),
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
