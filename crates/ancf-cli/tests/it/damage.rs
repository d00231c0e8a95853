//! Damaged files of a run: commands end with an error that names the file.

use std::fs;

use crate::folder::TestFolder;

/// Commands that read the folder of a run.
const COMMANDS: [&[&str]; 4] =
    [&["plot", "out", "--json"], &["report", "out"], &["paraview", "out"], &["resume", "out"]];

/// Asserts that commands reject a run with one changed bit of a file, at some places of the file.
fn assert_rejected(folder: &TestFolder, file: &str, commands: &[&[&str]]) {
    let path = folder.path(&format!("out/{file}"));
    let bytes = fs::read(&path).unwrap();
    for (command, part) in commands.iter().zip([3, 5, 7, 9]) {
        let mut damaged = bytes.clone();
        damaged[bytes.len() * 2 / part] ^= 0x40;
        fs::write(&path, damaged).unwrap();
        let output = folder.ancf(command);
        assert_eq!(output.code, Some(1), "{command:?}, {file}: {}", output.messages);
        assert!(output.messages.contains(file), "{command:?}, {file}: {}", output.messages);
    }
    fs::write(&path, bytes).unwrap();
}

#[test]
fn damaged_files_are_named() {
    let folder = TestFolder::with_run("cable");
    for file in ["results.parquet", "states.parquet", "summary.json", "model.toml"] {
        assert_rejected(&folder, file, &COMMANDS);
    }
    COMMANDS.iter().for_each(|command| drop(folder.printed(command)));
}

/// Edits of the model of a run are rejected as well: the results are not those of the text.
#[test]
fn an_edited_model_is_named() {
    let folder = TestFolder::with_run("cable");
    let text = folder.read("out/model.toml");
    folder.write("out/model.toml", &format!("# a comment\n{text}"));
    let output = folder.ancf(&["plot", "out", "--json"]);
    assert_eq!(output.code, Some(1), "{}", output.messages);
    assert!(output.messages.contains("it is not the model of this run"), "{}", output.messages);
    folder.write("out/model.toml", &text);
    folder.printed(&["plot", "out", "--json"]);
}
