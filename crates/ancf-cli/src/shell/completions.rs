//! `ancf completions`: scripts that complete commands and options in a shell.

use clap::Args;
use clap_complete::Shell;

use crate::terminal::{Ended, print_output};

/// Arguments of `ancf completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// Shell.
    shell: Shell,
}

/// Examples of the help.
pub const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  ancf completions bash > ~/.local/share/bash-completion/completions/ancf
  ancf completions zsh > ~/.zfunc/_ancf                  with ~/.zfunc in $fpath
  ancf completions fish > ~/.config/fish/completions/ancf.fish
  ancf completions powershell >> $PROFILE";

impl CompletionsArguments {
    /// Prints the script of the shell.
    pub fn run(&self, program: &clap::Command) -> Ended {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut program.clone(), "ancf", &mut script);
        print_output(&String::from_utf8_lossy(&script));
        Ended::Done
    }
}
