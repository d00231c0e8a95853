use std::fs::{self, File};
use std::io;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use ancf::solver::equations::State;
use ancf::{Checkpoint, Model, Observer, Simulation, Summary};
use serde::{Deserialize, Serialize};

use super::checkpoint::{self, CheckpointError, CheckpointInterval};
use super::expected_size::ExpectedSize;
use super::row_selection::RowSelection;
use super::run_files::{FileLengths, FileSpec, RunFiles};
use super::state_selection::StateSelection;
use crate::folder::{Folder, SummaryFile, erase_signature, remove, replace, sign, with_path, write_summary};
use crate::table::{Layout, PROGRAM, Provenance, angles, state_layout};

/// Writes a run into its folder.
///
/// The folder is created when the run begins, so that invalid input leaves no folder behind.
#[derive(Debug)]
pub struct Recorder {
    spec: FileSpec,
    /// Name of the model file.
    name: String,
    /// Text of the model file.
    text: String,
    selection: Selection,
    /// Places in a row of the angles whose turns a state does not contain.
    angles: Vec<usize>,
    interval: Option<CheckpointInterval>,
    /// Names and contents of the files of display geometry.
    display: Vec<(String, Vec<u8>)>,
    /// Time of the last flush.
    flushed: Instant,
    /// Time of the last checkpoint.
    saved: Instant,
    /// Steps since the last checkpoint.
    steps: u64,
    /// Checkpoint from which the run is resumed.
    resumed: Option<RecorderCheckpoint>,
    files: Option<RunFiles>,
    /// Lock of the folder until the summary is written.
    lock: Option<File>,
}

/// Selection of rows and states, with their counters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Selection {
    rows: RowSelection,
    states: StateSelection,
    /// Last state, if it was not selected, with the first number and the counted angles of its row.
    last: Option<(f64, State, Vec<f64>)>,
}

/// State of a recorder at a checkpoint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct RecorderCheckpoint {
    name: String,
    selection: Selection,
    lengths: FileLengths,
}

/// Time between two flushes.
const FLUSH_INTERVAL: Duration = Duration::from_secs(1);

impl Recorder {
    /// Recorder of a run into a folder. `name` is the name of the model in `summary.json`, `text` is its model file.
    pub fn new(folder: Folder, name: &str, text: &str, model: &Model, simulation: &Simulation) -> Self {
        let angles: Vec<usize> = angles(simulation).into_iter().map(|(_, place)| place).collect();
        let states = state_layout(simulation, angles.len());
        let selection = StateSelection::new(states.width(), model);
        let columns = simulation.columns();
        let provenance = Provenance::new(text, &model.unit_names(), &columns);
        let columns = Layout::new(columns.into_iter().map(|column| column.name).collect(), Vec::new());
        let now = Instant::now();
        Self {
            spec: FileSpec { folder, output: model.output, provenance, columns, states },
            name: name.to_owned(),
            text: text.to_owned(),
            selection: Selection {
                rows: RowSelection::new(model.row_interval()),
                states: selection,
                last: None,
            },
            angles,
            interval: None,
            display: Vec::new(),
            flushed: now,
            saved: now,
            steps: 0,
            resumed: None,
            files: None,
            lock: None,
        }
    }

    /// Returns a recorder that resumes the run in a folder, and the checkpoint of the simulation; `None` without a checkpoint.
    ///
    /// # Errors
    /// If the checkpoint is damaged.
    pub fn resume(
        folder: Folder,
        text: &str,
        model: &Model,
        simulation: &Simulation,
    ) -> Result<Option<(Self, Checkpoint)>, CheckpointError> {
        let read = checkpoint::read::<(RecorderCheckpoint, Checkpoint)>(&folder.checkpoint())?;
        let Some((resumed, from)) = read else { return Ok(None) };
        let recorder = Self::new(folder, &resumed.name, text, model, simulation);
        let selection = resumed.selection.clone();
        Ok(Some((Self { selection, resumed: Some(resumed), ..recorder }, from)))
    }

    /// Enables checkpoints.
    #[must_use]
    pub fn with_checkpoints(self, interval: CheckpointInterval) -> Self {
        Self { interval: Some(interval), ..self }
    }

    /// Adds files of display geometry, with names in the folder `display`.
    #[must_use]
    pub fn with_display(self, files: Vec<(String, Vec<u8>)>) -> Self {
        Self { display: files, ..self }
    }

    /// Name of the model.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Expected sizes of the files of a run of the model.
    pub fn expected_size(&self, model: &Model) -> ExpectedSize {
        let states = self.selection.states.expected(model);
        ExpectedSize::new(model, self.spec.columns.width(), self.spec.states.width(), states)
    }

    /// Folder of the run.
    pub fn folder(&self) -> &Folder {
        &self.spec.folder
    }

