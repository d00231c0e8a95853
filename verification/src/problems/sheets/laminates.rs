//! Laminates: coupling of stretching, bending and twisting, and deflections and frequencies of simply supported plates.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::model::{Edge, Element, Sheet};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "laminate_coupling",
        title: "Coupling of stretching, bending and twisting of laminates",
        source: "Classical theory of laminates: N = A ε + B κ, M = B ε + D κ, κ = −w,αβ (Jones 1999). E_L = 25, E_T = 1, G_LT = 0.5, \
                 ν = 0.25, h = 1",
        sketch: r"
      <--+-----+-->  N or M     one element, 1 × 1, free to bend and to twist
         |     |                0/90, 45/−45, 30/−30/−30/30, 30
      <--+-----+-->",
        goal: "Strains and curvatures of one element of both kinds within 1e-9, by the difference of a small load and its opposite",
        run: coupling,
    },
    Problem {
        name: "cylindrical_bending",
        title: "Cylindrical bending of laminates under a sinusoidal load",
        source: "Pagano (1969). First-order theory with κ = 5/6 and plies in plane stress: 100 E_T w h³/(q L⁴), for a thin plate without \
                 transverse shear. E_L = 25, E_T = 1, G_LT = 0.5, G_TT = 0.2, ν = 0.25",
        sketch: r"
        q sin(πx/L)
      =================   plane strain, L/h = 4, 10, 20, 50
      ^               ^   0/90/0, 0/90, 90/0/90",
        goal: "Deflection of the middle with 16 shear-deformable elements on half of the length within 0.1 %, with 8 thin ones of the thin \
               plate within 1e-5",
        run: cylindrical,
    },
    Problem {
        name: "cross_ply_plates",
        title: "Square cross-ply plates under sinusoidal and uniform loads",
        source: "Navier solution of the first-order theory with κ = 5/6, and of the classical theory for 0/90/0: w = q a⁴/(π⁴ D), \
                 ω² = π⁴ D/(ρh a⁴), D = D₁₁ + 2 D₁₂ + 4 D₆₆ + D₂₂. E_L = 25, E_T = 1, G_LT = 0.5, G_TT = 0.2, ν = 0.25. \
                 Reddy: 10.854 for E_L = 40, G_LT = 0.6, G_TT = 0.5",
        sketch: r"
      +--------+
      |        |   a/h = 4, 10, 100; edges supported along w and the tangent
      +--------+   0/90/0, 0/90, 0/90/90/0",
        goal: "A quarter with 12 × 12 shear-deformable elements: deflections and frequency within 0.4 %; with 6 × 6 thin ones within \
               1e-4 of the classical theory",
        run: square,
    },
];

/// Fibres of a high modulus; thin shells have no transverse shear modulus.
fn material(element: Element) -> String {
    let shear = if element == Element::Shear { ", transverse_shear = 0.2" } else { "" };
    format!("young = 25, poisson = 0.25, density = 1, orthotropic = {{ young = 1, shear = 0.5{shear} }}")
}

/// Plate of equal plies, of unit thickness.
fn plate(element: Element, sides: [f64; 2], elements: [usize; 2], degrees: &[f64]) -> Sheet {
    let layers: Vec<String> =
        degrees.iter().map(|angle| format!("{{ angle = {:?} }}", angle.to_radians())).collect();
    Sheet {
        element,
        corner: [0.0; 3],
        sides: [[sides[0], 0.0, 0.0], [0.0, sides[1], 0.0]],
        elements,
        thickness: 1.0,
        material: material(element),
        keys: format!("fibre_axis = [1, 0, 0]\nlayers = [{}]\n", layers.join(", ")),
    }
}

/// Rotation of a probe, for small angles.
fn rotation(solved: &SolvedModel, probe: &str, axis: usize) -> Result<f64, VerificationError> {
    Ok(2.0 * solved.last(&format!("{probe}.e{axis}"))?)
}

