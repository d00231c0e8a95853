//! Sheets whose thickness or fibre directions vary over the surface.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::{Matrix2, Vector2};

use super::model::{Edge, Element, Sheet};
use crate::problems::models::Convergence;
use crate::problems::shear_shells::mesh::{self, MeshModel, isotropic};
use crate::reference::{integral, root, runge_kutta};
use crate::{Findings, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "tapered_plates",
        title: "Deflection and frequency of tapered cantilever plates",
        source: "Beam of variable section: w = 12 F/E ∫ (L − x)²/h³ dx; (E I w'')'' = ω² ρA w by a Runge-Kutta integration from the free \
                 end, which has the classical 5.315 √(E h₀²/12ρ)/L² (Kirchhoff) of the sharp wedge. ν = 0",
        sketch: r"
      |======-----....     h = h₀ (1 − 0.8 x/L), h₀ = 0.01 L
      |======-----....",
        goal: "Deflection under a force and first frequency with 16 thin elements within 1e-4, with 32 shear-deformable ones within 0.5 %",
        run: tapered,
    },
    Problem {
        name: "conical_plate",
        title: "Annular plate whose thickness grows with the radius",
        source: "Timoshenko & Woinowsky-Krieger (1959), section 67, method: φ'' + 4 φ'/r − (1 − 3ν) φ/r² = −Q/D for D = D₀ r³/b³, with the \
                 exponents of r of the homogeneous equation and −2. a = 0.5, b = 1, ν = 0.3",
        sketch: r"
        q               q
      |###==--     --==###|   outer edge clamped, force q per length of
      |###==--     --==###|   the inner edge, h = h₀ r/b",
        goal: "Deflection of the inner edge with 8 × 8 thin elements on a quarter within 1e-4, with 24 × 24 shear-deformable ones within 0.5 %",
        run: conical,
    },
    Problem {
        name: "circular_fibres",
        title: "Rotating ring with fibres along the circumference",
        source: "Lekhnitskii (1968), cylindrical anisotropy: u = A r^k + B r^−k − ρΩ² r³/(9 Q_r − Q_θ), k² = E_θ/E_r = 25. ν = 0.3, a = 0.5, b = 1",
        sketch: r"
         .--~~--.
        ( (    ) )    fibres by a formula of their axis, or of their angle
         '--..--'     from a fixed axis; a quarter as the model",
        goal: "Displacements of both edges with 8 × 8 thin elements on a quarter within 1e-4, with 32 × 32 shear-deformable ones within 1 %",
        run: circular,
    },
];

/// Replaces the number of a thickness in the text of a body by a formula.
fn varying(body: &str, thickness: f64, formula: &str) -> String {
    body.replacen(
        &format!("thickness = {thickness:?}\n"),
        &format!("thickness = {{ kind = \"expression\", text = \"{formula}\" }}\n"),
        1,
    )
}

const THICK: f64 = 0.01;

/// Tapered cantilever of unit length with E = ρ = 1 and the width ¼.
fn cantilever(element: Element, n: usize) -> (Sheet, String) {
    let sheet = Sheet {
        element,
        corner: [0.0; 3],
        sides: [[1.0, 0.0, 0.0], [0.0, 0.25, 0.0]],
        elements: [n, 1],
        thickness: THICK,
        material: isotropic([1.0, 0.0, 1.0]),
        keys: String::new(),
    };
    let body = varying(&sheet.body(), THICK, "0.01*(1 - 0.8*x)");
    let text = body + &sheet.support(Edge::Left, "clamped");
    (sheet, text)
}

/// Value and slope of the deflection at the clamped end for unit values at the free end, where h = 1 − c.
fn at_clamp(omega: f64, taper: f64, start: [f64; 4]) -> [f64; 4] {
    // w, w', E I w'', (E I w'')' along the distance from the free end, for E = ρ = h₀ = 1.
    let rate = |s: f64, y: &[f64; 4]| {
        let h = 1.0 - taper * (1.0 - s);
        [y[1], 12.0 * y[2] / h.powi(3), y[3], omega * omega * h * y[0]]
    };
    runge_kutta(rate, start, 1.0, 4000)
}

/// First circular frequency of a tapered beam with unit length, E = ρ = 1 and the thickness 1 at the clamped end.
fn frequency(taper: f64) -> f64 {
    let determinant = |omega: f64| {
        let [a, b] = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]].map(|start| at_clamp(omega, taper, start));
        a[0] * b[1] - a[1] * b[0]
    };
    root(determinant, 0.5, 2.0)
}

/// Deflection 12 F/E ∫ (1 − x)²/h³ dx for F = 1.
fn deflection() -> f64 {
    integral(|x| 12.0 * (1.0 - x).powi(2) / (THICK * (1.0 - 0.8 * x)).powi(3), 0.0, 1.0)
}

