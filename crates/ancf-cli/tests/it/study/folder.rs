//! Folder with a model, its study and the results.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use tempfile::TempDir;

pub const MODEL: &str = r#"
    gravity = [0, -9.81, 0]
    materials.steel = { density = 8030, young = 193e9 }
    sections.rod = { kind = "circle", diameter = 0.02 }
    bodies = [
        { kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = "rod", material = "steel" },
    ]
    joints = [{ kind = "clamp", name = "root", a = { body = "beam", at = "start" } }]
    probes = [{ name = "tip", on = { body = "beam", at = "end" } }]
    output = { every = 3 }
    analysis = { kind = "dynamics", duration = 0.05, step = 1e-3, start = "zero" }
"#;

/// Row of a table.
pub type Row = BTreeMap<String, Field>;

pub fn float(row: &Row, name: &str) -> f64 {
    match row[name] {
        Field::Double(x) => x,
        Field::Long(n) => n as f64,
        ref other => panic!("{name}: {other:?}"),
    }
}

pub fn text(row: &Row, name: &str) -> String {
    match &row[name] {
        Field::Str(text) => text.clone(),
        Field::Null => String::new(),
        other => panic!("{name}: {other:?}"),
    }
}

pub fn table(path: &Path) -> Vec<Row> {
    let reader = SerializedFileReader::new(fs::File::open(path).unwrap()).unwrap();
    reader.get_row_iter(None).unwrap().map(|row| row.unwrap().into_columns().into_iter().collect()).collect()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Folder with a model, its study and the results.
pub struct StudyFolder(TempDir);

impl StudyFolder {
    pub fn new(study: &str) -> Self {
        let folder = Self(TempDir::new().unwrap());
        fs::write(folder.file("model.toml"), MODEL).unwrap();
        folder.state(study);
        folder
    }

    pub fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes the study file.
    pub fn state(&self, study: &str) {
        fs::write(self.file("study.toml"), format!("model = \"model.toml\"\n{study}")).unwrap();
    }

    pub fn command(&self, more: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
        command.arg("study").arg(self.file("study.toml")).arg("-o").arg(self.file("out")).args(more);
        command
    }

    /// Runs the study with an expected exit code, and returns standard error.
    pub fn run(&self, more: &[&str], code: i32) -> String {
        let output = self.command(more).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{}", stderr(&output));
        stderr(&output)
    }

    pub fn cases(&self) -> Vec<Row> {
        table(&self.file("out/cases.parquet"))
    }

    pub fn column(&self, name: &str) -> Vec<f64> {
        self.cases().iter().map(|row| float(row, name)).collect()
    }
}

pub const TIP: &str = "\n[objectives]\ntip = { column = \"tip.y\" }\n";