/// Strains ε_x, ε_y, γ_xy and curvatures κ_x, κ_y, κ_xy of an element of 1 × 1 under a force or a moment per length of its ends.
fn strains(element: Element, degrees: &[f64], load: &str, size: f64) -> Result<[f64; 6], VerificationError> {
    let sheet = plate(element, [1.0, 1.0], [1, 1], degrees);
    let ends: String = [(Edge::Right, size), (Edge::Left, -size)]
        .map(|(edge, size)| {
            let value =
                if load == "force" { format!("[{size:e}, 0, 0]") } else { format!("[0, {size:e}, 0]") };
            let edge = sheet.edge(edge);
            format!("[[loads]]\nkind = \"edge_{load}\"\nbody = \"s\"\nedge = \"{edge}\"\n{load} = {value}\n")
        })
        .concat();
    let probes: String = [("a", [0, 0]), ("b", [1, 0]), ("c", [0, 1]), ("d", [1, 1])]
        .map(|(name, at)| sheet.probe(name, at) + "record = [\"motion\", \"rotation\"]\n")
        .concat();
    let solved = solve(&format!(
        "{}{}{}{}{ends}{probes}[analysis]\nkind = \"statics\"\nstop = {{ rule = \"energy\", tolerance = 1e-13 }}\n",
        sheet.body(),
        sheet.pin("pin a", [0, 0], "\"x\", \"y\", \"z\""),
        sheet.pin("pin b", [1, 0], "\"y\", \"z\""),
        sheet.pin("pin c", [0, 1], "\"z\"")
    ))?;
    Ok([
        solved.last("b.x")? - 1.0,
        solved.last("c.y")? - 1.0,
        solved.last("c.x")?,
        rotation(&solved, "b", 2)? - rotation(&solved, "a", 2)?,
        rotation(&solved, "a", 1)? - rotation(&solved, "c", 1)?,
        // Three corners are held: the fourth one moves by the twist alone.
        -2.0 * solved.last("d.z")?,
    ])
}

