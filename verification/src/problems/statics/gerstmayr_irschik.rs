use crate::problems::models::Cantilever;
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Cable element under a large load at the tip.
pub const PROBLEM: Problem = Problem {
    name: "gerstmayr_irschik",
    title: "Cable element under a large dead load at the tip",
    source: "Gerstmayr & Irschik (2008); limit by shooting of the rod with axial strain and without shear, to 12 digits",
    sketch: r"
  |/|==============
  |/|              \        L = 2 m, 0.1 × 0.1 m, E = 207 GPa
                    \
                     | F = 3EI/L² = 1.29375 MN",
    goal: "Tip of 64 cable elements within 2e-8 L of the limit; by extrapolation from 32 and 64, of fourth order, within \
           1e-10 L",
    run,
};

const LENGTH: f64 = 2.0;
/// Displacement of the tip.
const LIMIT: [f64; 2] = [-0.508_537_304_326, -1.207_239_854_550];
const MESHES: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

fn tip(elements: u32) -> Result<[f64; 2], VerificationError> {
    let cantilever = Cantilever {
        element: "cable",
        elements,
        length: LENGTH,
        section: "{ kind = \"rectangle\", height = 0.1, width = 0.1 }",
        material: "{ density = 7800, young = 2.07e11 }",
        gravity: 0.0,
        load: Some("kind = \"force\"\nforce = [0, -1293750, 0]"),
        fix: "section",
        offset: 0.0,
        statics: "first = 0.25\nstop = { rule = \"energy\", tolerance = 1e-11 }",
    };
    let solved = solve(&cantilever.model())?;
    Ok([solved.last("tip.x")? - LENGTH, solved.last("tip.y")?])
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let tips = MESHES.into_iter().map(tip).collect::<Result<Vec<_>, _>>()?;
    let [.., coarse, fine] = tips.as_slice() else { return Err(VerificationError::Missing("meshes".into())) };
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let limit = LIMIT[axis];
        let extrapolated = fine[axis] + (fine[axis] - coarse[axis]) / 15.0;
        findings.compare(format!("u_{name}, 64 elements, m"), fine[axis], limit, LENGTH, 2e-8);
        findings.compare(format!("u_{name}, extrapolated, m"), extrapolated, limit, LENGTH, 1e-10);
    }
    let error = |tip: &[f64; 2]| (tip[0] - LIMIT[0]).hypot(tip[1] - LIMIT[1]) / LENGTH;
    let fourth = |n: u32| [f64::from(n), error(&tips[0]) / f64::from(n).powi(4)];
    findings.plot(
        Plot::new(
            "Error of the tip against the number of elements",
            ["elements", "error / L"],
            vec![
                PlotCurve::line(
                    "ancf",
                    MESHES.iter().zip(&tips).map(|(&n, tip)| [f64::from(n), error(tip)]).collect(),
                ),
                PlotCurve::points("fourth order", MESHES.map(fourth).to_vec()),
            ],
        )
        .with_logarithmic_axes([true, true]),
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
