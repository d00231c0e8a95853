use std::f64::consts::PI;

use super::instants::row_at;
use crate::problems::models::{ROD, Rod, end_probe};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Spin-up of a flexible arm about its root.
pub const PROBLEM: Problem = Problem {
    name: "spin_up",
    title: "Spin-up of a flexible arm",
    source: "Simo & Vu-Quoc (1986), after Kane, Ryan & Banerjee (1987); deflections by a spectral rod of Reissner's theory, \
             order 8, integrated to 1e-10, and by a second program, equal to 3e-4. Steady stretch tan(kL)/k − L, k² = \
             ω² ρA/EA",
    sketch: r"
      ___ ω(t)
     /   \ |
     O=====|=====================   L = 10
     root                     tip   at rest, 45 rad after 15 s, then 6 rad/s",
    goal: "Tip in a frame that rotates with the root: across within 1e-3 (of a length of 10) at all times, with 16 elements, \
           linked and quadratic; steady stretch at 6 rad/s within 1e-6",
    run,
};

/// t, displacement of the tip along and across.
const TIP: [[f64; 3]; 9] = [
    [2.5, -0.00132268, -0.15128356],
    [5.0, -0.01265464, -0.46847618],
    [6.0, -0.01697125, -0.54359640],
    [7.0, -0.01861826, -0.57131181],
    [7.5, -0.01774187, -0.55908346],
    [8.0, -0.01662992, -0.54284152],
    [10.0, -0.00707233, -0.36281429],
    [12.5, -0.00022176, -0.11269620],
    [15.0, 0.00051399, 0.00130358],
];
/// Stretch at 6 rad/s.
const STEADY: f64 = 5.1431e-4;

fn model(formulation: &str) -> String {
    format!(
        r#"
        output.interval = 0.1
        materials.material = {{ density = 1.2, young = 2.8e7 }}

        # E A = 2.8e7, G A = 1e7, E I = 1.4e4, ρ A = 1.2, ρ I = 6e-4.
        [sections.section]
        kind = "general"
        area = 1
        iy = 5e-4
        iz = 5e-4
        ky = {shear}
        kz = {shear}

        {rod}
        [[joints]]
        kind = "drive"
        name = "root"
        a = {{ body = "arm", at = "start" }}
        axis = [0, 0, 1]
        time = {{ kind = "expression", text = "if(t < 15, 0.4*(t^2/2 + (7.5/pi)^2*(cos(2*pi*t/15) - 1)), 6*t - 45)" }}

        {tip}
        [analysis]
        kind = "dynamics"
        duration = 17
        step = 0.005
        scheme = {{ spectral_radius = 0.8 }}
        "#,
        shear = 2.0 / 2.8,
        rod = Rod { name: "arm", element: formulation, to: [10.0, 0.0, 0.0], elements: 16, ..ROD },
        tip = end_probe("tip", "arm")
    )
}

/// Returns the angle of the root.
fn angle(t: f64) -> f64 {
    if t < 15.0 {
        0.4 * (0.5 * t * t + (7.5 / PI).powi(2) * ((2.0 * PI * t / 15.0).cos() - 1.0))
    } else {
        6.0 * t - 45.0
    }
}

/// Returns t and the displacement of the tip in the frame of the root, for all rows.
fn displacements(solved: &SolvedModel) -> Result<Vec<[f64; 3]>, VerificationError> {
    let (t, x, y) = (solved.column("t")?, solved.column("tip.x")?, solved.column("tip.y")?);
    let rows = t.iter().zip(x.iter().zip(y)).map(|(&t, (x, y))| {
        let (sin, cos) = angle(t).sin_cos();
        [t, cos * x + sin * y - 10.0, cos * y - sin * x]
    });
    Ok(rows.collect())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let axes = ["t, s", "along and across, m"];
    let mut plot = Plot::new("Displacement of the tip in the frame of the root", axes, Vec::new());
    for formulation in ["linked", "quadratic"] {
        let solved = solve(&model(formulation))?;
        let rows = displacements(&solved)?;
        for [t, along, across] in TIP {
            let [_, ours_along, ours_across] = rows[row_at(&solved, t)?];
            findings.compare(format!("{formulation}, across, t = {t} s"), ours_across, across, 1.0, 1e-3);
            findings.compare(format!("{formulation}, along, t = {t} s"), ours_along, along, 1.0, 1e-3);
        }
        let steady: Vec<f64> = rows.iter().filter(|row| row[0] > 15.0).map(|row| row[1]).collect();
        let mean = steady.iter().sum::<f64>() / steady.len() as f64;
        findings.compare(format!("{formulation}, steady stretch, m"), mean, STEADY, 1.0, 1e-6);
        for (column, name) in [(1, "along"), (2, "across")] {
            let points = rows.iter().map(|row| [row[0], row[column]]).collect();
            plot.curves.push(PlotCurve::line(format!("{formulation}, {name}"), points));
        }
    }
    for (column, name) in [(1, "along"), (2, "across")] {
        let points = TIP.map(|row| [row[0], row[column]]).to_vec();
        plot.curves.push(PlotCurve::points(format!("spectral rod, {name}"), points));
    }
    findings.plot(plot);
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
