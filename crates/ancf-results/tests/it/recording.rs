//! The folder of a run contains the rows and states of the run, also after errors and interruptions.

use std::fs;
use std::io;
use std::ops::ControlFlow;
use std::path::Path;

use ancf::record::Series;
use ancf::solver::equations::State;
use ancf::{Field, Fields, Model, Observer, Simulation, simulate};
use ancf_results::{Folder, OpenError, Recorder, Results, RunStatus, StoredState};
use tempfile::TempDir;

/// Flexible pendulum without analysis and output.
const PENDULUM: &str = r#"
gravity = [0, -9.81, 0]
units = { length = "m", time = "s", force = "N" }
materials.rubber = { density = 1100, young = 1e7 }
sections.rod = { kind = "circle", diameter = 0.02 }
bodies = [{ kind = "cable", name = "rope", from = [0, 0, 0], to = [1, 0, 0], elements = 3, section = "rod", material = "rubber" }]
joints = [{ kind = "spherical", name = "hook", a = { body = "rope", at = "start" } }]
probes = [{ name = "tip", on = { body = "rope", at = "end" } }]
"#;

const MOTION: &str = "analysis = { kind = \"dynamics\", duration = 0.1, step = 1e-3 }\n";

fn model(rest: &str) -> (String, Model) {
    let text = format!("{PENDULUM}{rest}");
    let model = Model::parse(&text).unwrap_or_else(|errors| panic!("{errors}"));
    (text, model)
}

/// Runs a model into a folder.
fn run(folder: &Path, text: &str, model: &Model) -> Results {
    let simulation = Simulation::new(model).unwrap();
    let mut recorder = Recorder::new(Folder::new(folder), "pendulum.toml", text, model, &simulation);
    let summary = simulation.run(&mut recorder).unwrap();
    recorder.write_summary(&summary, 0.0).unwrap();
    Results::open(folder).unwrap()
}

fn frames(results: &Results) -> Vec<StoredState> {
    results.frames().map(Result::unwrap).collect()
}

#[test]
fn columns_read_back_to_the_last_bit() {
    let (text, model) = model(MOTION);
    let folder = TempDir::new().unwrap();
    let results = run(folder.path(), &text, &model);
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished());
    assert_eq!(results.columns().unwrap(), series);
    assert_eq!(results.status(), RunStatus::Ended);
    assert!(results.summary_file().unwrap().unwrap().summary.outcome.is_finished());
    let mut csv = fs::read_to_string(Folder::new(folder.path()).csv()).unwrap();
    csv.truncate(csv.trim_end().len());
    let last = csv.lines().last().unwrap().split(',').nth(2).unwrap().parse::<f64>().unwrap();
    assert_eq!(Some(&last), series.column("tip.y").unwrap().last());
}

