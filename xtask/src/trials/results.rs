//! Commands that use results, studies and models of other programs.

use serde_json::Value;

use super::trial::{Trial, expect};
use crate::system::shell::Done;

const STUDY: &str = r#"
model = "modes.toml"
parameters = { "bodies.blade.elements" = [4, 5, 6] }
objectives = { first = { column = "frequency", take = "min" } }
"#;

pub(super) fn refinement(trial: &Trial<'_>) -> Done {
    let ended = trial.done(&["run", "statics.toml", "-o", "fein", "--to", "0.1%"])?;
    expect(trial.text("fein/summary.json")?.contains("meshes"), "the meshes", ended)?;
    trial.cantilever("kurz.toml", 0.1)?;
    trial.done(&["run", "kurz.toml", "-o", "Fehler", "--errors"])?;
    let header = trial.text("Fehler/probes.csv")?;
    expect(
        header.lines().next().is_some_and(|line| line.contains("error")),
        "columns of errors",
        header.lines().next(),
    )
}

pub(super) fn report(trial: &Trial<'_>) -> Done {
    for run in ["pendulum", "modes", "Ergebnis für Träger 数"] {
        trial.done(&["report", run])?;
        let page = trial.text(&format!("{run}/report.html"))?;
        expect(page.contains("</html>") && page.len() > 100_000, "a page", page.len())?;
        expect(!page.contains("\r\n"), "lines that end with LF", run)?;
    }
    Ok(())
}

pub(super) fn paraview(trial: &Trial<'_>) -> Done {
    trial.done(&["paraview", "cantilever", "-o", "Bilder für ParaView"])?;
    let files = std::fs::read_dir(trial.path("Bilder für ParaView")).map_err(|error| error.to_string())?;
    let names: Vec<_> = files.flatten().map(|file| file.file_name().to_string_lossy().into_owned()).collect();
    let has = |ending: &str| names.iter().any(|name| name.ends_with(ending));
    // References in collections are URLs: separators of Windows are invalid there.
    let collection = names.iter().find(|name| name.ends_with(".pvd")).cloned().unwrap_or_default();
    let text = trial.text(&format!("Bilder für ParaView/{collection}"))?;
    expect(has(".pvd") && text.contains("file=\"") && !text.contains('\\'), "a collection of files", text)
}

pub(super) fn study(trial: &Trial<'_>) -> Done {
    trial.write("Studie.toml", STUDY)?;
    trial.done(&["study", "Studie.toml", "-o", "Fälle"])?;
    // A repeated study reuses its table, which it replaces.
    trial.done(&["study", "Studie.toml", "-o", "Fälle"])?;
    trial.done(&["report", "Fälle"])?;
    trial.done(&["plot", "Fälle", "first"]).map(|_| ())
}

pub(super) fn scaled(trial: &Trial<'_>) -> Done {
    let printed = trial.done(&["scaled", "cantilever.toml"])?.stdout;
    trial.write("skaliert.toml", printed)?;
    trial.done(&["check", "skaliert.toml"]).map(|_| ())
}

pub(super) fn schema(trial: &Trial<'_>) -> Done {
    let printed = trial.done(&["schema"])?.stdout;
    let parsed: Result<Value, _> = serde_json::from_str(&printed);
    expect(parsed.is_ok_and(|schema| schema["properties"]["bodies"].is_object()), "a schema", printed.len())?;
    trial.write("schema.json", printed)
}

pub(super) fn verify(trial: &Trial<'_>) -> Done {
    let printed = trial.done(&["verify", "elastica", "-o", "geprüft"])?.stdout;
    expect(printed.contains("passed") && !printed.contains("FAILED"), "a solved problem", printed)
}

/// The FMU contains the library of the package, and its absence is explained.
pub(super) fn fmu(trial: &Trial<'_>) -> Done {
    trial.done(&["fmu", "pendulum.toml", "-o", "Pendel ä.fmu"])?;
    let bytes = trial.read("Pendel ä.fmu")?;
    let contains = |text: &str| bytes.windows(text.len()).any(|window| window == text.as_bytes());
    let binary = if trial.program.is_windows() { "x86_64-windows" } else { "-linux" };
    expect(contains("modelDescription.xml") && contains(binary), "description and library", bytes.len())?;
    let ended = trial.ends(2, &["fmu", "pendulum.toml", "--library", "fehlt.so"])?;
    expect(ended.stderr.contains("fehlt.so"), "the missing library", ended)
}
