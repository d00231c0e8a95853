//! Slender bodies, whose first increments stretch the axis: iterations and equilibria at any slenderness and mesh.

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::assert_near;

/// Tip of the elastica with PL²/EI = 10, by elliptic integrals: Bisshopp & Drucker (1945). The digits beyond the sixth are those of
/// a shooting solution of θ″ = −10 cos θ, θ(0) = θ′(1) = 0, by a Runge-Kutta method of fourth order.
const ELASTICA: [f64; 2] = [0.445_004_402_2, -0.810_609_024_9];

/// Most iterations of a load in one increment.
const ITERATIONS: u64 = 30;

/// Cantilever of length 1 with L/d and the load 10 EI/L² at its tip.
fn hook(formulation: &str, slenderness: f64, elements: u32) -> Model {
    let body = match formulation {
        "cable" => "kind = \"cable\"".to_owned(),
        beam => format!("kind = \"beam\", formulation = \"{beam}\""),
    };
    let diameter = 1.0 / slenderness;
    let force = -10.0 * 2e11 * std::f64::consts::PI * diameter.powi(4) / 64.0;
    let text = format!(
        "materials.steel = {{ density = 8000, young = 2e11, poisson = 0.3 }}
        sections.wire = {{ kind = \"circle\", diameter = {diameter} }}
        bodies = [{{ {body}, name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, section = \"wire\", material = \"steel\" }}]
        joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = \"start\" }} }}]
        loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, force = [0, 0, {force:e}] }}]
        probes = [{{ name = \"tip\", on = {{ body = \"b\", at = \"end\" }} }}]
        analysis = {{ kind = \"statics\" }}"
    );
    Model::parse(&text).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Tip, and the number of iterations.
fn tip(model: &Model) -> ([f64; 2], u64) {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (["tip.x", "tip.z"].map(|column| *series.column(column).unwrap().last().unwrap()), summary.iterations)
}

/// The number of iterations does not grow with L/d. The shear and the stretch of the rod are of the order (d/L)².
#[test]
fn a_hook_of_any_slenderness_is_the_elastica() {
    for slenderness in [1e3, 1e4, 1e5] {
        let (found, iterations) = tip(&hook("linked", slenderness, 200));
        let tolerance = 2e-7 + 2.0 / (slenderness * slenderness);
        for (found, expected) in found.into_iter().zip(ELASTICA) {
            assert_near(&format!("L/d = {slenderness}"), found, expected, tolerance);
        }
        assert!(iterations <= ITERATIONS, "L/d = {slenderness}: {iterations} iterations");
    }
}

/// Elements shorter than the diameter: the bounds of the rounding errors exceed the bending of the axis.
#[test]
fn fine_meshes_have_the_same_equilibrium() {
    let [(coarse, _), (fine, iterations)] = [500, 4000].map(|elements| tip(&hook("linked", 2e3, elements)));
    for (fine, coarse) in fine.into_iter().zip(coarse) {
        assert_near("position", fine, coarse, 1e-7);
    }
    assert!(iterations <= ITERATIONS, "{iterations} iterations");
}

#[test]
fn all_formulations_need_few_iterations() {
    for (formulation, elements) in [("quadratic", 60), ("cable", 100)] {
        let (found, iterations) = tip(&hook(formulation, 5e3, elements));
        for (found, expected) in found.into_iter().zip(ELASTICA) {
            assert_near(formulation, found, expected, 2e-6);
        }
        assert!(iterations <= ITERATIONS, "{formulation}: {iterations} iterations");
    }
}

/// Load and stretch of the elastic catenary: length 2 s between supports at the distance 2 x (Irvine 1981, section 1.4).
fn sag([s, x]: [f64; 2], weight: f64, axial: f64) -> f64 {
    let half_span = |h: f64| h * s / axial + h / weight * (weight * s / h).asinh();
    let (mut low, mut high) = (1e-3 * weight * s, 1e3 * weight * s);
    for _ in 0..200 {
        let middle = (low * high).sqrt();
        (low, high) = if half_span(middle) < x { (middle, high) } else { (low, middle) };
    }
    let height = (1.0 + (weight * s / low).powi(2)).sqrt() - 1.0;
    low / weight * height + weight * s * s / (2.0 * axial)
}

/// A slack cable starts as a straight line, without stiffness across it but that of bending. One support moves by a tenth of the length.
#[test]
fn a_slack_cable_finds_its_catenary_in_few_iterations() {
    let area = std::f64::consts::PI * 25e-6;
    let expected = -sag([50.0, 45.0], 1140.0 * 9.81 * area, 2e9 * area);
    for elements in [100, 3000] {
        let text = format!(
            "gravity = [0, 0, -9.81]
            materials.rope = {{ density = 1140, young = 2e9 }}
            sections.rope = {{ kind = \"circle\", diameter = 0.01 }}
            bodies = [{{ kind = \"cable\", name = \"b\", from = [0, 0, 0], to = [100, 0, 0], elements = {elements}, section = \"rope\", material = \"rope\" }}]
            joints = [
                {{ kind = \"spherical\", name = \"left\", a = {{ body = \"b\", at = \"start\" }} }},
                {{ kind = \"spherical\", name = \"right\", a = {{ body = \"b\", at = \"end\" }}, b = {{ point = [90, 0, 0] }} }},
            ]
            probes = [{{ name = \"tip\", on = {{ body = \"b\", at = 50 }} }}]
            analysis = {{ kind = \"statics\", first = 0.1 }}"
        );
        let ([x, z], iterations) = tip(&Model::parse(&text).unwrap());
        assert_near("middle", x, 45.0, 1e-6);
        // The bending stiffness has a share of EI/(H a²), with H and a the force and the radius at the lowest point.
        assert_near("sag", z, expected, 1e-3);
        assert!(iterations <= ITERATIONS, "{elements} elements: {iterations} iterations");
    }
}
