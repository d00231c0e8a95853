//! Large deformations: ratios of estimated and true errors.

use ancf::estimate::Resolution;

use super::{BODIES, CLAMPED, beam, errors, of};
use crate::common::assertions::{assert_near, assert_relative};

/// Asserts that value + error is nearer to the exact value than the value by a factor.
#[track_caller]
fn assert_better(what: &str, [value, error]: [f64; 2], exact: f64, factor: f64) {
    let (before, after) = ((exact - value).abs(), (exact - value - error).abs());
    assert!(after * factor < before, "{what}: error {before:e}, after the correction {after:e}");
}

fn loaded(force: &str) -> String {
    format!(
        "{CLAMPED}\nloads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, force = {force} }}]"
    )
}

/// Tip deflection of a cantilever with P L²/EI = 10, L/h = 1000: 0.81061 L (Mattiasson 1981, table 1).
#[test]
fn large_deflection_of_a_slender_cantilever() {
    for (body, elements) in [(BODIES[2], 4), (BODIES[3], 2), (BODIES[3], 4), (BODIES[4], 4), (BODIES[4], 8)] {
        let text = beam(body, elements, &loaded("[0, -8.333333333e-4, 0]")).replace("0.02", "0.001");
        let found = errors(&text);
        assert_eq!(found.resolution, Resolution::Good, "{body}");
        let [value, error] = of(&found, "tip.y");
        let what = format!("{body}, {elements} elements");
        // The reference has five digits.
        let (true_error, rounding) = (-0.81061 - value, 5e-6);
        assert_near(&what, error, true_error, 0.1 * true_error.abs() + rounding);
        assert_near(&what, value + error, -0.81061, 5e-4);
    }
}

/// All formulations and meshes estimate the same limit, from errors of 1e-4 to 70 %.
#[test]
fn all_meshes_estimate_the_same_limit() {
    let limit = |body: &str, elements: u32| {
        of(&errors(&beam(body, elements, &loaded("[0, -13.3333333333, 0]"))), "tip.y")
    };
    let [value, error] = limit(BODIES[3], 32);
    let exact = value + error;
    for (body, elements, factor) in [
        (BODIES[1], 4, 15.0),
        (BODIES[1], 8, 80.0),
        (BODIES[1], 16, 80.0),
        (BODIES[2], 1, 15.0),
        (BODIES[2], 4, 80.0),
        (BODIES[2], 8, 80.0),
        (BODIES[3], 1, 15.0),
        (BODIES[3], 4, 30.0),
    ] {
        assert_better(&format!("{body}, {elements} elements"), limit(body, elements), exact, factor);
    }
    // Poisson locking: the computed limit of the mesh is wrong by a quarter.
    let [locked, error] = limit(BODIES[0], 16);
    assert!((locked / exact - 1.0).abs() > 0.2);
    assert_near("continuum", locked + error, exact, 0.1 * (locked - exact).abs());
}

/// Tension N and a tip load: y = P/N (L − tanh(k L)/k), k² = N/EI. The elements are coarser than the boundary layer at the clamp.
#[test]
fn taut_beam_with_a_boundary_layer() {
    // Diameter 0.004, E I = 0.0125664, E A = 12566.
    let inertia = std::f64::consts::PI * 0.002_f64.powi(4) / 4.0;
    let (pull, push) = (30.0, 1e-3);
    let k = (pull / (1e9 * inertia)).sqrt();
    let exact = push / pull * (1.0 + pull / (1e9 * 1.256_637e-5)) * (1.0 - k.tanh() / k);
    for body in &BODIES[1..4] {
        for elements in [1, 2] {
            let text = beam(body, elements, &loaded("[30, 1e-3, 0]")).replace(
                "kind = \"rectangle\", height = 0.02, width = 0.02",
                "kind = \"circle\", diameter = 0.004",
            );
            let found = errors(&text);
            assert_eq!(found.resolution, Resolution::Good, "{body}");
            let [value, error] = of(&found, "tip.y");
            assert_relative(&format!("{body}, {elements}"), value + error, exact, 1e-3);
        }
    }
}

/// Catenary of a cable without bending stiffness between hooks at 0.9 of its length, on meshes with turns up to 1 rad per element.
///
/// Sag of the inextensible catenary: L = 2a sinh(d/2a), f = a (cosh(d/2a) − 1).
#[test]
fn slack_cable_is_a_catenary() {
    let (length, distance) = (1.0_f64, 0.9_f64);
    let mut a = 0.5_f64;
    for _ in 0..60 {
        let x = distance / (2.0 * a);
        let (value, slope) = (2.0 * a * x.sinh() - length, 2.0 * x.sinh() - 2.0 * x * x.cosh());
        a -= value / slope;
    }
    let sag = a * ((distance / (2.0 * a)).cosh() - 1.0);
    let hooks = r#"gravity = [0, -9.81, 0]
        joints = [{ kind = "spherical", name = "l", a = { body = "b", at = "start" }, b = { point = [0.05, 0, 0] } },
          { kind = "spherical", name = "r", a = { body = "b", at = "end" }, b = { point = [0.95, 0, 0] } }]"#;
    for (elements, tolerance) in [(2, 1e-5), (4, 1e-5), (8, 1e-5)] {
        let text = beam(BODIES[4], elements, hooks)
            .replace(
                "kind = \"rectangle\", height = 0.02, width = 0.02",
                "kind = \"circle\", diameter = 0.00001",
            )
            .replace("young = 1e9", "young = 1e11")
            .replace("density = 1000", "density = 1e4")
            .replace("at = \"end\" }\n        [analysis]", "at = 0.5 }\n        [analysis]");
        let [value, error] = of(&errors(&text), "tip.y");
        assert_near(
            &format!("{elements} elements"),
            value + error,
            -sag,
            tolerance + 0.02 * (value + sag).abs(),
        );
    }
}

