//! Whether there are colours.

use std::env;
use std::ffi::OsString;
use std::io;

use anstream::{AutoStream, ColorChoice};
use clap::ValueEnum;

/// Where there are colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Colour {
    // Words alone: their help would take half of each page.
    #[default]
    Auto,
    Always,
    Never,
}

impl Colour {
    /// What arguments ask for: the help, and what is wrong with them, is coloured before they are understood.
    pub fn asked(arguments: impl Iterator<Item = OsString>) -> Self {
        let mut arguments = arguments.take_while(|argument| argument != "--");
        let mut asked = Self::default();
        while let Some(argument) = arguments.next() {
            let argument = argument.to_string_lossy().into_owned();
            let value = match argument.strip_prefix("--color") {
                Some("") => arguments.next().map(|value| value.to_string_lossy().into_owned()),
                Some(value) => value.strip_prefix('=').map(str::to_owned),
                None => None,
            };
            asked = value.and_then(|value| Self::from_str(&value, false).ok()).unwrap_or(asked);
        }
        asked
    }

    /// The choice with regard to `FORCE_COLOR`, which the streams do not know; they know `NO_COLOR` and `CLICOLOR_FORCE`.
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

    /// Makes it the choice of all streams, and tells that of the help.
    pub fn establish(self) -> clap::ColorChoice {
        let choice = self.choice();
        choice.write_global();
        match choice {
            ColorChoice::Auto => clap::ColorChoice::Auto,
            ColorChoice::Never => clap::ColorChoice::Never,
            ColorChoice::Always | ColorChoice::AlwaysAnsi => clap::ColorChoice::Always,
        }
    }
}

/// Whether standard error is coloured.
pub fn on_stderr() -> bool {
    AutoStream::choice(&io::stderr()) != ColorChoice::Never
}

/// Whether standard output is coloured.
pub fn on_stdout() -> bool {
    AutoStream::choice(&io::stdout()) != ColorChoice::Never
}
