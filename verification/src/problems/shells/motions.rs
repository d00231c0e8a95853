//! Pendulums of plates.

use super::models::{ShellModel, probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "plate_pendulum",
        title: "Stiff square plate that swings about a corner",
        source: "Rigid plate without the inertia of its thickness: J/m = 7/12 a², period 2.15064439203 s from the horizontal by the \
                 complete elliptic integral",
        sketch: r"
      o--------+
      |        |   1 × 1 × 0.01 m, E = 210 GPa, released from the horizontal
      +--------+",
        goal: "After a quarter of the period the centre is below the corner, within 2e-4 m",
        run: rigid,
    },
    Problem {
        name: "flexible_plate_pendulum",
        title: "Flexible plate that swings about a corner",
        source: "Recomputed by an independent Kirchhoff-Love code: B-splines of degree 4, 12 × 6 elements, generalized-α with \
                 ρ = 0.9, h = 1e-3; coarser meshes and steps differ by less than 2e-4",
        sketch: r"
      o--------------+
      |              |   0.6 × 0.3 × 0.01 m, E = 1e8, ν = 0.3, released from the horizontal
      +--------------+",
        goal: "8 × 4 elements: three corners within 1e-3 m at 0.1, 0.2 and 0.3 s",
        run: flexible,
    },
];

const BALL: &str = "[[joints]]\nkind = \"spherical\"\nname = \"ball\"\na = { body = \"s\", at = [0, 0] }\n";

fn rigid() -> Result<Findings, VerificationError> {
    let shell = ShellModel {
        surface: "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]",
        elements: [2, 2],
        thickness: 0.01,
        material: [2.1e11, 0.3, 7810.0],
    };
    let quarter: f64 = 0.25 * 2.15064439203;
    let model = format!(
        "gravity = [0, 0, -9.81]\n{shell}{BALL}{}[analysis]\nkind = \"dynamics\"\nduration = {quarter:?}\nstep = 1e-3\n",
        probe("centre", [0.5, 0.5])
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    let arm = 0.5_f64.sqrt();
    for (name, exact) in [("centre.x", 0.0), ("centre.y", 0.0), ("centre.z", -arm)] {
        found.compare(name, solved.last(name)?, exact, 1.0, 2e-4);
    }
    let curves = vec![
        PlotCurve::line("computed", solved.points("centre.x", "centre.z")?),
        PlotCurve::points("rigid", vec![[0.5, 0.0], [0.0, -arm]]),
    ];
    found.plot(Plot::new("Path of the centre", ["x, m", "z, m"], curves));
    Ok(found)
}

/// Time and positions of the corners (0.6, 0.3), (0.6, 0) and (0, 0.3).
const REFERENCE: [(f64, [[f64; 3]; 3]); 3] = [
    (0.1, [[0.59518, 0.29890, -0.04638], [0.59678, -0.00109, -0.04958], [-0.00481, 0.29549, -0.05224]]),
    (0.2, [[0.53854, 0.28188, -0.25956], [0.56995, -0.00277, -0.16999], [-0.04890, 0.25320, -0.15357]]),
    (0.3, [[0.3002, 0.0978, -0.59229], [0.4763, 0.0091, -0.36610], [-0.1708, 0.1094, -0.22130]]),
];

fn flexible() -> Result<Findings, VerificationError> {
    let shell = ShellModel {
        surface: "kind = \"flat\", corner = [0, 0, 0], side_u = [0.6, 0, 0], side_v = [0, 0.3, 0]",
        elements: [8, 4],
        thickness: 0.01,
        material: [1e8, 0.3, 7810.0],
    };
    let corners = [("A", [1.0, 1.0]), ("B", [1.0, 0.0]), ("C", [0.0, 1.0])];
    let model = format!(
        "gravity = [0, 0, -9.81]\n{shell}{BALL}{}[analysis]\nkind = \"dynamics\"\nduration = 0.3\nstep = 1e-3\n\
         scheme = {{ spectral_radius = 0.9 }}\n",
        corners.map(|(name, at)| probe(name, at)).concat()
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    for (time, corners_then) in REFERENCE {
        for ((name, _), exact) in corners.iter().zip(corners_then) {
            for (axis, exact) in ["x", "y", "z"].into_iter().zip(exact) {
                let column = format!("{name}.{axis}");
                let ours = solved.at(&column, time)?;
                found.compare(format!("{column} at {time} s"), ours, exact, 1.0, 1e-3);
            }
        }
    }
    let points = REFERENCE.iter().map(|(t, corners)| [*t, corners[0][2]]).collect();
    let curves = vec![
        PlotCurve::line("8 x 4 elements", solved.points("t", "A.z")?),
        PlotCurve::points("reference", points),
    ];
    found.plot(Plot::new("Corner opposite to the joint", ["t, s", "z, m"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
