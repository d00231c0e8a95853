//! Curved shells with small displacements: tests of membrane locking.

use super::models::{ShellModel, edge, force, node, probe};
use crate::problems::models::study;
use crate::{Findings, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "scordelis_lo_roof",
        title: "Scordelis-Lo roof",
        source: "Data of MacNeal & Harder (1985). 0.300592 by an independent Kirchhoff-Love code with B-splines of degree 4",
        sketch: r"
       .-''''-.           R = 25, L = 50, half angle 40 degrees, h = 0.25
     .'        '.         E = 4.32e8, ν = 0, weight 90 per area
     |          |         diaphragms at both ends",
        goal: "A quarter of the roof: deflection of the middle of the free edge within 0.5 % with 8 × 8 elements",
        run: roof,
    },
    Problem {
        name: "pinched_cylinder",
        title: "Cylinder between diaphragms, pinched by two forces",
        source: "1.8282e-5 by an independent Kirchhoff-Love code with B-splines of degree 4 on graded meshes; Fourier series of \
                 Lindberg et al. (1969): 1.82488e-5",
        sketch: r"
         F
      .--v--.             R = 300, L = 600, h = 3, E = 3e6, ν = 0.3
     (       )
      '--^--'
         F",
        goal: "An eighth of the cylinder: displacement under the force within 1 % with 24 × 24 elements",
        run: cylinder,
    },
    Problem {
        name: "hemisphere",
        title: "Hemisphere with a hole of 18 degrees, four radial forces",
        source: "Data of MacNeal & Harder (1985). 0.0935213 by an independent Kirchhoff-Love code with B-splines of degree 4",
        sketch: r"
        .--__--.          R = 10, h = 0.04, E = 6.825e7, ν = 0.3
       (        ) ->      forces of alternating sign at the equator
        '------'",
        goal: "A quarter of the hemisphere: displacement under the force within 0.5 % with 16 × 16 elements. Nearly inextensible",
        run: hemisphere,
    },
    Problem {
        name: "full_hemisphere",
        title: "Hemisphere with a hole of one degree, four radial forces",
        source: "Data of MacNeal & Harder (1985), who have 0.0924. 0.0923822 by an independent Kirchhoff-Love code with B-splines of \
                 degree 4",
        sketch: r"
        .-''-.            R = 10, h = 0.04, E = 6.825e7, ν = 0.3
       (      ) ->        forces of alternating sign at the equator
        '----'",
        goal: "A quarter of the hemisphere: displacement under the force within 0.1 % with 16 × 16 elements, which are narrow near the \
               pole",
        run: || quarter_sphere(1.0, (0.0923822, 1e-3)),
    },
];

/// Small displacements: loads are divided by a thousand.
const SMALL: f64 = 1e-3;

fn roof() -> Result<Findings, VerificationError> {
    study(&[2, 4, 8], "deflection of the free edge", (0.300592, 5e-3), |n| {
        let shell = ShellModel {
            surface: "kind = \"revolved\", from = [0, 0, 25], to = [0, 25, 25], center = [0, 0, 0], axis = [0, 1, 0], \
                      angle = 0.6981317007977318",
            elements: [n, n],
            thickness: 0.25,
            material: [4.32e8, 0.0, 1.0],
        };
        let model = format!(
            "gravity = [0, 0, {:e}]\n{shell}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            -360.0 * SMALL,
            edge("u_start", "\"symmetry\""),
            edge("v_start", "\"symmetry\""),
            edge("v_end", "\"guided\"\naxes = [\"x\", \"z\"]"),
            probe("edge", [1.0, 0.0])
        );
        let start = 25.0 * 0.6981317007977318_f64.cos();
        Ok((start - solve(&model)?.last("edge.z")?) / SMALL)
    })
}

fn cylinder() -> Result<Findings, VerificationError> {
    // A force of 1000 moves the point by 6e-5 of the radius.
    let scale = 1e3;
    study(&[8, 16, 24], "displacement under the force", (1.8282e-5, 1e-2), |n| {
        let shell = ShellModel {
            surface: "kind = \"revolved\", from = [0, 0, 300], to = [0, 300, 300], center = [0, 0, 0], axis = [0, 1, 0], \
                      angle = 1.5707963267948966",
            elements: [n, n],
            thickness: 3.0,
            material: [3e6, 0.3, 1.0],
        };
        let model = format!(
            "{shell}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u_start", "\"symmetry\""),
            edge("u_end", "\"symmetry\""),
            edge("v_start", "\"symmetry\""),
            edge("v_end", "\"guided\"\naxes = [\"x\", \"z\"]"),
            force([0.0, 0.0], [0.0, 0.0, -0.25 * scale]),
            probe("p", [0.0, 0.0])
        );
        Ok((300.0 - solve(&model)?.last("p.z")?) / scale)
    })
}

fn hemisphere() -> Result<Findings, VerificationError> {
    quarter_sphere(18.0, (0.0935213, 5e-3))
}

/// Quarter of a hemisphere with a hole of an angle in degrees.
fn quarter_sphere(hole: f64, exact: (f64, f64)) -> Result<Findings, VerificationError> {
    let surface = format!(
        "kind = \"sphere\", center = [0, 0, 0], equator = [10, 0, 0], axis = [0, 0, 1], angle = 1.5707963267948966, \
         latitudes = [0, {:?}]",
        (90.0 - hole).to_radians()
    );
    study(&[4, 8, 16], "displacement under the outward force", exact, |n| {
        let shell = ShellModel {
            surface: &surface,
            elements: [n, n],
            thickness: 0.04,
            material: [6.825e7, 0.3, 1.0],
        };
        let model = format!(
            "{shell}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u_start", "\"symmetry\""),
            edge("u_end", "\"symmetry\""),
            node("z", [0.0, 0.0], "\"z\""),
            force([0.0, 0.0], [SMALL, 0.0, 0.0]),
            force([1.0, 0.0], [0.0, -SMALL, 0.0]),
            probe("A", [0.0, 0.0])
        );
        Ok((solve(&model)?.last("A.x")? - 10.0) / SMALL)
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
