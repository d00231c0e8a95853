use std::f64::consts::PI;

use crate::problems::models::{ROD, Rod, clamped_section};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Cantilever rolled up by a moment at its end.
pub const PROBLEM: Problem = Problem {
    name: "roll_up",
    title: "Cantilever rolled up by a moment at its end",
    source: "Euler's elastica, closed form; continuum of St. Venant and Kirchhoff with ν = 0 in pure bending: stretch, \
             thickness and curvature of least energy, three equations",
    sketch: r"
                _____
  |/|==========/     \   M     φ = ML/EI = π/4, π/2, π, 2π
                      )        inextensible: a circle of radius EI/M
               \____ /",
    goal: "Linked and quadratic beams of L/d = 2500, 64 elements: tip within 1e-5 L of the circle. With Green's strain a \
           thick section bends further. Relative to a section one length away from the clamp, 64 continuum elements are \
           within 8e-3 of their limit, with an error of at most 0.27 times that of 32; 48 quadratic elements within 1e-5. \
           A cable supports no moments",
    run,
};

/// Returns a rod under a moment, with probes at all tenths of its length.
fn model(formulation: &str, elements: u32, length: f64, section: &str, [young, moment]: [f64; 2]) -> String {
    let probes: String = (1..=10)
        .flat_map(|tenth| [(tenth, "p", 0.0), (tenth, "u", 1e-3)])
        .map(|(tenth, name, offset)| {
            let at = length * f64::from(tenth) / 10.0;
            format!(
                "[[probes]]\nname = \"{name}{tenth}\"\non = {{ body = \"rod\", at = {at:?} }}\noffset = \
                [{offset:?}, 0]\n"
            )
        })
        .collect();
    let rod = Rod { element: formulation, to: [length, 0.0, 0.0], elements, ..ROD };
    format!(
        r#"
        materials.material = {{ density = 8000, young = {young:e} }}
        sections.section = {section}
        {rod}{root}
        [[loads]]
        kind = "moment"
        on = {{ body = "rod", at = "end" }}
        moment = [0, 0, {moment:e}]
        follower = true

        {probes}

        [analysis]
        kind = "statics"
        first = 0.1
        stop = {{ rule = "energy", tolerance = 1e-12 }}
        "#,
        root = clamped_section("rod")
    )
}

/// Solves a nearly inextensible rod with E I = 1.
fn slender(formulation: &str, phi: f64) -> Result<SolvedModel, VerificationError> {
    let diameter: f64 = 4e-4;
    let young = 64.0 / (PI * diameter.powi(4));
    let section = format!("{{ kind = \"circle\", diameter = {diameter:e} }}");
    solve(&model(formulation, 64, 1.0, &section, [young, phi]))
}

