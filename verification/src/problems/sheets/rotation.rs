//! Plates that rotate: a blade, a ring, and a disc.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::model::{Edge, Element, Sheet};
use crate::problems::shear_shells::mesh::{self, MeshModel, isotropic};
use crate::problems::shells::models::{self, ShellModel};
use crate::reference::{root, runge_kutta};
use crate::{Findings, Plot, PlotCurve, Problem, Refinement, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "rotating_blade",
        title: "Frequencies of a rotating cantilever plate",
        source: "Wright, Smith, Thresher & Wang (1982): ω √(ρA L⁴/EI) = 4.1373, 5.5850 and 7.3604 across the plane of rotation for \
                 γ = Ω √(ρA L⁴/EI) = 2, 4 and 6; more digits by a Runge-Kutta integration of EI w'''' − (T w')' = ρA ω² w, \
                 T = ½ρA Ω² (L² − x²). In the plane of rotation ω² is smaller by Ω²",
        sketch: r"
      Ω |
        O=============    L = 1, b = 0.1, h = 0.003, ν = 0
          flat or on edge; no hub",
        goal: "First frequency across and in the plane of rotation within 1e-4 with 10 thin elements, and with 32 shear-deformable ones",
        run: blade,
    },
    Problem {
        name: "rotating_ring",
        title: "Rotating ring of thin shells",
        source: "Timoshenko & Goodier (1951), art. 32: σ_r = k (a² + b² − a²b²/r² − r²), σ_θ = k (a² + b² + a²b²/r² − \
                 (1 + 3ν) r²/(3 + ν)), k = (3 + ν)/8 ρΩ², u = r (σ_θ − ν σ_r)/E",
        sketch: r"
        .--''--.
       (   __   )  Ω      a = 0.5 m, b = 0.1 m, E = 2e11, ν = 0.3, ρ = 7800
        '--..--'",
        goal: "A quarter of n × n elements: displacements of both edges within 1e-4 with 8 × 8 elements, fourth order. Stresses within 1 %, \
               second order",
        run: ring,
    },
    Problem {
        name: "rotating_disc",
        title: "Rotating disc of shear-deformable shells",
        source: "Timoshenko & Goodier (1951), art. 32: u = ρΩ² a³ (1 − ν)/4E at the edge, σ = (3 + ν)/8 ρΩ² a² in the centre",
        sketch: r"
        .--''--.
       (        )  Ω      a = 0.5 m, E = 2e11, ν = 0.3, ρ = 7800
        '--..--'",
        goal: "A quarter of n × n elements: displacement of the edge and stress in the centre within 0.2 % with 16 × 16 elements. \
               Second order",
        run: disc,
    },
    Problem {
        name: "spinning_disc",
        title: "Disc that spins freely",
        source: "Initial rotation of the undeformed disc: it vibrates about the steady rotation, whose displacement of the edge is \
                 ρω² a³ (1 − ν)/4E (Timoshenko & Goodier 1951, art. 32). The angular momentum is constant",
        sketch: r"
        .--''--.
       (        )  ω      a = 0.5 m, E = 1e7, ν = 0.3, ρ = 1000, ω = 5
        '--..--'",
        goal: "8 × 8 shear-deformable elements, 250 steps of the energy-momentum scheme, about ten radial vibrations: mean displacement of \
               the edge with the weights of a Hann window within 2 %, angular momentum constant to 1e-12",
        run: spinning,
    },
];

/// Returns ω √(ρA L⁴/EI) of the first mode of a beam without a hub, across the plane of rotation, for the speed γ.
///
/// w'''' − (T w')' = ω² w with w = w' = 0 at the root and w'' = w''' = 0 at the tip.
fn flapping(speed: f64) -> f64 {
    let determinant = |omega: f64| {
        let slope = |x: f64, y: &[f64; 4]| {
            let [tension, rate] = [0.5 * speed.powi(2) * (1.0 - x * x), -speed.powi(2) * x];
            [y[1], y[2], y[3], tension * y[2] + rate * y[1] + omega.powi(2) * y[0]]
        };
        let starts = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let [a, b] = starts.map(|start| runge_kutta(slope, start, 1.0, 200));
        a[2] * b[3] - a[3] * b[2]
    };
    // Above the frequency Ω of a rigid blade on a hinge, and below the second one.
    root(determinant, speed, 5.0 + speed)
}

