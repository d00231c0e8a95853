//! Modes and forms of buckling, which have no size of their own.

use crate::common::{CANTILEVER, Run, apart};

#[test]
fn modes_are_displaced_by_a_tenth_of_the_size() {
    let run = Run::of_file("models/tuning_fork.toml", 1.0, 1);
    let scene = run.scene();
    assert!(scene.frames() >= 2);
    assert_eq!(scene.frames(), run.column("mode").len());
    let size = scene.header["size"].as_f64().unwrap();
    for frame in 0..scene.frames() {
        let moved = run.model.bodies.iter().flat_map(|body| {
            let at = scene.centres(body.name(), frame);
            at.into_iter().zip(scene.reference(body.name())).map(|(x, y)| apart(x, y)).collect::<Vec<_>>()
        });
        let most = moved.fold(0.0, f64::max);
        assert!((most / size - 0.1).abs() < 2e-3, "mode {frame}: {most} of {size}");
    }
    let labels = scene.header["frames"]["labels"].as_array().unwrap();
    assert!(labels[0].as_str().unwrap().starts_with("mode 1: "));
    assert!(labels[0].as_str().unwrap().ends_with(" Hz"));
    assert!(scene.header["reactions"].as_array().unwrap().is_empty());
}

/// The first forms of a beam on two equal supports are symmetric and antisymmetric about its middle.
#[test]
fn shapes_of_a_symmetric_beam_are_symmetric() {
    let text = CANTILEVER
        .replace("kind = \"statics\"", "kind = \"modes\"\ncount = 4\nabout = \"reference\"")
        .replace(
            "[[loads]]\nkind = \"force\"\non = { body = \"beam\", at = \"end\" }\nforce = [5, -0.003, 0]",
            "",
        )
        + "[[joints]]\nkind = \"clamp\"\nname = \"other\"\na = { body = \"beam\", at = \"end\" }\n";
    // Keys of the analysis come before other tables.
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

/// A shaft that only twists: its sections are seen to turn, by less than a radian, and its axis stays.
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
