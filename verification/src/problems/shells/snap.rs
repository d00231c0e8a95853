//! Shallow roof with limit points: problem 3.8 of Sze, Liu and Lo (2004).

use super::models::{ShellModel, edge, force, increments, probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "hinged_roof",
        title: "Shallow roof with hinged straight edges: snap-through and snap-back",
        source: SOURCE,
        sketch: SKETCH,
        goal: "A quarter of the roof of thickness 12.7 and 6.35: loads of limit points within 1 % of the first one, deflections there \
               within 0.3 of the thickness 12.7 and its half, with 8 × 8 elements",
        run: isotropic,
    },
    Problem {
        name: "hinged_laminated_roof",
        title: "Shallow roof of three plies: snap-through and snap-back",
        source: SOURCE,
        sketch: SKETCH,
        goal: "Plies of E = 3300 and 1100, G = 660, ν = 0.25 with fibres along and across the axis: loads of limit points within 1 % of \
               the first one with 8 × 8 elements",
        run: laminated,
    },
];

const SOURCE: &str = "Data of Sze, Liu & Lo (2004), section 3.8. Limit points recomputed by an independent Kirchhoff-Love code with \
                      B-splines of degree 4 on 8 × 8 elements; points: the published table";
const SKETCH: &str = r"
           | F
        .--v--.        R = 2540, half angle 0.1, length 508, E = 3102.75, ν = 0.3
      o'       'o      straight edges hinged, curved edges free, F = 3000";

/// Roof with its limit points: load factors and deflections of the centre, and points of the published table.
struct Case {
    name: &'static str,
    thickness: f64,
    /// Angles of the fibres from the axis in quarter turns, without plies for an isotropic roof.
    plies: &'static [u8],
    limits: &'static [[f64; 2]],
    table: &'static [[f64; 2]],
}

const ISOTROPIC: [Case; 2] = [
    Case {
        name: "thickness 12.7",
        thickness: 12.7,
        plies: &[],
        limits: &[[0.7418, 10.72], [0.1703, 19.53]],
        table: &[
            [0.0877, 0.693],
            [0.4686, 4.477],
            [0.7246, 9.339],
            [0.6649, 13.583],
            [0.3830, 16.125],
            [0.1750, 19.028],
            [0.2303, 21.780],
            [0.5093, 25.293],
            [0.9643, 28.663],
        ],
    },
    Case {
        name: "thickness 6.35",
        thickness: 6.35,
        plies: &[],
        limits: &[[0.19496, 13.17], [-0.12883, 16.00]],
        table: &[
            [0.0517, 1.846],
            [0.1583, 8.257],
            [0.1901, 14.472],
            [0.0923, 16.602],
            [-0.0312, 16.697],
            [-0.1001, 14.520],
            [-0.1271, 16.961],
            [-0.0484, 23.100],
            [0.2403, 30.023],
            [0.8114, 36.626],
        ],
    },
];

const LAMINATED: [Case; 4] = [
    Case {
        name: "0/90/0, thickness 12.7",
        thickness: 12.7,
        plies: &[0, 1, 0],
        limits: &[[0.3608, 9.69], [-0.0521, 19.43]],
        table: &[
            [0.1245, 1.956],
            [0.3244, 6.892],
            [0.3057, 12.872],
            [0.0638, 16.199],
            [-0.0394, 20.698],
            [0.2178, 26.244],
            [0.7374, 31.622],
        ],
    },
    Case {
        name: "90/0/90, thickness 12.7",
        thickness: 12.7,
        plies: &[1, 0, 1],
        limits: &[[0.5967, 13.76], [0.2770, 21.28]],
        table: &[
            [0.1299, 1.581],
            [0.4365, 6.777],
            [0.5838, 12.024],
            [0.4971, 18.206],
            [0.2834, 20.881],
            [0.4832, 26.120],
            [0.8444, 29.844],
        ],
    },
    Case {
        name: "0/90/0, thickness 6.35",
        thickness: 6.35,
        plies: &[0, 1, 0],
        limits: &[[0.0810, 10.85], [-0.0819, 15.12], [0.0608, 12.29], [-0.0774, 15.22]],
        table: &[[0.0423, 3.414], [0.3213, 34.362], [0.7292, 40.274]],
    },
    Case {
        name: "90/0/90, thickness 6.35",
        thickness: 6.35,
        plies: &[1, 0, 1],
        limits: &[[0.1583, 15.83], [-0.0820, 16.85]],
        table: &[
            [0.0822, 5.205],
            [0.1562, 14.550],
            [0.1019, 19.429],
            [0.0036, 24.905],
            [0.2761, 32.401],
            [0.7747, 39.301],
        ],
    },
];

fn model(case: &Case) -> String {
    let shell = ShellModel {
        surface: "kind = \"revolved\", from = [0, 0, 2540], to = [0, 254, 2540], center = [0, 0, 0], axis = [0, 1, 0], angle = 0.1",
        elements: [8, 8],
        thickness: case.thickness,
        material: if case.plies.is_empty() { [3102.75, 0.3, 1.0] } else { [3300.0, 0.25, 1.0] },
    };
    let mut body = shell.to_string();
    if !case.plies.is_empty() {
        let angle =
            |quarter: &u8| format!("{{ angle = {:?} }}", f64::from(*quarter) * std::f64::consts::FRAC_PI_2);
        let angles: Vec<String> = case.plies.iter().map(angle).collect();
        body = body.replace("young", "orthotropic = { young = 1100, shear = 660 }, young");
        body += &format!("fibre_axis = [0, 1, 0]\nlayers = [{}]\n", angles.join(", "));
    }
    format!(
        "{body}{}{}{}{}{}[analysis]\nkind = \"path\"\n",
        edge("u_start", "\"symmetry\""),
        edge("u_end", "\"hinged\""),
        edge("v_start", "\"symmetry\""),
        force([0.0, 0.0], [0.0, 0.0, -750.0]),
        probe("A", [0.0, 0.0])
    )
}

fn run(cases: &[Case]) -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    for case in cases {
        let solved = solve(&model(case))?;
        let [load, limit] = [solved.column("load")?, solved.column("limit")?];
        let deflection: Vec<f64> = solved.column("A.z")?.iter().map(|z| 2540.0 - z).collect();
        let rows: Vec<usize> = (0..limit.len()).filter(|&row| limit[row] != 0.0).collect();
        for (k, [exact, place]) in case.limits.iter().enumerate() {
            let row = rows.get(k).copied();
            let row = row.ok_or_else(|| VerificationError::Missing(format!("limit point {}", k + 1)))?;
            let first = case.limits[0][0];
            found.compare(
                format!("load of limit point {}, {}", k + 1, case.name),
                load[row],
                *exact,
                first,
                1e-2,
            );
            found.compare(
                format!("deflection there, {}", case.name),
                deflection[row],
                *place,
                case.thickness,
                0.3,
            );
        }
        let path: Vec<[f64; 2]> = deflection.iter().zip(load).map(|(w, load)| [*w, *load]).collect();
        let table = case.table.iter().map(|[load, w]| [*w, *load]).collect();
        let curves = vec![PlotCurve::line("8 x 8 elements", path), PlotCurve::points("table", table)];
        let title = format!("{}; points and iterations: {}", case.name, increments(&solved));
        found.plot(Plot::new(title, ["deflection of the centre", "load factor"], curves));
    }
    Ok(found)
}

fn isotropic() -> Result<Findings, VerificationError> {
    run(&ISOTROPIC)
}

fn laminated() -> Result<Findings, VerificationError> {
    run(&LAMINATED)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
