//! Execution of studies by the library: observer, reproducible samples, restart, errors.

use std::fs;
use std::path::Path;

use ancf::solver::newton::Interrupt;
use ancf_study::{
    CaseOutcome, ObjectiveRange, StudyError, StudyOutcome, StudyRun, StudySettings, StudySource,
};
use tempfile::TempDir;

const MODEL: &str = r#"
    gravity = [0, -9.81, 0]
    materials.steel = { density = 8030, young = 193e9 }
    sections.rod = { kind = "circle", diameter = 0.02 }
    bodies = [
        { kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = "rod", material = "steel" },
    ]
    joints = [{ kind = "clamp", name = "root", a = { body = "beam", at = "start" } }]
    probes = [{ name = "tip", on = { body = "beam", at = "end" } }]
    analysis = { kind = "statics" }
"#;

const STUDY: &str = r#"
    model = "model.toml"
    samples = 6
    seed = 3
    objectives.tip = { column = "tip.y" }
    [parameters]
    "gravity[1]" = { kind = "uniform", low = -10, high = -5 }
"#;

/// Writes a study and reads it.
fn source(folder: &Path, study: &str) -> StudySource {
    fs::write(folder.join("model.toml"), MODEL).unwrap();
    fs::write(folder.join("study.toml"), study).unwrap();
    StudySource::read(&folder.join("study.toml")).unwrap()
}

fn settings(folder: &Path) -> StudySettings {
    StudySettings { folder: folder.join("out"), part: None, retry: false }
}

/// Returns the tip of every case.
fn tips(run: &StudyRun) -> Vec<f64> {
    run.results().rows().map(|(_, row)| row.objectives[0].unwrap()).collect()
}

fn never() -> Interrupt {
    Interrupt::new(|| false)
}

#[test]
fn the_observer_is_called_after_each_case() {
    let folder = TempDir::new().unwrap();
    let mut run = StudyRun::prepare(source(folder.path(), STUDY), &settings(folder.path())).unwrap();
    let mut seen = Vec::new();
    run.execute(2, &never(), |results| seen.push((results.done(), results.requested()))).unwrap();
    assert_eq!(seen, (1..=6).map(|done| (done, 6)).collect::<Vec<_>>());
    let results = run.results();
    assert_eq!((results.outcome(), results.count(CaseOutcome::Finished)), (StudyOutcome::Finished, 6));
    assert!(results.path().is_file());
    let ObjectiveRange { least, mean, largest, .. } = results.range(0);
    assert!(least < mean && mean < largest && largest < Some(0.0));
}

/// The deflection is proportional to gravity. Samples are the same in any folder and with any number of threads.
#[test]
fn samples_depend_on_the_seed_only() {
    let [one, two, other] =
        [(STUDY.to_owned(), 1), (STUDY.to_owned(), 3), (STUDY.replace("seed = 3", "seed = 4"), 1)].map(
            |(study, jobs)| {
                let folder = TempDir::new().unwrap();
                let mut run =
                    StudyRun::prepare(source(folder.path(), &study), &settings(folder.path())).unwrap();
                run.execute(jobs, &never(), |_| {}).unwrap();
                let gravity = |case| run.results().design().axes()[0].value(case).as_float().unwrap();
                let tips = tips(&run);
                let compliance = tips[0] / gravity(0);
                let errors =
                    tips.iter().enumerate().map(|(case, tip)| (tip / gravity(case) / compliance - 1.0).abs());
                assert!(errors.fold(0.0, f64::max) < 1e-3, "{tips:?}");
                tips
            },
        );
    assert_eq!(one, two);
    assert_ne!(one, other);
}

/// A second run takes over all rows and does not call the observer.
#[test]
fn finished_cases_are_taken_over() {
    let folder = TempDir::new().unwrap();
    let mut first = StudyRun::prepare(source(folder.path(), STUDY), &settings(folder.path())).unwrap();
    first.execute(1, &never(), |_| {}).unwrap();
    let mut second = StudyRun::prepare(source(folder.path(), STUDY), &settings(folder.path())).unwrap();
    assert_eq!((second.results().taken_over(), second.results().missing()), (6, Vec::new()));
    second.execute(1, &never(), |_| panic!("a case was run")).unwrap();
    assert_eq!(tips(&first), tips(&second));
}

#[test]
fn an_interrupt_stops_the_study() {
    let folder = TempDir::new().unwrap();
    let mut run = StudyRun::prepare(source(folder.path(), STUDY), &settings(folder.path())).unwrap();
    run.execute(1, &Interrupt::new(|| true), |_| {}).unwrap();
    assert_eq!((run.results().outcome(), run.results().done()), (StudyOutcome::Stopped, 0));
}

#[test]
fn errors_name_their_file() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("study.toml");
    let error = StudySource::read(&file).unwrap_err();
    let StudyError::Invalid { path, errors } = error else { panic!("{error}") };
    assert_eq!((path, errors.len()), (file.clone(), 1));
    fs::write(folder.path().join("model.toml"), MODEL.replace("young", "yung")).unwrap();
    fs::write(&file, STUDY).unwrap();
    let error = StudySource::read(&file).unwrap_err();
    let StudyError::Invalid { path, errors } = error else { panic!("{error}") };
    assert_eq!(path, folder.path().join("model.toml"));
    assert!(errors.to_string().contains("did you mean `young`?"), "{errors}");
    let settings = StudySettings { folder: file, part: None, retry: false };
    let error = StudyRun::prepare(source(folder.path(), STUDY), &settings).unwrap_err();
    assert!(error.to_string().starts_with("cannot create "), "{error}");
}