/// Returns the first frequency ω √(ρA L⁴/EI) of a blade whose width has a direction.
fn blade_frequency(element: Element, width: [f64; 3], speed: f64) -> Result<f64, VerificationError> {
    let ([breadth, thickness], elements) = ([0.1, 0.003_f64], if element == Element::Thin { 10 } else { 32 });
    let (young, density) = (12.0 / (breadth * thickness.powi(3)), 1.0 / (breadth * thickness));
    let sheet = Sheet {
        element,
        corner: width.map(|x| -0.5 * breadth * x),
        sides: [[1.0, 0.0, 0.0], width.map(|x| breadth * x)],
        elements: [elements, 1],
        thickness,
        material: isotropic([young, 0.0, density]),
        keys: String::new(),
    };
    let solved = solve(&format!(
        "{}{}[[loads]]\nkind = \"base_rotation\"\nangular_velocity = [0, 0, {speed:?}]\n\
         [analysis]\nkind = \"modes\"\nabout = \"equilibrium\"\ndamped = true\ncount = 1\n",
        sheet.body(),
        sheet.support(Edge::Left, "clamped")
    ))?;
    Ok(TAU * solved.last("frequency")?)
}

/// Speeds γ and frequencies of the table of Wright et al. (1982).
const TABLE: [[f64; 2]; 3] = [[2.0, 4.1373], [4.0, 5.5850], [6.0, 7.3604]];

fn blade() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (direction, width, share) in
        [("across the plane", [0.0, 1.0, 0.0], 0.0), ("in the plane", [0.0, 0.0, 1.0], 1.0)]
    {
        let exact = |speed: f64| (flapping(speed).powi(2) - share * speed.powi(2)).sqrt();
        for (element, tolerance) in [(Element::Thin, 1e-4), (Element::Shear, 1e-4)] {
            let mut points = Vec::new();
            for [speed, _] in TABLE {
                let (ours, exact) = (blade_frequency(element, width, speed)?, exact(speed));
                let what = format!("{direction}, γ = {speed}, {}", element.name());
                found.compare(what, ours, exact, exact, tolerance);
                points.push([speed, ours]);
            }
            curves.push(PlotCurve::points(format!("{direction}, {}", element.name()), points));
        }
        let line = (1..=12).map(|k| 0.5 * f64::from(k)).map(|speed| [speed, exact(speed)]);
        curves.push(PlotCurve::line(format!("{direction}, beam"), line.collect()));
    }
    for [speed, table] in TABLE {
        found.compare(format!("beam, γ = {speed}, table"), flapping(speed), table, table, 2e-5);
    }
    found.plot(Plot::new("First frequency over the speed of rotation", ["γ", "ω"], curves));
    Ok(found)
}

const YOUNG: f64 = 2e11;
const POISSON: f64 = 0.3;
const DENSITY: f64 = 7800.0;
/// Small displacements: strains of 2e-8.
const SPEED: f64 = 3.0;
const OUTER: f64 = 0.5;
const INNER: f64 = 0.1;
const THICKNESS: f64 = 0.01;

/// Displacement and stress along the circumference of the ring at a radius.
fn ring_at(r: f64) -> [f64; 2] {
    let [a, b] = [OUTER.powi(2), INNER.powi(2)];
    let k = (3.0 + POISSON) / 8.0 * DENSITY * SPEED.powi(2);
    let radial = k * (a + b - a * b / (r * r) - r * r);
    let along = k * (a + b + a * b / (r * r) - (1.0 + 3.0 * POISSON) / (3.0 + POISSON) * r * r);
    [r * (along - POISSON * radial) / YOUNG, along]
}

/// Rotation of the ground, and the end of a model.
fn steady() -> String {
    format!(
        "[[loads]]\nkind = \"base_rotation\"\nangular_velocity = [0, 0, {SPEED:?}]\n[analysis]\nkind = \"statics\"\n"
    )
}

/// Probe with membrane forces.
fn with_forces(probe: String) -> String {
    probe + "record = [\"motion\", \"resultants\"]\n"
}

fn ring() -> Result<Findings, VerificationError> {
    let surface = format!(
        "kind = \"revolved\", from = [{INNER:?}, 0, 0], to = [{OUTER:?}, 0, 0], center = [0, 0, 0], axis = [0, 0, 1], \
         angle = {FRAC_PI_2:?}"
    );
    let model = |n: u32| {
        let shell = ShellModel {
            surface: &surface,
            elements: [n, n],
            thickness: THICKNESS,
            material: [YOUNG, POISSON, DENSITY],
        };
        format!(
            "{shell}{}{}{}{}{}{}",
            models::edge("u_start", "\"symmetry\""),
            models::edge("u_end", "\"symmetry\""),
            models::node("z", [0.0, 0.0], "\"z\""),
            with_forces(models::probe("inner", [0.0, 0.0])),
            with_forces(models::probe("outer", [0.0, 1.0])),
            steady()
        )
    };
    let moved = |name: &'static str, r: f64| move |s: &SolvedModel| Ok(s.last(name)? - r);
    let stress = |name: &'static str| move |s: &SolvedModel| Ok(s.last(name)? / THICKNESS);
    let [[inner, inner_stress], [outer, outer_stress]] = [ring_at(INNER), ring_at(OUTER)];
    Refinement::new("elements", &[4, 8], model)
        .value("displacement of the inner edge, m", moved("inner.x", INNER), inner, 1e-4)
        .order(4.0)
        .value("displacement of the outer edge, m", moved("outer.x", OUTER), outer, 1e-4)
        .order(4.0)
        .value("stress at the inner edge, Pa", stress("inner.nuu"), inner_stress, 1e-2)
        .order(2.0)
        .value("stress at the outer edge, Pa", stress("outer.nuu"), outer_stress, 1e-2)
        .order(2.0)
        .run()
}

