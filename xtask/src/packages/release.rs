//! Version, folders and build profile of a release.

use std::fs;
use std::path::{Path, PathBuf};

use crate::system::shell::root;

/// Release whose packages are built.
#[derive(Debug)]
pub(crate) struct Release {
    /// Version of all packages.
    pub(crate) version: String,
    /// Folder of the packages.
    pub(crate) packages: PathBuf,
    /// Folder of intermediate files.
    pub(crate) work: PathBuf,
    /// Profile of the programs.
    pub(crate) profile: String,
}

impl Release {
    /// Returns the release of the workspace. Removes packages of another version.
    pub(crate) fn new(profile: &str) -> Result<Self, String> {
        let manifest = root().join("Cargo.toml");
        let text =
            fs::read_to_string(&manifest).map_err(|error| format!("{}: {error}", manifest.display()))?;
        let manifest: toml::Table = text.parse().map_err(|error| format!("Cargo.toml: {error}"))?;
        let package = manifest["workspace"].get("package");
        let version = package.and_then(|package| package.get("version")).and_then(toml::Value::as_str);
        let version = version.ok_or("Cargo.toml has no version of the workspace")?.to_owned();
        let folder = root().join("target/packages");
        let release = Self {
            packages: folder.join(format!("ancf-{version}")),
            work: folder.join("work"),
            version,
            profile: profile.to_owned(),
        };
        for folder in [&release.packages, &release.work] {
            create(folder)?;
        }
        Ok(release)
    }

    /// Name of the release, which is that of the folder in the source archive.
    pub(crate) fn name(&self) -> String {
        format!("ancf-{}", self.version)
    }
}

/// Creates a folder and those above it.
pub(crate) fn create(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("cannot create {}: {error}", folder.display()))
}

/// Creates an empty folder in place of an existing one.
pub(crate) fn create_empty(folder: &Path) -> Result<(), String> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|error| format!("cannot remove {}: {error}", folder.display()))?;
    }
    create(folder)
}

/// Copies a file into a folder that is created if it is missing.
pub(crate) fn copy(from: &Path, to: &Path) -> Result<(), String> {
    create(to.parent().unwrap_or(to))?;
    let copied = fs::copy(from, to);
    copied.map(|_| ()).map_err(|error| format!("cannot copy {} to {}: {error}", from.display(), to.display()))
}
