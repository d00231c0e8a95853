//! Choice of colours.

use std::env;
use std::ffi::OsString;
use std::io;

use anstream::{AutoStream, ColorChoice};
use clap::ValueEnum;

/// Use of colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Colour {
    // No doc comments: the help would be twice as long.
    #[default]
    Auto,
    Always,
    Never,
}

impl Colour {
    /// Returns the choice in the arguments. It is required before parsing, for help and error messages.
    pub fn requested(arguments: impl Iterator<Item = OsString>) -> Self {
        let mut arguments = arguments.take_while(|argument| argument != "--");
        let mut requested = Self::default();
        while let Some(argument) = arguments.next() {
            let argument = argument.to_string_lossy().into_owned();
            let value = match argument.strip_prefix("--color") {
                Some("") => arguments.next().map(|value| value.to_string_lossy().into_owned()),
                Some(value) => value.strip_prefix('=').map(str::to_owned),
                None => None,
            };
            requested = value.and_then(|value| Self::from_str(&value, false).ok()).unwrap_or(requested);
        }
        requested
    }

    /// Returns the choice, considering `FORCE_COLOR`. The streams consider `NO_COLOR` and `CLICOLOR_FORCE` themselves.
    fn choice(self) -> ColorChoice {
        let set = |name| env::var_os(name).filter(|value| !value.is_empty());
        match self {
            Self::Always => ColorChoice::Always,
            Self::Never => ColorChoice::Never,
            Self::Auto if set("NO_COLOR").is_some() => ColorChoice::Never,
            Self::Auto => match set("FORCE_COLOR") {
                Some(value) if value == "0" => ColorChoice::Never,
                Some(_) => ColorChoice::Always,
                None => ColorChoice::Auto,
            },
        }
    }

    /// Applies the choice to all streams, and returns the choice of the help.
    pub fn apply(self) -> clap::ColorChoice {
        let choice = self.choice();
        choice.write_global();
        match choice {
            ColorChoice::Auto => clap::ColorChoice::Auto,
            ColorChoice::Never => clap::ColorChoice::Never,
            ColorChoice::Always | ColorChoice::AlwaysAnsi => clap::ColorChoice::Always,
        }
    }
}

/// True if standard error is coloured.
pub fn is_stderr_coloured() -> bool {
    AutoStream::choice(&io::stderr()) != ColorChoice::Never
}

/// True if standard output is coloured.
pub fn is_stdout_coloured() -> bool {
    AutoStream::choice(&io::stdout()) != ColorChoice::Never
}
