//! Bodies in rotation about a point.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::reference::runge_kutta;
use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "symmetric_top",
        title: "Symmetric top without forces",
        source: "Euler: the axis and ω turn about the angular momentum L at the rate |L|/J",
        sketch: r"
        L ^ / axis     J = 0.5, J₃ = 0.8 kg m², spin (1, 0, 4) 1/s
          |/
          o",
        goal: "Angular velocity in space over three seconds. Second order",
        run: symmetric_top,
    },
    Problem {
        name: "asymmetric_top",
        title: "Asymmetric top that turns over",
        source: "Euler's equations and the quaternion of the rotation, by a Runge-Kutta integration",
        sketch: r"
          ^ /    moments of inertia 1, 2, 3 kg m²
          |/     spin (0.05, 3, 0.02) 1/s about the unstable middle axis
          o--",
        goal: "Angular velocity and rotation after two seconds. Second order",
        run: asymmetric_top,
    },
    Problem {
        name: "heavy_top",
        title: "Steady precession of a heavy top",
        source: "J Ω² cos θ − J₃ ω₃ Ω + m g l = 0 about the fixed point",
        sketch: r"
          | Ω  / spin        θ = 60°, l = 0.3 m, m = 2 kg
          |   O              J = 0.25 kg m² about the point, J₃ = 0.05 kg m²
          |_/   g |          Ω = 2 1/s
          o",
        goal: "Centre on its circle at constant height over a second. Second order",
        run: heavy_top,
    },
    Problem {
        name: "flapping_blade",
        title: "Flapping of a rigid blade on a rotating hub",
        source: "Small oscillation about the hinge: ω² = Ω² (1 + 3e/2l) for a uniform blade of length l at radius e",
        sketch: r"
       Ω                   Ω = 10 1/s, e = 0.2 m, l = 1.5 m
      (|)--o===========    flapping rate 0.01 1/s at the start",
        goal: "Flapping angle over one period, within 1e-3 of its amplitude. Second order",
        run: flapping_blade,
    },
];

fn symmetric_top() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "top", center = [0, 0, 0], mass = 1, inertia = [0.5, 0.5, 0.8], motion = { spin = [1, 0, 4] } }]
        probes = [{ name = "p", on = { body = "top", at = "center" }, record = ["rotation"] }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let momentum = Vector3::new(0.5, 0.0, 3.2);
    let spin = move |t: f64| {
        let turn = UnitQuaternion::from_scaled_axis(momentum * (t / 0.5));
        turn * Vector3::new(1.0, 0.0, 4.0)
    };
    Refinement::steps(MODEL, 3.0, &[1500, 3000])
        .curve("ω along x, 1/s", ["t", "p.wx"], move |t| spin(t).x, 4.0, 1e-3)
        .order(2.0)
        .curve("ω along y, 1/s", ["t", "p.wy"], move |t| spin(t).y, 4.0, 1e-3)
        .order(2.0)
        .curve("ω along z, 1/s", ["t", "p.wz"], move |t| spin(t).z, 4.0, 1e-3)
        .order(2.0)
        .run()
}

/// Returns the angular velocity in space and the Euler parameters at time `t`.
fn euler(inertia: [f64; 3], spin: [f64; 3], t: f64) -> (Vector3<f64>, Quaternion<f64>) {
    let rates = |_: f64, y: &[f64; 7]| {
        let [a, b, c] = [y[0], y[1], y[2]];
        let q = Quaternion::new(y[3], y[4], y[5], y[6]) * Quaternion::new(0.0, a, b, c) * 0.5;
        let [i, j, k] = inertia;
        [(j - k) / i * b * c, (k - i) / j * c * a, (i - j) / k * a * b, q.w, q.i, q.j, q.k]
    };
    let start = [spin[0], spin[1], spin[2], 1.0, 0.0, 0.0, 0.0];
    let y = runge_kutta(rates, start, t, 20_000);
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(y[3], y[4], y[5], y[6]));
    (turn * Vector3::new(y[0], y[1], y[2]), *turn.quaternion())
}

