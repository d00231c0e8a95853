use super::instants::row_at;
use crate::problems::models::{Rod, hinge};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Slider crank with a flexible rod.
pub const PROBLEM: Problem = Problem {
    name: "slider_crank",
    title: "Slider crank with a flexible rod",
    source: "Simeon, Math. Modelling of Systems 2 (1996), and the test set of initial value problems: two sine modes \
                 of bending, two \
             axial modes, with the axial mass matrix divided by 15, a misprint there, and the strain energy \
             completed by ½ EA ∫ (w'²/2)² dx; from rest relative to the rigid motion, by Runge-Kutta, step 5e-6 s",
    sketch: r"
             __rod, 0.30 m
        o----------____
       / crank, 0.15 m ----___
      O 150 rad/s             [ ]--> block
    ============================= y = 0",
    goal: "Deflection of the middle of the rod within 3 % of the largest deflection, block within 5e-5 m, over 2.4 \
               revolutions",
    run,
};

/// t, deflection of the middle of the rod in mm, position of the block.
const SIMEON: [[f64; 3]; 20] = [
    [0.005, 1.4034, 0.3917791],
    [0.010, 0.6974, 0.2706420],
    [0.015, 0.1188, 0.1821285],
    [0.020, -0.0874, 0.1507359],
    [0.025, -0.3221, 0.1643854],
    [0.030, -0.6203, 0.2300986],
    [0.035, -1.6231, 0.3477106],
    [0.040, -0.9792, 0.4410953],
    [0.045, 0.8832, 0.4262489],
    [0.050, 0.9801, 0.3169483],
    [0.055, 0.0595, 0.2082904],
    [0.060, -0.1805, 0.1568991],
    [0.065, -0.4317, 0.1539845],
    [0.070, -0.6512, 0.1980682],
    [0.075, -1.4717, 0.3002490],
    [0.080, -1.6476, 0.4155880],
    [0.085, 0.2066, 0.4462346],
    [0.090, 1.2838, 0.3639277],
    [0.095, 0.3807, 0.2434370],
    [0.100, -0.0384, 0.1697530],
];

/// Largest deflection, mm.
const LARGEST: f64 = 1.87;

fn model(formulation: &str) -> String {
    let rod = Rod {
        name: "rod",
        element: formulation,
        from: [0.15, 0.0, 0.0],
        to: [0.45, 0.0, 0.0],
        elements: 8,
        keys: "motion = { velocity = [0, 22.5, 0], spin = [0, 0, -75] }",
    };
    format!(
        r#"
        output.interval = 5e-4
        materials.material = {{ density = 7870, young = 2e11, poisson = 0.3 }}
        sections.section = {{ kind = "rectangle", height = 0.008, width = 0.008 }}
        probes = [
          {{ name = "pin", on = {{ body = "rod", at = "start" }} }},
          {{ name = "middle", on = {{ body = "rod", at = 0.15 }} }},
          {{ name = "block", on = {{ body = "block", at = "center" }} }},
        ]

        [[bodies]]
        kind = "rigid"
        name = "crank"
        center = [0, 0, 0]
        mass = 0.36
        inertia = [0.001, 0.002, 0.002727]
        motion = {{ spin = [0, 0, 150] }}

        {rod}
        [[bodies]]
        kind = "mass"
        name = "block"
        center = [0.45, 0, 0]
        mass = 0.075552

        [[joints]]
        kind = "revolute"
        name = "motor"
        a = {{ body = "crank", at = "center" }}
        axis = [0, 0, 1]
        drive = {{ rate = 150 }}

        {crank_pin}b = {{ body = "crank", at = [0.15, 0, 0] }}

        [[joints]]
        kind = "spherical"
        name = "block pin"
        a = {{ body = "block", at = "center" }}
        b = {{ body = "rod", at = "end" }}

        [[joints]]
        kind = "point_on_line"
        name = "guide"
        a = {{ body = "block", at = "center" }}
        axis = [1, 0, 0]

        [scales]
        kind = "auto"

        [analysis]
        kind = "dynamics"
        duration = 0.1
        step = 2e-5
        scheme = {{ spectral_radius = 0.9 }}
        "#,
        crank_pin = hinge("crank pin", "rod", "start")
    )
}

/// Returns t and the deflection of the middle of the rod from its chord, mm.
fn deflections(solved: &SolvedModel) -> Result<Vec<[f64; 2]>, VerificationError> {
    let points = |name: &str| solved.points(&format!("{name}.x"), &format!("{name}.y"));
    let (pins, middles, blocks) = (points("pin")?, points("middle")?, points("block")?);
    let deflection = |i: usize| {
        let ([px, py], [mx, my], [bx, by]) = (pins[i], middles[i], blocks[i]);
        1e3 * ((bx - px) * (my - py) - (by - py) * (mx - px)) / (bx - px).hypot(by - py)
    };
    Ok(solved.column("t")?.iter().enumerate().map(|(i, &t)| [t, deflection(i)]).collect())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let mut plot =
        Plot::new("Deflection of the middle of the rod from its chord", ["t, s", "mm"], Vec::new());
    for formulation in ["linked", "quadratic"] {
        let solved = solve(&model(formulation))?;
        let (deflections, block) = (deflections(&solved)?, solved.column("block.x")?);
        for [t, deflection, position] in SIMEON {
            let row = row_at(&solved, t)?;
            findings.compare(
                format!("{formulation}, deflection, mm, t = {t} s"),
                deflections[row][1],
                deflection,
                LARGEST,
                0.03,
            );
            findings.compare(format!("{formulation}, block, m, t = {t} s"), block[row], position, 1.0, 5e-5);
        }
        plot.curves.push(PlotCurve::line(formulation, deflections));
    }
    plot.curves.push(PlotCurve::points("Simeon, completed", SIMEON.map(|[t, d, _]| [t, d]).to_vec()));
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
