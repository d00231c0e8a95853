//! Runs that keep their rows to the last bit, and checkpoints.

use std::fs;
use std::io;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use ancf::analysis::Interrupt;
use ancf::system::State;
use ancf::{Checkpoint, Model, Observer, Simulation, Summary};

/// Rows as bits, and checkpoints as bytes.
#[derive(Default)]
pub(crate) struct Kept {
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<Vec<u64>>,
    pub(crate) checkpoints: Vec<Vec<u8>>,
    pub(crate) last: Option<Vec<u8>>,
    /// Keeps all checkpoints, or looks at none.
    takes: bool,
    /// Ends the run at so many rows.
    limit: Option<usize>,
}

pub(crate) fn bytes(checkpoint: &Checkpoint) -> Vec<u8> {
    postcard::to_stdvec(checkpoint).unwrap()
}

pub(crate) fn read(bytes: &[u8]) -> Checkpoint {
    postcard::from_bytes(bytes).unwrap()
}

impl Observer for Kept {
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
        if self.takes {
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

/// A whole run.
pub(crate) fn run(model: &Model, takes: bool) -> (Kept, Summary) {
    let mut kept = Kept { takes, ..Kept::default() };
    let summary = Simulation::new(model).unwrap().run(&mut kept).unwrap();
    (kept, summary)
}

/// A run that a sink ends at so many rows.
pub(crate) fn run_to(model: &Model, limit: usize) -> (Kept, Summary) {
    let mut kept = Kept { limit: Some(limit), ..Kept::default() };
    let summary = Simulation::new(model).unwrap().run(&mut kept).unwrap();
    (kept, summary)
}

/// A run that is interrupted when it asks for the `n`th time, and how often it asked.
pub(crate) fn interrupted(model: &Model, n: u64) -> (Kept, Summary, u64) {
    let asked = Arc::new(AtomicU64::new(0));
    let heard = Arc::clone(&asked);
    let interrupt = Interrupt::new(move || heard.fetch_add(1, Ordering::Relaxed) + 1 >= n);
    let mut kept = Kept::default();
    let summary = Simulation::new(model).unwrap().heeding(interrupt).run(&mut kept).unwrap();
    (kept, summary, asked.load(Ordering::Relaxed))
}

/// The rest of a run, by another simulation of the same model.
pub(crate) fn resumed(model: &Model, checkpoint: &[u8]) -> (Kept, Summary) {
    let mut kept = Kept { takes: true, ..Kept::default() };
    let summary = Simulation::new(model).unwrap().resume(&read(checkpoint), &mut kept).unwrap();
    (kept, summary)
}

/// A model of the folder of models, with another analysis and output.
pub(crate) fn file(name: &str, analysis: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../models/{name}.toml"));
    let text = fs::read_to_string(path).unwrap().replace("\r\n", "\n");
    let (model, _) = text.split_once("\n[analysis]").unwrap();
    parsed(&format!("{model}\n[analysis]\nkind = \"dynamics\"\n{analysis}\n"))
}

pub(crate) fn parsed(text: &str) -> Model {
    Model::parse(text).unwrap_or_else(|errors| {
        panic!("{text}\n{}", errors.iter().map(|error| format!("{error}\n")).collect::<String>())
    })
}
