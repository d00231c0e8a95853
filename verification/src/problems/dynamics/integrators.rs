use nalgebra::Vector3;

use crate::{Curve, Error, Findings, Plot, Problem, Solved, solve};

/// Orders of the integrators, and what a tolerance of adaptive steps promises.
pub const PROBLEM: Problem = Problem {
    name: "integrators",
    title: "Orders of the integrators, and errors of adaptive steps",
    source: "Chung & Hulbert (1993), Hilber, Hughes & Taylor (1977) and Arnold & Brüls (2007): second order in coordinates, \
             velocities and multipliers. Observed: log₂ of the ratio of the differences at steps h, h/2, h/4; errors against \
             steps of 50 μs",
    sketch: r"
     o=====================   L = 1 m, d = 20 mm, soft, at rest
     hinge      | g",
    goal: "Order 2.0 ± 0.1 in the place and the velocity of the tip and in the force of the hinge. Root mean square errors of \
           adaptive steps between 0.1 and 1 of the tolerance",
    run,
};

/// By Young's modulus, the retardation time and the analysis.
fn model(young: f64, retardation: f64, elements: u32, analysis: &str) -> String {
    let probes: Vec<String> = (0..=4)
        .map(|i| format!(r#"{{ name = "p{i}", on = {{ body = "rod", at = {} }} }}"#, f64::from(i) / 4.0))
        .collect();
    format!(
        r#"
        probes = [{probes}]
        gravity = [0, -9.81, 0]
        materials.soft = {{ density = 8030, young = {young}, damping = {{ strain = {retardation} }} }}
        sections.rod = {{ kind = "circle", diameter = 0.02 }}

        [[bodies]]
        kind = "beam"
        name = "rod"
        from = [0, 0, 0]
        to = [1, 0, 0]
        elements = {elements}
        section = "rod"
        material = "soft"

        [[joints]]
        kind = "revolute"
        name = "hinge"
        a = {{ body = "rod", at = "start" }}
        axis = [0, 0, 1]

        {analysis}
        "#,
        probes = probes.join(", ")
    )
}

fn vector(solved: &Solved, prefix: &str) -> Result<Vector3<f64>, Error> {
    let last = |axis: &str| solved.last(&format!("{prefix}{axis}"));
    Ok(Vector3::new(last("x")?, last("y")?, last("z")?))
}

/// Ends of a swing of 0.4 s in three runs, of place, velocity and force.
fn orders(findings: &mut Findings, name: &str, scheme: &str, plot: &mut Plot) -> Result<(), Error> {
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
        plot.curves.push(Curve::line(format!("{name}, {what}"), points));
    }
    Ok(())
}

/// Places of five points at 20 instants.
fn places(step: &str) -> Result<Vec<[Vector3<f64>; 5]>, Error> {
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
    let mut places = vec![[Vector3::zeros(); 5]; solved.column("t")?.len()];
    for i in 0..5 {
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            for (place, &x) in places.iter_mut().zip(solved.column(&format!("p{i}.{name}"))?) {
                place[i][axis] = x;
            }
        }
    }
    Ok(places)
}

/// The largest root mean square distance over the length, which is one, by Simpson's rule.
fn error(ours: &[[Vector3<f64>; 5]], exact: &[[Vector3<f64>; 5]]) -> f64 {
    let weights = [1.0, 4.0, 2.0, 4.0, 1.0].map(|weight| weight / 12.0);
    let distances = ours.iter().zip(exact).map(|(ours, exact)| {
        let squares =
            ours.iter().zip(exact).zip(weights).map(|((a, b), weight)| weight * (a - b).norm_squared());
        squares.sum::<f64>().sqrt()
    });
    distances.fold(0.0, f64::max)
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut plot = Plot {
        title: "Differences between steps h and h/2 after 0.4 s".into(),
        axes: ["h, s".into(), "difference in m, m/s, N".into()],
        logarithmic: [true, true],
        ..Plot::default()
    };
    for (name, scheme) in [
        ("generalized-α, 0.8", "{ spectral_radius = 0.8 }"),
        ("generalized-α, 0.5", "{ spectral_radius = 0.5 }"),
        ("HHT, −0.1", "{ alpha = -0.1 }"),
    ] {
        orders(&mut findings, name, scheme, &mut plot)?;
    }
    findings.plots.push(plot);
    let exact = places("5e-5")?;
    let mut errors = Vec::new();
    for tolerance in [1e-3, 1e-4, 1e-5] {
        let error = error(&places(&format!("{{ tolerance = {tolerance} }}"))?, &exact);
        findings.compare(format!("error over tolerance {tolerance:e}"), error / tolerance, 0.55, 1.0, 0.45);
        errors.push([tolerance, error]);
    }
    let promised = errors.iter().map(|[tolerance, _]| [*tolerance; 2]).collect();
    findings.plots.push(Plot {
        title: "Errors of adaptive steps over a second, by tolerance".into(),
        axes: ["tolerance".into(), "root mean square error over the length".into()],
        logarithmic: [true, true],
        curves: vec![Curve::line("ours", errors), Curve::points("promised at most", promised)],
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
