//! Numerical failures: exit code, message, results so far.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// Run of a model with numerical difficulties.
struct FailedRun {
    code: Option<i32>,
    messages: String,
    folder: TempDir,
}

fn run(model: &str) -> FailedRun {
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
    FailedRun {
        code: output.status.code(),
        messages: String::from_utf8_lossy(&output.stderr).into_owned(),
        folder,
    }
}

impl FailedRun {
    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    /// Returns the first column of the results.
    fn times(&self) -> Vec<f64> {
        let text = fs::read_to_string(self.out().join("probes.csv")).unwrap();
        text.lines().skip(1).map(|line| line.split(',').next().unwrap().parse().unwrap()).collect()
    }
}

/// Time, reason, location and advice; exit code 1; rows so far.
#[test]
fn failures_are_reported_and_preserve_results() {
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
                "finite at all times",
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
        assert_eq!(ran.code, Some(1), "{model}: {}", ran.messages);
        for word in words {
            assert!(ran.messages.contains(word), "{model}: no `{word}` in\n{}", ran.messages);
        }
        assert!(
            ran.messages.contains("; try: ") && ran.messages.contains("results so far in "),
            "{model}: {}",
            ran.messages
        );
        let times = ran.times();
        assert!(times[0] == 0.0 && (times.last().unwrap() - last).abs() < 1e-6, "{model}: {times:?}");
        let summary: serde_json::Value =
            serde_json::from_slice(&fs::read(ran.out().join("summary.json")).unwrap()).unwrap();
        assert_eq!(summary["outcome"]["kind"], "failed");
        assert!(summary["outcome"]["advice"].is_string());
    }
}

/// A mechanism has no equilibrium.
#[test]
fn mechanisms_have_no_equilibrium() {
    let ran = run("singular");
    assert_eq!(ran.code, Some(1), "{}", ran.messages);
    assert!(
        ran.messages
            .contains("no equilibrium: a motion is unsupported; at: body `arm` can rotate about the axis"),
        "{}",
        ran.messages
    );
}

/// Warnings of runs that finish.
#[test]
fn warnings_of_finished_runs() {
    let ran = run("redundant");
    assert_eq!(ran.code, Some(0), "{}", ran.messages);
    assert!(
        ran.messages
            .contains("warning: redundant: joint `lower`: position along x, follows from joint `upper`")
    );
    let ran = run("buckling");
    assert_eq!(ran.code, Some(0), "{}", ran.messages);
    assert!(ran.messages.contains("warning: from about t = 10 to t = "), "{}", ran.messages);
}
