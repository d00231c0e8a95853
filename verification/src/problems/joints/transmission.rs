//! Couplings and mechanisms.

use std::f64::consts::PI;

use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "gear_pair",
        title: "Pair of gear wheels under a torque: coupling of two hinges",
        source: "(J₁ + i² J₂) dω₁/dt = M, ω₂ = −i ω₁",
        sketch: r"
      ( o )(o)     J₁ = 0.4, J₂ = 0.05 kg m², i = 3, M = 2 N m",
        goal: "Angles of the uniformly accelerated wheels. Second order",
        run: gear_pair,
    },
    Problem {
        name: "rack_pinion",
        title: "Rack that falls and turns its pinion: coupling of a hinge and a slider",
        source: "a = g/(1 + J/m r²)",
        sketch: r"
      (o)|     J = 0.03 kg m², r = 0.1 m, m = 2 kg
         | g |",
        goal: "Displacement of the rack and angular velocity of the pinion. Second order",
        run: rack_pinion,
    },
    Problem {
        name: "differential",
        title: "Three coupled hinges: differential gear",
        source: "θ₁ + θ₂ = 2 θ₃ with a torque M on the carrier: θ₃'' = M/(J₃ + 4 J₁J₂/(J₁ + J₂))",
        sketch: r"
      (1)--(3)--(2)    J = 0.2, 0.3, 0.1 kg m², M = 1 N m",
        goal: "Angles of carrier and wheels. Second order",
        run: differential,
    },
    Problem {
        name: "atwood",
        title: "Atwood's machine: coupling of two sliders",
        source: "a = g (m₁ − m₂)/(m₁ + m₂)",
        sketch: r"
       ( )
      |   |       m₁ = 3 kg, m₂ = 2 kg
     [1] [2]",
        goal: "Displacement of both masses, to the accuracy of the iteration",
        run: atwood,
    },
    Problem {
        name: "crank_slider",
        title: "Rigid slider crank: ball joints, hinge with drive, slider",
        source: "x = r cos φ + √(l² − r² sin²φ)",
        sketch: r"
         .o
       .'   '-.._         r = 0.3 m, l = 1 m, φ = t²
      o          'o==[ ]==",
        goal: "Displacement of the slider over more than a turn to the accuracy of the constraints, velocity with second order",
        run: crank_slider,
    },
];

fn gear_pair() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [
          { kind = "rigid", name = "wheel", center = [0, 0, 0], mass = 1, inertia = [0.2, 0.2, 0.4] },
          { kind = "rigid", name = "pinion", center = [1, 0, 0], mass = 1, inertia = [0.03, 0.03, 0.05] },
        ]
        joints = [
          { kind = "revolute", name = "first", a = { body = "wheel", at = "center" }, axis = [0, 0, 1] },
          { kind = "revolute", name = "second", a = { body = "pinion", at = "center" }, axis = [0, 0, 1] },
        ]
        couplings = [{ name = "teeth", joints = [{ joint = "first", factor = 3 }, { joint = "second", factor = 1 }] }]
        loads = [{ kind = "moment", on = { body = "wheel", at = "center" }, moment = [0, 0, 2] }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let acceleration = 2.0 / (0.4 + 9.0 * 0.05);
    Refinement::steps(MODEL, 2.0, &[600, 1200])
        .curve("angle of the wheel, rad", ["t", "first.angle"], |t| 0.5 * acceleration * t * t, 5.0, 1e-4)
        .order(2.0)
        .curve("angle of the pinion, rad", ["t", "second.angle"], |t| -1.5 * acceleration * t * t, 15.0, 1e-4)
        .order(2.0)
        .run()
}

fn rack_pinion() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [
          { kind = "rigid", name = "pinion", center = [0, 0, 0], mass = 1, inertia = [0.03, 0.03, 0.03] },
          { kind = "rigid", name = "rack", center = [0.1, 0, 0], mass = 2, inertia = [1, 1, 1] },
        ]
        joints = [
          { kind = "revolute", name = "axle", a = { body = "pinion", at = "center" }, axis = [0, 1, 0] },
          { kind = "prismatic", name = "guide", a = { body = "rack", at = "center" }, axis = [0, 0, 1] },
        ]
        couplings = [{ name = "teeth", joints = [{ joint = "axle", factor = 1 }, { joint = "guide", factor = 10 }] }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let acceleration = 9.81 / (1.0 + 0.03 / 0.02);
    Refinement::steps(MODEL, 0.6, &[200, 400])
        .curve("displacement, m", ["t", "guide.displacement"], |t| -0.5 * acceleration * t * t, 1.0, 1e-3)
        .order(2.0)
        .curve("angular velocity, 1/s", ["t", "axle.rate"], |t| 10.0 * acceleration * t, 24.0, 1e-3)
        .order(2.0)
        .run()
}

