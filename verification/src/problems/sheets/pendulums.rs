//! Pendulum of a plate on a hinged edge, and a cantilever plate that comes to rest.

use super::model::{Edge, Element, Sheet};
use crate::reference::elliptic_k;
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "hinged_plate_pendulum",
        title: "Stiff square plate that swings about an edge",
        source: "Rigid plate: period 4 K(sin θ₀/2) √(J/(m g d)) by the complete elliptic integral, angular velocity at the bottom \
                 √(2 m g d (1 − cos θ₀)/J), d = a/2, J/m = a²/3 of a thin shell and a²/3 + h²/12 of a shear-deformable one: \
                 1.93333485437 and 1.93335902091 s for θ₀ = 90°",
        sketch: r"
      o-------------     a = 1 m, h = 0.01 m, released at θ₀ = 30, 90 and 150 degrees
      |  θ₀              from the vertical; hinge along an edge
      |",
        goal: "A quarter of the period and the angular velocity at the bottom within 3e-5 with steps of 1 ms. The rotary inertia of the \
               thickness changes the period by 1.25e-5. Second order in the step",
        run: pendulum,
    },
    Problem {
        name: "plate_comes_to_rest",
        title: "Cantilever plate under a sudden force at a corner, with strain damping",
        source: "Data of Yamashita, Valkeapää, Jayakumar & Sugiyama (2015) with E = 2.1e8. The plate comes to rest in the equilibrium, \
                 recomputed by an independent Kirchhoff-Love code with B-splines of degree 4 on 14 × 14 elements",
        sketch: r"
  |/+--------+
  |/|        |     1 × 1 × 0.01 m, ν = 0.3, ρ = 500, retardation time 0.08 s
  |/+--------+ F   F = 50 N from t = 0",
        goal: "Positions of both free corners after 5 s within 0.5 % of 0.65 m of the equilibrium, and less than 1 mm/s",
        run: rest,
    },
];

const GRAVITY: f64 = 9.81;

/// Time at which the plate passes the bottom, and its angular velocity there.
fn bottom(solved: &SolvedModel) -> Result<[f64; 2], VerificationError> {
    let [t, x, z] = [solved.column("t")?, solved.column("tip.x")?, solved.column("tip.z")?];
    let [vx, vz] = [solved.column("tip.vx")?, solved.column("tip.vz")?];
    let row = x.iter().position(|x| *x < 0.0).filter(|row| *row > 0);
    let row = row.ok_or_else(|| VerificationError::Missing("row at the bottom".into()))?;
    let angle = |row: usize| x[row].atan2(-z[row]);
    // The angular acceleration vanishes at the bottom: linear interpolation has an error of third order.
    let part = angle(row - 1) / (angle(row - 1) - angle(row));
    let between = |values: [f64; 2]| values[0] + part * (values[1] - values[0]);
    Ok([between([t[row - 1], t[row]]), between([row - 1, row].map(|row| vx[row].hypot(vz[row])))])
}

fn pendulum() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (element, rotary) in [(Element::Thin, 0.0), (Element::Shear, 1e-4 / 12.0)] {
        let inertia = 1.0 / 3.0 + rotary;
        for degrees in [30.0, 90.0, 150.0_f64] {
            let start = degrees.to_radians();
            let quarter = elliptic_k((0.5 * start).sin()) * (2.0 * inertia / GRAVITY).sqrt();
            let speed = (GRAVITY * (1.0 - start.cos()) / inertia).sqrt();
            let sheet = Sheet {
                element,
                corner: [0.0; 3],
                sides: [[start.sin(), 0.0, -start.cos()], [0.0, 1.0, 0.0]],
                elements: [1, 1],
                thickness: 0.01,
                // Vibrations of the plate are not resolved, hence damped by the scheme.
                material: "young = 2.1e14, poisson = 0.3, density = 7810".into(),
                keys: String::new(),
            };
            let mut errors = Vec::new();
            for step in [4e-3, 2e-3, 1e-3] {
                let model = format!(
                    "gravity = [0, 0, {:?}]\n{}{}{}[analysis]\nkind = \"dynamics\"\nduration = {:?}\nstep = {step:?}\n",
                    -GRAVITY,
                    sheet.body(),
                    sheet.support(Edge::Left, "hinged"),
                    sheet.probe("tip", [1, 0]),
                    quarter + 0.02
                );
                let [time, rate] = bottom(&solve(&model)?)?;
                errors.push([step, (rate / speed - 1.0).abs()]);
                if step == 1e-3 {
                    let case = format!("{}, θ₀ = {degrees}°", element.name());
                    found.compare(
                        format!("period, s, {case}"),
                        4.0 * time,
                        4.0 * quarter,
                        4.0 * quarter,
                        3e-5,
                    );
                    found.compare(format!("angular velocity, 1/s, {case}"), rate, speed, speed, 3e-5);
                    curves.push(PlotCurve::points(case, std::mem::take(&mut errors)));
                }
            }
        }
    }
    let order = vec![[1e-3, 1e-5], [4e-3, 1.6e-4]];
    curves.push(PlotCurve::line("second order", order));
    let plot =
        Plot::new("Error of the angular velocity at the bottom", ["step, s", "relative error"], curves);
    found.plot(plot.with_logarithmic_axes([true, true]));
    Ok(found)
}

/// Positions of the loaded and of the other free corner in the equilibrium.
const REST: [(&str, [f64; 3]); 2] =
    [("A", [1.0 - 0.28816, 0.06252, -0.64891]), ("B", [1.0 - 0.11405, 1.01480, -0.41242])];

fn rest() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (element, n, step) in [(Element::Thin, 4, 0.02), (Element::Shear, 6, 0.04)] {
        let sheet = Sheet {
            element,
            corner: [0.0; 3],
            sides: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            elements: [n, n],
            thickness: 0.01,
            material: "young = 2.1e8, poisson = 0.3, density = 500, damping = { strain = 0.08 }".into(),
            keys: String::new(),
        };
        let model = format!(
            "{}{}{}{}{}[analysis]\nkind = \"dynamics\"\nduration = 5\nstep = {step:?}\nscheme = {{ spectral_radius = 0.9 }}\n",
            sheet.body(),
            sheet.support(Edge::Left, "clamped"),
            sheet.force([n, 0], [0.0, 0.0, -50.0]),
            sheet.probe("A", [1, 0]),
            sheet.probe("B", [1, 1])
        );
        let solved = solve(&model)?;
        let name = element.name();
        for (corner, exact) in REST {
            for (axis, exact) in ["x", "y", "z"].into_iter().zip(exact) {
                let column = format!("{corner}.{axis}");
                found.compare(format!("{column}, m, {name}"), solved.last(&column)?, exact, 0.64891, 5e-3);
            }
        }
        found.compare(format!("velocity at the end, m/s, {name}"), solved.last("A.vz")?, 0.0, 1.0, 1e-3);
        curves.push(PlotCurve::line(format!("{name}, {n} x {n} elements"), solved.points("t", "A.z")?));
    }
    curves.push(PlotCurve::points("equilibrium", vec![[5.0, REST[0].1[2]]]));
    found.plot(Plot::new("Loaded corner", ["t, s", "z, m"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
