//! Scenes of vibration modes and buckling modes, whose amplitude is arbitrary.

use crate::common::{CANTILEVER, Run, Scene, apart, dot};

/// Displacement of each station of a body in a frame.
fn displacements(scene: &Scene, body: &str, frame: usize) -> Vec<[f64; 3]> {
    let rest = scene.reference(body);
    let moved = scene.centres(body, frame).into_iter().zip(rest);
    moved.map(|(x, y)| std::array::from_fn(|k| x[k] - y[k])).collect()
}

#[test]
fn modes_are_displaced_by_a_tenth_of_the_size() {
    let run = Run::of_file("models/tuning_fork.toml", 1.0, 1);
    let scene = run.scene();
    assert!(scene.frames() >= 2);
    assert_eq!(scene.frames(), run.column("mode").len());
    let size = scene.header["size"].as_f64().unwrap();
    let mut limited = 0;
    for frame in 0..scene.frames() {
        let moved = run.model.bodies.iter().flat_map(|body| displacements(&scene, body.name(), frame));
        let most = moved.fold(0.0, |most: f64, x| most.max(dot(x, x).sqrt()));
        assert!(most / size < 0.102, "mode {frame}: {most} of {size}");
        limited += usize::from(most / size < 0.098);
    }
    // The prongs would cross in a part of the modes only.
    assert!(limited >= 1 && 2 * limited <= scene.frames(), "{limited} of {} modes", scene.frames());
    let labels = scene.header["frames"]["labels"].as_array().unwrap();
    assert!(labels[0].as_str().unwrap().starts_with("mode 1: "));
    assert!(labels[0].as_str().unwrap().ends_with(" Hz"));
    assert!(scene.header["reactions"].as_array().unwrap().is_empty());
}

/// The prongs of the fork keep a part of their gap at both extremes of every mode.
#[test]
fn bodies_of_a_mode_do_not_cross() {
    let run = Run::of_file("models/tuning_fork.toml", 1.0, 1);
    let scene = run.scene();
    let (left, right) = (scene.reference("left"), scene.reference("right"));
    let thickness = 0.005;
    for frame in 0..scene.frames() {
        let (of_left, of_right) =
            (displacements(&scene, "left", frame), displacements(&scene, "right", frame));
        for (x, u) in left.iter().zip(&of_left) {
            for (y, v) in right.iter().zip(&of_right) {
                if (x[1] - y[1]).abs() > 1e-6 {
                    continue;
                }
                for sign in [-1.0, 1.0] {
                    let gap = y[0] + sign * v[0] - x[0] - sign * u[0] - thickness;
                    assert!(gap > 0.0, "mode {frame}: gap {gap} at {x:?}");
                }
            }
        }
    }
}

/// Displacements of a mode have no unit. The largest one is 1.
#[test]
fn displacements_of_modes_are_relative() {
    let scene = Run::of_file("models/tuning_fork.toml", 1.0, 1).scene();
    let field = scene.named("fields", "relative displacement");
    assert_eq!(field["unit"], "");
    for frame in 0..scene.frames() {
        let of =
            |body: &str| scene.field("relative displacement", body, frame).into_iter().fold(0.0, f64::max);
        let largest = ["left", "right", "bow", "stem"].map(of).into_iter().fold(0.0, f64::max);
        assert!((largest - 1.0).abs() < 1e-4, "mode {frame}: {largest}");
    }
}

/// The first modes of a beam with two equal supports are symmetric or antisymmetric about its centre.
#[test]
fn shapes_of_a_symmetric_beam_are_symmetric() {
    let text = CANTILEVER
        .replace("kind = \"statics\"", "kind = \"modes\"\ncount = 4\nabout = \"reference\"")
        .replace(
            "[[loads]]\nkind = \"force\"\non = { body = \"beam\", at = \"end\" }\nforce = [5, -0.003, 0]",
            "",
        )
        + "[[joints]]\nkind = \"clamp\"\nname = \"other\"\na = { body = \"beam\", at = \"end\" }\n";
    let scene = Run::of(&text, 1).scene();
    let size = scene.header["size"].as_f64().unwrap();
    for frame in 0..4 {
        let (at, rest) = (scene.centres("beam", frame), scene.reference("beam"));
        let moved: Vec<[f64; 3]> =
            at.iter().zip(&rest).map(|(x, y)| std::array::from_fn(|k| x[k] - y[k])).collect();
        let count = moved.len();
        for axis in [1, 2] {
            let mirrored = |sign: f64| {
                (0..count).all(|k| (moved[k][axis] - sign * moved[count - 1 - k][axis]).abs() < 1e-4 * size)
            };
            assert!(mirrored(1.0) || mirrored(-1.0), "mode {frame}: {moved:?}");
        }
    }
}

/// Torsion of a shaft: its sections rotate by less than 1 rad, and its axis does not move.
#[test]
fn a_mode_of_torsion_turns_sections() {
    let text = CANTILEVER
        .replace("kind = \"statics\"", "kind = \"modes\"\ncount = 12\nabout = \"reference\"")
        .replace(
            "sections.bar = { kind = \"rectangle\", height = 0.02, width = 0.01 }",
            "sections.bar = { kind = \"circle\", diameter = 0.1 }",
        )
        .replace("elements = 8", "elements = 16");
    let scene = Run::of(&text, 1).scene();
    let twists = (0..scene.frames()).filter(|&frame| {
        let still = scene
            .centres("beam", frame)
            .iter()
            .zip(scene.reference("beam"))
            .all(|(x, y)| apart(*x, y) < 1e-3);
        let [_, y, _] = *scene.directors("beam", frame).last().unwrap();
        let turned = y[1].clamp(-1.0, 1.0).acos();
        still && turned > 0.1 && turned < 1.0
    });
    assert!(twists.count() >= 1);
}

#[test]
fn forms_of_buckling_are_drawn_about_the_straight_column() {
    let run = Run::of_file("models/column.toml", 1.0, 1);
    let scene = run.scene();
    assert_eq!(scene.header["analysis"], "buckling");
    let factor = run.column("factor")[0];
    let label = scene.header["frames"]["labels"][0].as_str().unwrap();
    let shown: f64 = label.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((shown / factor - 1.0).abs() < 1e-3, "{label}");
}
