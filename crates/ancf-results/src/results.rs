use std::borrow::Borrow;
use std::fs;
use std::io;
use std::iter;
use std::path::{Path, PathBuf};

use ancf::model::ModelErrors;
use ancf::record::{Series, Sink};
use ancf::system::{EquationsOfMotion, State};
use ancf::{Model, Simulation};
use thiserror::Error;

use crate::Conclusion;
use crate::folder::{Folder, about};
use crate::frames;
use crate::layout::Layout;
use crate::read::{about_table, rows_of};

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

/// What there is to say of a run that is [`Status::Broken`].
pub const KILLED: &str = "the run ended without a word: it was killed; `ancf resume` goes on with it";

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
            text => text.map_err(|error| about(&error, &file))?,
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
                let bytes = bytes.map_err(|error| about(&error, &path))?;
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
        let layout = Layout::new(names, Vec::new());
        for part in parts_of(self.folder.results(), &layout) {
            for row in part?.chunks_exact(layout.width().max(1)) {
                let _ = series.record(row)?;
            }
        }
        Ok(series)
    }

    /// The states that were kept, as far as they are on the disk, one part in memory at a time.
    pub fn frames(&self) -> impl Iterator<Item = Result<Frame, OpenError>> + '_ {
        let layout = frames::layout(&self.simulation);
        let width = layout.width();
        parts_of(self.folder.states(), layout).flat_map(move |part| match part {
            Ok(rows) => rows.chunks_exact(width).map(|row| Ok(self.frame(row))).collect(),
            Err(error) => vec![Err(error.into())],
        })
    }

    /// The frame of a row of the states, whose layout fits.
    fn frame(&self, row: &[f64]) -> Frame {
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
        Frame { row: head[0] as u64, value: head[1], state }
    }

    /// What a file of the results says about itself, such as `program` or `sha256`.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn about(&self, key: &str) -> Result<Option<String>, OpenError> {
        Ok(about_table(&self.folder.results(), key)?)
    }
}

/// The rows of a table part by part, to the last one, which may be growing, or to one that cannot be read.
fn parts_of(path: PathBuf, layout: impl Borrow<Layout>) -> impl Iterator<Item = io::Result<Vec<f64>>> {
    let mut next = Some(0);
    iter::from_fn(move || {
        let number = next?;
        let part = rows_of(&path, layout.borrow(), number).transpose();
        next = matches!(part, Some(Ok(_))).then_some(number + 1);
        part
    })
}
