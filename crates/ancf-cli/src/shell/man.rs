//! `ancf man`: manual pages.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};
use clap::Args;
use clap_mangen::Man;

use crate::terminal::{Ended, print_output, print_status};

/// Arguments of `ancf man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Folder for ancf.1, ancf-run.1, ...; without it, ancf.1 is printed.
    #[arg(value_name = "DIR")]
    folder: Option<PathBuf>,
}

/// Examples of the help.
pub const MAN_EXAMPLES: &str = "\
Examples:
  ancf man ~/.local/share/man/man1      then `man ancf-run`
  ancf man | man -l -                   show only";

impl ManArguments {
    /// Writes or prints the pages.
    pub fn run(&self, program: &clap::Command) -> Result<Ended> {
        let program = program.clone().disable_help_subcommand(true);
        let Some(folder) = &self.folder else {
            let mut page = Vec::new();
            Man::new(program).render(&mut page)?;
            print_output(&String::from_utf8_lossy(&page));
            return Ok(Ended::Done);
        };
        let write = || fs::create_dir_all(folder).and_then(|()| clap_mangen::generate_to(program, folder));
        write().with_context(|| format!("cannot write into {}", folder.display()))?;
        print_status(&format!("done: manual pages in {}", folder.display()));
        Ok(Ended::Done)
    }
}