/// Arch of 90 degrees, clamped, with a load out of its plane: bending and torsion of a curved reference axis.
#[test]
fn curved_beam_bends_and_twists() {
    let arc = |body: &str, elements: u32| {
        let text = beam(body, elements, &loaded("[0, 0, 1]")).replace("to = [1, 0, 0]", "to = [1, 1, 0]");
        of(&errors(&text.replace("name = \"b\"", "name = \"b\"\nshape = { kind = \"arc\", through = [0.7071067811865476, 0.2928932188134524, 0] }")), "tip.z")
    };
    let [value, error] = arc(BODIES[3], 24);
    let exact = value + error;
    for (body, elements, factor) in [
        (BODIES[1], 4, 10.0),
        (BODIES[2], 2, 5.0),
        (BODIES[2], 4, 10.0),
        (BODIES[3], 1, 5.0),
        (BODIES[3], 2, 5.0),
    ] {
        assert_better(&format!("{body}, {elements} elements"), arc(body, elements), exact, factor);
    }
}

/// Cable that is bent in two planes: its sections have no orientation about the axis.
#[test]
fn cable_bent_in_space() {
    let bent = |elements: u32| {
        let loads = r#"loads = [{ kind = "force", on = { body = "b", at = 0.5 }, force = [0, 0, 60] },
            { kind = "force", on = { body = "b", at = "end" }, force = [0, -40, 20] }]"#;
        errors(&beam(BODIES[4], elements, &format!("{loads}\n{CLAMPED}")))
    };
    let fine = bent(32);
    for (column, factor) in [("tip.x", 5.0), ("tip.y", 5.0), ("tip.z", 5.0)] {
        let [value, error] = of(&fine, column);
        for elements in [4, 8] {
            assert_better(
                &format!("{elements}, {column}"),
                of(&bent(elements), column),
                value + error,
                factor,
            );
        }
    }
}

/// A follower force: its stiffness is not symmetric.
#[test]
fn follower_force() {
    let follower = |body: &str, elements: u32| {
        let text =
            beam(body, elements, &loaded("[0, -40, 0]")).replace("force = [0", "follower = true, force = [0");
        of(&errors(&text), "tip.y")
    };
    let [value, error] = follower(BODIES[3], 24);
    let exact = value + error;
    for (body, elements) in [(BODIES[1], 8), (BODIES[2], 2), (BODIES[2], 4), (BODIES[3], 2)] {
        assert_better(&format!("{body}, {elements} elements"), follower(body, elements), exact, 8.0);
    }
}

/// Frame of two beams and a rigid body on hinges with a spring: displacements, section forces within elements, reactions.
#[test]
fn frame_with_joints_and_a_rigid_body() {
    let frame = |formulation: &str, elements: u32| {
        errors(&format!(
            r#"
            materials.m = {{ density = 1000, young = 1e9, poisson = 0.3 }}
            sections.s = {{ kind = "rectangle", height = 0.02, width = 0.03 }}
            bodies = [
              {{ kind = "beam", name = "a", from = [0, 0, 0], to = [0, 1, 0], elements = {elements}, section = "s",
                 material = "m", formulation = "{formulation}" }},
              {{ kind = "beam", name = "b", from = [0, 1, 0], to = [1, 1, 0.2], elements = {elements}, section = "s",
                 material = "m", formulation = "{formulation}" }},
              {{ kind = "rigid", name = "r", center = [1.1, 1.1, 0.2], mass = 1, inertia = [0.01, 0.01, 0.01] }},
            ]
            joints = [
              {{ kind = "clamp", name = "j0", a = {{ body = "a", at = "start" }} }},
              {{ kind = "clamp", name = "j1", a = {{ body = "a", at = "end" }}, b = {{ body = "b", at = "start" }} }},
              {{ kind = "revolute", name = "j2", a = {{ body = "b", at = "end" }}, b = {{ body = "r", at = [1, 1, 0.2] }},
                 axis = [0, 0, 1], spring = {{ stiffness = 20 }} }},
              {{ kind = "point_on_line", name = "j3", a = {{ body = "r", at = [1.2, 1, 0.2] }}, axis = [1, 0, 0] }},
            ]
            loads = [
              {{ kind = "force", on = {{ body = "r", at = [1.2, 1.2, 0.1] }}, force = [4, -6, 2] }},
              {{ kind = "distributed_force", body = "b", force = [0, -15, 5] }},
            ]
            [[probes]]
            name = "p"
            on = {{ body = "r", at = [1.2, 1.2, 0.1] }}
            [[probes]]
            name = "q"
            on = {{ body = "b", at = 0.35 }}
            record = ["motion", "section_forces"]
            [analysis]
            kind = "statics"
            stop = {{ rule = "energy", tolerance = 1e-12 }}
            "#
        ))
    };
    let fine = frame("quadratic", 16);
    for (formulation, elements) in [("linked", 1), ("linked", 2), ("enhanced", 4)] {
        let found = frame(formulation, elements);
        for column in
            ["p.x", "p.y", "q.y", "q.z", "q.N", "q.Qy", "q.My", "j0.mz", "j2.mx", "j2.angle", "j3.fy"]
        {
            let [value, error] = of(&fine, column);
            assert_better(
                &format!("{formulation}, {elements} elements: {column}"),
                of(&found, column),
                value + error,
                2.0,
            );
        }
    }
}