/// A table with thousands of columns has several parts, and its text contains the same numbers.
#[test]
fn wide_tables_and_texts_contain_the_numbers_of_the_run() {
    let one = r#"probes = [{ name = "tip", on = { body = "rope", at = "end" } }]"#;
    let many = (1..300).map(|k| {
        let s = f64::from(k) / 300.0;
        format!(r#"{{ name = "p{k}", on = {{ body = "rope", at = {s:?} }} }}"#)
    });
    let many = format!("probes = [{}]", many.collect::<Vec<_>>().join(", "));
    let text = format!("{PENDULUM}{}", MOTION.replace("1e-3", "1.5e-4")).replace(one, &many);
    let model = Model::parse(&text).unwrap_or_else(|errors| panic!("{errors}"));
    let folder = TempDir::new().unwrap();
    let results = run(folder.path(), &text, &model);
    let mut series = Series::new();
    assert!(simulate(&model, &mut series).unwrap().outcome.is_finished());
    assert!(series.names().count() > 2000);
    assert_eq!(results.columns().unwrap(), series);
    let csv = fs::read_to_string(Folder::new(folder.path()).csv()).unwrap();
    let columns: Vec<&[f64]> = series.columns().map(|(_, values)| values).collect();
    for (row, line) in csv.lines().skip(1).enumerate() {
        let numbers = line.split(',').map(|number| number.parse::<f64>().unwrap());
        assert!(numbers.eq(columns.iter().map(|column| column[row])), "row {row}");
    }
    assert_eq!(csv.lines().count(), columns[0].len() + 1);
}

#[test]
fn a_file_says_where_it_comes_from_and_in_what_units() {
    let (text, model) = model(MOTION);
    let folder = TempDir::new().unwrap();
    let results = run(folder.path(), &text, &model);
    assert_eq!(results.metadata("model").unwrap().as_deref(), Some(text.as_str()));
    assert!(results.metadata("program").unwrap().unwrap().starts_with("ancf "));
    let units: serde_json::Value =
        serde_json::from_str(&results.metadata("units").unwrap().unwrap()).unwrap();
    for (column, unit) in [("t", "s"), ("tip.ax", "m/s²"), ("hook.mz", "N m"), ("kinetic", "J")] {
        assert_eq!(units[column], unit, "{column}");
    }
    assert!(units.get("iterations").is_none(), "a column without a unit has no entry");
    assert_eq!(results.metadata("sha256").unwrap().unwrap().len(), 64);
}

#[test]
fn kept_states_are_those_of_the_run() {
    let (text, model) = model(&format!("{MOTION}output = {{ states = 11 }}\n"));
    let folder = TempDir::new().unwrap();
    let results = run(folder.path(), &text, &model);
    let (frames, columns) = (frames(&results), results.columns().unwrap());
    assert_eq!(
        frames.iter().map(|frame| frame.row).collect::<Vec<_>>(),
        (0..=10).map(|k| 10 * k).collect::<Vec<_>>()
    );
    let simulation = results.simulation();
    let fields = Fields::new(simulation.assembly(), simulation.scales(), 1);
    for StoredState { row, value, state, .. } in &frames {
        let row = usize::try_from(*row).unwrap();
        assert_eq!(columns.column("t").unwrap()[row], *value);
        let mut positions = Vec::new();
        fields.fill(Field::Position, state, &mut positions);
        let tip = ["tip.x", "tip.y", "tip.z"].map(|name| columns.column(name).unwrap()[row]);
        assert_eq!(positions[positions.len() - 3..], tip, "the field at the end is equal to the probe");
    }
}

#[test]
fn the_last_row_and_the_last_state_are_there_whether_due_or_not() {
    let (text, model) = model(&format!("{MOTION}output = {{ every = 7, states = 4 }}\n"));
    let folder = TempDir::new().unwrap();
    let results = run(folder.path(), &text, &model);
    let columns = results.columns().unwrap();
    let times = columns.column("t").unwrap();
    assert_eq!(times.len(), 16);
    assert!((times[14] - 0.098).abs() < 1e-12 && (times[15] - 0.1).abs() < 1e-12, "{times:?}");
    let frames = frames(&results);
    assert_eq!(frames.last().unwrap().row, 100);
    assert_eq!(frames.len(), 4);
}

/// Inspects the folder after every 40 rows.
struct Peek<'a> {
    recorder: Recorder,
    row: u32,
    look: &'a mut dyn FnMut(u32),
}

impl Observer for Peek<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.recorder.begin(columns)
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        let flow = self.recorder.record(row, state)?;
        if self.row.is_multiple_of(40) {
            // Rows are flushed about once a second.
            std::thread::sleep(std::time::Duration::from_millis(1010));
            (self.look)(self.row);
        }
        self.row += 1;
        Ok(flow)
    }

    fn finish(&mut self) -> io::Result<()> {
        self.recorder.finish()
    }
}

#[test]
fn a_run_that_goes_on_can_be_read_and_keeps_others_out() {
    let (text, model) = model(MOTION);
    let folder = TempDir::new().unwrap();
    let simulation = Simulation::new(&model).unwrap();
    let recorder = Recorder::new(Folder::new(folder.path()), "pendulum.toml", &text, &model, &simulation);
    let mut seen = Vec::new();
    let mut look = |row: u32| {
        let results = Results::open(folder.path()).unwrap();
        assert_eq!(results.status(), RunStatus::Running);
        let columns = results.columns().unwrap();
        seen.push((row, columns.column("t").unwrap().len(), frames(&results).len()));
        let mut other =
            Recorder::new(Folder::new(folder.path()), "pendulum.toml", &text, &model, &simulation);
        let refused = other.begin(&[]).unwrap_err().to_string();
        assert!(refused.contains("another run writes into this folder"), "{refused}");
    };
    let mut peek = Peek { recorder, row: 0, look: &mut look };
    let summary = simulation.run(&mut peek).unwrap();
    drop(peek);
    assert!(summary.outcome.is_finished());
    // Each inspection reads the rows of the last flush, which took place at the row after the previous inspection.
    assert_eq!(seen.iter().map(|(row, ..)| *row).collect::<Vec<_>>(), [0, 40, 80]);
    assert!(seen[1].1 >= 2 && seen[2].1 >= 42, "{seen:?}");
    assert!(seen[2].2 >= 42, "states too: {seen:?}");
    // The run has no summary.
    let results = Results::open(folder.path()).unwrap();
    assert_eq!(results.status(), RunStatus::Broken);
    assert_eq!(results.columns().unwrap().column("t").unwrap().len(), 101);
}

