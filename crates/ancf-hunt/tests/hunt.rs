//! Random models of a fixed seed, and the models of earlier findings.
// For Clippy, which permits `unwrap` in the helper functions of test code only.
#![cfg(test)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use ancf::Model;
use ancf_hunt::hunt::hunt;
use ancf_hunt::known::KNOWN;
use ancf_hunt::shrink::find;

/// Seed and number of the models, and share of the laws that each of them is held to.
const SEED: u64 = 3;
const MODELS: u64 = 500;
const SHARE: f64 = 0.4;

#[test]
fn random_models_obey_the_laws() {
    let report = hunt(SEED, 0..MODELS, SHARE).unwrap();
    let new: Vec<String> = report
        .new_findings()
        .map(|found| {
            let finding = &found.finding;
            format!("{}: {} {}: {}", found.number, finding.law, finding.quantity, finding.values)
        })
        .collect();
    assert!(
        new.is_empty(),
        "{report}\nnew findings of `cargo xtask hunt {SEED} {MODELS}`:\n{}",
        new.join("\n")
    );
    assert!(report.share_finished() > 0.9, "{report}");
    let is_found = |name: &str| report.violations.iter().any(|found| found.known == Some(name));
    let mended: Vec<&str> = KNOWN.iter().map(|known| known.name).filter(|name| !is_found(name)).collect();
    assert!(mended.is_empty(), "no findings, remove them from known.rs if they are mended: {mended:?}");
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("found")
}

/// Value of a line `# key: value` of the header.
fn header<'a>(text: &'a str, key: &str) -> &'a str {
    let line = text.lines().find_map(|line| line.strip_prefix(&format!("# {key}: ")));
    line.unwrap_or_else(|| panic!("no line `# {key}: ..`"))
}

/// Files of defects that are not yet mended, with the reason.
fn allowed() -> BTreeMap<String, String> {
    let text = fs::read_to_string(folder().join("allowed.toml")).unwrap();
    toml::from_str(&text).unwrap()
}

#[test]
fn models_of_findings_obey_the_laws() {
    let (mut allowed, mut wrong) = (allowed(), Vec::new());
    for entry in fs::read_dir(folder()).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        if name == "allowed" {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let model = Model::parse(&text).unwrap_or_else(|errors| panic!("{name}: {errors}"));
        let numbers: Vec<u64> = header(&text, "case")
            .split(|c: char| !c.is_ascii_digit())
            .filter_map(|x| x.parse().ok())
            .collect();
        let [seed, number] = numbers[..] else { panic!("{name}: expected `# case: seed S, number N`") };
        match (find(&model, header(&text, "law"), seed, number), allowed.remove(&name)) {
            (Some(finding), None) => wrong.push(format!("{name}: {finding:?}")),
            (None, Some(reason)) => {
                wrong.push(format!("{name} holds now, remove it from allowed.toml: {reason}"));
            }
            _ => {}
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(allowed.is_empty(), "allowed.toml names files that do not exist: {allowed:?}");
}
