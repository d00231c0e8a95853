//! Plates with transverse shear: deflections and frequencies of the theory of Mindlin, and laminates.

use std::f64::consts::TAU;

use super::mesh::{MeshModel, edge, isotropic, node, on_disc, probe};
use crate::problems::models::study;
use crate::{Findings, Plot, PlotCurve, Problem, Refinement, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "mindlin_plate",
        title: "Thick square plate on hard simple supports",
        source: "Navier solution of the Reissner-Mindlin plate with κ = 5/6, ν = 0.3: w D/(q a⁴) = 0.00406445756, 0.00427284224 and \
                 0.00490431098 for h/a = 0.01, 0.1 and 0.2; ω a² √(ρh/D) = 19.0649671691 and 45.4826799050 for h/a = 0.1",
        sketch: r"
      +--------+
      |        |   a = 1, D = 1, ρh = 1
      +--------+",
        goal: "Deflection within 0.5 % with 16 × 16 elements, and two frequencies within 1 % with 24 × 24 elements",
        run: mindlin,
    },
    Problem {
        name: "mindlin_frequencies",
        title: "Frequencies of thin and thick square plates on hard simple supports",
        source: "Navier solution of Mindlin's plate with κ = 5/6, ν = 0.3, three unknowns for each pair of half-waves: ω a² √(ρh/D) for \
                 h/a = 0.001, 0.01, 0.1 and 0.2",
        sketch: r"
      +--------+
      |        |   a = 1, D = 1, ρh = 1
      +--------+",
        goal: "Frequencies of the modes (1, 1), (2, 1) and (2, 2) within 1 % with 24 × 24 elements; errors of second order",
        run: frequencies,
    },
    Problem {
        name: "clamped_circle",
        title: "Frequencies of a thin clamped circular plate",
        source: "Bessel functions, J₀ I₁ + I₀ J₁ = 0 and J₁ I₂ + I₁ J₂ = 0: ω a² √(ρh/D) = 10.2158262 and 21.2603977",
        sketch: r"
        .--''--.
       (        )   a = 1, D = 1, ρh = 1, h = 0.002
        '--..--'",
        goal: "First frequency within 0.5 % and second one within 1 % with 32 × 32 elements on the whole plate; second order",
        run: circle,
    },
    Problem {
        name: "shear_shell_laminates",
        title: "Cross-ply square plates with transverse shear",
        source: "Navier solution of the first-order theory with κ = 5/6, E_L = 25 E_T, G_LT = 0.5 E_T, G_TT = 0.2 E_T, ν = 0.25: \
                 100 E_T w h³/(q a⁴) = 1.02193277 (0/90/0) and 1.94686989 (0/90), ω a²/h √(ρ/E_T) = 12.1628548487 and 8.9000743731 for \
                 a/h = 10",
        sketch: r"
      +--------+
      |        |   uniform load q; edges supported along w and the tangent
      +--------+",
        goal: "Deflection within 0.5 % and first frequency within 1 % with 16 × 16 elements",
        run: laminates,
    },
    Problem {
        name: "skew_plate",
        title: "Morley's skew plate under a uniform load",
        source: "Morley (1963): w D/(q a⁴) = 0.408e-3 for a thin plate with simply supported edges. An independent Kirchhoff-Love code on \
                 graded meshes converges slowly to it: 0.3851e-3, 0.3936e-3 and 0.3980e-3",
        sketch: r"
         +--------+
        /        /    rhombus a = 1 of 30 degrees, h = 0.01, D = 1, ν = 0.3
       +--------+     edges supported along w only",
        goal: "Deflection of the centre within 2 % with 32 × 32 elements: moments are singular in the corners of 150 degrees",
        run: skew,
    },
];

/// Small displacements.
const SMALL: f64 = 1e-6;

fn pressure(size: f64) -> String {
    format!("[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nforce = [0, 0, {size:e}]\n")
}

/// Square plate of n × n elements with a side, a bending stiffness D and a mass per area of 1, for ν = 0.3.
pub(super) fn plate(n: usize, h: f64) -> MeshModel {
    let material = isotropic([12.0 * (1.0 - 0.09) / h.powi(3), 0.3, 1.0 / h]);
    MeshModel::plate([n, n], [1.0, 1.0], h, material)
}

