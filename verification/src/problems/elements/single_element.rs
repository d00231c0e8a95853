use std::sync::Arc;

use ancf::mechanics::elements::{Beam24, Profile};
use ancf::mechanics::kinematics::BeamShape;
use ancf::model::{Material, Section};
use ancf::solver::equations::{LOCAL, Local, LocalMatrix, Term, Weights};
use nalgebra::Vector3;

use crate::problems::models::{Cantilever, KIM, KIM_AREA, ROD, end_probe, joint};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Mass, gravity, stiffness, stretch and release of one element.
pub const PROBLEM: Problem = Problem {
    name: "single_element",
    title: "Mass, gravity, stiffness, stretch and release of one element",
    source: "Unit test of the beam 3243 of Project Chrono; closed forms of the shape functions",
    sketch: r"
     y|  /z
      | /              order: r, r_x, r_y, r_z of both nodes
      o================o -- x     1 × 0.1 × 0.1 m, ρ = 7850 kg/m³, E = 210 GPa, ν = 0.3",
    goal: "Mass, gravity and stiffness to 1e-9, the shear terms of the stiffness times the factor k of Chrono, which \
               this element does \
           not have; stretch under a force at the end by s³ − s = 2P/EA, for all beams, and by s − 1 = P/EA for the cable; \
           acceleration of a pinned element at its release, and reaction m g/16 of the pin",
    run,
};

const TOLERANCE: f64 = 1e-9;
const MATERIAL: Material = Material::elastic(7850.0, 210e9, 0.3);

fn profile() -> Profile<8> {
    let section = Section::rectangle(0.1, 0.1);
    let shape = BeamShape { length: 1.0, slope: 1.0 };
    let gravity = Vector3::new(0.0, 0.0, -9.80665);
    Profile::new(shape, MATERIAL.lame(), MATERIAL.density, section.moments(), gravity)
}

fn element() -> Beam24 {
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()];
    Beam24::new(0..24, frame, Arc::new(profile()))
}

const REST: Local<'_> = Local { q: &[0.0; 24], v: &[0.0; 24], a: &[0.0; 24], lambda: &[], t: 0.0, load: 1.0 };

/// Non-zero entries of the upper triangle of the compact mass matrix.
const MASS: [(usize, usize, f64); 16] = [
    (0, 0, 29.1571428571429),
    (0, 1, 4.11190476190476),
    (0, 4, 10.0928571428571),
    (0, 5, -2.4297619047619),
    (1, 1, 0.747619047619048),
    (1, 4, 2.4297619047619),
    (1, 5, -0.560714285714286),
    (4, 4, 29.1571428571429),
    (4, 5, -4.11190476190476),
    (5, 5, 0.747619047619048),
    (2, 2, 0.0218055555555556),
    (2, 6, 0.0109027777777778),
    (6, 6, 0.0218055555555556),
    (3, 3, 0.0218055555555556),
    (3, 7, 0.0109027777777778),
    (7, 7, 0.0218055555555556),
];

fn mass(findings: &mut Findings) {
    let profile = profile();
    let mass = profile.mass();
    let mut rest = 0.0_f64;
    for i in 0..8 {
        for j in i..8 {
            match MASS.iter().find(|&&(row, column, _)| (row, column) == (i, j)) {
                Some(&(_, _, value)) => {
                    findings.compare(format!("M{}{}, kg", i + 1, j + 1), mass[i][j], value, value, TOLERANCE);
                }
                None => rest = rest.max(mass[i][j].abs()),
            }
        }
    }
    findings.compare("largest other entry of M, kg", rest, 0.0, MASS[0].2, 1e-15);
}

/// Compares gravity. The residual at rest is minus the force of gravity.
fn gravity(findings: &mut Findings) {
    let mut r = [0.0; 24];
    element().residual(&REST, &mut r);
    for (at, force) in [(2, -384.9110125), (5, -64.1518354166667), (14, -384.9110125), (17, 64.1518354166667)]
    {
        findings.compare(format!("gravity on coordinate {}, N", at + 1), -r[at], force, force, TOLERANCE);
        r[at] = 0.0;
    }
    let rest = r.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    findings.compare("largest other force of gravity, N", rest, 0.0, 384.9, 1e-15);
}

