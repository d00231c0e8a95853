//! Inertial sensors and powers of joints and loads.

use ancf::{Error, Simulation};
use nalgebra::Vector3;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Pendulum with nearly all mass at the distance 0.8 from its pivot.
const PENDULUM: &str = r#"
gravity = [0, -9.81, 0]
bodies = [{ kind = "rigid", name = "bob", center = [0.8, 0, 0], mass = 2, inertia = [1e-6, 1e-6, 1e-6] }]
joints = [{ kind = "revolute", name = "pivot", a = { body = "bob", at = [0, 0, 0] }, axis = [0, 0, 1] }]
probes = [{ name = "bob", on = { body = "bob", at = "center" }, record = ["motion", "inertial_sensor"] }]
[output]
power = true
[analysis]
kind = "dynamics"
duration = 0.9
step = 5e-4
scheme = { spectral_radius = 0.9 }
"#;

/// A point pendulum: the only force besides gravity is along the arm, T = m (g sin θ + ω²ℓ) with ω²ℓ = 2 g sin θ, θ below the horizontal.
#[test]
fn an_accelerometer_reads_the_force_of_the_arm() {
    let run = Run::of(&parse(PENDULUM));
    let (ax, ay, az) = (run.column("bob.imu_ax"), run.column("bob.imu_ay"), run.column("bob.imu_az"));
    let (y, w, speed) = (run.column("bob.y"), run.column("bob.imu_wz"), run.vectors("bob.v"));
    for k in 1..y.len() {
        let below = -y[k] / 0.8;
        assert!((ax[k] + 3.0 * 9.81 * below).abs() < 2e-2, "{} at {k}, not {}", ax[k], -3.0 * 9.81 * below);
        assert!(ay[k].abs() < 2e-2 && az[k].abs() < 1e-9, "{} and {} at {k}", ay[k], az[k]);
        assert!((w[k].abs() - speed[k].norm() / 0.8).abs() < 1e-3, "{} at {k}", w[k]);
    }
    // An ideal hinge does no work.
    assert!(run.column("pivot.power").iter().all(|power| power.abs() < 1e-6));
}

/// At rest, a tilted sensor reads −g in its own axes.
#[test]
fn a_sensor_at_rest_reads_gravity() {
    let text = PENDULUM.replace("\"revolute\"", "\"clamp\"").replace(", axis = [0, 0, 1]", "");
    let run = Run::of(&parse(&text));
    let read = Vector3::new(run.last("bob.imu_ax"), run.last("bob.imu_ay"), run.last("bob.imu_az"));
    assert!((read - Vector3::new(0.0, 9.81, 0.0)).norm() < 1e-9, "{read}");
}

#[test]
fn sensors_on_a_moving_ground_are_rejected() {
    let load = "loads = [{ kind = \"base_acceleration\", acceleration = [1, 0, 0] }]";
    let model = ancf::Model::parse(&format!("{load}\n{PENDULUM}"));
    let error =
        match model.map_err(Error::from).and_then(|model| Simulation::new(&model).map_err(Error::from)) {
            Ok(_) => panic!("accepted"),
            Err(error) => error.to_string(),
        };
    assert!(error.contains("probes[0].record") && error.contains("moving ground"), "{error}");
}

/// Powers of a drive, a damper and a force sum to the rate of the kinetic energy.
#[test]
fn powers_sum_to_the_rate_of_the_energy() {
    let run = Run::of(&parse(
        r#"
bodies = [{ kind = "rigid", name = "wheel", center = [0, 0, 0], mass = 2, inertia = [1, 1, 0.5] }, { kind = "mass", name = "block", center = [1, 0, 0], mass = 3 }]
joints = [
  { kind = "revolute", name = "motor", a = { body = "wheel", at = "center" }, axis = [0, 0, 1], drive = { angle = 1, time = { kind = "expression", text = "0.3*t^3" } } },
  { kind = "spring", name = "damper", a = { body = "block", at = "center" }, b = { point = [0, 0, 0] }, stiffness = 0, damping = 2 },
]
loads = [{ kind = "force", on = { body = "block", at = "center" }, force = [5, 0, 0], time = { kind = "expression", text = "1 + t" } }]
[output]
power = true
[analysis]
kind = "dynamics"
duration = 1
step = 1e-3
scheme = { spectral_radius = 0.9 }
"#,
    ));
    for (k, t) in run.column("t").iter().enumerate().skip(2) {
        // ω = 0.9 t², power 0.5 ω ω̇ of the drive.
        let motor = 0.5 * 0.9 * t * t * 1.8 * t;
        assert!((run.column("motor.power")[k] - motor).abs() < 2e-3, "{t}: {}", run.column("motor.power")[k]);
    }
    let (motor, damper, force) =
        (run.column("motor.power"), run.column("damper.power"), run.column("loads[0].power"));
    let (kinetic, h) = (run.column("kinetic"), 1e-3);
    for k in 2..kinetic.len() - 1 {
        let rate = (kinetic[k + 1] - kinetic[k - 1]) / (2.0 * h);
        let sum = motor[k] + damper[k] + force[k];
        assert!((rate - sum).abs() < 5e-3 * (1.0 + sum.abs()), "{k}: {rate} and {sum}");
        assert!(damper[k] <= 0.0 && force[k] >= 0.0);
    }
}
