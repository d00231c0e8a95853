//! Help, templates, errors of a model.

use std::fs::File;

use serde_json::Value;

use super::trial::{Trial, expect, finish_with};
use crate::system::shell::Done;

/// Templates of `ancf new`. Their runs are compared with those of the reference.
pub(super) const TEMPLATES: [&str; 9] =
    ["cantilever", "cable", "pendulum", "mechanism", "contact", "statics", "path", "modes", "buckling"];
/// Commands with a help.
const COMMANDS: [&str; 16] = [
    "new",
    "check",
    "run",
    "resume",
    "report",
    "view",
    "plot",
    "paraview",
    "study",
    "fmu",
    "scaled",
    "schema",
    "paper",
    "verify",
    "completions",
    "man",
];

pub(super) fn version(trial: &Trial<'_>) -> Done {
    let printed = trial.done(&["--version"])?.stdout;
    expect(printed == format!("ancf {}\n", env!("CARGO_PKG_VERSION")), "the version", printed)
}

pub(super) fn help(trial: &Trial<'_>) -> Done {
    let mut all = trial.done(&["--help"])?.stdout;
    for command in COMMANDS {
        let text = trial.done(&[command, "--help"])?.stdout;
        expect(
            text.contains(&format!("Usage: ancf {command}")) || text.contains("Usage: ancf"),
            "usage",
            &text,
        )?;
        all += &text;
    }
    trial.write("help.txt", all)
}

pub(super) fn invalid_arguments(trial: &Trial<'_>) -> Done {
    let ended = trial.ends(2, &["run", "--nonsense"])?;
    expect(ended.stderr.contains("--nonsense"), "the argument", ended)
}

pub(super) fn templates(trial: &Trial<'_>) -> Done {
    for kind in TEMPLATES {
        let file = format!("{kind}.toml");
        trial.done(&["new", &file, "--kind", kind])?;
        trial.shorten(&file)?;
        trial.done(&["check", &file])?;
        trial.done(&["run", &file, "-o", kind])?;
    }
    // Lines of all files end as in the repository, on all systems.
    let template = trial.text("cantilever.toml")?;
    expect(!template.contains('\r'), "no carriage return", template)
}

pub(super) fn model_errors(trial: &Trial<'_>) -> Done {
    let model = trial.text("cantilever.toml")?;
    trial.write("falsch für alle.toml", model.replacen("young", "yuong", 1))?;
    let ended = trial.ends(2, &["check", "falsch für alle.toml"])?;
    let line = 1 + model.lines().position(|line| line.contains("young")).unwrap_or_default();
    let place = format!("falsch für alle.toml:{line}:");
    expect(ended.stderr.contains(&place) && ended.stderr.contains("yuong"), &place, &ended)
}

pub(super) fn json_errors(trial: &Trial<'_>) -> Done {
    let ended = trial.ends(2, &["check", "falsch für alle.toml", "--json"])?;
    let parsed: Result<Value, _> = serde_json::from_str(&ended.stdout);
    expect(parsed.is_ok_and(|errors| errors.to_string().contains("yuong")), "JSON with the key", ended)
}

pub(super) fn standard_input(trial: &Trial<'_>) -> Done {
    let model = File::open(trial.path("cantilever.toml")).map_err(|error| error.to_string())?;
    let ended = finish_with(trial.program.command(&trial.folder, &["check", "-"]), model.into())?;
    expect(ended.code == Some(0), "success", ended)
}
