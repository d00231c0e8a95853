//! Studies that are rejected before any case is run.

use std::fs;

use super::folder::{MODEL, StudyFolder};

/// All errors are reported at once with their position. Nothing is written.
#[test]
fn invalid_studies_are_rejected() {
    for (study, messages) in [
        (
            "sampels = 10\ncombine = \"grit\"\n[parameters]\nelements = []\nx = 5\ny = { kind = \"normal\", mean = 3 }\n\
             [objectives]\ntip = { column = \"tip.y\", take = \"men\" }",
            &[
                ":2:1: sampels: found unknown key `sampels`",
                ":3:11: combine: found \"grit\", expected \"grid\" or \"zip\" (did you mean \"grid\"?)",
                ":5:12: parameters.elements: found an empty array, expected an array of at least one value",
                ":6:5: parameters.x: found 5, expected an array of at least one value or a table with `kind` = \"range\", ",
                ":7:5: parameters.y.deviation: found no key `deviation`, expected a number > 0",
                ":9:34: objectives.tip.take: found \"men\", expected \"first\", \"last\", \"mean\", \"min\", \"max\", \"amplitude\" or \
                 \"rms\" (did you mean \"mean\"?)",
            ][..],
        ),
        (
            "combine = \"zip\"\n[parameters]\nelements = [1, 2]\n\"bodies.beam.elements\" = [1, 2, 3]\n\"gravity[3]\" = [1, 2, 3]\n\
             \"bodies.beem.to\" = { kind = \"uniform\", low = 2, high = 1 }\n[objectives]\n\
             tip = { column = \"tip.yy\", take = \"mean\", row = 3 }\nseconds = { column = \"tip.x\" }",
            &[
                ":4:12: parameters.elements: found 2 values, expected 3, as many as `bodies.beam.elements` has",
                ":4:12: parameters.elements: found `bodies[0].elements`, which `bodies.beam.elements` sets too",
                ":6:16: parameters.\"gravity[3]\": found index `[3]`, expected an index from `[0]` to `[2]`",
                ":7:20: parameters.\"bodies.beem.to\": found no `beem`, expected `beam` (did you mean `beam`?)",
                ":7:20: parameters.\"bodies.beem.to\": found a distribution without `samples`",
                ":7:56: parameters.\"bodies.beem.to\".high: found 1, expected a number > 2, which is `low`",
                ":9:18: objectives.tip.column: found \"tip.yy\", which is no column of the results",
                "(did you mean \"tip.y\"?)",
                ":9:49: objectives.tip.row: found both `take` and `row`, expected one of them",
                ":10:11: objectives.seconds: found `seconds`, which is another column of the results",
            ][..],
        ),
        ("parameters = {", &[":2:15: found unclosed inline table, expected `}`"][..]),
    ] {
        let folder = StudyFolder::new(study);
        let output = folder.run(&[], 2);
        for message in messages {
            assert!(output.contains(message), "{message}\nis not in\n{output}");
        }
        assert!(!folder.file("out").exists());
    }
}

/// Errors of the model refer to the model file.
#[test]
fn an_invalid_model_is_rejected() {
    let folder = StudyFolder::new("parameters.elements = [1]");
    fs::write(folder.file("model.toml"), MODEL.replace("young", "yung")).unwrap();
    let output = folder.run(&[], 2);
    assert!(output.contains("model.toml:3:") && output.contains("did you mean `young`?"), "{output}");
    fs::remove_file(folder.file("model.toml")).unwrap();
    let output = folder.run(&[], 2);
    assert!(output.contains("study.toml:1:9: model: found \"model.toml\": no such file"), "{output}");
    fs::remove_file(folder.file("study.toml")).unwrap();
    assert!(folder.run(&[], 2).contains("study.toml: found no such file, expected a study file"));
}

/// A file that is not a table is not overwritten.
#[test]
fn a_file_that_is_no_table_is_not_overwritten() {
    let folder = StudyFolder::new("parameters.elements = [1]");
    fs::create_dir(folder.file("out")).unwrap();
    fs::write(folder.file("out/cases.parquet"), "precious").unwrap();
    let output = folder.run(&[], 1);
    assert!(output.contains("cases.parquet cannot be read; remove it or take another folder"), "{output}");
    assert_eq!(fs::read_to_string(folder.file("out/cases.parquet")).unwrap(), "precious");
}

