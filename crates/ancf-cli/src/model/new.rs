//! `ancf new`: a commented model to start from.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::{Args, ValueEnum};

use crate::terminal::{Ended, print_output, print_status, report_argument_error};

/// Arguments of `ancf new`.
#[derive(Debug, Args)]
pub struct NewArguments {
    /// Model file to write; `-` for standard output.
    file: PathBuf,
    /// Kind of the model.
    #[arg(short, long, default_value = "cantilever")]
    kind: TemplateKind,
    /// Overwrite an existing file.
    #[arg(short, long)]
    force: bool,
}

/// Examples of the help.
pub const NEW_EXAMPLES: &str = "\
Examples:
  ancf new beam.toml                         a clamped rod that swings under its weight
  ancf new --kind contact drop.toml          a rope that falls on the ground
  ancf new --kind modes - | less             print only";

/// Kind of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum TemplateKind {
    /// Motion: clamped rod that swings under its weight.
    Cantilever,
    /// Equilibrium: cord suspended between two points.
    Cable,
    /// Motion: double pendulum of a flexible rod and a rigid body.
    Pendulum,
    /// Motion: slider-crank mechanism with a flexible rod.
    Mechanism,
    /// Motion: rope that falls on the ground, with friction.
    Contact,
    /// Equilibrium: wire with large deflection under a force.
    Statics,
    /// Equilibrium path with snap-through: shallow arch.
    Path,
    /// Natural frequencies and mode shapes of a blade.
    Modes,
    /// Critical loads of a column.
    Buckling,
}

impl TemplateKind {
    /// Returns the text of the model.
    const fn text(self) -> &'static str {
        match self {
            Self::Cantilever => include_str!("../../templates/cantilever.toml"),
            Self::Cable => include_str!("../../templates/cable.toml"),
            Self::Pendulum => include_str!("../../templates/pendulum.toml"),
            Self::Mechanism => include_str!("../../templates/mechanism.toml"),
            Self::Contact => include_str!("../../templates/contact.toml"),
            Self::Statics => include_str!("../../templates/statics.toml"),
            Self::Path => include_str!("../../templates/path.toml"),
            Self::Modes => include_str!("../../templates/modes.toml"),
            Self::Buckling => include_str!("../../templates/buckling.toml"),
        }
    }

    /// Returns columns of interest, as arguments of `ancf plot`.
    const fn columns(self) -> &'static str {
        match self {
            Self::Cantilever | Self::Statics => "tip.y",
            Self::Cable => "middle.z",
            Self::Pendulum => "tip",
            Self::Mechanism => "block.x",
            Self::Contact => "'*.z'",
            Self::Path => "load --against crown.y",
            Self::Modes => "frequency",
            Self::Buckling => "factor",
        }
    }
}

impl NewArguments {
    /// Writes the model.
    pub fn run(&self) -> Result<Ended> {
        let text = self.kind.text();
        if self.file == Path::new("-") {
            print_output(text);
            return Ok(Ended::Done);
        }
        match self.write(text) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                let hint = "--force overwrites it";
                return Ok(report_argument_error(&format!("{} exists already; {hint}", self.file.display())));
            }
            written => written.with_context(|| format!("cannot write {}", self.file.display()))?,
        }
        print_status(&self.next_commands());
        Ok(Ended::Done)
    }

    fn write(&self, text: &str) -> io::Result<()> {
        let mut file = match self.force {
            true => File::create(&self.file)?,
            false => File::create_new(&self.file)?,
        };
        file.write_all(text.as_bytes())
    }

    /// Returns the message with the next commands.
    fn next_commands(&self) -> String {
        let file = self.file.display();
        let columns = self.kind.columns();
        format!(
            "done: {file}; next:\n  ancf check {file}\n  ancf run {file} -o out\n  ancf plot out {columns}"
        )
    }
}
