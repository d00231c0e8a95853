//! Run of a model text, with scenes during the run.

use std::io;
use std::ops::ControlFlow;

use ancf::model::Analysis;
use ancf::reading::ValidModel;
use ancf::record::{Csv, Series, Sink};
use ancf::solver::equations::State;
use ancf::{Error, Model, Observer, Simulation};
use ancf_report::{Ending, Recording, scene, summary_rows, summary_warnings};
use ancf_surface::BodySurfaces;
use web_time::{Duration, Instant};

use crate::frames::Frames;

/// Budget of a scene in bytes.
const BUDGET: usize = 16 << 20;
/// Maximum number of states of modes and equilibrium paths, of which each is drawn.
const SHAPES: usize = 1000;
/// Shortest time between two scenes.
const INTERVAL: Duration = Duration::from_millis(300);
/// Time between two scenes, relative to the time to build one.
const SHARE: u32 = 8;

/// Run of a model text.
#[derive(Clone, Copy, Debug)]
pub struct LiveRun<'a> {
    /// Text of the model file.
    pub text: &'a str,
    /// Heading, unless the model has a title.
    pub title: &'a str,
}

/// Results of a run.
#[derive(Clone, Debug)]
pub struct RunRecord {
    /// Scene as a [`container`](ancf_report::container).
    pub scene: Vec<u8>,
    /// All rows as comma-separated values.
    pub csv: String,
    /// Outcome in one sentence.
    pub sentence: String,
    /// True if the analysis was completed.
    pub is_finished: bool,
}

impl LiveRun<'_> {
    /// Runs the model. `send` receives the scene of the results so far, several times during the run.
    ///
    /// # Errors
    /// The errors of the model.
    pub fn run(&self, send: &mut dyn FnMut(&[u8])) -> Result<RunRecord, Error> {
        let clock = Instant::now();
        let model = ValidModel::parse(self.text)?;
        let simulation = Simulation::of_valid(&model)?;
        let (surfaces, notes) = BodySurfaces::of_run(&model, "".as_ref());
        let title = model.title.as_deref().unwrap_or(self.title);
        let view =
            View { text: self.text, title, model: &model, simulation: &simulation, surfaces: &surfaces };
        let limit = match model.analysis {
            Analysis::Dynamics(_) | Analysis::Statics(_) => 2 * model.output.states as usize,
            _ => SHAPES,
        };
        let mut recorder = Recorder {
            view,
            series: Series::new(),
            csv: Csv::new(Vec::new()),
            frames: Frames::new(limit),
            due: INTERVAL,
            clock,
            send,
        };
        let summary = simulation.run(&mut recorder)?;
        let Recorder { series, csv, frames, .. } = recorder;
        let ending = Ending::new(&summary.outcome, &model.analysis);
        let seconds = clock.elapsed().as_secs_f64();
        let sentence = match &ending {
            Ending::Failed(reason) => reason.clone(),
            _ => format!("{} steps in {seconds:.2} s", summary.steps),
        };
        let mut recording = view.recording(&series, &frames);
        recording.messages = notes.into_iter().chain(summary_warnings(&summary)).collect();
        recording.summary = summary_rows(&summary);
        recording.summary.insert(0, ("seconds".to_owned(), format!("{seconds:.3}")));
        recording.body_errors = summary.body_errors().to_vec();
        (recording.ending, recording.live) = (ending, false);
        let csv = String::from_utf8(csv.into_inner()?).map_err(io::Error::other)?;
        Ok(RunRecord {
            scene: scene(&recording, BUDGET),
            csv,
            sentence,
            is_finished: summary.outcome.is_finished(),
        })
    }
}

/// What the scenes of a run have in common.
#[derive(Clone, Copy)]
struct View<'a> {
    text: &'a str,
    title: &'a str,
    model: &'a Model,
    simulation: &'a Simulation,
    surfaces: &'a BodySurfaces,
}

impl<'a> View<'a> {
    /// Recording of the rows and states so far.
    fn recording(self, series: &'a Series, frames: &Frames) -> Recording<'a> {
        Recording {
            simulation: self.simulation,
            model: self.model,
            text: self.text,
            title: self.title,
            frames: frames.all(),
            series,
            summary: Vec::new(),
            surfaces: self.surfaces,
            body_errors: Vec::new(),
            ending: Ending::Running,
            messages: Vec::new(),
            live: true,
        }
    }
}

/// Receiver of rows and states, which sends scenes.
struct Recorder<'a> {
    view: View<'a>,
    series: Series,
    csv: Csv<Vec<u8>>,
    frames: Frames,
    clock: Instant,
    /// Time of the next scene since the start.
    due: Duration,
    send: &'a mut dyn FnMut(&[u8]),
}

impl Observer for Recorder<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.series, columns)?;
        Sink::begin(&mut self.csv, columns)
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        let _ = Sink::record(&mut self.series, row)?;
        let _ = Sink::record(&mut self.csv, row)?;
        self.frames.push(row.first().copied().unwrap_or_default(), state);
        let now = self.clock.elapsed();
        if now >= self.due {
            (self.send)(&scene(&self.view.recording(&self.series, &self.frames), BUDGET));
            let after = self.clock.elapsed();
            self.due = after + INTERVAL.max((after - now) * SHARE);
        }
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Sink::finish(&mut self.series)?;
        Sink::finish(&mut self.csv)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_those_of_the_library() {
        let text = include_str!("../../../models/cantilever.toml");
        let record = LiveRun { text, title: "a" }.run(&mut |_| ()).expect("a run");
        let mut csv = Csv::new(Vec::new());
        let model = Model::parse(text).expect("a model");
        let summary = ancf::simulate(&model, &mut csv).expect("a run");
        assert!(summary.outcome.is_finished());
        assert_eq!(record.csv.into_bytes(), csv.into_inner().expect("a text"));
        assert!(record.is_finished);
        let header = ancf_report::container::header(&record.scene).expect("a scene");
        assert_eq!(header["outcome"]["kind"], "finished");
        assert_eq!(header["live"], false);
    }

    #[test]
    fn failed_runs_have_a_scene_and_a_reason() {
        let text = include_str!("../../ancf-cli/templates/statics.toml");
        let wrong = text.replacen("kind = \"statics\"", "kind = \"statics\"\nmax_iterations = 1", 1);
        assert_ne!(text, wrong);
        let record = LiveRun { text: &wrong, title: "a" }.run(&mut |_| ()).expect("a run");
        assert!(!record.is_finished);
        assert!(!record.sentence.is_empty());
        assert!(ancf_report::container::header(&record.scene).is_some());
    }
}
