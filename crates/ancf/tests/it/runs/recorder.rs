//! Runs that record rows as bits and checkpoints as bytes.

use std::fs;
use std::io;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use ancf::solver::equations::State;
use ancf::solver::newton::Interrupt;
use ancf::{Checkpoint, Model, Observer, Simulation, Summary};

use crate::common::models::parse;

/// Observer that records rows as bits and checkpoints as bytes.
#[derive(Default)]
pub(crate) struct Recorder {
    pub(super) columns: Vec<String>,
    pub(crate) rows: Vec<Vec<u64>>,
    pub(super) checkpoints: Vec<Vec<u8>>,
    pub(super) last: Option<Vec<u8>>,
    /// True if all checkpoints are recorded.
    checkpointed: bool,
    /// Number of rows after which the run ends.
    limit: Option<usize>,
}

/// Serialises a checkpoint.
pub(super) fn bytes(checkpoint: &Checkpoint) -> Vec<u8> {
    postcard::to_stdvec(checkpoint).unwrap()
}

/// Deserialises a checkpoint.
pub(super) fn read(bytes: &[u8]) -> Checkpoint {
    postcard::from_bytes(bytes).unwrap()
}

impl Observer for Recorder {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.columns = columns.to_vec();
        Ok(())
    }

    fn record(&mut self, row: &[f64], _: &State) -> io::Result<ControlFlow<()>> {
        self.rows.push(row.iter().map(|x| x.to_bits()).collect());
        let is_enough = self.limit.is_some_and(|limit| self.rows.len() >= limit);
        Ok(if is_enough { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }

    fn checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        if self.checkpointed {
            self.checkpoints.push(bytes(&take()));
        }
        Ok(())
    }

    fn last_checkpoint(&mut self, take: &dyn Fn() -> Checkpoint) -> io::Result<()> {
        self.last = Some(bytes(&take()));
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Runs a model to its end.
pub(crate) fn run(model: &Model, checkpointed: bool) -> (Recorder, Summary) {
    let mut recorder = Recorder { checkpointed, ..Recorder::default() };
    let summary = Simulation::new(model).unwrap().run(&mut recorder).unwrap();
    (recorder, summary)
}

/// Runs a model; the observer ends the run after a number of rows.
pub(super) fn run_to(model: &Model, limit: usize) -> (Recorder, Summary) {
    let mut recorder = Recorder { limit: Some(limit), ..Recorder::default() };
    let summary = Simulation::new(model).unwrap().run(&mut recorder).unwrap();
    (recorder, summary)
}

/// Runs a model with an interrupt at its `n`th query, and returns the number of queries.
pub(super) fn interrupted(model: &Model, n: u64) -> (Recorder, Summary, u64) {
    let queries = Arc::new(AtomicU64::new(0));
    let counter = Arc::clone(&queries);
    let interrupt = Interrupt::new(move || counter.fetch_add(1, Ordering::Relaxed) + 1 >= n);
    let mut recorder = Recorder::default();
    let summary = Simulation::new(model).unwrap().with_interrupt(interrupt).run(&mut recorder).unwrap();
    (recorder, summary, queries.load(Ordering::Relaxed))
}

/// Resumes a run by another simulation of the same model.
pub(super) fn resumed(model: &Model, checkpoint: &[u8]) -> (Recorder, Summary) {
    let mut recorder = Recorder { checkpointed: true, ..Recorder::default() };
    let summary = Simulation::new(model).unwrap().resume(&read(checkpoint), &mut recorder).unwrap();
    (recorder, summary)
}

/// Reads `models/{name}.toml` with another analysis and output.
pub(super) fn file(name: &str, analysis: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../models/{name}.toml"));
    let text = fs::read_to_string(path).unwrap().replace("\r\n", "\n");
    let (model, _) = text.split_once("\n[analysis]").unwrap();
    parse(&format!("{model}\n[analysis]\nkind = \"dynamics\"\n{analysis}\n"))
}
