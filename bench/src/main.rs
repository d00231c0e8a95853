//! `ancf-bench`: program of `cargo xtask bench` and `cargo xtask instructions`.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use ancf_bench::Result;
use ancf_bench::instructions::{InstructionRecord, record_file, run_work};
use ancf_bench::measure::Machine;
use ancf_bench::table::{RowMeasurements, RowSpec, TableReport, process};
use clap::{Parser, Subcommand};

/// Measures the speed of ancf.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Print the table of costs with their targets.
    Table {
        /// Skip rows of 1e5 elements and more.
        #[arg(long)]
        quick: bool,
        /// Measure only rows whose names contain this text.
        #[arg(long, value_name = "TEXT", default_value = "")]
        rows: String,
        /// Write the table to a JSON file as well.
        #[arg(long, value_name = "FILE")]
        json: Option<PathBuf>,
    },
    /// Count the instructions of fixed work and compare them with the recorded counts.
    Instructions {
        /// Record the counts instead.
        #[arg(long)]
        update: bool,
    },
    /// Print the cost of steps of a beam; the table runs this in separate processes.
    #[command(hide = true)]
    Steps { elements: u32, steps: u32 },
    /// Print the cost of a run of ancf; the table runs this in separate processes.
    #[command(hide = true)]
    Program {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Run work a number of times under valgrind.
    #[command(hide = true)]
    Work { name: String, times: u32 },
}

fn main() -> ExitCode {
    let done = match Arguments::parse().task {
        Task::Table { quick, rows, json } => table(quick, &rows, json),
        Task::Instructions { update } => instructions(update),
        Task::Steps { elements, steps } => process::step_cost_here(elements, steps)
            .and_then(|cost| serde_json::to_string(&cost).map_err(|error| error.to_string()))
            .and_then(|text| print(&text)),
        Task::Program { arguments } => process::program_run_here(&arguments)
            .and_then(|cost| serde_json::to_string(&cost).map_err(|error| error.to_string()))
            .and_then(|text| print(&text)),
        Task::Work { name, times } => run_work(&name, times),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            say(&why);
            ExitCode::FAILURE
        }
    }
}

fn table(quick: bool, named: &str, json: Option<PathBuf>) -> Result<()> {
    let machine = Machine::this();
    let selected = |spec: &RowSpec| spec.name.contains(named) && !(quick && spec.large);
    let rows =
        RowMeasurements::new(machine.clone()).rows(selected, |name| say(&format!("measuring: {name}")));
    let report = TableReport { machine, rows };
    print(&report.text())?;
    let Some(path) = json else { return Ok(()) };
    let text = serde_json::to_string_pretty(&report).map_err(|error| error.to_string())? + "\n";
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
}

fn instructions(update: bool) -> Result<()> {
    let now = InstructionRecord::new(|name, count| say(&format!("{count:>14}  {name}")))?;
    if update {
        now.write()?;
        say(&format!("recorded in {}", record_file().display()));
        return Ok(());
    }
    let (messages, holds) = InstructionRecord::read()?.compare(&now);
    messages.iter().for_each(|message| say(message));
    if holds { Ok(()) } else { Err("instruction counts have grown beyond the tolerance".to_owned()) }
}

fn print(text: &str) -> Result<()> {
    writeln!(io::stdout(), "{}", text.trim_end()).map_err(|error| error.to_string())
}

fn say(text: &str) {
    // If standard error is closed, the message is lost.
    let _ = writeln!(io::stderr(), "{text}");
}
