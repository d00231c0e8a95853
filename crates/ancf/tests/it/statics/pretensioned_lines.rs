//! Lines of pretensioned cables that ball joints connect have stiffness across by their tension only.

use crate::common::models::parse;
use crate::common::solutions::Run;

const TENSION: f64 = 500.0;
const DIAMETER: f64 = 0.01;
const DENSITY: f64 = 1000.0;
const GRAVITY: f64 = 9.81;

/// Line of cables of 1 m along a direction in the horizontal plane, under its weight.
fn line(count: usize, direction: [f64; 2]) -> Run {
    let at = |k: usize| format!("[{}, {}, 0]", k as f64 * direction[0], k as f64 * direction[1]);
    let cable = |k: usize| {
        format!(
            "{{ kind = \"cable\", name = \"c{k}\", from = {}, to = {}, elements = 2, section = \"s\", material = \"m\" }}",
            at(k),
            at(k + 1)
        )
    };
    let knot = |k: usize| {
        format!(
            "{{ kind = \"spherical\", name = \"j{k}\", a = {{ body = \"c{k}\", at = \"start\" }}, b = {{ body = \"c{}\", at = \"end\" }} }}",
            k - 1
        )
    };
    let tension = |k: usize| format!("{{ kind = \"prestrain\", body = \"c{k}\", tension = {TENSION} }}");
    let list =
        |of: &dyn Fn(usize) -> String, from: usize| (from..count).map(of).collect::<Vec<_>>().join(",\n");
    Run::of(&parse(&format!(
        "gravity = [0, 0, -{GRAVITY}]
        materials.m = {{ density = {DENSITY}, young = 1e9 }}
        sections.s = {{ kind = \"circle\", diameter = {DIAMETER} }}
        bodies = [{}]
        joints = [
            {{ kind = \"spherical\", name = \"first\", a = {{ body = \"c0\", at = \"start\" }} }},
            {{ kind = \"spherical\", name = \"last\", a = {{ body = \"c{}\", at = \"end\" }} }},
            {}
        ]
        loads = [{}]
        probes = [{{ name = \"middle\", on = {{ body = \"c{}\", at = \"start\" }} }}]
        initial.from = \"equilibrium\"
        analysis = {{ kind = \"dynamics\", duration = 1e-3, step = 1e-3 }}",
        list(&cable, 0),
        count - 1,
        list(&knot, 1),
        list(&tension, 0),
        count / 2,
    )))
}

/// Sag w L²/(8 T) of a taut line of the weight w per length; the tension of the deflected line is larger by EA w² L²/(24 T²).
#[test]
fn pretension_supports_lines() {
    let area = std::f64::consts::FRAC_PI_4 * DIAMETER * DIAMETER;
    for (count, direction) in [(2, [1.0, 0.0]), (8, [1.0, 0.0]), (8, [0.6, 0.8]), (32, [1.0, 0.0])] {
        let (w, length) = (DENSITY * area * GRAVITY, count as f64);
        // The tension T solves T = T₀ + EA (w L/T)²/24.
        let tension =
            (0..100).fold(TENSION, |t, _| 0.5 * (t + TENSION + 1e9 * area * (w * length / t).powi(2) / 24.0));
        let expected = -w * length * length / (8.0 * tension);
        let sag = line(count, direction).last("middle.z");
        assert!((sag / expected - 1.0).abs() < 1e-3, "{count} cables: {sag}, not {expected}");
    }
}
