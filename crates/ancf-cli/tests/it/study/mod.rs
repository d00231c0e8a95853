//! `ancf study`: cases, tables, restarts, messages, exit codes.

mod cases;
mod folder;
mod rejections;
mod results;

use std::fs;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

use parquet::record::Field;

use folder::{MODEL, StudyFolder, TIP, float, text};

/// The objectives of a case agree with the results of `ancf run` for the same values.
#[test]
fn a_case_equals_a_run() {
    let folder = StudyFolder::new(
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
    folder.run(&[], 0);
    let cases = folder.cases();
    let names = ["bodies.beam.material.young", "elements"];
    let values: Vec<_> = cases.iter().map(|row| names.map(|name| float(row, name))).collect();
    assert_eq!(values, [[193e9, 1.0], [193e9, 2.0], [100e9, 1.0], [100e9, 2.0]], "the last runs fastest");

    let other = MODEL.replace("193e9", "100e9").replace("elements = 2", "elements = 1");
    fs::write(folder.file("other.toml"), other).unwrap();
    let mut run = Command::new(env!("CARGO_BIN_EXE_ancf"));
    run.arg("run").arg(folder.file("other.toml")).arg("-o").arg(folder.file("run"));
    assert!(run.output().unwrap().status.success());
    let csv = fs::read_to_string(folder.file("run/probes.csv")).unwrap();
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
        serde_json::from_slice(&fs::read(folder.file("run/summary.json")).unwrap()).unwrap();
    assert_eq!(float(case, "iterations"), summary["iterations"].as_f64().unwrap());
}

/// A second run computes nothing and writes the same table. Additional values run only new cases.
#[test]
fn a_restart_runs_only_what_is_new() {
    let folder = StudyFolder::new(&format!("parameters.elements = [1, 2, 3]{TIP}"));
    let messages = folder.run(&[], 0);
    assert!(messages.starts_with("done: 3 cases, "), "{messages}");
    let first = folder.cases();
    let messages = folder.run(&[], 0);
    assert!(messages.starts_with("done: 3 cases (3 taken over), "), "{messages}");
    assert_eq!(folder.cases(), first, "including times");

    folder.state(&format!("parameters.elements = [2, 4, 3, 1]{TIP}"));
    let messages = folder.run(&[], 0);
    assert!(messages.starts_with("done: 4 cases (3 taken over), "), "{messages}");
    assert_eq!(folder.column("elements"), [2.0, 4.0, 3.0, 1.0]);
    assert_eq!(folder.cases()[3]["seconds"], first[0]["seconds"]);

    // A new parameter: cases with the value of the model are not run again.
    folder.state(&format!("parameters = {{ elements = [1, 2], \"gravity[1]\" = [-9.81, -1.62] }}{TIP}"));
    let messages = folder.run(&[], 0);
    assert!(messages.starts_with("done: 4 cases (2 taken over), "), "{messages}");

    // After a change of the model or an objective all cases are run.
    fs::write(folder.file("model.toml"), MODEL.replace("8030", "7850")).unwrap();
    assert!(folder.run(&[], 0).starts_with("done: 4 cases, "));
    folder.state("parameters.elements = [1]\n[objectives]\ntip = { column = \"tip.y\", take = \"min\" }\n");
    assert!(folder.run(&[], 0).starts_with("done: 1 case, "));
}

/// Failed and invalid cases are rows with messages. They are run again only with `--retry`.
#[test]
fn failures_are_rows() {
    let folder = StudyFolder::new(&format!(
        "parameters.\"joints.root.kind\" = [\"clamp\", \"spherical\", \"revolute\"]{TIP}"
    ));
    let statics = MODEL
        .replace("kind = \"dynamics\", duration = 0.05, step = 1e-3, start = \"zero\"", "kind = \"statics\"");
    fs::write(folder.file("model.toml"), statics).unwrap();
    let messages = folder.run(&[], 1);
    let cases = folder.cases();
    let outcomes: Vec<_> = cases.iter().map(|row| text(row, "outcome")).collect();
    assert_eq!(outcomes, ["finished", "failed", "invalid"]);
    assert_eq!(text(&cases[1], "joints.root.kind"), "spherical");
    assert!(float(&cases[0], "tip") < 0.0);
    assert_eq!([&cases[1]["tip"], &cases[2]["tip"], &cases[2]["steps"]], [&Field::Null; 3]);
    let message = text(&cases[1], "message");
    assert!(message.starts_with("failed at load factor 0: the model has no equilibrium"), "{message}");
    assert!(message.contains("body `beam` can rotate"), "{message}");
    let message = text(&cases[2], "message");
    assert!(
        message.contains("joints[0].axis: found no key `axis`, expected an array of 3 numbers"),
        "{message}"
    );
    assert!(
        messages.contains("case 1: failed at load factor 0")
            && messages.contains("case 2: invalid: joints[0]"),
        "{messages}"
    );
    assert!(messages.contains("done: 3 cases, 1 failed, 1 invalid, "), "{messages}");

    let messages = folder.run(&[], 1);
    assert!(messages.contains("done: 3 cases (3 taken over), 1 failed, 1 invalid, "), "{messages}");
    let messages = folder.run(&["--retry"], 1);
    assert!(messages.contains("done: 3 cases (1 taken over), 1 failed, 1 invalid, "), "{messages}");
}

/// A missing column or row is a message in the row of the case.
#[test]
fn missing_columns_and_rows_are_reported() {
    let folder = StudyFolder::new(&format!(
        "parameters.probes = [[{{ name = \"tip\", on = {{ body = \"beam\", at = \"end\" }} }}], []]{TIP}"
    ));
    folder.run(&[], 1);
    assert_eq!(text(&folder.cases()[1], "message"), "objectives.tip: there is no column \"tip.y\"");
    folder.state("parameters.elements = [1]\n[objectives]\ntip = { column = \"tip.y\", row = 18 }\n");
    folder.run(&[], 0);
    let case = &folder.cases()[0];
    assert_eq!(
        (text(case, "message"), &case["tip"]),
        ("objectives.tip: no row 18 among 18".into(), &Field::Null)
    );
}

/// A column above its critical load, 63.6 N: the warnings of a finished case are in its row, on the terminal and in the report, and an
/// objective of a column with rows without a number has a message.
#[test]
fn warnings_of_cases_are_reported() {
    let folder = StudyFolder::new(
        "parameters.\"loads[0].force[2]\" = [-10, -100]\n[objectives]\ntip = { column = \"tip.z\" }\n\
         directions = { column = \"unstable\", take = \"max\" }\n",
    );
    let model = r#"
        materials.steel = { density = 7850, young = 2.1e11 }
        sections.round = { kind = "circle", diameter = 0.01 }
        bodies = [{ kind = "beam", name = "arm", from = [0, 0, 0], to = [0, 0, 2], elements = 4, section = "round", material = "steel" }]
        joints = [{ kind = "clamp", name = "root", a = { body = "arm", at = "start" } }]
        loads = [{ kind = "force", on = { body = "arm", at = "end" }, force = [0, 0, -100] }]
        probes = [{ name = "tip", on = { body = "arm", at = "end" } }]
        analysis = { kind = "statics" }
    "#;
    fs::write(folder.file("model.toml"), model).unwrap();
    let messages = folder.run(&[], 0);
    assert!(messages.contains("case 1: ") && messages.contains("lost its stability"), "{messages}");
    assert!(messages.contains("done: 2 cases, 2 with warnings, "), "{messages}");
    let cases = folder.cases();
    for case in &cases {
        assert_eq!(text(case, "outcome"), "finished");
        assert!(!matches!(&case["directions"], Field::Double(directions) if directions.is_finite()));
        assert!(text(case, "message").contains("a row of \"unstable\" has no finite number"));
    }
    assert!(!text(&cases[0], "message").contains("warning: "));
    assert!(text(&cases[1], "message").contains("warning: the equilibrium lost its stability"));
}

/// Starts a study of many cases and waits for its first table.
#[cfg(unix)]
fn started(folder: &StudyFolder) -> std::process::Child {
    let long = MODEL.replace("duration = 0.05", "duration = 2.0");
    fs::write(folder.file("model.toml"), long).unwrap();
    folder.state(&format!(
        "samples = 100\n[parameters]\n\"gravity[1]\" = {{ kind = \"uniform\", low = -10, high = -5 }}{TIP}"
    ));
    let mut study = folder.command(&["-j", "1"]).spawn().unwrap();
    while !folder.file("out/cases.parquet").exists() {
        assert!(study.try_wait().unwrap().is_none(), "the study ended before the interrupt");
        sleep(Duration::from_millis(20));
    }
    study
}

/// Ctrl-C: exit code 130; finished cases are preserved and not run again.
#[cfg(unix)]
#[test]
fn an_interrupt_preserves_finished_cases() {
    let folder = StudyFolder::new("");
    let mut study = started(&folder);
    let before = folder.cases();
    Command::new("kill").args(["-INT", &study.id().to_string()]).status().unwrap();
    assert_eq!(study.wait().unwrap().code(), Some(130));
    let kept = folder.cases();
    let finished = kept.iter().filter(|row| text(row, "outcome") == "finished").count();
    assert!(before.iter().all(|row| kept.contains(row)) && !before.is_empty());
    assert!(kept.iter().all(|row| ["finished", "stopped"].contains(&&*text(row, "outcome"))));
    let messages = folder.run(&[], 0);
    assert!(
        messages.starts_with(&format!("done: 100 cases ({finished} taken over), ")),
        "{finished}: {messages}"
    );
    assert!(folder.cases().iter().all(|row| text(row, "outcome") == "finished"));
}

/// After a kill the last table is complete.
#[cfg(unix)]
#[test]
fn a_kill_preserves_the_last_table() {
    let folder = StudyFolder::new("");
    let mut study = started(&folder);
    sleep(Duration::from_millis(300));
    study.kill().unwrap();
    study.wait().unwrap();
    let kept = folder.cases();
    assert!(!kept.is_empty() && kept.len() < 100, "{}", kept.len());
    let messages = folder.run(&[], 0);
    assert!(messages.starts_with(&format!("done: 100 cases ({} taken over), ", kept.len())), "{messages}");
    assert!(kept.iter().all(|row| folder.cases().contains(row)));
}