/// Deflection of the middle of a plate on hard simple supports, for a unit load per area.
pub(super) fn deflection(plate: &MeshModel) -> Result<f64, VerificationError> {
    let supports: String =
        ["u0", "u1", "v0", "v1"].map(|name| edge(name, "\"guided\"\naxes = [\"z\"]\nhard = true")).concat();
    let model = format!(
        "{plate}{supports}{}{}{}{}[analysis]\nkind = \"statics\"\n",
        node("p00", "\"x\", \"y\""),
        node("p10", "\"y\""),
        pressure(SMALL),
        probe("c", "middle")
    );
    Ok(solve(&model)?.last("c.z")? / SMALL)
}

fn mindlin() -> Result<Findings, VerificationError> {
    let (mut found, mut points) = (Findings::default(), Vec::new());
    for (h, exact) in [(0.01, 0.00406445756), (0.1, 0.00427284224), (0.2, 0.00490431098)] {
        let ours = deflection(&plate(16, h))?;
        points.push([h, ours / exact]);
        found.compare(format!("deflection, h/a = {h}"), ours, exact, exact, 5e-3);
    }
    let curves = vec![PlotCurve::points("computed", points)];
    found.plot(Plot::new("Deflection, relative to the Navier solution", ["h/a", "ratio"], curves));
    // Without displacements in the plane, the lowest modes are those of bending.
    let supports: String = ["u0", "u1", "v0", "v1"]
        .map(|name| edge(name, "\"guided\"\naxes = [\"x\", \"y\", \"z\"]\nhard = true"))
        .concat();
    let model = format!("{}{supports}[analysis]\nkind = \"modes\"\ncount = 3\n", plate(24, 0.1));
    let solved = solve(&model)?;
    let frequencies = solved.column("frequency")?;
    for (k, exact) in [19.0649671691, 45.4826799050, 45.4826799050].into_iter().enumerate() {
        let ours = frequencies.get(k).map_or(f64::NAN, |f| TAU * f);
        found.compare(format!("frequency {}", k + 1), ours, exact, exact, 1e-2);
    }
    Ok(found)
}

/// ω a² √(ρh/D) of the modes (1, 1), (2, 1) and (2, 2) for the thicknesses h/a.
const MINDLIN: [(f64, [f64; 3]); 4] = [
    (0.001, [19.7391369062, 49.3475726562, 78.9556848843]),
    (0.01, [19.7320239232, 49.3031617895, 78.8421086762]),
    (0.1, [19.0649671691, 45.4826799050, 69.7943648753]),
    (0.2, [17.4485912188, 38.1521664809, 55.1500772421]),
];

/// Circular frequency of a row.
fn frequency(row: usize) -> impl Fn(&SolvedModel) -> Result<f64, VerificationError> {
    move |solved| Ok(solved.column("frequency")?.get(row).map_or(f64::NAN, |f| TAU * f))
}

/// Modes of a plate with equal supports of all edges.
fn modes(plate: &MeshModel, condition: &str, count: usize) -> String {
    let supports: String = ["u0", "u1", "v0", "v1"].map(|name| edge(name, condition)).concat();
    format!("{plate}{supports}[analysis]\nkind = \"modes\"\ncount = {count}\n")
}

fn frequencies() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    for (h, [first, second, third]) in MINDLIN {
        // Without displacements in the plane, the lowest four modes are those of bending.
        let hinged = "\"guided\"\naxes = [\"x\", \"y\", \"z\"]\nhard = true";
        let model = |n: u32| modes(&plate(n as usize, h), hinged, 4);
        let names = [(1, 1), (2, 1), (2, 2)].map(|(m, n)| format!("ω ({m}, {n}), h/a = {h}"));
        let one = Refinement::new("elements", &[12, 24], model)
            .value(&names[0], frequency(0), first, 1e-2)
            .order(2.0)
            .value(&names[1], frequency(1), second, 1e-2)
            .order(2.0)
            .value(&names[2], frequency(3), third, 1e-2)
            .order(2.0)
            .run()?;
        found.comparisons.extend(one.comparisons);
        found.plots.extend(one.plots);
    }
    Ok(found)
}

