//! Balls of rigid bodies roll on obstacles.

use nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

/// A homogeneous ball of 2 kg on a plane, with the motion, the gravity and the scheme of the test.
fn ball(motion: &str, gravity: [f64; 3], scheme: &str) -> Run {
    Run::of(&parse(&format!(
        r#"
        gravity = {gravity:?}
        bodies = [{{ kind = "rigid", name = "ball", center = [0, 0, 0.05], mass = 2, inertia = [2e-3, 2e-3, 2e-3], surface = {{ radius = 0.05 }}, motion = {motion} }}]
        probes = [{{ name = "p", on = {{ body = "ball", at = "center" }}, record = ["motion", "rotation"] }}]
        contacts = [{{ with = {{ kind = "plane", point = [0, 0, 0], normal = [0, 0, 1] }}, stiffness = 1e6, friction = 0.3, slip_speed = 1e-3, damping = 5 }}]
        analysis = {{ kind = "dynamics", duration = 0.5, step = 1e-3, scheme = {scheme} }}
        "#
    )))
}

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
const SCHEMES: [&str; 2] = ["{ spectral_radius = 0.8 }", "\"energy\""];

/// Friction turns sliding and spinning into rolling, with the angular momentum about the point of contact: v = 5/7 v₀ + 2/7 R ω₀.
/// Pure rolling persists without loss, and a spin about the normal is not braked.
#[test]
fn sliding_becomes_rolling() {
    for scheme in SCHEMES {
        for (velocity, spin, rolling) in [(1.0, 0.0, 5.0 / 7.0), (0.0, 20.0, 2.0 / 7.0), (1.0, 20.0, 1.0)] {
            let motion = format!("{{ velocity = [{velocity:?}, 0, 0], spin = [0, {spin:?}, 3] }}");
            let run = ball(&motion, GRAVITY, scheme);
            assert_relative(scheme, run.last("p.vx"), rolling, 1e-3);
            assert_relative(scheme, run.last("p.wy"), rolling / 0.05, 1e-3);
            assert_relative(scheme, run.last("p.wz"), 3.0, 1e-3);
            // The ball settles on the plane by 0.2 mm, with a work of 4 mJ.
            let before: f64 = velocity * velocity + 1e-3 * spin * spin;
            let lost = run.last("dissipated") - (before - 1.4 * rolling * rolling);
            assert!(lost.abs() < 1e-2, "{scheme}: {lost}");
        }
    }
}

/// A ball rolls down an incline with 5/7 of the acceleration of gravity along it.
#[test]
fn ball_rolls_down_an_incline() {
    let slope = 0.3_f64;
    let gravity = [9.81 * slope.sin(), 0.0, -9.81 * slope.cos()];
    let run = ball("{ velocity = [0, 0, 0] }", gravity, SCHEMES[0]);
    assert_relative("speed", run.last("p.vx"), 5.0 / 7.0 * 9.81 * slope.sin() * 0.5, 2e-3);
    assert_relative("spin", run.last("p.wy"), run.last("p.vx") / 0.05, 2e-3);
}

/// A spinning ball that grazes a free body with a spherical obstacle: momentum and angular momentum are conserved, and the bodies turn.
#[test]
fn grazing_balls_conserve_momenta() {
    for scheme in SCHEMES {
        let run = Run::of(&parse(&format!(
            r#"
            bodies = [
              {{ kind = "rigid", name = "a", center = [0, 0, 0], mass = 1, inertia = [0.01, 0.02, 0.015], surface = {{ radius = 0.1 }}, motion = {{ velocity = [2, 0, 0], spin = [5, -20, 30] }} }},
              {{ kind = "rigid", name = "b", center = [0.4, 0.1, 0.05], mass = 3, inertia = [0.03, 0.02, 0.04] }},
            ]
            probes = [
              {{ name = "a", on = {{ body = "a", at = "center" }}, record = ["motion", "rotation"] }},
              {{ name = "b", on = {{ body = "b", at = "center" }}, record = ["motion", "rotation"] }},
            ]
            contacts = [{{ with = {{ kind = "sphere", center = [0.4, 0.1, 0.05], radius = 0.15, on = {{ body = "b", at = "center" }} }}, stiffness = 1e5, friction = 0.4, slip_speed = 1e-2, damping = 0.1 }}]
            analysis = {{ kind = "dynamics", duration = 0.15, step = 1e-4, scheme = {scheme} }}
            "#
        )));
        let vector = |at: usize, name: &str| {
            Vector3::from([0, 1, 2].map(|axis| run.column(&format!("{name}{}", ["x", "y", "z"][axis]))[at]))
        };
        let (mut momenta, mut spins) = (Vec::new(), Vec::new());
        let count = run.column("a.x").len();
        for at in [0, count - 1] {
            let (mut linear, mut angular) = (Vector3::zeros(), Vector3::zeros());
            for (body, mass) in [("a", 1.0), ("b", 3.0)] {
                let [r, v, w] = [".", ".v", ".w"].map(|name| vector(at, &format!("{body}{name}")));
                linear += v * mass;
                angular += r.cross(&v) * mass;
                spins.push(w);
            }
            momenta.push((linear, angular));
        }
        assert!((momenta[0].0 - momenta[1].0).norm() < 1e-9 * momenta[0].0.norm(), "{scheme}");
        assert!((spins[3] - spins[1]).norm() > 0.5, "{scheme}: the free body turns by {}", spins[3]);
        // About the normal of a sphere, both bodies have their own angular momentum: only the sum is checked.
        let own = |body: &str, inertia: [f64; 3], at: usize| {
            let [w, x, y, z] = ["e0", "e1", "e2", "e3"].map(|name| run.column(&format!("{body}.{name}"))[at]);
            let rotation = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
            let local = rotation.inverse() * vector(at, &format!("{body}.w"));
            rotation * Vector3::from_fn(|i, _| inertia[i] * local[i])
        };
        let whole = |k: usize, at: usize| {
            momenta[k].1 + own("a", [0.01, 0.02, 0.015], at) + own("b", [0.03, 0.02, 0.04], at)
        };
        let (before, after) = (whole(0, 0), whole(1, count - 1));
        assert!((before - after).norm() < 1e-5 * before.norm(), "{scheme}: {before} {after}");
    }
}

/// A damped ball comes to rest on a plane with all schemes, and remains there: the work of the contact vanishes with the motion.
#[test]
fn balls_come_to_rest() {
    for scheme in SCHEMES {
        let run = ball("{ velocity = [0, 0, -0.1] }", GRAVITY, scheme);
        let [height, speed] = ["p.z", "p.vz"].map(|name| run.last(name));
        // Depth of the weight p = m g/(2 R) in the transition, √(2δp/k).
        assert!(
            (height - (0.05 - (2.0 * 1e-3 * 2.0 * 9.81 / 1e5_f64).sqrt())).abs() < 1e-6 && speed.abs() < 1e-6,
            "{scheme}: {height}, {speed}"
        );
    }
}
