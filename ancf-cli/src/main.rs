//! `ancf`: checks and runs model files, verifies itself, and reproduces the paper.

mod check;
mod command;
mod conclusion;
mod figure;
mod paper;
mod paraview;
mod progress;
mod report;
mod run;
mod study;
mod verify;
mod view;

use std::process::ExitCode;

use clap::Parser;

use command::{Command, Ended};

/// Flexible multibody dynamics on the absolute nodal coordinate formulation.
#[derive(Parser)]
#[command(
    version,
    after_help = "Exit codes: 0 done, 1 the analysis or a verification failed, 2 bad input, 130 stopped by Ctrl-C."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    match Arguments::parse().command.run() {
        Ok(Ended::Done) => ExitCode::SUCCESS,
        Ok(Ended::Failed) => ExitCode::from(1),
        Ok(Ended::BadInput) => ExitCode::from(2),
        Ok(Ended::Stopped) => ExitCode::from(130),
        Err(error) => {
            progress::say(&format!("error: {error:#}"));
            ExitCode::from(1)
        }
    }
}
