//! `ancf study` as its user meets it: cases, tables, restarts, messages, exit codes.
#![cfg(test)]

mod bench;
mod cases;
mod refusals;

use std::fs;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

use parquet::record::Field;

use bench::{Bench, MODEL, TIP, float, text};

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
    let bench = Bench::new(&format!(
        "parameters.probes = [[{{ name = \"tip\", on = {{ body = \"beam\", at = \"end\" }} }}], []]{TIP}"
    ));
    bench.run(&[], 1);
    assert_eq!(text(&bench.cases()[1], "message"), "objectives.tip: there is no column \"tip.y\"");
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
