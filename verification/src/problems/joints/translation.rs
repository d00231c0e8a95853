//! Joints that allow displacements: prismatic, cylindrical, planar, point on line, slide.

use std::f64::consts::PI;

use crate::reference::runge_kutta;
use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "damped_slider",
        title: "Slider with spring and damper: joint `prismatic`",
        source: "Step response of the damped oscillator; logarithmic decrement 2πζ/√(1 − ζ²)",
        sketch: r"
     |/|--/\/\/--[ m ]--   m = 2 kg, k = 800 N/m, c = 8 N s/m
     |/|----]----          ω = 20 1/s, ζ = 0.1",
        goal: "Displacement after a sudden change of the rest position. Second order",
        run: damped_slider,
    },
    Problem {
        name: "friction_slider",
        title: "Slider with dry friction: friction of a `prismatic` joint",
        source: "m dv/dt = −F tanh(v/s), sinh(v/s) = sinh(v₀/s) exp(−F t/m s)",
        sketch: r"
     ====[ m ]====   m = 2 kg, F = 3 N, s = 0.2 m/s, v₀ = 1 m/s",
        goal: "Velocity from sliding to creep. Second order",
        run: friction_slider,
    },
    Problem {
        name: "screw",
        title: "Nut on a screw under its weight: joint `cylindrical` with a coupling",
        source: "m a = m g − J a (2π/p)²",
        sketch: r"
        ||       p = 0.05 m, m = 2 kg, J = 1e-3 kg m²
       [||] nut
        ||   g |",
        goal: "Displacement and angle of the uniformly accelerated nut. Second order",
        run: screw,
    },
    Problem {
        name: "inclined_plane",
        title: "Disc on an inclined plane: joint `planar`",
        source: "Uniform acceleration g sin α in the plane, normal force m g cos α",
        sketch: r"
       \  o-> v = 1 m/s across the slope    α = 0.4 rad, m = 3 kg
        \      spin 5 1/s about the normal
     ----+----",
        goal: "Parabola of the centre, constant spin and normal force, to the accuracy of the iteration",
        run: inclined_plane,
    },
    Problem {
        name: "rotating_line",
        title: "Bead on a rotating line: joint `point_on_line`, driven hinge",
        source: "r = r₀ cosh Ωt; torque m Ω² r₀² sinh 2Ωt by Coriolis' acceleration",
        sketch: r"
      o-----O-----   Ω = 2 1/s, r₀ = 0.5 m, m = 1.5 kg
     drive  bead     without gravity",
        goal: "Displacement along the line and torque of the drive. Second order",
        run: rotating_line,
    },
    Problem {
        name: "ladder",
        title: "Ladder sliding down a wall: two joints `point_on_line`",
        source: "θ'' = (3g/2L) sin θ, by a Runge-Kutta integration",
        sketch: r"
      |\        L = 2 m, θ = 0.3 rad from the vertical at the start
      | \  g |
      +--\--",
        goal: "Both ends along their lines. Second order",
        run: ladder,
    },
    Problem {
        name: "influence_line",
        title: "Load that slides along a simply supported beam: joint `slide` with drive",
        source: "Linear beam: deflection under the load P a² b²/3EIL + P a b/GAL",
        sketch: r"
         P v
      o====O==========o     L = 2 m; the load moves from 0.1 m to 0.9 m,
       a -> |    b    |     into the sixth of eight elements",
        goal: "Deflection under the load, inside of an element, force of the support and position of the load",
        run: influence_line,
    },
];

