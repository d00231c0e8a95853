//! Plates under uniform loads and forces: deflections and moments.

use std::f64::consts::PI;

use super::models::{ShellModel, edge, edge_load, force, probe, surface_force};
use crate::problems::models::Convergence;
use crate::{Findings, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "square_plates",
        title: "Square plates under a uniform load and a force in the centre",
        source: "Series of Navier and Ritz for ν = 0.3: w D/(q a⁴) = 0.00126531909 (clamped) and 0.00406235266 (hinged), w D/(P a²) = \
                 0.00561202 and 0.01160083977; moments of the uniform load 0.0229051 q a² in the centre and −0.051334 q a² at the \
                 middle of the edge (clamped), 0.0478864 q a² in the centre (hinged). MacNeal & Harder (1985) have 0.00126, 0.00406, \
                 0.00560 and 0.01160",
        sketch: r"
      +----+----+
      |    |////|   a = 1, h = 0.01, D = 1
      +----F----+   q = 1 or F = 1
      |    |    |   a quarter as the model
      +----+----+",
        goal: "Deflections under the uniform load within 1e-4, under the force within 1e-3, and three moments within 1 % with 12 × 12 \
               elements on a quarter",
        run: squares,
    },
    Problem {
        name: "annular_plates",
        title: "Annular plates under a uniform load and a line load at the inner edge",
        source: "Timoshenko & Woinowsky-Krieger (1959), sections 15 to 17: w = A + B r² + C ln r + F r² ln r + q r⁴/(64 D), with a free \
                 inner edge and a clamped or hinged outer edge",
        sketch: r"
         P
    |/=====   =====\|    radii 0.1 and 1, h = 0.01, D = 1, ν = 0.3
    |/=====   =====\|    q = 1, or P = 1 along the inner edge
        a quarter as the model",
        goal: "Deflections of the inner edge within 2e-4 with 16 × 8 elements. At most 45 degrees per element represent a circle",
        run: annuli,
    },
];

/// Small displacements.
const SMALL: f64 = 1e-6;

/// Plate with D = 1 for ν = 0.3.
const fn plate(surface: &str, elements: [u32; 2]) -> ShellModel<'_> {
    ShellModel { surface, elements, thickness: 0.01, material: [12.0 * (1.0 - 0.09) * 1e6, 0.3, 1.0] }
}

/// Quarter of a square plate with its centre at u = v = 0.
fn square(n: u32, condition: &str, load: &str) -> Result<SolvedModel, VerificationError> {
    let surface = "kind = \"flat\", corner = [0, 0, 0], side_u = [0.5, 0, 0], side_v = [0, 0.5, 0]";
    let record = "record = [\"motion\", \"resultants\"]\n";
    solve(&format!(
        "{}{}{}{}{}{load}{}{record}{}{record}[analysis]\nkind = \"statics\"\n",
        plate(surface, [n; 2]),
        edge("u_start", "\"symmetry\""),
        edge("v_start", "\"symmetry\""),
        edge("u_end", condition),
        edge("v_end", condition),
        probe("c", [0.0, 0.0]),
        probe("e", [1.0, 0.0])
    ))
}

fn squares() -> Result<Findings, VerificationError> {
    let mut convergence = Convergence::default();
    let uniform = surface_force([0.0, 0.0, SMALL]);
    let point = force([0.0, 0.0], [0.0, 0.0, 0.25 * SMALL]);
    let fine = 12;
    let cases = [
        ("clamped", [0.00126531909, 0.00561202], &[("c.muu", 0.0229051), ("e.muu", -0.051334)][..]),
        ("hinged", [0.00406235266, 0.01160083977], &[("c.muu", 0.0478864)]),
    ];
    let mut moments = Vec::new();
    for (name, [spread, single], exact) in cases {
        let condition = format!("\"{name}\"");
        for (kind, load, exact) in [("q", &uniform, (spread, 1e-4)), ("P", &point, (single, 1e-3))] {
            convergence.case(format!("deflection, {name}, {kind}"), &[3, 6, fine], exact, |n| {
                Ok(square(n, &condition, load)?.last("c.z")? / SMALL)
            })?;
        }
        let solved = square(fine, &condition, &uniform)?;
        for (column, exact) in exact {
            moments.push((format!("moment {column}, {name}"), solved.last(column)? / SMALL, *exact));
        }
    }
    let mut found = convergence.finish("elements along half an edge");
    for (name, ours, exact) in moments {
        found.compare(name, ours, exact, exact, 1e-2);
    }
    Ok(found)
}

