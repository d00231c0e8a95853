//! Beams and cables bonded to sheets and shells along lines.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::model::{Edge, Element, Sheet};
use crate::problems::models::Convergence;
use crate::problems::shear_shells::mesh::{self, MeshModel, isotropic};
use crate::reference::root;
use crate::{Findings, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "bonded_bar",
        title: "Strip and beam of the same width, bonded to one bar",
        source: "Euler-Bernoulli bar of both heights: w = F L³/(3 E I), f = 1.8751² √(E I/ρA)/(2π L²) in both directions. ν = 0",
        sketch: r"
      |=====================  strip
      |#####################  beam below, bonded: one bar of 2 h
                           ↓ F",
        goal: "Deflection with 4 thin elements within 1e-4, with 32 shear-deformable ones within 0.1 %; two frequencies within 0.1 and 0.5 %",
        run: bonded,
    },
    Problem {
        name: "ring_stiffened_cylinder",
        title: "Cylinder with a ring outside under internal pressure",
        source: "Timoshenko & Woinowsky-Krieger (1959), section 116, method: the ring is a radial spring E A/(R (R + e)) per length of the \
                 circumference, and the shell a beam on an elastic foundation: w = p R²/(E h)/(1 + A β R/(2 h (R + e))), β⁴ = 3 (1 − ν²)/(R h)²",
        sketch: r"
                 □               ring of area A, its axis at R + e
      -----------+-----------    radius R, thickness h = R/100
        ↑    ↑    p   ↑    ↑
      - · - · - · - · - · - ·",
        goal: "Radial displacement below the ring on a quarter within 5e-4 with 32 × 16 thin elements, 0.5 % with 64 × 16 shear-deformable ones",
        run: ring,
    },
    Problem {
        name: "stiffened_plate",
        title: "Frequencies of a simply supported plate with a rib in its middle surface",
        source: "w = sin(π x/a) Y(y) with Y'''' of the plate: 2 D Y''' + (E I k⁴ − ρA ω²) Y = 0 at the rib for bending (a rod without shear), \
                 −2 D Y'' + (G J k² − ρI_p ω²) Y' = 0 for torsion, k = π/a. ν = 0.3",
        sketch: r"
      +-----------------+
      |                 |
      |=================|   rib along the middle line
      |                 |
      +-----------------+",
        goal: "Lowest frequency with bending of the rib and lowest with its torsion, within 0.05 % with 12 x 12 thin elements, 1 % with 24 x 24 \
               shear-deformable ones",
        run: plate,
    },
];

/// Section `r` of the rib, as text before the lists of a model.
fn section(keys: &str) -> String {
    format!("sections.r = {{ {keys} }}\n")
}

/// Beam or cable `rib` of the section `r` with its bond to the shell `s`, as text. `line` has the keys of the axis.
fn rib(kind: &str, line: &str, elements: usize, on: &str) -> String {
    let formulation = if kind == "beam" { "formulation = \"linked\"\n" } else { "" };
    format!(
        "[[bodies]]\nkind = \"{kind}\"\nname = \"rib\"\n{line}elements = {elements}\n{formulation}\
         section = \"r\"\nmaterial = \"m\"\n[[joints]]\nkind = \"bond\"\nname = \"bond\"\n\
         a = {{ body = \"rib\", at = \"start\" }}\nb = {on}\n"
    )
}

const HIGH: f64 = 0.01;

/// Strip of unit length with a beam below it, both of square section.
fn bar(element: Element, n: usize) -> (Sheet, String) {
    let sheet = Sheet {
        element,
        corner: [0.0; 3],
        sides: [[1.0, 0.0, 0.0], [0.0, HIGH, 0.0]],
        elements: [n, if element == Element::Thin { 1 } else { 2 }],
        thickness: HIGH,
        material: isotropic([1.0, 0.0, 1.0]),
        keys: String::new(),
    };
    let (y, z) = (0.5 * HIGH, -HIGH);
    let line = format!("from = [0, {y:?}, {z:?}]\nto = [1, {y:?}, {z:?}]\n");
    let section = section(&format!("kind = \"rectangle\", height = {HIGH:?}, width = {HIGH:?}"));
    let rib = rib("beam", &line, n, &sheet.corner([0, 0]));
    let clamp = "[[joints]]\nkind = \"clamp\"\nname = \"wall\"\na = { body = \"rib\", at = \"start\" }\n";
    let text = section + &sheet.body() + &sheet.support(Edge::Left, "clamped") + &rib + clamp;
    (sheet, text)
}

