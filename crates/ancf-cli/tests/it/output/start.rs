//! `ancf new`, `completions`, `man` and help.

use std::fs;
use std::process::Command;

use crate::folder::TestFolder;

const KINDS: [&str; 9] =
    ["cantilever", "cable", "pendulum", "mechanism", "contact", "statics", "path", "modes", "buckling"];

/// The suggested commands work: check, run, plot.
#[test]
fn every_template_runs_with_the_suggested_commands() {
    for kind in KINDS {
        let folder = TestFolder::new();
        let made = folder.ancf(&["new", "my.toml", "--kind", kind]);
        assert_eq!((made.code, made.printed.as_str()), (Some(0), ""), "{kind}");
        let next: Vec<&str> = made.messages.lines().filter_map(|line| line.strip_prefix("  ancf ")).collect();
        assert_eq!(next.len(), 3, "{}", made.messages);
        for line in next {
            let arguments: Vec<&str> = line.split_whitespace().map(|word| word.trim_matches('\'')).collect();
            let output = folder.ancf(&arguments);
            assert_eq!(output.code, Some(0), "{kind}: {line}: {}", output.messages);
            // The arch of the path snaps through.
            let unstable = kind == "path" && line.starts_with("run");
            let warnings: Vec<&str> =
                output.messages.lines().filter(|line| line.contains("warning")).collect();
            assert_eq!(warnings.len(), usize::from(unstable), "{kind}: {line}: {}", output.messages);
            assert!(!unstable || warnings[0].contains("the path lost its stability"), "{}", output.messages);
        }
        assert!(
            folder.read("my.toml").contains("docs/model-file.md"),
            "{kind}: link to the documentation of the keys"
        );
    }
}

/// Physics of two templates: the deflection q L^4/(8 E I) at rest, Euler's critical load.
#[test]
fn templates_have_correct_physics() {
    let folder = TestFolder::with_run("cantilever");
    let text = folder.read("out/probes.csv");
    let at = text.lines().next().unwrap().split(',').position(|name| name == "tip.y").unwrap();
    let last: f64 = text.lines().last().unwrap().split(',').nth(at).unwrap().parse().unwrap();
    let (area, inertia) = (std::f64::consts::PI * 1e-4, std::f64::consts::PI * 1e-8 / 4.0);
    let deflection = 7850.0 * 9.81 * area / (8.0 * 2.1e11 * inertia);
    // A small oscillation remains at the end.
    assert!((last / -deflection - 1.0).abs() < 0.05, "{last} instead of {}", -deflection);
    let folder = TestFolder::new();
    folder.printed(&["new", "column.toml", "-k", "buckling"]);
    let factors = folder.ancf(&["run", "column.toml", "-o", "out", "--json"]).json();
    let euler = std::f64::consts::PI.powi(2) * 2.1e11 * inertia / 16.0;
    assert!((factors["factor"][0].as_f64().unwrap() / euler - 1.0).abs() < 1e-3, "{factors}");
}

#[test]
fn existing_files_are_overwritten_only_with_force() {
    let folder = TestFolder::new();
    folder.write("model.toml", "mine");
    let refused = folder.ancf(&["new", "model.toml"]);
    assert_eq!(refused.code, Some(2));
    assert_eq!(refused.messages, "error: model.toml exists already; --force overwrites it\n");
    assert_eq!(folder.read("model.toml"), "mine");
    folder.printed(&["new", "model.toml", "--force"]);
    assert_eq!(folder.read("model.toml"), folder.printed(&["new", "-"]));
    let nowhere = folder.ancf(&["new", "no/such/folder.toml"]);
    assert!(
        nowhere.code == Some(1) && nowhere.messages.starts_with("error: cannot write no/such/folder.toml: ")
    );
}

/// Every command has examples in its help, and the first tour works.
#[test]
fn help_has_examples_that_work() {
    let folder = TestFolder::new();
    for command in &folder.commands() {
        let own = folder.printed(&[command, "--help"]);
        let examples = own.split_once("Examples:\n  ancf ").map(|(_, examples)| examples).unwrap_or_default();
        assert!(format!("  ancf {examples}").contains(&format!("  ancf {command}")), "{command}: {own}");
        assert!(own.lines().all(|line| line.chars().count() <= 100), "{command}: {own}");
    }
    let help = folder.printed(&["--help"]);
    let tour = help.lines().skip_while(|line| *line != "A first tour:").skip(1).take(4);
    for line in tour {
        // Words up to the description.
        let line = line.trim_start().split("   ").next().unwrap();
        folder.printed(&line.split_whitespace().skip(1).collect::<Vec<_>>());
    }
}

#[test]
fn shells_complete() {
    let folder = TestFolder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = folder.printed(&["completions", shell]);
        let knows = |word: &str| script.contains(word);
        assert!(
            ["ancf", "resume", "--checkpoint"].into_iter().all(|word| knows(word.trim_start_matches("--")))
        );
        // Two shells complete no values.
        let values = ["cantilever", "buckling"].into_iter().all(knows);
        assert!(values || ["powershell", "elvish"].contains(&shell), "{shell}");
    }
    folder.write("ancf.bash", &folder.printed(&["completions", "bash"]));
    let script =
        "source ./ancf.bash; COMP_WORDS=(ancf res); COMP_CWORD=1; _ancf ancf res ancf; echo ${COMPREPLY[@]}";
    let Ok(done) = Command::new("bash").args(["-c", script]).current_dir(folder.path("")).output() else {
        return;
    };
    assert_eq!(String::from_utf8_lossy(&done.stdout).trim(), "resume");
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = TestFolder::new();
    let page = folder.printed(&["man"]);
    assert!(
        page.contains(".TH ancf 1") && page.contains("ancf\\-run(1)") && page.contains("A first tour"),
        "{page}"
    );
    folder.printed(&["man", "pages/man1"]);
    assert_eq!(folder.read("pages/man1/ancf.1"), page);
    let pages = fs::read_dir(folder.path("pages/man1")).unwrap().count();
    assert!(pages >= 13, "{pages}");
    let run = folder.read("pages/man1/ancf-run.1");
    assert!(run.contains("checkpoint") && run.contains("models/elastica.toml"), "{run}");
}
