//! Surfaces of rigid bodies in scenes.

use crate::common::Run;

/// Pendulum of a plate with its hinge off the centre of mass.
fn pendulum(display: &str) -> String {
    format!(
        "gravity = [0, -10, 0]
        bodies = [{{ kind = \"rigid\", name = \"plate\", center = [1, 0, 0], mass = 1, inertia = [1, 2, 3], {display} }}]
        joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"plate\", at = [0, 0, 0] }}, axis = [0, 0, 1] }}]
        analysis = {{ kind = \"dynamics\", duration = 0.2, step = 0.05, scheme = {{ spectral_radius = 0.8 }} }}"
    )
}

#[test]
fn a_display_shape_takes_the_place_of_the_box_and_the_arms() {
    let with =
        Run::of(&pendulum("display = [{ kind = \"box\", edges = [2, 0.5, 0.25], center = [1.5, 0, 0] }]"), 1);
    let scene = with.scene();
    let body = scene.named("bodies", "plate");
    let [points, normals, corners] =
        ["points", "normals", "corners"].map(|key| scene.numbers(&body["surface"][key]));
    assert_eq!((points.len(), normals.len(), corners.len()), (3 * 24, 3 * 24, 3 * 12));
    for (point, normal) in points.chunks_exact(3).zip(normals.chunks_exact(3)) {
        // The centre of the box is 0.5 beyond the centre of mass.
        let arm = [point[0] - 0.5, point[1], point[2]];
        assert_eq!(arm.map(f64::abs), [1.0, 0.25, 0.125]);
        let along = (0..3).find(|&k| normal[k].abs() == 32767.0).unwrap();
        assert!(arm[along] * normal[along] > 0.0, "{point:?}: {normal:?}");
    }
    assert_eq!(body["box"], serde_json::json!([1.5, 0.25, 0.125]));
    assert!(scene.header["links"].as_array().unwrap().is_empty());

    let without = Run::of(&pendulum(""), 1).scene();
    assert!(without.named("bodies", "plate")["surface"].is_null());
    assert_eq!(without.header["links"][0]["kind"], "arm");
}

/// Directors of a body with a surface are its own axes, not its principal axes.
#[test]
fn a_surface_refers_to_the_axes_of_the_body() {
    let display = "products = [0.3, 0, 0], display = [{ kind = \"sphere\", radius = 0.1 }]";
    let scene = Run::of(&pendulum(display), 1).scene();
    let rest = scene.numbers(&scene.header["reference"]["directors"]);
    assert_eq!(rest, [32767.0, 0.0, 0.0, 0.0, 32767.0, 0.0, 0.0, 0.0, 32767.0]);
}

#[test]
fn a_point_mass_with_a_contact_surface_has_its_radius() {
    let text = "bodies = [{ kind = \"mass\", name = \"ball\", center = [0, 0, 0], mass = 1, surface = { radius = 0.3 } }]
        analysis = { kind = \"dynamics\", duration = 0.2, step = 0.05, scheme = { spectral_radius = 0.8 } }";
    let scene = Run::of(text, 1).scene();
    assert_eq!(scene.named("bodies", "ball")["box"], serde_json::json!([0.3, 0.3, 0.3]));
}
