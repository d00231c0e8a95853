//! Scenes and ParaView files of shells: grids, fields, supports, loads, closed surfaces, limited size.

use ancf_report::{BUDGET, scene};

use crate::common::{Run, Scene, dot};
use crate::paraview::{write, written};

/// Cantilever plate of 0.6 x 0.3 with an edge force and a pressure, and a weight at a corner.
const PLATE: &str = r#"
materials.m = { density = 500, young = 2e9, poisson = 0.3 }
scales = { kind = "auto" }
[[bodies]]
kind = "mass"
name = "stone"
center = [0, 0, 2]
mass = 1
[[bodies]]
kind = "shell"
name = "plate"
surface = { kind = "flat", corner = [0, 0, 0], side_u = [0.6, 0, 0], side_v = [0.1, 0.3, 0] }
elements = [4, 2]
thickness = 0.01
material = "m"
[[joints]]
kind = "support"
name = "root"
a = { body = "plate", at = { edge = "u_start" } }
condition = "clamped"
[[joints]]
kind = "spherical"
name = "nail"
a = { body = "stone", at = "center" }
[[loads]]
kind = "edge_force"
body = "plate"
edge = "u_end"
force = [0, 0, 30]
[[loads]]
kind = "surface_pressure"
body = "plate"
pressure = -50
[[loads]]
kind = "edge_moment"
body = "plate"
edge = "u_end"
moment = [0, 2, 0]
[[probes]]
name = "p"
on = { body = "plate", at = [0.375, 0.75] }
record = ["motion", "resultants", "surface_stress"]
[analysis]
kind = "statics"
first = 0.25
"#;

/// Station of the probe in a grid with `parts` cells per element.
fn station(parts: usize) -> usize {
    (3 * parts / 2) * (4 * parts + 1) + 3 * parts / 2
}

#[test]
fn grids_have_the_values_of_probes() {
    let run = Run::of(PLATE, 1);
    let found = run.scene();
    let plate = found.named("bodies", "plate");
    let parts = plate["grid"]["parts"].as_u64().unwrap() as usize;
    assert_eq!(plate["grid"]["counts"], serde_json::json!([4 * parts + 1, 2 * parts + 1]));
    assert_eq!(plate["nodes"].as_array().unwrap().len(), 15);
    for frame in 0..found.frames() {
        let value = |name: &str| run.column(&format!("p.{name}"))[frame];
        let at = found.centres("plate", frame)[station(parts)];
        (0..3).for_each(|k| assert!((at[k] - value(["x", "y", "z"][k])).abs() < 1e-6));
        for (field, column) in [
            ("moment uu", "muu"),
            ("membrane force vv", "nvv"),
            ("stress uu top", "suu_top"),
            ("stress uv bottom", "suv_bottom"),
            ("von Mises stress", "von_mises"),
        ] {
            let error = found.field(field, "plate", frame)[station(parts)] - value(column);
            assert!(error.abs() <= found.resolution(field), "{field}: {error}");
        }
        // The first tangent is that of the parameter u, the normal that of the vector product.
        let [normal, u, _] = found.directors("plate", frame)[station(parts)];
        let centres = found.centres("plate", frame);
        let step: [f64; 3] =
            std::array::from_fn(|k| centres[station(parts) + 1][k] - centres[station(parts) - 1][k]);
        let length = dot(step, step).sqrt();
        assert!(dot(step, u) > 0.9999 * length && dot(step, normal).abs() < 1e-3 * length);
        assert!(normal[2] > 0.0);
    }
    assert!(found.field("moment uu", "stone", 0)[0].is_nan());
}

