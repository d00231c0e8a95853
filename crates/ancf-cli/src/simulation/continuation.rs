//! Continuation of a run from its last checkpoint.

use ancf::Simulation;
use ancf::solver::newton::Interrupt;
use ancf_results::{CheckpointError, CheckpointInterval, Recorder, Results};
use ancf_surface::BodySurfaces;
use anyhow::Result;

use super::recording::{Command, Recorded, record, run_from};
use crate::model::start_of;
use crate::terminal::{print_status, report_argument_error, report_model_errors};

/// Resumes a run from its last checkpoint, or from the beginning if there is none.
pub fn resume(
    command: Command,
    results: &Results,
    interval: CheckpointInterval,
    interrupt: &Interrupt,
) -> Result<Recorded> {
    let (folder, text, model) = (results.folder().clone(), results.text(), results.model());
    let simulation = Simulation::new(model)?.with_interrupt(interrupt.clone());
    let resumed = match Recorder::resume(folder.clone(), text, model, &simulation) {
        Err(error @ CheckpointError::Damaged { .. }) => {
            return Ok(Recorded::rejected(report_argument_error(&error.to_string())));
        }
        resumed => resumed?,
    };
    if let Some((recorder, from)) = resumed {
        print_status(&format!("resuming from t = {}", from.time()));
        let recorder = recorder.with_checkpoints(interval);
        return record(command, model, recorder, |observer| simulation.resume(&from, observer));
    }
    print_status("no checkpoint found: starting from the beginning");
    let file = folder.model();
    let start = match start_of(model, &simulation, text, &file) {
        Ok(start) => start,
        Err(errors) => return Ok(Recorded::rejected(report_model_errors(&errors, &file))),
    };
    let (surfaces, _) = BodySurfaces::of_run(model, folder.path());
    let recorder = Recorder::new(folder, &file.display().to_string(), text, model, &simulation);
    let recorder = recorder.with_checkpoints(interval).with_display(surfaces.files()?);
    record(command, model, recorder, |observer| run_from(&simulation, start.as_ref(), observer))
}
