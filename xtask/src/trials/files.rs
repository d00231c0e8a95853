//! Paths, line ends, permissions, files in use.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::trial::{Trial, expect, finish};
use crate::system::shell::Done;

/// A model with other line ends and a byte order mark is the same model.
pub(super) fn line_ends(trial: &Trial<'_>) -> Done {
    let model = trial.text("statics.toml")?;
    trial.write("crlf.toml", model.replace('\n', "\r\n"))?;
    trial.write("bom.toml", format!("\u{feff}{}", model.replace('\n', "\r\n")))?;
    for name in ["crlf", "bom"] {
        trial.done(&["run", &format!("{name}.toml"), "-o", name])?;
        let [own, other] = ["statics", name].map(|run| trial.read(&format!("{run}/probes.csv")));
        expect(own? == other?, "equal results", name)?;
    }
    // Places in messages count characters, not bytes of the line end.
    trial.write("crlf wrong.toml", model.replacen("young", "yuong", 1).replace('\n', "\r\n"))?;
    let line = 1 + model.lines().position(|line| line.contains("young")).unwrap_or_default();
    let ended = trial.ends(2, &["check", "crlf wrong.toml"])?;
    expect(ended.stderr.contains(&format!("crlf wrong.toml:{line}:")), "the line", ended)
}

pub(super) fn default_folder(trial: &Trial<'_>) -> Done {
    trial.write("ohne Ordner.toml", trial.read("statics.toml")?)?;
    trial.done(&["run", "ohne Ordner.toml"])?;
    trial.read("ohne Ordner/probes.csv").map(|_| ())
}

pub(super) fn absolute_path(trial: &Trial<'_>) -> Done {
    let unix = trial.path("absolut").display().to_string();
    let path = if trial.program.is_windows() { windows_path(&unix) } else { unix };
    trial.done(&["run", "statics.toml", "-o", &path])?;
    trial.read("absolut/probes.csv").map(|_| ())
}

/// Path of a file of this system on the drive on which Wine shows it.
fn windows_path(unix: &str) -> String {
    format!("Z:{}", unix.replace('/', "\\"))
}

/// Windows accepts both separators, also mixed.
pub(super) fn separators(trial: &Trial<'_>) -> Done {
    fs::create_dir_all(trial.path("a/b c")).map_err(|error| error.to_string())?;
    trial.write("a/b c/model.toml", trial.read("statics.toml")?)?;
    let separator = if trial.program.is_windows() { "\\" } else { "/" };
    let model = ["a", "b c/model.toml"].join(separator);
    let out = ["a", "b c", "out"].join(separator);
    trial.done(&["run", &model, "-o", &out])?;
    trial.done(&["report", &out])?;
    trial.read("a/b c/out/report.html").map(|_| ())
}

/// Paths with more than 260 characters, the classical limit of Windows, in folders that exist and in new ones.
pub(super) fn long_path(trial: &Trial<'_>) -> Done {
    let folder = ["long name of a folder, forty characters"; 7].join("/");
    let unix = trial.path(&folder).display().to_string();
    let path = if trial.program.is_windows() { windows_path(&unix) } else { unix };
    trial.done(&["run", "statics.toml", "-o", &path])?;
    trial.read(&format!("{folder}/probes.csv")).map(|_| ())
}

pub(super) fn names(trial: &Trial<'_>) -> Done {
    trial.write("Träger Größe 数.toml", trial.read("statics.toml")?)?;
    let ended = trial.done(&["run", "Träger Größe 数.toml", "-o", "Ergebnis für Träger 数"])?;
    expect(ended.stderr.contains("Ergebnis für Träger 数"), "the name of the folder", &ended)?;
    let summary = trial.text("Ergebnis für Träger 数/summary.json")?;
    expect(summary.contains("finished"), "a summary", summary)
}