fn damped_slider() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "block", center = [0, 0, 0], mass = 2, inertia = [1, 1, 1] }]
        joints = [{ kind = "prismatic", name = "guide", a = { body = "block", at = "center" }, axis = [1, 2, 2], spring = { stiffness = 800, damping = 8, displacement = 0.1 } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let (rate, omega) = (2.0f64, (400.0f64 - 4.0).sqrt());
    let law =
        move |t: f64| 0.1 - 0.1 * (-rate * t).exp() * ((omega * t).cos() + rate / omega * (omega * t).sin());
    // Overshoots half a period apart: the decrement of half a period.
    let overshoot = |s: &crate::SolvedModel| -> Result<f64, VerificationError> {
        let all = s.column("guide.displacement")?;
        let extreme =
            |from: usize, to: usize| all[from..to].iter().fold(0.0, |m: f64, x| m.max((x - 0.1).abs()));
        let n = all.len() - 1;
        Ok(2.0 * (extreme(n / 4, n / 2) / extreme(3 * n / 4, n)).ln())
    };
    Refinement::steps(MODEL, 2.0 * PI / omega, &[400, 800])
        .curve("displacement, m", ["t", "guide.displacement"], law, 0.1, 3e-4)
        .order(2.0)
        .value("logarithmic decrement", overshoot, 2.0 * PI * rate / omega, 2e-3)
        .run()
}

fn friction_slider() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "block", center = [0, 0, 0], mass = 2, inertia = [1, 1, 1], motion = { velocity = [1, 0, 0] } }]
        joints = [{ kind = "prismatic", name = "guide", a = { body = "block", at = "center" }, axis = [1, 0, 0], friction = { force = 3, speed = 0.2 } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let law = |t: f64| 0.2 * ((1.0f64 / 0.2).sinh() * (-3.0 * t / (2.0 * 0.2)).exp()).asinh();
    Refinement::steps(MODEL, 1.5, &[200, 400])
        .curve("velocity, m/s", ["t", "guide.speed"], law, 1.0, 1e-4)
        .order(2.0)
        .run()
}

fn screw() -> Result<Findings, VerificationError> {
    let lead = 2.0 * PI / 0.05;
    let model = format!(
        r#"
        gravity = [0, 0, -9.81]
        bodies = [{{ kind = "rigid", name = "nut", center = [0, 0, 0], mass = 2, inertia = [1e-3, 1e-3, 1e-3] }}]
        joints = [{{ kind = "cylindrical", name = "thread", a = {{ body = "nut", at = "center" }}, axis = [0, 0, 1] }}]
        couplings = [{{ name = "lead", joints = [{{ joint = "thread", factor = 1, of = "angle" }}, {{ joint = "thread", factor = {:?}, of = "displacement" }}] }}]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#,
        -lead
    );
    let acceleration = -9.81 / (1.0 + 1e-3 * lead * lead / 2.0);
    Refinement::steps(&model, 0.5, &[500, 1000])
        .curve("displacement, m", ["t", "thread.displacement"], |t| 0.5 * acceleration * t * t, 0.1, 1e-3)
        .order(2.0)
        .curve("angle, rad", ["t", "thread.angle"], |t| 0.5 * lead * acceleration * t * t, 10.0, 1e-3)
        .order(2.0)
        .run()
}

fn inclined_plane() -> Result<Findings, VerificationError> {
    let (sin, cos) = 0.4f64.sin_cos();
    let model = format!(
        r#"
        gravity = [0, 0, -9.81]
        bodies = [{{ kind = "rigid", name = "disc", center = [0, 0, 0], mass = 3, inertia = [0.2, 0.2, 0.2], motion = {{ velocity = [0, 1, 0], spin = [{:?}, 0, {:?}] }} }}]
        joints = [{{ kind = "planar", name = "plane", a = {{ body = "disc", at = "center" }}, normal = [{sin:?}, 0, {cos:?}] }}]
        probes = [{{ name = "p", on = {{ body = "disc", at = "center" }}, record = ["motion", "rotation"] }}]
        analysis = {{ kind = "dynamics", duration = 1, step = 5e-3 }}
        "#,
        5.0 * sin,
        5.0 * cos
    );
    Refinement::single(model)
        .curve("x, m", ["t", "p.x"], |t| 0.5 * 9.81 * sin * cos * t * t, 1.0, 1e-8)
        .curve("y, m", ["t", "p.y"], |t| t, 1.0, 1e-8)
        .curve("z, m", ["t", "p.z"], |t| -0.5 * 9.81 * sin * sin * t * t, 1.0, 1e-8)
        .curve("normal force along z, N", ["t", "plane.fz"], |_| 3.0 * 9.81 * cos * cos, 30.0, 1e-6)
        .curve("angular velocity about z, 1/s", ["t", "p.wz"], |_| 5.0 * cos, 5.0, 1e-3)
        .run()
}

fn rotating_line() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [
          { kind = "rigid", name = "hub", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1], motion = { spin = [0, 0, 2] } },
          { kind = "mass", name = "bead", center = [0.5, 0, 0], mass = 1.5, motion = { velocity = [0, 1, 0] } },
        ]
        joints = [
          { kind = "revolute", name = "drive", a = { body = "hub", at = "center" }, axis = [0, 0, 1], drive = { rate = 2 } },
          { kind = "point_on_line", name = "line", a = { body = "bead", at = "center" }, b = { body = "hub", at = [0.5, 0, 0] }, axis = [1, 0, 0] },
        ]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let torque = |t: f64| 1.5 * 4.0 * 0.25 * (4.0 * t).sinh();
    Refinement::steps(MODEL, 1.0, &[200, 400])
        .curve("displacement, m", ["t", "line.displacement"], |t| 0.5 * ((2.0 * t).cosh() - 1.0), 1.0, 1e-4)
        .order(2.0)
        .curve("torque of the drive, N m", ["t", "drive.mz"], torque, torque(1.0), 1e-3)
        .order(2.0)
        .run()
}

