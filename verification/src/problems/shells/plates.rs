//! Plates: natural frequencies, also of twisted ones, buckling, and a corner load with large rotations.

use std::f64::consts::{PI, TAU};

use super::models::{ShellModel, edge, force, node, probe};
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "plate_frequencies",
        title: "Frequencies of square plates",
        source: "Thin plate, ν = 0.3: π² (m² + n²) for hinged edges, Ritz series for others (free 13.468197 19.596137 24.270201 \
                 34.800891, clamped 35.9851911 73.3938455 108.2165017); cantilever 3.47100 8.5062 21.2839 27.1987 by an \
                 independent Kirchhoff-Love code on 24 × 24 elements",
        sketch: r"
      +--------+
      |        |   a = 1, h = 0.01, D = 1, ρh = 1
      +--------+",
        goal: "Circular frequencies within 0.5 % with 6 × 6 elements for free, clamped, hinged and cantilever plates",
        run: frequencies,
    },
    Problem {
        name: "plate_frequencies_fine",
        title: "Frequencies of plates on a fine mesh",
        source: "Ritz series with 18 × 18 terms: free, clamped, two opposite edges clamped or hinged, and cantilevers with a/b = 2 and 0.5. \
                 Square cantilever by an independent Kirchhoff-Love code on 24 × 24 elements",
        sketch: r"
      +--------+
      |        |   a = 1, h = 0.01, D = 1, ρh = 1, ν = 0.3
      +--------+",
        goal: "44 circular frequencies within 1e-4 with 24 × 24 elements",
        run: fine_frequencies,
    },
    Problem {
        name: "twisted_plates",
        title: "Frequencies of twisted cantilever plates",
        source: "Thin plates of the data of Leissa, MacBain & Kielb (1984), ν = 0.3, by an independent Kirchhoff-Love code with B-splines \
                 of degree 4 on 16 × 10 elements; in-plane bending of the flat plate 62.192 by a Ritz series of plane stress with \
                 32 × 14 terms",
        sketch: r"
  |/+--------.
  |/|         \.     length a, chord b, b/h = 20, twist 15 to 60 degrees
  |/+----------'     a/b = 1 and 3",
        goal: "ω a² √(ρh/D): five modes for a/b = 1 with 6 × 6 elements and four for a/b = 3 with 12 × 4 elements within 0.15 %, in-plane \
               bending within 0.1 %",
        run: twisted,
    },
    Problem {
        name: "plate_buckling",
        title: "Buckling of a square plate under edge compression",
        source: "Bryan (1891): N = π² D (m + 1/m)²/a²: 4 π² D/a², 6.25 π² D/a²",
        sketch: r"
     -->+--------+
     -->|        |<--   hinged edges, D = 1, a = 1
     -->+--------+",
        goal: "Two critical loads within 0.5 % with 8 × 8 elements",
        run: buckling,
    },
    Problem {
        name: "plate_corner_load",
        title: "Square cantilever plate with a force at a corner",
        source: "Data of Yamashita, Valkeapää, Jayakumar & Sugiyama (2015). Recomputed by an independent Kirchhoff-Love code with \
                 B-splines of degree 4 on 14 × 14 elements",
        sketch: r"
  |/+--------+
  |/|        |     1 × 1 × 0.01 m, E = 2.1e8, ν = 0.3
  |/+--------+ F   F = 50 N",
        goal: "Displacements of both free corners within 0.5 % of 0.65 m with 4 × 4 elements",
        run: corner,
    },
];

const SQUARE: &str = "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0]";
const EDGES: [&str; 4] = ["u_start", "u_end", "v_start", "v_end"];

/// Square plate with D = 1 and ρh = 1.
const fn plate(elements: u32) -> ShellModel<'static> {
    rectangle(SQUARE, [elements; 2])
}

/// Plate with D = 1 and ρh = 1.
const fn rectangle(surface: &str, elements: [u32; 2]) -> ShellModel<'_> {
    ShellModel { surface, elements, thickness: 0.01, material: [12.0 * (1.0 - 0.09) * 1e6, 0.3, 100.0] }
}

fn frequencies() -> Result<Findings, VerificationError> {
    let all = |condition: &str| EDGES.map(|name| edge(name, condition)).concat();
    let squares = [2.0, 5.0, 5.0, 8.0].map(|sum| sum * PI * PI);
    let cases = [
        ("free", String::new(), 6, [13.468197, 19.596137, 24.270201, 34.800891]),
        ("cantilever", edge("u_start", "\"clamped\""), 0, [3.47100, 8.5062, 21.2839, 27.1987]),
        ("clamped", all("\"clamped\""), 0, [35.9851911, 73.3938455, 73.3938455, 108.2165017]),
        ("hinged", all("\"hinged\""), 0, squares),
    ];
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (name, supports, rigid, exact) in cases {
        let count = rigid + exact.len();
        let model = format!("{}{supports}[analysis]\nkind = \"modes\"\ncount = {count}\n", plate(6));
        let solved = solve(&model)?;
        let ours = solved.column("frequency")?.iter().skip(rigid).map(|f| TAU * f);
        let mut points = Vec::new();
        for (k, (ours, exact)) in ours.zip(exact).enumerate() {
            found.compare(format!("{name}, mode {}", k + 1), ours, exact, exact, 5e-3);
            points.push([(k + 1) as f64, ours / exact]);
        }
        curves.push(PlotCurve::points(name, points));
    }
    found.plot(Plot::new("Frequency relative to the reference", ["mode", "ratio"], curves));
    Ok(found)
}

