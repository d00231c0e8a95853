//! Twisted, straight and curved strips of shear-deformable shells with small displacements.

use std::f64::consts::{FRAC_PI_2, PI};

use super::mesh::{MeshModel, edge, edge_load, force, isotropic, probe};
use crate::problems::models::Convergence;
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "shear_shell_twisted",
        title: "Strip of four-node shells twisted by 90 degrees, thick and thin",
        source: "MacNeal & Harder (1985): 5.424e-3 in plane and 1.754e-3 out of plane; thin: Simo, Fox & Rifai (1989), Belytschko et al. \
                 (1989): 5.256e-3 and 1.294e-3",
        sketch: r"
  |/=====--__             L = 12, b = 1.1, h = 0.32 or 0.0032
  |/   __--  ||  F        E = 29e6, ν = 0.22
  |/===      ||           F = 1 or 1e-6 along the edge",
        goal: "Displacements of the tip in the direction of the force within 0.5 % with 48 × 8 elements. Elements are not flat",
        run: twisted,
    },
    Problem {
        name: "shear_shell_hook",
        title: "Raasch's hook of four-node shells",
        source: "Data of Raasch, published by Knight (1997). 5.0382 by a Ritz series for the linear theory of Reissner and Mindlin with \
                 κ = 5/6: Legendre polynomials of degree 14 × 18 in each part. 5.02 in the documentation of a commercial program, 4.9934 \
                 with 108 × 20 linear shells of eight nodes",
        sketch: r"
  |/__                    radius 14 over 60 degrees, then 46 over 150 degrees
      \      .-''-.       width 20, h = 2, E = 3300, ν = 0.35
       '----'      \      F = 1 along the width at the free end
                    | F",
        goal: "Displacement of the free end within 0.5 % of the Ritz series with 56 × 32 elements. Elements without a consistent coupling of twist and \
               bending diverge",
        run: hook,
    },
    Problem {
        name: "shear_shell_straight_beam",
        title: "Straight beam of MacNeal and Harder of rectangles, trapezoids and parallelograms",
        source: "MacNeal & Harder (1985): 3e-5 along the beam, 0.1081 in plane, 0.4321 out of plane. In plane six \
                 trapezoids lock, as all elements of four nodes that pass the patch test (MacNeal 1987). An independent code of the elements \
                 of Andelfinger & Ramm (1993) has 0.0055697 with trapezoids and 0.0683496 with parallelograms. Torsion T L/(G J), J = b t³/3 (1 − tanh c/c), c = √10 b/(2t), of Reissner's plate \
                 with κ = 5/6; MacNeal & Harder have 0.03208, which is 6 % less",
        sketch: r"
  |/+---+---+---+---+---+---+    6 × 0.2 × 0.1, E = 1e7, ν = 0.3
  |/|    \   /   \   /    \ | F  F = 1, T = 1
  |/+-----+-+-----+-+------++    angles of 45 degrees",
        goal: "6 × 1 elements: 0.5 % along the beam, 1 % in plane with rectangles and 1e-4 from the independent code with distorted \
               ones, 4 % out of plane. 48 × 8 elements: 0.5 % in plane for all shapes, 2 % in torsion",
        run: straight,
    },
    Problem {
        name: "shear_shell_curved_beam",
        title: "Curved beam of MacNeal and Harder of four-node shells",
        source: "Out of plane 0.5022 (MacNeal & Harder 1985). In plane π F (a² + b²)/(E t N), N = a² − b² + (a² + b²) ln(b/a) (Golovin \
                 1881), which is 0.088566; MacNeal & Harder have 0.08734",
        sketch: r"
  |/==._                  90 degrees, radii a = 4.12 and b = 4.32, t = 0.1
        '\                E = 1e7, ν = 0.25, F = 1
          | F",
        goal: "In plane within 0.2 %, out of plane within 1 % with 96 × 16 elements: twisting needs fine elements near the free edges",
        run: curved,
    },
];

/// Model with a clamped edge `u0`, a line force along `u1`, and a probe `tip` in its middle.
fn cantilever(shell: &MeshModel, line_force: [f64; 3]) -> String {
    format!(
        "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
        edge("u0", "\"clamped\""),
        edge_load("edge_force", "u1", "force", line_force),
        probe("tip", "end")
    )
}

