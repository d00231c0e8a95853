//! Model files with several analyses.

use serde_json::Value;

use crate::folder::TestFolder;

const ROPE: &str = "gravity = [0, 0, -9.81]\nmaterials.steel = { density = 7850, young = 2.1e11 }\n\
    sections.wire = { kind = \"circle\", diameter = 0.005 }\n\
    bodies = [{ kind = \"cable\", name = \"rope\", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = \"wire\", material = \"steel\" }]\n\
    joints = [{ kind = \"spherical\", name = \"left\", a = { body = \"rope\", at = \"start\" } },\n\
    { kind = \"spherical\", name = \"hook\", a = { body = \"rope\", at = \"end\" }, not_in = [\"fall\", \"swing\"] }]\n\
    probes = [{ name = \"end\", on = { body = \"rope\", at = \"end\" } }]\n";

const ANALYSES: &str = "analysis = [{ kind = \"statics\", name = \"hang\" }, { kind = \"modes\", about = \"equilibrium\", count = 2 },\n\
    { kind = \"dynamics\", name = \"fall\", duration = 1, step = 1e-3, until = [{ value = \"end.z\", below = -0.1 }] },\n\
    { kind = \"dynamics\", name = \"swing\", duration = 0.05, step = 1e-3 }]\n";

fn folder(analyses: &str) -> TestFolder {
    let folder = TestFolder::new();
    folder.write("rope.toml", &format!("{ROPE}{analyses}"));
    folder
}

/// Column of the table of an analysis.
fn column(folder: &TestFolder, run: &str, name: &str) -> Vec<f64> {
    let text = folder.read(&format!("{run}/probes.csv"));
    let number = text.lines().next().unwrap().split(',').position(|column| column == name).unwrap();
    text.lines().skip(1).map(|line| line.split(',').nth(number).unwrap().parse().unwrap()).collect()
}

