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

const MESH: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 2 \"root\"\n1 4 \"tip\"\n$EndPhysicalNames\n\
    $Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n\
    $Elements\n4\n2 1 2 2 1 1 4\n3 1 2 4 1 3 6\n4 3 2 0 1 1 2 5 4\n5 3 2 0 1 2 3 6 5\n$EndElements\n";

const PLATE: &str = r#"
    gravity = [0, -9.81, 0]
    materials.m = { density = 1000, young = 1e7, poisson = 0.3 }
    bodies = [{ kind = "shear_shell", name = "s", thickness = 0.1, material = "m", mesh = { file = "strip.msh" } }]
    joints = [{ kind = "support", name = "root", a = { body = "s", at = { edge = "root" } }, condition = "clamped" }]
    probes = [{ name = "tip", on = { body = "s", at = { node = 2 } } }]
    analysis = { kind = "statics" }
"#;

/// The mesh file of a model is read relative to the model. Cases with another content of the file are other cases.
#[test]
fn mesh_files_are_parts_of_cases() {
    let folder = TempDir::new().unwrap();
    let inner = folder.path().join("models");
    fs::create_dir(&inner).unwrap();
    fs::write(inner.join("plate.toml"), PLATE).unwrap();
    let study = STUDY.replace("model.toml", "models/plate.toml").replace("samples = 6", "samples = 2");
    fs::write(folder.path().join("study.toml"), study).unwrap();
    let run_with = |mesh: &str| {
        fs::write(inner.join("strip.msh"), mesh).unwrap();
        let source = StudySource::read(&folder.path().join("study.toml")).unwrap();
        let mut run = StudyRun::prepare(source, &settings(folder.path())).unwrap();
        let taken_over = run.results().taken_over();
        run.execute(1, &never(), |_| {}).unwrap();
        (taken_over, tips(&run))
    };
    let (none, wide) = run_with(MESH);
    let (all, again) = run_with(MESH);
    let (other, long) = run_with(&MESH.replace("2 0 0\n4", "2.5 0 0\n4").replace("6 2 1 0", "6 2.5 1 0"));
    assert_eq!((none, all, other), (0, 2, 0));
    assert_eq!(wide, again);
    assert!(long.iter().zip(&wide).all(|(long, wide)| long.abs() > 1.2 * wide.abs()), "{long:?} {wide:?}");
}

/// A model that starts from results has a part outside of its file that a case does not contain.
#[test]
fn models_that_start_from_results_are_rejected() {
    let folder = TempDir::new().unwrap();
    let started = MODEL.replace("    analysis = ", "    initial.from = \"before\"\n    analysis = ");
    fs::write(folder.path().join("model.toml"), started).unwrap();
    fs::write(folder.path().join("study.toml"), STUDY).unwrap();
    let error = StudySource::read(&folder.path().join("study.toml")).unwrap_err();
    let StudyError::Invalid { path, errors } = error else { panic!("{error}") };
    assert_eq!(path, folder.path().join("model.toml"));
    assert!(errors.to_string().contains("initial.from"), "{errors}");
}