    /// Writes `summary.json` and unlocks the folder. The checkpoint of a finished run is removed.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_summary(&mut self, summary: &Summary, wall_seconds: f64) -> io::Result<()> {
        let (program, model, summary) = (PROGRAM.to_owned(), self.name.clone(), summary.clone());
        let contents = SummaryFile { program, model, wall_seconds, summary };
        write_summary(&self.folder().summary(), &contents)?;
        if contents.summary.outcome.is_finished() {
            remove(&self.folder().checkpoint())?;
        }
        self.lock = None;
        Ok(())
    }

    /// Creates new files in place of those of an earlier run.
    fn create(&mut self) -> io::Result<RunFiles> {
        let folder = &self.spec.folder;
        fs::create_dir_all(folder.path()).map_err(|error| with_path(&error, folder.path()))?;
        let mut lock = folder.lock()?;
        folder.check_overwrite(&lock, &self.text)?;
        folder.clear()?;
        // A reader may see the new model before its checksum.
        erase_signature(&lock).map_err(|error| with_path(&error, folder.path()))?;
        replace(&folder.model(), self.text.as_bytes())?;
        sign(&mut lock, &self.text).map_err(|error| with_path(&error, folder.path()))?;
        for (name, contents) in &self.display {
            let path = folder.path().join(name);
            let parent = path.parent().unwrap_or(folder.path());
            fs::create_dir_all(parent).map_err(|error| with_path(&error, parent))?;
            replace(&path, contents)?;
        }
        let files = self.spec.create()?;
        self.lock = Some(lock);
        Ok(files)
    }

    /// Reopens the files as they were at a checkpoint.
    fn reopen(&mut self, lengths: &FileLengths) -> io::Result<RunFiles> {
        let folder = &self.spec.folder;
        let lock = folder.lock()?;
        // The summary of the interrupted part is obsolete.
        remove(&folder.summary())?;
        folder.remove_incomplete()?;
        let files = self.spec.reopen(lengths)?;
        self.lock = Some(lock);
        Ok(files)
    }

    fn write_row(&mut self, row: &[f64]) -> io::Result<()> {
        self.files.as_mut().map_or(Ok(()), |files| files.write_row(row))
    }

    fn write_state(&mut self, first: f64, state: &State, angles: &[f64]) -> io::Result<()> {
        let row = self.selection.states.row();
        self.files.as_mut().map_or(Ok(()), |files| files.write_state(row, first, state, angles))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.flushed = Instant::now();
        self.files.as_mut().map_or(Ok(()), RunFiles::flush)
    }

    /// Writes a checkpoint, after all rows before it.
    fn save(&mut self, checkpoint: &Checkpoint) -> io::Result<()> {
        (self.saved, self.steps) = (Instant::now(), 0);
        self.flush()?;
        let Some(files) = &self.files else { return Ok(()) };
        let lengths = files.lengths()?;
        let own = RecorderCheckpoint { name: self.name.clone(), selection: self.selection.clone(), lengths };
        checkpoint::write(&self.folder().checkpoint(), &(own, checkpoint))
    }

    /// Writes the last row and state and merges the tables. An error does not prevent the subsequent steps.
    fn complete(&mut self) -> io::Result<()> {
        let row = self.selection.rows.take_last().map_or(Ok(()), |row| self.write_row(&row));
        let last = self.selection.last.take().filter(|_| self.selection.states.lacks_last());
        let state = last.map_or(Ok(()), |(first, state, angles)| self.write_state(first, &state, &angles));
        let flushed = self.flush();
        let finished = self.files.take().map_or(Ok(()), RunFiles::finish);
        row.and(state).and(flushed).and(finished)
    }
}

impl Observer for Recorder {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        self.files = Some(match self.resumed.take() {
            Some(resumed) => self.reopen(&resumed.lengths)?,
            None => self.create()?,
        });
        self.flush()
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        if self.selection.rows.is_due(row) {
            self.write_row(row)?;
        }
        let first = row.first().copied().unwrap_or_default();
        let angles = self.angles.iter().map(|place| row[*place]);
        if self.selection.states.is_due(first) {
            let angles: Vec<f64> = angles.collect();
            self.write_state(first, state, &angles)?;
        } else {
            match &mut self.selection.last {
                Some((value, last, counted)) => {
                    *value = first;
                    last.copy_from(state);
                    counted.clear();
                    counted.extend(angles);
                }
                None => self.selection.last = Some((first, state.clone(), angles.collect())),
            }
        }
        if self.flushed.elapsed() >= FLUSH_INTERVAL {
            self.flush()?;
        }
        Ok(ControlFlow::Continue(()))
    }

    fn checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.steps += 1;
        let due = match self.interval {
            None => false,
            Some(CheckpointInterval::Steps(steps)) => self.steps >= steps,
            Some(CheckpointInterval::Time(time)) => self.saved.elapsed() >= time,
        };
        if due { self.save(&take()) } else { Ok(()) }
    }

    fn last_checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.save(&take())
    }

    fn finish(&mut self) -> io::Result<()> {
        self.complete()
    }
}