#[test]
fn analyses_run_one_after_another() {
    let folder = folder(ANALYSES);
    let checked = folder.printed(&["check", "rope.toml"]);
    assert!(checked.contains("analysis `hang`") && checked.contains("analysis `swing`"), "{checked}");
    let done = folder.ancf(&["run", "rope.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.messages);
    for expected in [
        "analysis 1 of 4: `hang`",
        "analysis 2 of 4: `modes`",
        "start: the state of the results folder \"../1-hang\" at load factor 1, from which the load factor releases",
        "ended: `end.z` = -0.10",
        "start: the state of the results folder \"../3-fall\" at t = 0.1",
    ] {
        assert!(done.messages.contains(expected), "{expected}\n{}", done.messages);
    }
    assert!(done.printed.contains("frequency"), "{}", done.printed);
    let (fall, swing) = (column(&folder, "rope/3-fall", "t"), column(&folder, "rope/4-swing", "t"));
    assert_eq!(fall[0], 0.0);
    assert_eq!(fall.last(), swing.first());
    assert!((swing.last().unwrap() - swing[0] - 0.05).abs() < 1e-12);
    let (before, after) = (column(&folder, "rope/3-fall", "end.z"), column(&folder, "rope/4-swing", "end.z"));
    assert!((before.last().unwrap() - after[0]).abs() < 1e-12);
    folder.printed(&["report", "rope/3-fall"]);
    // Each analysis is a model file that can be run alone.
    folder.printed(&["run", "rope/4-swing/model.toml", "-o", "again/4-swing"]);
}

#[test]
fn commands_about_results_name_the_folders_of_the_analyses() {
    let folder = folder(
        "analysis = [{ kind = \"statics\", name = \"hang\" }, { kind = \"modes\" }, { kind = \"statics\", name = \"fall\" },\n\
         { kind = \"statics\", name = \"swing\" }]\n",
    );
    let text = folder.read("rope.toml").replace(", not_in = [\"fall\", \"swing\"]", "");
    folder.write("rope.toml", &text);
    folder.printed(&["run", "rope.toml", "-o", "out"]);
    for command in ["report", "paraview"] {
        let done = folder.ancf(&[command, "out"]);
        assert_eq!(done.code, Some(2), "{}", done.messages);
        let expected =
            "contains the results of several analyses: choose one of its folders 1-hang, 2-modes, 3-fall";
        assert!(done.messages.contains(expected), "{}", done.messages);
    }
}

#[test]
fn json_output_is_one_object() {
    let folder = folder(ANALYSES);
    let printed = folder.printed(&["run", "rope.toml", "-o", "out", "--json"]);
    let json: Value = serde_json::from_str(&printed).unwrap();
    let analyses = json["analyses"].as_array().unwrap();
    assert_eq!(analyses.len(), 4);
    assert_eq!(analyses[1]["frequency"].as_array().unwrap().len(), 2);
    assert!(analyses[2]["ended_by"].as_str().unwrap().starts_with("`end.z`"));
    let printed = folder.printed(&["check", "rope.toml", "--json"]);
    let json: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(json["analyses"][3]["name"], "swing");
}

/// A sequence whose third analysis fails is resumed after a change of nothing but time: finished analyses are skipped.
#[test]
fn resume_skips_finished_analyses() {
    let folder = folder(ANALYSES);
    folder.printed(&["run", "rope.toml", "-o", "out"]);
    let whole = folder.read("out/4-swing/probes.csv");
    std::fs::remove_dir_all(folder.path("out/4-swing")).unwrap();
    std::fs::remove_file(folder.path("out/3-fall/summary.json")).unwrap();
    let done = folder.ancf(&["resume", "out"]);
    assert_eq!(done.code, Some(0), "{}", done.messages);
    assert!(done.messages.contains("1-hang is finished"), "{}", done.messages);
    assert!(done.messages.contains("no checkpoint found: starting from the beginning"), "{}", done.messages);
    assert_eq!(folder.read("out/4-swing/probes.csv"), whole);
}

/// Analyses after one that fails do not run.
#[test]
fn a_failure_ends_the_sequence() {
    let folder = folder(
        "analysis = [{ kind = \"statics\", name = \"fall\" }, { kind = \"dynamics\", name = \"swing\", duration = 1, step = 0.1 }]\n",
    );
    let done = folder.ancf(&["run", "rope.toml", "-o", "out"]);
    assert_eq!(done.code, Some(1), "{}", done.messages);
    assert!(!folder.path("out/2-swing").exists());
}

#[test]
fn bad_lists_are_refused_before_anything_runs() {
    let wrong = ANALYSES.replace("end.z", "end.zz");
    let folder = folder(&wrong);
    for command in ["run", "check"] {
        let done = folder.ancf(&[command, "rope.toml"]);
        assert_eq!(done.code, Some(2));
        assert!(done.messages.contains("analysis[2].until[0].value"), "{}", done.messages);
        assert!(done.messages.contains("rope.toml:9:"), "{}", done.messages);
    }
    assert!(!folder.path("rope").exists());
    let done = folder.ancf(&["run", "rope.toml", "--to", "1%"]);
    assert_eq!(done.code, Some(2));
    let done = folder.ancf(&["scaled", "rope.toml"]);
    assert!(done.messages.contains("a list of 4 analyses"), "{}", done.messages);
}

/// A file of the user with the name of the copy is kept. The copy of an earlier run is replaced.
#[test]
fn files_of_the_user_are_not_overwritten() {
    let short = |step: &str| {
        format!(
            "analysis = [{{ kind = \"statics\", name = \"hang\" }}, {{ kind = \"dynamics\", name = \"fall\", duration = 0.01, step = {step} }}, {{ kind = \"dynamics\", name = \"swing\", duration = 0.01, step = {step} }}]\n"
        )
    };
    let folder = folder(&short("1e-3"));
    std::fs::create_dir(folder.path("own")).unwrap();
    folder.write("own/sequence.toml", "mine");
    let refused = folder.ancf(&["run", "rope.toml", "-o", "own"]);
    assert_ne!(refused.code, Some(0));
    assert!(refused.messages.contains("own/sequence.toml is not a file of a run"), "{}", refused.messages);
    assert_eq!(folder.read("own/sequence.toml"), "mine");
    folder.printed(&["run", "rope.toml"]);
    folder.write("rope.toml", &format!("{ROPE}{}", short("2e-3")));
    folder.printed(&["run", "rope.toml", "-o", "rope"]);
    assert!(folder.read("rope/sequence.toml").contains("step = 2e-3"));
}

/// Turns are counted in every step, and the next analysis continues them, for any output: also from a state between recorded rows, and
/// without rows.
#[test]
fn turns_do_not_depend_on_the_output() {
    let folder = TestFolder::new();
    let spin = |output: &str, analysis: &str| {
        format!(
            "output = {{ {output} }}\n\
             bodies = [{{ kind = \"rigid\", name = \"r\", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1], motion = {{ spin = [0, 0, 20] }} }}]\n\
             joints = [{{ kind = \"revolute\", name = \"h\", a = {{ body = \"r\", at = \"center\" }}, axis = [0, 0, 1] }},\n\
             {{ kind = \"sensor\", name = \"sn\", a = {{ body = \"r\", at = \"center\" }}, b = \"ground\", measure = \"angle\", axis = [0, 0, 1] }}]\n\
             {analysis}\n"
        )
    };
    let two = "analysis = [{ name = \"one\", kind = \"dynamics\", duration = 1, step = 1e-3 },\n\
        { name = \"two\", kind = \"dynamics\", duration = 0.5, step = 1e-3 }]";
    for output in ["every = 1", "every = 10", "every = 7", "every = 10000", "parquet = false", "states = 0"] {
        folder.write("spin.toml", &spin(output, two));
        folder.printed(&["run", "spin.toml"]);
        for name in ["h.angle", "sn.angle"] {
            let angles = column(&folder, "spin/2-two", name);
            assert!((angles[0] - 20.0).abs() < 2e-3, "{output}: {name} starts at {}", angles[0]);
            let last = angles.last().unwrap();
            assert!((last - 30.0).abs() < 3e-3, "{output}: {name} ends at {last}");
        }
    }
    let motion =
        |duration: f64| format!("analysis = {{ kind = \"dynamics\", duration = {duration}, step = 1e-3 }}");
    folder.write("first.toml", &spin("every = 300, states = 11", &motion(1.0)));
    folder.printed(&["run", "first.toml"]);
    let start = format!("initial = {{ from = \"first\", time = 0.5 }}\n{}", motion(0.1));
    folder.write("second.toml", &spin("every = 1", &start));
    folder.printed(&["run", "second.toml"]);
    let first = column(&folder, "second", "h.angle")[0];
    assert!((first - 10.0).abs() < 2e-3, "{first}");
}
