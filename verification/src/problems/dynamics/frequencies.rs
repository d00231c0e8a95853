use crate::{Curve, Error, Findings, Plot, Problem, Solved, solve};

/// Natural frequencies of a cantilever, and of the same rod in free space.
pub const PROBLEM: Problem = Problem {
    name: "frequencies",
    title: "Natural frequencies of a cantilever and of a free rod",
    source: "Timoshenko's beam (k = 1), roots of its characteristic equation; axial √(E/ρ) (2n−1)/4L, torsion \
             √(G/ρ) (2n−1)/4L. The rod is that of Kim et al. (2017)",
    sketch: r"
  |/|==========================    L = 1 m, d = 20 mm, steel
  |/|                              bending B, axial A, torsion T",
    goal: "Bending, axial and torsional frequencies: 64 quadratic elements within 1e-5, 64 linked ones within 1e-4 (ν = 0, \
           k = 1). The continuum formulation locks: with ν = 0.3 it converges to (λ+2G) I in place of E I, within 1e-4 of \
           which it comes by extrapolation from 32 and 64 elements. A free rod has six rigid motions",
    run,
};

/// Hertz, ν = 0 and k = 1.
const BENDING: [f64; 4] = [13.714693124408, 85.85919781924, 240.0061199541, 469.17308113901];
const AXIAL: [f64; 3] = [1225.6342552009, 3676.9027656026, 6128.1712760044];
const TORSION: [f64; 3] = [866.65429310706, 2599.9628793212, 4333.2714655353];
/// Hertz, ν = 0.3 with (λ+2G) I in place of E I.
const LOCKED: [f64; 3] = [15.910931825754, 99.556825887235, 278.06445474896];

/// The kinds of modes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Bending,
    Axial,
    Torsion,
}

fn model(formulation: &str, elements: u32, poisson: f64, count: u32, clamped: bool) -> String {
    let (area, second) = (std::f64::consts::PI * 1e-4, std::f64::consts::PI * 0.25e-8);
    let section = if formulation == "continuum" {
        r#"{ kind = "circle", diameter = 0.02 }"#.to_owned()
    } else {
        format!(r#"{{ kind = "general", area = {area}, iy = {second}, iz = {second} }}"#)
    };
    let joint = if clamped {
        r#"joints = [{ kind = "clamp", name = "root", a = { body = "rod", at = "start" }, fix = "section" }]"#
    } else {
        ""
    };
    format!(
        r#"
        {joint}
        materials.steel = {{ density = 8030, young = 193e9, poisson = {poisson} }}
        sections.rod = {section}

        [[bodies]]
        kind = "beam"
        name = "rod"
        formulation = "{formulation}"
        from = [0, 0, 0]
        to = [1, 0, 0]
        elements = {elements}
        section = "rod"
        material = "steel"

        [[probes]]
        name = "tip"
        on = {{ body = "rod", at = "end" }}

        [[probes]]
        name = "rim"
        on = {{ body = "rod", at = "end" }}
        offset = [0.01, 0]

        [analysis]
        kind = "modes"
        count = {count}
        "#
    )
}

/// Frequencies of a kind by what the tip and its rim do; bending has every frequency twice, of which one is kept.
fn of_kind(solved: &Solved, kind: Kind) -> Result<Vec<f64>, Error> {
    let column = |name: &str| solved.column(name);
    let (x, y, z, rim) = (column("tip.x")?, column("tip.y")?, column("tip.z")?, column("rim.z")?);
    let mut frequencies = Vec::new();
    for (i, &frequency) in column("frequency")?.iter().enumerate() {
        let (along, across, around) = (x[i].abs(), y[i].hypot(z[i]), (rim[i] - z[i]).abs());
        let found = if around > along && around > across {
            Kind::Torsion
        } else if along > across {
            Kind::Axial
        } else {
            Kind::Bending
        };
        if found == kind {
            frequencies.push(frequency);
        }
    }
    let step = if kind == Kind::Bending { 2 } else { 1 };
    Ok(frequencies.into_iter().step_by(step).collect())
}

fn compare(
    findings: &mut Findings,
    name: &str,
    ours: &[f64],
    reference: &[f64],
    tolerance: f64,
) -> Result<(), Error> {
    for (i, &reference) in reference.iter().enumerate() {
        let what = format!("{name}{}, Hz", i + 1);
        let ours = ours.get(i).ok_or_else(|| Error::Missing(what.clone()))?;
        findings.compare(what, *ours, reference, reference, tolerance);
    }
    Ok(())
}

fn numbered(frequencies: &[f64]) -> Vec<[f64; 2]> {
    frequencies.iter().enumerate().map(|(i, &f)| [(i + 1) as f64, f]).collect()
}

fn run() -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let quadratic = solve(&model("quadratic", 64, 0.0, 36, true))?;
    let bending = of_kind(&quadratic, Kind::Bending)?;
    for (name, kind, reference) in [
        ("B", Kind::Bending, &BENDING[..]),
        ("A", Kind::Axial, &AXIAL[..]),
        ("T", Kind::Torsion, &TORSION[..]),
    ] {
        let ours = of_kind(&quadratic, kind)?;
        compare(&mut findings, &format!("quadratic, {name}"), &ours, reference, 1e-5)?;
    }
    let linked = solve(&model("linked", 64, 0.0, 16, true))?;
    for (name, kind, reference) in [
        ("B", Kind::Bending, &BENDING[..]),
        ("A", Kind::Axial, &AXIAL[..1]),
        ("T", Kind::Torsion, &TORSION[..1]),
    ] {
        let ours = of_kind(&linked, kind)?;
        compare(&mut findings, &format!("linked, {name}"), &ours, reference, 1e-4)?;
    }
    // Errors fall with the square of an element's length.
    let coarse = of_kind(&solve(&model("continuum", 32, 0.3, 6, true))?, Kind::Bending)?;
    let fine = of_kind(&solve(&model("continuum", 64, 0.3, 6, true))?, Kind::Bending)?;
    let limit: Vec<f64> =
        coarse.iter().zip(&fine).map(|(coarse, fine)| fine + (fine - coarse) / 3.0).collect();
    compare(&mut findings, "continuum, ν = 0.3, extrapolated, B", &limit, &LOCKED, 1e-4)?;
    for formulation in ["continuum", "linked", "quadratic"] {
        let free = solve(&model(formulation, 8, 0.0, 8, false))?;
        let rigid = free.column("frequency")?.iter().filter(|&&frequency| frequency == 0.0).count();
        findings.compare(format!("{formulation}, free: rigid motions"), rigid as f64, 6.0, 1.0, 0.0);
    }
    findings.plots.push(Plot {
        title: "Frequencies of bending by the number of the mode".into(),
        axes: ["mode".into(), "frequency, Hz".into()],
        logarithmic: [false, true],
        curves: vec![
            Curve::line("quadratic, ν = 0", numbered(&bending[..4])),
            Curve::points("Timoshenko", numbered(&BENDING)),
            Curve::line("continuum, ν = 0.3", numbered(&limit)),
            Curve::points("its limit", numbered(&LOCKED)),
        ],
        ..Plot::default()
    });
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        super::super::assert_holds(&super::PROBLEM);
    }
}
