//! Thin shells on surfaces through points: lofted and swept ones.

use std::f64::consts::{FRAC_PI_2, PI};

use ancf::Model;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

fn shell(surface: &str, elements: [u32; 2]) -> String {
    format!(
        "materials.m = {{ density = 1000, young = 1.2e7, poisson = 0.3 }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\n\
         surface = {{ {surface} }}\nelements = {elements:?}\nthickness = 0.01\nmaterial = \"m\"\n"
    )
}

const CLAMPED: &str = "[[joints]]\nkind = \"support\"\nname = \"root\"\na = { body = \"s\", at = { edge = \"v_start\" } }\n\
                       condition = \"clamped\"\n";

fn solved(surface: &str, elements: [u32; 2]) -> Run {
    let text = shell(surface, elements)
        + CLAMPED
        + "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"v_end\"\nforce = [0.3, 0.2, 1]\n\
           [[probes]]\nname = \"p\"\non = { body = \"s\", at = [0.5, 1] }\n[analysis]\nkind = \"statics\"\n";
    Run::of(&parse(&text))
}

fn arc(radius: f64, count: usize, height: f64) -> Vec<[f64; 3]> {
    let point = |k: usize| {
        let angle = FRAC_PI_2 * k as f64 / count as f64;
        [radius * angle.sin(), height, radius * angle.cos()]
    };
    (0..=count).map(point).collect()
}

/// Curves of points on a cylinder give the displacements of the revolved surface. The error falls with the fourth power of the distance of the points.
#[test]
fn a_loft_through_arcs_is_a_cylinder() {
    let revolved = "kind = \"revolved\", from = [0, 0, 1], to = [0, 1, 1], center = [0, 0, 0], axis = [0, 1, 0], angle = 1.5707963267948966";
    let exact = solved(revolved, [4, 4]);
    let errors = [4, 8].map(|count| {
        let sections = [arc(1.0, count, 0.0), arc(1.0, count, 0.4), arc(1.0, count, 1.0)];
        let series = solved(&format!("kind = \"lofted\", sections = {sections:?}"), [4, 4]);
        let moved = |run: &Run, axis: &str| run.last(&format!("p.{axis}"));
        ["x", "y", "z"]
            .map(|axis| (moved(&series, axis) - moved(&exact, axis)).abs())
            .into_iter()
            .fold(0.0, f64::max)
    });
    assert!(errors[1] < 2e-4 && errors[0] / errors[1] > 6.0, "{errors:?}");
}

/// A line along a circle is a cylinder: its mass is 2π r l h ρ/4. A curve along a line is extruded.
#[test]
fn sweeps_have_the_mass_of_their_surface() {
    let path: Vec<_> = arc(2.0, 16, 0.0);
    let swept = |profile: &str, path: &str| {
        let text = shell(&format!("kind = \"swept\", profile = {profile}, path = {path}"), [4, 8])
            + CLAMPED
            + "[analysis]\nkind = \"statics\"\n";
        parse(&text).mass()
    };
    let cylinder = swept("[[0, 0, 2], [0, 0.5, 2]]", &format!("{path:?}"));
    assert_relative("cylinder", cylinder, PI * 0.5 * 0.01 * 1000.0, 1e-4);
    let flat = swept("[[0, 0, 2], [0, 0, 3]]", &format!("{path:?}"));
    assert_relative("annulus", flat, 0.25 * PI * (9.0 - 4.0) * 0.01 * 1000.0, 1e-4);
    let channel = swept(&format!("{:?}", arc(0.5, 8, 0.0)), "[[0, 0, 0], [0, 3, 0]]");
    assert_relative("channel", channel, 0.5 * FRAC_PI_2 * 3.0 * 0.01 * 1000.0, 1e-4);
}

/// A closed curve has no kink where it closes: its seam keeps smooth tangents.
#[test]
fn closed_curves_are_smooth() {
    let ring = |height: f64, radius: f64| -> Vec<[f64; 3]> {
        let point = |k: usize| {
            let angle = 2.0 * PI * (k % 12) as f64 / 12.0;
            [radius * angle.cos(), radius * angle.sin(), height]
        };
        (0..=12).map(point).collect()
    };
    let sections = [ring(0.0, 1.0), ring(0.5, 1.2), ring(1.0, 1.0)];
    let text = shell(&format!("kind = \"lofted\", sections = {sections:?}"), [16, 2])
        + CLAMPED
        + "[[joints]]\nkind = \"seam\"\nname = \"seam\"\na = { body = \"s\", at = { edge = \"u_start\" } }\n\
           b = { body = \"s\", at = { edge = \"u_end\" } }\n[analysis]\nkind = \"modes\"\ncount = 2\n";
    let run = Run::of(&parse(&text));
    // Modes of a ring are pairs.
    let frequencies = run.column("frequency");
    assert_relative("pair", frequencies[0], frequencies[1], 1e-3);
}

/// Errors of points name the curve and what is expected.
#[test]
fn wrong_points_are_rejected() {
    for (surface, part) in [
        (
            "kind = \"lofted\", sections = [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0], [2, 1, 0]]]",
            "2 points, as in the first curve",
        ),
        ("kind = \"lofted\", sections = [[[0, 0, 0], [1, 0, 0]]]", "sections"),
        ("kind = \"lofted\", sections = [[[0, 0, 0]], [[0, 1, 0]]]", "sections"),
        ("kind = \"lofted\", sections = [[[0, 0, 0], [0, 0, 0]], [[0, 1, 0], [0, 1, 0]]]", "without normal"),
        (
            "kind = \"swept\", profile = [[0, 0, 0], [1, 0, 0]], path = [[0, 0, 0], [0, 0, 0]]",
            "without normal",
        ),
        (
            "kind = \"swept\", profile = [[0, 0, 0], [1, 0, 0]], path = [[0, 0, 0], [1, 0, 0]]",
            "without normal",
        ),
        (
            "kind = \"swept\", profile = [[0, 0, 0], [0, 1, 0]], path = [[1, 0, 0], [0, 0, 1], [-1, 0, 0]]",
            "45 degrees",
        ),
    ] {
        let text = shell(surface, [1, 1]) + CLAMPED + "[analysis]\nkind = \"statics\"\n";
        let error = Model::parse(&text).unwrap_err().to_string();
        assert!(error.contains("bodies[0]") && error.contains(part), "{surface}: {error}");
    }
}
