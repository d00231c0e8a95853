//! `ancf`: checks and runs model files, plots and reports results, solves verification problems, reproduces the paper.
//!
//! ```text
//! main -> command -> model  simulation  results  plot  reproduce  shell
//!                        \      |          |      |      |       /
//!                                      terminal
//! ```

mod command;
mod model;
mod plot;
mod reproduce;
mod results;
mod shell;
mod simulation;
mod terminal;

use std::env;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, FromArgMatches, Parser};

use command::Command;
use terminal::{Colour, Ended, JsonErrors, OutputMode};

/// Flexible multibody dynamics on the absolute nodal coordinate formulation.
#[derive(Debug, Parser)]
// Without `bin_name`, help on Windows has the name `ancf.exe`.
#[command(name = "ancf", bin_name = "ancf", version, after_help = TOUR)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Print only warnings and errors on standard error.
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Colours: on terminals, always or never.
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto")]
    color: Colour,
}

const TOUR: &str = "\
A first tour:
  ancf new beam.toml              write a commented model to start from
  ancf check beam.toml            report errors in the model, or its content
  ancf run beam.toml -o out       write results into the folder `out`
  ancf plot out tip.y             plot a column in the terminal
  ancf report out                 write a 3D animation and charts for the browser
  ancf COMMAND --help             options and examples of a command

Exit codes: 0 done, 1 the analysis or a verification failed or output could not be written,
2 bad input, 130 stopped by Ctrl-C, 143 stopped by SIGTERM.";

fn main() -> ExitCode {
    let colours = Colour::requested(env::args_os()).apply();
    let parsed = Arguments::command().color(colours).try_get_matches();
    let parsed = parsed.and_then(|matches| Arguments::from_arg_matches(&matches));
    let ended = match parsed {
        Ok(Arguments { command, quiet, .. }) => {
            terminal::set_output_mode(OutputMode { quiet, json: command.is_json() });
            command.run(&Arguments::command())
        }
        Err(error) => Ok(reject_arguments(&error)),
    };
    let code = match ended {
        Ok(Ended::Done) => 0,
        Ok(Ended::Failed) => 1,
        Ok(Ended::BadInput) => 2,
        // 128 plus the number of the signal, as in shells.
        Ok(Ended::Stopped) => match terminal::is_terminated() {
            true => 143,
            false => 130,
        },
        Err(error) => {
            terminal::print_error(&format!("error: {error:#}"));
            terminal::print_json(&JsonErrors::from_message(format!("{error:#}")));
            1
        }
    };
    match terminal::check_output() {
        Ok(()) => ExitCode::from(code),
        Err(error) => {
            terminal::print_error(&format!("error: {error}"));
            ExitCode::from(1)
        }
    }
}

/// Prints help, the version, or the error of invalid arguments.
fn reject_arguments(error: &clap::Error) -> Ended {
    let text = error.render();
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            terminal::print_output(&text.ansi().to_string());
            Ended::Done
        }
        _ => {
            let _ = error.print();
            let json = env::args_os().any(|argument| argument == "--json");
            terminal::set_output_mode(OutputMode { quiet: false, json });
            let text = text.to_string();
            let first = text.lines().take_while(|line| !line.is_empty()).map(str::trim).collect::<Vec<_>>();
            let message = first.join(" ");
            terminal::print_json(&JsonErrors::from_message(message.trim_start_matches("error: ")));
            Ended::BadInput
        }
    }
}