fn circle() -> Result<Findings, VerificationError> {
    let h: f64 = 0.002;
    let material = || isotropic([12.0 * (1.0 - 0.09) / h.powi(3), 0.3, 1.0 / h]);
    let disc = |n: u32| {
        let shell = MeshModel::grid([n as usize; 2], h, material(), |place| {
            let [x, y] = on_disc(place.map(|u| 2.0 * u - 1.0));
            [[x, y, 0.0], [0.0, 0.0, 1.0]]
        });
        modes(&shell, "\"clamped\"", 2)
    };
    Refinement::new("elements", &[8, 16, 32], disc)
        .value("first frequency", frequency(0), 10.2158262, 5e-3)
        .order(2.0)
        .value("second frequency", frequency(1), 21.2603977, 1e-2)
        .order(2.0)
        .run()
}

fn laminates() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    let support =
        |name: &str, axis: &str| edge(name, &format!("\"guided\"\naxes = [\"{axis}\", \"z\"]\nhard = true"));
    let supports = [support("u0", "y"), support("u1", "y"), support("v0", "x"), support("v1", "x")].concat();
    let material = "young = 25, poisson = 0.25, density = 1, orthotropic = { young = 1, shear = 0.5, transverse_shear = 0.2 }";
    let quarter = TAU / 4.0;
    let plies: [(&str, &[f64], [f64; 2]); 2] = [
        ("0/90/0", &[0.0, quarter, 0.0], [1.02193277, 12.1628548487]),
        ("0/90", &[0.0, quarter], [1.94686989, 8.9000743731]),
    ];
    for (name, angles, [deflection, frequency]) in plies {
        let layers: Vec<String> = angles.iter().map(|angle| format!("{{ angle = {angle:?} }}")).collect();
        let shell = MeshModel {
            keys: format!("fibre_axis = [1, 0, 0]\nlayers = [{}]\n", layers.join(", ")),
            ..MeshModel::plate([16, 16], [10.0, 10.0], 1.0, material.to_owned())
        };
        let model = format!(
            "{shell}{supports}{}{}[analysis]\nkind = \"statics\"\n",
            pressure(SMALL),
            probe("c", "middle")
        );
        let ours = 100.0 * solve(&model)?.last("c.z")? / (SMALL * 1e4);
        let mut points = vec![[1.0, ours / deflection]];
        found.compare(format!("{name}: deflection"), ours, deflection, deflection, 5e-3);
        let model = format!("{shell}{supports}[analysis]\nkind = \"modes\"\ncount = 1\n");
        let ours = solve(&model)?.column("frequency")?.first().map_or(f64::NAN, |f| TAU * f * 100.0);
        points.push([2.0, ours / frequency]);
        found.compare(format!("{name}: frequency"), ours, frequency, frequency, 1e-2);
        curves.push(PlotCurve::points(name, points));
    }
    let axes = ["deflection (1), frequency (2)", "ratio"];
    found.plot(Plot::new("Deflection and frequency, relative to the Navier solution", axes, curves));
    Ok(found)
}

fn skew() -> Result<Findings, VerificationError> {
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    study(&[8, 16, 32], "deflection of the centre", (0.408e-3, 2e-2), |n| {
        let material = isotropic([12.0 * (1.0 - 0.09) * 1e6, 0.3, 1.0]);
        let shell = MeshModel::grid([n as usize; 2], 0.01, material, |[u, v]| {
            [[u + v * cos, v * sin, 0.0], [0.0, 0.0, 1.0]]
        });
        let supports = ["u0", "u1", "v0", "v1"].map(|name| edge(name, "\"guided\"\naxes = [\"z\"]")).concat();
        let model = format!(
            "{shell}{supports}{}{}{}{}[analysis]\nkind = \"statics\"\n",
            node("p00", "\"x\", \"y\""),
            node("p10", "\"y\""),
            pressure(SMALL),
            probe("c", "middle")
        );
        Ok(solve(&model)?.last("c.z")? / SMALL)
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