/// Plate, its supports, the number of rigid motions, and ω a² √(ρh/D).
type FineCase = (&'static str, ShellModel<'static>, String, usize, &'static [f64]);

/// Number of the cases with free edges, which are the first ones.
const WITH_FREE_EDGES: usize = 5;

fn fine_cases() -> [FineCase; 8] {
    let on = |names: &[&str], condition: &str| -> String {
        names.iter().map(|name| edge(name, &format!("\"{condition}\""))).collect()
    };
    let [us, vs] = [["u_start", "u_end"], ["v_start", "v_end"]];
    let square = || plate(24);
    let wide = "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 2, 0]";
    let narrow = "kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 0.5, 0]";
    let root = || on(&["u_start"], "clamped");
    [
        (
            "free",
            square(),
            String::new(),
            6,
            &[
                13.468197, 19.596137, 24.270201, 34.800891, 34.800891, 61.093234, 61.093234, 63.686134,
                69.265405,
            ],
        ),
        ("cantilever", square(), root(), 0, &[3.47100, 8.5062, 21.2839, 27.1987, 30.9543, 54.1838]),
        (
            "two edges hinged, two free",
            square(),
            on(&us, "hinged"),
            0,
            &[9.6313849, 16.1347770, 36.7256420, 38.9449587],
        ),
        (
            "cantilever, a/b = 2",
            rectangle(narrow, [24; 2]),
            root(),
            0,
            &[3.43928, 14.8020, 21.4337, 48.1781, 60.1494],
        ),
        (
            "cantilever, a/b = 0.5",
            rectangle(wide, [24; 2]),
            root(),
            0,
            &[3.49280, 5.35101, 10.18076, 19.0750, 21.8382],
        ),
        (
            "clamped",
            square(),
            on(&EDGES, "clamped"),
            0,
            &[35.9851911, 73.3938455, 73.3938455, 108.2165017, 131.58077, 132.20479],
        ),
        ("hinged", square(), on(&EDGES, "hinged"), 0, &[19.7392088, 49.3480220, 49.3480220, 78.9568352]),
        (
            "two edges clamped, two hinged",
            square(),
            on(&us, "clamped") + &on(&vs, "hinged"),
            0,
            &[28.9508504, 54.7430707, 69.3270137, 94.58528, 102.21619],
        ),
    ]
}

fn fine_frequencies() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (name, shell, supports, rigid, exact) in fine_cases() {
        let count = rigid + exact.len();
        let model = format!("{shell}{supports}[analysis]\nkind = \"modes\"\ncount = {count}\n");
        let solved = solve(&model)?;
        let ours = solved.column("frequency")?.iter().skip(rigid).map(|f| TAU * f);
        let mut points = Vec::new();
        for (k, (ours, exact)) in ours.zip(exact).enumerate() {
            found.compare(format!("{name}, mode {}", k + 1), ours, *exact, *exact, 1e-4);
            points.push([(k + 1) as f64, 1e6 * (ours / exact - 1.0)]);
        }
        curves.push(PlotCurve::points(name, points));
    }
    let held = curves.split_off(WITH_FREE_EDGES);
    for (edges, curves) in [("some free edges", curves), ("all edges held", held)] {
        let title = format!("Deviation of the frequency from the reference, {edges}");
        found.plot(Plot::new(title, ["mode", "1e-6"], curves));
    }
    Ok(found)
}

