//! FMUs: files and exit codes. `cargo xtask fmi` runs them in importers.

use std::fs;

use crate::run_folder::{command, stderr};

const MODEL: &str = "models/revolute_pendulum.toml";

#[test]
fn an_fmu_is_written_for_each_version() {
    let folder = tempfile::tempdir().unwrap();
    for (version, platform) in [("2", "linux64"), ("3", "-linux")] {
        let file = folder.path().join("model.fmu");
        let path = file.to_str().unwrap();
        let done = command(&["fmu", MODEL, "-o", path, "--version", version]).output().unwrap();
        assert_eq!(done.status.code(), Some(0), "{}", stderr(&done));
        assert!(stderr(&done).contains("0 inputs, 0 parameters, "), "{}", stderr(&done));
        let bytes = fs::read(&file).unwrap();
        let contains = |text: &str| bytes.windows(text.len()).any(|window| window == text.as_bytes());
        for name in ["modelDescription.xml", "resources/model.toml", "resources/interface.toml"] {
            assert!(contains(name), "{name}");
        }
        assert!(contains(platform) || !cfg!(target_os = "linux"), "{platform}");
    }
}

#[test]
fn invalid_arguments_are_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("model.fmu");
    let path = file.to_str().unwrap();
    for (arguments, text) in [
        (&["no/such.toml"][..], "no such file"),
        (&["models/elastica.toml"], "analysis.kind"),
        (&[MODEL, "-p", "bodies.none.mass"], "no `none`"),
        (&[MODEL, "-p", "gravity[1]=fast"], "expected a number"),
        (&[MODEL, "--library", "Cargo.toml"], "expected the shared library of the crate ancf-fmu"),
        (&[MODEL, "--version", "1"], "possible values: 2, 3"),
    ] {
        let done = command(&[&["fmu", "-o", path], arguments].concat()).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{arguments:?}: {}", stderr(&done));
        assert!(stderr(&done).contains(text), "{arguments:?}: {}", stderr(&done));
        assert!(!file.exists());
    }
}