fn stiffness(findings: &mut Findings) {
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(24, &mut storage);
    element().tangent(&REST, Weights::STIFFNESS, &mut k);
    let shear_factor = 10.0 * 1.3 / (12.0 + 11.0 * 0.3);
    for (i, j, value) in [
        (0, 0, 3392307692.30769),
        (3, 0, 282692307.692308),
        (3, 3, 376923076.923077),
        (7, 0, -605769230.769231),
    ] {
        findings.compare(format!("K at ({}, {}), N/m", i + 1, j + 1), k.get(i, j), value, value, TOLERANCE);
    }
    for (i, j, value) in [
        (1, 1, 823529411.764706),
        (2, 2, 823529411.764706),
        (4, 1, 68627450.9803922),
        (6, 1, -343137254.901961),
    ] {
        let what = format!("k K at ({}, {}), N/m", i + 1, j + 1);
        findings.compare(what, shear_factor * k.get(i, j), value, value, TOLERANCE);
    }
}

/// P/EA and the stretch s with s³ − s = 2P/EA.
const STRETCHES: [(f64, f64); 4] = [
    (0.001, 1.000998503986923),
    (0.01, 1.009853873369681),
    (0.1, 1.088033914691289),
    (0.5, 1.324717957244746),
];

fn stretch(findings: &mut Findings) -> Result<(), VerificationError> {
    let mut curves = Vec::new();
    for element in ["continuum", "enhanced", "linked", "quadratic", "cable"] {
        let mut ours = Vec::new();
        for (force, s) in STRETCHES {
            let young = 1.0 / KIM_AREA;
            let cantilever = Cantilever {
                element,
                material: &format!("{{ density = 1, young = {young:e} }}"),
                gravity: 0.0,
                load: Some(&format!("kind = \"force\"\nforce = [{force}, 0, 0]")),
                statics: "first = 0.05\nstop = { rule = \"energy\", tolerance = 1e-11 }",
                ..KIM
            };
            let solved = solve(&cantilever.model())?;
            // The force of a cable is E A (s − 1).
            let s = if element == "cable" { 1.0 + force } else { s };
            let what = format!("stretch, {element}, P/EA = {force}");
            findings.compare(what, solved.last("tip.x")?, s, 1.0, 1e-10);
            ours = solved.points("tip.x", "load")?.into_iter().map(|[s, load]| [s, load * force]).collect();
        }
        curves.push(PlotCurve::line(element, ours));
    }
    curves.push(PlotCurve::points("s³ − s = 2P/EA", STRETCHES.map(|(force, s)| [s, force]).to_vec()));
    findings.plot(Plot::new("Force on one element against its stretch", ["s", "P/EA"], curves));
    Ok(())
}

/// Compares a horizontal rod, pinned at its start, at its release. Unlike a rigid rod, its tip has the acceleration 5g/4.
fn release(findings: &mut Findings) -> Result<(), VerificationError> {
    let solved = solve(&format!(
        r#"
        gravity = [0, -9.81, 0]
        materials.material = {{ density = 8030, young = 193e9 }}
        sections.section = {{ kind = "circle", diameter = 0.02 }}
        {ROD}{pin}{tip}
        [analysis]
        kind = "dynamics"
        duration = 1e-6
        step = 1e-6
        "#,
        pin = joint("spherical", "pin", "{ body = \"rod\", at = \"start\" }"),
        tip = end_probe("tip", "rod")
    ))?;
    let first = |name: &str| -> Result<f64, VerificationError> {
        solved
            .column(name)?
            .first()
            .copied()
            .ok_or_else(|| VerificationError::Missing(format!("row in {name}")))
    };
    let weight = 8030.0 * KIM_AREA * 9.81;
    findings.compare("tip's acceleration at release by g", first("tip.ay")? / -9.81, 1.25, 1.0, TOLERANCE);
    findings.compare(
        "pin's reaction at release by m g",
        first("pin.fy")? / weight,
        1.0 / 16.0,
        1.0,
        TOLERANCE,
    );
    Ok(())
}

fn run() -> Result<Findings, VerificationError> {
    let mut findings = Findings::default();
    mass(&mut findings);
    gravity(&mut findings);
    stiffness(&mut findings);
    stretch(&mut findings)?;
    release(&mut findings)?;
    Ok(findings)
}

#[cfg(test)]
mod tests {
    #[test]
    fn holds() {
        crate::assert_holds(&super::PROBLEM);
    }
}
