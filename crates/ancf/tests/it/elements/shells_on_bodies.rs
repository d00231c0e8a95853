//! Edges of shells on rigid bodies.

use std::f64::consts::{FRAC_PI_2, TAU};

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::{assert_near, assert_relative};

const MATERIAL: &str = "materials.m = { density = 100, young = 1.2e7 }\n";

fn run(text: &str) -> Series {
    let mut series = Series::new();
    let model = Model::parse(text).unwrap();
    let warnings = model.diagnose().unwrap().warnings;
    assert!(warnings.iter().all(|warning| !warning.contains("redundant")), "{warnings:?}");
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap_or_else(|| panic!("no column {name}")).last().unwrap()
}

fn strip(elements: [u32; 2], keys: &str) -> String {
    format!(
        "[[bodies]]\nkind = \"shell\"\nname = \"s\"\nthickness = 0.01\nmaterial = \"m\"\nelements = {elements:?}\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 0.5, 0] }}\n{keys}"
    )
}

fn support(edge: &str, body: &str, condition: &str) -> String {
    let b = if body.is_empty() {
        String::new()
    } else {
        format!("b = {{ body = \"{body}\", at = \"center\" }}\n")
    };
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
         condition = \"{condition}\"\n{b}"
    )
}

fn rigid(name: &str, center: [f64; 3], mass: f64, keys: &str) -> String {
    format!(
        "[[bodies]]\nkind = \"rigid\"\nname = \"{name}\"\ncenter = {center:?}\nmass = {mass}\ninertia = [{0}, {0}, {0}]\n{keys}",
        mass * 0.01
    )
}

/// A moment on a rigid body at the end of a strip rolls it up to a quarter of a circle, and the reaction is the moment.
#[test]
fn moments_on_bodies_bend_the_strip() {
    // Curvature m/D = π/2 for the moment per width m, D = E h³/12 = 1.
    let text = format!(
        "{MATERIAL}{}{}{}{}[[loads]]\nkind = \"moment\"\non = {{ body = \"hub\", at = \"center\" }}\nmoment = [0, {}, 0]\n\
         [[probes]]\nname = \"hub\"\non = {{ body = \"hub\", at = \"center\" }}\nrecord = [\"motion\", \"rotation\"]\n\
         [[probes]]\nname = \"end\"\non = {{ body = \"s\", at = [1, 1] }}\n[analysis]\nkind = \"statics\"\n",
        strip([8, 2], ""),
        rigid("hub", [1.2, 0.25, 0.1], 1.0, ""),
        support("u_start", "", "clamped"),
        support("u_end", "hub", "clamped"),
        -0.5 * FRAC_PI_2
    );
    let series = run(&text);
    // The end of the arc is at (2/π, 2/π); the hub is at the arm (0.2, 0.1) in the turned frame: (−0.1, 0.2).
    let radius = 1.0 / FRAC_PI_2;
    assert_near("end x", last(&series, "end.x"), radius, 2e-3);
    assert_near("end z", last(&series, "end.z"), radius, 2e-3);
    assert_near("hub x", last(&series, "hub.x") - last(&series, "end.x"), -0.1, 1e-3);
    assert_near("hub z", last(&series, "hub.z") - last(&series, "end.z"), 0.2, 1e-3);
    assert_relative("moment", last(&series, "u_end.my").abs(), 0.5 * FRAC_PI_2, 1e-6);
    assert_near("force", last(&series, "u_end.fx"), 0.0, 1e-6);
}

/// A light strip with a heavy block at its end: ω² = 3 E I/(M L³) of a hinged block without moment, and 12 E I/(M L³) between blocks
/// that do not rotate.
#[test]
fn heavy_blocks_on_strips_have_the_frequencies_of_springs() {
    let (mass, bending) = (1000.0, 0.5);
    for (condition, keys, stiffness) in [
        ("hinged", "", 3.0 * bending),
        (
            "clamped",
            "[[joints]]\nkind = \"prismatic\"\nname = \"guide\"\na = { body = \"block\", at = \"center\" }\naxis = [0, 0, 1]\n",
            12.0 * bending,
        ),
        (
            "hinged",
            "[[joints]]\nkind = \"prismatic\"\nname = \"guide\"\na = { body = \"block\", at = \"center\" }\naxis = [0, 0, 1]\n",
            3.0 * bending,
        ),
    ] {
        let text = format!(
            "{}{}{}{}{}{keys}[analysis]\nkind = \"modes\"\ncount = 1\n",
            MATERIAL.replace("100", "1e-3"),
            strip([4, 2], ""),
            rigid("block", [1.0, 0.25, 0.0], mass, ""),
            support("u_start", "", "clamped"),
            support("u_end", "block", condition)
        );
        let frequency = run(&text).column("frequency").unwrap()[0];
        // Without the guide the hinged block swings freely about the edge.
        if condition == "hinged" && keys.is_empty() {
            assert_near("free rotation", frequency, 0.0, 1e-4);
            continue;
        }
        assert_relative(condition, TAU * frequency, (stiffness / mass).sqrt(), 2e-3);
    }
}