pub(super) fn missing(trial: &Trial<'_>) -> Done {
    let ended = trial.ends(2, &["check", "fehlt ä.toml"])?;
    expect(
        ended.stderr.contains("fehlt ä.toml") && ended.stderr.contains("no such file"),
        "the file",
        &ended,
    )?;
    trial.ends(2, &["report", "fehlt ä"]).map(|_| ())
}

/// Results cannot be written into a folder without permission. The message names it.
pub(super) fn read_only(trial: &Trial<'_>) -> Done {
    let folder = trial.path(READ_ONLY);
    fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let Some(_locked) = ReadOnly::new(&folder) else {
        return Err("the folder cannot be made read-only".to_owned());
    };
    let ended = trial.ancf(&["run", "statics.toml", "-o", "nur lesen/out"])?;
    let message = ended.stderr.to_lowercase();
    let is_explained = ["denied", "read-only", "not permitted", "write protected", "write-protected"]
        .iter()
        .any(|word| message.contains(word));
    expect(ended.code == Some(1) && is_explained && message.contains("nur lesen"), "a message", &ended)
}

/// Name of the folder that is read-only.
const READ_ONLY: &str = "nur lesen";

/// A folder that nobody can write to, also not root, as long as this exists.
struct ReadOnly<'a>(&'a Path);

impl<'a> ReadOnly<'a> {
    fn new(folder: &'a Path) -> Option<Self> {
        let locked = Self(folder);
        // Root ignores permissions. A file system that is mounted read-only stops root too.
        let mut mount = Command::new("mount");
        mount.args(["-t", "tmpfs", "-o", "ro", "tmpfs"]).arg(folder);
        let mounted = mount.output().is_ok_and(|output| output.status.success());
        let mut permissions = fs::metadata(folder).ok()?.permissions();
        permissions.set_readonly(true);
        let restricted = mounted || fs::set_permissions(folder, permissions).is_ok();
        let test = folder.join("test");
        let is_locked = restricted && fs::write(&test, "x").is_err();
        is_locked.then_some(locked)
    }
}

impl Drop for ReadOnly<'_> {
    fn drop(&mut self) {
        unlock_folder(self.0);
    }
}

/// Makes the read-only folder of an earlier trial writable, so that it can be removed.
pub(super) fn unlock(trial: &Path) {
    let folder = trial.join(READ_ONLY);
    if folder.exists() {
        unlock_folder(&folder);
    }
}

fn unlock_folder(folder: &Path) {
    let _ = Command::new("umount").arg(folder).output();
    let _ = Command::new("chmod").arg("u+w").arg(folder).output();
}

/// A table that another program shows. On Windows such a file cannot be replaced: the message states the reason, and the file is complete.
pub(super) fn replaced_while_open(trial: &Trial<'_>) -> Done {
    trial.done(&["run", "statics.toml", "-o", "offen"])?;
    trial.done(&["report", "offen"])?;
    let arguments = ["report", "offen"];
    let Some(command) = trial.program.by_console(&trial.folder, "hold", "offen/report.html", &arguments)
    else {
        let _reader = fs::File::open(trial.path("offen/report.html")).map_err(|error| error.to_string())?;
        return trial.done(&arguments).map(|_| ());
    };
    let before = trial.read("offen/report.html")?;
    let ended = finish(command)?;
    let is_explained = ended.stderr.contains("report.html") && ended.stderr.contains("another program");
    expect(ended.code == Some(1) && is_explained, "a message about the open file", &ended)?;
    expect(trial.read("offen/report.html")? == before, "the report unchanged", "another file")?;
    let parts = fs::read_dir(trial.path("offen")).into_iter().flatten().flatten();
    let parts: Vec<_> = parts
        .map(|entry| entry.file_name())
        .filter(|name| name.to_string_lossy().ends_with(".part"))
        .collect();
    expect(parts.is_empty(), "no incomplete file", parts)?;
    trial.done(&arguments).map(|_| ())
}
