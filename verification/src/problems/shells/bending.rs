//! Strips and annuli that bend by large rotations.

use std::f64::consts::{PI, TAU};

use super::models::{ShellModel, edge, edge_load, probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "shell_roll_up",
        title: "Plate strip rolled up by a moment at its end",
        source: "Inextensible strip: a circle of radius EI/M. Data of Sze, Liu & Lo (2004), section 3.2",
        sketch: r"
  |/|================ M    L = 12, b = 1, h = 0.1, E = 1.2e6, ν = 0, M = 2π EI/L",
        goal: "16 elements: the strip is a full circle, tip within 1e-3 of the length; within 1e-3 at a quarter of the moment",
        run: roll_up,
    },
    Problem {
        name: "shell_cantilever",
        title: "Plate strip bent by a force at its end",
        source: "Inextensible elastica, recomputed by elliptic functions. Data of Sze, Liu & Lo (2004), section 3.1",
        sketch: r"
  |/|================ F    L = 10, b = 1, h = 0.1, E = 1.2e6, ν = 0, F = 4",
        goal: "16 elements: displacements of the tip within 1e-3 of the exact ones",
        run: cantilever,
    },
    Problem {
        name: "slit_annulus",
        title: "Annular plate with a slit, one edge clamped, the other lifted",
        source: "Sze, Liu & Lo (2004), section 3.3; recomputed by an independent Kirchhoff-Love code with B-splines of degree 4 on \
                 10 × 63 elements",
        sketch: r"
     .--======--.        radii 6 and 10, h = 0.03, E = 21e6, ν = 0
    (     __     )       line force 0.8 times 0.1 along the slit
     '--==|/==--'",
        goal: "4 × 30 elements at a tenth of the full load: both ends of the loaded edge within 1 %",
        run: annulus,
    },
];

/// Flat strip along x.
const fn strip(surface: &str, elements: u32) -> ShellModel<'_> {
    ShellModel { surface, elements: [elements, 1], thickness: 0.1, material: [1.2e6, 0.0, 1.0] }
}

fn roll_up() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let surface = "kind = \"flat\", corner = [0, 0, 0], side_u = [12, 0, 0], side_v = [0, 1, 0]";
    let mut points = Vec::new();
    for part in [0.25, 1.0] {
        let moment = -part * 50.0 * PI / 3.0;
        let model = format!(
            "{}{}{}follower = true\n{}[analysis]\nkind = \"statics\"\n",
            strip(surface, 16),
            edge("u_start", "\"clamped\""),
            edge_load("edge_moment", "u_end", "moment", [0.0, moment, 0.0]),
            probe("tip", [1.0, 0.5])
        );
        let solved = solve(&model)?;
        let angle = TAU * part;
        let exact = [12.0 * angle.sin() / angle, 12.0 * (1.0 - angle.cos()) / angle];
        for (axis, exact) in [("tip.x", exact[0]), ("tip.z", exact[1])] {
            found.compare(format!("{axis} at {part} M"), solved.last(axis)?, exact, 12.0, 1e-3);
        }
        points.extend(solved.points("tip.x", "tip.z")?);
    }
    let exact = (1..=40).map(|k| {
        let angle = TAU * f64::from(k) / 40.0;
        [12.0 * angle.sin() / angle, 12.0 * (1.0 - angle.cos()) / angle]
    });
    let curves = vec![PlotCurve::line("exact", exact.collect()), PlotCurve::points("16 elements", points)];
    found.plot(Plot::new("Path of the tip", ["x", "z"], curves).with_equal_scales());
    Ok(found)
}

/// Displacements −u and w of the elastica at tenths of the force.
const ELASTICA: [[f64; 2]; 5] = [
    [0.381656132405, 2.49451542028],
    [1.18596080493, 4.29412751703],
    [2.00464315477, 5.44546965452],
    [2.70803086466, 6.19177498338],
    [3.28941242247, 6.69964181278],
];

fn cantilever() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let surface = "kind = \"flat\", corner = [0, 0, 0], side_u = [10, 0, 0], side_v = [0, 1, 0]";
    let mut points = Vec::new();
    for (k, exact) in ELASTICA.into_iter().enumerate() {
        let force = 0.8 * (k + 1) as f64;
        let model = format!(
            "{}{}{}{}[analysis]\nkind = \"statics\"\n",
            strip(surface, 16),
            edge("u_start", "\"clamped\""),
            edge_load("edge_force", "u_end", "force", [0.0, 0.0, force]),
            probe("tip", [1.0, 0.5])
        );
        let solved = solve(&model)?;
        let ours = [10.0 - solved.last("tip.x")?, solved.last("tip.z")?];
        for (axis, (ours, exact)) in ["-u", "w"].into_iter().zip(ours.into_iter().zip(exact)) {
            found.compare(format!("{axis} of the tip, F = {force:.1}"), ours, exact, exact, 1e-3);
        }
        points.push([force, ours[1]]);
    }
    let exact = ELASTICA.iter().enumerate().map(|(k, w)| [0.8 * (k + 1) as f64, w[1]]).collect();
    let curves = vec![PlotCurve::line("16 elements", points), PlotCurve::points("elastica", exact)];
    found.plot(Plot::new("Deflection of the tip", ["F", "w"], curves));
    Ok(found)
}

fn annulus() -> Result<Findings, VerificationError> {
    let shell = ShellModel {
        surface: "kind = \"revolved\", from = [6, 0, 0], to = [10, 0, 0], center = [0, 0, 0], axis = [0, 0, 1], \
                  angle = 6.283185307179586",
        elements: [30, 4],
        thickness: 0.03,
        material: [21e6, 0.0, 1.0],
    };
    let model = format!(
        "{shell}{}{}{}{}[analysis]\nkind = \"statics\"\n",
        edge("u_start", "\"clamped\""),
        edge_load("edge_force", "u_end", "force", [0.0, 0.0, 0.08]),
        probe("A", [1.0, 0.0]),
        probe("B", [1.0, 1.0])
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    for (name, exact) in [("A.z", 4.26335), ("B.z", 5.85933)] {
        found.compare(name, solved.last(name)?, exact, exact, 1e-2);
    }
    let reference = vec![[1.0, 4.26335], [1.0, 5.85933]];
    let curves = vec![
        PlotCurve::line("A, inner end", solved.points("load", "A.z")?),
        PlotCurve::line("B, outer end", solved.points("load", "B.z")?),
        PlotCurve::points("reference", reference),
    ];
    found.plot(Plot::new("Deflection of the loaded edge", ["load factor", "z"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
