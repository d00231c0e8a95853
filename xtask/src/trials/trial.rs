use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use super::program::Program;
use crate::system::shell::Done;

/// Longest duration of a command.
const PATIENCE: Duration = Duration::from_secs(300);

/// Folder in which a program is tried.
#[derive(Debug)]
pub(super) struct Trial<'a> {
    /// Program.
    pub(super) program: &'a Program,
    /// Folder of models and results. Its name has spaces and letters outside of ASCII.
    pub(super) folder: PathBuf,
}

/// End of a command.
#[derive(Debug)]
pub(super) struct Ended {
    /// Exit code.
    pub(super) code: Option<i32>,
    /// Standard output.
    pub(super) stdout: String,
    /// Standard error.
    pub(super) stderr: String,
}

impl Trial<'_> {
    /// Runs the program and returns its end.
    pub(super) fn ancf(&self, arguments: &[&str]) -> Result<Ended, String> {
        finish(self.program.command(&self.folder, arguments))
    }

    /// Runs the program, which must end with an exit code.
    pub(super) fn ends(&self, code: i32, arguments: &[&str]) -> Result<Ended, String> {
        let ended = self.ancf(arguments)?;
        match ended.code == Some(code) {
            true => Ok(ended),
            false => Err(format!("`ancf {}`: expected exit code {code}: {ended:?}", arguments.join(" "))),
        }
    }

    /// Runs the program, which must succeed.
    pub(super) fn done(&self, arguments: &[&str]) -> Result<Ended, String> {
        self.ends(0, arguments)
    }

    /// Path in the folder.
    pub(super) fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Reads a file of the folder.
    pub(super) fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        fs::read(self.path(name)).map_err(|error| format!("{name}: {error}"))
    }

    /// Reads a text of the folder.
    pub(super) fn text(&self, name: &str) -> Result<String, String> {
        String::from_utf8(self.read(name)?).map_err(|error| format!("{name}: {error}"))
    }

    /// Writes a file of the folder.
    pub(super) fn write(&self, name: &str, contents: impl AsRef<[u8]>) -> Done {
        fs::write(self.path(name), contents).map_err(|error| format!("{name}: {error}"))
    }

    /// Shortens the motion of a model by the pace of the program.
    pub(super) fn shorten(&self, name: &str) -> Done {
        let shortened = |line: &str| {
            let value = line.strip_prefix("duration = ").and_then(|rest| rest.split_whitespace().next());
            match value.and_then(|value| value.parse::<f64>().ok()) {
                Some(value) if self.program.pace < 1.0 => {
                    format!("duration = {:?}\n", value * self.program.pace)
                }
                _ => format!("{line}\n"),
            }
        };
        self.write(name, self.text(name)?.lines().map(shortened).collect::<String>())
    }

    /// Writes the model of the cantilever with a duration.
    pub(super) fn cantilever(&self, name: &str, duration: f64) -> Done {
        let text = include_str!("../../../models/cantilever.toml");
        let duration = duration * self.program.pace;
        let changed = text.replace("duration = 2.0", &format!("duration = {duration:?}"));
        self.write(name, changed.replace("elements = 20", "elements = 4"))
    }
}

/// Runs a command to its end, but not longer than [`PATIENCE`].
///
/// Its output goes to files: services that Wine starts keep pipes open.
pub(super) fn finish(command: Command) -> Result<Ended, String> {
    finish_with(command, Stdio::null())
}

/// Runs a command with a standard input.
pub(super) fn finish_with(mut command: Command, input: Stdio) -> Result<Ended, String> {
    let file = |name: &str| std::env::temp_dir().join(format!("ancf trial {} {name}", std::process::id()));
    let files = ["stdout", "stderr"].map(file);
    let create = |file: &Path| File::create(file).map_err(|error| format!("{}: {error}", file.display()));
    command.stdin(input).stdout(create(&files[0])?).stderr(create(&files[1])?);
    let program = command.get_program().display().to_string();
    let mut child = command.spawn().map_err(|error| format!("cannot run {program}: {error}"))?;
    let start = Instant::now();
    let code = loop {
        if let Some(status) = child.try_wait().map_err(|error| format!("{program}: {error}"))? {
            break status.code();
        }
        if start.elapsed() > PATIENCE {
            let _ = child.kill().and_then(|()| child.wait());
            return Err(format!("{program} did not end in {} s", PATIENCE.as_secs()));
        }
        thread::sleep(Duration::from_millis(5));
    };
    let text = |file: &Path| fs::read(file).map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let [stdout, stderr] = [&files[0], &files[1]].map(|file| text(file).map_err(|error| error.to_string()));
    files.iter().for_each(|file| _ = fs::remove_file(file));
    Ok(Ended { code, stdout: stdout?, stderr: stderr? })
}

/// Fails with a message and the text in which something is missing.
pub(super) fn expect(holds: bool, what: &str, found: impl std::fmt::Debug) -> Done {
    if holds { Ok(()) } else { Err(format!("expected {what}, found {found:?}")) }
}

/// Waits until a file is not empty.
pub(super) fn wait_for(file: &Path) -> Done {
    let start = Instant::now();
    while fs::metadata(file).map_or(0, |file| file.len()) == 0 {
        if start.elapsed() > PATIENCE {
            return Err(format!("{} was not written", file.display()));
        }
        thread::sleep(Duration::from_millis(20));
    }
    Ok(())
}
