//! Bad numerics as the user of the program meets them: exit code, message, results so far.
#![cfg(test)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// A run of one of the library's models of bad numerics.
struct Ran {
    code: Option<i32>,
    said: String,
    folder: TempDir,
}

fn run(model: &str) -> Ran {
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../ancf/tests/models/numerics/{model}.toml"));
    let folder = TempDir::new().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let output = command
        .arg("run")
        .arg(file)
        .arg("--quiet")
        .arg("-o")
        .arg(folder.path().join("out"))
        .output()
        .unwrap();
    Ran { code: output.status.code(), said: String::from_utf8_lossy(&output.stderr).into_owned(), folder }
}

impl Ran {
    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    /// The first column of what was recorded.
    fn times(&self) -> Vec<f64> {
        let text = fs::read_to_string(self.out().join("probes.csv")).unwrap();
        text.lines().skip(1).map(|line| line.split(',').next().unwrap().parse().unwrap()).collect()
    }
}

/// When, why, where and what to try; exit code 1; rows until then.
#[test]
fn failures_are_told_and_leave_what_was_computed() {
    let cases = [
        (
            "divergence",
            ["failed at t = 0.05", "halved 2 times", "body `strip`, node ", "a shorter `analysis.step`"],
            0.05,
        ),
        ("dead_point", ["failed at t = 0.998", "the iteration", "at: ", "dead point"], 0.99),
        (
            "step_below_minimum",
            ["failed at t = 0.5", "below the smallest permitted", "body `ball`", "`step.tolerance`"],
            0.5,
        ),
        (
            "not_a_number",
            [
                "failed at t = 1",
                "the value of `loads[0].time` became -inf",
                "at: `loads[0].time`",
                "a number at all times",
            ],
            0.99,
        ),
        (
            "contradiction",
            [
                "failed at t = ",
                "joints contradict each other",
                "at: joint `motor`: drive",
                "leave one of them out",
            ],
            0.0,
        ),
    ];
    for (model, words, last) in cases {
        let ran = run(model);
        assert_eq!(ran.code, Some(1), "{model}: {}", ran.said);
        for word in words {
            assert!(ran.said.contains(word), "{model}: no `{word}` in\n{}", ran.said);
        }
        assert!(
            ran.said.contains("; try: ") && ran.said.contains("results so far in "),
            "{model}: {}",
            ran.said
        );
        let times = ran.times();
        assert!(times[0] == 0.0 && (times.last().unwrap() - last).abs() < 1e-6, "{model}: {times:?}");
        let summary: serde_json::Value =
            serde_json::from_slice(&fs::read(ran.out().join("summary.json")).unwrap()).unwrap();
        assert_eq!(summary["outcome"]["kind"], "failed");
        assert!(summary["outcome"]["advice"].is_string());
    }
}

/// There is nothing to record of an equilibrium that cannot be.
#[test]
fn mechanisms_have_no_equilibrium() {
    let ran = run("singular");
    assert_eq!(ran.code, Some(1), "{}", ran.said);
    assert!(ran.said.contains("held by nothing; at: body `arm` can rotate about the axis"), "{}", ran.said);
}

/// What is not wrong goes on, with a warning.
#[test]
fn warnings_of_runs_that_go_on() {
    let ran = run("redundant");
    assert_eq!(ran.code, Some(0), "{}", ran.said);
    assert!(
        ran.said.contains("warning: redundant: joint `lower`: position along x, follows from joint `upper`")
    );
    let ran = run("buckling");
    assert_eq!(ran.code, Some(0), "{}", ran.said);
    assert!(ran.said.contains("warning: from about t = 10."), "{}", ran.said);
}
