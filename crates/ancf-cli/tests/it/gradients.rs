//! `ancf gradients`: table, file and JSON of derivatives, and errors.

use std::fs;

use serde_json::Value;

use crate::folder::TestFolder;
use crate::run_folder::{command, stderr};

const MODEL: &str = r#"
[materials.steel]
density = 7850.0
young = 2.1e11

[sections.rod]
kind = "circle"
diameter = 0.01

[[bodies]]
kind = "cable"
name = "rod"
from = [0, 0, 0]
to = [1, 0, 0]
elements = 4
section = "rod"
material = "steel"

[[joints]]
kind = "clamp"
name = "root"
a = { body = "rod", at = "start" }

[analysis]
kind = "modes"
count = 1
"#;

/// The frequency is proportional to √(E/ρ) and to d/L².
#[test]
fn derivatives_are_printed_and_written() {
    let folder = TestFolder::new();
    folder.write("model.toml", MODEL);
    let parameters =
        ["materials.steel.young", "materials.steel.density", "sections.rod.diameter", "bodies.rod.to[0]"];
    let mut arguments = vec!["gradients", "model.toml", "-o", "gradients.csv", "--json"];
    parameters.iter().for_each(|path| arguments.extend(["-p", path]));
    let output = folder.command(&arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    let value = json["values"][0].as_f64().unwrap();
    for (k, exponent) in [0.5, -0.5, 1.0, -2.0].into_iter().enumerate() {
        let derivative = json["derivatives"][0][k].as_f64().unwrap();
        let relative = derivative * json["parameter_values"][k].as_f64().unwrap() / value;
        assert!((relative - exponent).abs() < 1e-6, "{}: {relative}", parameters[k]);
    }
    let mut rows = csv::Reader::from_path(folder.path("gradients.csv")).unwrap();
    let rows: Vec<csv::StringRecord> = rows.records().collect::<Result<_, _>>().unwrap();
    assert_eq!(rows.len(), 4);
    assert_eq!([&rows[0][0], &rows[0][2]], ["frequency[0]", "materials.steel.young"]);
    let arguments = ["gradients", "model.toml", "-p", "materials.steel.young"];
    let output = folder.command(&arguments).output().unwrap();
    let table = String::from_utf8(output.stdout).unwrap();
    assert_eq!(table.lines().count(), 2, "{table}");
    assert!(table.contains("d/d materials.steel.young") && table.contains("frequency[0]"), "{table}");
}

/// Errors of parameters and sizes have exit code 2 and all messages at once.
#[test]
fn errors_of_parameters() {
    let folder = TestFolder::new();
    folder.write("model.toml", MODEL);
    let rejected = |arguments: &[&str]| {
        let output = folder.command(&[&["gradients", "model.toml"], arguments].concat()).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        stderr(&output)
    };
    let messages = rejected(&["-p", "materials.steel.youn", "-p", "bodies.rod.elements"]);
    assert!(
        messages.contains("materials.steel.youn") && messages.contains("did you mean `young`"),
        "{messages}"
    );
    assert!(messages.contains("the integer 4"), "{messages}");
    assert!(rejected(&["-p", "gravity[1]:-1"]).contains("expected a positive number"));
    assert!(rejected(&[]).contains("--parameter"));
    fs::remove_file(folder.path("model.toml")).unwrap();
    let output = command(&["gradients", "nowhere.toml", "-p", "gravity[1]"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}
