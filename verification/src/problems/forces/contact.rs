//! Contact of balls with planes.

use std::f64::consts::PI;

use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "ball_at_rest",
        title: "Ball that settles on a plane",
        source: "Static force per length k (g − δ/2) of the penetration g: g = m g/2rk + δ/2",
        sketch: r"
       ( o )     r = 0.1 m, m = 2 kg, k = 1e6 N/m², δ = 2e-5 m
      -------    falls from 0.1 mm, damped contact",
        goal: "Penetration at rest, within 1e-4",
        run: ball_at_rest,
    },
    Problem {
        name: "bouncing_ball",
        title: "Ball that bounces without loss",
        source: "Free flight 2√(2h/g) and contact (π + 2 arctan(g/ωv))/ω of a mass on a spring of the stiffness 2rk",
        sketch: r"
        ( o )    r = 0.1 m, m = 1 kg, h = 0.05 m
          |      k = 5e5 N/m², small transition
      -------",
        goal: "Height after the first bounce, at the second apex, within 1e-3 of h",
        run: bouncing_ball,
    },
    Problem {
        name: "sliding_block",
        title: "Block that slides down an incline",
        source: "Coulomb: a = g (sin α − μ cos α)",
        sketch: r"
       \[]       α = 0.5 rad, μ = 0.2
        \        friction does not rotate the ball that stands for the block
      ---+",
        goal: "Distance and speed after a second, within 1e-3, which is the first step, where friction is not yet developed",
        run: || incline(0.2, 1e-4),
    },
    Problem {
        name: "sticking_block",
        title: "Block that sticks to an incline and creeps",
        source: "Regularised friction: creep speed v = s T/√(μ²N² − T²), s the slip speed",
        sketch: r"
       \[]       α = 0.5 rad, μ = 0.8, s = 1e-3 m/s
        \
      ---+",
        goal: "Creep speed, within 1e-3",
        run: || incline(0.8, 1e-3),
    },
    Problem {
        name: "capstan",
        title: "Rope on a rotating drum",
        source: "Eytelwein (1808): ratio of the tensions exp(μπ) for half a turn",
        sketch: r"
         .---.
        (  o  )  <- drum turns against the load     R = 0.1 m, μ = 0.3
      |         |
     hook       v 1 N",
        goal: "Tension at the hook and torque of the drum within 3e-2 with 40 elements, whose contact points are discrete",
        run: capstan,
    },
];

fn ball_at_rest() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [{ kind = "mass", name = "ball", center = [0, 0, 0.1001], mass = 2, surface = { radius = 0.1 } }]
        contacts = [{ with = { kind = "plane", point = [0, 0, 0], normal = [0, 0, 1] }, stiffness = 1e6, damping = 50, transition = 2e-5 }]
        probes = [{ name = "p", on = { body = "ball", at = "center" } }]
        analysis = { kind = "dynamics", duration = 1, step = 2e-4 }
    "#;
    let depth = 2.0 * 9.81 / (0.2 * 1e6) + 1e-5;
    Refinement::single(MODEL.to_owned())
        .value("penetration, m", |s| Ok(0.1 - s.last("p.z")?), depth, 1e-4)
        .run()
}

fn bouncing_ball() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        gravity = [0, 0, -9.81]
        bodies = [{ kind = "mass", name = "ball", center = [0, 0, 0.15], mass = 1, surface = { radius = 0.1 } }]
        contacts = [{ with = { kind = "plane", point = [0, 0, 0], normal = [0, 0, 1] }, stiffness = 5e5, transition = 1e-6 }]
        probes = [{ name = "p", on = { body = "ball", at = "center" } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP, scheme = { spectral_radius = 0.95 } }
    "#;
    let omega = (0.2 * 5e5f64).sqrt();
    let speed = (2.0 * 9.81 * 0.05f64).sqrt();
    let contact = (PI + 2.0 * (9.81 / (omega * speed)).atan()) / omega;
    let fall = speed / 9.81;
    let (omega_fall, sag) = (omega, 9.81 / (omega * omega));
    let law = move |t: f64| {
        if t < fall {
            return 0.15 - 0.5 * 9.81 * t * t;
        }
        let inside = t - fall;
        if inside < contact {
            let (sin, cos) = (omega_fall * inside).sin_cos();
            return 0.1 - sag * (1.0 - cos) - speed / omega_fall * sin;
        }
        let flight = inside - contact;
        0.1 + speed * flight - 0.5 * 9.81 * flight * flight
    };
    Refinement::steps(MODEL, 2.0 * fall + contact, &[4000, 8000])
        .curve("height, m", ["t", "p.z"], law, 0.05, 1e-3)
        .last("second apex, m", "p.z", 0.15, 1e-3)
        .run()
}

