//! Circular plates and a full hemisphere: meshes of several patches without a singular node.

use std::f64::consts::{FRAC_PI_4, PI};

use super::mesh::{MeshModel, edge, force, isotropic, node, probe};
use crate::problems::models::{Convergence, study};
use crate::{Findings, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "circular_plates",
        title: "Circular plates of four-node shells under a uniform load and a force in the centre",
        source: "Timoshenko & Woinowsky-Krieger (1959), sections 16 and 19: q a⁴/(64 D) and P a²/(16 π D) for a clamped edge, times (5 + ν)/(1 + ν) \
                 and (3 + ν)/(1 + ν) for a hinged edge. The theory of Reissner and Mindlin adds q a²/(4 κ G h), κ = 5/6",
        sketch: r"
        .-''-.
       /   |//\           a = 1, D = 1, ν = 0.3
      (----F---)          h = 0.001, and h = 0.2 under the uniform load
       \   |  /           a quarter of three patches as the model
        '-..-'",
        goal: "Deflection of the centre within 0.5 % with 3 × 8 × 8 elements. Edges of polygons on soft supports have the limit of the circle",
        run: circles,
    },
    Problem {
        name: "shear_shell_full_hemisphere",
        title: "Full hemisphere of four-node shells, four radial forces",
        source: "Data of MacNeal & Harder (1985), who have 0.0924. 0.092378 by an independent Kirchhoff-Love code, with a hole of 0.1 \
                 degrees",
        sketch: r"
        .-''-.            R = 10, h = 0.04, E = 6.825e7, ν = 0.3
       (      ) ->        forces of alternating sign at the equator
        '----'            a quarter of three patches as the model",
        goal: "Displacement under the force within 0.5 % with 3 × 12 × 12 elements. Nearly inextensible",
        run: hemisphere,
    },
];

/// Small displacements.
const SMALL: f64 = 1e-6;
/// Two coordinates that count as equal.
const CLOSE: f64 = 1e-9;

/// Point of the square in the middle of a quarter of a disc: a quadrilateral with a corner on the line at 45 degrees.
fn inner([u, v]: [f64; 2]) -> [f64; 2] {
    let coordinate = |u: f64, v: f64| 0.5 * u * (1.0 - v) + 0.42 * u * v;
    [coordinate(u, v), coordinate(v, u)]
}

/// Point of the patch between this square and the arc from 0 to 45 degrees.
fn outer([u, v]: [f64; 2]) -> [f64; 2] {
    let ([x, y], (sin, cos)) = (inner([1.0, v]), (FRAC_PI_4 * v).sin_cos());
    [x + u * (cos - x), y + u * (sin - y)]
}

/// Quarter of a disc of the radius 1 with D = 1 for ν = 0.3. The edges are `x`, `y` and `arc`, the centre is `c`.
fn quarter_disc(n: usize, h: f64) -> MeshModel {
    let material = isotropic([12.0 * (1.0 - 0.09) / h.powi(3), 0.3, 1.0]);
    let flat = |[x, y]: [f64; 2]| [[x, y, 0.0], [0.0, 0.0, 1.0]];
    let mirrored = |[u, v]: [f64; 2]| {
        let [y, x] = outer([v, u]);
        flat([x, y])
    };
    MeshModel::patches(n, h, material, &[&|at| flat(inner(at)), &|at| flat(outer(at)), &mirrored])
        .with_edge("x", |[x, y, _]| (y.abs() < CLOSE).then_some(x))
        .with_edge("y", |[x, y, _]| (x.abs() < CLOSE).then_some(y))
        .with_edge("arc", |[x, y, _]| (x.hypot(y) > 1.0 - CLOSE).then_some(y))
        .with_point("c", [0.0; 3])
}

fn circles() -> Result<Findings, VerificationError> {
    let uniform = format!("[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, {SMALL:e}]\n");
    let point = force("c", [0.0, 0.0, 0.25 * SMALL]);
    let mut convergence = Convergence::default();
    for (condition, support, factors) in [
        ("clamped", edge("arc", "\"clamped\""), [1.0, 1.0]),
        ("hinged", edge("arc", "\"guided\"\naxes = [\"z\"]"), [5.3 / 1.3, 3.3 / 1.3]),
    ] {
        // Shear: κ G h = 5/6 · 12 (1 − ν²)/h² / (2 (1 + ν)) for D = 1.
        let shear = |h: f64| 0.25 / (5.0 * 0.7 / (h * h));
        let [spread, single] = [factors[0] / 64.0, factors[1] / (16.0 * PI)];
        for (name, h, load, exact) in [
            ("q", 1e-3, &uniform, spread + shear(1e-3)),
            ("q", 0.2, &uniform, spread + shear(0.2)),
            ("P", 1e-3, &point, single),
        ] {
            convergence.case(format!("{condition}, {name}, h = {h}"), &[2, 4, 8], (exact, 5e-3), |n| {
                let model = format!(
                    "{}{}{}{support}{load}{}[analysis]\nkind = \"statics\"\n",
                    quarter_disc(n as usize, h),
                    edge("x", "\"symmetry\""),
                    edge("y", "\"symmetry\""),
                    probe("c", "c")
                );
                Ok(solve(&model)?.last("c.z")? / SMALL)
            })?;
        }
    }
    Ok(convergence.finish("elements along an edge of a patch"))
}

/// Quarter of a hemisphere of the radius 10. The edges of symmetry are `x` and `y`, the loaded points `A` and `B`.
fn octant(n: usize) -> MeshModel {
    let patch = |axis: usize| {
        move |[u, v]: [f64; 2]| {
            let mut normal = [0.0; 3];
            normal[axis] = 1.0;
            normal[(axis + 1) % 3] = (FRAC_PI_4 * u).tan();
            normal[(axis + 2) % 3] = (FRAC_PI_4 * v).tan();
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            let normal = normal.map(|x| x / length);
            [normal.map(|x| 10.0 * x), normal]
        }
    };
    MeshModel::patches(n, 0.04, isotropic([6.825e7, 0.3, 1.0]), &[&patch(0), &patch(1), &patch(2)])
        .with_edge("x", |[x, _, z]| (x.abs() < CLOSE).then_some(z))
        .with_edge("y", |[_, y, z]| (y.abs() < CLOSE).then_some(z))
        .with_point("A", [10.0, 0.0, 0.0])
        .with_point("B", [0.0, 10.0, 0.0])
}

fn hemisphere() -> Result<Findings, VerificationError> {
    let small = 1e-3;
    study(&[4, 8, 12], "displacement under the outward force", (0.092378, 5e-3), |n| {
        let model = format!(
            "{}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            octant(n as usize),
            edge("x", "\"symmetry\""),
            edge("y", "\"symmetry\""),
            node("A", "\"z\""),
            force("A", [small, 0.0, 0.0]),
            force("B", [0.0, -small, 0.0]),
            probe("A", "A")
        );
        Ok((solve(&model)?.last("A.x")? - 10.0) / small)
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