/// A parameter that overwrites another one, in any order, or redirects its path.
#[test]
fn conflicting_parameters_are_rejected() {
    let folder = StudyFolder::new(
        "[parameters]\n\"bodies.beam.material.young\" = [193e9, 100e9]\n\
         \"materials.steel\" = [{ density = 8030, young = 193e9 }]\n\
         gravity = [[0, -1, 0]]\n\"gravity[1]\" = [-2]\n\
         \"bodies.beam.section\" = [\"rod\"]\n\"section.diameter\" = [0.02, 0.03]\n",
    );
    let output = folder.run(&[], 2);
    for message in [
        "parameters.\"materials.steel\": found `materials.steel`, of which `bodies.beam.material.young` sets a part, \
         expected every place to be set once (give the whole with its parts, or the parts alone)",
        "parameters.\"gravity[1]\": found `gravity[1]`, which `gravity` sets too, expected every place to be set once",
        "parameters.\"section.diameter\": found a path through what `bodies.beam.section` sets, expected a path that leads \
         to the same place in every case (such as `sections.rod.diameter`)",
    ] {
        assert!(output.contains(message), "{message}\nis not in\n{output}");
    }
    assert_eq!(output.matches(": found ").count(), 3, "{output}");

    // Parameters without conflicts.
    folder.state(
        "parameters = { \"materials.steel.young\" = [193e9], \"bodies.beam.material\" = [\"steel\"] }",
    );
    folder.run(&[], 0);
}

/// Numbers of samples, distributions and cases that are too large, and a seed beyond 32 bits.
#[test]
fn limits_of_samples_and_cases() {
    let distributions: String =
        (0..482).map(|k| format!("\"p{k}\" = {{ kind = \"normal\", mean = 0, deviation = 1 }}\n")).collect();
    let folder =
        StudyFolder::new(&format!("samples = 2\nsampling = \"sobol\"\n[parameters]\n{distributions}"));
    let message = "parameters: found 482 distributions, expected at most 481 in a Sobol sequence";
    assert!(folder.run(&[], 2).contains(message));
    folder.state(
        "samples = 2\n[parameters]\nelements = { kind = \"range\", from = 1, to = 9, count = 10000000 }\n\
                  \"gravity[1]\" = { kind = \"normal\", mean = 0, deviation = 1 }",
    );
    assert!(folder.run(&[], 2).contains("found too many combinations, expected at most 10 000 000 cases"));
    folder.state("seed = 4294967296\nparameters.elements = [1]");
    assert!(folder.run(&[], 2).contains("seed: found 4294967296, expected"));
}

/// Paths and columns refer to the model of the first case, not to the model in its file.
#[test]
fn paths_and_columns_are_those_of_the_first_case() {
    let probe = "{ name = \"end\", on = { body = \"beam\", at = \"end\" } }";
    let folder = StudyFolder::new(&format!(
        "[parameters]\nprobes = [[{probe}]]\n\"bodies.beam.kind\" = [\"cable\"]\n[objectives]\nend = {{ column = \"end.y\" }}"
    ));
    let spherical = MODEL.replace("kind = \"clamp\"", "kind = \"spherical\"");
    fs::write(folder.file("model.toml"), spherical).unwrap();
    folder.run(&[], 0);
    assert_eq!(folder.column("end").len(), 1);

    folder
        .state(&format!("[parameters]\nprobes = [[{probe}]]\n[objectives]\ntip = {{ column = \"tip.y\" }}"));
    let output = folder.run(&[], 2);
    assert!(
        output.contains("objectives.tip.column: found \"tip.y\", which is no column of the results"),
        "{output}"
    );

    folder.state(
        "[parameters]\nanalysis = [{ kind = \"modes\", count = 2 }, { kind = \"modes\", count = 3 }]\n\
                 [objectives]\nfirst = { column = \"frequency\" }",
    );
    fs::write(folder.file("model.toml"), MODEL).unwrap();
    folder.run(&[], 0);
}
