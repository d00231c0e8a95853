//! Curved shells with large displacements: problems of Sze, Liu and Lo (2004).

use super::models::{ShellModel, edge, force, increments, node, probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "hemisphere_large",
        title: "Hemisphere with a hole under four large radial forces",
        source: "Data of Sze, Liu & Lo (2004), section 3.4. Recomputed by an independent Kirchhoff-Love code with B-splines of \
                 degree 4 on 20 × 20 elements, graded to the forces; the published table differs by up to 0.4 %",
        sketch: r"
        .--__--.          R = 10, h = 0.04, E = 6.825e7, ν = 0.3
       (        ) ->      forces of 400 with alternating sign at the equator
        '------'",
        goal: "A quarter of the hemisphere: displacements under both forces within 1 % with 12 × 12 elements",
        run: hemisphere,
    },
    Problem {
        name: "cylinder_pull_out",
        title: "Open cylinder, pulled out by two forces",
        source: "Data of Sze, Liu & Lo (2004), section 3.5. Recomputed by an independent Kirchhoff-Love code with B-splines of \
                 degree 4 on 16 × 16 elements; B and C of the published table differ by up to 0.3 %",
        sketch: r"
         F
      .--^--.             R = 4.953, L = 10.35, h = 0.094, E = 10.5e6, ν = 0.3125
     (B      )            F = 40 000, free ends
      '--v--'
         F",
        goal: "An eighth of the cylinder: B at mid length and C at the end, both at 90 degrees from the forces, within 1 % with \
               16 × 16 elements, before and after the fast change near half of the load. The point under the force depends on shear \
               and is within 3 %",
        run: pull_out,
    },
    Problem {
        name: "semi_cylinder",
        title: "Semi-cylinder, pinched at its free end",
        source: "Data of Sze, Liu & Lo (2004), section 3.7. Recomputed by an independent Kirchhoff-Love code with B-splines of \
                 degree 4 on 16 × 16 elements",
        sketch: r"
            F
         .--v--.          R = 101.6, L = 304.8, h = 3, E = 2068.5, ν = 0.3, F = 2000
        /       \         one end clamped; straight edges without vertical displacement and rotation
       |         |",
        goal: "Half of the shell: displacement under the force within 2 % with 16 × 16 elements",
        run: semi_cylinder,
    },
];

/// Runs a model with several loads and compares displacements of its probes.
///
/// `measures` are names with the column, its value at rest and the factor of the displacement. `references` have the part of the full load
/// and the displacements, with their tolerances relative to the last one.
fn compare(
    what: [&str; 2],
    measures: &[(&str, &str, f64, f64)],
    references: &[(f64, &[f64])],
    tolerances: &[f64],
    model: impl Fn(f64) -> String,
) -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let mut curves: Vec<Vec<[f64; 2]>> = vec![Vec::new(); measures.len()];
    let mut work = Vec::new();
    for (load, exact) in references {
        let solved = solve(&model(*load))?;
        work.push(increments(&solved));
        for (k, (name, column, start, factor)) in measures.iter().enumerate() {
            let ours = (solved.last(column)? - start) * factor;
            let size = references[references.len() - 1].1[k];
            found.compare(format!("{name} at {load} of the load"), ours, exact[k], size, tolerances[k]);
            curves[k].push([*load, ours]);
        }
    }
    let mut plotted = Vec::new();
    for (k, (name, ..)) in measures.iter().enumerate() {
        plotted.push(PlotCurve::line(*name, curves[k].clone()));
        let exact = references.iter().map(|(load, exact)| [*load, exact[k]]).collect();
        plotted.push(PlotCurve::points(format!("{name}, reference"), exact));
    }
    let title = format!("{}; increments and iterations: {}", what[0], work.join(", "));
    found.plot(Plot::new(title, ["part of the full load", what[1]], plotted));
    Ok(found)
}

fn hemisphere() -> Result<Findings, VerificationError> {
    let shell = ShellModel {
        surface: "kind = \"sphere\", center = [0, 0, 0], equator = [10, 0, 0], axis = [0, 0, 1], \
                  angle = 1.5707963267948966, latitudes = [0, 1.2566370614359172]",
        elements: [12, 12],
        thickness: 0.04,
        material: [6.825e7, 0.3, 1.0],
    };
    let model = |load: f64| {
        format!(
            "{shell}{}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u_start", "\"symmetry\""),
            edge("u_end", "\"symmetry\""),
            node("z", [0.0, 0.0], "\"z\""),
            force([0.0, 0.0], [200.0 * load, 0.0, 0.0]),
            force([1.0, 0.0], [0.0, -200.0 * load, 0.0]),
            probe("A", [0.0, 0.0]),
            probe("B", [1.0, 0.0])
        )
    };
    let measures = [("outward force", "A.x", 10.0, 1.0), ("inward force", "B.y", 10.0, -1.0)];
    let references: [(f64, &[f64]); 2] = [(0.25, &[2.59607, 3.80241]), (1.0, &[4.0739, 8.1487])];
    compare(["Displacements under the forces", "displacement"], &measures, &references, &[1e-2; 2], model)
}

fn pull_out() -> Result<Findings, VerificationError> {
    let shell = ShellModel {
        surface: "kind = \"revolved\", from = [0, 0, 4.953], to = [0, 5.175, 4.953], center = [0, 0, 0], axis = [0, 1, 0], \
                  angle = 1.5707963267948966",
        elements: [16, 16],
        thickness: 0.094,
        material: [10.5e6, 0.3125, 1.0],
    };
    let model = |load: f64| {
        format!(
            "{shell}{}{}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u_start", "\"symmetry\""),
            edge("u_end", "\"symmetry\""),
            edge("v_start", "\"symmetry\""),
            force([0.0, 0.0], [0.0, 0.0, 1e4 * load]),
            probe("A", [0.0, 0.0]),
            probe("B", [1.0, 0.0]),
            probe("C", [1.0, 1.0])
        )
    };
    let measures = [
        ("A, outward", "A.z", 4.953, 1.0),
        ("B, inward", "B.x", 4.953, -1.0),
        ("C, inward", "C.x", 4.953, -1.0),
    ];
    let references: [(f64, &[f64]); 2] =
        [(0.25, &[2.1667, 3.0884, 3.3096]), (1.0, &[2.7130, 4.5484, 3.2772])];
    compare(["Displacements", "displacement"], &measures, &references, &[3e-2, 1e-2, 1e-2], model)
}

fn semi_cylinder() -> Result<Findings, VerificationError> {
    let shell = ShellModel {
        surface: "kind = \"revolved\", from = [0, 0, 101.6], to = [0, 304.8, 101.6], center = [0, 0, 0], axis = [0, 1, 0], \
                  angle = 1.5707963267948966",
        elements: [16, 16],
        thickness: 3.0,
        material: [2068.5, 0.3, 1.0],
    };
    let model = |load: f64| {
        format!(
            "{shell}{}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            edge("u_start", "\"symmetry\""),
            edge("u_end", "\"symmetry\""),
            edge("v_start", "\"clamped\""),
            force([0.0, 1.0], [0.0, 0.0, -1000.0 * load]),
            probe("A", [0.0, 1.0])
        )
    };
    let measures = [("displacement under the force", "A.z", 101.6, -1.0)];
    let references: [(f64, &[f64]); 3] = [(0.1, &[15.771]), (0.3, &[66.646]), (1.0, &[171.43])];
    compare(["Displacement under the force", "displacement"], &measures, &references, &[2e-2], model)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
