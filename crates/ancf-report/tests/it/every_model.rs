//! Scenes of all models of the repository contain finite and consistent numbers.

use std::fs;

use ancf::Model;
use ancf::model::Step;
use ancf_report::{BUDGET, scene};

use crate::common::{Run, Scene, dot, file};

fn models() -> Vec<(String, String)> {
    let folders = ["models", "crates/ancf/tests/models/good"];
    let mut found = Vec::new();
    for folder in folders {
        for entry in fs::read_dir(file(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|end| end == "toml") {
                found.push((path.display().to_string(), Model::read_text(&path).unwrap()));
            }
        }
    }
    found.sort();
    assert!(found.len() > 30);
    found
}

/// Runs a model with at most twelve steps; `None` if the model requires functions of a program.
fn short(text: &str) -> Option<Run> {
    let mut model = Model::parse(text).unwrap();
    if let Some(dynamics) = model.analysis.dynamics_mut() {
        let step = match dynamics.step {
            Step::Fixed(step) => step,
            Step::Adaptive { .. } => 1e-2 * dynamics.duration,
        };
        dynamics.duration = dynamics.duration.min(12.0 * step);
    }
    ancf::Simulation::new(&model).ok()?;
    Some(Run::of_model(model, text, 3))
}

#[test]
fn every_model_gives_a_scene() {
    let mut drawn = 0;
    for (path, text) in models() {
        let Some(run) = short(&text) else { continue };
        let found = run.scene();
        check(&path, &found);
        assert!(found.frames() <= run.frames.len().max(1));
        // One frame, then none.
        let mut recording = run.recording();
        recording.frames.truncate(1);
        check(&path, &Scene::read(&scene(&recording, BUDGET)));
        recording.frames.clear();
        let empty = Scene::read(&scene(&recording, BUDGET));
        check(&path, &empty);
        assert!(empty.has_message("no recorded states"), "{path}");
        // Small budget.
        recording.frames.clone_from(&run.frames);
        check(&path, &Scene::read(&scene(&recording, 1000)));
        drawn += 1;
    }
    assert!(drawn > 25, "{drawn} models drawn");
}

fn check(path: &str, scene: &Scene) {
    let (frames, stations) = (scene.frames(), scene.stations());
    let centres = scene.numbers(&scene.header["centres"]);
    assert_eq!(centres.len(), frames * stations * 3, "{path}");
    assert!(centres.iter().all(|x| x.is_finite()), "{path}");
    assert_eq!(scene.numbers(&scene.header["frames"]["values"]).len(), frames, "{path}");
    let places = scene.numbers(&scene.header["abscissa"]["values"]);
    assert!(places.is_sorted(), "{path}");
    let [low, high] = [0, 1].map(|k| -> Vec<f64> {
        scene.header["bounds"][k].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    });
    for x in centres.chunks_exact(3) {
        for k in 0..3 {
            let slack = 1e-6 * (1.0 + x[k].abs());
            assert!(low[k] - slack <= x[k] && x[k] <= high[k] + slack, "{path}: {x:?} is out of bounds");
        }
    }
    let mut counted = 0;
    for body in scene.header["bodies"].as_array().unwrap() {
        let name = body["name"].as_str().unwrap();
        assert_eq!(body["first"].as_u64().unwrap() as usize, counted, "{path}");
        counted += body["count"].as_u64().unwrap() as usize;
        let is_swept = !body["outline"].as_array().unwrap().is_empty();
        assert_eq!(body["box"].is_null(), is_swept || !body["grid"].is_null(), "{path}");
        for frame in 0..frames {
            for axes in scene.directors(name, frame) {
                for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                    let expected = if i == j { 1.0 } else { 0.0 };
                    let found = dot(axes[i], axes[j]);
                    assert!((found - expected).abs() < 2e-4, "{path}: {axes:?}");
                }
            }
        }
    }
    assert_eq!(counted, stations, "{path}");
    for field in scene.header["fields"].as_array().unwrap() {
        let range = [0, 1].map(|k| field["range"][k].as_f64().expect("a finite bound"));
        assert!(range[0] <= range[1], "{path}");
        assert_eq!(scene.numbers(&field["values"]).len(), frames * stations, "{path}");
    }
}
