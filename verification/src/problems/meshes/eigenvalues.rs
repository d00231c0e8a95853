//! Estimated errors of frequencies and critical loads of coarse meshes.

use std::f64::consts::{PI, TAU};

use crate::problems::models::{ROD, Rod, clamped, joint, tip_load};
use crate::{Findings, Problem, SolvedModel, VerificationError, estimated};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "mesh_modes_enhanced",
        title: "Estimated error: frequencies of a cantilever of enhanced elements",
        source: "Euler-Bernoulli beam, cos βL cosh βL = −1",
        sketch: CANTILEVER,
        goal: "Ratio of estimate and error 0.8 to 1.25 with 2 to 8 elements; value + error within 1e-4",
        run: || cantilever("enhanced", 0, &[2, 4, 8], 1e-4),
    },
    Problem {
        name: "mesh_modes_quadratic",
        title: "Estimated error: second frequency of a cantilever of quadratic elements",
        source: "Euler-Bernoulli beam, cos βL cosh βL = −1",
        sketch: CANTILEVER,
        goal: "Ratio of estimate and error 0.8 to 1.25 with 2 to 8 elements; value + error within 1e-5",
        run: || cantilever("quadratic", 2, &[2, 4, 8], 1e-5),
    },
    Problem {
        name: "mesh_modes_cable",
        title: "Estimated error: second frequency of a cantilever of cable elements",
        source: "Euler-Bernoulli beam, cos βL cosh βL = −1",
        sketch: CANTILEVER,
        goal: "Ratio of estimate and error 0.8 to 1.25 with 2 to 8 elements; value + error within 1e-6",
        run: || cantilever("cable", 2, &[2, 4, 8], 1e-6),
    },
    Problem {
        name: "mesh_modes_compressed",
        title: "Estimated error: frequency of a beam with two hinges under 90 % of its critical load",
        source: "ω² = (π/L)² (EI (π/L)² − N)/ρA",
        sketch: r"
      o=================o ←      N = 0.9 π² EI/L²",
        goal: "Ratio of estimate and error 0.8 to 1.25 with 2 to 4 elements; value + error within 3e-5",
        run: compressed,
    },
    Problem {
        name: "mesh_column_enhanced",
        title: "Estimated error: critical load of a column of enhanced elements",
        source: "Euler, π² EI/4L²",
        sketch: r"
    |/|================= ←",
        goal: "Ratio of estimate and error 0.8 to 1.25 with 2 to 8 elements; value + error within 1e-4",
        run: column,
    },
];

const CANTILEVER: &str = r"
    |/|=================   L = 1 m, L/h = 1000";

/// E I and ρA of the section, which is slender.
const BENDING: f64 = 1.0;
const MASS: f64 = 1e-3;

/// Tables of the section, the material and an analysis.
fn tables(analysis: &str) -> String {
    format!(
        r#"
        materials.material = {{ density = 1000, young = 12e12, poisson = 0 }}
        sections.section = {{ kind = "rectangle", height = 1e-3, width = 1e-3 }}
        analysis = {{ {analysis} }}
        "#
    )
}

/// Returns the value of a column in a row.
fn row(column: &'static str, row: usize) -> impl Fn(&SolvedModel) -> Result<f64, VerificationError> {
    move |solved| {
        let value = solved.column(column)?.get(row).copied();
        value.ok_or_else(|| VerificationError::Missing(format!("row {row} in {column}")))
    }
}

fn cantilever(
    element: &'static str,
    number: usize,
    levels: &[u32],
    tolerance: f64,
) -> Result<Findings, VerificationError> {
    let model = |elements| {
        let rod = Rod { element, elements, ..ROD };
        tables("kind = \"modes\", count = COUNT").replace("COUNT", &(number + 2).to_string())
            + &rod.to_string()
            + &clamped("rod")
    };
    // The modes of both planes have equal frequencies.
    let beta: f64 = if number == 0 { 1.875_104_068_711_961 } else { 4.694_091_132_974_175 };
    let reference = beta * beta * (BENDING / MASS).sqrt() / TAU;
    estimated("frequency, Hz", levels, model, row("frequency", number), reference, tolerance)
}

fn compressed() -> Result<Findings, VerificationError> {
    let load = 0.9 * PI * PI * BENDING;
    let model = |elements| {
        let rod = Rod { element: "cable", elements, ..ROD };
        tables("kind = \"modes\", count = 1, about = \"equilibrium\"")
            + &rod.to_string()
            + &joint("spherical", "left", "{ body = \"rod\", at = \"start\" }")
            + &joint("point_on_line", "right", "{ body = \"rod\", at = \"end\" }")
            + "axis = [1, 0, 0]\n"
            + &tip_load("rod", [-load, 0.0, 0.0])
    };
    let reference = (PI * PI * (PI * PI * BENDING - load) / MASS).sqrt() / TAU;
    estimated("frequency, Hz", &[2, 3, 4], model, row("frequency", 0), reference, 3e-5)
}

fn column() -> Result<Findings, VerificationError> {
    let model = |elements| {
        let rod = Rod { element: "enhanced", elements, ..ROD };
        let rod = rod.to_string() + &clamped("rod") + &tip_load("rod", [-1.0, 0.0, 0.0]);
        tables("kind = \"buckling\", count = 1") + &rod
    };
    estimated("critical load, N", &[2, 4, 8], model, row("factor", 0), PI * PI * BENDING / 4.0, 1e-4)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn problems_hold() {
        crate::assert_all_hold(PROBLEMS);
    }
}
