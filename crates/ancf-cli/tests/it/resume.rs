//! Runs that are killed or stopped repeatedly and resumed: their files are bit-identical to those of an uninterrupted run.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use ancf_results::Results;
use serde_json::Value;
use tempfile::TempDir;

const FILES: [&str; 3] = ["results.parquet", "states.parquet", "probes.csv"];

fn ancf(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    command.args(arguments).stdout(Stdio::null()).stderr(Stdio::piped());
    command
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Folder with a model and its runs.
struct ResumeFolder {
    folder: TempDir,
    model: String,
}

impl ResumeFolder {
    /// Creates a folder with the cantilever of `duration` seconds.
    fn new(duration: f64) -> Self {
        let folder = TempDir::new().unwrap();
        let text = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/cantilever.toml");
        let text = fs::read_to_string(text).unwrap();
        let changed = text
            .replace("duration = 2.0", &format!("duration = {duration:?}"))
            .replace("elements = 20", "elements = 4");
        assert_ne!(changed, text);
        let model = folder.path().join("model.toml");
        fs::write(&model, changed).unwrap();
        Self { model: model.to_str().unwrap().to_owned(), folder }
    }

    fn out(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn run(&self, name: &str) -> Command {
        ancf(&["run", &self.model, "-o", self.out(name).to_str().unwrap(), "--checkpoint", "500"])
    }

    fn resume(&self, name: &str) -> Command {
        ancf(&["resume", self.out(name).to_str().unwrap(), "--checkpoint", "500"])
    }

    /// Waits until a program has written another checkpoint or has ended.
    fn until_checkpoint(&self, name: &str, program: &mut Child) {
        let path = self.out(name).join("checkpoint");
        let written = || fs::metadata(&path).and_then(|file| file.modified()).ok();
        let before = written();
        while written() == before && program.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(5));
        }
        // Rows after the checkpoint are lost.
        std::thread::sleep(Duration::from_millis(30));
    }

    fn signal(program: &Child, name: &str) {
        Command::new("kill").args([&format!("-{name}"), &program.id().to_string()]).status().unwrap();
    }

    fn assert_equal_files(&self) {
        for file in FILES {
            let [whole, pieces] =
                ["whole", "pieces"].map(|name| fs::read(self.out(name).join(file)).unwrap());
            assert!(whole == pieces, "{file} differs");
        }
        assert!(!self.out("pieces").join("checkpoint").exists(), "a finished run has no checkpoint");
    }

    fn outcome(&self, name: &str) -> Value {
        let text = fs::read(self.out(name).join("summary.json")).unwrap();
        serde_json::from_slice::<Value>(&text).unwrap()["outcome"]["kind"].clone()
    }
}

/// Runs a model without interruption and in pieces that a signal stops. Returns the exit codes of the pieces.
fn in_pieces(folder: &ResumeFolder, signal: &str) -> Vec<Option<i32>> {
    let whole = folder.run("whole").output().unwrap();
    assert_eq!(whole.status.code(), Some(0), "{}", stderr(&whole));
    let mut codes = Vec::new();
    let mut program = folder.run("pieces").spawn().unwrap();
    loop {
        folder.until_checkpoint("pieces", &mut program);
        // The last piece is not stopped.
        if codes.len() < 4 {
            ResumeFolder::signal(&program, signal);
        }
        let ended = program.wait_with_output().unwrap();
        codes.push(ended.status.code());
        // The results so far are readable at any time.
        let rows = Results::open(folder.out("pieces")).unwrap().columns().unwrap();
        let t = rows.column("t").unwrap();
        assert!(t.windows(2).all(|pair| pair[0] < pair[1]), "rows in order, each once");
        if ended.status.success() {
            break;
        }
        program = folder.resume("pieces").spawn().unwrap();
    }
    codes
}

#[test]
fn killed_runs_resume_bit_identically() {
    let folder = ResumeFolder::new(20.0);
    let codes = in_pieces(&folder, "KILL");
    assert!(codes.len() > 1 && codes[0].is_none(), "it was killed at least once: {codes:?}");
    folder.assert_equal_files();
    assert_eq!(folder.outcome("pieces"), "finished");
}

#[test]
fn stopped_runs_resume_bit_identically() {
    for (signal, code) in [("INT", 130), ("TERM", 143)] {
        let folder = ResumeFolder::new(20.0);
        let codes = in_pieces(&folder, signal);
        assert!(codes.len() > 1 && codes[0] == Some(code), "SIG{signal} stopped it at least once: {codes:?}");
        folder.assert_equal_files();
    }
}

/// Under `nohup` a run continues after its terminal is closed.
#[test]
fn an_ignored_hang_up_does_not_stop_a_run() {
    let folder = ResumeFolder::new(1000.0);
    let script = "trap '' HUP; exec \"$@\"";
    let run = folder.run("out");
    let arguments: Vec<_> = run.get_args().collect();
    let mut program =
        Command::new("sh").args(["-c", script, "sh"]).arg(run.get_program()).args(arguments).spawn().unwrap();
    folder.until_checkpoint("out", &mut program);
    ResumeFolder::signal(&program, "HUP");
    folder.until_checkpoint("out", &mut program);
    assert!(program.try_wait().unwrap().is_none(), "the run continues");
    program.kill().unwrap();
    program.wait().unwrap();
}

/// A stopped run reports its outcome. A finished run is not resumed.
#[test]
fn the_outcome_is_reported() {
    let folder = ResumeFolder::new(1000.0);
    let mut program = folder.run("out").spawn().unwrap();
    folder.until_checkpoint("out", &mut program);
    ResumeFolder::signal(&program, "TERM");
    let ended = program.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(143));
    assert!(stderr(&ended).lines().any(|line| line.starts_with("stopped: ")), "{}", stderr(&ended));
    assert_eq!(folder.outcome("out"), "stopped");
    let short = ResumeFolder::new(0.1);
    assert!(short.run("out").status().unwrap().success());
    let again = short.resume("out").output().unwrap();
    assert_eq!(again.status.code(), Some(0));
    assert!(stderr(&again).contains("is finished: there is nothing to do"), "{}", stderr(&again));
}
