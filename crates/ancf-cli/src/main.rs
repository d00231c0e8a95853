//! `ancf`: checks and runs model files, verifies itself, and reproduces the paper.

mod check;
mod colour;
mod command;
mod conclusion;
mod fault;
mod figure;
mod guide;
mod new;
mod paper;
mod paraview;
mod past;
mod plot;
mod progress;
mod report;
mod run;
mod signal;
mod speech;
mod study;
mod verify;
mod view;

use std::env;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches, Parser};

use colour::Colour;
use command::{Command, Ended};
use fault::Faults;
use speech::Manners;

/// Flexible multibody dynamics on the absolute nodal coordinate formulation.
#[derive(Debug, Parser)]
#[command(name = "ancf", version, after_help = TOUR)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Say nothing on standard error but what went wrong.
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Colours: on terminals, everywhere or nowhere.
    #[arg(long, global = true, value_name = "WHERE", default_value = "auto")]
    color: Colour,
}

const TOUR: &str = "\
A first tour:
  ancf new beam.toml              a model to start from, with comments
  ancf check beam.toml            what is wrong with it, or what it consists of
  ancf run beam.toml -o out       into tables, in the folder `out`
  ancf plot out tip.y             a column of it, in the terminal
  ancf report out                 all of it, in space and in charts, for the browser
  ancf COMMAND --help             more of each, with examples

Exit codes: 0 done, 1 the analysis or a verification failed or results could not be written,
2 bad input, 130 stopped by Ctrl-C, 143 stopped by SIGTERM.";

fn main() -> ExitCode {
    let colours = Colour::asked(env::args_os()).establish();
    let parsed = Arguments::command().color(colours).try_get_matches();
    let parsed = parsed.and_then(|matches| Arguments::from_arg_matches(&matches));
    let ended = match parsed {
        Ok(Arguments { command, quiet, .. }) => {
            speech::choose(Manners { quiet, json: command.wants_json() });
            command.run()
        }
        Err(error) => Ok(misunderstood(&error)),
    };
    match ended {
        Ok(Ended::Done) => ExitCode::SUCCESS,
        Ok(Ended::Failed) => ExitCode::from(1),
        Ok(Ended::BadInput) => ExitCode::from(2),
        // By the number of the signal, as shells have it.
        Ok(Ended::Stopped) => ExitCode::from(if signal::is_terminated() { 143 } else { 130 }),
        Err(error) => {
            speech::complain(&format!("error: {error:#}"));
            speech::answer(&Faults::other(format!("{error:#}")));
            ExitCode::from(1)
        }
    }
}

/// Help, the version, or arguments that make no command.
fn misunderstood(error: &clap::Error) -> Ended {
    let _ = error.print();
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => Ended::Done,
        _ => {
            speech::choose(Manners {
                quiet: false,
                json: env::args_os().any(|argument| argument == "--json"),
            });
            let text = error.render().to_string();
            let first = text.lines().take_while(|line| !line.is_empty()).map(str::trim).collect::<Vec<_>>();
            speech::answer(&Faults::other(first.join(" ").trim_start_matches("error: ")));
            Ended::BadInput
        }
    }
}
