//! Spheres and tori that enclose a gas.

use std::f64::consts::{PI, TAU};

use super::sphere::{eighth, planes};
use crate::problems::models::Convergence;
use crate::problems::shear_shells::mesh::isotropic;
use crate::{Findings, Plot, PlotCurve, Problem, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "gas_in_a_sphere",
        title: "Sphere that breathes with the gas in it: load `gas`",
        source: "ρ h ẅ + (2 E h/((1 - ν) R²) + 3 κ p/R) w = Δp: membrane theory of the sphere and p V^κ = const, linearised",
        sketch: r"
     .--.      p          R = 1, h = 0.01, E = 1e7, ν = 0.3, ρ = 1000
    ( <> )     outside    p = 30001, outside 30000, κ = 1.4
     '--'                 an eighth with planes of symmetry",
        goal: "Radius over one period within 0.5 % of the amplitude with 300 elements and 200 steps of the energy-momentum scheme; second order in the size \
               of the elements. p V^κ within 1e-12",
        run: breathing,
    },
    Problem {
        name: "inner_tube",
        title: "Inner tube under the pressure of a gas",
        source: "Membrane theory of the torus: n = p r (2 R + r cos θ)/(2 (R + r cos θ)) along the meridian at the outer and at the inner \
                 equator, by the equilibrium of the parts between the equators and the crowns. V = 2 π² R r² undeformed",
        sketch: r"
      _.-----._           R = 0.3 m, r = 0.1 m, h = 1 mm, E = 1e8, ν = 0.4
    ( (_)   (_) )  r      p = 1.01 bar, outside 1 bar, constant temperature
      '-.___.-'           one swept shell, seams along and around
          R",
        goal: "Volume before the load within 1e-3. Forces along the meridian within 1 % with 32 × 32 elements",
        run: tube,
    },
];

/// Largest deviation of the radius relative to the amplitude, that of p V^κ, and the motion.
fn breathe(n: usize) -> Result<(f64, f64, Vec<[f64; 2]>), VerificationError> {
    let omega = ((2e5 / 0.7 + 3.0 * 1.4 * 30000.0) / 10.0_f64).sqrt();
    let (period, amplitude) = (TAU / omega, 1.0 / (10.0 * omega * omega));
    let solved = solve(&format!(
        "{}{}\
         [[loads]]\nkind = \"gas\"\nname = \"air\"\nsurfaces = [{{ body = \"s\" }}]\napex = [0, 0, 0]\npressure = 30001\n\
         ambient = 30000\nexponent = 1.4\n[[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [1, 0, 0] }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = {period:?}\nstep = {:?}\nscheme = \"energy\"\n",
        eighth(n, 0.01, isotropic([1e7, 0.3, 1000.0])),
        planes(&["e0", "e1", "e2"]),
        period / 200.0
    ))?;
    let mut largest = 0.0_f64;
    let mut motion = Vec::new();
    for (t, x) in solved.column("t")?.iter().zip(solved.column("p.x")?) {
        let exact = amplitude * (1.0 - (omega * t).cos());
        largest = largest.max((x - 1.0 - exact).abs() / amplitude);
        motion.push([t / period, (x - 1.0) / amplitude]);
    }
    let states = solved.column("air.pressure")?.iter().zip(solved.column("air.volume")?);
    let states: Vec<f64> = states.map(|(p, v)| p * v.powf(1.4)).collect();
    let change = states.iter().map(|state| (state / states[0] - 1.0).abs()).fold(0.0, f64::max);
    Ok((largest, change, motion))
}

fn breathing() -> Result<Findings, VerificationError> {
    let mut found = Findings::default();
    let [(coarse, ..), (fine, change, motion)] = [breathe(5)?, breathe(10)?];
    found.compare("largest deviation of the radius, relative to the amplitude", fine, 0.0, 1.0, 5e-3);
    found.compare("its order in the size of the elements", (coarse / fine).log2(), 2.0, 1.0, 0.5);
    found.compare("change of p V^κ", change, 0.0, 1.0, 1e-12);
    let exact = (0..=40).map(|k| f64::from(k) / 40.0).map(|t| [t, 1.0 - (TAU * t).cos()]).collect();
    let curves = vec![PlotCurve::line("300 elements", motion), PlotCurve::points("membrane theory", exact)];
    found.plot(Plot::new("Breathing of the sphere", ["t/T", "radius, change/amplitude"], curves));
    Ok(found)
}

