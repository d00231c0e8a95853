use std::env::consts::{ARCH, DLL_EXTENSION, DLL_PREFIX, DLL_SUFFIX, OS};
use std::fs;
use std::path::Path;

use super::options::{ExportError, Fmi};
use crate::interface::MARKER;

/// Name of the file of the shared library.
pub fn library_name() -> String {
    format!("{DLL_PREFIX}ancf_fmu{DLL_SUFFIX}")
}

/// Reads the shared library and checks its version.
pub(super) fn read(path: &Path) -> Result<Vec<u8>, ExportError> {
    let wrong = |reason: String| ExportError::Library { path: path.to_owned(), reason };
    let bytes = fs::read(path).map_err(|error| wrong(error.to_string()))?;
    let text = MARKER.to_bytes();
    match bytes.windows(text.len()).any(|window| window == text) {
        true => Ok(bytes),
        false => {
            let version = env!("CARGO_PKG_VERSION");
            Err(wrong(format!("expected the shared library of the crate ancf-fmu, version {version}")))
        }
    }
}

/// Path of the shared library in an FMU for this platform.
pub(super) fn path_in(version: Fmi, identifier: &str) -> String {
    let folder = match (version, OS, ARCH) {
        (Fmi::Two, "linux", "x86_64") => "linux64".to_owned(),
        (Fmi::Two, "windows", "x86_64") => "win64".to_owned(),
        (Fmi::Two, "macos", _) => "darwin64".to_owned(),
        (_, "macos", arch) => format!("{arch}-darwin"),
        (_, system, arch) => format!("{arch}-{system}"),
    };
    format!("binaries/{folder}/{identifier}.{DLL_EXTENSION}")
}