fn ladder() -> Result<Findings, VerificationError> {
    let (sin, cos) = 0.3f64.sin_cos();
    let model = format!(
        r#"
        gravity = [0, -9.81, 0]
        bodies = [{{ kind = "rigid", name = "ladder", center = [{sin:?}, {cos:?}, 0], mass = 4, inertia = [1.3333333333333333, 1.3333333333333333, 1.3333333333333333] }}]
        joints = [
          {{ kind = "point_on_line", name = "wall", a = {{ body = "ladder", at = [0, {:?}, 0] }}, axis = [0, 1, 0] }},
          {{ kind = "point_on_line", name = "floor", a = {{ body = "ladder", at = [{:?}, 0, 0] }}, axis = [1, 0, 0] }},
        ]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#,
        2.0 * cos,
        2.0 * sin
    );
    let rates = |_: f64, y: &[f64; 2]| [y[1], 0.75 * 9.81 * y[0].sin()];
    let [theta, rate] = runge_kutta(rates, [0.3, 0.0], 0.7, 2000);
    Refinement::steps(&model, 0.7, &[200, 400])
        .last("displacement on the floor, m", "floor.displacement", 2.0 * (theta.sin() - sin), 1e-4)
        .order(2.0)
        .last("displacement on the wall, m", "wall.displacement", 2.0 * (theta.cos() - cos), 1e-4)
        .order(2.0)
        .last("velocity on the floor, m/s", "floor.speed", 2.0 * theta.cos() * rate, 1e-4)
        .order(2.0)
        .run()
}

fn influence_line() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e9 }
        sections.s = { kind = "general", area = 4e-4, iy = 1.3e-8, iz = 1.3e-8 }
        bodies = [
          { kind = "beam", name = "beam", from = [0, 0, 0], to = [2, 0, 0], elements = ELEMENTS, section = "s", material = "m" },
          { kind = "mass", name = "load", center = [0.1, 0, 0], mass = 1 },
        ]
        joints = [
          { kind = "revolute", name = "left", a = { body = "beam", at = "start" }, axis = [0, 0, 1] },
          { kind = "point_on_line", name = "right", a = { body = "beam", at = "end" }, axis = [1, 0, 0] },
          { kind = "slide", name = "slide", a = { body = "load", at = "center" }, b = { body = "beam", at = 0.1 }, drive = { displacement = 0.8 } },
        ]
        loads = [{ kind = "force", on = { body = "load", at = "center" }, force = [0, -1e-3, 0] }]
        probes = [{ name = "p", on = { body = "load", at = "center" } }]
        analysis = { kind = "statics" }
    "#;
    let (a, b, load) = (0.9f64, 1.1f64, 1e-3);
    let deflection = load * (a * a * b * b / (3.0 * 1e9 * 1.3e-8 * 2.0) + a * b / (0.5e9 * 4e-4 * 2.0));
    Refinement::elements(MODEL, &[4, 8, 16, 32])
        .last("deflection under the load, m", "p.y", -deflection, 1e-3)
        .last("force of the right support, N", "right.fy", load * a / 2.0, 1e-3)
        .last("position, m", "slide.position", 0.9, 1e-9)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
