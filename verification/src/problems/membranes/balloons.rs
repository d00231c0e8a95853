//! Balloons of shear-deformable shells: a sphere of rubber and two discs of a thin sheet.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::sphere::{eighth, planes};
use crate::problems::shear_shells::mesh::{MeshModel, edge, isotropic, probe};
use crate::reference::integral;
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "rubber_balloon",
        title: "Balloon of rubber: pressure beyond its maximum",
        source: "Incompressible neo-Hookean sphere: p = 2 G h/R (λ⁻¹ - λ⁻⁷), with a maximum at λ = 7^(1/6)",
        sketch: r"
     .--.
    ( -> )  p             R = 1, h = 0.001, G = E/3 = 1
     '--'                 an eighth with planes of symmetry, path by arc length",
        goal: "Largest difference of the pressure at the radii of the path up to λ = 2.5, relative to the maximum, within 1 % with 108 quadrilaterals and 4 % with \
               216 triangles; second order in the size of quadrilaterals",
        run: rubber,
    },
    Problem {
        name: "mylar_balloon",
        title: "Mylar balloon: two discs joined at their edges and inflated",
        source: "Paulsen (1994): meridians without strain, no force around. Discs of radius a have the inflated radius r = a/1.3110 and the thickness 1.1981 r",
        sketch: r"
      .-----.             a = 1, p a/(E h) = 0.001
    (    p    )           tension field, a quarter of one disc
      '-----'             planes of symmetry",
        goal: "Radius and thickness within 1 % with 48 and 192 quadrilaterals; 1e-6 of the energy against compression remains",
        run: mylar,
    },
];

/// Thickness of the rubber.
const H: f64 = 1e-3;

/// Pressure p R/(2 G h) of the sphere of rubber.
fn pressure(stretch: f64) -> f64 {
    stretch.recip() - stretch.powi(-7)
}

/// Stretches and pressures p R/(2 G h) along a path.
fn balloon(n: usize, are_triangles: bool) -> Result<Vec<[f64; 2]>, VerificationError> {
    let mesh = eighth(n, H, isotropic([3.0, 0.3, 1.0])).divided(|_| are_triangles);
    let mesh = MeshModel { keys: "membrane = { law = \"neo_hookean\" }\n".into(), ..mesh };
    let solved = solve(&format!(
        "{mesh}{}[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {:?}\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [1, 0, 0] }}\n\
         [analysis]\nkind = \"path\"\nload = 2\npoints = 60\n",
        planes(&["e0", "e1", "e2"]),
        2.0 * H
    ))?;
    solved.points("p.x", "load")
}

fn rubber() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let maximum = pressure(7.0_f64.powf(1.0 / 6.0));
    let largest = |points: &[[f64; 2]]| {
        let near = points.iter().filter(|[stretch, _]| *stretch < 2.5);
        near.map(|[stretch, load]| (load - pressure(*stretch)).abs() / maximum).fold(0.0, f64::max)
    };
    let mut fine = Vec::new();
    for (are_triangles, name, tolerance) in [(true, "triangles", 4e-2), (false, "quadrilaterals", 1e-2)] {
        let coarse = largest(&balloon(3, are_triangles)?);
        fine = balloon(6, are_triangles)?;
        let error = largest(&fine);
        found.compare(
            format!("largest difference of p, relative to its maximum, {name}"),
            error,
            0.0,
            1.0,
            tolerance,
        );
        if !are_triangles {
            found.compare("its order in the size of the elements", (coarse / error).log2(), 2.0, 1.0, 0.5);
        }
    }
    let reached = fine.iter().map(|[stretch, _]| *stretch).fold(0.0, f64::max);
    found.compare(
        "the path passes λ = 2.5: smaller of 2.5 and the largest stretch",
        reached.min(2.5),
        2.5,
        2.5,
        1e-12,
    );
    let exact = (0..=40).map(|k| 1.0 + 0.05 * f64::from(k)).map(|x| [x, pressure(x)]).collect();
    let points = fine.into_iter().filter(|[stretch, _]| *stretch < 3.0).collect();
    let curves = vec![PlotCurve::line("exact", exact), PlotCurve::points("computed", points)];
    found.plot(Plot::new("Balloon of rubber", ["stretch λ", "p R/(2 G h)"], curves));
    Ok(found)
}

