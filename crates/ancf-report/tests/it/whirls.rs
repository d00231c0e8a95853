//! Scenes and ParaView files of complex shapes: whirls of a shaft in the rotating frame.

use crate::common::{Run, Scene, dot};
use crate::paraview::written;

const SHAFT: &str = r#"
units = { length = "m", time = "s", force = "N" }
materials.steel = { density = 7850, young = 2e11, damping = { strain = 1e-5 } }
sections.round = { kind = "circle", diameter = 0.02 }
bodies = [{ kind = "beam", name = "shaft", from = [0, 0, 0], to = [1, 0, 0], elements = 6, section = "round", material = "steel" }]
joints = [{ kind = "clamp", name = "root", a = { body = "shaft", at = "start" } }]
loads = [{ kind = "base_rotation", angular_velocity = [30, 0, 0] }]
[analysis]
kind = "modes"
about = "equilibrium"
count = 2
damped = true
"#;

fn difference(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| x[k] - y[k])
}

/// Displacements of the shaft in a stored frame.
fn displacements(scene: &Scene, frame: usize) -> Vec<[f64; 3]> {
    let rest = scene.reference("shaft");
    scene.centres("shaft", frame).into_iter().zip(rest).map(|(x, y)| difference(x, y)).collect()
}

/// Asserts that two displacements are radii of a circle about x, from the first to the second by −90° times the sense.
fn assert_circle(real: [f64; 3], imaginary: [f64; 3], sense: f64, tolerance: f64) {
    let turned = [0.0, sense * real[2], -sense * real[1]];
    let apart = difference(imaginary, turned);
    assert!(dot(apart, apart).sqrt() < tolerance, "{imaginary:?} not {turned:?}");
}

#[test]
fn scenes_have_both_parts_of_whirls() {
    let scene = Run::of(SHAFT, 1).scene();
    assert_eq!(scene.frames(), 2);
    assert_eq!(scene.header["frames"]["imaginary"], serde_json::json!([2, 3]));
    let size = scene.header["size"].as_f64().unwrap();
    for (frame, sense) in [(0, 1.0), (1, -1.0)] {
        let [real, imaginary] = [frame, frame + 2].map(|stored| displacements(&scene, stored));
        for (x, y) in real.iter().zip(&imaginary) {
            assert_circle(*x, *y, sense, 1e-4 * size);
        }
        let largest = real.iter().map(|x| dot(*x, *x).sqrt()).fold(0.0, f64::max);
        assert!((largest / size - 0.1).abs() < 1e-3, "{largest} of {size}");
        for stored in [frame, frame + 2] {
            let moved = scene.field("relative displacement", "shaft", stored);
            assert!((moved.last().unwrap() - 1.0).abs() < 1e-4, "{moved:?}");
        }
    }
}

/// Without rotation the modes are real: the scene has no imaginary parts.
#[test]
fn scenes_of_real_shapes_have_one_part() {
    let flat = r#"kind = "rectangle", width = 0.02, height = 0.015"#;
    let text = SHAFT.replace("[30, 0, 0]", "[0, 0, 0]").replace(r#"kind = "circle", diameter = 0.02"#, flat);
    let scene = Run::of(&text, 1).scene();
    assert_eq!(scene.frames(), 2);
    assert!(scene.header["frames"]["imaginary"].is_null());
}

#[test]
fn paraview_files_have_both_parts_of_whirls() {
    for ((_, grid), sense) in written(&Run::of(SHAFT, 1), "lines").iter().zip([1.0, -1.0]) {
        for (x, y) in grid.vectors("shape").into_iter().zip(grid.vectors("shape_imaginary")) {
            assert_circle(x, y, sense, 1e-4);
        }
    }
}
