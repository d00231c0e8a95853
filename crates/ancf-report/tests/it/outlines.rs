//! Bodies, links and obstacles in a scene have the shapes of the model.

use std::f64::consts::PI;

use crate::common::{CANTILEVER, Run, apart, dot, tapered, three};

#[test]
fn outlines_go_about_the_axis_and_their_normals_point_outwards() {
    let kinds = [
        r#"kind = "circle", diameter = 0.1"#,
        r#"kind = "tube", outer = 0.1, inner = 0.08"#,
        r#"kind = "rectangle", height = 0.1, width = 0.05"#,
        r#"kind = "ellipse", height = 0.1, width = 0.05"#,
        r#"kind = "general", area = 0.01, iy = 1e-6, iz = 4e-6"#,
    ];
    for kind in kinds {
        let text = CANTILEVER.replace("kind = \"rectangle\", height = 0.02, width = 0.01", kind);
        let scene = Run::of(&text, 1).scene();
        let body = scene.named("bodies", "beam");
        let points =
            |key: &str| -> Vec<Vec<f64>> { serde_json::from_value(body[key].clone()).unwrap_or_default() };
        let (outer, inner) = (points("outline"), points("inner"));
        let area = |points: &[Vec<f64>]| -> f64 {
            (0..points.len())
                .map(|k| (&points[k], &points[(k + 1) % points.len()]))
                .map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0]))
                .sum()
        };
        assert!(area(&outer) > 0.0, "counter-clockwise");
        for p in &outer {
            assert!(p[0] * p[2] + p[1] * p[3] > 0.0, "outwards");
            assert!((p[2].hypot(p[3]) - 1.0).abs() < 1e-12);
        }
        assert!(inner.iter().all(|p| p[0] * p[2] + p[1] * p[3] > 0.0), "away from the axis");
        assert_eq!(inner.is_empty(), !kind.contains("tube"));
        // A polygon with 24 sides has 0.9886 of the area of its circle.
        let expected = match kind {
            _ if kind.contains("circle") || kind.contains("tube") => PI * 0.0025,
            _ if kind.contains("rectangle") => 0.005,
            _ if kind.contains("ellipse") => PI * 0.05 * 0.025,
            _ => 4.0 * PI * (1e-4_f64 * 4e-4).sqrt(),
        };
        assert!((area(&outer) / expected - 1.0).abs() < 0.012, "{kind}");
    }
}

#[test]
fn tapers_have_scales() {
    let scene = Run::of(&tapered(), 1).scene();
    let scale = scene.numbers(&scene.named("bodies", "beam")["scale"]);
    let count = scale.len() / 2;
    for k in 0..count {
        let part = k as f64 / (count - 1) as f64;
        assert!((scale[2 * k] - (1.0 - 0.5 * part)).abs() < 1e-6);
        assert!((scale[2 * k + 1] - 1.0).abs() < 1e-6);
    }
}

/// The box of a rigid brick below the maximum size is the brick.
#[test]
fn rigid_bodies_are_boxes_of_their_inertia() {
    let (m, a, b, c) = (2.0, 0.3_f64, 0.2_f64, 0.1_f64);
    let inertia = [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| m * x / 12.0);
    let text = format!(
        "[[bodies]]\nkind = \"rigid\"\nname = \"brick\"\ncenter = [0, 0, 0]\nmass = {m}\ninertia = {inertia:?}\n\
         motion = {{ spin = [0, 0, 1] }}\n\
         [[bodies]]\nkind = \"mass\"\nname = \"far\"\ncenter = [10, 0, 0]\nmass = 1\n\
         [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 1e-2\n"
    );
    let run = Run::of(&text, 1);
    let scene = run.scene();
    let half: [f64; 3] = serde_json::from_value(scene.named("bodies", "brick")["box"].clone()).unwrap();
    for (half, edge) in half.iter().zip([a, b, c]) {
        assert!((2.0 * half / edge - 1.0).abs() < 1e-9, "{half:?}");
    }
    // Rotation by 0.5 rad.
    let [x, ..] = scene.directors("brick", scene.frames() - 1)[0];
    assert!((x[1].atan2(x[0]) - 0.5).abs() < 2e-3, "{x:?}");
    assert_eq!(scene.named("bodies", "far")["kind"], "point");
}

#[test]
fn rods_end_where_their_lengths_say() {
    let run = Run::of_file("crates/ancf/tests/models/good/joints.toml", 0.2, 2);
    let scene = run.scene();
    let expected = [("distance", "rod"), ("bushing", "bushing"), ("spring", "spring")];
    let mut checked = 0;
    for joint in &run.model.joints {
        let marker = scene.named("markers", joint.name());
        let kinds = expected.iter().filter(|(detail, _)| marker["detail"] == *detail);
        for (_, kind) in kinds {
            let links = scene.header["links"].as_array().unwrap();
            let link = links.iter().find(|link| link["name"] == joint.name()).expect("a link");
            let rope = kind == &"spring" && ["rope", "damper"].iter().any(|other| link["kind"] == *other);
            assert!(link["kind"] == *kind || rope);
            let ends = scene.numbers(&link["ends"]);
            let at = scene.numbers(&marker["at"]);
            for frame in 0..scene.frames() {
                let end = three(&ends[6 * frame..]);
                assert!(apart(end, three(&at[3 * frame..])) < 1e-6, "the symbol is at end a");
                let Some(lengths) = run.series.column(&format!("{}.length", joint.name())) else { continue };
                let drawn = apart(end, three(&ends[6 * frame + 3..]));
                assert!((drawn - lengths[2 * frame]).abs() < 1e-5, "{drawn}");
                checked += 1;
            }
        }
    }
    assert!(checked >= 2, "{checked}");
}

/// An obstacle moves with the body that carries it.
#[test]
fn obstacles_follow_what_carries_them() {
    let run = Run::of_file("models/belt.toml", 0.2, 20);
    let scene = run.scene();
    let wheel = &scene.header["obstacles"][0];
    assert_eq!(wheel["kind"], "cylinder");
    let poses = scene.numbers(&wheel["pose"]);
    assert_eq!(poses.len(), 12 * scene.frames());
    let carrier = scene.centres("pulley", 0);
    for pose in poses.chunks_exact(12) {
        assert!((dot(three(&pose[3..6]), three(&pose[3..6])) - 1.0).abs() < 1e-6);
        assert!(apart(three(&pose[..3]), carrier[0]) < 0.05);
    }
    // Rotation with the pulley.
    assert!(apart(three(&poses[6..9]), three(&poses[poses.len() - 6..poses.len() - 3])) > 1e-2);
}
