//! Rows of a study and the file that keeps them.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::error::StudyError;
use super::range::ObjectiveRange;
use super::write::StudyTable;
use crate::cases::{CaseDesign, CaseOutcome, CaseRow};
use crate::statement::Objectives;

/// Minimum time between two writes.
const MIN_INTERVAL: Duration = Duration::from_secs(1);
/// Upper limit on the share of time spent on writing, as a reciprocal.
const WRITE_SHARE: u32 = 50;

/// Outcome of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StudyOutcome {
    /// All cases finished.
    Finished,
    /// Some cases failed or are invalid.
    Failed,
    /// The study was interrupted.
    Stopped,
}

/// Rows of the cases, and the file that keeps them.
#[derive(Debug)]
pub struct StudyResults {
    design: CaseDesign,
    objectives: Objectives,
    /// Text of the study file.
    text: String,
    path: PathBuf,
    /// Key of every requested case.
    keys: BTreeMap<usize, String>,
    rows: BTreeMap<usize, CaseRow>,
    counts: BTreeMap<CaseOutcome, usize>,
    taken_over: usize,
    /// True if rows were added since the last write.
    is_modified: bool,
    written: Instant,
    /// Duration of the last write.
    write_time: Duration,
}

impl StudyResults {
    /// Creates results without rows, for the cases in `keys`.
    pub fn new(
        design: CaseDesign,
        objectives: Objectives,
        text: String,
        path: PathBuf,
        keys: BTreeMap<usize, String>,
    ) -> Self {
        Self {
            design,
            objectives,
            text,
            path,
            keys,
            rows: BTreeMap::new(),
            counts: BTreeMap::new(),
            taken_over: 0,
            is_modified: true,
            written: Instant::now(),
            write_time: Duration::ZERO,
        }
    }

    /// Takes over rows of earlier runs by key. With `retry`, only finished ones.
    pub fn take_over(&mut self, earlier: &HashMap<String, CaseRow>, retry: bool) {
        for case in self.missing() {
            let is_done = |row: &&CaseRow| !retry || row.outcome == CaseOutcome::Finished;
            if let Some(row) = earlier.get(&self.keys[&case]).filter(is_done) {
                self.add(case, row.clone());
            }
        }
        self.taken_over = self.rows.len();
    }

    /// Returns the requested cases without a row.
    pub fn missing(&self) -> Vec<usize> {
        self.keys.keys().copied().filter(|case| !self.rows.contains_key(case)).collect()
    }

    /// Adds the row of a case.
    pub fn add(&mut self, case: usize, row: CaseRow) {
        *self.counts.entry(row.outcome).or_default() += 1;
        self.rows.insert(case, row);
        self.is_modified = true;
    }

    /// Writes the table if there are new rows and the last write was long enough ago.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_if_due(&mut self) -> Result<(), StudyError> {
        let is_due = self.written.elapsed() >= MIN_INTERVAL.max(WRITE_SHARE * self.write_time);
        if self.is_modified && is_due { self.write() } else { Ok(()) }
    }

    /// Writes the table.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&mut self) -> Result<(), StudyError> {
        let clock = Instant::now();
        let cases: Vec<_> = self.rows.iter().map(|(case, row)| (*case, &*self.keys[case], row)).collect();
        let table = StudyTable { axes: self.design.axes(), objectives: &self.objectives, text: &self.text };
        table.write(&self.path, &cases)?;
        (self.is_modified, self.written, self.write_time) = (false, Instant::now(), clock.elapsed());
        Ok(())
    }

    /// Returns the number of cases with a row.
    pub fn done(&self) -> usize {
        self.rows.len()
    }

    /// Returns the number of requested cases.
    pub fn requested(&self) -> usize {
        self.keys.len()
    }

    /// Returns the number of cases taken over from earlier runs.
    pub const fn taken_over(&self) -> usize {
        self.taken_over
    }

    /// Returns the cases and their rows, in the order of the cases.
    pub fn rows(&self) -> impl Iterator<Item = (usize, &CaseRow)> {
        self.rows.iter().map(|(case, row)| (*case, row))
    }

    /// Returns the number of cases with an outcome.
    pub fn count(&self, outcome: CaseOutcome) -> usize {
        self.counts.get(&outcome).copied().unwrap_or(0)
    }

    /// Returns the design.
    pub const fn design(&self) -> &CaseDesign {
        &self.design
    }

    /// Returns the objectives.
    pub const fn objectives(&self) -> &Objectives {
        &self.objectives
    }

    /// Returns the path of the table.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the range of an objective, by its index in the order of the names.
    pub fn range(&self, objective: usize) -> ObjectiveRange {
        let values = self.rows.values().filter_map(|row| row.objectives.get(objective).copied().flatten());
        ObjectiveRange::of(values)
    }

    /// Returns the outcome of the study.
    pub fn outcome(&self) -> StudyOutcome {
        if self.done() < self.requested() || self.count(CaseOutcome::Stopped) > 0 {
            StudyOutcome::Stopped
        } else if self.count(CaseOutcome::Finished) < self.done() {
            StudyOutcome::Failed
        } else {
            StudyOutcome::Finished
        }
    }
}
