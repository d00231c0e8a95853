use std::io::{self, Write as _};

use ancf_solver::equations::EquationsOfMotion;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::simulation::Simulation;
use super::step_control::{MOST, Pace, PaceMemory};
use super::summary::Summary;
use crate::failure::Watch;
use crate::model::Model;
use crate::results::{Past, Rows};

/// All on which the rest of a motion depends: a run goes on from it to the last bit as if it had never stopped
/// ([`Simulation::resume`]).
///
/// To be kept in a format that writes numbers exactly, as binary ones do. Of n coordinates and m multipliers it takes some
/// 8 (5n + 2m) bytes, another 8 (3n + m) where tangents are used again, 8 (n + m) with error control, and a few for each pair
/// in contact.
///
/// It goes with the very model and the version of this library that it was made by. Functions that the program supplies have to
/// be the same, and functions of time alone, as everywhere.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    version: u32,
    /// A hash of the model.
    model: u64,
    time: f64,
    counts: Counts,
    rows: Past,
    watch: Watch,
    pace: PaceMemory,
}

/// What has been counted so far.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Counts {
    steps: u64,
    divided_steps: u64,
    rejected_steps: u64,
    floor_steps: u64,
    iterations: u64,
    most_iterations: u32,
}

/// A checkpoint from which a simulation cannot go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Mismatch {
    /// Statics, modes and the like keep none.
    #[error("only motions go on from checkpoints: carry this analysis out anew")]
    Analysis,
    /// It was made by a version with another format.
    #[error("the checkpoint was made by another version of ancf (format {found}, here {wanted}): begin anew")]
    Version {
        /// Its format.
        found: u32,
        /// The format of this version.
        wanted: u32,
    },
    /// It belongs to another model.
    #[error("the checkpoint belongs to another model, or to this one before it was changed: begin anew")]
    Model,
    /// It makes no sense.
    #[error("the checkpoint is damaged: take an earlier one, or begin anew")]
    Damaged,
}

/// The format, and the way in which runs go on.
const VERSION: u32 = 1;

impl Checkpoint {
    /// Number of rows recorded before it; the next one has this number, counted from 0.
    pub fn rows(&self) -> u64 {
        self.pace.rows()
    }

    /// Its time, in the user's units.
    pub fn time(&self) -> f64 {
        self.time
    }

    pub(crate) fn new(model: u64, summary: &Summary, watch: &Watch, rows: &Rows, pace: &Pace<'_>) -> Self {
        let pace = pace.memory();
        let time = pace.time() * summary.scales.time;
        let (rows, watch) = (rows.past().clone(), watch.clone());
        Self { version: VERSION, model, time, counts: Counts::of(summary), rows, watch, pace }
    }

    /// Refuses what is not of a simulation, but for its numbers.
    pub(crate) fn check(&self, simulation: &Simulation) -> Result<(), Mismatch> {
        if self.version != VERSION {
            return Err(Mismatch::Version { found: self.version, wanted: VERSION });
        }
        if self.model != fingerprint(simulation) {
            return Err(Mismatch::Model);
        }
        let Counts { steps, divided_steps, rejected_steps, floor_steps, iterations, .. } = self.counts;
        let counts = [steps, divided_steps, rejected_steps, floor_steps, iterations];
        let coordinates = simulation.assembly.system.coordinates();
        let is_time = self.time == self.pace.time() * simulation.scales().time;
        if is_time && self.watch.fits(coordinates) && counts.iter().all(|count| *count <= MOST) {
            Ok(())
        } else {
            Err(Mismatch::Damaged)
        }
    }

    /// Puts a run that has begun where this one was.
    pub(crate) fn restore(
        &self,
        summary: &mut Summary,
        watch: &mut Watch,
        rows: &mut Rows,
        pace: &mut Pace<'_>,
    ) -> Result<(), Mismatch> {
        if !rows.go_on(&self.rows) || pace.recall(&self.pace).is_err() {
            return Err(Mismatch::Damaged);
        }
        self.counts.put(summary);
        watch.clone_from(&self.watch);
        summary.time = self.pace.time();
        Ok(())
    }
}

impl Counts {
    fn of(summary: &Summary) -> Self {
        Self {
            steps: summary.steps,
            divided_steps: summary.divided_steps,
            rejected_steps: summary.rejected_steps,
            floor_steps: summary.floor_steps,
            iterations: summary.iterations,
            most_iterations: summary.most_iterations,
        }
    }

    fn put(self, summary: &mut Summary) {
        summary.steps = self.steps;
        summary.divided_steps = self.divided_steps;
        summary.rejected_steps = self.rejected_steps;
        summary.floor_steps = self.floor_steps;
        summary.iterations = self.iterations;
        summary.most_iterations = self.most_iterations;
    }
}

/// A hash of all that a model says, in the units of the solver, and of these. It need not withstand malice.
///
/// Source: Fowler, Noll & Vo, FNV-1a of 64 bits.
pub(crate) fn fingerprint(simulation: &Simulation) -> u64 {
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    // It never fails: the model is plain data, and the hash takes everything.
    let _ = serde_json::to_writer(&mut hash, &(&simulation.scaled, &simulation.scales()));
    if simulation.scaled.is_extended() {
        // Parts of a program's own kinds are not data of the model.
        let Model { joints, loads, sections, .. } = &simulation.scaled;
        let _ = write!(hash, "{joints:?} {loads:?} {sections:?}");
    }
    hash.0
}

struct Hash(u64);

impl io::Write for Hash {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
