//! `ancf paraview`: the results of a run as files for ParaView.

use std::collections::BTreeSet;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use ancf_report::Snapshot;
use ancf_report::paraview::{FrameSelection, Writer};
use ancf_results::Results;
use ancf_surface::BodySurfaces;
use anyhow::Result;
use clap::Args;

use super::run_folder::{open_run, recording, title};
use crate::terminal::{Ended, print, print_error, print_status, report_argument_error};

/// Arguments of `ancf paraview`.
#[derive(Debug, Args)]
pub struct ParaviewArguments {
    /// Results folder, also during the run.
    folder: PathBuf,
    /// Folder for the files; paraview in the folder of the run by default.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Maximum number of frames, evenly spaced; all by default.
    #[arg(long, value_name = "N")]
    frames: Option<NonZeroUsize>,
    /// First time, load factor or mode number.
    #[arg(long, value_name = "VALUE", default_value_t = f64::NEG_INFINITY, hide_default_value = true, allow_negative_numbers = true)]
    from: f64,
    /// Last time, load factor or mode number.
    #[arg(long, value_name = "VALUE", default_value_t = f64::INFINITY, hide_default_value = true, allow_negative_numbers = true)]
    to: f64,
}

/// Examples of the help.
pub const PARAVIEW_EXAMPLES: &str = "\
Examples:
  ancf run models/bow.toml -o out && ancf paraview out    writes out/paraview/sections.pvd, lines.pvd
  ancf paraview out -o vtk --frames 50 --from 0.5         50 frames from time 0.5

Open sections.pvd (surfaces) or lines.pvd (axes) in ParaView. The run may still be running, or
may have been killed.";

impl ParaviewArguments {
    /// Writes the files, one frame in memory at a time.
    pub fn run(&self) -> Result<Ended> {
        let results = match open_run(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let values: Vec<f64> =
            results.frames().map(|frame| frame.map(|frame| frame.value)).collect::<Result<_, _>>()?;
        if values.is_empty() {
            let folder = self.folder.display();
            return Ok(report_argument_error(&format!(
                "{folder} contains no stored states: the run failed before the first one, `output.states` is 0, or their \
                 file was removed"
            )));
        }
        let most = self.frames.map_or(usize::MAX, NonZeroUsize::get);
        let picked = FrameSelection { from: self.from, to: self.to, most }.pick(&values);
        if picked.is_empty() {
            let span =
                values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
            return Ok(report_argument_error(&format!(
                "there is no frame from {} to {}; there are {} frames from {} to {}",
                self.from,
                self.to,
                values.len(),
                span[0],
                span[1]
            )));
        }
        self.write(&results, &picked.into_iter().collect())
    }

    fn write(&self, results: &Results, picked: &BTreeSet<usize>) -> Result<Ended> {
        let (title, series) = (title(results), results.columns()?);
        let (surfaces, missing) = BodySurfaces::of_run(results.model(), results.folder().path());
        missing.iter().for_each(|message| print_error(&format!("warning: {message}")));
        let recording = recording(results, &title, &series, &surfaces);
        let output = self.output.clone().unwrap_or_else(|| self.folder.join("paraview"));
        let mut writer = Writer::new(&recording, &output)?;
        // A run in progress may have added frames since they were counted.
        let selected = results.frames().enumerate().filter(|(number, _)| picked.contains(number));
        for (_, frame) in selected {
            let ancf_results::StoredState { value, state, .. } = frame?;
            writer.push(&Snapshot { value, state })?;
        }
        let written = writer.finish()?;
        for file in &written.files {
            print(&format!("{}\n", file.display()));
        }
        if written.left_out > 0 {
            print_status(&format!("{} frames omitted: positions that are not finite", written.left_out));
        }
        Ok(Ended::Done)
    }
}
