use super::instants::row_at;
use crate::problems::models::{ROD, Rod, end_probe, hinge};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Steel rod on a hinge, released from the horizontal.
pub const PROBLEM: Problem = Problem {
    name: "compound_pendulum",
    title: "Compound pendulum: a stiff rod on a hinge",
    source: "Rigid rod, θ̈ = W² cos θ with J = m (L²/3 + d²/16), by Jacobi's elliptic functions and by an integration \
                 in time, \
             equal to 1e-13. The rod is that of Kim et al. (2017)",
    sketch: r"
     o=====================   L = 1 m, d = 20 mm, steel, at rest
     hinge      | g           period 1.933407 s",
    goal: "Tip within 5e-4 of the rigid rod, which is the effect of the flexibility, without material damping; energy \
               constant to \
           1e-6 of m g L. Reactions within 1e-3 of their maximum, with a retardation time of 1 ms that damps the vibration \
           after the release. Four linked elements, generalized-α with a spectral radius of 0.8",
    run,
};

/// t, tip x, y, reaction of the hinge x, y.
const RIGID: [[f64; 5]; 8] = [
    [0.25, 0.897555597254, -0.440901292625, -22.0336833721, 17.011795936],
    [0.5, -0.0901281176136, -0.995930179488, 4.99773893313, 61.4141291476],
    [0.75, -0.941372899724, -0.337367846224, 17.6827478, 12.5254283619],
    [1.0, -0.999966738166, -0.00815613650197, 0.454103043337, 6.19201485629],
    [1.25, -0.834428777999, -0.551115790417, 25.6045118737, 23.0993418479],
    [1.5, 0.266044667463, -0.963960701956, -14.279015345, 57.9255241089],
    [1.75, 0.96965730188, -0.244468232928, -13.198515238, 9.51589663023],
    [2.0, 0.999467890296, -0.0326180359245, -1.81514375369, 6.24754895193],
];
/// Weight times length, J.
const ENERGY: f64 = 24.74767621716784;
/// Maximum reaction of the hinge, 5/2 of the weight, N.
const PEAK: f64 = 2.5 * ENERGY;

fn model(retardation: f64, step: f64) -> String {
    let rod = Rod { element: "linked", elements: 4, ..ROD };
    format!(
        r#"
        gravity = [0, -9.81, 0]
        output.interval = 0.01
        materials.material = {{ density = 8030, young = 193e9, damping = {{ strain = {retardation} }} }}
        sections.section = {{ kind = "circle", diameter = 0.02 }}
        {rod}{support}{tip}
        [analysis]
        kind = "dynamics"
        duration = 2
        step = {step}
        scheme = {{ spectral_radius = 0.8 }}
        "#,
        support = hinge("hinge", "rod", "start"),
        tip = end_probe("tip", "rod")
    )
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let free = solve(&model(0.0, 2.5e-4))?;
    let damped = solve(&model(1e-3, 1e-3))?;
    let (x, y, lost) = (free.column("tip.x")?, free.column("tip.y")?, free.column("balance")?);
    let (fx, fy) = (damped.column("hinge.fx")?, damped.column("hinge.fy")?);
    for [t, tip_x, tip_y, force_x, force_y] in RIGID {
        let row = row_at(&free, t)?;
        findings.compare(format!("tip x, m, t = {t} s"), x[row], tip_x, 1.0, 5e-4);
        findings.compare(format!("tip y, m, t = {t} s"), y[row], tip_y, 1.0, 5e-4);
        let row = row_at(&damped, t)?;
        findings.compare(format!("force x, N, t = {t} s"), fx[row], force_x, PEAK, 1e-3);
        findings.compare(format!("force y, N, t = {t} s"), fy[row], force_y, PEAK, 1e-3);
    }
    let drift = lost.iter().fold(0.0, |drift: f64, lost| drift.max(lost.abs()));
    findings.compare("largest change of energy, J", drift, 0.0, ENERGY, 1e-6);
    findings.plot(
        Plot::new(
            "Path of the tip",
            ["x, m", "y, m"],
            vec![
                PlotCurve::line("ancf", free.points("tip.x", "tip.y")?),
                PlotCurve::points("rigid rod", RIGID.map(|[_, x, y, ..]| [x, y]).to_vec()),
            ],
        )
        .with_equal_scales(),
    );
    findings.plot(Plot::new(
        "Reaction of the hinge",
        ["t, s", "force along x and y, N"],
        vec![
            PlotCurve::line("ancf, x", damped.points("t", "hinge.fx")?),
            PlotCurve::points("rigid rod, x", RIGID.map(|[t, _, _, x, _]| [t, x]).to_vec()),
            PlotCurve::line("ancf, y", damped.points("t", "hinge.fy")?),
            PlotCurve::points("rigid rod, y", RIGID.map(|[t, .., y]| [t, y]).to_vec()),
        ],
    ));
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
