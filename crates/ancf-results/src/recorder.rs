use std::fs::File;
use std::io::{self, Seek, SeekFrom};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

use ancf::model::Output;
use ancf::record::{Csv, Sink};
use ancf::system::State;
use ancf::{Checkpoint, Column, Model, Observer, Simulation, Summary};
use serde::{Deserialize, Serialize};

use crate::Conclusion;
use crate::checkpoint::{self, CheckpointError, Every};
use crate::folder::{Folder, about, remove, replace, sign};
use crate::frames::{self, Frames};
use crate::layout::Layout;
use crate::provenance::{PROGRAM, Provenance};
use crate::table::Table;
use crate::thinned::Thinned;

/// Writes a run into its folder. The folder comes into being when the run begins, so that bad input leaves none.
#[derive(Debug)]
pub struct Recorder {
    folder: Folder,
    name: String,
    output: Output,
    text: String,
    provenance: Provenance,
    columns: Vec<Column>,
    states_layout: Layout,
    seen: Seen,
    every: Option<Every>,
    /// When rows were flushed, and when a checkpoint was written.
    flushed: Instant,
    checked: Instant,
    /// Steps since then.
    steps: u64,
    /// What it goes on from.
    memory: Option<Memory>,
    files: Option<Files>,
    /// Keeps others out of the folder, until all is said.
    lock: Option<File>,
}

/// The files that grow.
#[derive(Debug)]
struct Files {
    csv: Option<Csv<File>>,
    results: Option<Table>,
    states: Option<Table>,
}

/// What the rows so far say about those to come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Seen {
    thinned: Thinned,
    frames: Frames,
    /// The last state, if it may have to be kept.
    last: Option<(f64, State)>,
}

/// What a recorder has to remember to go on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Memory {
    name: String,
    seen: Seen,
    csv: u64,
    results: u64,
    states: u64,
}

/// Between two flushes.
const FLUSH: Duration = Duration::from_secs(1);

impl Recorder {
    /// Of a run of a model into a folder; the model is given also by its name, which `summary.json` tells, and as its text.
    pub fn new(folder: Folder, name: &str, text: &str, model: &Model, simulation: &Simulation) -> Self {
        let columns = simulation.columns();
        let now = Instant::now();
        Self {
            folder,
            name: name.to_owned(),
            output: model.output,
            text: text.to_owned(),
            provenance: Provenance::new(text, &model.unit_names(), &columns),
            columns,
            states_layout: frames::layout(simulation),
            seen: Seen {
                thinned: Thinned::new(model.output.every),
                frames: Frames::new(simulation, &model.analysis, model.output.states),
                last: None,
            },
            every: None,
            flushed: now,
            checked: now,
            steps: 0,
            memory: None,
            files: None,
            lock: None,
        }
    }

    /// What continues the run in a folder, and from where; nothing if it left no checkpoint.
    ///
    /// # Errors
    /// If the checkpoint is damaged.
    pub fn resume(
        folder: Folder,
        text: &str,
        model: &Model,
        simulation: &Simulation,
    ) -> Result<Option<(Self, Checkpoint)>, CheckpointError> {
        let Some((memory, from)) = checkpoint::read::<(Memory, Checkpoint)>(&folder.checkpoint())? else {
            return Ok(None);
        };
        let recorder = Self::new(folder, &memory.name, text, model, simulation);
        Ok(Some((Self { seen: memory.seen.clone(), memory: Some(memory), ..recorder }, from)))
    }

    /// The same, writing checkpoints.
    #[must_use]
    pub fn with_checkpoints(self, every: Every) -> Self {
        Self { every: Some(every), ..self }
    }

    /// What the model is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it writes.
    pub fn folder(&self) -> &Folder {
        &self.folder
    }

