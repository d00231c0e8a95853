//! `ancf completions` and `ancf man`: what shells and readers of manuals want to know.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result};
use clap::{Args, CommandFactory};
use clap_complete::Shell;
use clap_mangen::Man as Page;

use crate::command::Ended;
use crate::speech::{deliver, say};

/// What `ancf completions` is asked.
#[derive(Debug, Args)]
pub struct Completions {
    /// The shell.
    shell: Shell,
}

/// What `ancf man` is asked.
#[derive(Debug, Args)]
pub struct Man {
    /// The folder for ancf.1, ancf-run.1, ...; without it, ancf.1 is printed.
    #[arg(value_name = "DIR")]
    folder: Option<PathBuf>,
}

pub const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  ancf completions bash > ~/.local/share/bash-completion/completions/ancf
  ancf completions zsh > ~/.zfunc/_ancf                  with ~/.zfunc in $fpath
  ancf completions fish > ~/.config/fish/completions/ancf.fish
  ancf completions powershell >> $PROFILE";

pub const MAN_EXAMPLES: &str = "\
Examples:
  ancf man ~/.local/share/man/man1      then `man ancf-run`
  ancf man | man -l -                   to look at it only";

impl Completions {
    /// Prints the script of the shell.
    pub fn run(&self) -> Ended {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut crate::Arguments::command(), "ancf", &mut script);
        deliver(&String::from_utf8_lossy(&script));
        Ended::Done
    }
}

impl Man {
    /// Writes or prints the pages.
    pub fn run(&self) -> Result<Ended> {
        let program = crate::Arguments::command().disable_help_subcommand(true);
        let Some(folder) = &self.folder else {
            let mut page = Vec::new();
            Page::new(program).render(&mut page)?;
            deliver(&String::from_utf8_lossy(&page));
            return Ok(Ended::Done);
        };
        let write = || fs::create_dir_all(folder).and_then(|()| clap_mangen::generate_to(program, folder));
        write().with_context(|| format!("cannot write into {}", folder.display()))?;
        say(&format!("done: manual pages in {}", folder.display()));
        Ok(Ended::Done)
    }
}
