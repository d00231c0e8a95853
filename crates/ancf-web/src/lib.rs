//! Solver and reports in the browser, without files and threads: the library of the playground.
//!
//! ```text
//!   lib          interface of the web worker: texts, bytes and a callback
//!    |
//!  live_run      run of a model text: rows, states and scenes during the run
//!   /    \
//! frames  problems   states of the scene; errors and warnings with their places
//!         handles    points of the model that one drags
//! ```
//!
//! The analyses are those of [`ancf`], and the scenes those of [`ancf_report`]. The results have the digits of a native run, up to
//! the differences of the vector instructions.

mod frames;
mod handles;
mod live_run;
mod problems;

use js_sys::{Function, Uint8Array};
use wasm_bindgen::prelude::*;

pub use handles::{Handle, handles, moved};
pub use live_run::{LiveRun, RunRecord};
pub use problems::{Problem, Severity, problems};

/// Returns the errors and warnings of a model text as a JSON array of [`Problem`]s.
#[wasm_bindgen]
pub fn check(text: &str) -> String {
    serde_json::to_string(&problems(text)).unwrap_or_default()
}

/// Returns the points of a model text that one drags as a JSON array of [`Handle`]s.
#[wasm_bindgen]
pub fn handle_list(text: &str) -> String {
    serde_json::to_string(&handles(text)).unwrap_or_default()
}

/// Returns the text of a model in which a point that one drags has other coordinates; the same text if there is no such point.
#[wasm_bindgen]
pub fn moved_text(text: &str, number: usize, x: f64, y: f64, z: f64) -> String {
    moved(text, number, [x, y, z]).unwrap_or_else(|| text.to_owned())
}

/// Runs a model text. `update` receives the scene of the results so far, as a `Uint8Array`, several times during the run.
///
/// # Errors
/// The errors of the model as one text.
#[wasm_bindgen]
pub fn run(text: &str, title: &str, update: &Function) -> Result<RunResult, JsError> {
    let run = LiveRun { text, title };
    let mut send = |scene: &[u8]| {
        // An error of the page does not affect the run.
        let _ = update.call1(&JsValue::NULL, &Uint8Array::from(scene));
    };
    run.run(&mut send).map(RunResult).map_err(|error| JsError::new(&error.to_string()))
}

/// Results of a complete run.
#[wasm_bindgen]
#[derive(Debug)]
pub struct RunResult(RunRecord);

#[wasm_bindgen]
impl RunResult {
    /// Scene for the viewer.
    pub fn scene(&self) -> Vec<u8> {
        self.0.scene.clone()
    }

    /// All rows as comma-separated values, as in `probes.csv`.
    pub fn csv(&self) -> String {
        self.0.csv.clone()
    }

    /// Outcome in one sentence.
    pub fn sentence(&self) -> String {
        self.0.sentence.clone()
    }

    /// True if the analysis was completed.
    pub fn is_finished(&self) -> bool {
        self.0.is_finished
    }
}
