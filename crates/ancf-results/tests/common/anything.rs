//! Bytes of any kind in the place of a file of a run: read, and resumed from. Nothing may panic or go on for ever.

use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use ancf::analysis::Interrupt;
use ancf::{Model, Simulation};
use ancf_results::{Every, Folder, Recorder, Results};
use sha2::{Digest, Sha256};

/// A run of a few steps, small enough to be made in a millisecond.
pub const MODEL: &str = r#"
materials.rubber = { density = 1100, young = 1e7 }
sections.rod = { kind = "circle", diameter = 0.02 }
bodies = [{ kind = "cable", name = "rope", from = [0, 0, 0], to = [1, 0, 0], elements = 1, section = "rod", material = "rubber" }]
joints = [{ kind = "spherical", name = "hook", a = { body = "rope", at = "start" } }]
gravity = [0, -9.81, 0]
analysis = { kind = "dynamics", duration = 0.01, step = 1e-3 }
"#;

/// What bytes are put in the place of.
const FILES: [&str; 5] = ["results.parquet", "states.parquet", "checkpoint", "summary.json", "model.toml"];

/// The folder of a run that was stopped after some steps.
pub fn stopped(folder: &Path) {
    let model = Model::parse(MODEL).expect("a model");
    let asked = AtomicU32::new(0);
    let interrupt = Interrupt::new(move || asked.fetch_add(1, Ordering::Relaxed) > 12);
    let simulation = Simulation::new(&model).expect("a valid one").heeding(interrupt);
    let recorder = Recorder::new(Folder::new(folder), "model.toml", MODEL, &model, &simulation);
    let mut recorder = recorder.with_checkpoints(Every::Steps(2));
    let summary = simulation.run(&mut recorder).expect("it can be written");
    recorder.conclude(&summary, 0.0).expect("it can be written");
}

/// The first byte chooses the file, the others are its contents; those of a checkpoint get their sum.
///
/// `run` is the folder of a stopped run, and `folder` one that may be filled.
pub fn results(run: &Path, folder: &Path, bytes: &[u8]) {
    let Some((which, contents)) = bytes.split_first() else { return };
    let name = FILES[usize::from(*which) % FILES.len()];
    let mut contents = contents.to_vec();
    if name == "checkpoint" {
        let sum = Sha256::digest(&contents);
        contents.extend_from_slice(&sum);
    }
    for file in
        ["model.toml", "results.parquet", "states.parquet", "probes.csv", "checkpoint", "summary.json"]
    {
        fs::copy(run.join(file), folder.join(file)).expect("it can be written");
    }
    // What a run that was resumed before left behind.
    let _ = ["results.parquet.parts", "states.parquet.parts"]
        .map(|parts| fs::remove_dir_all(folder.join(parts)).ok());
    fs::write(folder.join(name), contents).expect("it can be written");
    read(folder);
}

fn read(folder: &Path) {
    let Ok(results) = Results::open(folder) else { return };
    let _ = (
        results.status(),
        results.conclusion().is_ok(),
        results.columns().is_ok(),
        results.about("units").is_ok(),
    );
    let _ = results.frames().filter(|frame| frame.is_ok()).count();
    let asked = Arc::new(AtomicU32::new(0));
    let interrupt = Interrupt::new(move || asked.fetch_add(1, Ordering::Relaxed) > 1000);
    let Ok(simulation) = Simulation::new(results.model()) else { return };
    let simulation = simulation.heeding(interrupt);
    let folder = results.folder().clone();
    if let Ok(Some((mut recorder, from))) =
        Recorder::resume(folder, results.text(), results.model(), &simulation)
    {
        let _ = simulation.resume(&from, &mut recorder);
    }
}