/// Section, its second moment of area and its area.
type Shape = (&'static str, f64, f64);

const SQUARE: Shape = ("{ kind = \"rectangle\", height = 0.05, width = 0.05 }", 5.208333333333334e-7, 0.0025);
const CIRCLE: Shape = ("{ kind = \"circle\", diameter = 0.02 }", 7.853981633974483e-9, 3.141592653589793e-4);

/// Name, section, φ, and for the continuum: angle minus φ, x and y.
type Limit = (&'static str, Shape, f64, [f64; 3]);

const LIMITS: [Limit; 3] = [
    ("square L/h = 20", SQUARE, PI, [3.1787640322 - PI, -0.0116541451, 0.6269771869]),
    ("circle L/d = 50", CIRCLE, 0.5 * PI, [1.57132966449 - 0.5 * PI, 0.636344681286, 0.636684158429]),
    ("circle L/d = 50", CIRCLE, 2.0 * PI, [6.31772618396 - 2.0 * PI, 0.0054580371, 9.4272e-5]),
];

/// Returns the angle minus φ and the position of the end, relative to the section one length before it.
///
/// The rod is twice as long, because the clamp prevents the contraction of its section: the bending is not pure there.
fn far_from_the_clamp(
    formulation: &str,
    elements: u32,
    (_, section, phi, _): Limit,
) -> Result<[f64; 3], VerificationError> {
    let young = 193e9;
    let solved = solve(&model(formulation, 2 * elements, 2.0, section.0, [young, phi * young * section.1]))?;
    let at = |name: &str| -> Result<[f64; 2], VerificationError> {
        Ok([solved.last(&format!("{name}.x"))?, solved.last(&format!("{name}.y"))?])
    };
    let [p, u, end, end_u] = [at("p5")?, at("u5")?, at("p10")?, at("u10")?];
    let angle = |p: [f64; 2], u: [f64; 2]| (p[0] - u[0]).atan2(u[1] - p[1]);
    let start = angle(p, u);
    let turned = (angle(end, end_u) - start - phi + PI).rem_euclid(2.0 * PI) - PI;
    let (dx, dy) = (end[0] - p[0], end[1] - p[1]);
    let (sin, cos) = start.sin_cos();
    Ok([turned, dx * cos + dy * sin, dy * cos - dx * sin])
}

fn continuum(findings: &mut Findings) -> Result<(), VerificationError> {
    for limit in LIMITS {
        let (name, _, phi, reference) = limit;
        let coarse = far_from_the_clamp("continuum", 32, limit)?;
        let fine = far_from_the_clamp("continuum", 64, limit)?;
        let what = |part: &str| format!("{part}, continuum, {name}, φ = {}π", phi / PI);
        for (i, part) in ["θ − φ", "x/L", "y/L"].into_iter().enumerate() {
            findings.compare(what(part), fine[i], reference[i], 1.0, 8e-3);
        }
        let found = far_from_the_clamp("quadratic", 48, limit)?;
        for (i, part) in ["θ − φ", "x/L", "y/L"].into_iter().enumerate() {
            let what = format!("{part}, quadratic, {name}, φ = {}π", phi / PI);
            findings.compare(what, found[i], reference[i], 1.0, 1e-5);
        }
        let error = |found: [f64; 3]| (0..3).map(|i| (found[i] - reference[i]).abs()).fold(0.0, f64::max);
        findings.compare(
            what("error of 64 elements by that of 32"),
            error(fine) / error(coarse),
            0.0,
            1.0,
            0.27,
        );
    }
    Ok(())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut curves = Vec::new();
    for formulation in ["linked", "quadratic"] {
        for quarters in [1.0, 2.0, 4.0, 8.0] {
            let phi = quarters * PI / 4.0;
            let solved = slender(formulation, phi)?;
            let what = |axis: &str| format!("{axis}/L, {formulation}, φ = {}π", quarters / 4.0);
            findings.compare(what("x"), solved.last("p10.x")?, phi.sin() / phi, 1.0, 1e-5);
            findings.compare(what("y"), solved.last("p10.y")?, (1.0 - phi.cos()) / phi, 1.0, 1e-5);
            if formulation == "linked" {
                let points = (1..=10)
                    .map(|tenth| {
                        Ok([solved.last(&format!("p{tenth}.x"))?, solved.last(&format!("p{tenth}.y"))?])
                    })
                    .collect::<Result<_, VerificationError>>()?;
                curves.push(PlotCurve::line(format!("ancf, φ = {}π", quarters / 4.0), points));
            }
        }
    }
    continuum(&mut findings)?;
    let circle = |tenth: i32| {
        let (angle, phi) = (2.0 * PI * f64::from(tenth) / 10.0, 2.0 * PI);
        [angle.sin() / phi, (1.0 - angle.cos()) / phi]
    };
    curves.push(PlotCurve::points("circle", (1..=10).map(circle).collect()));
    findings.plot(Plot::new("Shapes under increasing moments", ["x/L", "y/L"], curves).with_equal_scales());
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
