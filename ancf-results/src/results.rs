use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ancf::model::ModelErrors;
use ancf::record::{Series, Sink};
use ancf::system::State;
use ancf::{Model, Simulation};
use thiserror::Error;

use crate::Conclusion;
use crate::folder::Folder;
use crate::frames;
use crate::read::{Reader, files, rows_of};

/// Why the results of a run cannot be read.
#[derive(Debug, Error)]
pub enum OpenError {
    /// There is no run.
    #[error("{0} holds no run: there is no model.toml")]
    NoRun(PathBuf),
    /// The model that was run is none of this version of the program.
    #[error("{path}: {errors}")]
    Model {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        errors: ModelErrors,
    },
    /// A file cannot be read.
    #[error(transparent)]
    Read(#[from] io::Error),
}

/// What is known of a run's end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It goes on.
    Running,
    /// It has ended, and said how.
    Ended,
    /// It has ended without a word: it was killed.
    Broken,
}

/// A state of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The number of its row.
    pub row: u64,
    /// Time, load factor or number of the mode: the first number of its row.
    pub value: f64,
    /// The state, in the units of the solver.
    pub state: State,
}

/// The results of a run: one that has ended, was killed, or goes on.
#[derive(Debug)]
pub struct Results {
    folder: Folder,
    text: String,
    model: Model,
    simulation: Simulation,
}

impl Results {
    /// Opens a folder.
    ///
    /// # Errors
    /// If there is no run in it, or the model is none of this version of the program.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        let folder = Folder::new(path.as_ref());
        let file = folder.model();
        let text = match fs::read_to_string(&file) {
            Err(error) if matches!(error.kind(), io::ErrorKind::NotFound | io::ErrorKind::NotADirectory) => {
                return Err(OpenError::NoRun(folder.path().to_owned()));
            }
            text => text.map_err(|error| crate::folder::about(&error, &file))?,
        };
        let wrong = |errors| OpenError::Model { path: file.clone(), errors };
        let model = Model::parse(&text).map_err(wrong)?;
        let simulation = Simulation::new(&model).map_err(wrong)?;
        Ok(Self { folder, text, model, simulation })
    }

    /// Where they are.
    pub fn folder(&self) -> &Folder {
        &self.folder
    }

    /// The text of the model.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// What reads its states.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// What is known of the run's end.
    pub fn status(&self) -> Status {
        if self.folder.is_busy() {
            Status::Running
        } else if self.folder.summary().exists() {
            Status::Ended
        } else {
            Status::Broken
        }
    }

    /// What the run said at its end, as in `summary.json`.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn conclusion(&self) -> Result<Option<Conclusion>, OpenError> {
        let path = self.folder.summary();
        match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            bytes => {
                let bytes = bytes.map_err(|error| crate::folder::about(&error, &path))?;
                // What is damaged says no more than what is missing.
                Ok(serde_json::from_slice(&bytes).ok())
            }
        }
    }

    /// All columns, as far as they are on the disk.
    ///
    /// # Errors
    /// If they cannot be read.
    pub fn columns(&self) -> Result<Series, OpenError> {
        let mut series = Series::new();
        let names: Vec<String> = self.simulation.columns().into_iter().map(|column| column.name).collect();
        series.begin(&names)?;
        let layout = crate::layout::Layout::new(names, Vec::new());
        for file in files(&self.folder.results()) {
            for row in rows_of(&file, &layout)?.chunks_exact(layout.width().max(1)) {
                let _ = series.record(row)?;
            }
        }
        Ok(series)
    }

    /// The states that were kept, as far as they are on the disk, one part in memory at a time.
    pub fn frames(&self) -> impl Iterator<Item = Result<Frame, OpenError>> + '_ {
        let layout = frames::layout(&self.simulation);
        let files = files(&self.folder.states()).into_iter();
        files.flat_map(move |file| self.frames_of(&file, &layout))
    }

    fn frames_of(&self, file: &Path, layout: &crate::layout::Layout) -> Vec<Result<Frame, OpenError>> {
        match rows_of(file, layout) {
            Ok(rows) => rows.chunks_exact(layout.width()).map(|row| Ok(self.frame(row))).collect(),
            Err(error) => vec![Err(error.into())],
        }
    }

    /// The frame of a row of the states, whose layout fits.
    fn frame(&self, row: &[f64]) -> Frame {
        let system = &self.simulation.assembly().system;
        let (coordinates, multipliers) = {
            use ancf::system::EquationsOfMotion;
            (system.coordinates(), system.multipliers())
        };
        let mut state = State::rest(coordinates, multipliers);
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
        Frame { row: head[0] as u64, value: head[1], state }
    }

    /// What a file of the results says about itself, such as `program` or `sha256`.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn about(&self, key: &str) -> Result<Option<String>, OpenError> {
        let file = files(&self.folder.results()).into_iter().next();
        Ok(file.map(|file| Reader::open(&file)).transpose()?.and_then(|reader| reader.about(key)))
    }
}
