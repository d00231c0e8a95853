//! Twisted, straight and curved strips with small displacements.

use std::f64::consts::PI;

use super::models::{ShellModel, edge, edge_load, probe};
use crate::problems::models::Convergence;
use crate::{Findings, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "twisted_strip",
        title: "Strip twisted by 90 degrees, thick and thin, loaded along and across its tip",
        source: "Data of MacNeal & Harder (1985), thin: Belytschko, Wong & Stolarski (1989). Recomputed by a Ritz series for the \
                 linear theory of Kirchhoff and Love: Legendre polynomials of degree 30 × 9, exact surface. Published: 5.424e-3, \
                 1.754e-3 (with transverse shear), 5.256e-3 and 1.294e-3. An independent Kirchhoff-Love code with B-splines of degree \
                 4 has 5.3994e-3, 1.7475e-3, 5.2490e-3 and 1.29303e-3",
        sketch: r"
  |/=====--__             L = 12, b = 1.1, h = 0.32 or 0.0032
  |/   __--  ||  F        E = 29e6, ν = 0.22
  |/===      ||           F = 1 or 1e-6 along the edge",
        goal: "Displacements of the tip in the direction of the force within 0.1 % of the Ritz series with 24 × 4 elements",
        run: twisted,
    },
    Problem {
        name: "shell_hook",
        title: "Raasch's hook of two cylindrical shells with a seam",
        source: "Data of Raasch, published by Knight (1997). 4.7187 by a Ritz series for the linear theory of Kirchhoff and Love: Legendre \
                 polynomials of degree 20 × 10 in each part. With transverse shear 5.0382: near free edges twisting requires it",
        sketch: r"
  |/__                    radius 14 over 60 degrees, then 46 over 150 degrees
      \      .-''-.       width 20, h = 2, E = 3300, ν = 0.35
       '----'      \      F = 1 along the width at the free end
                    | F",
        goal: "Displacement of the free end within 0.1 % with 28 × 4 elements: the seam transfers bending and twist",
        run: hook,
    },
    Problem {
        name: "shell_beams",
        title: "Straight and curved beam of MacNeal and Harder as a thin shell",
        source: "Data of MacNeal & Harder (1985). Straight: F L/(E A) = 3e-5, in plane 0.1081, out of plane 0.4321. Curved, in plane: \
                 π F (a² + b²)/(E t N), N = a² − b² + (a² + b²) ln(b/a) (Golovin 1881), which is 0.088566; MacNeal & Harder have 0.08734",
        sketch: r"
  |/===========| F        6 × 0.2 × 0.1, E = 1e7, ν = 0.3

  |/==._                  90 degrees, radii a = 4.12 and b = 4.32, t = 0.1
        '\                E = 1e7, ν = 0.25, F = 1
          | F",
        goal: "24 × 4 elements: tip displacements in plane within 0.2 %; out of plane within 1 %, where the clamped edge prevents the \
               lateral contraction. No torsion: a section of 0.2 × 0.1 requires transverse shear",
        run: beams,
    },
];

fn twisted() -> Result<Findings, VerificationError> {
    let surface = format!(
        "kind = \"twisted\", from = [0, 0, 0], to = [12, 0, 0], width = [0, 1.1, 0], twist = {:?}",
        0.5 * PI
    );
    let mut convergence = Convergence::default();
    for (thickness, force, name, exact) in [
        (0.32, 1e-2, "in plane", 5.3996e-3),
        (0.32, 1e-2, "out of plane", 1.75073e-3),
        (0.0032, 1e-8, "in plane", 5.2498e-3),
        (0.0032, 1e-8, "out of plane", 1.29280e-3),
    ] {
        let (column, direction) =
            if name == "in plane" { ("tip.z", [0.0, 0.0, 1.0]) } else { ("tip.y", [0.0, 1.0, 0.0]) };
        convergence.case(format!("h = {thickness}, {name}"), &[6, 12, 24], (exact, 1e-3), |n| {
            let shell = ShellModel {
                surface: &surface,
                elements: [n, n / 6],
                thickness,
                material: [29e6, 0.22, 1.0],
            };
            let model = format!(
                "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
                edge("u_start", "\"clamped\""),
                edge_load("edge_force", "u_end", "force", direction.map(|x| x * force / 1.1)),
                probe("tip", [1.0, 0.5])
            );
            // Displacements are small: 5e-5.
            Ok(solve(&model)?.last(column)? / 1e-2)
        })?;
    }
    Ok(convergence.finish("elements along the strip"))
}