/// Quarter of a disc of radius 1 of 3 n² quadrilaterals with a bulge, and the edges `x`, `y` and `rim`.
fn quarter_of_disc(n: usize, thickness: f64, material: String) -> MeshModel {
    const BULGE: f64 = 0.02;
    let on_surface = |x: f64, y: f64| {
        let [dx, dy] = [2.0 * BULGE * x, 2.0 * BULGE * y];
        let length = (1.0 + dx * dx + dy * dy).sqrt();
        [[x, y, BULGE * (1.0 - x * x - y * y)], [dx / length, dy / length, 1.0 / length]]
    };
    let core = |u: f64, v: f64| {
        let (side, corner) = (0.45, 0.38);
        [u * (1.0 - v) * side + u * v * corner, v * (1.0 - u) * side + u * v * corner]
    };
    // Ring from the core to the rim; `turned` for the upper half.
    let ring = |t: f64, s: f64, turned: bool| {
        let ([a, b], (sin, cos)) = (core(1.0, s), (FRAC_PI_4 * s).sin_cos());
        let [x, y] = [a + (cos - a) * t, b + (sin - b) * t];
        if turned { [y, x] } else { [x, y] }
    };
    let inner = move |[u, v]: [f64; 2]| on_surface(core(u, v)[0], core(u, v)[1]);
    let right = move |[u, v]: [f64; 2]| on_surface(ring(u, v, false)[0], ring(u, v, false)[1]);
    let upper = move |[u, v]: [f64; 2]| on_surface(ring(v, u, true)[0], ring(v, u, true)[1]);
    MeshModel::patches(n, thickness, material, &[&inner, &right, &upper])
        .with_edge("x", |p| (p[0].abs() < 1e-12).then_some(p[1]))
        .with_edge("y", |p| (p[1].abs() < 1e-12).then_some(p[0]))
        .with_edge("rim", |p| (p[0].hypot(p[1]) > 1.0 - 1e-9).then_some(p[1].atan2(p[0])))
}

/// Radius and thickness of the balloon of 3 n² elements with p a/(E h) = 0.001, relative to those of Paulsen.
fn balloon_of_discs(n: usize) -> Result<[f64; 2], VerificationError> {
    let (young, thickness) = (1e8, 1e-3);
    let mesh = quarter_of_disc(n, thickness, isotropic([young, 0.3, 1000.0]));
    let keys = "membrane = { tension_field = true, slack = 1e-6 }\n".into();
    let mesh =
        MeshModel { keys, ..mesh }.with_point("top", [0.0, 0.0, 0.02]).with_point("side", [1.0, 0.0, 0.0]);
    let solved = solve(&format!(
        "analysis = {{ kind = \"statics\", unstable = \"follow\" }}\n{mesh}{}{}{}{}[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {:?}\n",
        planes(&["x", "y"]),
        edge("rim", "\"guided\"\naxes = [\"z\"]"),
        probe("top", "top"),
        probe("side", "side"),
        1e-3 * young * thickness
    ))?;
    let [top, side] = [solved.last("top.z")?, solved.last("side.x")?];
    // ∫ dt/√(1 − t⁴) and ∫ t² dt/√(1 − t⁴) from 0 to 1 with t = sin φ.
    let length = integral(|x| (1.0 + x.sin().powi(2)).sqrt().recip(), 0.0, FRAC_PI_2);
    let height = integral(|x| x.sin().powi(2) / (1.0 + x.sin().powi(2)).sqrt(), 0.0, FRAC_PI_2);
    Ok([side * length, top * length / height])
}

fn mylar() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let mut curves = [Vec::new(), Vec::new()];
    for n in [4, 8] {
        let [radius, thickness] = balloon_of_discs(n)?;
        for (curve, size) in curves.iter_mut().zip([radius, thickness]) {
            curve.push([(3 * n * n) as f64, size]);
        }
        found.compare(format!("radius, relative, {} elements", 3 * n * n), radius, 1.0, 1.0, 1e-2);
        found.compare(format!("thickness, relative, {} elements", 3 * n * n), thickness, 1.0, 1.0, 1e-2);
    }
    let [radius, thickness] = curves;
    let curves = vec![PlotCurve::line("radius", radius), PlotCurve::line("thickness", thickness)];
    let title = "Radius and thickness, relative to those of Paulsen";
    found.plot(Plot::new(title, ["number of elements", "size"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
