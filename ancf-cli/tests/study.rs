//! `ancf study` as its user meets it: cases, tables, restarts, messages, exit codes.
#![cfg(test)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread::sleep;
use std::time::Duration;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
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
    output = { every = 3 }
    analysis = { kind = "dynamics", duration = 0.05, step = 1e-3, start = "zero" }
"#;

/// One row of a table.
type Row = BTreeMap<String, Field>;

fn float(row: &Row, name: &str) -> f64 {
    match row[name] {
        Field::Double(x) => x,
        Field::Long(n) => n as f64,
        ref other => panic!("{name}: {other:?}"),
    }
}

fn text(row: &Row, name: &str) -> String {
    match &row[name] {
        Field::Str(text) => text.clone(),
        Field::Null => String::new(),
        other => panic!("{name}: {other:?}"),
    }
}

fn table(path: &Path) -> Vec<Row> {
    let reader = SerializedFileReader::new(fs::File::open(path).unwrap()).unwrap();
    reader.get_row_iter(None).unwrap().map(|row| row.unwrap().into_columns().into_iter().collect()).collect()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A folder with a model, a study of it and its results.
struct Bench(TempDir);

impl Bench {
    fn new(study: &str) -> Self {
        let bench = Self(TempDir::new().unwrap());
        fs::write(bench.file("model.toml"), MODEL).unwrap();
        bench.state(study);
        bench
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes the study of the model.
    fn state(&self, study: &str) {
        fs::write(self.file("study.toml"), format!("model = \"model.toml\"\n{study}")).unwrap();
    }

    fn command(&self, more: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
        command.arg("study").arg(self.file("study.toml")).arg("-o").arg(self.file("out")).args(more);
        command
    }

    /// Runs the study, which ends with this exit code; what it said.
    fn run(&self, more: &[&str], code: i32) -> String {
        let output = self.command(more).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{}", stderr(&output));
        stderr(&output)
    }

    fn cases(&self) -> Vec<Row> {
        table(&self.file("out/cases.parquet"))
    }

    fn column(&self, name: &str) -> Vec<f64> {
        self.cases().iter().map(|row| float(row, name)).collect()
    }
}

const TIP: &str = "\n[objectives]\ntip = { column = \"tip.y\" }\n";

/// Every objective of a case is the same as from the file that `ancf run` writes for the model with these values.
#[test]
fn a_case_is_what_a_run_is() {
    let bench = Bench::new(
        r#"
        parameters = { elements = [1, 2], "bodies.beam.material.young" = [193e9, 100e9] }
        objectives.first = { column = "tip.y", take = "first" }
        objectives.last = { column = "tip.y", take = "last" }
        objectives.mean = { column = "tip.y", take = "mean" }
        objectives.least = { column = "tip.y", take = "min" }
        objectives.most = { column = "tip.vy", take = "max" }
        objectives.seventh = { column = "tip.y", row = 6 }
        "#,
    );
    bench.run(&[], 0);
    let cases = bench.cases();
    let names = ["bodies.beam.material.young", "elements"];
    let values: Vec<_> = cases.iter().map(|row| names.map(|name| float(row, name))).collect();
    assert_eq!(values, [[193e9, 1.0], [193e9, 2.0], [100e9, 1.0], [100e9, 2.0]], "the last runs fastest");

    let other = MODEL.replace("193e9", "100e9").replace("elements = 2", "elements = 1");
    fs::write(bench.file("other.toml"), other).unwrap();
    let mut run = Command::new(env!("CARGO_BIN_EXE_ancf"));
    run.arg("run").arg(bench.file("other.toml")).arg("-o").arg(bench.file("run"));
    assert!(run.output().unwrap().status.success());
    let csv = fs::read_to_string(bench.file("run/probes.csv")).unwrap();
    let column = |name: &str| -> Vec<f64> {
        let at = csv.lines().next().unwrap().split(',').position(|column| column == name).unwrap();
        csv.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    };
    let (y, case) = (column("tip.y"), &cases[2]);
    assert_eq!(y.len(), 18, "every third of 51 instants, and the last");
    assert_eq!(float(case, "first"), y[0]);
    assert_eq!(float(case, "last"), y[17]);
    assert_eq!(float(case, "seventh"), y[6]);
    assert_eq!(float(case, "least"), y.iter().copied().fold(0.0, f64::min));
    assert_eq!(float(case, "most"), column("tip.vy").into_iter().fold(f64::MIN, f64::max));
    let mean = y.iter().sum::<f64>() / 18.0;
    assert!((float(case, "mean") / mean - 1.0).abs() < 1e-14);
    assert_eq!((text(case, "outcome"), text(case, "message")), ("finished".into(), String::new()));
    assert_eq!(float(case, "steps"), 50.0);
    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(bench.file("run/summary.json")).unwrap()).unwrap();
    assert_eq!(float(case, "iterations"), summary["iterations"].as_f64().unwrap());
}

/// A second run computes nothing, and writes the same; after values were added only the new ones are run.
#[test]
fn a_restart_runs_only_what_is_new() {
    let bench = Bench::new(&format!("parameters.elements = [1, 2, 3]{TIP}"));
    let said = bench.run(&[], 0);
    assert!(said.starts_with("done: 3 cases, "), "{said}");
    let first = bench.cases();
    let said = bench.run(&[], 0);
    assert!(said.starts_with("done: 3 cases (3 taken over), "), "{said}");
    assert_eq!(bench.cases(), first, "times too");

    bench.state(&format!("parameters.elements = [2, 4, 3, 1]{TIP}"));
    let said = bench.run(&[], 0);
    assert!(said.starts_with("done: 4 cases (3 taken over), "), "{said}");
    assert_eq!(bench.column("elements"), [2.0, 4.0, 3.0, 1.0]);
    assert_eq!(bench.cases()[3]["seconds"], first[0]["seconds"]);

    // A new parameter: its cases with the value that the model has anyway are those that were run.
    bench.state(&format!("parameters = {{ elements = [1, 2], \"gravity[1]\" = [-9.81, -1.62] }}{TIP}"));
    let said = bench.run(&[], 0);
    assert!(said.starts_with("done: 4 cases (2 taken over), "), "{said}");

    // The model or an objective changed: nothing is left of it.
    fs::write(bench.file("model.toml"), MODEL.replace("8030", "7850")).unwrap();
    assert!(bench.run(&[], 0).starts_with("done: 4 cases, "));
    bench.state("parameters.elements = [1]\n[objectives]\ntip = { column = \"tip.y\", take = \"min\" }\n");
    assert!(bench.run(&[], 0).starts_with("done: 1 case, "));
}

/// A case that cannot be solved and one that is no model are rows with messages; they are not run again unless asked.
#[test]
fn failures_are_rows() {
    let bench = Bench::new(&format!(
        "parameters.\"joints.root.kind\" = [\"clamp\", \"spherical\", \"revolute\"]{TIP}"
    ));
    let statics = MODEL
        .replace("kind = \"dynamics\", duration = 0.05, step = 1e-3, start = \"zero\"", "kind = \"statics\"");
    fs::write(bench.file("model.toml"), statics).unwrap();
    let said = bench.run(&[], 1);
    let cases = bench.cases();
    let outcomes: Vec<_> = cases.iter().map(|row| text(row, "outcome")).collect();
    assert_eq!(outcomes, ["finished", "failed", "invalid"]);
    assert_eq!(text(&cases[1], "joints.root.kind"), "spherical");
    assert!(float(&cases[0], "tip") < 0.0);
    assert_eq!([&cases[1]["tip"], &cases[2]["tip"], &cases[2]["steps"]], [&Field::Null; 3]);
    let message = text(&cases[1], "message");
    assert!(message.starts_with("failed at load factor 0: there is no equilibrium to find"), "{message}");
    assert!(message.contains("body `beam` can rotate"), "{message}");
    let message = text(&cases[2], "message");
    assert!(
        message.contains("joints[0].axis: found no key `axis`, wanted an array of 3 numbers"),
        "{message}"
    );
    assert!(
        said.contains("case 1: failed at load factor 0") && said.contains("case 2: invalid: joints[0]"),
        "{said}"
    );
    assert!(said.contains("done: 3 cases, 1 failed, 1 invalid, "), "{said}");

    let said = bench.run(&[], 1);
    assert!(said.contains("done: 3 cases (3 taken over), 1 failed, 1 invalid, "), "{said}");
    let said = bench.run(&["--retry"], 1);
    assert!(said.contains("done: 3 cases (1 taken over), 1 failed, 1 invalid, "), "{said}");
}

/// A column that a case has not, and a row that there is not, are told in the row.
#[test]
fn what_a_case_has_not_is_told() {
    let bench = Bench::new(&format!("parameters.probes = [[]]{TIP}"));
    bench.run(&[], 1);
    assert_eq!(text(&bench.cases()[0], "message"), "objectives.tip: there is no column \"tip.y\"");
    bench.state("parameters.elements = [1]\n[objectives]\ntip = { column = \"tip.y\", row = 18 }\n");
    bench.run(&[], 0);
    let case = &bench.cases()[0];
    assert_eq!(
        (text(case, "message"), &case["tip"]),
        ("objectives.tip: no row 18 among 18".into(), &Field::Null)
    );
}

/// A study of many cases that has written some of them.
#[cfg(unix)]
fn started(bench: &Bench) -> std::process::Child {
    let long = MODEL.replace("duration = 0.05", "duration = 2.0");
    fs::write(bench.file("model.toml"), long).unwrap();
    bench.state(&format!(
        "samples = 100\n[parameters]\n\"gravity[1]\" = {{ kind = \"uniform\", low = -10, high = -5 }}{TIP}"
    ));
    let mut study = bench.command(&["-j", "1"]).spawn().unwrap();
    while !bench.file("out/cases.parquet").exists() {
        assert!(study.try_wait().unwrap().is_none(), "it ended before it was interrupted");
        sleep(Duration::from_millis(20));
    }
    study
}

/// Ctrl-C: exit code 130, every case that had finished is there and is not run again.
#[cfg(unix)]
#[test]
fn an_interrupt_keeps_what_finished() {
    let bench = Bench::new("");
    let mut study = started(&bench);
    let before = bench.cases();
    Command::new("kill").args(["-INT", &study.id().to_string()]).status().unwrap();
    assert_eq!(study.wait().unwrap().code(), Some(130));
    let kept = bench.cases();
    let finished = kept.iter().filter(|row| text(row, "outcome") == "finished").count();
    assert!(before.iter().all(|row| kept.contains(row)) && !before.is_empty());
    assert!(kept.iter().all(|row| ["finished", "stopped"].contains(&&*text(row, "outcome"))));
    let said = bench.run(&[], 0);
    assert!(said.starts_with(&format!("done: 100 cases ({finished} taken over), ")), "{finished}: {said}");
    assert!(bench.cases().iter().all(|row| text(row, "outcome") == "finished"));
}

/// A kill that leaves no time for anything: the last table that was written is whole.
#[cfg(unix)]
#[test]
fn a_kill_keeps_what_was_written() {
    let bench = Bench::new("");
    let mut study = started(&bench);
    sleep(Duration::from_millis(300));
    study.kill().unwrap();
    study.wait().unwrap();
    let kept = bench.cases();
    assert!(!kept.is_empty() && kept.len() < 100, "{}", kept.len());
    let said = bench.run(&[], 0);
    assert!(said.starts_with(&format!("done: 100 cases ({} taken over), ", kept.len())), "{said}");
    assert!(kept.iter().all(|row| bench.cases().contains(row)));
}

/// Samples: the same for the same seed, one in each interval of a Latin hypercube, as many as asked with every combination.
#[test]
fn samples_fill_their_range() {
    let study = |seed: u32, sampling: &str| {
        format!(
            "samples = 20\nseed = {seed}\nsampling = \"{sampling}\"\n[parameters]\nelements = [1, 2]\n\
             \"gravity[1]\" = {{ kind = \"uniform\", low = -10, high = 0 }}{TIP}"
        )
    };
    let bench = Bench::new(&study(1, "latin_hypercube"));
    bench.run(&["-q", "-j", "1"], 0);
    let (elements, first) = (bench.column("elements"), bench.column("gravity[1]"));
    let tips = bench.column("tip");
    assert!(elements[..20].iter().all(|n| *n == 1.0) && elements[20..].iter().all(|n| *n == 2.0));
    assert_eq!(first[..20], first[20..], "the same samples with every combination");
    let mut intervals: Vec<_> = first[..20].iter().map(|x| ((x + 10.0) * 2.0) as usize).collect();
    intervals.sort_unstable();
    assert_eq!(intervals, (0..20).collect::<Vec<_>>());

    fs::remove_file(bench.file("out/cases.parquet")).unwrap();
    bench.run(&[], 0);
    assert_eq!(
        (bench.column("gravity[1]"), bench.column("tip")),
        (first, tips),
        "with any number of threads"
    );
    bench.state(&study(2, "latin_hypercube"));
    assert!(bench.run(&[], 0).starts_with("done: 40 cases, "));
    bench.state(&study(1, "random"));
    assert!(bench.run(&[], 0).starts_with("done: 40 cases, "));
    bench.state(&study(1, "random").replace("samples = 20", "samples = 30"));
    assert!(bench.run(&[], 0).starts_with("done: 60 cases (40 taken over), "));
}

/// Lists in step with each other; values of several types in columns that hold them.
#[test]
fn lists_may_go_in_step() {
    let bench = Bench::new(&format!(
        "combine = \"zip\"\n[parameters]\nelements = {{ kind = \"logarithmic\", from = 1, to = 4, count = 3 }}\n\
         gravity = [[0, -1, 0], [0, -2, 0], [0, -3, 0]]\n\"gravity[2]\" = [0, 0.5, 1]{TIP}"
    ));
    bench.run(&[], 0);
    let cases = bench.cases();
    assert_eq!(bench.column("elements"), [1.0, 2.0, 4.0]);
    assert_eq!(cases.iter().map(|row| text(row, "gravity")).collect::<Vec<_>>()[1], "[0, -2, 0]");
    assert_eq!(bench.column("gravity[2]"), [0.0, 0.5, 1.0]);
}

/// Parts of a study in files of their own, which a run of the whole takes over.
#[test]
fn parts_make_the_whole() {
    let bench = Bench::new(&format!("parameters.elements = [1, 2, 3, 4, 5]{TIP}"));
    assert!(bench.run(&["--index", "2/2"], 0).starts_with("done: 2 cases, "));
    let part = table(&bench.file("out/cases-2.parquet"));
    assert_eq!(part.iter().map(|row| float(row, "case")).collect::<Vec<_>>(), [1.0, 3.0]);
    bench.run(&["--index", "1/2"], 0);
    assert!(!bench.file("out/cases.parquet").exists());
    assert!(bench.run(&[], 0).starts_with("done: 5 cases (5 taken over), "));
    assert_eq!(bench.column("elements"), [1.0, 2.0, 3.0, 4.0, 5.0]);
    for wrong in ["0/2", "3/2", "2", "a/b"] {
        assert!(bench.run(&["--index", wrong], 2).contains("wanted K/N with K from 1 to N"));
    }
}

/// All that is wrong is said at once with its place; nothing is written.
#[test]
fn wrong_input_is_refused() {
    for (study, messages) in [
        (
            "sampels = 10\ncombine = \"grit\"\n[parameters]\nelements = []\nx = 5\ny = { kind = \"normal\", mean = 3 }\n\
             [objectives]\ntip = { column = \"tip.y\", take = \"men\" }",
            &[
                ":2:1: sampels: found unknown key `sampels`",
                ":3:11: combine: found \"grit\", wanted \"grid\" or \"zip\" (did you mean \"grid\"?)",
                ":5:12: parameters.elements: found an empty array, wanted an array of at least one value",
                ":6:5: parameters.x: found 5, wanted an array of at least one value or a table with `kind` = \"range\", ",
                ":7:5: parameters.y.deviation: found no key `deviation`, wanted a number > 0",
                ":9:34: objectives.tip.take: found \"men\", wanted \"first\", \"last\", \"mean\", \"min\", \"max\", \"amplitude\" or \
                 \"rms\" (did you mean \"mean\"?)",
            ][..],
        ),
        (
            "combine = \"zip\"\n[parameters]\nelements = [1, 2]\n\"bodies.beam.elements\" = [1, 2, 3]\n\"gravity[3]\" = [1, 2, 3]\n\
             \"bodies.beem.to\" = { kind = \"uniform\", low = 2, high = 1 }\n[objectives]\n\
             tip = { column = \"tip.yy\", take = \"mean\", row = 3 }\nseconds = { column = \"tip.x\" }",
            &[
                ":4:12: parameters.elements: found 2 values, wanted 3, as many as `bodies.beam.elements` has",
                ":4:12: parameters.elements: found `bodies[0].elements`, which `bodies.beam.elements` sets too",
                ":6:16: parameters.\"gravity[3]\": found place `[3]`, wanted a place from `[0]` to `[2]`",
                ":7:20: parameters.\"bodies.beem.to\": found no `beem`, wanted `beam` (did you mean `beam`?)",
                ":7:20: parameters.\"bodies.beem.to\": found a distribution without `samples`",
                ":7:56: parameters.\"bodies.beem.to\".high: found 1, wanted a number > 2, which is `low`",
                ":9:18: objectives.tip.column: found \"tip.yy\", which is no column of the results",
                "(did you mean \"tip.y\"?)",
                ":9:49: objectives.tip.row: found both `take` and `row`, wanted one of them",
                ":10:11: objectives.seconds: found `seconds`, which is another column of the results",
            ][..],
        ),
        ("parameters = {", &[":2:15: found unclosed inline table, wanted `}`"][..]),
    ] {
        let bench = Bench::new(study);
        let said = bench.run(&[], 2);
        for message in messages {
            assert!(said.contains(message), "{message}\nis not in\n{said}");
        }
        assert!(!bench.file("out").exists());
    }
}

/// What is wrong with the model is said of the model's file.
#[test]
fn a_wrong_model_is_refused() {
    let bench = Bench::new("parameters.elements = [1]");
    fs::write(bench.file("model.toml"), MODEL.replace("young", "yung")).unwrap();
    let said = bench.run(&[], 2);
    assert!(said.contains("model.toml:3:") && said.contains("did you mean `young`?"), "{said}");
    fs::remove_file(bench.file("model.toml")).unwrap();
    let said = bench.run(&[], 2);
    assert!(said.contains("study.toml:1:9: model: found \"model.toml\": no such file"), "{said}");
    fs::remove_file(bench.file("study.toml")).unwrap();
    assert!(bench.run(&[], 2).contains("study.toml: found no such file, wanted a study file"));
}

/// A file in the way that is no table is left alone.
#[test]
fn a_file_in_the_way_is_left_alone() {
    let bench = Bench::new("parameters.elements = [1]");
    fs::create_dir(bench.file("out")).unwrap();
    fs::write(bench.file("out/cases.parquet"), "precious").unwrap();
    let said = bench.run(&[], 1);
    assert!(said.contains("cases.parquet cannot be read; remove it or take another folder"), "{said}");
    assert_eq!(fs::read_to_string(bench.file("out/cases.parquet")).unwrap(), "precious");
}

/// The studies in `models/studies/` run; the cantilever converges as its comment says.
#[test]
fn the_examples_run() {
    let studies = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/studies");
    let bench = Bench::new("");
    for entry in fs::read_dir(studies).unwrap() {
        let path = entry.unwrap().path();
        let out = bench.file(path.file_stem().unwrap().to_str().unwrap());
        let mut study = Command::new(env!("CARGO_BIN_EXE_ancf"));
        let run = study.arg("study").arg(&path).arg("-o").arg(out).output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{}: {}", path.display(), stderr(&run));
    }
    for row in table(&bench.file("convergence/cases.parquet")) {
        let (n, tip) = (float(&row, "elements"), float(&row, "tip"));
        let missing = 1.0 + tip / 2.041e-3;
        assert!((missing * 3.0 * n * n - 1.0).abs() < 0.1 || missing < 5e-3, "{n} elements: {missing}");
    }
}