/// Parts of the hook with n elements per 30 degrees, joined by a seam. The free end is at z = 0 to 20 of the part `s`.
fn hook_model(n: u32) -> String {
    let (sin, cos) = (2.0 * PI / 3.0).sin_cos();
    // The centres of both arcs and their common point are on a line.
    let [center, joint, other] =
        [0.0, 14.0, 60.0].map(|distance| [14.0 + distance * cos, distance * sin, 0.0]);
    let [mut top, mut start] = [joint, [0.0; 3]];
    (top[2], start[2]) = (20.0, 20.0);
    let surface = |from: [f64; 3], to: [f64; 3], center: [f64; 3], z: f64, angle: f64| {
        format!(
            "surface = {{ kind = \"revolved\", from = {from:?}, to = {to:?}, center = {center:?}, axis = [0, 0, {z:?}], \
             angle = {angle:?} }}"
        )
    };
    let parts = [
        ("root", surface([0.0; 3], start, center, -1.0, PI / 3.0), 2 * n),
        ("s", surface(joint, top, other, 1.0, 5.0 * PI / 6.0), 5 * n),
    ];
    let mut model = String::from("materials.m = { young = 3300, poisson = 0.35, density = 1 }\n");
    for (name, surface, along) in parts {
        model += &format!(
            "[[bodies]]\nkind = \"shell\"\nname = \"{name}\"\n{surface}\nelements = [{along}, {n}]\nthickness = 2.0\n\
             material = \"m\"\n"
        );
    }
    model
        + "[[joints]]\nkind = \"seam\"\nname = \"seam\"\na = { body = \"root\", at = { edge = \"u_end\" } }\n\
             b = { body = \"s\", at = { edge = \"u_start\" } }\n\
             [[joints]]\nkind = \"support\"\nname = \"wall\"\na = { body = \"root\", at = { edge = \"u_start\" } }\n\
             condition = \"clamped\"\n"
}

fn hook() -> Result<Findings, VerificationError> {
    let (small, mut convergence) = (1e-3, Convergence::default());
    convergence.case("displacement of the free end", &[1, 2, 4], (4.7187, 1e-3), |n| {
        let model = format!(
            "{}{}{}[analysis]\nkind = \"statics\"\n",
            hook_model(n),
            edge_load("edge_force", "u_end", "force", [0.0, 0.0, 0.05 * small]),
            probe("tip", [1.0, 0.5])
        );
        Ok((solve(&model)?.last("tip.z")? - 10.0) / small)
    })?;
    Ok(convergence.finish("elements per 30 degrees"))
}

fn beams() -> Result<Findings, VerificationError> {
    let (small, mut convergence) = (1e-5, Convergence::default());
    let straight = "kind = \"flat\", corner = [0, -0.1, 0], side_u = [6, 0, 0], side_v = [0, 0.2, 0]";
    let curved = "kind = \"revolved\", from = [4.12, 0, 0], to = [4.32, 0, 0], center = [0, 0, 0], axis = [0, 0, 1], \
                  angle = 1.5707963267948966";
    let [a, b] = [4.12_f64, 4.32].map(|r| r * r);
    let golovin = PI * (a + b) / (1e6 * (a - b + 0.5 * (a + b) * (b / a).ln()));
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (name, surface, poisson, (axis, force, start), exact) in [
        ("straight, along", straight, 0.3, ("tip.x", x, 6.0), (3e-5, 2e-3)),
        ("straight, in plane", straight, 0.3, ("tip.y", y, 0.0), (0.1081, 2e-3)),
        ("straight, out of plane", straight, 0.3, ("tip.z", z, 0.0), (0.4321, 1e-2)),
        ("curved, in plane", curved, 0.25, ("tip.y", y, 4.22), (golovin, 2e-3)),
    ] {
        convergence.case(name, &[6, 12, 24], exact, |n| {
            let shell =
                ShellModel { surface, elements: [n, n / 6], thickness: 0.1, material: [1e7, poisson, 1.0] };
            let model = format!(
                "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
                edge("u_start", "\"clamped\""),
                edge_load("edge_force", "u_end", "force", force.map(|x| x * small / 0.2)),
                probe("tip", [1.0, 0.5])
            );
            Ok((solve(&model)?.last(axis)? - start) / small)
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
