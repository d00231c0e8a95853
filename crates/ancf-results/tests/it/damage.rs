//! A changed bit anywhere in the folder of a run is found by reading, or has no effect on the contents.

use std::fs;
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use ancf::record::Series;
use ancf::solver::equations::State;
use ancf::{Checkpoint, Model, Observer, Simulation};
use ancf_results::{CheckpointInterval, Folder, OpenError, Recorder, Results, StoredState, SummaryFile};
use tempfile::TempDir;

use crate::common::anything::{MODEL, stopped};

/// Number of changed positions of a file.
const POSITIONS: usize = 150;

/// Recorder of a run that is killed before it ends: the tables remain in parts.
struct Killed(Recorder);

impl Observer for Killed {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.0.begin(columns)
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        self.0.record(row, state)
    }

    fn checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.0.checkpoint(take)
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn killed(folder: &Path) {
    let model = Model::parse(MODEL).unwrap();
    let simulation = Simulation::new(&model).unwrap();
    let recorder = Recorder::new(Folder::new(folder), "model.toml", MODEL, &model, &simulation);
    let _ = simulation.run(&mut Killed(recorder.with_checkpoints(CheckpointInterval::Steps(2)))).unwrap();
}

/// Contents of a folder.
type Contents = (String, Series, Vec<StoredState>, Option<SummaryFile>, Option<f64>);

fn contents(folder: &Path) -> Result<Contents, String> {
    let read = || -> Result<_, OpenError> {
        let results = Results::open(folder)?;
        let frames = results.frames().collect::<Result<_, _>>()?;
        let (columns, summary) = (results.columns()?, results.summary_file()?);
        Ok((results, columns, frames, summary))
    };
    let (results, columns, frames, summary) = read().map_err(|error| error.to_string())?;
    let (text, model) = (results.text(), results.model());
    let resumed = Recorder::resume(results.folder().clone(), text, model, results.simulation());
    let time = resumed.map_err(|error| error.to_string())?.map(|(_, from)| from.time());
    Ok((text.to_owned(), columns, frames, summary, time))
}

/// Changes a bit at many positions of each file.
fn assert_found(folder: &Path, files: &[&str]) {
    let expected = contents(folder).unwrap();
    assert!(Results::open(folder).unwrap().has_checksums().unwrap());
    for file in files {
        let path: PathBuf = folder.join(file);
        let bytes = fs::read(&path).unwrap();
        let (mut found, mut changes) = (0, 0);
        for place in (0..bytes.len()).step_by((bytes.len() / POSITIONS).max(1)) {
            let mut damaged = bytes.clone();
            damaged[place] ^= 1 << (place % 8);
            fs::write(&path, damaged).unwrap();
            changes += 1;
            match contents(folder) {
                Err(error) => {
                    found += 1;
                    assert!(error.contains(file), "{file}, byte {place}: {error}");
                }
                Ok(contents) => assert!(contents == expected, "{file}, byte {place}: other contents"),
            }
        }
        fs::write(&path, &bytes).unwrap();
        // Without the name of the checksum a file is read as a file of an earlier version.
        assert!(found * 100 >= changes * 95, "{file}: {found} of {changes}");
    }
    assert!(contents(folder).unwrap() == expected);
}

#[test]
fn of_a_stopped_run() {
    let folder = TempDir::new().unwrap();
    stopped(folder.path());
    let files = ["results.parquet", "states.parquet", "summary.json", "checkpoint", "model.toml", ".lock"];
    assert_found(folder.path(), &files);
}

#[test]
fn of_a_killed_run() {
    let folder = TempDir::new().unwrap();
    killed(folder.path());
    let part = |table: &str| format!("{table}.parquet.parts/part-000000.parquet");
    let [results, states] = [part("results"), part("states")];
    assert_found(folder.path(), &[&results, &states, "checkpoint", "model.toml"]);
}

/// A copy without hidden files has the checksum of the model in the tables.
#[test]
fn of_a_model_without_lock_file() {
    let folder = TempDir::new().unwrap();
    stopped(folder.path());
    fs::remove_file(folder.path().join(".lock")).unwrap();
    assert_found(folder.path(), &["model.toml"]);
}

/// A damaged run is not resumed.
#[test]
fn resuming_is_rejected() {
    for (run, file) in [
        (stopped as fn(&Path), "results.parquet"),
        (stopped, "states.parquet"),
        (killed, "results.parquet.parts/part-000000.parquet"),
    ] {
        let folder = TempDir::new().unwrap();
        run(folder.path());
        let path = folder.path().join(file);
        let mut bytes = fs::read(&path).unwrap();
        bytes[100] ^= 0x40;
        fs::write(&path, bytes).unwrap();
        let results = Results::open(folder.path()).unwrap();
        let error = results.verify().unwrap_err().to_string();
        assert!(error.contains(file) && error.contains("wrong checksum of rows 0 to "), "{error}");
        let resumed =
            Recorder::resume(results.folder().clone(), results.text(), results.model(), results.simulation());
        let (mut recorder, from) = resumed.unwrap().unwrap();
        let error = results.simulation().resume(&from, &mut recorder).unwrap_err();
        let error = format!("{error:?}");
        assert!(error.contains(file.split('/').next().unwrap()), "{error}");
    }
}
