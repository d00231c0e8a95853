//! Annular plate, banner, bracket, cloth and tent.

use std::f64::consts::PI;

use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::files::model;
use crate::common::solutions::Run;

/// Deflections 17.528 and 13.891 at the full load (Sze, Liu & Lo 2004, table 4).
#[test]
fn slit_annulus_becomes_a_ramp() {
    let run = Run::of(&model("annulus"));
    for (name, reference) in [("outer.y", 17.528), ("inner.y", 13.891)] {
        assert_near(name, *run.column(name).last().unwrap(), reference, 0.1);
    }
}

/// Reactions balance the force and the weight, and most of the strain energy is the work of the force.
#[test]
fn bracket_is_in_equilibrium() {
    let run = Run::of(&model("bracket"));
    let last = |name: &str| *run.column(name).last().unwrap();
    // Weights of the pin and of a strip of 96.57 x 40 mm with round corners of 6 mm and holes of 4, 4 and 8 mm.
    let area = 96.57 * 40.0 - (4.0 - PI) * 36.0 - PI * (16.0 + 16.0 + 64.0);
    let weight = 9.81 * (0.02 + 7850.0 * 1.5e-3 * area * 1e-6);
    for (axis, force, size) in [("x", 20.0, 1e-9), ("y", 10.0, 1e-9), ("z", -40.0 - weight, 5e-3)] {
        let sum = last(&format!("left.f{axis}")) + last(&format!("right.f{axis}"));
        assert_near(axis, sum, -force, size);
    }
    let moved = [last("pin.x") - 0.05, last("pin.y"), last("pin.z") - 0.034];
    let work = 0.5 * (20.0 * moved[0] + 10.0 * moved[1] - 40.0 * moved[2]);
    assert_relative("strain energy", last("strain"), work, 0.05);
}

/// The sheet hardly stretches: the corner remains at the distance of the height from the rail, or nearer.
#[test]
fn banner_swings_about_its_rail() {
    let run = Run::of(&model("banner"));
    let (y, z) = (run.column("corner.y"), run.column("corner.z"));
    let distances: Vec<f64> = y.iter().zip(z).map(|(y, z)| y.hypot(*z)).collect();
    assert!(distances.iter().all(|distance| *distance < 1.02), "{distances:?}");
    assert!(y.iter().any(|y| *y > 0.5) && y.iter().any(|y| *y < -0.3));
}

/// The felt lies on the ball with half its thickness, hangs down at its corner, and comes to rest.
#[test]
fn cloth_drapes_over_a_ball() {
    let run = Run::of(&model("cloth"));
    let last = |name: &str| *run.column(name).last().unwrap();
    let distance = ["top.x", "top.y", "top.z"].map(last).iter().map(|x| x * x).sum::<f64>().sqrt();
    assert_near("distance from the ball", distance, 0.2 + 0.003, 0.002);
    assert!(last("corner.z") < -0.05, "{}", last("corner.z"));
    let kinetic = run.column("kinetic");
    let largest = kinetic.iter().fold(0.0, |a: f64, b| a.max(*b));
    assert!(last("kinetic") < 0.5 * largest, "{} of {largest}", last("kinetic"));
}

/// The arch has lost its pretension, the sag carries, and the supports carry weight and snow of the whole surface.
#[test]
fn tent_carries_snow_by_its_sag() {
    let run = Run::of(&model("tent"));
    let last = |name: &str| *run.column(name).last().unwrap();
    let [arch, sag] = [1.0, -1.0].map(|sign| last("middle.nuu") + sign * last("middle.nuv"));
    assert_near("principal directions", last("middle.nuu"), last("middle.nvv"), 1e-3);
    assert!(arch.abs() < 1.0 && sag > 4000.0, "{arch} and {sag} N/m");
    // Area of z = 2 (x/6 + y/6 − 2 x y/36) over the square of 6 × 6, by the midpoint rule.
    let slope = |x: f64| (1.0 - 2.0 * x) / 3.0;
    let places = (0..100).map(|k| (f64::from(k) + 0.5) / 100.0);
    let cells = places.clone().flat_map(|x| places.clone().map(move |y| [slope(x), slope(y)]));
    let area: f64 = cells.map(|[a, b]| 36e-4 * (1.0 + a * a + b * b).sqrt()).sum();
    let carried: f64 =
        ["front", "back", "left", "right"].map(|name| last(&format!("{name}.fz"))).iter().sum();
    assert_relative("reactions", carried, area * (600.0 + 1200.0 * 1e-3 * 9.81), 1e-5);
}
