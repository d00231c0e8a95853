//! Shear stress and equivalent stress of sections under a torque, a shear force and a bending moment.

use std::f64::consts::PI;

use crate::common::{CANTILEVER, Run};

const LENGTH: f64 = 2.0;
const TORQUE: f64 = 0.03;
const FORCE: f64 = 0.02;

/// Cantilever with a section, a torque and a transverse force along y at its end.
fn scene_of(section: &str) -> crate::common::Scene {
    let text = CANTILEVER
        .replace("kind = \"rectangle\", height = 0.02, width = 0.01", section)
        .replace("force = [5, -0.003, 0]", &format!("force = [0, {FORCE}, 0]"))
        .replace(
            "[[probes]]",
            &format!(
                "[[loads]]\nkind = \"moment\"\non = {{ body = \"beam\", at = \"end\" }}\nmoment = [{TORQUE}, 0, 0]\n[[probes]]"
            ),
        );
    Run::of(&text, 1).scene()
}

/// Value at the clamp in the last frame.
fn at_root(scene: &crate::common::Scene, field: &str) -> f64 {
    scene.field(field, "beam", scene.frames() - 1)[0]
}

fn assert_near(name: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{name}: {found}, expected {expected}");
}

#[test]
fn stresses_of_a_shaft_are_those_of_the_handbook() {
    let d: f64 = 0.02;
    let scene = scene_of(&format!("kind = \"circle\", diameter = {d}"));
    let torsion = 16.0 * TORQUE / (PI * d.powi(3));
    let transverse = 4.0 / 3.0 * FORCE / (PI * d * d / 4.0);
    let bending = 32.0 * FORCE * LENGTH / (PI * d.powi(3));
    assert_near("shear stress", at_root(&scene, "shear stress"), torsion + transverse, 2e-3);
    let equivalent = (bending.powi(2) + 3.0 * torsion.powi(2)).sqrt();
    assert_near("von Mises stress", at_root(&scene, "von Mises stress"), equivalent, 2e-3);
    assert_eq!(scene.named("fields", "von Mises stress")["unit"], "N/m²");
    assert_eq!(scene.named("fields", "shear stress")["diverging"], false);
}

/// Thin tube: 2 Q/A and T/(2π r² t) in the limit.
#[test]
fn shear_stress_of_a_thin_tube_is_that_of_a_thin_wall() {
    let (radius, wall) = (0.02, 1e-4);
    let (outer, inner) = (2.0 * radius + wall, 2.0 * radius - wall);
    let scene = scene_of(&format!("kind = \"tube\", outer = {outer}, inner = {inner}"));
    let expected = TORQUE / (2.0 * PI * radius * radius * wall) + 2.0 * FORCE / (2.0 * PI * radius * wall);
    assert_near("shear stress", at_root(&scene, "shear stress"), expected, 1e-2);
}

/// Torsion of rectangles with sides a ≥ b: T/(k a b²), k = 0.208 of a square and 0.246 of a/b = 2.
///
/// Source: Timoshenko & Goodier (1970), table of section 109.
#[test]
fn shear_stress_of_rectangles_has_the_factors_of_the_table() {
    for (a, b, k) in [(0.02, 0.02, 0.208), (0.02, 0.01, 0.246), (0.1, 0.01, 0.312)] {
        let scene = scene_of(&format!("kind = \"rectangle\", height = {a}, width = {b}"));
        let expected = TORQUE / (k * a * b * b) + 1.5 * FORCE / (a * b);
        assert_near("shear stress", at_root(&scene, "shear stress"), expected, 5e-3);
    }
}
