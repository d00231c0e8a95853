//! Motions that start from an equilibrium or from the state of another run.

use crate::folder::TestFolder;

const ARM: &str = "gravity = [0, 0, -9.81]\nmaterials.m = { density = 1000, young = 2e8 }\n\
    sections.s = { kind = \"circle\", diameter = 0.02 }\n\
    bodies = [{ kind = \"beam\", name = \"arm\", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = \"s\", material = \"m\" }]\n\
    joints = [{ kind = \"clamp\", name = \"root\", a = { body = \"arm\", at = \"start\" } }]\n\
    probes = [{ name = \"tip\", on = { body = \"arm\", at = \"end\" } }]\n";

const MOTION: &str = "analysis = { kind = \"dynamics\", duration = 0.1, step = 0.01 }\n";

/// Folder with the runs `still` (statics), `moving` (dynamics) and `shapes` (modes) of the arm.
fn folder() -> TestFolder {
    let folder = TestFolder::new();
    for (name, analysis) in [
        ("still", "analysis = { kind = \"statics\" }\n"),
        ("moving", MOTION),
        ("shapes", "analysis = { kind = \"modes\", count = 2 }\n"),
    ] {
        folder.write(&format!("{name}.toml"), &format!("{ARM}{analysis}"));
        folder.printed(&["run", &format!("{name}.toml")]);
    }
    folder
}

/// First and last height of the tip in `probes.csv` of a run.
fn heights(folder: &TestFolder, run: &str) -> [f64; 2] {
    let text = folder.read(&format!("{run}/probes.csv"));
    let column = text.lines().next().unwrap().split(',').position(|name| name == "tip.z").unwrap();
    let value = |line: &str| line.split(',').nth(column).unwrap().parse::<f64>().unwrap();
    [value(text.lines().nth(1).unwrap()), value(text.lines().last().unwrap())]
}

#[test]
fn runs_start_from_results_folders() {
    let folder = folder();
    let start = |name: &str, initial: &str| {
        folder.write(&format!("{name}.toml"), &format!("{ARM}initial = {{ {initial} }}\n{MOTION}"));
        let done = folder.ancf(&["run", &format!("{name}.toml")]);
        assert_eq!(done.code, Some(0), "{}", done.messages);
        (heights(&folder, name), done.messages)
    };
    let ([first, last], messages) = start("released", "from = \"still\"");
    assert!((first - heights(&folder, "still")[1]).abs() < 1e-14 && (last - first).abs() < 1e-8);
    assert!(
        messages.contains("start: the state of the results folder \"still\" at load factor 1"),
        "{messages}"
    );
    let ([first, _], messages) = start("again", "from = \"moving\"");
    assert!((first - heights(&folder, "moving")[1]).abs() < 1e-12);
    assert!(messages.contains("at t = 0.1, positions moved by up to "), "{messages}");
    let ([first, _], messages) = start("middle", "from = \"moving\", time = 0.05");
    assert!(first < -1e-4 && first > heights(&folder, "moving")[1], "{first}");
    assert!(messages.contains("at t = 0.05"), "{messages}");
    let (_, messages) = start("settled", "from = \"equilibrium\"");
    assert!(messages.contains("start: equilibrium at t = 0, "), "{messages}");
    let checked = folder.printed(&["check", "again.toml"]);
    assert!(checked.contains("start:     state of the results folder `moving`"), "{checked}");
    folder.printed(&["report", "again"]);
}

#[test]
fn wrong_starts_are_errors_at_their_keys() {
    let folder = folder();
    let other = ARM.replace("elements = 4", "elements = 5");
    let longer = ARM.replace("to = [1, 0, 0]", "to = [1.1, 0, 0]");
    let named = ARM.replace("\"arm\"", "\"leg\"");
    let structure = ", expected a state of the same structure";
    let cases = [
        (ARM, "from = \"nowhere\"", "8:20: initial.from: found \"nowhere\": nowhere contains no run", ""),
        (
            ARM,
            "from = \"shapes\"",
            "8:20: initial.from: found the results folder \"shapes\", which has shapes",
            "",
        ),
        (ARM, "from = \"still\", time = 1", "8:36: initial.time: found a time for a run without time", ""),
        (
            ARM,
            "from = \"moving\", time = 0.055",
            "8:37: initial.time: found 0.055, expected the time of a stored state",
            "is at t = ",
        ),
        (ARM, "time = 0.05", "8:20: initial.time: found 0.05, expected no time", ""),
        (&other, "from = \"moving\"", "which has other elements of body \"arm\"", structure),
        (
            &longer,
            "from = \"moving\"",
            "which has another undeformed shape or place of body \"arm\"",
            structure,
        ),
        (&named, "from = \"moving\"", "which has a further body \"arm\"", structure),
    ];
    for (model, initial, message, more) in cases {
        folder.write("wrong.toml", &format!("\n{model}initial = {{ {initial} }}\n{MOTION}"));
        for command in ["run", "check"] {
            let done = folder.ancf(&[command, "wrong.toml"]);
            assert_eq!(done.code, Some(2), "{initial}");
            assert!(done.messages.contains(message) && done.messages.contains(more), "{}", done.messages);
        }
    }
}
