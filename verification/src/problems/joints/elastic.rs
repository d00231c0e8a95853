//! Bushing, spring, rope, rod of given length, driven clamp.

use std::f64::consts::PI;

use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "bushing_twist",
        title: "Body that oscillates by 2.5 rad in a bushing: joint `bushing`",
        source: "J θ'' = −k θ for any angle: θ = 2.5 sin ωt",
        sketch: r"
      (~o~)   J = 0.2 kg m², k = 5 N m/rad, ω = 5 1/s",
        goal: "Angle over one period, by a point at the radius 0.3 m. Second order",
        run: bushing_twist,
    },
    Problem {
        name: "shaken_base",
        title: "Mass on a shaken base: joints `drive` and `bushing`",
        source: "u'' + ω² u = −A Ω² cos Ωt from rest: u = −A Ω²/(ω² − Ω²) (cos Ωt − cos ωt)",
        sketch: r"
      <-[ base ]-~~~-[ m ]   A = 0.1 m, Ω = 3 1/s, ω = 5 1/s
      A (1 − cos Ωt)",
        goal: "Displacement of the mass. Second order",
        run: shaken_base,
    },
    Problem {
        name: "elliptic_orbit",
        title: "Mass on a spring of zero length: joint `spring`",
        source: "Harmonic motion: x = x₀ cos ωt, y = (v₀/ω) sin ωt",
        sketch: r"
           . - .
        .    o   .     ellipse of the semi-axes 1 m and 0.4 m
           ' - '",
        goal: "Ellipse over one period. Second order",
        run: elliptic_orbit,
    },
    Problem {
        name: "rope_catch",
        title: "Falling mass caught by a rope: joint `spring` with tension only",
        source: "Free fall, then a harmonic motion: largest elongation (mg/k) (1 + √(1 + 2kh/mg))",
        sketch: r"
      o rope, slack by h = 0.5 m, k = 2000 N/m
      (
      [m]  2 kg, g |",
        goal: "Fall and first half of the motion on the rope, and largest elongation",
        run: rope_catch,
    },
    Problem {
        name: "shortened_rod",
        title: "Mass on a rod that becomes shorter: joint `distance` of given length",
        source: "Angular momentum: r² dθ/dt = const; θ = h [t/2(1 − at²) + atanh(√a t)/2√a] for r = 1 − a t²",
        sketch: r"
      o-----------O     r = 1 − 3t²/4, velocity 1 m/s across
                  |     without gravity",
        goal: "Spiral over one second and the force of the rod. Second order",
        run: shortened_rod,
    },
    Problem {
        name: "three_bars",
        title: "Three bars that share a load: statically indeterminate springs",
        source: "N = P/(1 + 2 cos³α) of the middle bar, P cos²α/(1 + 2 cos³α) of the outer ones",
        sketch: r"
     o   o   o     α = 60°, middle bar 1 m
      \  |  /      E A = 1e6 N in each bar
       \ | /
         v P",
        goal: "Forces and displacement of the linear truss, within 1e-5, the effect of the displacement",
        run: three_bars,
    },
    Problem {
        name: "von_mises_truss",
        title: "Snap-through of a truss of two springs: path through both limit points",
        source: "P = 2k (L₀ − l) y/l with the length l = √(b² + y²), limit points at l³ = L₀ b²",
        sketch: r"
            | P
            v
        _.-'o'-._      b = 1 m, height 0.3 m
      o           o    k = 1000 N/m",
        goal: "Load on each point of the path, within 1e-6 of its maximum; maximum and minimum within 1e-3, by the \
               largest of the points",
        run: von_mises_truss,
    },
];

