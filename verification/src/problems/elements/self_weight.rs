use crate::problems::models::{Cantilever, KIM, KIM_BY_NUMBERS};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Many elements under their own weight, in one load step.
pub const PROBLEM: Problem = Problem {
    name: "self_weight",
    title: "Own weight on a thousand elements in one load step",
    source: "Rod of Kim et al. (2017): heavy elastica and Reissner's rod with shear factor one, by shooting",
    sketch: r"
  |/|========================     L = 1 m, d = 20 mm, E A = 4e4 E I/L²
  |/| | | | | | | | | | | | |     1000 elements, each a twentieth of d long
      v v v v v v v v v v v v",
    goal: "One load step, 1 to 5 Newton iterations, for all elements and meshes of 10, 100 and 1000; deflection of 1000 \
           elements within 1e-6. Codes with approximate tangents or absolute tolerances need hundreds of \
           iterations here, or fail",
    run,
};

/// Elements, and the deflection of the tip in mm.
const KINDS: [(&str, f64); 5] = [
    ("continuum", 2.041_186_330),
    ("enhanced", 2.041_186_330),
    ("linked", 2.041_186_330),
    ("quadratic", 2.041_186_330),
    ("cable", 2.040_778_175),
];

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for (element, reference) in KINDS {
        let mut points = Vec::new();
        for elements in [10, 100, 1000] {
            let section = if element == "cable" { KIM.section } else { KIM_BY_NUMBERS };
            let solved = solve(&Cantilever { element, elements, section, ..KIM }.model())?;
            // Exact as a floating-point number.
            let iterations = solved.summary.iterations as f64;
            findings.compare(
                format!("iterations, 1 to 5, {element}, {elements} elements"),
                iterations,
                3.0,
                1.0,
                2.0,
            );
            points.push([f64::from(elements), iterations]);
            if elements == 1000 {
                let depth = -1e3 * solved.last("tip.y")?;
                findings.compare(
                    format!("depth, {element}, {elements} elements, mm"),
                    depth,
                    reference,
                    reference,
                    1e-6,
                );
            }
        }
        curves.push(PlotCurve::line(element, points));
    }
    findings.plot(
        Plot::new("Newton iterations against the number of elements", ["elements", "iterations"], curves)
            .with_logarithmic_axes([true, false]),
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
