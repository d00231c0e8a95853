use std::borrow::Borrow;
use std::fs;
use std::io;
use std::iter;
use std::path::{Path, PathBuf};

use ancf::record::{Series, Sink};
use ancf::solver::equations::{EquationsOfMotion, State};
use ancf::{Model, Simulation};

use super::open_error::OpenError;
use super::run_status::RunStatus;
use crate::folder::{
    Folder, SummaryFile, damaged, has_summary_checksum, read_summary, sequence_folders, with_path,
};
use crate::table::{
    ANGLES, Layout, angles, has_checksums, has_column, metadata_of_table, rows_of_part, state_layout, verify,
};

/// Stored state of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredState {
    /// Number of the row.
    pub row: u64,
    /// First number of the row: time, load factor or number of the mode.
    pub value: f64,
    /// State in the units of the solver.
    pub state: State,
    /// Angles of joints and sensors with their full turns, by their columns. Runs of earlier versions have none.
    pub angles: Vec<(String, f64)>,
}

/// Results of a run that has ended, was killed or is in progress.
#[derive(Debug)]
pub struct Results {
    folder: Folder,
    text: String,
    model: Model,
    simulation: Simulation,
}

impl Results {
    /// Opens a results folder.
    ///
    /// # Errors
    /// If the folder contains no run, the model is not that of the run, or it is invalid in this version of the program.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        let folder = Folder::new(path.as_ref());
        let file = folder.model();
        let bytes = match fs::read(&file) {
            Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
                let path = folder.path().to_owned();
                return Err(match sequence_folders(&path) {
                    Some(analyses) => OpenError::Sequence { folder: path, analyses },
                    None => OpenError::NoRun(path),
                });
            }
            bytes => bytes.map_err(|error| with_path(&error, &file))?,
        };
        folder.verify_model(&bytes, || stored_checksum(&folder))?;
        let text = String::from_utf8(bytes).map_err(|_| with_path(&damaged("it is not UTF-8"), &file))?;
        let wrong = |errors| OpenError::Model { path: file.clone(), errors };
        let model = Model::parse(&text).map_err(wrong)?;
        let simulation = Simulation::new(&model).map_err(wrong)?;
        Ok(Self { folder, text, model, simulation })
    }

    /// Folder of the run.
    pub fn folder(&self) -> &Folder {
        &self.folder
    }

    /// Text of the model file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Model in the user's units.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Simulation of the model, which evaluates the states.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Status of the run.
    pub fn status(&self) -> RunStatus {
        if self.folder.is_busy() {
            RunStatus::Running
        } else if self.folder.summary().exists() {
            RunStatus::Ended
        } else {
            RunStatus::Broken
        }
    }

    /// Reads `summary.json`; `None` if the file does not exist.
    ///
    /// # Errors
    /// If the file cannot be read or is damaged.
    pub fn summary_file(&self) -> Result<Option<SummaryFile>, OpenError> {
        let path = self.folder.summary();
        match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            bytes => {
                let bytes = bytes.map_err(|error| with_path(&error, &path))?;
                Ok(Some(read_summary(&bytes).map_err(|error| with_path(&error, &path))?))
            }
        }
    }

    /// Verifies the checksums of columns, states and summary without decoding the tables.
    ///
    /// # Errors
    /// If a file is damaged or cannot be read.
    pub fn verify(&self) -> Result<(), OpenError> {
        verify(&self.folder.results())?;
        verify(&self.folder.states())?;
        self.summary_file().map(|_| ())
    }

    /// True if damage of every file of the results would be detected. Files of earlier versions have no checksums.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub fn has_checksums(&self) -> Result<bool, OpenError> {
        for table in [self.folder.results(), self.folder.states()] {
            if has_checksums(&table)? == Some(false) {
                return Ok(false);
            }
        }
        let path = self.folder.summary();
        match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(true),
            bytes => Ok(has_summary_checksum(&bytes.map_err(|error| with_path(&error, &path))?)),
        }
    }

    /// Reads all columns, as far as they are on the disk.
    ///
    /// # Errors
    /// If the columns cannot be read.
    pub fn columns(&self) -> Result<Series, OpenError> {
        let mut series = Series::new();
        let names: Vec<String> = self.simulation.columns().into_iter().map(|column| column.name).collect();
        series.begin(&names)?;
        let layout = Layout::new(names, Vec::new());
        for part in parts_of(self.folder.results(), &layout) {
            for row in part?.chunks_exact(layout.width().max(1)) {
                let _ = series.record(row)?;
            }
        }
        Ok(series)
    }

    /// Reads the stored states, as far as they are on the disk, with one part in memory at a time.
    pub fn frames(&self) -> impl Iterator<Item = Result<StoredState, OpenError>> + '_ {
        let mut names: Vec<String> = angles(&self.simulation).into_iter().map(|(name, _)| name).collect();
        if matches!(has_column(&self.folder.states(), ANGLES), Ok(Some(false))) {
            names.clear();
        }
        let layout = state_layout(&self.simulation, names.len());
        let width = layout.width();
        parts_of(self.folder.states(), layout).flat_map(move |part| match part {
            Ok(rows) => rows.chunks_exact(width).map(|row| Ok(self.state_of(row, &names))).collect(),
            Err(error) => vec![Err(error.into())],
        })
    }

    /// Converts a row of the table of states.
    fn state_of(&self, row: &[f64], angles: &[String]) -> StoredState {
        let system = &self.simulation.assembly().system;
        let mut state = State::rest(system.coordinates(), system.multipliers());
        let (head, mut rest) = row.split_at(3);
        for part in [&mut state.q, &mut state.v, &mut state.a, &mut state.lambda] {
            let (own, beyond) = rest.split_at(part.len());
            part.copy_from_slice(own);
            rest = beyond;
        }
        state.load = head[2];
        if self.model.analysis.dynamics().is_some() {
            state.t = head[1] / self.simulation.scales().time;
        }
        let angles = angles.iter().cloned().zip(rest.iter().copied()).collect();
        StoredState { row: head[0] as u64, value: head[1], state, angles }
    }

    /// Reads a value of the metadata of the columns: `program`, `model`, `sha256` or `units`.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn metadata(&self, key: &str) -> Result<Option<String>, OpenError> {
        Ok(metadata_of_table(&self.folder.results(), key)?)
    }
}

/// SHA-256 of the model in the metadata of the results.
fn stored_checksum(folder: &Folder) -> io::Result<Option<String>> {
    match metadata_of_table(&folder.results(), "sha256")? {
        Some(checksum) => Ok(Some(checksum)),
        None => metadata_of_table(&folder.states(), "sha256"),
    }
}

/// Reads the rows of a table part by part, up to the last part or an error.
fn parts_of(path: PathBuf, layout: impl Borrow<Layout>) -> impl Iterator<Item = io::Result<Vec<f64>>> {
    let mut next = Some(0);
    iter::from_fn(move || {
        let number = next?;
        let part = rows_of_part(&path, layout.borrow(), number).transpose();
        next = matches!(part, Some(Ok(_))).then_some(number + 1);
        part
    })
}