fn asymmetric_top() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "top", center = [0, 0, 0], mass = 1, inertia = [1, 2, 3], motion = { spin = [0.05, 3, 0.02] } }]
        probes = [{ name = "p", on = { body = "top", at = "center" }, record = ["rotation"] }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let (spin, turn) = euler([1.0, 2.0, 3.0], [0.05, 3.0, 0.02], 2.0);
    let angle = move |s: &SolvedModel| {
        let [w, i, j, k] = ["p.e0", "p.e1", "p.e2", "p.e3"].map(|name| s.last(name));
        let ours = UnitQuaternion::from_quaternion(Quaternion::new(w?, i?, j?, k?));
        Ok(ours.angle_to(&UnitQuaternion::from_quaternion(turn)))
    };
    let error = move |s: &SolvedModel| {
        let [x, y, z] = ["p.wx", "p.wy", "p.wz"].map(|name| s.last(name));
        Ok((Vector3::new(x?, y?, z?) - spin).norm())
    };
    Refinement::steps(MODEL, 2.0, &[1000, 2000, 4000])
        .value("error of the angular velocity, 1/s", error, 0.0, 1e-3)
        .scaled(3.0)
        .order(2.0)
        .value("angle of the error of the rotation, rad", angle, 0.0, 1e-3)
        .scaled(1.0)
        .order(2.0)
        .run()
}

fn heavy_top() -> Result<Findings, VerificationError> {
    let (theta, rate, mass, arm, about, axial) = (std::f64::consts::FRAC_PI_3, 2.0, 2.0, 0.3, 0.25, 0.05);
    let (sin, cos) = theta.sin_cos();
    let axis = Vector3::new(sin, 0.0, cos);
    let spin = (about * rate * rate * cos + mass * 9.81 * arm) / (axial * rate);
    // ω = Ω e_z + (ω₃ − Ω cos θ) e₃.
    let omega = Vector3::z() * rate + axis * (spin - rate * cos);
    let transverse = about - mass * arm * arm;
    let inertia = Matrix3::identity() * transverse + axis * axis.transpose() * (axial - transverse);
    let model = format!(
        r#"
        gravity = [0, 0, -9.81]
        bodies = [{{ kind = "rigid", name = "top", center = {:?}, mass = {mass:?}, inertia = {:?}, products = {:?}, motion = {{ spin = {:?}, about = [0, 0, 0] }} }}]
        joints = [{{ kind = "spherical", name = "point", a = {{ body = "top", at = [0, 0, 0] }} }}]
        probes = [{{ name = "p", on = {{ body = "top", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = DURATION, step = STEP }}
        "#,
        (axis * arm).as_slice(),
        [inertia[(0, 0)], inertia[(1, 1)], inertia[(2, 2)]],
        [inertia[(0, 1)], inertia[(0, 2)], inertia[(1, 2)]],
        omega.as_slice()
    );
    Refinement::steps(&model, 1.0, &[2000, 4000])
        .curve("x of the centre, m", ["t", "p.x"], |t| arm * sin * (rate * t).cos(), 0.3, 1e-3)
        .order(2.0)
        .curve("y of the centre, m", ["t", "p.y"], |t| arm * sin * (rate * t).sin(), 0.3, 1e-3)
        .order(2.0)
        .curve("height of the centre, m", ["t", "p.z"], |_| arm * cos, 0.3, 1e-3)
        .order(2.0)
        .run()
}

fn flapping_blade() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [
          { kind = "rigid", name = "hub", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1], motion = { spin = [0, 0, 10] } },
          { kind = "rigid", name = "blade", center = [0.95, 0, 0], mass = 4, inertia = [1e-9, 0.75, 0.75], motion = { spin = [0, -0.01, 10], velocity = [0, 9.5, 0.0075] } },
        ]
        joints = [
          { kind = "revolute", name = "drive", a = { body = "hub", at = "center" }, axis = [0, 0, 1], drive = { rate = 10 } },
          { kind = "revolute", name = "flap", a = { body = "blade", at = [0.2, 0, 0] }, b = { body = "hub", at = [0.2, 0, 0] }, axis = [0, -1, 0] },
        ]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let omega = 10.0 * (1.0f64 + 3.0 * 0.2 / (2.0 * 1.5)).sqrt();
    Refinement::steps(MODEL, std::f64::consts::TAU / omega, &[200, 400])
        .curve(
            "flapping angle, rad",
            ["t", "flap.angle"],
            |t| 0.01 / omega * (omega * t).sin(),
            0.01 / omega,
            1e-3,
        )
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
