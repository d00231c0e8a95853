use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use super::program::Program;
use super::trial::Trial;
use super::{comparison, files, first_steps, interruption, output, results, view};
use crate::system::shell::{Done, say};

/// Name of the folder of a trial.
const FOLDER: &str = "Prüfung der Träger, Größe 1 м";

type Test = fn(&Trial<'_>) -> Done;

/// Trials in the order in which they run: later ones use results of earlier ones.
const TRIALS: [(&str, Test); 34] = [
    ("version", first_steps::version),
    ("help of all commands", first_steps::help),
    ("invalid arguments", first_steps::invalid_arguments),
    ("templates: new, check, run", first_steps::templates),
    ("errors of a model with line and column", first_steps::model_errors),
    ("errors as JSON", first_steps::json_errors),
    ("model from standard input", first_steps::standard_input),
    ("lines that end with CR LF, byte order mark", files::line_ends),
    ("path without -o", files::default_folder),
    ("absolute path", files::absolute_path),
    ("separators of folders", files::separators),
    ("long path", files::long_path),
    ("umlauts and spaces in names", files::names),
    ("read-only folder", files::read_only),
    ("missing file", files::missing),
    ("file replaced while it is open", files::replaced_while_open),
    ("folder in use", interruption::folder_in_use),
    ("kill and resume", interruption::kill_and_resume),
    ("Ctrl-C and resume", interruption::ctrl_c),
    ("estimated errors and refinement", results::refinement),
    ("report", results::report),
    ("view with requests", view::view),
    ("plot in the terminal", output::plot),
    ("plot into SVG, PNG and PDF", output::plot_files),
    ("colours", output::colours),
    ("Unicode", output::unicode),
    ("paraview", results::paraview),
    ("study, its report and plot", results::study),
    ("scaled model", results::scaled),
    ("schema", results::schema),
    ("verify", results::verify),
    ("completions", output::completions),
    ("manual pages", output::man),
    ("FMU", results::fmu),
];

/// Tries a program and compares its results with those of another program, the reference, in a folder of an earlier trial.
/// Returns the folder.
pub(crate) fn run(
    what: &str,
    program: &Program,
    place: &Path,
    reference: Option<&Path>,
) -> Result<PathBuf, String> {
    let folder = place.join(FOLDER);
    if folder.exists() {
        files::unlock(&folder);
        fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    fs::create_dir_all(&program.home).map_err(|error| format!("{}: {error}", program.home.display()))?;
    say(&format!("\n== trial of {what}"));
    let trial = Trial { program, folder: folder.clone() };
    let start = Instant::now();
    let mut failed = Vec::new();
    for (name, test) in TRIALS {
        let start = Instant::now();
        let result = test(&trial);
        let state = if result.is_ok() { "passed" } else { "FAILED" };
        say(&format!("{state} {:6.1} s  {name}", start.elapsed().as_secs_f64()));
        failed.extend(result.err().map(|why| format!("{name}: {why}")));
    }
    if let Some(reference) = reference {
        let compared = comparison::compare(&folder, reference);
        let state = if compared.is_ok() { "passed" } else { "FAILED" };
        say(&format!("{state}           results equal those of this system"));
        failed.extend(compared.err());
    }
    say(&format!("{} trials of {what} in {:.0} s", TRIALS.len(), start.elapsed().as_secs_f64()));
    match failed.is_empty() {
        true => Ok(folder),
        false => Err(format!("{what}: {} trials failed\n\n{}", failed.len(), failed.join("\n\n"))),
    }
}
