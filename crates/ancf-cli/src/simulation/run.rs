//! `ancf run`: runs a model file and writes its results into a folder.

use std::path::{Path, PathBuf};

use ancf::estimate::MeshStep;
use ancf::reading::{AnalysisSequence, ModelFile, ValidModel, with_places};
use ancf::{Model, ModelErrors, Observer, RefinedModel, Simulation, can_refine, refine};
use ancf_report::BUDGET;
use ancf_results::{CheckpointInterval, Folder, Recorder, sequence_file, write_sequence};
use anyhow::Result;
use clap::Args;

use super::model_text::{with_elements, with_errors};
use super::recording::{Command, checkpoint_interval, record, run_from};
use super::requested_error::requested_error;
use super::sequence::SequenceRun;
use crate::model::{check_stages, start_of, surfaces_of};
use crate::results::{REPORT, write_report};
use crate::terminal::{
    Ended, interrupt, print_error, print_status, report_argument_error, report_model_errors,
};

/// Arguments of `ancf run`.
#[derive(Debug, Args)]
pub struct RunArguments {
    /// Model file (TOML).
    file: PathBuf,
    /// Folder for results.parquet, states.parquet, probes.csv and summary.json; by default the name of the file without its ending.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Interval of checkpoints for `ancf resume`: a number of steps (1000) or a time (30s, 10min).
    #[arg(long, value_name = "EVERY", default_value = "5min", value_parser = checkpoint_interval)]
    checkpoint: CheckpointInterval,
    /// Refine the bodies until the estimated error of the mesh is at most ERROR: 1% or 0.01 (statics, modes, buckling).
    #[arg(long, value_name = "ERROR", value_parser = requested_error)]
    to: Option<f64>,
    /// Estimate the errors of all recorded values, columns `p.x_error` and so on, as `output.errors = true` (dynamics, statics; with shells also modes and buckling).
    #[arg(long)]
    errors: bool,
    /// Write the report of the results and open it in the browser.
    #[arg(long)]
    open: bool,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const RUN_EXAMPLES: &str = "\
Examples:
  ancf run models/cantilever.toml                 a motion; the results are in the folder cantilever
  ancf run models/bow.toml --open                 the report opens in the browser
  ancf run models/elastica.toml -o out            an equilibrium
  ancf run models/lees_frame.toml -o out          an equilibrium path with snap-through
  ancf run models/tuning_fork.toml -o out         natural frequencies, also printed
  ancf run models/column.toml -o out              critical loads, also printed
  ancf run models/elastica.toml -o out --to 0.1%  with as many elements as this error requires
  ancf run models/rotor.toml -o out --errors      errors of the time steps and of the mesh
  ancf run models/bow.toml -o out --json          summary for scripts

Ctrl-C or SIGTERM stops the run with exit code 130 or 143; `ancf resume` resumes it.";

impl RunArguments {
    /// Runs the model and opens its report on request.
    pub fn run(&self) -> Result<Ended> {
        let folder = match self.folder() {
            Ok(folder) => folder,
            Err(message) => return Ok(report_argument_error(&message)),
        };
        let (ended, folder) = self.run_into(folder)?;
        if self.open && ended == Ended::Done {
            let report = folder.join(REPORT);
            if let Some(ended) = write_report(&folder, &report, BUDGET)? {
                return Ok(ended);
            }
            if let Err(error) = open::that_detached(&report) {
                print_error(&format!("warning: no browser for {}: {error}", report.display()));
            }
        }
        Ok(ended)
    }

    /// Folder of the results.
    fn folder(&self) -> Result<PathBuf, String> {
        let chosen = self.output.clone().or_else(|| self.file.file_stem().map(PathBuf::from));
        let folder = chosen.ok_or_else(|| format!("{} is not a file", self.file.display()))?;
        if folder.exists() && !folder.is_dir() {
            return Err(format!("{} is a file, expected a folder for the results", folder.display()));
        }
        if self.output.is_none() && !Folder::new(&folder).is_free() && !sequence_file(&folder).exists() {
            return Err(format!(
                "the folder {} contains other files than results; choose the folder of the results with `-o`",
                folder.display()
            ));
        }
        Ok(folder)
    }

