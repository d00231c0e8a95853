//! Subcommands of the program.

use anyhow::Result;
use clap::Subcommand;

use crate::model::{
    CHECK_EXAMPLES, CheckArguments, FMU_EXAMPLES, FmuArguments, NEW_EXAMPLES, NewArguments, SCALED_EXAMPLES,
    SCHEMA_EXAMPLES, ScaledArguments, print_schema,
};
use crate::plot::{PLOT_EXAMPLES, PlotArguments};
use crate::reproduce::{PAPER_EXAMPLES, PaperArguments, VERIFY_EXAMPLES, VerifyArguments};
use crate::results::{
    PARAVIEW_EXAMPLES, ParaviewArguments, REPORT_EXAMPLES, ReportArguments, VIEW_EXAMPLES, ViewArguments,
};
use crate::shell::{COMPLETIONS_EXAMPLES, CompletionsArguments, MAN_EXAMPLES, ManArguments};
use crate::simulation::{
    GRADIENTS_EXAMPLES, GradientsArguments, RESUME_EXAMPLES, RUN_EXAMPLES, ResumeArguments, RunArguments,
    STUDY_EXAMPLES, StudyArguments,
};
use crate::terminal::Ended;

/// Subcommand.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Write a commented model to start from. It runs without changes.
    #[command(after_help = NEW_EXAMPLES)]
    New(NewArguments),
    /// Check a model file: report all errors, or bodies, joints, redundant constraints and degrees of freedom.
    #[command(after_help = CHECK_EXAMPLES)]
    Check(CheckArguments),
    /// Run a model file and write its results: motion, equilibrium, equilibrium path, modes or critical loads.
    #[command(after_help = RUN_EXAMPLES)]
    Run(RunArguments),
    /// Resume a run that was stopped, failed or killed, from its last checkpoint.
    #[command(after_help = RESUME_EXAMPLES)]
    Resume(ResumeArguments),
    /// Write the results of a run as one HTML file: 3D animation, charts, summary.
    #[command(after_help = REPORT_EXAMPLES)]
    Report(ReportArguments),
    /// Show the results of a run in a browser, live while it runs.
    #[command(after_help = VIEW_EXAMPLES)]
    View(ViewArguments),
    /// Plot columns of a run in the terminal, or into an SVG, PNG or PDF file, also while it runs.
    #[command(after_help = PLOT_EXAMPLES)]
    Plot(PlotArguments),
    /// Write the results of a run as files for ParaView and PyVista.
    #[command(after_help = PARAVIEW_EXAMPLES)]
    Paraview(ParaviewArguments),
    /// Run a model in many cases, with parameters from lists, ranges and distributions, into a table.
    #[command(after_help = STUDY_EXAMPLES)]
    Study(StudyArguments),
    /// Differentiate equilibria, frequencies or critical loads with respect to numbers of the model.
    #[command(after_help = GRADIENTS_EXAMPLES)]
    Gradients(GradientsArguments),
    /// Write the model as a co-simulation FMU (FMI 2.0 or 3.0), for other simulation programs.
    #[command(after_help = FMU_EXAMPLES)]
    Fmu(FmuArguments),
    /// Print the model in the units in which its equations are solved.
    #[command(after_help = SCALED_EXAMPLES)]
    Scaled(ScaledArguments),
    /// Print the JSON Schema of model files, for editors.
    #[command(after_help = SCHEMA_EXAMPLES)]
    Schema,
    /// Reproduce every table and figure of Kim et al. (2017).
    #[command(after_help = PAPER_EXAMPLES)]
    Paper(PaperArguments),
    /// Solve problems with known answers and compare the results with the references.
    #[command(after_help = VERIFY_EXAMPLES)]
    Verify(VerifyArguments),
    /// Print the script that completes commands and options in a shell.
    #[command(after_help = COMPLETIONS_EXAMPLES)]
    Completions(CompletionsArguments),
    /// Write the manual pages: ancf.1 and one page per command.
    #[command(after_help = MAN_EXAMPLES)]
    Man(ManArguments),
}

impl Command {
    /// True if the output is JSON.
    pub const fn is_json(&self) -> bool {
        match self {
            Self::Check(arguments) => arguments.json,
            Self::Verify(arguments) => arguments.json,
            Self::Run(arguments) => arguments.json,
            Self::Resume(arguments) => arguments.json,
            Self::Study(arguments) => arguments.json,
            Self::Gradients(arguments) => arguments.json,
            Self::Plot(arguments) => arguments.json,
            _ => false,
        }
    }

    /// Runs the command. `program` is the description of the program, for its manual.
    pub fn run(self, program: &clap::Command) -> Result<Ended> {
        match self {
            Self::New(arguments) => arguments.run(),
            Self::Check(arguments) => Ok(arguments.run()),
            Self::Fmu(arguments) => arguments.run(),
            Self::Scaled(arguments) => arguments.run(),
            Self::Run(arguments) => arguments.run(),
            Self::Resume(arguments) => arguments.run(),
            Self::Report(arguments) => arguments.run(),
            Self::View(arguments) => arguments.run(),
            Self::Plot(arguments) => arguments.run(),
            Self::Paraview(arguments) => arguments.run(),
            Self::Study(arguments) => arguments.run(),
            Self::Gradients(arguments) => arguments.run(),
            Self::Schema => Ok(print_schema()),
            Self::Paper(arguments) => arguments.run(),
            Self::Verify(arguments) => arguments.run(),
            Self::Completions(arguments) => Ok(arguments.run(program)),
            Self::Man(arguments) => arguments.run(program),
        }
    }
}
