//! The result files of a run.

use std::fs::{self, File};
use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use ancf::model::Output;
use ancf::record::{Csv, Every, Npz, Sink};

/// A folder with the files that a model asks for. It comes into being when the run begins, so that bad input leaves none.
pub struct Folder {
    path: PathBuf,
    output: Output,
    files: Vec<Box<dyn Sink>>,
}

impl Folder {
    /// Results will be written into `path`.
    pub fn new(path: &Path, output: Output) -> Self {
        Self { path: path.to_owned(), output, files: Vec::new() }
    }

    fn create(&self, name: &str) -> io::Result<File> {
        let path = self.path.join(name);
        File::create(&path).map_err(|error| annotate(&error, &path))
    }
}

fn annotate(error: &io::Error, path: &Path) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

impl Sink for Folder {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        fs::create_dir_all(&self.path).map_err(|error| annotate(&error, &self.path))?;
        // What an earlier run left must not be taken for results of this one.
        for name in ["probes.csv", "probes.npz", "summary.json"] {
            match fs::remove_file(self.path.join(name)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(annotate(&error, &self.path));
                }
                _ => {}
            }
        }
        let every = self.output.every;
        if self.output.csv {
            self.files.push(Box::new(Every::new(every, Csv::new(self.create("probes.csv")?))));
        }
        if self.output.npz {
            self.files.push(Box::new(Every::new(every, Npz::new(self.create("probes.npz")?))));
        }
        self.files.begin(columns)
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        self.files.record(row)
    }

    fn finish(&mut self) -> io::Result<()> {
        self.files.finish()
    }
}
