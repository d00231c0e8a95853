use nalgebra::Vector3;

use crate::problems::models::{ROD, Rod, hinge};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Orders of the integrators, and errors of adaptive steps.
pub const PROBLEM: Problem = Problem {
    name: "integrators",
    title: "Orders of the integrators, and errors of adaptive steps",
    source: "Chung & Hulbert (1993), Hilber, Hughes & Taylor (1977) and Arnold & Brüls (2007): second order in coordinates, \
             velocities and multipliers. Observed: log₂ of the ratio of the differences with steps h, h/2, h/4; \
             errors relative to \
             steps of 50 μs",
    sketch: r"
     o=====================   L = 1 m, d = 20 mm, soft, at rest
     hinge      | g",
    goal: "Order 2.0 ± 0.1 of position and velocity of the tip and of the reaction of the hinge. Root mean square errors of \
           adaptive steps between 0.1 and 1 of the tolerance",
    run,
};

/// Returns the model with Young's modulus, retardation time and analysis.
fn model(young: f64, retardation: f64, elements: u32, analysis: &str) -> String {
    let probes: Vec<String> = (0..=4)
        .map(|i| format!(r#"{{ name = "p{i}", on = {{ body = "rod", at = {} }} }}"#, f64::from(i) / 4.0))
        .collect();
    format!(
        r#"
        probes = [{probes}]
        gravity = [0, -9.81, 0]
        materials.material = {{ density = 8030, young = {young}, damping = {{ strain = {retardation} }} }}
        sections.section = {{ kind = "circle", diameter = 0.02 }}
        {rod}{support}
        {analysis}
        "#,
        probes = probes.join(", "),
        rod = Rod { elements, ..ROD },
        support = hinge("hinge", "rod", "start")
    )
}

fn vector(solved: &SolvedModel, prefix: &str) -> Result<Vector3<f64>, VerificationError> {
    let last = |axis: &str| solved.last(&format!("{prefix}{axis}"));
    Ok(Vector3::new(last("x")?, last("y")?, last("z")?))
}

/// Compares the orders of position, velocity and reaction after 0.4 s, by three runs.
fn orders(
    findings: &mut Findings,
    name: &str,
    scheme: &str,
    plot: &mut Plot,
) -> Result<(), VerificationError> {
    let steps = [5e-4, 2.5e-4, 1.25e-4];
    let mut ends = Vec::new();
    for step in steps {
        let analysis = format!(
            r#"
            [output]
            interval = 0.1

            [analysis]
            kind = "dynamics"
            duration = 0.4
            step = {step}
            scheme = {scheme}
            stop = {{ rule = "energy", tolerance = 1e-10 }}
            "#
        );
        let solved = solve(&model(193e9 / 1e5, 1e-3, 1, &analysis))?;
        ends.push([vector(&solved, "p4.")?, vector(&solved, "p4.v")?, vector(&solved, "hinge.f")?]);
    }
    for (i, what) in ["place", "velocity", "force"].iter().enumerate() {
        let differences = [(ends[0][i] - ends[1][i]).norm(), (ends[1][i] - ends[2][i]).norm()];
        let order = (differences[0] / differences[1]).log2();
        findings.compare(format!("{name}, order in {what}"), order, 2.0, 1.0, 0.1);
        let points = vec![[steps[0], differences[0]], [steps[1], differences[1]]];
        plot.curves.push(PlotCurve::line(format!("{name}, {what}"), points));
    }
    Ok(())
}

/// Returns the positions of five points at 20 instants.
fn positions(step: &str) -> Result<Vec<[Vector3<f64>; 5]>, VerificationError> {
    let analysis = format!(
        r#"
        [output]
        interval = 0.05

        [analysis]
        kind = "dynamics"
        duration = 1
        step = {step}
        scheme = {{ spectral_radius = 0.8 }}
        "#
    );
    let solved = solve(&model(193e9 / 1e3, 0.0, 2, &analysis))?;
    let mut positions = vec![[Vector3::zeros(); 5]; solved.column("t")?.len()];
    for i in 0..5 {
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            for (position, &x) in positions.iter_mut().zip(solved.column(&format!("p{i}.{name}"))?) {
                position[i][axis] = x;
            }
        }
    }
    Ok(positions)
}

/// Returns the maximum root mean square distance, relative to the length of one, by Simpson's rule.
fn error(ours: &[[Vector3<f64>; 5]], exact: &[[Vector3<f64>; 5]]) -> f64 {
    let weights = [1.0, 4.0, 2.0, 4.0, 1.0].map(|weight| weight / 12.0);
    let distances = ours.iter().zip(exact).map(|(ours, exact)| {
        let squares =
            ours.iter().zip(exact).zip(weights).map(|((a, b), weight)| weight * (a - b).norm_squared());
        squares.sum::<f64>().sqrt()
    });
    distances.fold(0.0, f64::max)
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let axes = ["h, s", "difference in m, m/s, N"];
    let mut plot = Plot::new("Differences between steps h and h/2 after 0.4 s", axes, Vec::new())
        .with_logarithmic_axes([true, true]);
    for (name, scheme) in [
        ("generalized-α, 0.8", "{ spectral_radius = 0.8 }"),
        ("generalized-α, 0.5", "{ spectral_radius = 0.5 }"),
        ("HHT, −0.1", "{ alpha = -0.1 }"),
    ] {
        orders(&mut findings, name, scheme, &mut plot)?;
    }
    findings.plot(plot);
    let exact = positions("5e-5")?;
    let mut errors = Vec::new();
    for tolerance in [1e-3, 1e-4, 1e-5] {
        let error = error(&positions(&format!("{{ tolerance = {tolerance} }}"))?, &exact);
        findings.compare(format!("error over tolerance {tolerance:e}"), error / tolerance, 0.55, 1.0, 0.45);
        errors.push([tolerance, error]);
    }
    let bound = errors.iter().map(|[tolerance, _]| [*tolerance; 2]).collect();
    findings.plot(
        Plot::new(
            "Errors of adaptive steps over a second, by tolerance",
            ["tolerance", "root mean square error / length"],
            vec![PlotCurve::line("ancf", errors), PlotCurve::points("upper bound", bound)],
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