fn bonded() -> Result<Findings, VerificationError> {
    let (force, mut convergence) = (1e-15, Convergence::default());
    let stiffness = |height: f64, width: f64| width * height.powi(3) / 12.0;
    let [down, aside] = [stiffness(2.0 * HIGH, HIGH), stiffness(HIGH, 2.0 * HIGH)];
    let frequency = |stiffness: f64| 1.875_104_f64.powi(2) * (stiffness / (2.0 * HIGH * HIGH)).sqrt() / TAU;
    for (element, meshes, tolerances) in
        [(Element::Thin, [1, 2, 4], [1e-4, 1e-3]), (Element::Shear, [8, 16, 32], [1e-3, 5e-3])]
    {
        let name = element.name();
        let exact = 1.0 / (3.0 * down);
        convergence.case(format!("{name}, deflection"), &meshes, (exact, tolerances[0]), |n| {
            let (sheet, text) = bar(element, n as usize);
            let load = format!(
                "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"{}\"\nforce = [0, 0, {:e}]\n",
                sheet.edge(Edge::Right),
                -force / HIGH
            );
            let probe = sheet.probe("end", [1, 0]);
            Ok(-solve(&format!("{text}{load}{probe}[analysis]\nkind = \"statics\"\n"))?.last("end.z")?
                / force)
        })?;
        for (k, (direction, stiffness)) in [("along y", aside), ("along z", down)].into_iter().enumerate() {
            let name = format!("{name}, frequency {direction}");
            convergence.case(name, &meshes, (frequency(stiffness), tolerances[1]), |n| {
                let (_, text) = bar(element, n as usize);
                Ok(solve(&format!("{text}[analysis]\nkind = \"modes\"\ncount = 2\n"))?.column("frequency")?
                    [k])
            })?;
        }
    }
    Ok(convergence.finish("elements along the bar"))
}

const THICK: f64 = 0.01;
const POISSON: f64 = 0.3;
/// Half of the length of the cylinder, beyond which the ring has no influence.
const HALF: f64 = 0.6;
/// Side of the square section of the ring, and the distance of its axis from the middle surface.
const SIDE: f64 = 0.02;
const OUTSIDE: f64 = 0.015;

/// Quarter of a cylinder of unit radius about the x-axis with E = 1 and a ring at x = 0, under the pressure p.
fn stiffened_cylinder(element: Element, along: usize, pressure: f64) -> String {
    let around = along / if element == Element::Thin { 2 } else { 4 };
    let material = isotropic([1.0, POISSON, 1.0]);
    let (body, [low, a, b], place) = if element == Element::Thin {
        let text = format!(
            "materials.m = {{ {material} }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [{around}, {along}]\n\
             thickness = {THICK:?}\nmaterial = \"m\"\nsurface = {{ kind = \"revolved\", from = [{:?}, 0, 1], to = [{HALF:?}, 0, 1], \
             center = [0, 0, 0], axis = [1, 0, 0], angle = {FRAC_PI_2:?} }}\n",
            -HALF
        );
        let place = "{ body = \"s\", at = [0, 0.5] }".to_owned();
        (text, ["v_start", "u_start", "u_end"], place)
    } else {
        let shell = MeshModel::grid([along, around], THICK, material, |[u, v]| {
            let (sin, cos) = (FRAC_PI_2 * v).sin_cos();
            [[HALF * (2.0 * u - 1.0), sin, cos], [0.0, sin, cos]]
        });
        let place = "{ body = \"s\", at = { point = \"ring\" } }".to_owned();
        (shell.with_point("ring", [0.0, 0.0, 1.0]).to_string(), ["u0", "v0", "v1"], place)
    };
    // The other end is free along the axis.
    let guide = mesh::edge(low, "\"guided\"\naxes = [\"x\"]");
    let supports = [a, b].map(|e| mesh::edge(e, "\"symmetry\"")).concat();
    // The thin shell turns from z to −y.
    let (r, side) = (1.0 + OUTSIDE, if element == Element::Thin { -1.0 } else { 1.0 });
    let (half, line) = (0.5_f64.sqrt() * r, "shape = { kind = \"arc\", through = ");
    let line = format!(
        "from = [0, 0, {r:?}]\nto = [0, {:?}, 0]\n{line}[0, {:?}, {half:?}] }}\n",
        side * r,
        side * half
    );
    let section = section(&format!("kind = \"rectangle\", height = {SIDE:?}, width = {SIDE:?}"));
    let ring = rib("beam", &line, around, &place);
    // The positive side of both surfaces is outside.
    let load = format!("[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {pressure:e}\n");
    let probe = format!("[[probes]]\nname = \"p\"\non = {place}\n[analysis]\nkind = \"statics\"\n");
    format!("{section}{body}{supports}{guide}{ring}{load}{probe}")
}