fn differential() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [
          { kind = "rigid", name = "left", center = [-1, 0, 0], mass = 1, inertia = [0.2, 0.2, 0.2] },
          { kind = "rigid", name = "right", center = [1, 0, 0], mass = 1, inertia = [0.3, 0.3, 0.3] },
          { kind = "rigid", name = "carrier", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1] },
        ]
        joints = [
          { kind = "revolute", name = "first", a = { body = "left", at = "center" }, axis = [1, 0, 0] },
          { kind = "revolute", name = "second", a = { body = "right", at = "center" }, axis = [1, 0, 0] },
          { kind = "revolute", name = "third", a = { body = "carrier", at = "center" }, axis = [1, 0, 0] },
        ]
        couplings = [{ name = "gear", joints = [{ joint = "first", factor = 1 }, { joint = "second", factor = 1 }, { joint = "third", factor = -2 }] }]
        loads = [{ kind = "moment", on = { body = "carrier", at = "center" }, moment = [1, 0, 0] }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let carrier = 1.0 / (0.1 + 4.0 * 0.2 * 0.3 / 0.5);
    let left = carrier * 2.0 * 0.3 / 0.5;
    Refinement::steps(MODEL, 1.5, &[300, 600])
        .curve("angle of the carrier, rad", ["t", "third.angle"], |t| 0.5 * carrier * t * t, 2.0, 1e-4)
        .order(2.0)
        .curve("angle of the left wheel, rad", ["t", "first.angle"], |t| 0.5 * left * t * t, 2.0, 1e-4)
        .order(2.0)
        .run()
}

fn atwood() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [
          { kind = "rigid", name = "heavy", center = [0, 0, 0], mass = 3, inertia = [1, 1, 1] },
          { kind = "rigid", name = "light", center = [1, 0, 0], mass = 2, inertia = [1, 1, 1] },
        ]
        joints = [
          { kind = "prismatic", name = "first", a = { body = "heavy", at = "center" }, axis = [0, 0, 1] },
          { kind = "prismatic", name = "second", a = { body = "light", at = "center" }, axis = [0, 0, 1] },
        ]
        couplings = [{ name = "rope", joints = [{ joint = "first", factor = 1 }, { joint = "second", factor = 1 }] }]
        analysis = { kind = "dynamics", duration = 1, step = 0.01 }
    "#;
    Refinement::single(MODEL.to_owned())
        .curve(
            "displacement of the heavy mass, m",
            ["t", "first.displacement"],
            |t| -0.981 * t * t,
            1.0,
            1e-8,
        )
        .curve(
            "displacement of the light mass, m",
            ["t", "second.displacement"],
            |t| 0.981 * t * t,
            1.0,
            1e-8,
        )
        .run()
}

fn crank_slider() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [
          { kind = "rigid", name = "crank", center = [0.15, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] },
          { kind = "rigid", name = "rod", center = [0.8, 0, 0], mass = 1, inertia = [0.08, 0.08, 0.08] },
          { kind = "rigid", name = "slider", center = [1.3, 0, 0], mass = 1, inertia = [0.01, 0.01, 0.01] },
        ]
        joints = [
          { kind = "revolute", name = "drive", a = { body = "crank", at = [0, 0, 0] }, axis = [0, 0, 1], drive = { angle = 1, time = { kind = "expression", text = "t^2" } } },
          { kind = "spherical", name = "pin", a = { body = "rod", at = [0.3, 0, 0] }, b = { body = "crank", at = [0.3, 0, 0] } },
          { kind = "spherical", name = "wrist", a = { body = "rod", at = [1.3, 0, 0] }, b = { body = "slider", at = "center" } },
          { kind = "prismatic", name = "guide", a = { body = "slider", at = "center" }, axis = [1, 0, 0] },
        ]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let root = |phi: f64| (1.0 - 0.09 * phi.sin().powi(2)).sqrt();
    let place = move |t: f64| 0.3 * (t * t).cos() + root(t * t) - 1.3;
    let rate = move |t: f64| {
        let (sin, cos) = (t * t).sin_cos();
        -2.0 * t * 0.3 * (sin + 0.3 * sin * cos / root(t * t))
    };
    Refinement::steps(MODEL, (2.4 * PI).sqrt(), &[400, 800])
        .curve("displacement, m", ["t", "guide.displacement"], place, 0.6, 1e-7)
        .curve("velocity, m/s", ["t", "guide.speed"], rate, 1.6, 1e-3)
        .order(2.0)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
