//! Statics and modes of rigid bodies alone, with redundant joints, in any direction and for any size of the loads.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::common::models::parse;
use crate::common::random::Random;
use crate::common::solutions::Run;

/// Door that hangs on two joints along an axis, turned and moved.
struct Door {
    turn: Rotation3<f64>,
    offset: Vector3<f64>,
    mass: f64,
    gravity: f64,
}

impl Door {
    fn at(&self, x: f64, y: f64, z: f64) -> Vec<f64> {
        (self.turn * Vector3::new(x, y, z) + self.offset).as_slice().to_vec()
    }

    fn along(&self, x: f64, y: f64, z: f64) -> Vec<f64> {
        (self.turn * Vector3::new(x, y, z)).as_slice().to_vec()
    }

    /// Runs an analysis of the door. The keys of both joints are functions of the direction of the axis.
    fn run(&self, joints: [&str; 2], analysis: &str) -> Run {
        let turn = self.turn.matrix();
        let inertia =
            turn * Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 1.5)) * turn.transpose() * self.mass;
        let joint = |k: usize| {
            format!(
                "[[joints]]\nname = \"h{k}\"\na = {{ body = \"d\", at = {:?} }}\n{}\n",
                self.at(0.0, k as f64 - 0.5, 0.0),
                joints[k].replace("AXIS", &format!("{:?}", self.along(0.0, 1.0, 0.0)))
            )
        };
        Run::of(&parse(&format!(
            "gravity = {:?}\n[[bodies]]\nkind = \"rigid\"\nname = \"d\"\ncenter = {:?}\nmass = {:?}\ninertia = {:?}\nproducts = {:?}\n\
             {}{}[analysis]\n{analysis}\n",
            self.along(0.0, 0.0, -self.gravity),
            self.at(0.0, 0.0, -0.4),
            self.mass,
            [inertia[(0, 0)], inertia[(1, 1)], inertia[(2, 2)]],
            [inertia[(0, 1)], inertia[(0, 2)], inertia[(1, 2)]],
            joint(0),
            joint(1)
        )))
    }
}

/// The reactions carry the weight, and the frequency about the equilibrium is √((k + m g l)/(J + m l²)). Nothing moves: before, the
/// scales of the equations came from rounding errors, statics failed in most directions, and some frequencies were wrong by 70 %.
#[test]
fn door_on_two_joints_carries_its_weight() {
    let mut random = Random(61);
    for k in 0..8 {
        let axis = random.vector3();
        let door = Door {
            turn: if k % 4 == 0 { Rotation3::identity() } else { Rotation3::new(axis * 3.0) },
            offset: random.vector3() * k as f64,
            mass: [1.0, 20.0, 3e-2, 4e3][k % 4],
            gravity: [9.81, 1.0, 5.0, 20.0][k / 2],
        };
        let weight = door.mass * door.gravity;
        let stiffness = [50.0, 0.4, 7.0][k % 3] * door.mass;
        let sprung = format!("kind = \"revolute\"\naxis = AXIS\nspring = {{ stiffness = {stiffness:?} }}");
        let hinges = [sprung.as_str(), "kind = \"revolute\"\naxis = AXIS"];
        for joints in [hinges, ["kind = \"clamp\""; 2]] {
            let held = door.run(joints, "kind = \"statics\"");
            let force: Vec<f64> = ["x", "y", "z"]
                .map(|i| held.last(&format!("h0.f{i}")) + held.last(&format!("h1.f{i}")))
                .to_vec();
            let expected = door.along(0.0, 0.0, weight);
            let error = force.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(error < 1e-9 * weight, "{k}: {force:?} not {expected:?}");
        }
        let found =
            door.run(hinges, "kind = \"modes\"\nabout = \"equilibrium\"\ncount = 1").column("frequency")[0];
        let exact = ((stiffness + 0.4 * weight) / (2.16 * door.mass)).sqrt() / TAU;
        assert!((found / exact - 1.0).abs() < 1e-8, "{k}: {found} not {exact}");
    }
}

/// The same with units that are chosen from the model, and an axis along gravity.
#[test]
fn upright_door_carries_its_weight() {
    for scales in ["none", "auto"] {
        let hinge = |name: &str, z: f64, spring: &str| {
            format!(
                "[[joints]]\nkind = \"revolute\"\nname = \"{name}\"\na = {{ body = \"d\", at = [0, 0, {z}] }}\naxis = [0, 0, 1]\n{spring}\n"
            )
        };
        let run = Run::of(&parse(&format!(
            "gravity = [0, 0, -9.81]\nscales = {{ kind = \"{scales}\" }}\n[[bodies]]\nkind = \"rigid\"\nname = \"d\"\n\
             center = [0.351, 0.1918, 1.0]\nmass = 20\ninertia = [1.23, 1.77, 1.5]\nproducts = [-0.42, 0, 0]\n{}{}\
             [analysis]\nkind = \"statics\"\n",
            hinge("h0", 0.2, "spring = { stiffness = 10 }"),
            hinge("h1", 1.8, "")
        )));
        let force = run.last("h0.fz") + run.last("h1.fz");
        assert!((force - 196.2).abs() < 1e-9 * 196.2, "{force}");
        // Moments about the lower hinge: the upper one pulls with m g r/1.6.
        let pull = run.last("h1.fx").hypot(run.last("h1.fy"));
        let exact = 196.2 * 0.351_f64.hypot(0.1918) / 1.6;
        let moments = run.last("h0.mx").hypot(run.last("h0.my")) + run.last("h1.mx").hypot(run.last("h1.my"));
        assert!(
            pull <= exact * (1.0 + 1e-9) && pull * 1.6 + moments >= exact * 1.6 * (1.0 - 1e-9),
            "{pull} {exact}"
        );
    }
}