fn twisted_mesh(n: usize, thickness: f64) -> MeshModel {
    MeshModel::grid([n, n / 6], thickness, isotropic([29e6, 0.22, 1.0]), |[u, v]| {
        let (width, rate) = (1.1 * (v - 0.5), PI / 24.0);
        let (sin, cos) = (FRAC_PI_2 * u).sin_cos();
        // Normal: (1, −w φ' sin φ, w φ' cos φ) × (0, cos φ, sin φ).
        let length = (1.0 + (width * rate).powi(2)).sqrt();
        let normal = [-width * rate, -sin, cos].map(|x| x / length);
        [[12.0 * u, width * cos, width * sin], normal]
    })
}

fn twisted() -> Result<Findings, VerificationError> {
    let mut convergence = Convergence::default();
    for (thickness, force, name, exact) in [
        (0.32, 1e-2, "in plane", 5.424e-3),
        (0.32, 1e-2, "out of plane", 1.754e-3),
        (0.0032, 1e-8, "in plane", 5.256e-3),
        (0.0032, 1e-8, "out of plane", 1.294e-3),
    ] {
        let (column, direction) =
            if name == "in plane" { ("tip.z", [0.0, 0.0, 1.0]) } else { ("tip.y", [0.0, 1.0, 0.0]) };
        convergence.case(format!("h = {thickness}, {name}"), &[12, 24, 48], (exact, 5e-3), |n| {
            let model = cantilever(&twisted_mesh(n as usize, thickness), direction.map(|x| x * force / 1.1));
            // Displacements are small: 5e-5.
            Ok(solve(&model)?.last(column)? / 1e-2)
        })?;
    }
    Ok(convergence.finish("elements along the strip"))
}

/// Hook with n elements per 30 degrees. The width is along z.
fn hook_mesh(n: usize) -> MeshModel {
    MeshModel::grid([7 * n, 4 * n], 2.0, isotropic([3300.0, 0.35, 1.0]), |[u, v]| {
        let (angle, z) = (210.0 * u, 20.0 * v);
        let (sin, cos) = 120_f64.to_radians().sin_cos();
        let on_arc = |center: [f64; 2], radius: f64, degrees: f64, side: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            [[center[0] + radius * cos, center[1] + radius * sin, z], [side * cos, side * sin, 0.0]]
        };
        if angle <= 60.0 {
            on_arc([14.0, 0.0], 14.0, 180.0 - angle, -1.0)
        } else {
            on_arc([14.0 + 60.0 * cos, 60.0 * sin], 46.0, 240.0 + angle, 1.0)
        }
    })
}

fn hook() -> Result<Findings, VerificationError> {
    let (small, mut convergence) = (1e-3, Convergence::default());
    convergence.case("displacement of the free end", &[2, 4, 8], (5.0382, 5e-3), |n| {
        let model = cantilever(&hook_mesh(n as usize), [0.0, 0.0, 0.05 * small]);
        Ok((solve(&model)?.last("tip.z")? - 10.0) / small)
    })?;
    Ok(convergence.finish("elements per 30 degrees"))
}

/// Small displacements of the beams.
const SMALL: f64 = 1e-5;

/// Slope of the line after the k-th of six elements.
type Slope = fn(i32) -> f64;

/// Shapes of the elements.
const SHAPES: [(&str, Slope); 3] = [
    ("rectangles", |_| 0.0),
    ("trapezoids", |k| if k % 2 == 1 { 1.0 } else { -1.0 }),
    ("parallelograms", |_| 1.0),
];

/// Straight beam of six elements, each divided into n × n.
fn straight_mesh(n: usize, slope: Slope) -> MeshModel {
    MeshModel::grid([6 * n, n], 0.1, isotropic([1e7, 0.3, 1.0]), |[u, v]| {
        let before = (6.0 * u).floor().min(5.0);
        let part = 6.0 * u - before;
        let slope = |k: f64| if k > 0.5 && k < 5.5 { slope(k.round() as i32) } else { 0.0 };
        let mean = (1.0 - part) * slope(before) + part * slope(before + 1.0);
        [[6.0 * u + 0.1 * (2.0 * v - 1.0) * mean, 0.2 * v, 0.0], [0.0, 0.0, 1.0]]
    })
}