fn tapered() -> Result<Findings, VerificationError> {
    let (force, mut convergence) = (1e-12, Convergence::default());
    for (element, meshes, tolerance) in
        [(Element::Thin, [4, 8, 16], 1e-4), (Element::Shear, [8, 16, 32], 5e-3)]
    {
        let name = element.name();
        convergence.case(format!("{name}, deflection"), &meshes, (deflection(), tolerance), |n| {
            let (sheet, text) = cantilever(element, n as usize);
            let load = format!(
                "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"{}\"\nforce = [0, 0, {force:e}]\n",
                sheet.edge(Edge::Right)
            );
            let probe = sheet.probe("end", [1, 0]);
            Ok(solve(&format!("{text}{load}{probe}[analysis]\nkind = \"statics\"\n"))?.last("end.z")? / force)
        })?;
        let exact = THICK * frequency(0.8);
        convergence.case(format!("{name}, frequency"), &meshes, (exact, tolerance), |n| {
            let (_, text) = cantilever(element, n as usize);
            Ok(TAU
                * solve(&format!("{text}[analysis]\nkind = \"modes\"\ncount = 1\n"))?.column("frequency")?[0])
        })?;
    }
    Ok(convergence.finish("elements along the plate"))
}

const INNER: f64 = 0.5;
const POISSON: f64 = 0.3;