/// Inner radius of the annulus. The outer one is 1.
const INNER: f64 = 0.1;

/// Deflection of the inner edge, of radius a, for D = 1, ν = 0.3, the load q per area and the load P along the inner edge.
fn annulus_deflection(a: f64, is_clamped: bool, [q, p]: [f64; 2]) -> f64 {
    let nu = 0.3;
    // Shear force at the inner edge: 4 F/a + q a/2 = P/(2 π a).
    let f = (p / PI - q * a * a) / 8.0;
    // Radial moments w'' + ν w'/r = 0, or the slope w' = 0 of the clamped edge: rows of B and C.
    let bending = |r: f64| [2.0 * (1.0 + nu), -(1.0 - nu) / (r * r)];
    let known = |r: f64| f * (2.0 * (1.0 + nu) * r.ln() + 3.0 + nu) + q * (3.0 + nu) * r * r / 16.0;
    let inner = (bending(a), -known(a));
    let outer = if is_clamped { ([2.0, 1.0], -f - q / 16.0) } else { (bending(1.0), -known(1.0)) };
    let det = inner.0[0] * outer.0[1] - inner.0[1] * outer.0[0];
    let b = (inner.1 * outer.0[1] - inner.0[1] * outer.1) / det;
    let c = (inner.0[0] * outer.1 - inner.1 * outer.0[0]) / det;
    // The deflection of the outer edge r = 1 is zero: A = −B − q/64.
    b * (a * a - 1.0) + c * a.ln() + f * a * a * a.ln() + q * (a.powi(4) - 1.0) / 64.0
}

fn annuli() -> Result<Findings, VerificationError> {
    let surface = "kind = \"revolved\", from = [0.1, 0, 0], to = [1, 0, 0], center = [0, 0, 0], axis = [0, 0, 1], \
                   angle = 1.5707963267948966";
    let line = SMALL / (2.0 * PI * INNER);
    let loads = [
        ("q", surface_force([0.0, 0.0, SMALL]), [1.0, 0.0]),
        ("P", edge_load("edge_force", "v_start", "force", [0.0, 0.0, line]), [0.0, 1.0]),
    ];
    let mut convergence = Convergence::default();
    for condition in ["clamped", "hinged"] {
        for (name, load, sizes) in &loads {
            let exact = annulus_deflection(INNER, condition == "clamped", *sizes);
            convergence.case(format!("{condition}, {name}"), &[4, 8, 16], (exact, 2e-4), |n| {
                let model = format!(
                    "{}{}{}{}{load}{}[analysis]\nkind = \"statics\"\n",
                    plate(surface, [n / 2, n]),
                    edge("u_start", "\"symmetry\""),
                    edge("u_end", "\"symmetry\""),
                    edge("v_end", &format!("\"{condition}\"")),
                    probe("inner", [0.5, 0.0])
                );
                Ok(solve(&model)?.last("inner.z")? / SMALL)
            })?;
        }
    }
    Ok(convergence.finish("elements along a radius"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hold() {
        crate::assert_all_hold(PROBLEMS);
    }

    /// A plate with a tiny hole has the deflection of the circular plate: q a⁴/(64 D) and P a²/(16 π D), or (5 + ν)/(1 + ν) and
    /// (3 + ν)/(1 + ν) times these.
    #[test]
    fn deflection_is_that_of_the_circular_plate_for_a_small_hole() {
        let [uniform, point] = [1.0 / 64.0, 1.0 / (16.0 * PI)];
        for (is_clamped, factors) in [(true, [1.0, 1.0]), (false, [5.3 / 1.3, 3.3 / 1.3])] {
            for (load, exact) in [([1.0, 0.0], uniform * factors[0]), ([0.0, 1.0], point * factors[1])] {
                let ratio = annulus_deflection(1e-6, is_clamped, load) / exact;
                assert!((ratio - 1.0).abs() < 1e-8, "{ratio}");
            }
        }
    }
}
