//! Arbitrary bytes as a file of a run, which is then read and resumed. Neither may panic or run indefinitely.

use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use ancf::solver::newton::Interrupt;
use ancf::{Model, Simulation};
use ancf_results::{CheckpointInterval, Folder, Recorder, Results};
use sha2::{Digest, Sha256};

/// Model of a run with a few steps, which takes about a millisecond.
pub const MODEL: &str = r#"
materials.rubber = { density = 1100, young = 1e7 }
sections.rod = { kind = "circle", diameter = 0.02 }
bodies = [{ kind = "cable", name = "rope", from = [0, 0, 0], to = [1, 0, 0], elements = 1, section = "rod", material = "rubber" }]
joints = [{ kind = "spherical", name = "hook", a = { body = "rope", at = "start" } }]
gravity = [0, -9.81, 0]
analysis = { kind = "dynamics", duration = 0.01, step = 1e-3 }
"#;

/// Files that are replaced by the bytes.
const FILES: [&str; 5] = ["results.parquet", "states.parquet", "checkpoint", "summary.json", "model.toml"];

/// Creates the folder of a run that was stopped after some steps.
pub fn stopped(folder: &Path) {
    let model = Model::parse(MODEL).expect("the model is valid");
    let asked = AtomicU32::new(0);
    let interrupt = Interrupt::new(move || asked.fetch_add(1, Ordering::Relaxed) > 12);
    let simulation = Simulation::new(&model).expect("the model can be assembled").with_interrupt(interrupt);
    let recorder = Recorder::new(Folder::new(folder), "model.toml", MODEL, &model, &simulation);
    let mut recorder = recorder.with_checkpoints(CheckpointInterval::Steps(2));
    let summary = simulation.run(&mut recorder).expect("the folder is writable");
    recorder.write_summary(&summary, 0.0).expect("the folder is writable");
}

/// Reads and resumes a run with one replaced file. The first byte selects the file, the others are its contents.
///
/// Checksums of a checkpoint and of a model are added. Those of Parquet files are removed. `run` is the folder of a stopped run, `folder` a folder that may be overwritten.
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
        fs::copy(run.join(file), folder.join(file)).expect("the folder is writable");
    }
    // Parts of an earlier resumed run.
    let _ = ["results.parquet.parts", "states.parquet.parts"]
        .map(|parts| fs::remove_dir_all(folder.join(parts)).ok());
    if name.ends_with(".parquet") {
        remove_checksums(&mut contents);
    }
    fs::write(folder.join(name), contents).expect("the folder is writable");
    let model = fs::read(folder.join("model.toml")).expect("the folder is readable");
    let digits: String = Sha256::digest(&model).iter().map(|byte| format!("{byte:02x}")).collect();
    fs::write(folder.join(".lock"), digits).expect("the folder is writable");
    read(folder);
}

/// Renames the key of the checksums, which would reject the contents before they are interpreted.
fn remove_checksums(contents: &mut [u8]) {
    const KEY: &[u8] = b"checksums";
    if let Some(place) = contents.windows(KEY.len()).rposition(|bytes| bytes == KEY) {
        contents[place] = b'C';
    }
}

fn read(folder: &Path) {
    let Ok(results) = Results::open(folder) else { return };
    let _ = (
        results.status(),
        results.summary_file().is_ok(),
        results.columns().is_ok(),
        results.metadata("units").is_ok(),
    );
    let _ = results.frames().filter(|frame| frame.is_ok()).count();
    let asked = Arc::new(AtomicU32::new(0));
    let interrupt = Interrupt::new(move || asked.fetch_add(1, Ordering::Relaxed) > 1000);
    let Ok(simulation) = Simulation::new(results.model()) else { return };
    let simulation = simulation.with_interrupt(interrupt);
    let folder = results.folder().clone();
    if let Ok(Some((mut recorder, from))) =
        Recorder::resume(folder, results.text(), results.model(), &simulation)
    {
        let _ = simulation.resume(&from, &mut recorder);
    }
}
