//! Strips and tubes of incompressible rubber.

use std::f64::consts::FRAC_PI_2;

use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[Problem {
    name: "rubber_membranes",
    title: "Sheet in tension and tube under pressure of incompressible rubber: `membrane`",
    source: "Neo-Hookean law. Uniaxial: F = G h b (λ - λ⁻²), width b λ^(-1/2). Equal in both directions: F = G h b (λ - λ⁻⁵). Tube with fixed ends: p = \
             G h (1 - λ⁻⁴)/R",
    sketch: r"
   +------+ -> F         b = 1, R = 1, h = 0.001, G = E/3 = 1
   |      |              stretch λ up to 4
   +------+",
    goal: "Stretches within 1e-8 for the sheet, which has uniform strains, and within 1e-3 for a quarter of the tube with 8 elements",
    run: rubber,
}];

/// Thickness.
const H: f64 = 0.001;

fn support(edge: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\ncondition = \"symmetry\"\n"
    )
}

fn body(surface: &str, elements: [u32; 2], at: [f64; 2]) -> String {
    format!(
        "analysis = {{ kind = \"statics\" }}\nmaterials.m = {{ young = 3, poisson = 0.3, density = 1 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = {elements:?}\nthickness = {H:?}\nmaterial = \"m\"\n\
         membrane = {{ law = \"neo_hookean\" }}\nsurface = {{ {surface} }}\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {at:?} }}\n"
    )
}

/// Stretches of a square under forces per length along x and y.
fn sheet(forces: [f64; 2]) -> Result<[f64; 2], VerificationError> {
    let surface = "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]";
    let mut text = body(surface, [2, 2], [1.0, 1.0]) + &support("u_start") + &support("v_start");
    for (edge, force) in [("u_end", [forces[0], 0.0, 0.0]), ("v_end", [0.0, forces[1], 0.0])] {
        text += &format!(
            "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"{edge}\"\nforce = {force:?}\n"
        );
        text += &format!(
            "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
             condition = \"guided\"\naxes = [\"z\"]\n"
        );
    }
    let solved = solve(&text)?;
    Ok([solved.last("p.x")?, solved.last("p.y")?])
}

/// Stretch of a tube under a pressure.
fn tube(pressure: f64) -> Result<f64, VerificationError> {
    let surface = format!(
        "kind = \"revolved\", from = [1, 0, 0], to = [1, 0, 0.5], center = [0, 0, 0], axis = [0, 0, 1], angle = {FRAC_PI_2:?}"
    );
    let mut text = body(&surface, [8, 1], [0.0, 0.0]);
    text.extend(["u_start", "u_end", "v_start", "v_end"].map(support));
    text += &format!("[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {pressure:?}\n");
    solve(&text)?.last("p.x")
}

fn rubber() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let mut points = [Vec::new(), Vec::new(), Vec::new()];
    for stretch in [1.5, 2.0, 4.0_f64] {
        let uniaxial = stretch - stretch.powi(-2);
        let equal = stretch - stretch.powi(-5);
        let pressure = 1.0 - stretch.powi(-4);
        let [length, width] = sheet([H * uniaxial, 0.0])?;
        found.compare(format!("length, uniaxial, λ = {stretch}"), length, stretch, stretch, 1e-8);
        found.compare(format!("width, uniaxial, λ = {stretch}"), width, stretch.powf(-0.5), 1.0, 1e-8);
        let [x, y] = sheet([H * equal; 2])?;
        found.compare(format!("length, both directions, λ = {stretch}"), x, stretch, stretch, 1e-8);
        found.compare(format!("width, both directions, λ = {stretch}"), y, stretch, stretch, 1e-8);
        let radius = tube(H * pressure)?;
        found.compare(format!("radius of the tube, λ = {stretch}"), radius, stretch, stretch, 1e-3);
        for (list, point) in points.iter_mut().zip([[length, uniaxial], [x, equal], [radius, pressure]]) {
            list.push(point);
        }
    }
    let exact = |force: &dyn Fn(f64) -> f64| {
        (0..=60).map(|k| 1.0 + 0.05 * f64::from(k)).map(|x| [x, force(x)]).collect()
    };
    let [uniaxial, equal, tube] = points;
    let curves = vec![
        PlotCurve::line("uniaxial", exact(&|x| x - x.powi(-2))),
        PlotCurve::line("both directions", exact(&|x| x - x.powi(-5))),
        PlotCurve::line("tube", exact(&|x| 1.0 - x.powi(-4))),
        PlotCurve::points("uniaxial, computed", uniaxial),
        PlotCurve::points("both directions, computed", equal),
        PlotCurve::points("tube, computed", tube),
    ];
    found.plot(Plot::new("Rubber membranes", ["stretch λ", "F/(G h b), p R/(G h)"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
