//! Small loads: value + error is the closed form of a Timoshenko beam on any mesh, also with locking.

use super::{BODIES, CLAMPED, beam, errors, of};
use crate::common::assertions::assert_relative;

const EI: f64 = 1e9 * 0.02 * 0.02 * 0.02 * 0.02 / 12.0;
const SHEAR: f64 = 1e9 / 2.6 * 0.02 * 0.02;

/// Shear factor of a rectangle, 10 (1 + ν)/(12 + 11 ν); a cable has no shear.
fn shear_compliance(body: &str) -> f64 {
    if body.contains("cable") { 0.0 } else { 1.0 / (SHEAR * 10.0 * 1.3 / (12.0 + 11.0 * 0.3)) }
}

/// P L³/3EI + P L/kGA at the tip, P/2 (x² − x³/3)/EI + P x/kGA at a point within an element.
#[test]
fn tip_load_on_any_mesh() {
    let load = r#"loads = [{ kind = "force", on = { body = "b", at = "end" }, force = [0, 1e-4, 0] }]"#;
    for body in BODIES {
        for elements in [1, 2, 5] {
            let probe = r#"[[probes]]
                name = "inner"
                on = { body = "b", at = 0.3 }"#;
            let text = beam(body, elements, &format!("{CLAMPED}\n{load}"))
                .replace("[analysis]", &format!("{probe}\n[analysis]"));
            let found = errors(&text);
            for (column, x) in [("tip.y", 1.0_f64), ("inner.y", 0.3)] {
                let exact = 1e-4 * (x * x * (3.0 - x) / (6.0 * EI) + x * shear_compliance(body));
                let [value, error] = of(&found, column);
                assert_relative(
                    &format!("{body}, {elements} elements: {column}"),
                    value + error,
                    exact,
                    1e-6,
                );
            }
        }
    }
}

/// q x² (6 − 4x + x²)/24EI + q (x − x²/2)/kGA under a line load and under weight.
#[test]
fn uniform_loads_on_any_mesh() {
    let line = r#"loads = [{ kind = "distributed_force", body = "b", force = [0, 1e-4, 0] }]"#;
    let weight = "gravity = [0, 2.5e-4, 0]";
    for body in BODIES {
        for load in [line, weight] {
            for elements in [1, 3] {
                let [value, error] =
                    of(&errors(&beam(body, elements, &format!("{load}\n{CLAMPED}"))), "tip.y");
                let exact = 1e-4 * (1.0 / (8.0 * EI) + 0.5 * shear_compliance(body));
                assert_relative(&format!("{body}, {elements} elements, {load}"), value + error, exact, 1e-6);
            }
        }
    }
}

/// P a² (3 − a)/6EI + P a/kGA: the load acts within an element.
#[test]
fn point_load_within_an_element() {
    let load = r#"loads = [{ kind = "force", on = { body = "b", at = 0.4 }, force = [0, 1e-4, 0] }]"#;
    for body in BODIES {
        for elements in [1, 2, 4] {
            let [value, error] = of(&errors(&beam(body, elements, &format!("{CLAMPED}\n{load}"))), "tip.y");
            let exact = 1e-4 * (0.16 * 2.6 / (6.0 * EI) + 0.4 * shear_compliance(body));
            assert_relative(&format!("{body}, {elements} elements"), value + error, exact, 1e-6);
        }
    }
}

/// The reaction of a propped cantilever under a line load is 3qL/8 (1 + 4s)/(1 + 3s), s = EI/(kGA L²).
///
/// The structure is redundant, so the stiffness of the elements enters: the estimate is exact to second order of the errors.
#[test]
fn reaction_of_a_redundant_support() {
    let load = r#"loads = [{ kind = "distributed_force", body = "b", force = [0, 1e-4, 0] }]
        joints = [{ kind = "clamp", name = "root", a = { body = "b", at = "start" } },
          { kind = "point_on_line", name = "prop", a = { body = "b", at = "end" }, axis = [1, 0, 0] }]"#;
    for (body, elements) in [(1, 2), (1, 4), (1, 8), (2, 1), (2, 2), (3, 1), (3, 2)] {
        let body = BODIES[body];
        let [value, error] = of(&errors(&beam(body, elements, load)), "prop.fy");
        let s = EI * shear_compliance(body);
        let exact = -3e-4 / 8.0 * (1.0 + 4.0 * s) / (1.0 + 3.0 * s);
        let (before, after) = (value / exact - 1.0, (value + error) / exact - 1.0);
        assert!(
            after.abs() < 1e-6 + 3.0 * before * before,
            "{body}, {elements}: {before:e} becomes {after:e}"
        );
    }
}

/// The end rotation is T L/GJ: the Euler parameter e₁ = sin(φ/2) of a small end rotation.
#[test]
fn torsion_on_any_mesh() {
    let load = r#"loads = [{ kind = "moment", on = { body = "b", at = "end" }, moment = [1e-4, 0, 0] }]"#;
    // J = 0.14058 a⁴ for a square of side a (Timoshenko & Goodier 1970, article 109).
    let exact = 0.5e-4 / (1e9 / 2.6 * 0.140_577_0 * 0.02_f64.powi(4));
    for body in &BODIES[..4] {
        for elements in [1, 3] {
            let text = beam(body, elements, &format!("{CLAMPED}\n{load}"));
            let text = text.replace("[analysis]", "record = [\"rotation\"]\n[analysis]");
            let [value, error] = of(&errors(&text), "tip.e1");
            assert_relative(&format!("{body}, {elements} elements"), value + error, exact, 2e-6);
        }
    }
}