    /// Writes how the run ended, into `summary.json`, and leaves the folder to others.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn conclude(&mut self, summary: &Summary, seconds: f64) -> io::Result<()> {
        let (program, model, summary) = (PROGRAM.to_owned(), self.name.clone(), summary.clone());
        let conclusion = Conclusion { program, model, wall_seconds: seconds, summary };
        let text = serde_json::to_string_pretty(&conclusion).map_err(io::Error::other)? + "\n";
        replace(&self.folder.summary(), text.as_bytes())?;
        if conclusion.summary.outcome.is_finished() {
            // There is nothing left to do, and from now on the summary says so.
            remove(&self.folder.checkpoint())?;
        }
        self.lock = None;
        Ok(())
    }

    fn layout(&self) -> Layout {
        Layout::new(self.columns.iter().map(|column| column.name.clone()).collect(), Vec::new())
    }

    /// New files in the place of those of an earlier run.
    fn create(&mut self) -> io::Result<Files> {
        let folder = &self.folder;
        std::fs::create_dir_all(folder.path()).map_err(|error| about(&error, folder.path()))?;
        let mut lock = folder.lock()?;
        folder.spare(&lock, &self.text)?;
        folder.clear()?;
        replace(&folder.model(), self.text.as_bytes())?;
        sign(&mut lock, &self.text).map_err(|error| about(&error, folder.path()))?;
        let Output { csv, parquet, states, .. } = self.output;
        let files = Files {
            csv: csv.then(|| new_csv(folder, &self.layout().numbers)).transpose()?,
            results: parquet
                .then(|| Table::create(&folder.results(), self.layout(), &self.provenance))
                .transpose()?,
            states: (states > 0).then(|| self.create_states()).transpose()?,
        };
        self.lock = Some(lock);
        Ok(files)
    }

    fn create_states(&self) -> io::Result<Table> {
        let (path, layout) = (self.folder.states(), self.states_layout.clone());
        Table::create(&path, layout, &self.provenance.without_units())
    }

    /// The files as they were at a checkpoint.
    fn reopen(&mut self, memory: &Memory) -> io::Result<Files> {
        let folder = &self.folder;
        let lock = folder.lock()?;
        // It tells of the piece before.
        remove(&folder.summary())?;
        folder.sweep()?;
        let Output { csv, parquet, states, .. } = self.output;
        let results = || Table::reopen(&folder.results(), self.layout(), &self.provenance, memory.results);
        let states_again = || {
            let about = self.provenance.without_units();
            Table::reopen(&folder.states(), self.states_layout.clone(), &about, memory.states)
        };
        let files = Files {
            csv: csv.then(|| old_csv(folder, memory.csv)).transpose()?,
            results: parquet.then(results).transpose()?,
            states: (states > 0).then(states_again).transpose()?,
        };
        self.lock = Some(lock);
        Ok(files)
    }

    fn write_row(&mut self, row: &[f64]) -> io::Result<()> {
        let path = self.folder.csv();
        let Some(files) = &mut self.files else { return Ok(()) };
        if let Some(csv) = &mut files.csv {
            let _ = Sink::record(csv, row).map_err(|error| about(&error, &path))?;
        }
        files.results.as_mut().map_or(Ok(()), |table| table.push(&[row]))
    }

    fn write_state(&mut self, first: f64, state: &State) -> io::Result<()> {
        let head = [self.seen.frames.row() as f64, first, state.load];
        let Some(table) = self.files.as_mut().and_then(|files| files.states.as_mut()) else { return Ok(()) };
        let [q, v, a, lambda] = frames::numbers(state);
        table.push(&[&head, q, v, a, lambda])
    }

    /// Writes from where the run can be continued, all rows before it first.
    fn save(&mut self, checkpoint: &Checkpoint) -> io::Result<()> {
        (self.checked, self.steps) = (Instant::now(), 0);
        self.flush()?;
        let Some(files) = &self.files else { return Ok(()) };
        let rows = |table: &Option<Table>| table.as_ref().map_or(0, Table::rows);
        let path = self.folder.csv();
        let csv = if files.csv.is_some() { synced(&path).map_err(|error| about(&error, &path))? } else { 0 };
        let memory = Memory {
            name: self.name.clone(),
            seen: self.seen.clone(),
            csv,
            results: rows(&files.results),
            states: rows(&files.states),
        };
        checkpoint::write(&self.folder.checkpoint(), &(memory, checkpoint))
    }

    /// Puts all there is on the disk.
    fn flush(&mut self) -> io::Result<()> {
        self.flushed = Instant::now();
        let path = self.folder.csv();
        let Some(files) = &mut self.files else { return Ok(()) };
        if let Some(csv) = &mut files.csv {
            Sink::finish(csv).map_err(|error| about(&error, &path))?;
        }
        [&mut files.results, &mut files.states].into_iter().flatten().try_for_each(Table::flush)
    }

    /// Writes what is left, and makes one file of each table; of all even if one fails.
    fn complete(&mut self) -> io::Result<()> {
        let row = self.seen.thinned.left().map_or(Ok(()), |row| self.write_row(&row));
        let last = self.seen.last.take().filter(|_| self.seen.frames.lack_last());
        let state = last.map_or(Ok(()), |(first, state)| self.write_state(first, &state));
        let flushed = self.flush();
        let tables = self.files.take().map(|files| [files.results, files.states]).into_iter().flatten();
        let finished: Vec<_> = tables.flatten().map(|mut table| table.finish()).collect();
        row.and(state).and(flushed).and(finished.into_iter().collect())
    }
}

impl Observer for Recorder {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        self.files = Some(match self.memory.take() {
            Some(memory) => self.reopen(&memory)?,
            None => self.create()?,
        });
        self.flush()
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        if self.seen.thinned.is_due(row) {
            self.write_row(row)?;
        }
        let first = row.first().copied().unwrap_or_default();
        if self.seen.frames.is_due(first) {
            self.write_state(first, state)?;
        } else {
            match &mut self.seen.last {
                Some((value, last)) => {
                    *value = first;
                    last.copy_from(state);
                }
                None => self.seen.last = Some((first, state.clone())),
            }
        }
        if self.flushed.elapsed() >= FLUSH {
            self.flush()?;
        }
        Ok(ControlFlow::Continue(()))
    }

    fn checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.steps += 1;
        let due = match self.every {
            None => false,
            Some(Every::Steps(steps)) => self.steps >= steps,
            Some(Every::Time(time)) => self.checked.elapsed() >= time,
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

/// A new `probes.csv`.
fn new_csv(folder: &Folder, columns: &[String]) -> io::Result<Csv<File>> {
    let path = folder.csv();
    let create = || {
        let mut csv = Csv::new(File::create(&path)?);
        Sink::begin(&mut csv, columns)?;
        Ok(csv)
    };
    create().map_err(|error| about(&error, &path))
}

/// The length of a file whose contents are on the disk when this returns.
fn synced(path: &Path) -> io::Result<u64> {
    let file = File::open(path)?;
    file.sync_all()?;
    Ok(file.metadata()?.len())
}

/// `probes.csv` cut down to so many bytes.
fn old_csv(folder: &Folder, bytes: u64) -> io::Result<Csv<File>> {
    let path = folder.csv();
    let open = || {
        let mut file = File::options().write(true).open(&path)?;
        if file.metadata()?.len() < bytes {
            return Err(io::Error::new(io::ErrorKind::InvalidData, "rows are missing"));
        }
        file.set_len(bytes)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Csv::new(file))
    };
    open().map_err(|error| about(&error, &path))
}
