//! Source archive: the files of the last commit, which build without the repository.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use super::archive;
use super::release::Release;
use crate::system::shell::{root, run, say};

/// Writes the source archive and unpacks it, once in a run. Returns the unpacked folder: all packages are built from it.
pub(crate) fn unpacked(release: &Release) -> Result<PathBuf, String> {
    static DONE: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    DONE.get_or_init(|| write(release)).clone()
}

fn write(release: &Release) -> Result<PathBuf, String> {
    let changed = Command::new("git").args(["status", "--porcelain"]).current_dir(root()).output();
    let changed = changed.map_err(|error| format!("cannot run git: {error}"))?;
    if !changed.status.success() {
        return Err("the source archive requires a clone of the repository".to_owned());
    }
    if !changed.stdout.is_empty() {
        say("warning: uncommitted changes are NOT in the packages, which are those of the last commit");
    }
    let name = release.name();
    let file = release.packages.join(format!("{name}-source.tar.gz"));
    let mut command = Command::new("git");
    command.args(["archive", "--format=tar.gz", &format!("--prefix={name}/"), "-o"]).arg(&file).arg("HEAD");
    run("source archive", command.current_dir(root()))?;
    let new = release.work.join("unpacked");
    archive::unpack(&file, &new)?;
    let folder = release.work.join("source");
    mirror(&new, &folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(folder.join(name))
}

/// Makes a folder equal to another one. Equal files keep their times, so that cargo compiles only what changed.
fn mirror(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(to)? {
        let entry = entry?;
        if !from.join(entry.file_name()).exists() {
            match entry.file_type()?.is_dir() {
                true => fs::remove_dir_all(entry.path())?,
                false => fs::remove_file(entry.path())?,
            }
        }
    }
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (from, to) = (entry.path(), to.join(entry.file_name()));
        if entry.file_type()?.is_dir() {
            mirror(&from, &to)?;
        } else if fs::read(&to).ok() != Some(fs::read(&from)?) {
            fs::copy(&from, &to)?;
        }
    }
    Ok(())
}