fn ring() -> Result<Findings, VerificationError> {
    let (pressure, mut convergence) = (1e-9, Convergence::default());
    let decay = (3.0 * (1.0 - POISSON * POISSON)).powf(0.25) / THICK.sqrt();
    let area = SIDE * SIDE;
    let exact = 1.0 / THICK / (1.0 + area * decay / (2.0 * THICK * (1.0 + OUTSIDE)));
    for (element, meshes, tolerance) in
        [(Element::Thin, [8, 16, 32], 5e-4), (Element::Shear, [16, 32, 64], 5e-3)]
    {
        convergence.case(element.name(), &meshes, (exact, tolerance), |n| {
            let text = stiffened_cylinder(element, n as usize, pressure);
            Ok((solve(&text)?.last("p.z")? - 1.0) / pressure)
        })?;
    }
    Ok(convergence.finish("elements along the axis"))
}

/// Diameter of the rib of the plate.
const DIAMETER: f64 = 0.03;

/// Lowest circular frequencies of the plate with one half-wave along the rib, for E = ρ = a = 1: with bending of the rib and with its
/// torsion.
fn plate_frequencies() -> [f64; 2] {
    let stiffness = THICK.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    let (area, inertia) = (PI * DIAMETER.powi(2) / 4.0, PI * DIAMETER.powi(4) / 64.0);
    let (shear, k, b) = (0.5 / (1.0 + POISSON), PI, 0.5);
    // Y = sin β(b − y) + c sinh α(b − y) is zero at the edge, as its second derivative.
    let roots = |omega: f64| {
        let of_plate = omega * (THICK / stiffness).sqrt();
        [(of_plate + k * k).sqrt(), (of_plate - k * k).sqrt()]
    };
    let bending = |omega: f64| {
        let [alpha, beta] = roots(omega);
        let c = -beta * (beta * b).cos() / (alpha * (alpha * b).cosh());
        let third = beta.powi(3) * (beta * b).cos() - c * alpha.powi(3) * (alpha * b).cosh();
        let value = (beta * b).sin() + c * (alpha * b).sinh();
        2.0 * stiffness * third + (inertia * k.powi(4) - area * omega * omega) * value
    };
    let torsion = |omega: f64| {
        let [alpha, beta] = roots(omega);
        let c = -(beta * b).sin() / (alpha * b).sinh();
        let second = -beta * beta * (beta * b).sin() + c * alpha * alpha * (alpha * b).sinh();
        let slope = -beta * (beta * b).cos() - c * alpha * (alpha * b).cosh();
        -2.0 * stiffness * second + 2.0 * inertia * (shear * k * k - omega * omega) * slope
    };
    // Frequencies of the plate without rib and with an edge that is clamped at it enclose that with torsion.
    let of_plate = |m: f64| (m * m + 1.0) * PI * PI * (stiffness / THICK).sqrt();
    [
        root(bending, of_plate(1.0) * 1.001, of_plate(2.0) * 0.999),
        root(torsion, of_plate(2.0) * 0.9, of_plate(2.0) * 1.35),
    ]
}

fn plate() -> Result<Findings, VerificationError> {
    let mut convergence = Convergence::default();
    let exact = plate_frequencies().map(|omega| omega / TAU);
    let names = ["bending of the rib", "torsion of the rib"];
    for (element, meshes, tolerance) in
        [(Element::Thin, [4, 8, 12], 5e-4), (Element::Shear, [8, 16, 24], 1e-2)]
    {
        for (k, kind) in ["cable", "beam"].into_iter().enumerate() {
            let name = format!("{}, {}", element.name(), names[k]);
            convergence.case(name, &meshes, (exact[k], tolerance), |n| {
                let sheet = Sheet {
                    element,
                    corner: [0.0; 3],
                    sides: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
                    elements: [n as usize; 2],
                    thickness: THICK,
                    material: isotropic([1.0, POISSON, 1.0]),
                    keys: String::new(),
                };
                let edges = [Edge::Left, Edge::Right, Edge::Front, Edge::Back];
                let supports = edges.map(|edge| sheet.guide(edge, "\"x\", \"y\", \"z\"")).concat();
                let line = "from = [0, 0.5, 0]\nto = [1, 0.5, 0]\n";
                let section = section(&format!("kind = \"circle\", diameter = {DIAMETER:?}"));
                let rib = rib(kind, line, n as usize, &sheet.corner([0, 0]));
                let modes = "[analysis]\nkind = \"modes\"\ncount = 3\n";
                let found = solve(&format!("{section}{}{supports}{rib}{modes}", sheet.body()))?;
                let apart = |f: &f64| (f - exact[k]).abs();
                let nearest =
                    found.column("frequency")?.iter().copied().min_by(|a, b| apart(a).total_cmp(&apart(b)));
                Ok(nearest.unwrap_or(f64::NAN))
            })?;
        }
    }
    Ok(convergence.finish("elements along an edge"))
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
