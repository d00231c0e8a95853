//! `ancf plot`.

use std::fs;

use crate::bench::{Bench, Ended};

#[test]
fn columns_are_listed_with_unit_and_range() {
    let bench = Bench::with_run("cantilever");
    let listed = bench.printed(&["plot", "out"]);
    let line = |name: &str| {
        let line = listed.lines().find(|line| line.split_whitespace().next() == Some(name)).unwrap();
        line.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(line("t"), ["t", "s", "0", "1"]);
    assert_eq!(line("tip.z")[1..], ["m", "0", "0"]);
    assert_eq!(line("tip.ay")[1], "m/s²");
    assert!(listed.ends_with("501 rows\n"), "{listed}");
    let json = bench.ancf(&["plot", "out", "--json"]).json();
    let tip = json["columns"].as_array().unwrap().iter().find(|column| column["name"] == "tip.y").unwrap();
    // It swings between rest and twice the static deflection, somewhat less with damping.
    let least = tip["least"].as_f64().unwrap();
    assert!((-3.74e-3..-3.0e-3).contains(&least) && tip["largest"].as_f64() == Some(0.0), "{tip}");
    assert_eq!((json["rows"].as_u64(), json["status"].as_str()), (Some(501), Some("ended")));
}

#[test]
fn charts_have_axes_units_and_names() {
    let bench = Bench::with_run("cantilever");
    let chart = bench.printed(&["plot", "out", "tip.y"]);
    assert!(chart.is_ascii() && chart.starts_with("* tip.y (m)\n"), "{chart}");
    assert!(chart.trim_end().ends_with(" t (s)") && chart.contains("-0.002+"), "{chart}");
    assert!(chart.lines().all(|line| line.len() <= 80), "{chart}");
    let unicode = bench.command(&["plot", "out", "tip.y"]).env("LANG", "de_DE.UTF-8").output().unwrap();
    let unicode = Ended::of(&unicode).printed;
    assert!(
        unicode.contains('┤') && unicode.contains(|c| ('\u{2801}'..='\u{28ff}').contains(&c)),
        "{unicode}"
    );
    assert!(unicode.lines().all(|line| line.chars().count() <= 80), "{unicode}");
    let several = bench.printed(&["plot", "out", "tip", "root.f*"]);
    let heads: Vec<&str> = several.lines().filter(|line| line.starts_with("* ")).collect();
    assert_eq!(
        heads,
        ["* tip.x  + tip.y  o tip.z (m)", "* root.fx  + root.fy  o root.fz (N)"],
        "one chart a unit"
    );
    let path = bench.printed(&["plot", "out", "tip.y", "--against", "tip.x"]);
    assert!(path.trim_end().ends_with(" tip.x (m)"), "{path}");
}

/// From 0.5 s to 0.6 s, the axis has that range and no other.
#[test]
fn a_part_of_the_time_is_plotted() {
    let bench = Bench::with_run("cantilever");
    let chart = bench.printed(&["plot", "out", "tip.y", "--from", "0.5", "--to", "0.6"]);
    let numbers: Vec<f64> =
        chart.lines().nth_back(1).unwrap().split_whitespace().map(|number| number.parse().unwrap()).collect();
    assert_eq!((numbers.first(), numbers.last()), (Some(&0.5), Some(&0.6)), "{chart}");
    let nothing = bench.ancf(&["plot", "out", "tip.y", "--from", "7"]);
    assert_eq!(
        (nothing.code, nothing.said.as_str()),
        (Some(2), "error: out: there is no number to plot in this range\n")
    );
}

#[test]
fn figures_are_written() {
    let bench = Bench::with_run("cantilever");
    bench.printed(&["plot", "out", "tip", "kinetic", "-o", "tip.svg"]);
    let svg = bench.read("tip.svg");
    let tree = roxmltree::Document::parse(&svg).unwrap();
    let texts: Vec<String> = tree
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| node.text().unwrap_or_default().to_owned())
        .collect();
    for wanted in ["t (s)", "tip.x", "tip.y", "tip.z", "m", "kinetic (N m)"] {
        assert!(texts.iter().any(|text| text == wanted), "{wanted} is not in {texts:?}");
    }
    bench.printed(&["plot", "out", "tip.y", "-o", "tip.png"]);
    let image = png::Decoder::new(std::io::BufReader::new(fs::File::open(bench.path("tip.png")).unwrap()));
    let info = image.read_info().unwrap();
    assert_eq!((info.info().width, info.info().height), (1280, 800));
    let other = bench.ancf(&["plot", "out", "tip.y", "-o", "tip.pdf"]);
    assert!(other.code == Some(2) && other.said.contains("wanted a file that ends with .svg or .png"));
}

#[test]
fn what_is_not_there_is_told() {
    let bench = Bench::with_run("statics");
    let unknown = bench.ancf(&["plot", "out", "tpi.y"]);
    assert_eq!(unknown.code, Some(2));
    assert_eq!(unknown.said, "error: there is no column `tpi.y`; did you mean `tip.y`?\n");
    let against = bench.ancf(&["plot", "out", "tip.y", "--against", "laod"]);
    assert_eq!(against.said, "error: there is no column `laod`; did you mean `load`?\n");
    let cases = [("nowhere", "there is no model.toml"), (".", "there is a model.toml and no results")];
    for (folder, why) in cases {
        let none = bench.ancf(&["plot", folder, "tip.y"]);
        assert_eq!((none.code, none.said), (Some(2), format!("error: {folder} holds no run: {why}\n")));
    }
}

/// A run that goes on, and one that was killed, are plotted as far as they are.
#[cfg(unix)]
#[test]
fn runs_that_go_on_or_broke_off_are_plotted() {
    let bench = Bench::new();
    bench.printed(&["new", "model.toml"]);
    bench.write("model.toml", &bench.read("model.toml").replace("duration = 1.0", "duration = 10000.0"));
    let mut run = bench.command(&["run", "model.toml", "-o", "out"]).spawn().unwrap();
    let rows = || bench.ancf(&["plot", "out", "--json"]).printed;
    let is_there = |text: &str| {
        serde_json::from_str::<serde_json::Value>(text).is_ok_and(|json| json["rows"].as_u64() > Some(9))
    };
    while !is_there(&rows()) {
        assert!(run.try_wait().unwrap().is_none(), "it ended");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    assert!(bench.printed(&["plot", "out"]).contains("rows, and the run goes on\n"));
    assert!(bench.printed(&["plot", "out", "tip.y"]).starts_with("* tip.y (m)\n"));
    run.kill().unwrap();
    run.wait().unwrap();
    assert!(bench.printed(&["plot", "out"]).contains("rows; the run broke off: `ancf resume` goes on\n"));
    assert!(bench.printed(&["plot", "out", "tip.y"]).starts_with("* tip.y (m)\n"));
}
