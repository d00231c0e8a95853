//! Strips and tubes of incompressible rubber.

use std::f64::consts::FRAC_PI_2;

use super::sphere::planes;
use crate::problems::shear_shells::mesh::{MeshModel, isotropic, probe};
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
    goal: "Stretches within 1e-8 for the sheet, which has uniform strains, also for distorted shear-deformable elements, and within 1e-3 for a quarter of the \
           tube with 8 elements",
    run: rubber,
}];

/// Thickness.
const H: f64 = 0.001;

const MEMBRANE: &str = "membrane = { law = \"neo_hookean\" }\n";

fn body(surface: &str, elements: [u32; 2], at: [f64; 2]) -> String {
    format!(
        "analysis = {{ kind = \"statics\" }}\nmaterials.m = {{ young = 3, poisson = 0.3, density = 1 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = {elements:?}\nthickness = {H:?}\nmaterial = \"m\"\n\
         {MEMBRANE}surface = {{ {surface} }}\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {at:?} }}\n"
    )
}

/// Stretches of a thin square under forces per length along x and y.
fn thin_sheet(forces: [f64; 2]) -> Result<[f64; 2], VerificationError> {
    let surface = "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]";
    let text = body(surface, [2, 2], [1.0, 1.0]);
    sheet(text, ["u_start", "v_start", "u_end", "v_end"], forces)
}

/// Stretches of a square of distorted quadrilaterals or triangles with transverse shear.
fn distorted_sheet(are_triangles: bool, forces: [f64; 2]) -> Result<[f64; 2], VerificationError> {
    let map = |[u, v]: [f64; 2]| {
        let inner = u * (1.0 - u) * v * (1.0 - v);
        [[u + (1.3 * v - 0.4) * inner, v + (0.9 - 1.7 * u) * inner, 0.0], [0.0, 0.0, 1.0]]
    };
    let mesh = MeshModel::grid([3, 3], H, isotropic([3.0, 0.3, 1.0]), map).divided(|_| are_triangles);
    let mesh = MeshModel { keys: MEMBRANE.into(), ..mesh };
    let text = format!("analysis = {{ kind = \"statics\" }}\n{mesh}{}", probe("p", "p11"));
    sheet(text, ["u0", "v0", "u1", "v1"], forces)
}

/// Stretches of a square with the named edges left, front, right and back.
fn sheet(
    mut text: String,
    [left, front, right, back]: [&str; 4],
    forces: [f64; 2],
) -> Result<[f64; 2], VerificationError> {
    text += &planes(&[left, front]);
    for (edge, force) in [(right, [forces[0], 0.0, 0.0]), (back, [0.0, forces[1], 0.0])] {
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
    text += &planes(&["u_start", "u_end", "v_start", "v_end"]);
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
        let [length, width] = thin_sheet([H * uniaxial, 0.0])?;
        found.compare(format!("length, uniaxial, λ = {stretch}"), length, stretch, stretch, 1e-8);
        found.compare(format!("width, uniaxial, λ = {stretch}"), width, stretch.powf(-0.5), 1.0, 1e-8);
        let [x, y] = thin_sheet([H * equal; 2])?;
        found.compare(format!("length, both directions, λ = {stretch}"), x, stretch, stretch, 1e-8);
        found.compare(format!("width, both directions, λ = {stretch}"), y, stretch, stretch, 1e-8);
        let radius = tube(H * pressure)?;
        found.compare(format!("radius of the tube, λ = {stretch}"), radius, stretch, stretch, 1e-3);
        for (list, point) in points.iter_mut().zip([[length, uniaxial], [x, equal], [radius, pressure]]) {
            list.push(point);
        }
    }
    let stretch = 6.0_f64;
    for (are_triangles, name) in [(false, "quadrilaterals"), (true, "triangles")] {
        let [length, _] = distorted_sheet(are_triangles, [H * (stretch - stretch.powi(-2)), 0.0])?;
        found.compare(format!("length, uniaxial, λ = 6, {name}"), length, stretch, stretch, 1e-8);
        let [length, _] = distorted_sheet(are_triangles, [H * (stretch - stretch.powi(-5)); 2])?;
        found.compare(format!("length, both directions, λ = 6, {name}"), length, stretch, stretch, 1e-8);
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
