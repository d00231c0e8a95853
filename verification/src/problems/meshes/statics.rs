//! Estimated errors of coarse meshes in statics.

use crate::problems::models::{ROD, Rod, cantilever, clamped, end_probe, joint};
use crate::reference::integral;
use crate::{Findings, Problem, SolvedModel, VerificationError, estimated};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "mesh_elastica_cable",
        title: "Estimated error: cantilever of cable elements, P L²/EI = 10",
        source: "Euler's elastica (Bisshopp & Drucker 1945)",
        sketch: ELASTICA,
        goal: "Ratio of estimate and error 0.5 to 2 with 4 to 16 elements; value + error within 2e-6",
        run: || elastica("cable", &[4, 8, 16], TEN, 2e-6),
    },
    Problem {
        name: "mesh_elastica_linked",
        title: "Estimated error: cantilever of linked elements, P L²/EI = 10",
        source: "Euler's elastica (Bisshopp & Drucker 1945)",
        sketch: ELASTICA,
        goal: "Ratio of estimate and error 0.5 to 2 with 4 to 16 elements; value + error within 2e-5",
        run: || elastica("linked", &[4, 8, 16], TEN, 2e-5),
    },
    Problem {
        name: "mesh_elastica_quadratic",
        title: "Estimated error: cantilever of quadratic elements, P L²/EI = 10",
        source: "Euler's elastica (Bisshopp & Drucker 1945)",
        sketch: ELASTICA,
        goal: "Ratio of estimate and error 0.5 to 2 with 2 to 4 elements; value + error within 2e-5",
        run: || elastica("quadratic", &[2, 3, 4], TEN, 2e-5),
    },
    Problem {
        name: "mesh_shear_locking",
        title: "Estimated error: cantilever of enhanced elements, P L²/EI = 1",
        source: "Euler's elastica (Bisshopp & Drucker 1945)",
        sketch: ELASTICA,
        goal: "Ratio of estimate and error 0.5 to 2 with 8 to 32 elements; value + error within 1e-4",
        run: || elastica("enhanced", &[8, 16, 32], ONE, 1e-4),
    },
    Problem {
        name: "mesh_poisson_locking",
        title: "Estimated error: cantilever of continuum elements with ν = 0.3",
        source: "Timoshenko's beam, P L³/3EI + P L/k_z GA",
        sketch: ELASTICA,
        goal: "Ratio of estimate and error 0.5 to 2, though the error of a quarter does not decrease with the mesh; value + error within 1e-3",
        run: poisson,
    },
    Problem {
        name: "mesh_taper",
        title: "Estimated error: tapered cantilever with a small load at its tip",
        source: "Unit-load theorem, ∫ P (L − x)²/EI dx + ∫ P/k_z GA dx",
        sketch: r"
    |/|████▓▓▓▓▒▒▒▒░░░░|  P     height 3 : 1, L = 1 m",
        goal: "Ratio of estimate and error 0.5 to 2 with 2 to 8 elements; value + error within 1e-4",
        run: taper,
    },
    Problem {
        name: "mesh_clamped_weight",
        title: "Estimated error: beam with two clamps under its own weight",
        source: "Timoshenko's beam, q L⁴/384EI + q L²/8 k_z GA",
        sketch: r"
    |/|=================|/|   L = 1 m, L/h = 100
       ↓ ↓ ↓ ↓ q ↓ ↓ ↓ ↓",
        goal: "Ratio of estimate and error of the middle 0.5 to 2 with 2 to 8 elements; value + error within 1e-6",
        run: weight,
    },
    Problem {
        name: "mesh_boundary_layer",
        title: "Estimated error: taut beam with a boundary layer at its clamp",
        source: "P/N (L − tanh(k L)/k), k² = N/EI",
        sketch: r"
    |/|=================|→ N     √(EI/N) = 0.02 L
                        ↓ P",
        goal: "Ratio of estimate and error 0.5 to 2 with elements longer than the layer; value + error within 1e-3",
        run: taut,
    },
    Problem {
        name: "mesh_catenary",
        title: "Estimated error: hanging cable of few elements",
        source: "Inextensible catenary, L = 2a sinh(d/2a), sag a (cosh(d/2a) − 1)",
        sketch: r"
      o               o      d = 0.9 m, L = 1 m
       \             /
         \__     __/
            `---´",
        goal: "Ratio of estimate and error of the sag 0.5 to 2 with 4 and 6 elements; value + error within 1e-5",
        run: catenary,
    },
];

const ELASTICA: &str = r"
    |/|============________
    |/|                    \____
                                \
                                 | P";

/// P L²/EI and the deflection of the tip of the elastica.
const ONE: [f64; 2] = [1.0, 0.301720773799814];
const TEN: [f64; 2] = [10.0, 0.810609024880296];

/// Tables of a material and a rectangular section of height and width `h`, and a static analysis.
fn tables(young: f64, poisson: f64, h: f64) -> String {
    format!(
        r#"
        materials.material = {{ density = 1, young = {young:?}, poisson = {poisson:?} }}
        sections.section = {{ kind = "rectangle", height = {h:?}, width = {h:?} }}
        analysis = {{ kind = "statics", stop = {{ rule = "energy", tolerance = 1e-14 }} }}
        "#
    )
}

fn tip(solved: &SolvedModel) -> Result<f64, VerificationError> {
    Ok(-solved.last("tip.y")?)
}

/// Wire of length one with L/h = 1000 and E I = 1.
fn elastica(
    element: &'static str,
    levels: &[u32],
    [load, reference]: [f64; 2],
    tolerance: f64,
) -> Result<Findings, VerificationError> {
    let tables = tables(12e12, 0.0, 1e-3);
    let model = |elements| tables.clone() + &cantilever(&Rod { element, elements, ..ROD }, [0.0, -load, 0.0]);
    estimated("deflection", levels, model, tip, reference, tolerance)
}

fn poisson() -> Result<Findings, VerificationError> {
    let (young, h, load): (f64, f64, f64) = (1e9, 0.02, 1e-3);
    let tables = tables(young, 0.3, h);
    let model = |elements| {
        tables.clone() + &cantilever(&Rod { element: "continuum", elements, ..ROD }, [0.0, -load, 0.0])
    };
    // The shear correction factor of a rectangle is 10(1 + ν)/(12 + 11ν).
    let shear = 13.0 / 15.3 * young / 2.6 * h * h;
    let reference = load / (3.0 * young * h.powi(4) / 12.0) + load / shear;
    estimated("deflection", &[2, 4, 8, 16], model, tip, reference, 1e-3)
}

fn taper() -> Result<Findings, VerificationError> {
    let (young, width, load): (f64, f64, f64) = (1e9, 0.02, 1e-3);
    let tables = tables(young, 0.0, width);
    let end = r#"section_end = "small""#;
    let model = |elements| {
        let rod = Rod { element: "linked", elements, keys: end, ..ROD };
        let small = "sections.small = { kind = \"rectangle\", height = 0.01, width = 0.02 }\n";
        let tall = tables.replacen("height = 0.02", "height = 0.03", 1);
        small.to_owned() + &tall + &cantilever(&rod, [0.0, -load, 0.0])
    };
    let height = |x: f64| 0.03 - 0.02 * x;
    let bending = |x: f64| (1.0 - x).powi(2) / (young * width * height(x).powi(3) / 12.0);
    let shear = |x: f64| 1.0 / (10.0 / 12.0 * 0.5 * young * width * height(x));
    let reference = load * integral(|x| bending(x) + shear(x), 0.0, 1.0);
    estimated("deflection", &[2, 4, 8], model, tip, reference, 1e-4)
}

fn weight() -> Result<Findings, VerificationError> {
    let (young, h, gravity): (f64, f64, f64) = (1e9, 0.01, 0.1);
    let model = |elements| {
        let end = joint("clamp", "end", "{ body = \"rod\", at = \"end\" }");
        let probe = end_probe("tip", "rod").replace("\"end\"", "0.5");
        let rod = Rod { element: "linked", elements, ..ROD };
        let gravity = format!("gravity = [0, -{gravity}, 0]\n");
        gravity + &tables(young, 0.0, h) + &rod.to_string() + &clamped("rod") + &end + &probe
    };
    let load = h * h * gravity;
    let reference =
        load / (384.0 * young * h.powi(4) / 12.0) + load / (8.0 * 10.0 / 12.0 * 0.5 * young * h * h);
    estimated("deflection of the middle", &[2, 4, 8], model, tip, reference, 1e-6)
}

fn taut() -> Result<Findings, VerificationError> {
    let (young, h, pull, push): (f64, f64, f64, f64) = (1e9, 4e-3, 50.0, 1e-3);
    let tables = tables(young, 0.0, h);
    let model = |elements| {
        let rod = Rod { element: "linked", elements, ..ROD };
        tables.clone() + &cantilever(&rod, [pull, -push, 0.0])
    };
    let k = (pull / (young * h.powi(4) / 12.0)).sqrt();
    let stretch = 1.0 + pull / (young * h * h);
    let reference = push / pull * (stretch - k.tanh() / k);
    estimated("deflection", &[1, 2], model, tip, reference, 1e-3)
}

fn catenary() -> Result<Findings, VerificationError> {
    let (length, distance) = (1.0_f64, 0.9_f64);
    let mut a = 0.5_f64;
    for _ in 0..60 {
        let x = distance / (2.0 * a);
        a -= (2.0 * a * x.sinh() - length) / (2.0 * x.sinh() - 2.0 * x * x.cosh());
    }
    let reference = a * ((distance / (2.0 * a)).cosh() - 1.0);
    let hook = |name: &str, at: &str, x: f64| {
        let place = format!("{{ body = \"rod\", at = \"{at}\" }}");
        joint("spherical", name, &place) + &format!("b = {{ point = [{x}, 0, 0] }}\n")
    };
    let model = |elements| {
        let rod = Rod { element: "cable", elements, ..ROD };
        let probe = end_probe("tip", "rod").replace("\"end\"", "\"center\"");
        let tables = tables(1e11, 0.0, 2e-6).replace("density = 1", "density = 1e4");
        "gravity = [0, -9.81, 0]\n".to_owned()
            + &tables
            + &rod.to_string()
            + &hook("left", "start", 0.05)
            + &hook("right", "end", 0.95)
            + &probe
    };
    estimated("sag", &[4, 6], model, tip, reference, 1e-5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn problems_hold() {
        crate::assert_all_hold(PROBLEMS);
    }
}