#[test]
fn what_an_earlier_run_left_goes_and_what_is_not_ours_stays() {
    let folder = TempDir::new().unwrap();
    let (text, first) = model(MOTION);
    run(folder.path(), &text, &first);
    fs::write(folder.path().join("notes.txt"), "mine").unwrap();
    let (text, second) = model(
        "analysis = { kind = \"modes\", about = \"reference\", count = 3 }\noutput = { csv = false }\n",
    );
    let results = run(folder.path(), &text, &second);
    assert!(!results.folder().csv().exists());
    assert_eq!(results.columns().unwrap().column("mode").unwrap(), [1.0, 2.0, 3.0]);
    assert_eq!(frames(&results).len(), 3, "every shape");
    assert_eq!(fs::read_to_string(folder.path().join("notes.txt")).unwrap(), "mine");
}

#[test]
fn what_is_no_run_or_damaged_is_told() {
    let folder = TempDir::new().unwrap();
    assert!(matches!(Results::open(folder.path()), Err(OpenError::NoRun(_))));
    let (text, model) = model(MOTION);
    run(folder.path(), &text, &model);
    let path = Folder::new(folder.path()).results();
    let bytes = fs::read(&path).unwrap();
    for length in [0, 3, bytes.len() / 2, bytes.len() - 1] {
        fs::write(&path, &bytes[..length]).unwrap();
        let error = Results::open(folder.path()).unwrap().columns().unwrap_err();
        assert!(error.to_string().contains("results.parquet"), "{error}");
    }
    let other = text.replace("elements = 3", "elements = 4");
    fs::write(&path, &bytes).unwrap();
    fs::write(Folder::new(folder.path()).model(), other).unwrap();
    let error = Results::open(folder.path()).unwrap_err().to_string();
    assert!(error.contains("model.toml") && error.contains("not the model of this run"), "{error}");
    // Without the checksums of the run.
    fs::write(folder.path().join(".lock"), "").unwrap();
    fs::remove_file(&path).unwrap();
    let states = Folder::new(folder.path()).states();
    let mut bytes = fs::read(&states).unwrap();
    let key = bytes.windows(9).rposition(|bytes| bytes == b"checksums").unwrap();
    let sha = bytes.windows(6).rposition(|bytes| bytes == b"sha256").unwrap();
    (bytes[key], bytes[sha]) = (b'C', b'S');
    fs::write(&states, bytes).unwrap();
    let results = Results::open(folder.path()).unwrap();
    assert!(!results.has_checksums().unwrap());
    assert!(results.frames().any(|frame| frame.is_err()), "states of another model");
}

#[test]
fn a_model_of_the_user_is_not_taken_for_that_of_a_run() {
    let folder = TempDir::new().unwrap();
    let (text, model) = model(MOTION);
    let own = Folder::new(folder.path()).model();
    fs::write(&own, "# another one\n").unwrap();
    let simulation = Simulation::new(&model).unwrap();
    let mut recorder = Recorder::new(Folder::new(folder.path()), "pendulum.toml", &text, &model, &simulation);
    let refused = simulation.run(&mut recorder).unwrap_err().to_string();
    assert!(refused.contains("would be lost"), "{refused}");
    assert_eq!(fs::read_to_string(&own).unwrap(), "# another one\n");
    // Other files of the user with names of files of a run are not overwritten either.
    for name in ["checkpoint", "report.html"] {
        let other = TempDir::new().unwrap();
        fs::write(other.path().join(name), "mine").unwrap();
        let mut recorder =
            Recorder::new(Folder::new(other.path()), "pendulum.toml", &text, &model, &simulation);
        assert!(simulation.run(&mut recorder).unwrap_err().to_string().contains("would be lost"));
        assert_eq!(fs::read_to_string(other.path().join(name)).unwrap(), "mine");
    }
    // The model of this run and models of earlier runs are replaced.
    fs::write(&own, &text).unwrap();
    run(folder.path(), &text, &model);
    run(folder.path(), &text.replace("0.02", "0.03"), &model);
    // A model that was changed after the run is not replaced.
    fs::write(&own, "# changed\n").unwrap();
    let mut recorder = Recorder::new(Folder::new(folder.path()), "pendulum.toml", &text, &model, &simulation);
    assert!(simulation.run(&mut recorder).unwrap_err().to_string().contains("would be lost"));
}
