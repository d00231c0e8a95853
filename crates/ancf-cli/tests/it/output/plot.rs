//! `ancf plot`.

use std::fs;

use crate::folder::{CommandOutput, TestFolder};

#[test]
fn columns_are_listed_with_unit_and_range() {
    let folder = TestFolder::with_run("cantilever");
    let listed = folder.printed(&["plot", "out"]);
    let line = |name: &str| {
        let line = listed.lines().find(|line| line.split_whitespace().next() == Some(name)).unwrap();
        line.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(line("t"), ["t", "s", "0", "1"]);
    assert_eq!(line("tip.z")[1..], ["m", "0", "0"]);
    assert_eq!(line("tip.ay")[1], "m/s²");
    assert!(listed.ends_with("501 rows\n"), "{listed}");
    let json = folder.ancf(&["plot", "out", "--json"]).json();
    let tip = json["columns"].as_array().unwrap().iter().find(|column| column["name"] == "tip.y").unwrap();
    // The tip oscillates between rest and twice the static deflection, less with damping.
    let least = tip["least"].as_f64().unwrap();
    assert!((-3.74e-3..-3.0e-3).contains(&least) && tip["largest"].as_f64() == Some(0.0), "{tip}");
    assert_eq!((json["rows"].as_u64(), json["status"].as_str()), (Some(501), Some("ended")));
}

#[test]
fn charts_have_axes_units_and_names() {
    let folder = TestFolder::with_run("cantilever");
    let chart = folder.printed(&["plot", "out", "tip.y"]);
    assert!(chart.is_ascii() && chart.starts_with("* tip.y (m)\n"), "{chart}");
    assert!(chart.trim_end().ends_with(" t (s)") && chart.contains("-0.002+"), "{chart}");
    assert!(chart.lines().all(|line| line.len() <= 80), "{chart}");
    let unicode = folder.command(&["plot", "out", "tip.y"]).env("LANG", "de_DE.UTF-8").output().unwrap();
    let unicode = CommandOutput::new(&unicode).printed;
    assert!(
        unicode.contains('┤') && unicode.contains(|c| ('\u{2801}'..='\u{28ff}').contains(&c)),
        "{unicode}"
    );
    assert!(unicode.lines().all(|line| line.chars().count() <= 80), "{unicode}");
    let several = folder.printed(&["plot", "out", "tip", "root.f*"]);
    let heads: Vec<&str> = several.lines().filter(|line| line.starts_with("* ")).collect();
    assert_eq!(
        heads,
        ["* tip.x  + tip.y  o tip.z (m)", "* root.fx  + root.fy  o root.fz (N)"],
        "one chart a unit"
    );
    let path = folder.printed(&["plot", "out", "tip.y", "--against", "tip.x"]);
    assert!(path.trim_end().ends_with(" tip.x (m)"), "{path}");
}

/// From 0.5 s to 0.6 s: the axis has this range.
#[test]
fn a_part_of_the_time_is_plotted() {
    let folder = TestFolder::with_run("cantilever");
    let chart = folder.printed(&["plot", "out", "tip.y", "--from", "0.5", "--to", "0.6"]);
    let numbers: Vec<f64> =
        chart.lines().nth_back(1).unwrap().split_whitespace().map(|number| number.parse().unwrap()).collect();
    assert_eq!((numbers.first(), numbers.last()), (Some(&0.5), Some(&0.6)), "{chart}");
    let nothing = folder.ancf(&["plot", "out", "tip.y", "--from", "7"]);
    assert_eq!(
        (nothing.code, nothing.messages.as_str()),
        (Some(2), "error: out: no values to plot in this range\n")
    );
}

#[test]
fn figures_are_written() {
    let folder = TestFolder::with_run("cantilever");
    folder.printed(&["plot", "out", "tip", "kinetic", "-o", "tip.svg"]);
    let svg = folder.read("tip.svg");
    let tree = roxmltree::Document::parse(&svg).unwrap();
    let texts: Vec<String> = tree
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| node.text().unwrap_or_default().to_owned())
        .collect();
    for expected in ["t (s)", "tip.x", "tip.y", "tip.z", "m", "kinetic (J)"] {
        assert!(texts.iter().any(|text| text == expected), "{expected} is not in {texts:?}");
    }
    folder.printed(&["plot", "out", "tip.y", "-o", "tip.png"]);
    let image = png::Decoder::new(std::io::BufReader::new(fs::File::open(folder.path("tip.png")).unwrap()));
    let info = image.read_info().unwrap();
    assert_eq!((info.info().width, info.info().height), (1280, 800));
    folder.printed(&["plot", "out", "tip.y", "-o", "tip.pdf"]);
    assert!(fs::read(folder.path("tip.pdf")).unwrap().starts_with(b"%PDF-"));
    let other = folder.ancf(&["plot", "out", "tip.y", "-o", "tip.eps"]);
    let expected = "expected a file with the extension .svg, .png or .pdf";
    assert!(other.code == Some(2) && other.messages.contains(expected), "{}", other.messages);
}

#[test]
fn unknown_columns_and_folders_are_rejected() {
    let folder = TestFolder::with_run("statics");
    let unknown = folder.ancf(&["plot", "out", "tpi.y"]);
    assert_eq!(unknown.code, Some(2));
    assert_eq!(unknown.messages, "error: there is no column `tpi.y`; did you mean `tip.y`?\n");
    let against = folder.ancf(&["plot", "out", "tip.y", "--against", "laod"]);
    assert_eq!(against.messages, "error: there is no column `laod`; did you mean `load`?\n");
    let cases = [("nowhere", "there is no model.toml"), (".", "there is a model.toml and no results")];
    for (place, why) in cases {
        let none = folder.ancf(&["plot", place, "tip.y"]);
        assert_eq!((none.code, none.messages), (Some(2), format!("error: {place} contains no run: {why}\n")));
    }
}

/// A run in progress and a killed run are plotted as far as their rows are on the disk.
#[cfg(unix)]
#[test]
fn running_and_killed_runs_are_plotted() {
    let folder = TestFolder::new();
    folder.printed(&["new", "model.toml"]);
    folder.write("model.toml", &folder.read("model.toml").replace("duration = 1.0", "duration = 10000.0"));
    let mut run = folder.command(&["run", "model.toml", "-o", "out"]).spawn().unwrap();
    let rows = || folder.ancf(&["plot", "out", "--json"]).printed;
    let is_there = |text: &str| {
        serde_json::from_str::<serde_json::Value>(text).is_ok_and(|json| json["rows"].as_u64() > Some(9))
    };
    while !is_there(&rows()) {
        assert!(run.try_wait().unwrap().is_none(), "the run ended");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    assert!(folder.printed(&["plot", "out"]).contains("rows, the run is in progress\n"));
    assert!(folder.printed(&["plot", "out", "tip.y"]).starts_with("* tip.y (m)\n"));
    run.kill().unwrap();
    run.wait().unwrap();
    assert!(
        folder
            .printed(&["plot", "out"])
            .contains("rows; the run was interrupted, `ancf resume` resumes it\n")
    );
    assert!(folder.printed(&["plot", "out", "tip.y"]).starts_with("* tip.y (m)\n"));
}
