//! Pinched cylinder with wrinkles: problem 3.6 of Sze, Liu and Lo (2004).

use std::f64::consts::FRAC_PI_2;

use super::mesh::{MeshModel, edge, force, isotropic, probe};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[Problem {
    name: "shear_shell_pinched_cylinder_large",
    title: "Cylinder between diaphragms of four-node shells under two large forces",
    source: "Table of Sze, Liu & Lo (2004), section 3.6, 48 × 48 elements per eighth",
    sketch: r"
           | F
      .----v----.         R = 100, L = 200, h = 1, E = 30 000, ν = 0.3
     |           |        F = 12 000, ends on rigid diaphragms
      '----^----'
           | F",
    goal: "An eighth of the cylinder with 48 × 16 elements, narrow across the wrinkles: deflection under the force within 2 % and \
           displacement at 90 degrees within 5 % below a tenth of the load and above 0.3 of it, on one path. Between them wrinkles \
           form, and both depend on the mesh: with 48 × 48 elements they are greater by 1 % and 3 % at the full load",
    run: pinched,
}];

/// Load factor, deflection under the force and outward displacement at 90 degrees.
const TABLE: [[f64; 3]; 13] = [
    [0.05, 9.561, -0.233],
    [0.075, 15.648, -0.922],
    [0.1, 23.164, -2.391],
    [0.15, 36.208, -2.154],
    [0.2, 56.373, 10.448],
    [0.3, 65.498, 17.979],
    [0.4, 70.424, 22.321],
    [0.5, 73.790, 25.381],
    [0.6, 76.331, 27.735],
    [0.7, 78.451, 29.772],
    [0.8, 80.218, 31.471],
    [0.9, 81.766, 32.989],
    [1.0, 83.102, 34.272],
];
/// Load factors between which the displacements depend on the mesh.
const WRINKLING: [f64; 2] = [0.1, 0.3];

fn model() -> String {
    let shell = MeshModel::grid([48, 16], 1.0, isotropic([30e3, 0.3, 1.0]), |[u, v]| {
        let (sin, cos) = (FRAC_PI_2 * u).sin_cos();
        [[100.0 * sin, 100.0 * v, 100.0 * cos], [sin, 0.0, cos]]
    });
    format!(
        "{shell}{}{}{}{}{}{}{}[analysis]\nkind = \"path\"\n",
        edge("u0", "\"symmetry\""),
        edge("u1", "\"symmetry\""),
        edge("v0", "\"symmetry\""),
        edge("v1", "\"guided\"\naxes = [\"x\", \"z\"]"),
        force("p00", [0.0, 0.0, -3000.0]),
        probe("A", "p00"),
        probe("B", "p10")
    )
}

/// Displacements along the path: load factor, deflection under the force and outward displacement at 90 degrees.
fn path(solved: &SolvedModel) -> Result<Vec<[f64; 3]>, VerificationError> {
    let [load, a, b] = [solved.column("load")?, solved.column("A.z")?, solved.column("B.x")?];
    Ok((0..load.len()).map(|k| [load[k], 100.0 - a[k], b[k] - 100.0]).collect())
}

/// Displacements at a load factor, between two points of the path.
fn at(path: &[[f64; 3]], load: f64) -> Option<[f64; 2]> {
    let is_between = |pair: &&[[f64; 3]]| (pair[0][0] - load) * (pair[1][0] - load) <= 0.0;
    let pair = path.windows(2).rev().find(is_between)?;
    let part = (load - pair[0][0]) / (pair[1][0] - pair[0][0]);
    Some([1, 2].map(|k| pair[0][k] + part * (pair[1][k] - pair[0][k])))
}

fn pinched() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let solved = solve(&model())?;
    let path = path(&solved)?;
    for [load, w, u] in TABLE {
        if load > WRINKLING[0] && load < WRINKLING[1] {
            continue;
        }
        let ours = at(&path, load);
        let ours = ours.ok_or_else(|| VerificationError::Missing(format!("load factor {load}")))?;
        found.compare(format!("deflection under the force at {load} of the load"), ours[0], w, w, 2e-2);
        found.compare(format!("displacement at 90 degrees at {load} of the load"), ours[1], u, u, 5e-2);
    }
    let curve = |k: usize, points: &[[f64; 3]]| points.iter().map(|point| [point[k], point[0]]).collect();
    let curves = vec![
        PlotCurve::line("under the force", curve(1, &path)),
        PlotCurve::points("under the force, table", curve(1, &TABLE)),
        PlotCurve::line("at 90 degrees", curve(2, &path)),
        PlotCurve::points("at 90 degrees, table", curve(2, &TABLE)),
    ];
    let summary = &solved.summary;
    let title = format!("Displacements; {} points, {} iterations", summary.steps, summary.iterations);
    found.plot(Plot::new(title, ["displacement", "load factor"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