/// Quarter of a ring with the edges `inner`, `outer`, and the lines of symmetry, as the text of the body.
fn ring(
    element: Element,
    n: usize,
    thickness: f64,
    material: &str,
    keys: &str,
) -> (String, [&'static str; 4]) {
    if element == Element::Thin {
        let text = format!(
            "materials.m = {{ {material} }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [{n}, {n}]\n\
             thickness = {thickness:?}\nmaterial = \"m\"\n{keys}surface = {{ kind = \"revolved\", from = [{INNER:?}, 0, 0], to = [1, 0, 0], \
             center = [0, 0, 0], axis = [0, 0, 1], angle = {FRAC_PI_2:?} }}\n"
        );
        return (text, ["v_start", "v_end", "u_start", "u_end"]);
    }
    let shell = MeshModel::grid([n; 2], thickness, material.to_owned(), |[u, v]| {
        let (r, (sin, cos)) = (INNER + (1.0 - INNER) * u, (FRAC_PI_2 * v).sin_cos());
        [[r * cos, r * sin, 0.0], [0.0, 0.0, 1.0]]
    });
    (MeshModel { keys: keys.to_owned(), ..shell }.to_string(), ["u0", "u1", "v0", "v1"])
}

/// Place of the end of the inner edge (0) or of the outer one (1) on the x axis.
fn end(element: Element, outer: usize) -> String {
    match element {
        Element::Thin => format!("{{ body = \"s\", at = [0, {outer}] }}"),
        Element::Shear => format!("{{ body = \"s\", at = {{ point = \"p{outer}0\" }} }}"),
    }
}

/// Deflection of the inner edge for D₀ = 1 and the force 1 per length of this edge.
fn conical_deflection() -> f64 {
    let a = INNER;
    let root = (9.0 + 4.0 * (1.0 - 3.0 * POISSON)).sqrt();
    let exponents = [0.5 * (root - 3.0), -0.5 * (root + 3.0)];
    // φ = c r⁻² with Q = a/r and D = r³.
    let c = -a / (6.0 - 8.0 - (1.0 - 3.0 * POISSON));
    // No moment φ' + ν φ/r at the inner edge, no slope at the outer one.
    let [m, k] = exponents;
    let moment = |x: f64| (x + POISSON) * a.powf(x - 1.0);
    let matrix = Matrix2::new(moment(m), moment(k), 1.0, 1.0);
    let loads = Vector2::new(-c * moment(-2.0), -c);
    let found = matrix.lu().solve(&loads).unwrap_or_default();
    let integral = |x: f64| (1.0 - a.powf(x + 1.0)) / (x + 1.0);
    found[0] * integral(m) + found[1] * integral(k) + c * integral(-2.0)
}

fn conical() -> Result<Findings, VerificationError> {
    let (force, thickness, mut convergence) = (1e-9, 0.01_f64, Convergence::default());
    let material = isotropic([12.0 * (1.0 - POISSON * POISSON) / thickness.powi(3), POISSON, 1.0]);
    for (element, meshes, tolerance) in
        [(Element::Thin, [2, 4, 8], 1e-4), (Element::Shear, [6, 12, 24], 5e-3)]
    {
        convergence.case(element.name(), &meshes, (conical_deflection(), tolerance), |n| {
            let (body, [inner, outer, a, b]) = ring(element, n as usize, thickness, &material, "");
            let body = varying(&body, thickness, "0.01*sqrt(x^2 + y^2)");
            let supports: String =
                [(outer, "\"clamped\""), (a, "\"symmetry\""), (b, "\"symmetry\"")].map(|(e, c)| mesh::edge(e, c)).concat();
            let load = format!(
                "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"{inner}\"\nforce = [0, 0, {force:e}]\n"
            );
            let probe = format!("[[probes]]\nname = \"p\"\non = {}\n", end(element, 0));
            Ok(solve(&format!("{body}{supports}{load}{probe}[analysis]\nkind = \"statics\"\n"))?.last("p.z")? / force)
        })?;
    }
    Ok(convergence.finish("elements along an edge"))
}

const ALONG: f64 = 25.0;
const SPEED: f64 = 1e-4;

/// Displacements of the inner and of the outer edge of a rotating ring with E_θ = 25, E_r = 1 and ρ = 1.
fn ring_displacements() -> [f64; 2] {
    // ν_LT is the contraction along r by a stress along θ.
    let ratio = 1.0 - POISSON * POISSON / ALONG;
    let [radial, coupled, hoop] = [1.0 / ratio, POISSON / ratio, ALONG / ratio];
    let k = (hoop / radial).sqrt();
    let c = -SPEED.powi(2) / (9.0 * radial - hoop);
    // σ_r of r^x at both edges.
    let stress = |x: f64, r: f64| (radial * x + coupled) * r.powf(x - 1.0);
    let matrix = Matrix2::new(stress(k, INNER), stress(-k, INNER), stress(k, 1.0), stress(-k, 1.0));
    let loads = Vector2::new(-c * stress(3.0, INNER), -c * stress(3.0, 1.0));
    let found = matrix.lu().solve(&loads).unwrap_or_default();
    [INNER, 1.0].map(|r| found[0] * r.powf(k) + found[1] * r.powf(-k) + c * r.powi(3))
}

fn circular() -> Result<Findings, VerificationError> {
    let material = format!(
        "young = {ALONG:?}, poisson = {POISSON:?}, density = 1, orthotropic = {{ young = 1, shear = 0.7, transverse_shear = 0.5 }}"
    );
    let axis = "fibre_axis = { kind = \"expression\", text = [\"-y\", \"x\", \"0\"] }\n";
    let mut convergence = Convergence::default();
    for (element, meshes, tolerance) in
        [(Element::Thin, [2, 4, 8], 1e-4), (Element::Shear, [8, 16, 32], 1e-2)]
    {
        // The angle about the normal, which is −z for the thin shell.
        let sign = if element == Element::Thin { "-" } else { "" };
        let angle = format!(
            "fibre_axis = [1, 0, 0]\nfibre_angle = {{ kind = \"expression\", text = \"{sign}(pi/2 + atan(y/x))\" }}\n"
        );
        for (name, keys) in [("axis", axis), ("angle", &angle)] {
            for (k, edge) in ["inner", "outer"].into_iter().enumerate() {
                let (exact, r) = (ring_displacements()[k], [INNER, 1.0][k]);
                let name = format!("{}, {name}, {edge} edge", element.name());
                convergence.case(name, &meshes, (exact, tolerance), |n| {
                    let (body, [_, _, a, b]) = ring(element, n as usize, 0.01, &material, keys);
                    let supports = [a, b].map(|e| mesh::edge(e, "\"symmetry\"")).concat();
                    let hold = format!(
                        "[[joints]]\nkind = \"support\"\nname = \"z\"\na = {}\ncondition = \"guided\"\naxes = [\"z\"]\n",
                        end(element, 0)
                    );
                    let probe = format!("[[probes]]\nname = \"p\"\non = {}\n", end(element, k));
                    let load = format!(
                        "[[loads]]\nkind = \"base_rotation\"\nangular_velocity = [0, 0, {SPEED:?}]\n[analysis]\nkind = \"statics\"\n"
                    );
                    Ok(solve(&format!("{body}{supports}{hold}{probe}{load}"))?.last("p.x")? - r)
                })?;
            }
        }
    }
    Ok(convergence.finish("elements along an edge"))
}

#[cfg(test)]
mod tests {
    use super::frequency;

    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }

    /// The independent integration has the classical frequencies of the uniform beam and, from below in the limit, of the sharp wedge.
    #[test]
    fn beams_have_the_classical_frequencies() {
        let ratio = |taper: f64| frequency(taper) * 12.0_f64.sqrt();
        assert!((ratio(0.0) - 3.516_015).abs() < 1e-5, "{}", ratio(0.0));
        let [blunt, sharp] = [0.99, 0.998].map(ratio);
        assert!(blunt < sharp && sharp < 5.315 && sharp > 5.315 - 0.03, "{blunt}, {sharp}");
    }
}
