//! Joints that allow rotations: revolute, spherical, universal, clamp.

use std::f64::consts::{FRAC_PI_3, PI};

use crate::reference::elliptic_k;
use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "physical_pendulum",
        title: "Physical pendulum of large amplitude: joint `revolute`",
        source: "Period 4 K(sin α/2) √((J + m l²)/m g l), K by the arithmetic-geometric mean",
        sketch: r"
      o hinge          l = 0.5 m, m = 1 kg, J = 0.1 kg m²
       \  g |          released at 2.5 rad from the lowest position
        O",
        goal: "After 5/4 of the period: angle −2.5 rad and the angular velocity of the lowest position. Second order",
        run: physical_pendulum,
    },
    Problem {
        name: "conical_pendulum",
        title: "Conical pendulum: joint `spherical`",
        source: "Steady precession Ω² = g/(l cos θ) of a body with equal moments of inertia",
        sketch: r"
      o ball joint     l = 1 m, θ = 60°, Ω² = 2 g/l
       \  g |
        O   one turn about the vertical",
        goal: "Circle of the centre at constant height. Second order",
        run: conical_pendulum,
    },
    Problem {
        name: "cardan_shaft",
        title: "Shafts at an angle: joints `universal` and `point_on_line`, driven hinge",
        source: "tan φ₂ = cos β tan φ₁, ω₂ = ω₁ cos β/(1 − sin²β sin²φ₁)",
        sketch: r"
                 / second shaft     β = 30°, φ₁ = t²
     =====+=====X                   arms of the cross: normal to the
      drive      cross              plane of the shafts, and in it",
        goal: "Angle of the second shaft to the accuracy of the constraints, its angular velocity with second order",
        run: cardan_shaft,
    },
    Problem {
        name: "hinge_brake",
        title: "Wheel with a brake: friction of a `revolute` joint",
        source: "J dω/dt = −M tanh(ω/s), sinh(ω/s) = sinh(ω₀/s) exp(−M t/J s)",
        sketch: r"
      ( o )   J = 0.4 kg m², M = 0.3 N m, s = 0.5 1/s, ω₀ = 2 1/s",
        goal: "Angular velocity from sliding to creep. Second order",
        run: hinge_brake,
    },
    Problem {
        name: "knee",
        title: "Knee of two beams, loaded out of their plane: joint `clamp` of two bodies",
        source: "Linear beam: P (a³ + b³)/3EI + P a b²/GJ + P (a + b)/GA",
        sketch: r"
  |/|=========+   a = 1 m         circular section, d = 20 mm,
              |   b = 0.7 m       E = 210 GPa, ν = 0.3, shear factor 1
              x P, normal to the plane",
        goal: "Exact with one linked element per leg: 1e-7, the effect of the finite displacement",
        run: knee,
    },
    Problem {
        name: "plastic_impact",
        title: "Rod that is caught by a hinge: impulse at the start",
        source: "Conservation of the angular momentum about the hinge: ω = 3v/2L, kinetic energy 3/4",
        sketch: r"
      ================o    v = 2 m/s normal to the rod, L = 0.8 m
      |  |  |  |  |  |     the hinge stops one end
      v  v  v  v  v  v",
        goal: "Angular velocity and energy after the impulse, to rounding",
        run: plastic_impact,
    },
    Problem {
        name: "hinged_link",
        title: "Post-buckling of a rigid link: `spring` of a `revolute` joint",
        source: "P_cr = k/L; P L sin θ + H L cos θ = k θ with a transverse force H",
        sketch: r"
         | P, H = P/1000
         v
         |    L = 2 m
      ~~ o    k = 50 N m/rad",
        goal: "Equilibrium on each point of the path up to 1.5 P_cr, to 1e-7 of P_cr",
        run: hinged_link,
    },
];