fn incline(friction: f64, slip: f64) -> Result<Findings, VerificationError> {
    let (sin, cos) = 0.5f64.sin_cos();
    let (mass, radius, stiffness) = (2.0, 0.1, 1e6);
    // Starts at the depth of the equilibrium normal to the plane.
    let depth = mass * 9.81 * cos / (2.0 * radius * stiffness) + 0.5e-5;
    let model = format!(
        r#"
        gravity = [{:?}, 0, {:?}]
        bodies = [{{ kind = "mass", name = "ball", center = [0, 0, {:?}], mass = 2, surface = {{ radius = 0.1 }} }}]
        contacts = [{{ with = {{ kind = "plane", point = [0, 0, 0], normal = [0, 0, 1] }}, stiffness = {stiffness:?}, damping = 20, transition = 1e-5, friction = {friction:?}, slip_speed = {slip:?} }}]
        probes = [{{ name = "p", on = {{ body = "ball", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = 1, step = 1e-3 }}
        "#,
        9.81 * sin,
        -9.81 * cos,
        radius - depth
    );
    let study = Refinement::single(model);
    if sin < friction * cos {
        let speed = slip * sin / ((friction * cos).powi(2) - sin * sin).sqrt();
        return study.last("creep speed, m/s", "p.vx", speed, 1e-3).run();
    }
    let acceleration = 9.81 * (sin - friction * cos);
    study
        .last("distance, m", "p.x", 0.5 * acceleration, 1e-3)
        .last("speed, m/s", "p.vx", acceleration, 1e-3)
        .value("depth, m", |s: &SolvedModel| Ok(radius - s.last("p.z")?), depth, 1e-3)
        .run()
}

fn capstan() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.soft = { density = 1000, young = 1e8, damping = { strain = 1e-4, mass = 20 } }
        sections.thin = { kind = "circle", diameter = 2e-3 }
        bodies = [
          { kind = "beam", name = "rope", from = [-0.1, 0, 0], to = [0.1, 0, 0], shape = { kind = "arc", through = [0, 0.1, 0] }, up = [0, 0, 1], elements = ELEMENTS, section = "thin", material = "soft" },
          { kind = "rigid", name = "drum", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1] },
        ]
        joints = [
          { kind = "spherical", name = "hook", a = { body = "rope", at = "start" } },
          { kind = "revolute", name = "drive", a = { body = "drum", at = "center" }, axis = [0, 0, 1], drive = { rate = -2, time = { kind = "ramp", end = 0.01 } } },
        ]
        contacts = [{ with = { kind = "cylinder", point = [0, 0, 0], axis = [0, 0, 1], radius = 0.099, on = { body = "drum", at = "center" } }, bodies = ["rope"], stiffness = 1e6, friction = 0.3, slip_speed = 1e-3 }]
        loads = [{ kind = "force", on = { body = "rope", at = "end" }, force = [0, -1, 0] }]
        analysis = { kind = "dynamics", duration = 0.2, step = 5e-4 }
    "#;
    let tension = (0.3 * PI).exp();
    Refinement::elements(MODEL, &[20, 40])
        .last("tension at the hook, N", "hook.fy", -tension, 3e-2)
        .last("torque of the drum, N m", "drive.mz", -0.1 * (tension - 1.0), 3e-2)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
