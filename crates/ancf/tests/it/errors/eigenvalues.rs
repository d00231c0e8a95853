//! Frequencies and critical load factors: ratios of estimated and true errors.

use std::f64::consts::{PI, TAU};

use ancf::estimate::{DiscretisationErrors, Resolution};
use ancf::record::Series;
use ancf::simulate;

use super::{BODIES, CLAMPED, beam, errors, of};
use crate::common::assertions::assert_relative;
use crate::common::models::parse;

/// E I and E A of the beam of [`beam`], and its mass per length.
const BENDING: f64 = 1e9 * 0.02 * 0.02 * 0.02 * 0.02 / 12.0;
const AXIAL: f64 = 1e9 * 0.02 * 0.02;
const MASS: f64 = 1000.0 * 0.02 * 0.02;

const PINNED: &str = r#"joints = [{ kind = "spherical", name = "l", a = { body = "b", at = "start" } },
    { kind = "point_on_line", name = "r", a = { body = "b", at = "end" }, axis = [1, 0, 0] }]"#;

/// Model with another analysis.
fn analysed(body: &str, elements: u32, rest: &str, analysis: &str) -> String {
    let statics = "kind = \"statics\"\n        stop = { rule = \"energy\", tolerance = 1e-12 }";
    beam(body, elements, rest).replace(statics, analysis)
}

fn modes(body: &str, elements: u32, rest: &str) -> DiscretisationErrors {
    errors(&analysed(body, elements, rest, "kind = \"modes\"\ncount = 8"))
}

fn modes_under_load(body: &str, elements: u32, rest: &str) -> DiscretisationErrors {
    errors(&analysed(body, elements, rest, "kind = \"modes\"\nabout = \"equilibrium\"\ncount = 4"))
}

fn buckling(body: &str, elements: u32, rest: &str) -> DiscretisationErrors {
    errors(&analysed(body, elements, rest, "kind = \"buckling\"\ncount = 2"))
}

/// Asserts that the ratio of the estimated and the true error is within 0.8 and 1.25.
#[track_caller]
fn assert_effective(what: &str, [value, error]: [f64; 2], exact: f64) {
    let effectivity = error / (exact - value);
    assert!((0.8..1.25).contains(&effectivity), "{what}: {value} + {error} for {exact}: {effectivity}");
}

fn load(force: &str) -> String {
    format!("loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, force = {force} }}]\n")
}

/// Bernoulli-Euler cantilever: ω = β² √(EI/ρA)/L², cos β cosh β = −1.
#[test]
fn frequencies_of_a_cantilever() {
    let exact = |beta: f64| beta * beta * (BENDING / MASS).sqrt() / TAU;
    for elements in [1, 2, 4, 8] {
        let found = modes(BODIES[4], elements, CLAMPED);
        assert_eq!(found.resolution, Resolution::Good);
        assert_effective(&format!("{elements}"), of(&found, "frequency[1]"), exact(1.875_104_068_711_961));
        if elements > 1 {
            assert_effective(
                &format!("{elements}"),
                of(&found, "frequency[3]"),
                exact(4.694_091_132_974_175),
            );
        }
    }
}

/// All formulations and meshes estimate the same frequencies in bending, also with shear and Poisson locking. The first mode of the
/// hinged beam is its rotation about its axis.
#[test]
fn frequencies_of_all_formulations() {
    for (supports, number) in [(CLAMPED, 1), (CLAMPED, 3), (PINNED, 2)] {
        let column = format!("frequency[{number}]");
        let [value, error] = of(&modes(BODIES[3], 24, supports), &column);
        for (body, elements) in [(0, 4), (0, 8), (1, 2), (1, 4), (1, 16), (2, 2), (2, 4), (3, 2), (3, 8)] {
            let found = modes(BODIES[body], elements, supports);
            let what = format!("{}, {elements}, {column}", BODIES[body]);
            assert_effective(&what, of(&found, &column), value + error);
        }
    }
}

/// Torsion of a clamped rod: ω = π/2 √(GJ/ρI_p)/L, J = 0.140577 h⁴; axial vibration: ω = π/2 √(E/ρ)/L.
#[test]
fn torsion_and_axial_vibration() {
    let torsion = (1e9_f64 / 2.6 * 0.140_577 / (1000.0 / 6.0)).sqrt() / 4.0;
    let axial = (1e9_f64 / 1000.0).sqrt() / 4.0;
    for body in &BODIES[2..4] {
        let found = errors(&analysed(body, 4, CLAMPED, "kind = \"modes\"\ncount = 16"));
        for exact in [torsion, axial] {
            let near = |[value, _]: &[f64; 2]| (value / exact - 1.0).abs() < 0.05;
            let values = found.values.iter().map(|value| [value.value, value.error]).find(near);
            let [value, error] = values.unwrap_or_else(|| panic!("{body}: no frequency {exact}: {found:?}"));
            assert_relative(body, value + error, exact, 0.1 * (value / exact - 1.0).abs() + 1e-5);
        }
    }
}

