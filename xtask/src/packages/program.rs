//! Archive of the program: program, library of FMUs, completions, manual pages, licences.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::build::Built;
use super::release::{Release, copy, create, create_empty};
use super::{archive, licences};
use crate::system::shell::{Done, run};

/// Files of the repository in all archives.
const DOCUMENTS: [&str; 6] = [
    "README.md",
    "CHANGELOG.md",
    "CITATION.cff",
    "LICENSE-MIT",
    "LICENSE-APACHE",
    "LICENSE-DIRECTION-NUMBERS",
];
/// Scripts of shells and their places.
const COMPLETIONS: [(&str, &str); 5] = [
    ("bash", "share/bash-completion/completions/ancf"),
    ("zsh", "share/zsh/site-functions/_ancf"),
    ("fish", "share/fish/vendor_completions.d/ancf.fish"),
    ("powershell", "share/powershell/ancf.ps1"),
    ("elvish", "share/elvish/lib/ancf.elv"),
];

/// Archive and its name without the ending.
#[derive(Clone, Debug)]
pub(crate) struct ProgramArchive {
    /// File.
    pub(crate) file: PathBuf,
    /// Name of the folder in it.
    pub(crate) name: String,
}

impl ProgramArchive {
    /// Archive of a target.
    pub(crate) fn of(release: &Release, target: &str) -> Self {
        let name = format!("{}-{target}", release.name());
        let ending = if target.contains("windows") { "zip" } else { "tar.gz" };
        Self { file: release.packages.join(format!("{name}.{ending}")), name }
    }

    /// Unpacks the archive into an empty folder. Returns the path of the program.
    pub(crate) fn unpack(&self, folder: &Path) -> Result<PathBuf, String> {
        archive::unpack(&self.file, folder)?;
        let folder = folder.join(&self.name);
        let places = ["bin/ancf", "ancf.exe"].map(|place| folder.join(place));
        let missing = || format!("{} has no program", self.file.display());
        places.into_iter().find(|place| place.is_file()).ok_or_else(missing)
    }
}

/// Writes the archive of a build. `native` is a program of this version that this machine can run.
pub(crate) fn write(
    release: &Release,
    source: &Path,
    target: &str,
    built: &Built,
    native: &Path,
) -> Result<ProgramArchive, String> {
    let archive = ProgramArchive::of(release, target);
    let folder = release.work.join(&archive.name);
    create_empty(&folder)?;
    let is_windows = target.contains("windows");
    // Windows searches for libraries beside the program, and users unpack archives into one folder.
    let [programs, libraries] =
        if is_windows { ["", ""] } else { ["bin", "lib"] }.map(|name| folder.join(name));
    for (file, folder) in [(Some(&built.program), &programs), (built.library.as_ref(), &libraries)] {
        let Some(file) = file else { continue };
        copy(file, &folder.join(file.file_name().unwrap_or_default()))?;
    }
    for document in DOCUMENTS {
        copy(&source.join(document), &folder.join(document))?;
    }
    let notices = folder.join("THIRD-PARTY-LICENSES.txt");
    fs::write(&notices, licences::third_party(source, target)?)
        .map_err(|error| format!("{}: {error}", notices.display()))?;
    shell_files(native, &folder)?;
    archive::write(&folder, &archive.file)?;
    Ok(archive)
}

/// Writes completions and manual pages.
fn shell_files(native: &Path, folder: &Path) -> Done {
    for (shell, place) in COMPLETIONS {
        let place = folder.join(place);
        let script = Command::new(native).args(["completions", shell]).output();
        let script = script.map_err(|error| format!("cannot run {}: {error}", native.display()))?;
        if !script.status.success() || script.stdout.is_empty() {
            return Err(format!("no completions for {shell}"));
        }
        create(place.parent().unwrap_or(folder))?;
        fs::write(&place, script.stdout).map_err(|error| format!("{}: {error}", place.display()))?;
    }
    let pages = folder.join("share/man/man1");
    run("manual pages", Command::new(native).args(["--quiet", "man"]).arg(pages))
}

/// Checks that an unpacked archive has all files.
pub(crate) fn check(folder: &Path) -> Done {
    let others = ["THIRD-PARTY-LICENSES.txt", "share/man/man1/ancf.1", "share/man/man1/ancf-run.1"];
    let scripts = COMPLETIONS.map(|(_, place)| place);
    let expected = DOCUMENTS.iter().chain(&others).chain(&scripts);
    for place in expected {
        let file = folder.join(place);
        let length = fs::metadata(&file).map(|file| file.len()).unwrap_or(0);
        if length < 40 {
            return Err(format!("{} is missing or empty", file.display()));
        }
    }
    Ok(())
}