/// Laminate, plies, load and its strains and curvatures.
type Coupling = (&'static str, &'static [f64], &'static str, [f64; 6]);

const COUPLINGS: [Coupling; 5] = [
    ("0/90 under N", &[0.0, 90.0], "force", [0.2128, -0.004092307692308, 0.0, 0.5892923076923, 0.0, 0.0]),
    ("0/90 under M", &[0.0, 90.0], "moment", [0.5892923076923, 0.0, 0.0, 2.5536, -0.04910769230769, 0.0]),
    (
        "45/−45 under N",
        &[45.0, -45.0],
        "force",
        [0.604353846154, -0.395646153846, 0.0, 0.0, 0.0, 0.589292307692],
    ),
    (
        "30/−30/−30/30 under M",
        &[30.0, -30.0, -30.0, 30.0],
        "moment",
        [0.0, 0.0, 0.0, 2.518837052403, -3.247950940086, -1.664047791266],
    ),
    ("30 under N", &[30.0], "force", [0.45625, -0.18625, -0.619208163706, 0.0, 0.0, 0.0]),
];

fn coupling() -> Result<Findings, VerificationError> {
    let size = 1e-6;
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for element in [Element::Thin, Element::Shear] {
        for (name, degrees, load, exact) in COUPLINGS {
            let [plus, minus] =
                [strains(element, degrees, load, size)?, strains(element, degrees, load, -size)?];
            let mut points = Vec::new();
            for (k, what) in ["ε_x", "ε_y", "γ_xy", "κ_x", "κ_y", "κ_xy"].into_iter().enumerate() {
                // Finite displacements are even in the load.
                let ours = (plus[k] - minus[k]) / (2.0 * size);
                let what = format!("{what}, {name}, {}", element.name());
                found.compare(what, ours, exact[k], 1.0, 1e-9);
                points.push([(k + 1) as f64, ours]);
            }
            if element == Element::Shear {
                curves.push(PlotCurve::points(name, points));
            }
        }
    }
    let axes = ["1 to 3: strains, 4 to 6: curvatures", "strain or curvature per load"];
    found.plot(Plot::new("Shear-deformable element", axes, curves));
    Ok(found)
}

/// Laminate, its plies, deflections for [`SPANS`] and of the thin plate.
type Span = (&'static str, &'static [f64], [f64; 4], f64);

/// Laminate whose convergence is shown.
const SHOWN: &str = "0/90";
const SPANS: [f64; 4] = [4.0, 10.0, 20.0, 50.0];
const CYLINDRICAL: [Span; 3] = [
    ("0/90/0", &[0.0, 90.0, 0.0], [2.409428538, 0.8136198958, 0.5856472326, 0.5218148869], 0.5096563448),
    ("0/90", &[0.0, 90.0], [4.790003465, 2.966222159, 2.705681973, 2.632730720], 2.618835244),
    ("90/0/90", &[90.0, 0.0, 90.0], [9.038642934, 6.910898077, 6.606934527, 6.521824732], 6.505613343),
];

/// Deflection 100 E_T w h³/(q L⁴) of the middle of a strip, with n elements on half of its length L.
fn strip_deflection(
    element: Element,
    degrees: &[f64],
    span: f64,
    n: usize,
) -> Result<f64, VerificationError> {
    let width = 0.5 * span / n as f64;
    let sheet = plate(element, [0.5 * span, width], [n, 1], degrees);
    let load = 1e-6 / span.powi(3);
    // Forces at equidistant nodes have, of the load, its first term and terms of the order 2n and higher only.
    let forces: String = (1..=n)
        .flat_map(|i| [0, 1].map(|j| (i, j)))
        .map(|(i, j)| {
            let part = if i == n { 0.25 } else { 0.5 };
            let size = load * (FRAC_PI_2 * i as f64 / n as f64).sin() * width * width * part;
            sheet.force([i, j], [0.0, 0.0, size])
        })
        .collect();
    let model = format!(
        "{}{}{}{}{}{forces}{}[analysis]\nkind = \"statics\"\n",
        sheet.body(),
        sheet.guide(Edge::Left, "\"z\""),
        sheet.support(Edge::Right, "symmetry"),
        sheet.support(Edge::Front, "symmetry"),
        sheet.support(Edge::Back, "symmetry"),
        sheet.probe("middle", [1, 0])
    );
    Ok(100.0 * solve(&model)?.last("middle.z")? / (load * span.powi(4)))
}

fn cylindrical() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (name, degrees, deflections, thin) in CYLINDRICAL {
        for (span, exact) in SPANS.into_iter().zip(deflections) {
            let meshes: &[usize] = if name == SHOWN { &[4, 8, 16] } else { &[16] };
            let (mut points, mut ours) = (Vec::new(), f64::NAN);
            for n in meshes {
                ours = strip_deflection(Element::Shear, degrees, span, *n)?;
                points.push([*n as f64, ours / exact]);
            }
            found.compare(format!("{name}, L/h = {span}"), ours, exact, exact, 1e-3);
            if name == SHOWN {
                curves.push(PlotCurve::line(format!("{name}, L/h = {span}"), points));
            }
        }
        let mut points = Vec::new();
        for n in [2, 4, 8] {
            points.push([n as f64, strip_deflection(Element::Thin, degrees, 100.0, n)? / thin]);
        }
        found.compare(format!("{name}, thin"), thin * points[2][1], thin, thin, 1e-5);
        curves.push(PlotCurve::line(format!("{name}, thin"), points));
    }
    let axes = ["elements on half of the length", "ratio"];
    found.plot(Plot::new("Deflection, relative to the exact one", axes, curves));
    Ok(found)
}

/// Laminate, its plies, a/h, deflections under the sinusoidal and the uniform load, and frequency.
type Square = (&'static str, &'static [f64], f64, [f64; 3]);

const SQUARES: [Square; 7] = [
    ("0/90/0", &[0.0, 90.0, 0.0], 4.0, [1.7757508055, 2.65948941, 7.4131278119]),
    ("0/90/0", &[0.0, 90.0, 0.0], 10.0, [0.6693024764, 1.02193277, 12.1628548487]),
    ("0/90/0", &[0.0, 90.0, 0.0], 100.0, [0.4337024922, 0.66969588, 15.1833842680]),
    ("0/90", &[0.0, 90.0], 4.0, [2.1491610924, 3.27094118, 6.6756423119]),
    ("0/90", &[0.0, 90.0], 10.0, [1.2372704396, 1.94686989, 8.9000743731]),
    ("0/90", &[0.0, 90.0], 100.0, [1.0653139165, 1.69797605, 9.6872821686]),
    ("0/90/90/0", &[0.0, 90.0, 90.0, 0.0], 10.0, [0.6627116260, 1.02501845, 12.2272075207]),
];