/// Hinged beam under an axial force N: ω_n = (nπ/L)² √(EI/ρA) √(1 + N L²/n²π²EI), stretched by N/EA.
#[test]
fn frequencies_under_axial_force() {
    let critical = PI * PI * BENDING;
    for force in [-0.9 * critical, -0.5 * critical, 0.5 * critical] {
        let length = 1.0 + force / AXIAL;
        let exact = |n: f64| {
            let bending = (n * PI / length).powi(2) * BENDING * length;
            let along = force + bending / length;
            (n / (2.0 * length)) * (along / (MASS / length)).sqrt()
        };
        for elements in [2, 4] {
            let text = load(&format!("[{force}, 0, 0]")) + PINNED;
            let found = modes_under_load(BODIES[4], elements, &text);
            // The bending stiffness refers to the stretched length to the order of the strain.
            let [value, error] = of(&found, "frequency[1]");
            let difference = (value - exact(1.0)).abs();
            let what = format!("{force}, {elements}: {value} + {error}");
            let strain = 4.0 * force.abs() / AXIAL * value / (1.0 + force / critical);
            assert!((value + error - exact(1.0)).abs() < 0.2 * difference + strain, "{what}, {}", exact(1.0));
        }
    }
}

/// Cantilever with a large deflection: the error of the equilibrium changes the frequencies, in and out of its plane.
#[test]
fn frequencies_about_a_large_deflection() {
    let bent = |body: &str, elements: u32| modes_under_load(body, elements, &(load("[0, -40, 0]") + CLAMPED));
    for bodies in [&BODIES[2..4], &BODIES[4..5]] {
        let fine = bent(bodies[bodies.len() - 1], 24);
        for column in ["frequency[1]", "frequency[2]", "frequency[3]"] {
            let [value, error] = of(&fine, column);
            for body in bodies {
                assert_effective(&format!("{body}, {column}"), of(&bent(body, 6), column), value + error);
            }
        }
    }
}

/// Euler's column π² EI/4L², and a column under its own weight, 7.837347 EI/L² (Greenhill 1881).
#[test]
fn critical_loads_of_columns() {
    let euler = load("[-1, 0, 0]") + CLAMPED;
    let weight = format!("gravity = [-1, 0, 0]\n{CLAMPED}");
    for (rest, exact) in [(&euler, PI * PI * BENDING / 4.0), (&weight, 7.837_347 * BENDING / MASS)] {
        for elements in [2, 4] {
            let found = buckling(BODIES[4], elements, rest);
            assert_effective(&format!("cable, {elements}"), of(&found, "factor[1]"), exact);
        }
        let [value, error] = of(&buckling(BODIES[3], 16, rest), "factor[1]");
        // Shear, P/kGA, and compression, P/EA.
        assert_relative("quadratic", value + error, exact, 1e-3);
        for (body, elements) in [(0, 4), (0, 8), (1, 2), (1, 4), (1, 8), (3, 1), (3, 2)] {
            let found = buckling(BODIES[body], elements, rest);
            assert_effective(
                &format!("{}, {elements}", BODIES[body]),
                of(&found, "factor[1]"),
                value + error,
            );
        }
    }
}

/// Rigid modes, modes above half the number of degrees of freedom, and modes of distorted sections have no estimate.
#[test]
fn modes_without_estimate() {
    let text = analysed(BODIES[1], 1, "", "kind = \"modes\"\ncount = 24");
    let mut series = Series::new();
    let summary = simulate(&parse(&text), &mut series).unwrap();
    let found = summary.errors.unwrap();
    let errors = series.column("frequency_error").unwrap();
    let known: Vec<usize> = (0..24).filter(|&row| errors[row].is_finite()).collect();
    assert!(known.iter().all(|&row| (6..12).contains(&row)) && !known.is_empty(), "{known:?}");
    assert_eq!(found.values.len(), known.len());
}

/// Loads that bend the structure before it buckles.
#[test]
fn buckling_of_a_bent_structure_is_unknown() {
    let text = load("[0, -1, 0]") + CLAMPED;
    let text = analysed(BODIES[3], 4, &text, "kind = \"buckling\"")
        .replace("height = 0.02, width = 0.02", "height = 0.04, width = 0.002");
    let found = errors(&text);
    assert_eq!(found.resolution, Resolution::Unknown);
    assert!(found.values.is_empty());
}

/// The frame and the units have no effect.
#[test]
fn eigenvalues_are_independent_of_frame_and_units() {
    let text = analysed(BODIES[1], 3, CLAMPED, "kind = \"modes\"\ncount = 3");
    let of_text = |text: &str| {
        let [value, error] = of(&errors(text), "frequency[3]");
        error / value
    };
    let base = of_text(&text);
    let turned = text.replace("to = [1, 0, 0]", "to = [0.48, 0.64, 0.6]");
    assert_relative("turned", of_text(&turned), base, 1e-5);
    // Millimetres and tonnes.
    let small = text
        .replace("to = [1, 0, 0]", "to = [1000, 0, 0]")
        .replace("0.02", "20")
        .replace("density = 1000", "density = 1e-9")
        .replace("young = 1e9", "young = 1e3");
    assert_relative("units", of_text(&small), base, 1e-5);
}