fn bushing_twist() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "body", center = [0, 0, 0], mass = 1, inertia = [0.2, 0.2, 0.2], motion = { spin = [0, 0, 12.5] } }]
        joints = [{ kind = "bushing", name = "bush", a = { body = "body", at = "center" }, stiffness = [1e3, 1e3, 1e3, 20, 20, 5] }]
        probes = [{ name = "p", on = { body = "body", at = [0.3, 0, 0] } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let angle = |t: f64| 2.5 * (5.0 * t).sin();
    Refinement::steps(MODEL, 0.4 * PI, &[800, 1600])
        .curve("x of the point, m", ["t", "p.x"], |t| 0.3 * angle(t).cos(), 0.3, 1e-3)
        .order(2.0)
        .curve("y of the point, m", ["t", "p.y"], |t| 0.3 * angle(t).sin(), 0.3, 1e-3)
        .order(2.0)
        .curve("moment, N m", ["t", "bush.mz"], |t| -5.0 * angle(t), 12.5, 1e-3)
        .order(2.0)
        .run()
}

fn shaken_base() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [
          { kind = "rigid", name = "base", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1] },
          { kind = "rigid", name = "block", center = [0, 0, 0], mass = 4, inertia = [1, 1, 1] },
        ]
        joints = [
          { kind = "drive", name = "shaker", a = { body = "base", at = "center" }, displacement = [0.1, 0, 0], time = { kind = "expression", text = "1 - cos(3*t)" } },
          { kind = "bushing", name = "bush", a = { body = "block", at = "center" }, b = { body = "base", at = "center" }, stiffness = [100, 100, 100, 10, 10, 10] },
        ]
        probes = [{ name = "p", on = { body = "block", at = "center" } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let relative = |t: f64| -0.1 * 9.0 / 16.0 * ((3.0 * t).cos() - (5.0 * t).cos());
    let law = |t: f64| 0.1 * (1.0 - (3.0 * t).cos()) + relative(t);
    Refinement::steps(MODEL, 4.0, &[500, 1000])
        .curve("displacement, m", ["t", "p.x"], law, 0.1, 1e-3)
        .order(2.0)
        .curve("force of the bushing, N", ["t", "bush.fx"], |t| -100.0 * relative(t), 10.0, 1e-3)
        .order(2.0)
        .run()
}

fn elliptic_orbit() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "mass", name = "ball", center = [1, 0, 0], mass = 2, motion = { velocity = [0, 1.2, 0] } }]
        joints = [{ kind = "spring", name = "spring", a = { body = "ball", at = "center" }, b = { point = [0, 0, 0] }, stiffness = 18, length = 0 }]
        probes = [{ name = "p", on = { body = "ball", at = "center" } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    Refinement::steps(MODEL, 2.0 * PI / 3.0, &[200, 400])
        .curve("x, m", ["t", "p.x"], |t| (3.0 * t).cos(), 1.0, 5e-4)
        .order(2.0)
        .curve("y, m", ["t", "p.y"], |t| 0.4 * (3.0 * t).sin(), 1.0, 5e-4)
        .order(2.0)
        .run()
}

fn rope_catch() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [{ kind = "mass", name = "ball", center = [0, 0, -1], mass = 2 }]
        joints = [{ kind = "spring", name = "rope", a = { body = "ball", at = "center" }, b = { point = [0, 0, 0] }, stiffness = 2000, length = 1.5, tension_only = true }]
        probes = [{ name = "p", on = { body = "ball", at = "center" } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let (fall, omega, sag) = ((1.0f64 / 9.81).sqrt(), 1000f64.sqrt(), 2.0 * 9.81 / 2000.0);
    let law = move |t: f64| {
        if t < fall {
            return -1.0 - 0.5 * 9.81 * t * t;
        }
        let (sin, cos) = (omega * (t - fall)).sin_cos();
        -1.5 - sag * (1.0 - cos) - 9.81 * fall / omega * sin
    };
    let lowest = -1.5 - sag * (1.0 + (1.0 + 1.0 / sag).sqrt());
    let least = |s: &crate::SolvedModel| Ok(s.column("p.z")?.iter().copied().fold(0.0, f64::min));
    Refinement::steps(MODEL, fall + PI / omega, &[1000, 2000])
        .curve("height, m", ["t", "p.z"], law, 0.1, 1e-3)
        .value("lowest point, m", least, lowest, 1e-5)
        .run()
}

fn shortened_rod() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "mass", name = "ball", center = [1, 0, 0], mass = 2, motion = { velocity = [0, 1, 0] } }]
        joints = [{ kind = "distance", name = "rod", a = { body = "ball", at = "center" }, b = { point = [0, 0, 0] }, change = -0.75, time = { kind = "expression", text = "t^2" } }]
        probes = [{ name = "p", on = { body = "ball", at = "center" } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let (a, root) = (0.75f64, 0.75f64.sqrt());
    let radius = move |t: f64| 1.0 - a * t * t;
    let angle = move |t: f64| t / (2.0 * radius(t)) + (root * t).atanh() / (2.0 * root);
    Refinement::steps(MODEL, 1.0, &[400, 800])
        .curve("x, m", ["t", "p.x"], move |t| radius(t) * angle(t).cos(), 1.0, 3e-4)
        .order(2.0)
        .curve("y, m", ["t", "p.y"], move |t| radius(t) * angle(t).sin(), 1.0, 3e-4)
        .order(2.0)
        .run()
}

fn three_bars() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "mass", name = "knot", center = [0, 0, 0], mass = 1 }]
        joints = [
          { kind = "planar guide" },
          { kind = "spring", name = "middle", a = { body = "knot", at = "center" }, b = { point = [0, 1, 0] }, stiffness = 1e6 },
          { kind = "spring", name = "left", a = { body = "knot", at = "center" }, b = { point = [-1.7320508075688772, 1, 0] }, stiffness = 5e5 },
          { kind = "spring", name = "right", a = { body = "knot", at = "center" }, b = { point = [1.7320508075688772, 1, 0] }, stiffness = 5e5 },
        ]
        loads = [{ kind = "force", on = { body = "knot", at = "center" }, force = [0, -1, 0] }]
        probes = [{ name = "p", on = { body = "knot", at = "center" } }]
        analysis = { kind = "statics" }
    "#;
    let guide = r#"{ kind = "point_on_line", name = "guide", a = { body = "knot", at = "center" }, axis = [0, 1, 0] }"#;
    let share = 1.0 + 2.0 * 0.125;
    Refinement::single(MODEL.replace(r#"{ kind = "planar guide" }"#, guide))
        .last("displacement, m", "p.y", -1e-6 / share, 1e-5)
        .last("force of the middle bar, N", "middle.fy", 1.0 / share, 1e-5)
        .last("force of the left bar along y, N", "left.fy", 0.25 / share * 0.5, 1e-5)
        .run()
}

fn von_mises_truss() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "mass", name = "top", center = [0, 0.3, 0], mass = 1 }]
        joints = [
          { kind = "point_on_line", name = "guide", a = { body = "top", at = "center" }, axis = [0, 1, 0] },
          { kind = "spring", name = "left", a = { body = "top", at = "center" }, b = { point = [-1, 0, 0] }, stiffness = 1000 },
          { kind = "spring", name = "right", a = { body = "top", at = "center" }, b = { point = [1, 0, 0] }, stiffness = 1000 },
        ]
        loads = [{ kind = "force", on = { body = "top", at = "center" }, force = [0, -10, 0] }]
        probes = [{ name = "p", on = { body = "top", at = "center" } }]
        analysis = { kind = "path", load = 2, largest = 0.02, first = 0.01, points = 2000 }
    "#;
    let whole = 1.09f64.sqrt();
    let law = move |y: f64| {
        let length = (1.0 + y * y).sqrt();
        200.0 * (whole - length) * y / length
    };
    let peak = law((whole.powf(2.0 / 3.0) - 1.0).sqrt());
    let first = |s: &crate::SolvedModel, kind: f64| {
        let row = s.column("limit")?.iter().position(|&limit| limit == kind);
        row.and_then(|row| s.column("load").ok()?.get(row).copied())
            .ok_or_else(|| VerificationError::Missing("limit point".into()))
    };
    Refinement::single(MODEL.to_owned())
        .curve("load factor", ["p.y", "load"], law, peak, 1e-6)
        .value("maximum of the load factor", move |s| first(s, 1.0), peak, 1e-3)
        .value("minimum of the load factor", move |s| first(s, -1.0), -peak, 1e-3)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
