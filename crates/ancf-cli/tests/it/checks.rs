//! `ancf check`: diagnosis, several files, standard input, changes of a file.

use std::fs;
use std::io::{Read, Write};
use std::process::Stdio;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::folder::TestFolder;
use crate::run_folder::{RunFolder, command, stderr};

/// Diagnosis of a model: bodies, joints, degrees of freedom. A redundant constraint is a warning.
#[test]
fn a_model_is_diagnosed() {
    let folder = RunFolder::new();
    let second =
        "[[joints]]\nkind = \"spherical\"\nname = \"again\"\na = { body = \"beam\", at = 0.0 }\n\n[[probes]]";
    let model = folder.cantilever("[[probes]]", second);
    let check = command(&["check", &model]).output().unwrap();
    assert_eq!(check.status.code(), Some(0), "{}", stderr(&check));
    assert!(
        stderr(&check).ends_with(&format!("model.toml has no errors; next: ancf run {model}\n")),
        "{}",
        stderr(&check)
    );
    let printed = String::from_utf8(check.stdout).unwrap();
    for line in [
        "bodies:    1 beam\n",
        "joints:    1 clamp, 1 spherical\n",
        "loads:     1 gravity\n",
        "equations: 252 coordinates, 15 constraints, 3 of them redundant\n",
        "mobility:  -3 by Grübler's formula for rigid bodies, which counts every joint\n",
        "           0 free motions of the bodies if they are rigid, by the rank of the constraints; 3 constraints are \
                    redundant for rigid bodies\n",
        "           240 degrees of freedom with the deformation of the bodies\n",
        "warning:   redundant: joint `again`: position along y, follows from joint `root`; they share the constraint force\n",
    ] {
        assert!(printed.contains(&line.replace("1 gravity", "gravity")), "{line} is not in\n{printed}");
    }
}

/// Gaps are rejected, or closed if the model requests it.
#[test]
fn gaps_are_reported_or_closed() {
    let folder = RunFolder::new();
    let clamp = "b = { point = [0.0, 0.01, 0.0] }\nname = \"root\"";
    let open = folder.cantilever("name = \"root\"", clamp);
    let check = command(&["check", &open]).output().unwrap();
    assert_eq!(check.status.code(), Some(2));
    let messages = stderr(&check);
    assert!(
        messages.contains("found a point that is 0.01 away from `a`")
            && messages.contains("`assemble = true`"),
        "{messages}"
    );
    let text = fs::read_to_string(&open).unwrap();
    fs::write(&open, format!("assemble = true\n{text}")).unwrap();
    let check = command(&["check", &open]).output().unwrap();
    assert_eq!(check.status.code(), Some(0), "{}", stderr(&check));
    let printed = String::from_utf8(check.stdout).unwrap();
    assert!(printed.contains("closed:    gap of joint `root`, 0.01\n"), "{printed}");
    assert!(printed.contains("moved:     body `beam`, by up to 0.01\n"), "{printed}");
}

/// Several files: one line per file without errors, its warnings, all errors of the others, and a count.
#[test]
fn several_files_are_checked() {
    let folder = TestFolder::new();
    let _ = folder.printed(&["new", "one.toml"]);
    let two = folder.read("one.toml").replace("diameter = 0.02", "diameter = 20");
    folder.write("two.toml", &two);
    let checked = folder.ancf(&["check", "one.toml", "two.toml"]);
    assert_eq!(checked.code, Some(0), "{}", checked.messages);
    let warning = "two.toml: warning: body `beam` is 1 long, and its section is 20 thick: check the units of `sections.rod`";
    assert_eq!(
        checked.printed.lines().collect::<Vec<_>>(),
        ["one.toml: no errors", "two.toml: no errors", warning]
    );
    assert_eq!(checked.messages, "done: 2 files without errors\n");

    folder.write("bad.toml", "gravity = 3");
    let checked = folder.ancf(&["check", "one.toml", "bad.toml", "none.toml"]);
    assert_eq!(checked.code, Some(2));
    for part in ["bad.toml:1:11: gravity", "none.toml: no such file\n", "error: 2 of 3 files have errors\n"] {
        assert!(checked.messages.contains(part), "{part}: {}", checked.messages);
    }
    let checked = folder.ancf(&["check", "one.toml", "none.toml", "--json"]);
    let json: Value = serde_json::from_str(&checked.printed).unwrap();
    assert_eq!(json["files"][0]["diagnosis"]["bodies"]["beam"], 1);
    assert_eq!(json["files"][1]["errors"][0]["found"], "no such file");
    assert_eq!(json["files"][1]["errors"][0]["expected"], Value::Null);
}

/// `-` is standard input, once.
#[test]
fn standard_input_is_checked() {
    let folder = TestFolder::new();
    let check = |text: &[u8]| {
        let mut check = folder.command(&["check", "-"]);
        let check = check.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut check = check.spawn().unwrap();
        check.stdin.take().unwrap().write_all(text).unwrap();
        check.wait_with_output().unwrap()
    };
    let _ = folder.printed(&["new", "one.toml"]);
    let good = check(folder.read("one.toml").as_bytes());
    assert_eq!((good.status.code(), stderr(&good)), (Some(0), "done: <stdin> has no errors\n".into()));
    let bad = check(b"gravity = 3");
    assert_eq!(bad.status.code(), Some(2));
    assert!(stderr(&bad).contains("<stdin>:1:11: gravity: found 3"), "{}", stderr(&bad));
    assert_eq!(folder.ancf(&["check", "-", "-"]).code, Some(2));
}

/// `--watch` checks again after a change.
#[test]
fn changes_are_checked() {
    let folder = TestFolder::new();
    folder.write("model.toml", "gravity = 3");
    let mut watch = folder.command(&["check", "--watch", "model.toml"]);
    let mut watch = watch.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    let mut errors = watch.stderr.take().unwrap();
    let mut wait_for = |text: &str| {
        let (mut all, mut part, start) = (String::new(), [0; 4096], Instant::now());
        while !all.contains(text) {
            assert!(start.elapsed() < Duration::from_secs(60), "{text} is not in {all}");
            let count = errors.read(&mut part).unwrap();
            all += &String::from_utf8_lossy(&part[..count]);
        }
    };
    wait_for("waiting for changes");
    // The file system may resolve times of changes to 10 ms only.
    std::thread::sleep(Duration::from_millis(50));
    folder.write("model.toml", "gravity = 4");
    wait_for("found 4");
    watch.kill().unwrap();
    let _ = watch.wait().unwrap();
}
