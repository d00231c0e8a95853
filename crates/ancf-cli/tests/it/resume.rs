//! Runs that are killed or stopped, again and again, and go on: their files are to the last bit those of a run that was not.
#![cfg(test)]
#![cfg(unix)]

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

/// A motion of some seconds and two folders for it.
struct Bench {
    folder: TempDir,
    model: String,
}

impl Bench {
    /// The cantilever for so many seconds of its time.
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

    /// Lets a program run until it has put down another checkpoint, or has ended.
    fn until_checkpoint(&self, name: &str, program: &mut Child) {
        let path = self.out(name).join("checkpoint");
        let written = || fs::metadata(&path).and_then(|file| file.modified()).ok();
        let before = written();
        while written() == before && program.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(5));
        }
        // A little more, so that there is something that is lost.
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
        assert!(!self.out("pieces").join("checkpoint").exists(), "there is nothing left to do");
    }

    fn outcome(&self, name: &str) -> Value {
        let text = fs::read(self.out(name).join("summary.json")).unwrap();
        serde_json::from_slice::<Value>(&text).unwrap()["outcome"]["kind"].clone()
    }
}

/// Runs a model whole, and in pieces that a signal ends each; the exit codes of the pieces.
fn in_pieces(bench: &Bench, signal: &str) -> Vec<Option<i32>> {
    let whole = bench.run("whole").output().unwrap();
    assert_eq!(whole.status.code(), Some(0), "{}", stderr(&whole));
    let mut codes = Vec::new();
    let mut program = bench.run("pieces").spawn().unwrap();
    loop {
        bench.until_checkpoint("pieces", &mut program);
        // The first pieces are ended, the last one is let go on.
        if codes.len() < 4 {
            Bench::signal(&program, signal);
        }
        let ended = program.wait_with_output().unwrap();
        codes.push(ended.status.code());
        // What there is can be read at any time.
        let rows = Results::open(bench.out("pieces")).unwrap().columns().unwrap();
        let t = rows.column("t").unwrap();
        assert!(t.windows(2).all(|pair| pair[0] < pair[1]), "rows in order, each once");
        if ended.status.success() {
            break;
        }
        program = bench.resume("pieces").spawn().unwrap();
    }
    codes
}

#[test]
fn killed_runs_go_on_to_the_last_bit() {
    let bench = Bench::new(20.0);
    let codes = in_pieces(&bench, "KILL");
    assert!(codes.len() > 1 && codes[0].is_none(), "it was killed at least once: {codes:?}");
    bench.assert_equal_files();
    assert_eq!(bench.outcome("pieces"), "finished");
}

#[test]
fn stopped_runs_go_on_to_the_last_bit() {
    for (signal, code) in [("INT", 130), ("TERM", 143)] {
        let bench = Bench::new(20.0);
        let codes = in_pieces(&bench, signal);
        assert!(codes.len() > 1 && codes[0] == Some(code), "SIG{signal} stopped it at least once: {codes:?}");
        bench.assert_equal_files();
    }
}

/// `nohup` is heeded: what outlives its terminal goes on.
#[test]
fn a_hang_up_that_is_ignored_stops_nothing() {
    let bench = Bench::new(1000.0);
    let script = "trap '' HUP; exec \"$@\"";
    let run = bench.run("out");
    let arguments: Vec<_> = run.get_args().collect();
    let mut program =
        Command::new("sh").args(["-c", script, "sh"]).arg(run.get_program()).args(arguments).spawn().unwrap();
    bench.until_checkpoint("out", &mut program);
    Bench::signal(&program, "HUP");
    bench.until_checkpoint("out", &mut program);
    assert!(program.try_wait().unwrap().is_none(), "it goes on");
    program.kill().unwrap();
    program.wait().unwrap();
}

/// A stopped run says so everywhere; a finished one has nothing to resume.
#[test]
fn the_end_is_told() {
    let bench = Bench::new(1000.0);
    let mut program = bench.run("out").spawn().unwrap();
    bench.until_checkpoint("out", &mut program);
    Bench::signal(&program, "TERM");
    let ended = program.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(143));
    assert!(stderr(&ended).starts_with("stopped: "), "{}", stderr(&ended));
    assert_eq!(bench.outcome("out"), "stopped");
    let short = Bench::new(0.1);
    assert!(short.run("out").status().unwrap().success());
    let again = short.resume("out").output().unwrap();
    assert_eq!(again.status.code(), Some(0));
    assert!(stderr(&again).contains("is finished: there is nothing to do"), "{}", stderr(&again));
}
