//! Cargo subcommands from crates.io, built into `target/tools` on first use.

use std::path::PathBuf;
use std::process::Command;

use crate::system::shell::{root, run};

/// Subcommand of cargo from crates.io, of a fixed version.
#[derive(Debug)]
pub(crate) struct Tool {
    /// Name of the crate and of its program.
    pub(crate) name: &'static str,
    /// Version.
    pub(crate) version: &'static str,
}

impl Tool {
    /// Returns the path of the program. Compiles it if it is missing, which takes about a minute.
    pub(crate) fn program(&self) -> Result<PathBuf, String> {
        let Self { name, version } = self;
        let folder = root().join("target/tools").join(format!("{name}-{version}"));
        let program = folder.join("bin").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
        if !program.exists() {
            let mut install = Command::new(env!("CARGO"));
            install
                .args(["install", "--locked", "--debug", "--version", version, name, "--root"])
                .arg(&folder);
            run(name, &mut install)?;
        }
        Ok(program)
    }
}
