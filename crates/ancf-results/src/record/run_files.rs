use std::fs::File;
use std::io::{self, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use ancf::model::Output;
use ancf::record::{Csv, Sink};
use ancf::solver::equations::State;
use serde::{Deserialize, Serialize};

use crate::folder::{Folder, with_path};
use crate::table::{GrowingTable, Layout, Provenance, numbers_of_state};

/// Folder, columns and provenance of the files of a run.
#[derive(Debug)]
pub(super) struct FileSpec {
    pub folder: Folder,
    pub output: Output,
    pub provenance: Provenance,
    pub columns: Layout,
    pub states: Layout,
}

/// Open files of a run. Files that the model does not request are `None`.
#[derive(Debug)]
pub(super) struct RunFiles {
    csv: Option<CsvFile>,
    results: Option<GrowingTable>,
    states: Option<GrowingTable>,
}

/// Lengths of the files at a checkpoint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct FileLengths {
    /// Bytes of `probes.csv`.
    csv: u64,
    /// Rows of the columns.
    results: u64,
    /// Number of states.
    states: u64,
}

impl FileSpec {
    /// Creates new files.
    pub(super) fn create(&self) -> io::Result<RunFiles> {
        let Output { csv, parquet, states, .. } = self.output;
        let new_states = || {
            let provenance = self.provenance.without_units();
            GrowingTable::create(&self.folder.states(), self.states.clone(), &provenance)
        };
        let results = || GrowingTable::create(&self.folder.results(), self.columns.clone(), &self.provenance);
        Ok(RunFiles {
            csv: csv.then(|| CsvFile::create(self.folder.csv(), &self.columns.numbers)).transpose()?,
            results: parquet.then(results).transpose()?,
            states: (states > 0).then(new_states).transpose()?,
        })
    }

    /// Reopens the files and truncates them to their lengths at a checkpoint.
    pub(super) fn reopen(&self, lengths: &FileLengths) -> io::Result<RunFiles> {
        let Output { csv, parquet, states, .. } = self.output;
        let (folder, provenance) = (&self.folder, &self.provenance);
        let results =
            || GrowingTable::reopen(&folder.results(), self.columns.clone(), provenance, lengths.results);
        let old_states = || {
            let provenance = provenance.without_units();
            GrowingTable::reopen(&folder.states(), self.states.clone(), &provenance, lengths.states)
        };
        Ok(RunFiles {
            csv: csv.then(|| CsvFile::reopen(folder.csv(), lengths.csv)).transpose()?,
            results: parquet.then(results).transpose()?,
            states: (states > 0).then(old_states).transpose()?,
        })
    }
}

impl RunFiles {
    /// Writes a row of the columns.
    pub(super) fn write_row(&mut self, row: &[f64]) -> io::Result<()> {
        if let Some(csv) = &mut self.csv {
            csv.write(row)?;
        }
        self.results.as_mut().map_or(Ok(()), |table| table.push(&[row]))
    }

    /// Writes a state, given the number of its row, and the first number and the counted angles of the row.
    pub(super) fn write_state(
        &mut self,
        row: u64,
        first: f64,
        state: &State,
        angles: &[f64],
    ) -> io::Result<()> {
        let Some(table) = &mut self.states else { return Ok(()) };
        let head = [row as f64, first, state.load];
        let [q, v, a, lambda] = numbers_of_state(state);
        table.push(&[&head, q, v, a, lambda, angles])
    }

    /// Writes all rows and states to the disk.
    pub(super) fn flush(&mut self) -> io::Result<()> {
        if let Some(csv) = &mut self.csv {
            csv.flush()?;
        }
        [&mut self.results, &mut self.states].into_iter().flatten().try_for_each(GrowingTable::flush)
    }

    /// Returns the lengths of the flushed files, once `probes.csv` is on the disk.
    pub(super) fn lengths(&self) -> io::Result<FileLengths> {
        let rows = |table: &Option<GrowingTable>| table.as_ref().map_or(0, GrowingTable::rows);
        let csv = self.csv.as_ref().map_or(Ok(0), CsvFile::synced_length)?;
        Ok(FileLengths { csv, results: rows(&self.results), states: rows(&self.states) })
    }

    /// Merges the parts of each table, of the second one even if the first one fails.
    pub(super) fn finish(self) -> io::Result<()> {
        let tables = [self.results, self.states].into_iter().flatten();
        let finished: Vec<_> = tables.map(|mut table| table.finish()).collect();
        finished.into_iter().collect()
    }
}

/// File `probes.csv` with its path, for errors.
#[derive(Debug)]
struct CsvFile {
    path: PathBuf,
    csv: Csv<File>,
}

impl CsvFile {
    fn create(path: PathBuf, columns: &[String]) -> io::Result<Self> {
        let create = || {
            let mut csv = Csv::new(File::create(&path)?);
            Sink::begin(&mut csv, columns)?;
            Ok(csv)
        };
        let csv = create().map_err(|error| with_path(&error, &path))?;
        Ok(Self { path, csv })
    }

    /// Opens an existing file and truncates it to a number of bytes.
    fn reopen(path: PathBuf, bytes: u64) -> io::Result<Self> {
        let open = || {
            let mut file = File::options().write(true).open(&path)?;
            if file.metadata()?.len() < bytes {
                return Err(io::Error::new(io::ErrorKind::InvalidData, "rows are missing"));
            }
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            Ok(Csv::new(file))
        };
        let csv = open().map_err(|error| with_path(&error, &path))?;
        Ok(Self { path, csv })
    }

    fn write(&mut self, row: &[f64]) -> io::Result<()> {
        let _ = Sink::record(&mut self.csv, row).map_err(|error| with_path(&error, &self.path))?;
        Ok(())
    }

    fn flush(&mut self) -> io::Result<()> {
        Sink::finish(&mut self.csv).map_err(|error| with_path(&error, &self.path))
    }

    /// Length of the file, once its contents are on the disk.
    fn synced_length(&self) -> io::Result<u64> {
        let length = |path: &Path| {
            // Windows writes files to the disk only for those who may write to them.
            let file = File::options().write(true).open(path)?;
            file.sync_all()?;
            Ok(file.metadata()?.len())
        };
        length(&self.path).map_err(|error: io::Error| with_path(&error, &self.path))
    }
}