/// Major and minor radius.
const RADII: [f64; 2] = [0.3, 0.1];

fn circle(count: u32, at: impl Fn(f64) -> [f64; 3]) -> Vec<[f64; 3]> {
    let mut points: Vec<_> = (0..count).map(|k| at(TAU * f64::from(k) / f64::from(count))).collect();
    points.push(points[0]);
    points
}

/// Volume before the load, and the forces along the meridian at the outer and the inner equator, each relative to the reference.
fn tube_of(n: u32) -> Result<[f64; 3], VerificationError> {
    let [major, minor] = RADII;
    let profile = circle(16, |angle| [major + minor * angle.cos(), 0.0, minor * angle.sin()]);
    let path = circle(16, |angle| [(major + minor) * angle.cos(), (major + minor) * angle.sin(), 0.0]);
    let mut text = format!(
        "analysis = {{ kind = \"statics\" }}\nmaterials.m = {{ young = 1e8, poisson = 0.4, density = 1100 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"tube\"\nelements = [{n}, {n}]\nthickness = 1e-3\nmaterial = \"m\"\n\
         surface = {{ kind = \"swept\", profile = {profile:?}, path = {path:?} }}\n\
         [[joints]]\nkind = \"clamp\"\nname = \"c\"\na = {{ body = \"tube\", at = [0.5, 0.5] }}\n\
         [[loads]]\nkind = \"gas\"\nname = \"air\"\nsurfaces = [{{ body = \"tube\", reversed = true }}]\npressure = 1.01e5\nambient = 1e5\n"
    );
    for edge in ["u", "v"] {
        text += &format!(
            "[[joints]]\nkind = \"seam\"\nname = \"{edge}\"\na = {{ body = \"tube\", at = {{ edge = \"{edge}_start\" }} }}\n\
             b = {{ body = \"tube\", at = {{ edge = \"{edge}_end\" }} }}\n"
        );
    }
    for (name, u) in [("outer", 0.0), ("inner", 0.5)] {
        text += &format!(
            "[[probes]]\nname = \"{name}\"\non = {{ body = \"tube\", at = [{u:?}, 0.25] }}\nrecord = [\"resultants\"]\n"
        );
    }
    let solved = solve(&text)?;
    let [pressure, volume] = [solved.last("air.pressure")?, solved.last("air.volume")?];
    let force = |cosine: f64| {
        (pressure - 1e5) * minor * (2.0 * major + minor * cosine) / (2.0 * (major + minor * cosine))
    };
    let undeformed = pressure * volume / 1.01e5;
    let forces = [solved.last("outer.nuu")? / force(1.0), solved.last("inner.nuu")? / force(-1.0)];
    Ok([undeformed / (2.0 * PI * PI * major * minor * minor), forces[0], forces[1]])
}

fn tube() -> Result<Findings, VerificationError> {
    let meshes = [8, 16, 32];
    let results: Vec<[f64; 3]> = meshes.into_iter().map(tube_of).collect::<Result<_, _>>()?;
    let mut convergence = Convergence::default();
    for (k, (name, tolerance)) in [
        ("p V/p₀, relative to 2 π² R r²", 1e-3),
        ("force along the meridian at the outer equator, relative", 1e-2),
        ("force along the meridian at the inner equator, relative", 1e-2),
    ]
    .into_iter()
    .enumerate()
    {
        convergence.case(name, &meshes, (1.0, tolerance), |n| {
            Ok(meshes
                .iter()
                .zip(&results)
                .find(|(own, _)| **own == n)
                .map_or(f64::NAN, |(_, found)| found[k]))
        })?;
    }
    Ok(convergence.finish("elements around the section"))
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