    /// Runs the model into a folder. Returns also the folder of the last results.
    fn run_into(&self, folder: PathBuf) -> Result<(Ended, PathBuf)> {
        let read = Model::read_text(&self.file).and_then(|text| Ok((ModelFile::parse(&text)?, text)));
        match read {
            Err(errors) => Ok((report_model_errors(&errors, &self.file), folder)),
            Ok((ModelFile::Single(model), text)) => Ok((self.run_single(*model, text, &folder)?, folder)),
            Ok((ModelFile::Sequence(sequence), text)) => self.run_sequence(text, sequence, folder),
        }
    }

    fn run_sequence(
        &self,
        mut text: String,
        mut sequence: AnalysisSequence,
        folder: PathBuf,
    ) -> Result<(Ended, PathBuf)> {
        if self.to.is_some() {
            let message = "--to: refines the mesh of a single analysis, and the file has a list of analyses";
            return Ok((report_argument_error(message), folder));
        }
        if self.errors {
            text = with_errors(&text)?;
            match AnalysisSequence::parse(&text) {
                Ok(changed) => sequence = changed.unwrap_or(sequence),
                Err(errors) => return Ok((report_model_errors(&errors, &self.file), folder)),
            }
        }
        let checked = check_stages(&sequence, &text);
        let surfaces = checked.and_then(|()| surfaces_of(&sequence.stages[0].model, &text, &self.file));
        let surfaces = match surfaces {
            Ok(surfaces) => surfaces,
            Err(errors) => return Ok((report_model_errors(&errors, &self.file), folder)),
        };
        write_sequence(&folder, &text)?;
        let (file, checkpoint) = (self.file.as_path(), self.checkpoint);
        let ended = SequenceRun { file, folder: &folder, surfaces, checkpoint, interrupt: interrupt()? }
            .run(&sequence, false)?;
        let last = sequence.stages.last().map(|stage| folder.join(&stage.folder));
        Ok((ended, last.unwrap_or(folder)))
    }

    /// Model with error estimates, if they are requested.
    fn with_estimates(&self, model: ValidModel) -> Result<ValidModel, ModelErrors> {
        if !self.errors || model.output.errors {
            return Ok(model);
        }
        let mut model = model.into_model();
        model.output.errors = true;
        ValidModel::new(model)
    }

    fn run_single(&self, model: ValidModel, text: String, folder: &Path) -> Result<Ended> {
        let located = |errors| with_places(errors, &text);
        let prepared = self.with_estimates(model).map_err(located).and_then(|model| {
            let surfaces = surfaces_of(&model, &text, &self.file)?;
            let simulation = Simulation::of_valid(&model).map_err(located)?;
            let start = start_of(&model, &simulation, &text, &self.file)?;
            Ok((model, simulation, surfaces, start))
        });
        let (model, simulation, surfaces, start) = match prepared {
            Ok(prepared) => prepared,
            Err(errors) => return Ok(report_model_errors(&errors, &self.file)),
        };
        let text = if self.errors { with_errors(&text)? } else { text };
        let (name, display) = (self.file.display().to_string(), surfaces.files()?);
        let recorder = |text: &str, model: &Model, simulation: &Simulation| {
            Recorder::new(Folder::new(folder), &name, text, model, simulation)
                .with_checkpoints(self.checkpoint)
                .with_display(display.clone())
        };
        let Some(requested) = self.to else {
            let simulation = simulation.with_interrupt(interrupt()?);
            let recorder = recorder(&text, &model, &simulation);
            let run = |observer: &mut dyn Observer| run_from(&simulation, start.as_ref(), observer);
            return Ok(record(Command::Single, &model, recorder, run)?.ended);
        };
        if !can_refine(&model.analysis) || start.is_some() {
            return Ok(report_argument_error(
                "--to: refines the meshes of statics, modes and buckling that start in the undeformed state; `--errors` states the \
                 errors of motions",
            ));
        }
        let on_mesh = |number: usize, mesh: &MeshStep| print_status(&format!("mesh {number}: {mesh}"));
        let RefinedModel { model, simulation, history } = refine(&model, requested, &interrupt()?, on_mesh)?;
        let text = with_elements(&text, &model)?;
        let text = if model.output.errors { with_errors(&text)? } else { text };
        let recorded = record(Command::Single, &model, recorder(&text, &model, &simulation), |observer| {
            let mut summary = simulation.run(observer)?;
            history.add_to(&mut summary);
            Ok(summary)
        });
        Ok(recorded?.ended)
    }
}
