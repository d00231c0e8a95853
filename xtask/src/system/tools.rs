//! Programs of others that are built into `target/tools` when they are wanted first.

use std::path::PathBuf;
use std::process::Command;

use crate::system::shell::{root, run};

/// A subcommand of cargo from crates.io, of one version.
#[derive(Debug)]
pub(crate) struct Tool {
    /// The name of the crate and of its program.
    pub(crate) name: &'static str,
    /// The version.
    pub(crate) version: &'static str,
}

impl Tool {
    /// The program, which is compiled if it is not there: a minute or so.
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
