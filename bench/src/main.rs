//! `ancf-bench`: measures; see `cargo xtask bench` and `cargo xtask instructions`.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use ancf_bench::instructions::{Record, file};
use ancf_bench::machine::Machine;
use ancf_bench::measure::Result;
use ancf_bench::report::Report;
use ancf_bench::row::Asked;
use ancf_bench::table::Bench;
use ancf_bench::{counts, process};
use clap::{Parser, Subcommand};

/// Measures the speed of ancf.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(Subcommand)]
enum Chore {
    /// Print the table of times beside their goals.
    Table {
        /// Leave out the rows of 1e5 elements and more.
        #[arg(long)]
        quick: bool,
        /// Measure those rows only whose names have this in them.
        #[arg(long, value_name = "TEXT", default_value = "")]
        rows: String,
        /// Write the table to a file, too.
        #[arg(long, value_name = "FILE")]
        json: Option<PathBuf>,
    },
    /// Count the instructions of fixed work and compare with those on record.
    Instructions {
        /// Put them on record instead.
        #[arg(long)]
        update: bool,
    },
    /// Step a beam and print what it took: what the table starts as processes of their own.
    #[command(hide = true)]
    Steps { elements: u32, steps: u32 },
    /// Do work so many times: what valgrind runs.
    #[command(hide = true)]
    Work { name: String, times: u32 },
}

fn main() -> ExitCode {
    let done = match Arguments::parse().chore {
        Chore::Table { quick, rows, json } => table(quick, &rows, json),
        Chore::Instructions { update } => instructions(update),
        Chore::Steps { elements, steps } => process::step_here(elements, steps)
            .and_then(|stepped| serde_json::to_string(&stepped).map_err(|error| error.to_string()))
            .and_then(|text| print(&text)),
        Chore::Work { name, times } => counts::work(&name, times),
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
    let wanted = |asked: &Asked| asked.name.contains(named) && !(quick && asked.large);
    let rows = Bench::new(machine.clone()).rows(wanted, |name| say(&format!("measuring: {name}")));
    let report = Report { machine, rows };
    print(&report.text())?;
    let Some(path) = json else { return Ok(()) };
    let text = serde_json::to_string_pretty(&report).map_err(|error| error.to_string())? + "\n";
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
}

fn instructions(update: bool) -> Result<()> {
    let now = Record::new(|name, count| say(&format!("{count:>14}  {name}")))?;
    if update {
        now.write()?;
        say(&format!("on record in {}", file().display()));
        return Ok(());
    }
    let (words, holds) = Record::read()?.compare(&now);
    words.iter().for_each(|word| say(word));
    if holds { Ok(()) } else { Err("there is more work than on record".to_owned()) }
}

fn print(text: &str) -> Result<()> {
    writeln!(io::stdout(), "{}", text.trim_end()).map_err(|error| error.to_string())
}

fn say(text: &str) {
    // Nothing is left to be done if standard error is closed.
    let _ = writeln!(io::stderr(), "{text}");
}
