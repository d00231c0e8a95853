use crate::problems::models::{ROD, Rod, clamped_section, end_probe};
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Natural frequencies of a cantilever and of a free rod.
pub const PROBLEM: Problem = Problem {
    name: "frequencies",
    title: "Natural frequencies of a cantilever and of a free rod",
    source: "Timoshenko's beam (k = 1), roots of its characteristic equation; axial √(E/ρ) (2n−1)/4L, torsion \
             √(G/ρ) (2n−1)/4L. The rod is that of Kim et al. (2017)",
    sketch: r"
  |/|==========================    L = 1 m, d = 20 mm, steel
  |/|                              bending B, axial A, torsion T",
    goal: "Bending, axial and torsional frequencies: 64 quadratic elements within 1e-5, 64 linked ones within 1e-4 (ν = 0, \
           k = 1). The continuum formulation locks: with ν = 0.3 it converges to (λ+2G) I instead of E I, by \
           extrapolation from 32 and 64 \
           elements within 1e-4. A free rod has six rigid-body modes",
    run,
};

/// Hertz, ν = 0 and k = 1.
const BENDING: [f64; 4] = [13.714693124408, 85.85919781924, 240.0061199541, 469.17308113901];
const AXIAL: [f64; 3] = [1225.6342552009, 3676.9027656026, 6128.1712760044];
const TORSION: [f64; 3] = [866.65429310706, 2599.9628793212, 4333.2714655353];
/// Hertz, ν = 0.3 with (λ+2G) I in place of E I.
const LOCKED: [f64; 3] = [15.910931825754, 99.556825887235, 278.06445474896];

/// Kind of a mode.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ModeKind {
    Bending,
    Axial,
    Torsion,
}

fn model(formulation: &str, elements: u32, poisson: f64, count: u32, is_clamped: bool) -> String {
    let (area, second) = (std::f64::consts::PI * 1e-4, std::f64::consts::PI * 0.25e-8);
    let section = if formulation == "continuum" {
        r#"{ kind = "circle", diameter = 0.02 }"#.to_owned()
    } else {
        format!(r#"{{ kind = "general", area = {area}, iy = {second}, iz = {second} }}"#)
    };
    let root = if is_clamped { clamped_section("rod") } else { String::new() };
    format!(
        r#"
        materials.material = {{ density = 8030, young = 193e9, poisson = {poisson} }}
        sections.section = {section}
        {rod}{root}{tip}{rim}offset = [0.01, 0]

        [analysis]
        kind = "modes"
        count = {count}
        "#,
        rod = Rod { element: formulation, elements, ..ROD },
        tip = end_probe("tip", "rod"),
        rim = end_probe("rim", "rod")
    )
}

/// Returns the frequencies of a kind, by the motion of the tip and its rim. Bending frequencies are double; one is kept.
fn of_kind(solved: &SolvedModel, kind: ModeKind) -> Result<Vec<f64>, VerificationError> {
    let column = |name: &str| solved.column(name);
    let (x, y, z, rim) = (column("tip.x")?, column("tip.y")?, column("tip.z")?, column("rim.z")?);
    let mut frequencies = Vec::new();
    for (i, &frequency) in column("frequency")?.iter().enumerate() {
        let (along, across, around) = (x[i].abs(), y[i].hypot(z[i]), (rim[i] - z[i]).abs());
        let found = if around > along && around > across {
            ModeKind::Torsion
        } else if along > across {
            ModeKind::Axial
        } else {
            ModeKind::Bending
        };
        if found == kind {
            frequencies.push(frequency);
        }
    }
    let step = if kind == ModeKind::Bending { 2 } else { 1 };
    Ok(frequencies.into_iter().step_by(step).collect())
}

fn compare(
    findings: &mut Findings,
    name: &str,
    ours: &[f64],
    reference: &[f64],
    tolerance: f64,
) -> Result<(), VerificationError> {
    for (i, &reference) in reference.iter().enumerate() {
        let what = format!("{name}{}, Hz", i + 1);
        let ours = ours.get(i).ok_or_else(|| VerificationError::Missing(what.clone()))?;
        findings.compare(what, *ours, reference, reference, tolerance);
    }
    Ok(())
}

fn numbered(frequencies: &[f64]) -> Vec<[f64; 2]> {
    frequencies.iter().enumerate().map(|(i, &f)| [(i + 1) as f64, f]).collect()
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    let quadratic = solve(&model("quadratic", 64, 0.0, 36, true))?;
    let bending = of_kind(&quadratic, ModeKind::Bending)?;
    for (name, kind, reference) in [
        ("B", ModeKind::Bending, &BENDING[..]),
        ("A", ModeKind::Axial, &AXIAL[..]),
        ("T", ModeKind::Torsion, &TORSION[..]),
    ] {
        let ours = of_kind(&quadratic, kind)?;
        compare(&mut findings, &format!("quadratic, {name}"), &ours, reference, 1e-5)?;
    }
    let linked = solve(&model("linked", 64, 0.0, 16, true))?;
    for (name, kind, reference) in [
        ("B", ModeKind::Bending, &BENDING[..]),
        ("A", ModeKind::Axial, &AXIAL[..1]),
        ("T", ModeKind::Torsion, &TORSION[..1]),
    ] {
        let ours = of_kind(&linked, kind)?;
        compare(&mut findings, &format!("linked, {name}"), &ours, reference, 1e-4)?;
    }
    // The error is proportional to the square of the element length.
    let coarse = of_kind(&solve(&model("continuum", 32, 0.3, 6, true))?, ModeKind::Bending)?;
    let fine = of_kind(&solve(&model("continuum", 64, 0.3, 6, true))?, ModeKind::Bending)?;
    let limit: Vec<f64> =
        coarse.iter().zip(&fine).map(|(coarse, fine)| fine + (fine - coarse) / 3.0).collect();
    compare(&mut findings, "continuum, ν = 0.3, extrapolated, B", &limit, &LOCKED, 1e-4)?;
    for formulation in ["continuum", "linked", "quadratic"] {
        let free = solve(&model(formulation, 8, 0.0, 8, false))?;
        let rigid = free.column("frequency")?.iter().filter(|&&frequency| frequency == 0.0).count();
        findings.compare(format!("{formulation}, free: rigid motions"), rigid as f64, 6.0, 1.0, 0.0);
    }
    findings.plot(
        Plot::new(
            "Bending frequencies against the number of the mode",
            ["mode", "frequency, Hz"],
            vec![
                PlotCurve::line("quadratic, ν = 0", numbered(&bending[..4])),
                PlotCurve::points("Timoshenko", numbered(&BENDING)),
                PlotCurve::line("continuum, ν = 0.3", numbered(&limit)),
                PlotCurve::points("its limit", numbered(&LOCKED)),
            ],
        )
        .with_logarithmic_axes([false, true]),
    );
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