/// Deflections 100 E_T w h³/(q a⁴) under a sinusoidal and a uniform load, and ω a²/h √(ρ/E_T), of a quarter of n × n elements.
fn quarter(sheet: &Sheet) -> Result<[f64; 3], VerificationError> {
    let (n, side) = (sheet.elements[0], 2.0 * sheet.sides[0][0]);
    let supported = [
        sheet.body(),
        sheet.guide(Edge::Left, "\"y\", \"z\""),
        sheet.guide(Edge::Front, "\"x\", \"z\""),
        sheet.support(Edge::Right, "symmetry"),
        sheet.support(Edge::Back, "symmetry"),
    ]
    .concat();
    let load = 1e-6 / side.powi(3);
    let wave = |i: usize| {
        let weight = if i == n { 0.5 } else { 1.0 };
        weight * (FRAC_PI_2 * i as f64 / n as f64).sin() * 0.5 * side / n as f64
    };
    let forces: String = (1..=n)
        .flat_map(|j| (1..=n).map(move |i| [i, j]))
        .map(|[i, j]| sheet.force([i, j], [0.0, 0.0, load * wave(i) * wave(j)]))
        .collect();
    let uniform = format!("[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, {load:e}]\n");
    let deflection = |loads: &str| -> Result<f64, VerificationError> {
        let probe = sheet.probe("middle", [1, 1]);
        let solved = solve(&format!("{supported}{loads}{probe}[analysis]\nkind = \"statics\"\n"))?;
        Ok(100.0 * solved.last("middle.z")? / (load * side.powi(4)))
    };
    let modes = solve(&format!("{supported}[analysis]\nkind = \"modes\"\ncount = 1\n"))?;
    let frequency = TAU * modes.last("frequency")? * side.powi(2);
    Ok([deflection(&forces)?, deflection(&uniform)?, frequency])
}

/// Deflection and frequency of the classical theory for 0/90/0, in the same units.
fn classical() -> [f64; 2] {
    let ratio = 1.0 - 0.25_f64.powi(2) / 25.0;
    let [along, across, coupled, shear] = [25.0 / ratio, 1.0 / ratio, 0.25 / ratio, 0.5];
    // The middle ply is a 27th part of the bending stiffness; D₁₁ and D₂₂ sum up to that of both moduli.
    let stiffness = (along + across + 2.0 * coupled + 4.0 * shear) / 12.0;
    [100.0 / (PI.powi(4) * stiffness), PI.powi(2) * stiffness.sqrt()]
}

fn square() -> Result<Findings, VerificationError> {
    let (mut found, mut points) = (Findings::default(), [const { Vec::new() }; 3]);
    let quantities = ["sinusoidal load", "uniform load", "frequency"];
    for (row, (name, degrees, side, exact)) in SQUARES.into_iter().enumerate() {
        let ours = quarter(&plate(Element::Shear, [0.5 * side; 2], [12, 12], degrees))?;
        for (k, what) in quantities.into_iter().enumerate() {
            found.compare(format!("{name}, a/h = {side}: {what}"), ours[k], exact[k], exact[k], 4e-3);
            points[k].push([(row + 1) as f64, ours[k] / exact[k]]);
        }
    }
    let ours = quarter(&plate(Element::Thin, [50.0, 50.0], [6, 6], &[0.0, 90.0, 0.0]))?;
    let [deflection, frequency] = classical();
    found.compare("0/90/0, thin: sinusoidal load", ours[0], deflection, deflection, 1e-4);
    found.compare("0/90/0, thin: frequency", ours[2], frequency, frequency, 1e-4);
    let reddy = Sheet {
        material: "young = 40, poisson = 0.25, density = 1, orthotropic = { young = 1, shear = 0.6, transverse_shear = 0.5 }".into(),
        ..plate(Element::Shear, [2.5, 2.5], [12, 12], &[0.0, 90.0, 90.0, 0.0])
    };
    let (ours, exact) = (quarter(&reddy)?[2], 10.85395416861);
    found.compare("0/90/90/0, E_L/E_T = 40, a/h = 5: frequency", ours, exact, exact, 4e-3);
    let curves = quantities.into_iter().zip(points).map(|(what, points)| PlotCurve::points(what, points));
    found.plot(Plot::new("Relative to the Navier solution", ["row of the table", "ratio"], curves.collect()));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