/// Ratio a/b, twist in degrees, and ω a² √(ρh/D).
type Twisted = (f64, f64, &'static [f64]);

/// The fifth mode for a/b = 3 is in-plane bending, and left out.
const TWISTED: [Twisted; 8] = [
    (1.0, 15.0, &[3.4536, 10.4587, 20.5829, 27.0993, 32.0889]),
    (1.0, 30.0, &[3.40326, 14.4409, 18.7258, 27.2062, 34.8863]),
    (1.0, 45.0, &[3.3256, 16.4365, 18.4758, 27.6222, 38.1822]),
    (1.0, 60.0, &[3.2286, 14.2431, 21.7917, 28.0411, 41.0127]),
    (3.0, 15.0, &[3.4196, 20.6840, 22.2783, 58.2098]),
    (3.0, 30.0, &[3.4210, 19.0164, 25.3479, 55.9787]),
    (3.0, 45.0, &[3.4235, 17.0115, 29.6488, 53.5769]),
    (3.0, 60.0, &[3.4276, 15.0891, 34.6017, 50.9293]),
];

/// Lowest ω a² √(ρh/D) of a cantilever plate with a/b = `length` and a twist.
fn twisted_modes(length: f64, degrees: f64, count: usize) -> Result<Vec<f64>, VerificationError> {
    let surface = format!(
        "kind = \"twisted\", from = [0, 0, 0], to = [{length:?}, 0, 0], width = [0, 1, 0], twist = {:?}",
        degrees.to_radians()
    );
    let thickness: f64 = 0.05;
    let shell = ShellModel {
        surface: &surface,
        elements: if length > 2.0 { [12, 4] } else { [6, 6] },
        thickness,
        material: [12.0 * (1.0 - 0.09) / thickness.powi(3), 0.3, 1.0 / thickness],
    };
    let root = edge("u_start", "\"clamped\"");
    let solved = solve(&format!("{shell}{root}[analysis]\nkind = \"modes\"\ncount = {count}\n"))?;
    Ok(solved.column("frequency")?.iter().map(|f| TAU * f * length.powi(2)).collect())
}

fn twisted() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for (length, degrees, exact) in TWISTED {
        let ours = twisted_modes(length, degrees, exact.len())?;
        let mut points = Vec::new();
        for (k, (ours, exact)) in ours.into_iter().zip(exact).enumerate() {
            let what = format!("a/b = {length}, {degrees}°, mode {}", k + 1);
            found.compare(what, ours, *exact, *exact, 1.5e-3);
            points.push([(k + 1) as f64, ours / exact]);
        }
        curves.push(PlotCurve::points(format!("a/b = {length}, {degrees}°"), points));
    }
    let flat = twisted_modes(3.0, 0.0, 5)?;
    found.compare("a/b = 3, flat, in-plane bending", flat[4], 62.192, 62.192, 1e-3);
    found.plot(Plot::new("Frequency relative to the reference", ["mode", "ratio"], curves));
    Ok(found)
}

fn buckling() -> Result<Findings, VerificationError> {
    let guided = |name: &str, axes: &str| edge(name, &format!("\"guided\"\naxes = [{axes}]"));
    let model = format!(
        "{}{}{}{}{}{}[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [-1, 0, 0]\n\
         [analysis]\nkind = \"buckling\"\ncount = 2\n",
        plate(8),
        guided("u_start", "\"x\", \"z\""),
        guided("u_end", "\"z\""),
        guided("v_start", "\"z\""),
        guided("v_end", "\"z\""),
        node("corner", [0.0, 0.0], "\"y\"")
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    let exact = [4.0, 6.25].map(|k| k * PI * PI);
    let ours = solved.column("factor")?.to_vec();
    for (k, exact) in exact.into_iter().enumerate() {
        let ours = ours.get(k).copied().unwrap_or(f64::NAN);
        found.compare(format!("critical load {}", k + 1), ours, exact, exact, 5e-3);
    }
    let points = |loads: &[f64]| loads.iter().enumerate().map(|(k, x)| [(k + 1) as f64, *x]).collect();
    let curves = vec![PlotCurve::points("computed", points(&ours)), PlotCurve::line("Bryan", points(&exact))];
    found.plot(Plot::new("Critical loads", ["mode", "N"], curves));
    Ok(found)
}

fn corner() -> Result<Findings, VerificationError> {
    let shell =
        ShellModel { surface: SQUARE, elements: [4; 2], thickness: 0.01, material: [2.1e8, 0.3, 500.0] };
    let model = format!(
        "{shell}{}{}{}{}[analysis]\nkind = \"statics\"\n",
        edge("u_start", "\"clamped\""),
        force([1.0, 0.0], [0.0, 0.0, -50.0]),
        probe("A", [1.0, 0.0]),
        probe("B", [1.0, 1.0])
    );
    let (solved, mut found) = (solve(&model)?, Findings::default());
    let loaded = [("A.x", 1.0 - 0.28816), ("A.y", 0.06252), ("A.z", -0.64891)];
    let other = [("B.x", 1.0 - 0.11405), ("B.y", 1.01480), ("B.z", -0.41242)];
    // The other corner moves by v = −0.01480 along the edge, away from the loaded corner at y = 0 in this model.
    for (name, exact) in loaded.into_iter().chain(other) {
        found.compare(name, solved.last(name)?, exact, 0.64891, 5e-3);
    }
    let curves = vec![
        PlotCurve::line("loaded corner", solved.points("load", "A.z")?),
        PlotCurve::points("reference", vec![[1.0, -0.64891]]),
    ];
    found.plot(Plot::new("Deflection", ["load factor", "z"], curves));
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
