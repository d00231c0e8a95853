//! Triangles of shear-deformable shells, alone and among quadrilaterals.

use super::linear::{patch_mesh, patch_test, roof_of};
use super::plates::{deflection, plate};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "shear_shell_triangle_patch",
        title: "Patch tests of a mesh with quadrilaterals and triangles",
        source: "MacNeal & Harder (1985): ε_x = ε_y = γ_xy = 1e-3, σ_x = σ_y = 1333.3333, τ = 400; m_x = m_y = 1.1111111e-7, \
                 m_xy = 3.3333333e-8",
        sketch: r"
      +-------------+
      | \  +---+  / |   0.24 × 0.12, t = 0.001, E = 1e6, ν = 0.25
      |  +-'  / '-+ |   two of five quadrilaterals divided
      +-------------+",
        goal: "Uniform membrane forces and moments at all nodes to 1e-6 of them, with small displacements",
        run: || patch_test(|| patch_mesh().divided(|k| k < 2)),
    },
    Problem {
        name: "shear_shell_triangle_roof",
        title: "Scordelis-Lo roof with triangles",
        source: "Data of MacNeal & Harder (1985). 0.300592 by an independent Kirchhoff-Love code; with transverse shear 0.301 to 0.302",
        sketch: r"
       .-''''-.           R = 25, L = 50, half angle 40 degrees, h = 0.25
     .'        '.         E = 4.32e8, ν = 0, weight 90 per area
     |          |         one of nine quadrilaterals is two triangles",
        goal: "A quarter of the roof: deflection of the middle of the free edge within 0.5 % of 0.3013 with 24 × 24 elements",
        run: || roof_of(&[6, 12, 24], |shell| shell.divided(|k| k % 9 == 4)),
    },
    Problem {
        name: "shear_shell_triangles",
        title: "Square plate of triangles on hard simple supports",
        source: "Navier solution of the Reissner-Mindlin plate with κ = 5/6, ν = 0.3: w D/(q a⁴) = 0.00406237371, 0.00406445756 and \
                 0.00490431098 for h/a = 0.001, 0.01 and 0.2",
        sketch: r"
      +--------+
      | / / /  |   a = 1, D = 1
      +--------+",
        goal: "Deflection within 1 % with 24 × 24 × 2 elements for all thicknesses: no shear locking",
        run: thicknesses,
    },
];

fn thicknesses() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (h, exact) in [(0.001, 0.00406237371), (0.01, 0.00406445756), (0.2, 0.00490431098)] {
        let mut points = Vec::new();
        for n in [6, 12, 24] {
            points.push([n as f64, deflection(&plate(n, h).divided(|_| true))? / exact]);
        }
        let ratio = points.last().map_or(f64::NAN, |[_, ratio]| *ratio);
        found.compare(format!("deflection, h/a = {h}"), ratio * exact, exact, exact, 1e-2);
        curves.push(PlotCurve::points(format!("h/a = {h}"), points));
    }
    let axes = ["elements along an edge", "ratio"];
    found.plot(Plot::new("Deflection, relative to the Navier solution", axes, curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