fn disc() -> Result<Findings, VerificationError> {
    let model = |n: u32| {
        let shell =
            MeshModel::grid([n as usize; 2], THICKNESS, isotropic([YOUNG, POISSON, DENSITY]), |[u, v]| {
                let [x, y] = mesh::on_disc([u, v]);
                [[OUTER * x, OUTER * y, 0.0], [0.0, 0.0, 1.0]]
            });
        format!(
            "{shell}{}{}{}{}{}{}",
            mesh::edge("u0", "\"symmetry\""),
            mesh::edge("v0", "\"symmetry\""),
            mesh::node("p00", "\"z\""),
            with_forces(mesh::probe("centre", "p00")),
            with_forces(mesh::probe("edge", "p10")),
            steady()
        )
    };
    let displacement = DENSITY * SPEED.powi(2) * OUTER.powi(3) * (1.0 - POISSON) / (4.0 * YOUNG);
    let stress = (3.0 + POISSON) / 8.0 * DENSITY * SPEED.powi(2) * OUTER.powi(2);
    Refinement::new("elements", &[4, 8, 16], model)
        .value("displacement of the edge, m", |s| Ok(s.last("edge.x")? - OUTER), displacement, 2e-3)
        .order(2.0)
        .value("stress in the centre, Pa", |s| Ok(s.last("centre.nuu")? / THICKNESS), stress, 2e-3)
        .order(2.0)
        .run()
}

fn spinning() -> Result<Findings, VerificationError> {
    let (young, density, spin, n) = (1e7, 1000.0, 5.0_f64, 8);
    let shell = MeshModel::grid([n; 2], 0.02, isotropic([young, POISSON, density]), |place| {
        let [x, y] = mesh::on_disc(place.map(|u| 2.0 * u - 1.0));
        [[OUTER * x, OUTER * y, 0.0], [0.0, 0.0, 1.0]]
    });
    let shell = MeshModel {
        keys: format!("motion = {{ spin = [0, 0, {spin:?}], about = [0, 0, 0] }}\n"),
        groups: shell.groups.clone() + &format!("groups.side = {{ nodes = [{}] }}\n", n / 2),
        ..shell
    };
    let solved = solve(&format!(
        "output.momentum = true\n{shell}{}[analysis]\nkind = \"dynamics\"\nduration = 0.15\nstep = 6e-4\n\
         scheme = \"energy\"\n",
        mesh::probe("edge", "side")
    ))?;
    let (x, y) = (solved.column("edge.x")?, solved.column("edge.y")?);
    let moved: Vec<f64> = x.iter().zip(y).map(|(x, y)| x.hypot(*y) - OUTER).collect();
    let last = (moved.len() - 1) as f64;
    let weights: Vec<f64> = (0..moved.len()).map(|k| 1.0 - (TAU * k as f64 / last).cos()).collect();
    let sum: f64 = moved.iter().zip(&weights).map(|(u, weight)| u * weight).sum();
    let mean = sum / weights.iter().sum::<f64>();
    let exact = density * spin.powi(2) * OUTER.powi(3) * (1.0 - POISSON) / (4.0 * young);
    let mut found = Findings::default();
    found.compare("mean displacement of the edge, m", mean, exact, exact, 2e-2);
    let momentum = solved.column("lz")?;
    for (row, value) in [("half", momentum[momentum.len() / 2]), ("end", momentum[momentum.len() - 1])] {
        let what = format!("angular momentum at the {row}, kg m²/s");
        found.compare(what, value, momentum[0], momentum[0], 1e-12);
    }
    let points = solved.column("t")?.iter().zip(&moved).map(|(t, u)| [*t, *u]).collect();
    let steady = vec![[0.0, exact], [0.15, exact]];
    let curves = vec![PlotCurve::line("computed", points), PlotCurve::line("steady rotation", steady)];
    found.plot(Plot::new("Displacement of the edge", ["t, s", "m"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
