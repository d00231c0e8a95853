//! Shear-deformable shells with large displacements: problems of Sze, Liu and Lo (2004).

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::linear::on_sphere;
use super::mesh::{MeshModel, edge, edge_load, force, isotropic, node, probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "shear_shell_roll_up",
        title: "Strip of four-node shells, rolled up to a circle by a moment",
        source: "Sze, Liu & Lo (2004), section 3.2: u = −L (1 − sin φ/φ), w = L (1 − cos φ)/φ, φ = 2 π λ",
        sketch: r"
  |/===========) M        L = 12, b = 1, h = 0.1, E = 1.2e6, ν = 0, M = 2 π E I/L",
        goal: "Displacements of the end within 1 % of the length for λ = 0.25, 0.5 and 1 with 32 × 1 elements",
        run: roll_up,
    },
    Problem {
        name: "shear_shell_end_shear",
        title: "Strip of four-node shells under a force at its end",
        source: "Sze, Liu & Lo (2004), section 3.1. Inextensible elastica: u = 3.28941242247, w = 6.69964181278 at P = 4, 1.60641720825 \
                 and 4.93457480397 at P = 2",
        sketch: r"
  |/===========| P        L = 10, b = 1, h = 0.1, E = 1.2e6, ν = 0",
        goal: "Displacements of the end within 0.5 % with 16 × 1 elements",
        run: end_shear,
    },
    Problem {
        name: "shear_shell_slit_annulus",
        title: "Slit annular plate of four-node shells, lifted at the slit",
        source: "Data of Sze, Liu & Lo (2004), section 3.3. 6.70849 and 9.14097 at λ = 0.2, 13.842 and 17.480 at λ = 1 by an \
                 independent Kirchhoff-Love code; their table has 6.725, 9.160, 13.891 and 17.528",
        sketch: r"
        .-''''-.          radii 6 and 10, h = 0.03, E = 21e6, ν = 0
       (  (  )==)-        one edge of the slit clamped, the other lifted by 0.8 per length
        '-....-'",
        goal: "Displacements of both ends of the lifted edge within 1.5 % with 6 × 48 elements",
        run: slit_annulus,
    },
    Problem {
        name: "shear_shell_hemisphere_large",
        title: "Hemisphere with a hole of four-node shells under four large radial forces",
        source: "Data of Sze, Liu & Lo (2004), section 3.4. 4.0739 and 8.1487 by an independent Kirchhoff-Love code; their table has \
                 4.067 and 8.178",
        sketch: r"
        .--__--.          R = 10, h = 0.04, E = 6.825e7, ν = 0.3
       (        ) ->      forces of 400 with alternating sign at the equator
        '------'",
        goal: "A quarter of the hemisphere: displacements under both forces within 1.5 % with 16 × 16 elements",
        run: hemisphere,
    },
];

/// Adds a plot of computed values over the parts of the load, and the references.
fn plot(found: &mut Findings, names: [&str; 2], rows: &[(f64, [f64; 2], [f64; 2])]) {
    let mut curves = Vec::new();
    for (k, name) in names.into_iter().enumerate() {
        curves.push(PlotCurve::line(name, rows.iter().map(|(part, ours, _)| [*part, ours[k]]).collect()));
        let exact = rows.iter().map(|(part, _, exact)| [*part, exact[k]]).collect();
        curves.push(PlotCurve::points(format!("{name}, reference"), exact));
    }
    found.plot(Plot::new("Displacements", ["part of the load", "displacement"], curves));
}

fn roll_up() -> Result<Findings, VerificationError> {
    let (mut found, mut rows) = (Findings::default(), Vec::new());
    for part in [0.25, 0.5, 1.0] {
        let shell = MeshModel::plate([32, 1], [12.0, 1.0], 0.1, isotropic([1.2e6, 0.0, 1.0]));
        let model = format!(
            "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u0", "\"clamped\""),
            edge_load("edge_moment", "u1", "moment", [0.0, -50.0 * PI / 3.0 * part, 0.0]),
            probe("tip", "p10")
        );
        let (solved, angle) = (solve(&model)?, TAU * part);
        let exact = [12.0 * angle.sin() / angle, 12.0 * (1.0 - angle.cos()) / angle];
        rows.push((part, [solved.last("tip.x")?, solved.last("tip.z")?], exact));
        for (name, exact) in ["tip.x", "tip.z"].into_iter().zip(exact) {
            found.compare(format!("{name} at {part} of the moment"), solved.last(name)?, exact, 12.0, 1e-2);
        }
    }
    plot(&mut found, ["x", "z"], &rows);
    Ok(found)
}

fn end_shear() -> Result<Findings, VerificationError> {
    let (mut found, mut rows) = (Findings::default(), Vec::new());
    for (load, [u, w]) in [(2.0, [1.60641720825, 4.93457480397]), (4.0, [3.28941242247, 6.69964181278])] {
        let shell = MeshModel::plate([16, 1], [10.0, 1.0], 0.1, isotropic([1.2e6, 0.0, 1.0]));
        let model = format!(
            "{shell}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u0", "\"clamped\""),
            edge_load("edge_force", "u1", "force", [0.0, 0.0, load]),
            probe("tip", "p10")
        );
        let solved = solve(&model)?;
        let ours = [10.0 - solved.last("tip.x")?, solved.last("tip.z")?];
        rows.push((load / 4.0, ours, [u, w]));
        found.compare(format!("u at P = {load}"), ours[0], u, w, 5e-3);
        found.compare(format!("w at P = {load}"), ours[1], w, w, 5e-3);
    }
    plot(&mut found, ["u", "w"], &rows);
    Ok(found)
}

fn slit_annulus() -> Result<Findings, VerificationError> {
    let (mut found, mut rows) = (Findings::default(), Vec::new());
    for (part, exact) in [(0.2, [6.70849, 9.14097]), (1.0, [13.842, 17.480])] {
        let shell = MeshModel::grid([6, 48], 0.03, isotropic([21e6, 0.0, 1.0]), |[u, v]| {
            let ((sin, cos), radius) = ((TAU * v).sin_cos(), 6.0 + 4.0 * u);
            // The slit has two rows of nodes at the same points: they are apart by a part of a millionth of the radius.
            let gap = 1e-4 * v;
            [[radius * cos, radius * sin - gap, 0.0], [0.0, 0.0, 1.0]]
        });
        let model = format!(
            "{shell}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("v0", "\"clamped\""),
            edge_load("edge_force", "v1", "force", [0.0, 0.0, 0.8 * part]),
            probe("A", "p01"),
            probe("B", "p11")
        );
        let solved = solve(&model)?;
        rows.push((part, [solved.last("A.z")?, solved.last("B.z")?], exact));
        for (name, exact) in ["A", "B"].into_iter().zip(exact) {
            let ours = solved.last(&format!("{name}.z"))?;
            found.compare(format!("{name} at {part} of the load"), ours, exact, exact, 1.5e-2);
        }
    }
    plot(&mut found, ["A", "B"], &rows);
    Ok(found)
}

fn hemisphere() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let shell = MeshModel::grid([16, 16], 0.04, isotropic([6.825e7, 0.3, 1.0]), |[u, v]| {
        on_sphere(10.0, FRAC_PI_2 * u, 72.0_f64.to_radians() * v)
    });
    let model = format!(
        "{shell}{}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
        edge("u0", "\"symmetry\""),
        edge("u1", "\"symmetry\""),
        node("p00", "\"z\""),
        force("p00", [200.0, 0.0, 0.0]),
        force("p10", [0.0, -200.0, 0.0]),
        probe("A", "p00"),
        probe("B", "p10")
    );
    let solved = solve(&model)?;
    let (ours, exact) = ([solved.last("A.x")? - 10.0, 10.0 - solved.last("B.y")?], [4.0739, 8.1487]);
    found.compare("outward force", ours[0], exact[0], exact[0], 1.5e-2);
    found.compare("inward force", ours[1], exact[1], exact[1], 1.5e-2);
    plot(&mut found, ["A", "B"], &[(1.0, ours, exact)]);
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
