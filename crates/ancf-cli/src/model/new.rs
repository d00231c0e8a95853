//! `ancf new`: a model to start from.

use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::{Args, ValueEnum};

use crate::command::{Ended, reject};
use crate::speech::{deliver, say};

/// What `ancf new` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The model file to write; `-` for standard output.
    file: PathBuf,
    /// What the model shows.
    #[arg(short, long, default_value = "cantilever")]
    kind: Kind,
    /// Write over a file that is there.
    #[arg(short, long)]
    force: bool,
}

pub const EXAMPLES: &str = "\
Examples:
  ancf new beam.toml                         a rod that swings, to be checked, run and changed
  ancf new --kind contact drop.toml          a rope that falls on the ground
  ancf new --kind modes - | less             to look at it only";

/// Models to start from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// A motion: a clamped rod that swings under its weight.
    Cantilever,
    /// An equilibrium: a cord that hangs between two hooks.
    Cable,
    /// A motion: a double pendulum of a flexible rod and a rigid body.
    Pendulum,
    /// A motion: a driven crank, a rod that bends and a sliding block.
    Mechanism,
    /// A motion: a rope that falls on the ground, with friction.
    Contact,
    /// An equilibrium: a wire bent far by a force.
    Statics,
    /// A path of equilibria through snap-through: a shallow arch.
    Path,
    /// Natural frequencies and shapes of a blade.
    Modes,
    /// Critical loads of a column.
    Buckling,
}

impl Kind {
    const fn text(self) -> &'static str {
        match self {
            Self::Cantilever => include_str!("../templates/cantilever.toml"),
            Self::Cable => include_str!("../templates/cable.toml"),
            Self::Pendulum => include_str!("../templates/pendulum.toml"),
            Self::Mechanism => include_str!("../templates/mechanism.toml"),
            Self::Contact => include_str!("../templates/contact.toml"),
            Self::Statics => include_str!("../templates/statics.toml"),
            Self::Path => include_str!("../templates/path.toml"),
            Self::Modes => include_str!("../templates/modes.toml"),
            Self::Buckling => include_str!("../templates/buckling.toml"),
        }
    }

    /// Columns that are worth a look.
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

impl Arguments {
    /// Writes the model.
    pub fn run(&self) -> Result<Ended> {
        let text = self.kind.text();
        if self.file == Path::new("-") {
            deliver(text);
            return Ok(Ended::Done);
        }
        match self.write(text) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                let hint = "--force writes over it";
                return Ok(reject(&format!("{} is there already; {hint}", self.file.display())));
            }
            written => written.with_context(|| format!("cannot write {}", self.file.display()))?,
        }
        say(&self.next());
        Ok(Ended::Done)
    }

    fn write(&self, text: &str) -> io::Result<()> {
        let mut file = match self.force {
            true => File::create(&self.file)?,
            false => File::create_new(&self.file)?,
        };
        file.write_all(text.as_bytes())
    }

    /// What to do with the model.
    fn next(&self) -> String {
        let file = self.file.display();
        let columns = self.kind.columns();
        format!(
            "done: {file}; next:\n  ancf check {file}\n  ancf run {file} -o out\n  ancf plot out {columns}"
        )
    }
}
