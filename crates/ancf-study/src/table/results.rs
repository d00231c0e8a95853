//! The cases that are done, kept in a file.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::Result;

use super::objective::Objectives;
use super::row::{Ending, Row};
use super::table::Table;
use crate::command::Ended;

/// The least time between two writings.
const PAUSE: Duration = Duration::from_secs(1);
/// Writing takes one part in so many of the time.
const SHARE: u32 = 50;

/// The cases that are done, and the file that has them.
pub struct Results<'a> {
    table: Table<'a>,
    path: PathBuf,
    /// The key of every case that is wanted.
    keys: BTreeMap<usize, String>,
    rows: BTreeMap<usize, Row>,
    counts: BTreeMap<Ending, usize>,
    taken_over: usize,
    /// Whether the file lacks something.
    is_due: bool,
    written: Instant,
    /// How long the last writing took.
    cost: Duration,
}

impl<'a> Results<'a> {
    /// No case done yet.
    pub fn new(table: Table<'a>, path: PathBuf, keys: BTreeMap<usize, String>) -> Self {
        let (rows, counts) = (BTreeMap::new(), BTreeMap::new());
        Self {
            table,
            path,
            keys,
            rows,
            counts,
            taken_over: 0,
            is_due: true,
            written: Instant::now(),
            cost: Duration::ZERO,
        }
    }

    /// Takes over what was done earlier, by key; with `retry` only what finished.
    pub fn take_over(&mut self, earlier: HashMap<String, Row>, retry: bool) {
        let missing = self.missing();
        for case in missing {
            let is_done = |row: &&Row| !retry || row.ending == Ending::Finished;
            if let Some(row) = earlier.get(&self.keys[&case]).filter(is_done) {
                self.add(case, row.clone());
            }
        }
        self.taken_over = self.rows.len();
    }

    /// The cases that are wanted and not done.
    pub fn missing(&self) -> Vec<usize> {
        self.keys.keys().copied().filter(|case| !self.rows.contains_key(case)).collect()
    }

    /// Adds what came of a case.
    pub fn add(&mut self, case: usize, row: Row) {
        *self.counts.entry(row.ending).or_default() += 1;
        self.rows.insert(case, row);
        self.is_due = true;
    }

    /// Writes if there is something new and writing does not come too often.
    pub fn write_when_due(&mut self) -> Result<()> {
        let is_time = self.written.elapsed() >= PAUSE.max(SHARE * self.cost);
        if self.is_due && is_time { self.write() } else { Ok(()) }
    }

    /// Writes all that is there.
    pub fn write(&mut self) -> Result<()> {
        let clock = Instant::now();
        let cases: Vec<_> = self.rows.iter().map(|(case, row)| (*case, &*self.keys[case], row)).collect();
        self.table.write(&self.path, &cases)?;
        (self.is_due, self.written, self.cost) = (false, Instant::now(), clock.elapsed());
        Ok(())
    }

    /// How many cases are done.
    pub fn done(&self) -> usize {
        self.rows.len()
    }

    /// How many cases are wanted.
    pub fn wanted(&self) -> usize {
        self.keys.len()
    }

    /// How many cases were taken over.
    pub const fn taken_over(&self) -> usize {
        self.taken_over
    }

    /// Cases and what came of them.
    pub fn rows(&self) -> impl Iterator<Item = (usize, &Row)> {
        self.rows.iter().map(|(case, row)| (*case, row))
    }

    /// How many cases ended in a way.
    pub fn count(&self, ending: Ending) -> usize {
        self.counts.get(&ending).copied().unwrap_or(0)
    }

    /// The objectives.
    pub const fn objectives(&self) -> &Objectives {
        self.table.objectives
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How the study ended.
    pub fn ended(&self) -> Ended {
        if self.done() < self.wanted() || self.count(Ending::Stopped) > 0 {
            Ended::Stopped
        } else if self.count(Ending::Finished) < self.done() {
            Ended::Failed
        } else {
            Ended::Done
        }
    }
}
