use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Program of a package, with the emulator that runs it.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    /// File.
    pub(crate) file: PathBuf,
    /// Emulator; none for programs of this system.
    pub(crate) emulator: Option<OsString>,
    /// Variables of the emulator.
    pub(crate) variables: Vec<(String, OsString)>,
    /// Program that sends Ctrl-C and keeps files open on Windows.
    pub(crate) console: Option<PathBuf>,
    /// Home folder.
    pub(crate) home: PathBuf,
    /// Factor of the durations of motions, below 1 for programs that are compiled without optimisation.
    pub(crate) pace: f64,
}

impl Program {
    /// Program of this system.
    pub(crate) fn native(file: &Path, home: &Path) -> Self {
        Self {
            file: file.to_owned(),
            emulator: None,
            variables: Vec::new(),
            console: None,
            home: home.to_owned(),
            pace: 1.0,
        }
    }

    /// True for a program of Windows.
    pub(crate) fn is_windows(&self) -> bool {
        self.file.extension().is_some_and(|ending| ending == "exe")
    }

    /// Command in a folder. Variables of this shell are not passed on: a package must not depend on them.
    pub(crate) fn command(&self, folder: &Path, arguments: &[&str]) -> Command {
        let mut command = self.start(&self.file);
        command.args(arguments).current_dir(folder);
        command
    }

    /// Command by way of the console program: `action`, a file, and the arguments of `ancf`.
    pub(crate) fn by_console(
        &self,
        folder: &Path,
        action: &str,
        file: &str,
        arguments: &[&str],
    ) -> Option<Command> {
        let mut command = self.start(self.console.as_deref()?);
        command.args([action, file]).arg(&self.file).args(arguments).current_dir(folder);
        Some(command)
    }

    fn start(&self, file: &Path) -> Command {
        let mut command = Command::new(self.emulator.as_deref().unwrap_or(file.as_os_str()));
        if self.emulator.is_some() {
            command.arg(file);
        }
        command.env_clear().env("HOME", &self.home).env("LC_ALL", "C.UTF-8").env("PATH", "/usr/bin:/bin");
        command.envs(self.variables.iter().map(|(name, value)| (name, value)));
        command
    }
}