#[test]
fn supports_and_loads_are_at_their_edges() {
    let run = Run::of(PLATE, 1);
    let found = run.scene();
    let list = |value: &serde_json::Value| -> Vec<usize> {
        value.as_array().unwrap().iter().map(|k| k.as_u64().unwrap() as usize).collect()
    };
    let reference = found.reference("plate");
    let first = found.named("bodies", "plate")["first"].as_u64().unwrap() as usize;
    let root = &found.header["supports"][0];
    assert_eq!(found.header["markers"][root["marker"].as_u64().unwrap() as usize]["name"], "root");
    // The edges are skew: x = y/3 at the root.
    assert!(
        list(&root["stations"])
            .iter()
            .all(|k| (reference[k - first][0] - reference[k - first][1] / 3.0).abs() < 1e-6)
    );
    let loads = found.header["loads"].as_array().unwrap();
    assert_eq!(loads.len(), 3);
    for (load, (size, is_moment)) in loads.iter().zip([(30.0, false), (50.0, false), (2.0, true)]) {
        let stations = list(&load["stations"]);
        assert!(stations.len() <= 36 && load["moment"] == is_moment);
        let vectors = found.numbers(&load["vectors"]);
        assert_eq!(vectors.len(), found.frames() * stations.len() * 3);
        for (frame, vectors) in vectors.chunks_exact(3 * stations.len()).enumerate() {
            let factor = run.column("load")[frame];
            for vector in vectors.chunks_exact(3) {
                let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
                assert!((length - size * factor).abs() < 1e-5 * size, "{length}, {size} times {factor}");
            }
        }
    }
    // The pressure of −50 acts against the normal, that is downwards.
    assert!(found.numbers(&loads[1]["vectors"]).chunks_exact(3).skip(36).all(|x| x[2] < 0.0));
}

/// Long recordings stay within the budget.
#[test]
fn scenes_are_limited() {
    let run = Run::of(&PLATE.replace("elements = [4, 2]", "elements = [16, 8]"), 1);
    let mut recording = run.recording();
    let frames = recording.frames.clone();
    recording.frames = frames.iter().cycle().take(400).cloned().collect();
    let whole = Scene::read(&scene(&recording, BUDGET));
    let budget = 3 << 20;
    let packed = scene(&recording, budget);
    assert!(packed.len() <= budget + budget / 4, "{}", packed.len());
    let small = Scene::read(&packed);
    assert!(small.frames() >= 2 && small.stations() <= whole.stations());
    assert!(small.has_message("straight segment") && small.has_message("to limit the file size"));
}

#[test]
fn paraview_files_have_closed_surfaces_and_fields() {
    let run = Run::of(PLATE, 1);
    let all = written(&run, "sections");
    let volume = 0.6 * 0.3 * 0.01;
    for (_, grid) in &all {
        assert!(grid.is_closed());
        assert!((grid.volume(1) / volume - 1.0).abs() < 0.02, "{}", grid.volume(1));
    }
    let last = run.frames.len() - 1;
    let value = |name: &str| run.column(&format!("p.{name}"))[last];
    let (_, middle) = written(&run, "shells").pop().unwrap();
    let parts = ((middle.points().len() / 9) as f64).sqrt() as usize;
    let parts = (parts - 1..=parts + 1).find(|p| (4 * p + 1) * (2 * p + 1) == middle.points().len()).unwrap();
    for name in ["nuu", "muv", "suu_top", "svv_middle", "suv_bottom", "von_mises"] {
        let found = middle[name][station(parts)];
        assert!((found - value(name)).abs() <= 1e-9 * value("von_mises"), "{name}: {found} {}", value(name));
    }
    let at = station(parts);
    assert!((middle["u"][at] - 0.375).abs() < 1e-12 && (middle["thickness"][at] - 0.01).abs() < 1e-15);
    // The principal stresses are the eigenvalues: their sum is the trace, and σ₁ is the stress along its direction.
    let (direction, axis) = (middle.vectors("s1_direction_top")[at], middle.vectors("u_axis")[at]);
    let trace = value("suu_top") + value("svv_top");
    assert!((middle["s1_top"][at] + middle["s2_top"][at] - trace).abs() < 1e-9 * trace.abs());
    let cos = dot(direction, axis);
    let sin = dot(direction, middle.vectors("v_axis")[at]);
    let along =
        value("suu_top") * cos * cos + value("svv_top") * sin * sin + 2.0 * value("suv_top") * sin * cos;
    assert!((along - middle["s1_top"][at]).abs() < 1e-9 * along.abs());
    assert!(middle.texts["units"][0].contains(r#""muu":"N""#));
    // A model with shells only has no lines.
    let folder = tempfile::tempdir().unwrap();
    let alone =
        PLATE.replace("[[bodies]]\nkind = \"mass\"\nname = \"stone\"\ncenter = [0, 0, 2]\nmass = 1\n", "");
    let nail =
        "[[joints]]\nkind = \"spherical\"\nname = \"nail\"\na = { body = \"stone\", at = \"center\" }\n";
    let files = write(&Run::of(&alone.replace(nail, ""), 1), folder.path()).files;
    let names: Vec<_> = files.iter().map(|file| file.file_name().unwrap().to_owned()).collect();
    assert_eq!(names, ["sections.pvd", "shells.pvd"]);
}
