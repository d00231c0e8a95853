//! Shear-deformable shells with small displacements: tests of locking.

use std::f64::consts::FRAC_PI_2;

use super::mesh::{MeshModel, edge, edge_load, force, isotropic, node, probe};
use crate::problems::models::study;
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "shear_shell_roof",
        title: "Scordelis-Lo roof of four-node shells",
        source: "Data of MacNeal & Harder (1985). 0.300592 by an independent Kirchhoff-Love code; with transverse shear 0.301 to 0.302",
        sketch: r"
       .-''''-.           R = 25, L = 50, half angle 40 degrees, h = 0.25
     .'        '.         E = 4.32e8, ν = 0, weight 90 per area
     |          |         diaphragms at both ends",
        goal: "A quarter of the roof: deflection of the middle of the free edge within 0.5 % of 0.3013 with 16 × 16 elements",
        run: roof,
    },
    Problem {
        name: "shear_shell_pinched_cylinder",
        title: "Cylinder between diaphragms of four-node shells, pinched by two forces",
        source: "Fourier series of Lindberg et al. (1969): 1.82488e-5; 1.8282e-5 by an independent Kirchhoff-Love code",
        sketch: r"
         F
      .--v--.             R = 300, L = 600, h = 3, E = 3e6, ν = 0.3
     (       )
      '--^--'
         F",
        goal: "An eighth of the cylinder: displacement under the force within 1 % of 1.8282e-5 with 40 × 40 elements. With transverse shear the \
               displacement under the force grows without limit on finer meshes",
        run: cylinder,
    },
    Problem {
        name: "shear_shell_hemisphere",
        title: "Hemisphere with a hole of four-node shells, four radial forces",
        source: "Data of MacNeal & Harder (1985). 0.0935213 by an independent Kirchhoff-Love code",
        sketch: r"
        .--__--.          R = 10, h = 0.04, E = 6.825e7, ν = 0.3
       (        ) ->      forces of alternating sign at the equator
        '------'",
        goal: "A quarter of the hemisphere: displacement under the force within 0.5 % with 16 × 16 elements. Nearly inextensible",
        run: hemisphere,
    },
    Problem {
        name: "shear_shell_cook",
        title: "Cook's membrane of four-node shells",
        source: "Data of Cook (1974). 23.968, extrapolated from meshes of up to 128 × 128 elements with nine nodes",
        sketch: r"
              __+ 60
       44 +--'  |       plane stress, t = 1, E = 1, ν = 1/3
          |   __+ 44    shear force of 1 on the right side
        0 +--'          left side clamped, x = 0 to 48",
        goal: "Displacement of the middle of the loaded side within 0.5 % with 32 × 32 elements of distorted shape",
        run: cook,
    },
    Problem {
        name: "shear_shell_patch",
        title: "Patch tests of a distorted mesh",
        source: "MacNeal & Harder (1985): ε_x = ε_y = γ_xy = 1e-3, σ_x = σ_y = 1333.3333, τ = 400; m_x = m_y = 1.1111111e-7, \
                 m_xy = 3.3333333e-8",
        sketch: r"
      +-------------+
      | \  +---+  / |   0.24 × 0.12, t = 0.001, E = 1e6, ν = 0.25
      |  +-'    '-+ |   five elements
      +-------------+",
        goal: "Uniform membrane forces and moments at all nodes to 1e-6 of them, with small displacements",
        run: patch,
    },
];

/// Small displacements: loads are divided by a thousand.
const SMALL: f64 = 1e-3;

/// Point and normal of a cylinder about the y-axis at an angle from the z-axis.
fn on_cylinder(radius: f64, angle: f64, y: f64) -> [[f64; 3]; 2] {
    let (sin, cos) = angle.sin_cos();
    [[radius * sin, y, radius * cos], [sin, 0.0, cos]]
}

/// Point and normal of a sphere at a longitude and a latitude.
pub(super) fn on_sphere(radius: f64, longitude: f64, latitude: f64) -> [[f64; 3]; 2] {
    let normal = [latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin()];
    [normal.map(|x| radius * x), normal]
}

fn roof() -> Result<Findings, VerificationError> {
    roof_of(&[4, 8, 16], |shell| shell)
}

/// Roof of changed grids of quadrilaterals.
pub(super) fn roof_of(
    meshes: &[u32],
    changed: impl Fn(MeshModel) -> MeshModel,
) -> Result<Findings, VerificationError> {
    let half = 40.0_f64.to_radians();
    study(meshes, "deflection of the free edge", (0.3013, 5e-3), |n| {
        let shell =
            changed(MeshModel::grid([n as usize; 2], 0.25, isotropic([4.32e8, 0.0, 1.0]), |[u, v]| {
                on_cylinder(25.0, half * u, 25.0 * v)
            }));
        let model = format!(
            "gravity = [0, 0, {:e}]\n{shell}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            -360.0 * SMALL,
            edge("u0", "\"symmetry\""),
            edge("v0", "\"symmetry\""),
            edge("v1", "\"guided\"\naxes = [\"x\", \"z\"]"),
            probe("edge", "p10")
        );
        Ok((25.0 * half.cos() - solve(&model)?.last("edge.z")?) / SMALL)
    })
}

fn cylinder() -> Result<Findings, VerificationError> {
    let scale = 1e3;
    study(&[10, 20, 40], "displacement under the force", (1.8282e-5, 1e-2), |n| {
        let shell = MeshModel::grid([n as usize; 2], 3.0, isotropic([3e6, 0.3, 1.0]), |[u, v]| {
            on_cylinder(300.0, FRAC_PI_2 * u, 300.0 * v)
        });
        let model = format!(
            "{shell}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u0", "\"symmetry\""),
            edge("u1", "\"symmetry\""),
            edge("v0", "\"symmetry\""),
            edge("v1", "\"guided\"\naxes = [\"x\", \"z\"]"),
            force("p00", [0.0, 0.0, -0.25 * scale]),
            probe("p", "p00")
        );
        Ok((300.0 - solve(&model)?.last("p.z")?) / scale)
    })
}

fn hemisphere() -> Result<Findings, VerificationError> {
    study(&[4, 8, 16], "displacement under the outward force", (0.0935213, 5e-3), |n| {
        let shell = MeshModel::grid([n as usize; 2], 0.04, isotropic([6.825e7, 0.3, 1.0]), |[u, v]| {
            on_sphere(10.0, FRAC_PI_2 * u, 72.0_f64.to_radians() * v)
        });
        let model = format!(
            "{shell}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u0", "\"symmetry\""),
            edge("u1", "\"symmetry\""),
            node("p00", "\"z\""),
            force("p00", [SMALL, 0.0, 0.0]),
            force("p10", [0.0, -SMALL, 0.0]),
            probe("A", "p00")
        );
        Ok((solve(&model)?.last("A.x")? - 10.0) / SMALL)
    })
}

fn cook() -> Result<Findings, VerificationError> {
    let load = 1e-5;
    study(&[4, 8, 16, 32], "displacement of the loaded side", (23.968, 5e-3), |n| {
        let shell = MeshModel::grid([n as usize; 2], 1.0, isotropic([1.0, 1.0 / 3.0, 1.0]), |[u, v]| {
            [[48.0 * u, 44.0 * u + v * (44.0 - 28.0 * u), 0.0], [0.0, 0.0, 1.0]]
        });
        let model = format!(
            "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u0", "\"clamped\""),
            edge_load("edge_force", "u1", "force", [0.0, load / 16.0, 0.0]),
            probe("tip", "end")
        );
        Ok((solve(&model)?.last("tip.y")? - 52.0) / load)
    })
}

/// Mesh of the patch test.
pub(super) fn patch_mesh() -> MeshModel {
    let corners = [[0.0, 0.0], [0.24, 0.0], [0.24, 0.12], [0.0, 0.12]];
    let inner = [[0.04, 0.02], [0.18, 0.03], [0.16, 0.08], [0.08, 0.08]];
    let nodes: Vec<[f64; 3]> = corners.iter().chain(&inner).map(|[x, y]| [*x, *y, 0.0]).collect();
    let mut elements = vec![vec![4, 5, 6, 7]];
    elements.extend((0..4).map(|k| vec![k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k]));
    let mut groups = String::from("groups.edge = { edges = [[0, 1, 2, 3, 0]] }\n");
    for k in 0..8 {
        groups += &format!("groups.n{k} = {{ nodes = [{k}] }}\n");
    }
    MeshModel {
        directors: vec![[0.0, 0.0, 1.0]; nodes.len()],
        nodes,
        elements,
        groups,
        thickness: 1e-3,
        keys: String::new(),
        material: isotropic([1e6, 0.25, 1.0]),
    }
}

/// Statics under the nodal forces of uniform tractions on the outer edges, which are those of uniform stresses.
fn patch() -> Result<Findings, VerificationError> {
    patch_test(patch_mesh)
}

/// Patch test of a mesh with the nodes of [`patch_mesh`].
pub(super) fn patch_test(mesh: impl Fn() -> MeshModel) -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    let probes: String = (0..8)
        .map(|k| probe(&format!("n{k}"), &format!("n{k}")) + "record = [\"motion\", \"resultants\"]\n")
        .collect();
    let sides = [([0, 1], [0.0, -1.0]), ([1, 2], [1.0, 0.0]), ([2, 3], [0.0, 1.0]), ([3, 0], [-1.0, 0.0])];
    for (kind, key, [xx, yy, xy], scale) in [
        ("edge_force", "force", [4.0 / 3.0, 4.0 / 3.0, 0.4], 1e-8),
        ("edge_moment", "moment", [1.0 / 9.0e6, 1.0 / 9.0e6, 1.0 / 3.0e7], 1e-5),
    ] {
        let mut shell = mesh();
        let mut loads = String::new();
        for ([a, b], [x, y]) in sides {
            shell.groups += &format!("groups.side{a} = {{ edges = [[{a}, {b}]] }}\n");
            let [p, q] = [scale * (xx * x + xy * y), scale * (xy * x + yy * y)];
            // A moment per length m·ν acts on the rotation of the director: n × (m ν).
            let load = if kind == "edge_force" { [p, q, 0.0] } else { [-q, p, 0.0] };
            loads += &edge_load(kind, &format!("side{a}"), key, load);
        }
        let model = format!(
            "{shell}{}{}{}{loads}{probes}[analysis]\nkind = \"statics\"\n",
            node("n0", "\"x\", \"y\", \"z\""),
            node("n1", "\"y\", \"z\""),
            node("n3", "\"z\"")
        );
        let solved = solve(&model)?;
        let letter = if kind == "edge_force" { 'n' } else { 'm' };
        for (component, exact) in [("uu", xx), ("vv", yy), ("uv", xy)] {
            let mut points = Vec::new();
            for k in 0..8 {
                let name = format!("n{k}.{letter}{component}");
                let ours = solved.last(&name)? / scale;
                points.push([f64::from(k), ours / exact]);
                found.compare(name, ours, exact, xx, 1e-6);
            }
            curves.push(PlotCurve::points(format!("{letter}_{component}"), points));
        }
    }
    found.plot(Plot::new("Resultants at the nodes, relative to the exact ones", ["node", "ratio"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
