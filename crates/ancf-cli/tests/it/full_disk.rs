//! Full disk, simulated by a limit on the file size.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use ancf_results::Results;
use tempfile::TempDir;

/// Runs the cantilever with files of at most `blocks` times 512 bytes.
fn run(blocks: u32, folder: &Path) -> Output {
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\"");
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/cantilever.toml");
    let program = ["sh", env!("CARGO_BIN_EXE_ancf"), "run"];
    Command::new("sh")
        .args(["-c", &script])
        .args(program)
        .arg(model)
        .arg("-o")
        .arg(folder)
        .args(["--checkpoint", "500"])
        .output()
        .unwrap()
}

/// Returns all files below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

#[test]
fn results_so_far_are_preserved_and_the_file_is_named() {
    // Limits after the first rows, the first states, the first checkpoint.
    for blocks in [40, 200, 600] {
        let place = TempDir::new().unwrap();
        let folder = place.path().join("out");
        let ended = run(blocks, &folder);
        let messages = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert_eq!(ended.status.code(), Some(1), "{messages}");
        assert_eq!(messages.lines().count(), 1, "one line: {messages}");
        assert!(
            messages.starts_with("error: ") && messages.contains("probes.csv: File too large"),
            "{messages}"
        );
        let unfinished: Vec<_> =
            files(&folder).into_iter().filter(|path| path.to_string_lossy().ends_with(".part")).collect();
        assert!(unfinished.is_empty(), "{unfinished:?}");
        assert_rows(&folder);
        // Without the limit the run is resumed or starts from the beginning.
        let resumed = Command::new(env!("CARGO_BIN_EXE_ancf")).arg("resume").arg(&folder).output().unwrap();
        assert_eq!(resumed.status.code(), Some(0), "{}", String::from_utf8_lossy(&resumed.stderr));
        let rows = Results::open(&folder).unwrap().columns().unwrap();
        assert_eq!(rows.column("t").unwrap().len(), 2001);
        assert_eq!(fs::read_to_string(folder.join("probes.csv")).unwrap().lines().count(), 2002);
    }
}

/// Asserts that the rows of the table and of the text are those of the first instants.
fn assert_rows(folder: &Path) {
    let rows = Results::open(folder).unwrap().columns().unwrap();
    let t = rows.column("t").unwrap();
    assert!(!t.is_empty() && t.iter().enumerate().all(|(k, t)| (t - 1e-3 * k as f64).abs() < 1e-9), "{t:?}");
    let text = fs::read_to_string(folder.join("probes.csv")).unwrap();
    // The last line may be incomplete.
    let lines: Vec<&str> = text.lines().collect();
    let width = lines[0].split(',').count();
    for (k, line) in lines[1..lines.len() - 1].iter().enumerate() {
        let numbers: Vec<f64> = line.split(',').map(|number| number.parse().unwrap()).collect();
        assert!(numbers.len() == width && (numbers[0] - 1e-3 * k as f64).abs() < 1e-9, "{line}");
    }
    assert!(lines.len() > 2, "{text}");
}

/// Without space for the model there is no run.
#[test]
fn a_full_disk_is_reported() {
    let place = TempDir::new().unwrap();
    let ended = run(0, &place.path().join("out"));
    let messages = String::from_utf8_lossy(&ended.stderr);
    assert_eq!(ended.status.code(), Some(1), "{messages}");
    assert!(
        messages.starts_with("error: results could not be written: ") && messages.contains("model.toml: "),
        "{messages}"
    );
}