/// Two edges that meet at a corner of the same body state its motion twice; those on two bodies connect them.
#[test]
fn corners_on_bodies_have_no_redundant_equations() {
    for bodies in [["hub", "hub"], ["hub", "other"]] {
        let text = format!(
            "{MATERIAL}{}{}{}{}{}[[loads]]\nkind = \"force\"\non = {{ body = \"s\", at = [0, 1] }}\nforce = [0, 0, 0.01]\n\
             [[joints]]\nkind = \"clamp\"\nname = \"wall\"\na = {{ body = \"hub\", at = \"center\" }}\n\
             [[probes]]\nname = \"P\"\non = {{ body = \"s\", at = [1, 0] }}\n[analysis]\nkind = \"statics\"\n",
            strip([3, 2], ""),
            rigid("hub", [2.0, 0.0, 0.0], 1.0, ""),
            rigid("other", [2.0, 1.0, 0.0], 1.0, ""),
            support("v_start", bodies[0], "clamped"),
            support("u_end", bodies[1], "clamped")
        );
        let text = if bodies[1] == "hub" {
            text.replacen(
                "[[joints]]",
                "[[joints]]\nkind = \"clamp\"\nname = \"rest\"\na = { body = \"other\", at = \"center\" }\n[[joints]]",
                1,
            )
        } else {
            text
        };
        let series = run(&text);
        assert_near("corner", last(&series, "P.z"), 0.0, 1e-12);
    }
}

/// A strip between two rigid bodies in free flight: energy and momenta are constant, and the bodies rotate by large angles.
#[test]
fn strips_between_bodies_in_flight_conserve_momenta_and_energy() {
    for (scheme, tolerance) in [("\"energy\"", 1e-8), ("{ spectral_radius = 1.0 }", 2e-3)] {
        let motion = "motion = { velocity = [0.1, 0.2, 0], spin = [3, 4, -2], about = [0, 0, 0] }\n";
        let text = format!(
            "{MATERIAL}{}{}{}{}{}[[probes]]\nname = \"A\"\non = {{ body = \"a\", at = \"center\" }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.6\nstep = 3e-3\nscheme = {scheme}\n[output]\nmomentum = true\n",
            strip([4, 2], motion),
            rigid("a", [-0.2, 0.25, 0.0], 0.5, motion),
            rigid("b", [1.1, 0.2, 0.1], 0.3, motion),
            support("u_start", "a", "clamped"),
            support("u_end", "b", "hinged")
        );
        let series = run(&text);
        let column = |name: &str| series.column(name).unwrap_or_else(|| panic!("no column {name}"));
        let (kinetic, strain) = (column("kinetic"), column("strain"));
        let total = |row: usize| kinetic[row] + strain[row];
        let drift = (0..kinetic.len()).map(|row| (total(row) - total(0)).abs()).fold(0.0, f64::max);
        assert!(drift < tolerance * kinetic[0], "{scheme}: {drift} of {}", kinetic[0]);
        assert!(strain.iter().any(|e| *e > 1e-4 * kinetic[0]), "{scheme}: no strain");
        for name in ["px", "py", "pz", "lx", "ly", "lz"] {
            let values = column(name);
            let size = ["x", "y", "z"].map(|axis| column(&format!("{}{axis}", &name[..1]))[0].abs());
            let size = size.into_iter().fold(0.0, f64::max);
            let off = values.iter().map(|x| (x - values[0]).abs()).fold(0.0, f64::max);
            assert!(off < tolerance * size, "{scheme}, {name}: {off:e} of {size:e}");
        }
    }
}

/// A driven body carries the strip: a slow full turn leaves it unstrained.
#[test]
fn turning_bodies_carry_the_strip() {
    let text = format!(
        "{MATERIAL}{}{}{}[[joints]]\nkind = \"revolute\"\nname = \"axle\"\na = {{ body = \"hub\", at = \"center\" }}\naxis = [1, 2, 3]\n\
         drive = {{ angle = 2 }}\n[[probes]]\nname = \"P\"\non = {{ body = \"s\", at = [1, 1] }}\n[analysis]\nkind = \"statics\"\n",
        strip([3, 2], ""),
        rigid("hub", [-0.3, 0.1, 0.2], 1.0, ""),
        support("u_start", "hub", "clamped")
    );
    let series = run(&text);
    let axis = nalgebra::Unit::new_normalize(nalgebra::Vector3::new(1.0, 2.0, 3.0));
    let center = nalgebra::Vector3::new(-0.3, 0.1, 0.2);
    let turned = nalgebra::Rotation3::from_axis_angle(&axis, 2.0)
        * (nalgebra::Vector3::new(1.0, 0.5, 0.0) - center)
        + center;
    for (k, name) in ["P.x", "P.y", "P.z"].into_iter().enumerate() {
        assert_near(name, last(&series, name), turned[k], 1e-8);
    }
}

#[test]
fn supports_by_other_bodies_are_rejected() {
    let paths = |b: &str, at: &str, condition: &str| -> Vec<String> {
        let text = format!(
            "{MATERIAL}{}{}[[joints]]\nkind = \"support\"\nname = \"j\"\na = {{ body = \"s\", at = {at} }}\nb = {{ body = \"{b}\", at = \"center\" }}\n\
             condition = {condition}\n[[bodies]]\nkind = \"mass\"\nname = \"m\"\ncenter = [1, 0, 0]\nmass = 1\n[analysis]\nkind = \"statics\"\n",
            strip([3, 2], ""),
            rigid("hub", [2.0, 0.0, 0.0], 1.0, ""),
        );
        let errors = Model::parse(&text).map(|_| ());
        errors.err().map_or(Vec::new(), |errors| errors.0.iter().map(|error| error.path.clone()).collect())
    };
    let edge = "{ edge = \"u_end\" }";
    assert_eq!(paths("hub", edge, "\"clamped\""), Vec::<String>::new());
    assert_eq!(paths("m", edge, "\"clamped\""), ["joints[0].b.body"]);
    assert_eq!(paths("hub", "[1, 0]", "\"hinged\""), ["joints[0].a.at"]);
    assert_eq!(paths("hub", edge, "\"symmetry\""), ["joints[0].condition"]);
    assert_eq!(paths("hub", edge, "\"guided\"\naxes = [\"x\"]"), ["joints[0].condition", "joints[0].axes"]);
}