/// Displacement of the tip of the straight beam along an axis under a unit force, mean of both corners.
fn tip(shell: &MeshModel, axis: usize) -> Result<f64, VerificationError> {
    let mut force = [0.0; 3];
    force[axis] = SMALL / 0.2;
    let solved = solve(&(cantilever(shell, force) + &probe("a", "p10") + &probe("b", "p11")))?;
    let (name, start) = [("x", 6.0), ("y", 0.1), ("z", 0.0)][axis];
    let sum = solved.last(&format!("a.{name}"))? + solved.last(&format!("b.{name}"))?;
    Ok((0.5 * sum - start) / SMALL)
}

/// Angle of the tip of the straight beam under a unit torque.
fn torsion(shell: &MeshModel) -> Result<f64, VerificationError> {
    let forces = force("p10", [0.0, 0.0, -SMALL / 0.2]) + &force("p11", [0.0, 0.0, SMALL / 0.2]);
    let model = cantilever(shell, [0.0; 3]) + &forces + &probe("a", "p10") + &probe("b", "p11");
    let solved = solve(&model)?;
    Ok((solved.last("b.z")? - solved.last("a.z")?) / (0.2 * SMALL))
}

fn straight() -> Result<Findings, VerificationError> {
    let mut convergence = Convergence::default();
    let twist = {
        let (shear, c) = (1e7 / 2.6, 10_f64.sqrt());
        6.0 / (shear * 0.2 * 1e-3 / 3.0 * (1.0 - c.tanh() / c))
    };
    for (name, slope) in SHAPES {
        convergence.case(format!("in plane, 48 x 8 {name}"), &[1, 2, 4, 8], (0.1081, 5e-3), |n| {
            tip(&straight_mesh(n as usize, slope), 1)
        })?;
    }
    convergence.case("torsion, 48 x 8 rectangles", &[1, 2, 4, 8], (twist, 2e-2), |n| {
        torsion(&straight_mesh(n as usize, SHAPES[0].1))
    })?;
    let mut found = convergence.finish("elements along the width");
    let mut curves = Vec::new();
    let independent = [(0.1081, 1e-2), (0.0055697, 1e-4), (0.0683496, 1e-4)];
    for ((name, slope), plane) in SHAPES.into_iter().zip(independent) {
        let mut points = Vec::new();
        let cases = [
            ("along", 3e-5, (3e-5, 5e-3)),
            ("in plane", 0.1081, plane),
            ("out of plane", 0.4321, (0.4321, 4e-2)),
        ];
        for (axis, (case, theory, (exact, tolerance))) in cases.into_iter().enumerate() {
            let ours = tip(&straight_mesh(1, slope), axis)?;
            found.compare(format!("{case}, 6 x 1 {name}"), ours, exact, exact, tolerance);
            points.push([(axis + 1) as f64, ours / theory]);
        }
        curves.push(PlotCurve::points(name, points));
    }
    let axes = ["along (1), in plane (2), out of plane (3)", "ratio"];
    found.plot(Plot::new("Six elements: displacement, relative to the theory", axes, curves));
    Ok(found)
}

fn curved() -> Result<Findings, VerificationError> {
    let mut convergence = Convergence::default();
    let [a, b] = [4.12_f64, 4.32].map(|r| r * r);
    let golovin = PI * (a + b) / (1e6 * (a - b + 0.5 * (a + b) * (b / a).ln()));
    for (name, column, force, start, exact) in [
        ("in plane", "tip.y", [0.0, 1.0, 0.0], 4.22, (golovin, 2e-3)),
        ("out of plane", "tip.z", [0.0, 0.0, 1.0], 0.0, (0.5022, 1e-2)),
    ] {
        convergence.case(name, &[12, 24, 48, 96], exact, |n| {
            let shell =
                MeshModel::grid([n as usize, n as usize / 6], 0.1, isotropic([1e7, 0.25, 1.0]), |[u, v]| {
                    let ((sin, cos), radius) = ((FRAC_PI_2 * u).sin_cos(), 4.32 - 0.2 * v);
                    [[radius * cos, radius * sin, 0.0], [0.0, 0.0, 1.0]]
                });
            let model = cantilever(&shell, force.map(|x| x * SMALL / 0.2));
            Ok((solve(&model)?.last(column)? - start) / SMALL)
        })?;
    }
    Ok(convergence.finish("elements along the beam"))
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
