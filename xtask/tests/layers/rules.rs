//! Rules on folders, sizes and directions.

use super::workspace::Workspace;

fn layered(name: &str) -> Workspace {
    Workspace::rust(name, &[".", "upper", "lower"])
        .file("house/src/lib.rs", "mod lower;\nmod upper;")
        .file("house/src/upper/mod.rs", "mod roof;\npub use roof::Roof;")
        .file("house/src/upper/roof.rs", "pub struct Roof;")
        .file("house/src/lower/mod.rs", "mod wall;")
        .file("house/src/lower/wall.rs", "")
}

#[test]
fn imports_point_downwards() {
    layered("downwards").passes();
    layered("upwards")
        .file("house/src/lower/wall.rs", "fn f() {}\nuse crate::upper::Roof;")
        .fails(&["house/src/lower/wall.rs:2: imports `Roof` of upper/roof.rs, upwards from layer \"lower\" to \"upper\""]);
}

#[test]
fn every_folder_is_listed() {
    layered("unlisted")
        .configured("\"upper\", ", "")
        .fails(&["house/src/upper: folder is not in layers.toml"]);
    layered("empty")
        .configured("\"upper\"", "\"attic\", \"upper\"")
        .fails(&["\"attic\" of house/src has no files"]);
    layered("twice")
        .configured("\"upper\"", "\"upper\", \"upper\"")
        .fails(&["\"upper\" of house/src is listed twice"]);
}

#[test]
fn a_file_beside_its_folder_belongs_to_it() {
    Workspace::rust("beside", &["inner", "."])
        .file("house/src/lib.rs", "mod inner;\nmod own;")
        .file("house/src/inner.rs", "mod a;\npub fn f() { crate::own::own() }")
        .file("house/src/inner/a.rs", "fn g() { super::f() }")
        .file("house/src/own.rs", "pub fn own() {}")
        .passes();
}

#[test]
fn folders_have_at_most_twelve_files() {
    let folder = |name: &str, files: usize| {
        let modules: Vec<_> = (0..files).map(|at| format!("mod f{at};")).collect();
        let tree = Workspace::rust(name, &["."]).file("house/src/lib.rs", &modules.join("\n"));
        (0..files).fold(tree, |tree, at| tree.file(&format!("house/src/f{at}.rs"), "fn f() {}"))
    };
    folder("twelve", 12).passes();
    folder("thirteen", 13).fails(&["house/src: 13 files, at most 12 are allowed"]);
    folder("thirteen_generated", 13)
        .configured("lines = 400", "lines = 400\ngenerated = [\"house/src/f12.rs\"]")
        .passes();
}

#[test]
fn files_have_at_most_four_hundred_lines() {
    let file =
        |name: &str, lines: usize| layered(name).file("house/src/lower/wall.rs", &"//\n".repeat(lines));
    file("lines", 400).passes();
    file("long", 401).fails(&["house/src/lower/wall.rs:401: 401 lines, at most 400 are allowed"]);
    file("long_generated", 401)
        .configured("lines = 400", "lines = 400\ngenerated = [\"house/src/lower\"]")
        .passes();
    let tests = |name: &str| layered(name).file("house/tests/long.rs", &"//\n".repeat(401));
    tests("tests_free").passes();
    tests("tests_long")
        .configured("lines = 400", "lines = 400\nalso = [\"house/tests\"]")
        .fails(&["house/tests/long.rs:401"]);
}

#[test]
fn every_member_is_a_tree() {
    layered("members")
        .file("Cargo.toml", "[workspace]\nmembers = [\"house\", \"more/*\"]")
        .file("more/barn/src/lib.rs", "")
        .fails(&["more/barn/src: no tree in layers.toml"]);
}

#[test]
fn one_tree_is_chosen() {
    let tree = layered("chosen")
        .tree("barn/src", "rust", &["."])
        .file("house/src/lower/wall.rs", "use crate::upper::Roof;")
        .file("barn/src/lib.rs", "");
    let (is_success, said) = tree.run(&["--tree", "barn/src"]);
    assert!(is_success && said == "barn/src: 1 layer, 1 file, 0 imports between files\n", "{said}");
    assert!(!tree.run(&["--tree", "house/src"]).0);
    let (is_success, said) = tree.run(&["--tree", "shed"]);
    assert!(!is_success && said.contains("no tree `shed`"), "{said}");
}

#[test]
fn the_workspace_keeps_its_layers() {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_xtask")).arg("layers").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