fn physical_pendulum() -> Result<Findings, VerificationError> {
    let (alpha, omega) = (2.5f64, (9.81 * 0.5 / (0.1 + 0.25f64)).sqrt());
    let duration = 5.0 * elliptic_k((0.5 * alpha).sin()) / omega;
    let model = format!(
        r#"
        gravity = [0, -9.81, 0]
        bodies = [{{ kind = "rigid", name = "rod", center = [{:?}, {:?}, 0], mass = 1, inertia = [0.1, 0.1, 0.1] }}]
        joints = [{{ kind = "revolute", name = "hinge", a = {{ body = "rod", at = [0, 0, 0] }}, axis = [0, 0, 1] }}]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#,
        0.5 * alpha.sin(),
        -0.5 * alpha.cos()
    );
    Refinement::steps(&model, duration, &[2000, 4000])
        .last("angle, rad", "hinge.angle", -alpha, 1e-4)
        .order(2.0)
        .last("angular velocity, 1/s", "hinge.rate", -2.0 * omega * (0.5 * alpha).sin(), 1e-4)
        .order(2.0)
        .run()
}

fn conical_pendulum() -> Result<Findings, VerificationError> {
    let (sin, omega) = (FRAC_PI_3.sin(), (2.0 * 9.81f64).sqrt());
    let model = format!(
        r#"
        gravity = [0, 0, -9.81]
        bodies = [{{ kind = "rigid", name = "bob", center = [{sin:?}, 0, -0.5], mass = 2, inertia = [0.3, 0.3, 0.3], motion = {{ spin = [0, 0, {omega:?}], about = [0, 0, 0] }} }}]
        joints = [{{ kind = "spherical", name = "ball", a = {{ body = "bob", at = [0, 0, 0] }} }}]
        probes = [{{ name = "p", on = {{ body = "bob", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#
    );
    Refinement::steps(&model, 2.0 * PI / omega, &[200, 400])
        .curve("x of the centre, m", ["t", "p.x"], |t| sin * (omega * t).cos(), 1.0, 3e-4)
        .order(2.0)
        .curve("height of the centre, m", ["t", "p.z"], |_| -0.5, 1.0, 3e-4)
        .order(2.0)
        .run()
}

fn cardan_shaft() -> Result<Findings, VerificationError> {
    let (sin, cos) = (PI / 6.0).sin_cos();
    let model = format!(
        r#"
        bodies = [
          {{ kind = "rigid", name = "first", center = [-0.5, 0, 0], mass = 1, inertia = [0.01, 0.1, 0.1] }},
          {{ kind = "rigid", name = "second", center = [{:?}, {:?}, 0], mass = 1, inertia = [0.02, 0.02, 0.02] }},
        ]
        joints = [
          {{ kind = "revolute", name = "drive", a = {{ body = "first", at = "center" }}, axis = [1, 0, 0], drive = {{ angle = 1, time = {{ kind = "expression", text = "t^2" }} }} }},
          {{ kind = "universal", name = "cross", a = {{ body = "first", at = [0, 0, 0] }}, b = {{ body = "second", at = [0, 0, 0] }}, axis_a = [0, 0, 1], axis_b = [{:?}, {cos:?}, 0] }},
          {{ kind = "point_on_line", name = "bearing", a = {{ body = "second", at = [{cos:?}, {sin:?}, 0] }}, axis = [{cos:?}, {sin:?}, 0] }},
        ]
        probes = [
          {{ name = "mark", on = {{ body = "second", at = [{:?}, {:?}, 0.1] }} }},
          {{ name = "second shaft", on = {{ body = "second", at = "center" }}, record = ["rotation"] }},
        ]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#,
        0.5 * cos,
        0.5 * sin,
        -sin,
        0.5 * cos,
        0.5 * sin
    );
    let angle = |t: f64| f64::atan2(cos * (t * t).sin(), (t * t).cos());
    let rate = |t: f64| 2.0 * t * cos / (1.0 - (sin * (t * t).sin()).powi(2));
    Refinement::steps(&model, 2.5, &[500, 1000])
        .curve(
            "z of a mark at 0.1 m on the second shaft, m",
            ["t", "mark.z"],
            |t| 0.1 * angle(t).cos(),
            0.1,
            1e-7,
        )
        .curve("angular velocity about x, 1/s", ["t", "second shaft.wx"], |t| rate(t) * cos, 5.0, 1e-3)
        .order(2.0)
        .run()
}

fn hinge_brake() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "wheel", center = [0, 0, 0], mass = 1, inertia = [0.2, 0.2, 0.4], motion = { spin = [0, 0, 2] } }]
        joints = [{ kind = "revolute", name = "hinge", a = { body = "wheel", at = "center" }, axis = [0, 0, 1], friction = { moment = 0.3, rate = 0.5 } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let law = |t: f64| 0.5 * ((2.0f64 / 0.5).sinh() * (-0.3 * t / (0.4 * 0.5)).exp()).asinh();
    Refinement::steps(MODEL, 4.0, &[400, 800])
        .curve("angular velocity, 1/s", ["t", "hinge.rate"], law, 2.0, 1e-4)
        .order(2.0)
        .run()
}

fn knee() -> Result<Findings, VerificationError> {
    let (young, shear, d) = (210e9, 210e9 / 2.6, 0.02f64);
    let (area, second) = (PI * d * d / 4.0, PI * d.powi(4) / 64.0);
    let (a, b, load) = (1.0f64, 0.7f64, 1e-3);
    let model = format!(
        r#"
        materials.steel = {{ density = 7850, young = {young:?}, poisson = 0.3 }}
        sections.round = {{ kind = "general", area = {area:?}, iy = {second:?}, iz = {second:?} }}
        bodies = [
          {{ kind = "beam", name = "arm", from = [0, 0, 0], to = [1, 0, 0], elements = 1, section = "round", material = "steel" }},
          {{ kind = "beam", name = "leg", from = [1, 0, 0], to = [1, -0.7, 0], elements = 1, section = "round", material = "steel", up = [1, 0, 0] }},
        ]
        joints = [
          {{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }},
          {{ kind = "clamp", name = "knee", a = {{ body = "leg", at = "start" }}, b = {{ body = "arm", at = "end" }} }},
        ]
        loads = [{{ kind = "force", on = {{ body = "leg", at = "end" }}, force = [0, 0, {load:?}] }}]
        probes = [{{ name = "tip", on = {{ body = "leg", at = "end" }} }}]
        analysis = {{ kind = "statics", stop = {{ rule = "energy", tolerance = 1e-12 }} }}
        "#
    );
    let bending = (a.powi(3) + b.powi(3)) / (3.0 * young * second);
    let deflection = load * (bending + a * b * b / (shear * 2.0 * second) + (a + b) / (shear * area));
    Refinement::single(model)
        .last("deflection, m", "tip.z", deflection, 1e-7)
        .last("force of the knee, N", "knee.fz", -load, 1e-9)
        .last("torque of the root, N m", "root.mx", load * b, 1e-6)
        .run()
}

fn plastic_impact() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "rod", center = [0.4, 0, 0], mass = 3, inertia = [0.16, 0.16, 0.16], motion = { velocity = [0, -2, 0] } }]
        joints = [{ kind = "revolute", name = "hinge", a = { body = "rod", at = [0.8, 0, 0] }, axis = [0, 0, 1] }]
        analysis = { kind = "dynamics", duration = 0.1, step = 0.01 }
    "#;
    Refinement::single(MODEL.to_owned())
        .value("angular velocity at the start, 1/s", |s| Ok(s.column("hinge.rate")?[0]), 3.75, 1e-9)
        .value("kinetic energy at the start, J", |s| Ok(s.column("kinetic")?[0]), 4.5, 1e-9)
        .last("angular velocity at the end, 1/s", "hinge.rate", 3.75, 1e-3)
        .run()
}

fn hinged_link() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "link", center = [0, 1, 0], mass = 1, inertia = [1, 1, 1] }]
        joints = [{ kind = "revolute", name = "foot", a = { body = "link", at = [0, 0, 0] }, axis = [0, 0, 1], spring = { stiffness = 50 } }]
        loads = [{ kind = "force", on = { body = "link", at = [0, 2, 0] }, force = [-0.025, -25, 0] }]
        analysis = { kind = "path", load = 1.5, largest = 0.05 }
    "#;
    let load = |theta: f64| 50.0 * theta / (2.0 * (25.0 * theta.sin() + 0.025 * theta.cos()));
    Refinement::single(MODEL.to_owned()).curve("load factor", ["foot.angle", "load"], load, 1.0, 1e-7).run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
