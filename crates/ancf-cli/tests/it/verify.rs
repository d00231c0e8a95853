//! `ancf verify`: lines, page, JSON, exit codes.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

fn verify(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).arg("verify").args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn into(folder: &Path, names: &[&str]) -> Output {
    verify(&[&["-o", folder.to_str().unwrap()], names].concat())
}

#[test]
fn a_problem_is_reported() {
    let folder = TempDir::new().unwrap();
    let run = into(folder.path(), &["elastica"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let lines = text(&run.stdout);
    assert!(lines.starts_with("elastica  passed ") && lines.lines().count() == 1, "{lines}");
    assert!(text(&run.stderr).contains("1 of 1 problems passed"));

    let results: Value =
        serde_json::from_slice(&fs::read(folder.path().join("results.json")).unwrap()).unwrap();
    assert_eq!(
        (&results["holds"], &results["machine"]["version"]),
        (&true.into(), &env!("CARGO_PKG_VERSION").into())
    );
    let problem = &results["problems"][0];
    assert_eq!((&problem["name"], &problem["holds"]), (&"elastica".into(), &true.into()));
    let comparisons = problem["comparisons"].as_array().unwrap();
    for comparison in comparisons {
        let number = |key: &str| comparison[key].as_f64().unwrap();
        assert!(number("error") <= number("tolerance"), "{comparison}");
        assert!(
            ((number("ours") - number("reference")).abs() / number("scale") - number("error")).abs() < 1e-15
        );
    }

    let page = fs::read_to_string(folder.path().join("index.html")).unwrap();
    assert!(page.contains("The problem passed.") && page.contains("<section id=\"elastica\">"));
    assert_eq!(page.matches("<td class=\"text\"><span class=\"good\">passed").count(), comparisons.len() + 1);
    assert_well_formed(&page, folder.path());
}

/// Asserts a well-formed page: valid links, no external resources, figures with an alternative text.
fn assert_well_formed(page: &str, folder: &Path) {
    // `meta` is not closed in HTML. All other tags are as in XML.
    let closed: Vec<String> = page
        .strip_prefix("<!DOCTYPE html>")
        .unwrap()
        .split("<meta ")
        .enumerate()
        .map(|(k, part)| if k == 0 { part.to_owned() } else { part.replacen('>', "/>", 1) })
        .collect();
    let closed = closed.join("<meta ");
    let document = roxmltree::Document::parse(&closed).unwrap_or_else(|error| panic!("{error}"));
    let ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    for link in document.descendants().filter_map(|node| node.attribute("href")) {
        let is_there = match link.strip_prefix('#') {
            Some(id) => ids.contains(&id),
            None => folder.join(link).is_file(),
        };
        assert!(is_there, "{link}");
    }
    let mut pictures =
        document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "svg")));
    assert!(pictures.clone().count() > 0);
    assert!(pictures.all(|svg| svg.attribute("aria-label").is_some_and(|words| words.len() > 20)));
    for remote in ["<script", "<link", "@import", "url(", "src=\"http", "href=\"http", "NaN"] {
        assert!(!page.contains(remote), "{remote}");
    }
}

#[test]
fn an_unknown_problem_is_rejected() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    let run = into(&out, &["elastcia"]);
    assert_eq!(run.status.code(), Some(2));
    let messages = text(&run.stderr);
    assert!(
        messages.contains("possible values: ") && messages.contains("a similar value exists: 'elastica'"),
        "{messages}"
    );
    assert!(!out.exists());
}

#[test]
fn every_problem_is_named() {
    // Long titles are wrapped.
    let help = text(&verify(&["--help"]).stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    for problem in ancf_verification::problems::all() {
        assert!(help.contains(&format!("- {}: {}", problem.name, problem.title)), "{}: {help}", problem.name);
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        assert!(problem.name.chars().all(plain), "{} is an anchor", problem.name);
    }
}
