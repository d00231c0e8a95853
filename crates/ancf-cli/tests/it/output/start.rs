//! `ancf new`, `completions`, `man` and help.

use std::fs;
use std::process::Command;

use crate::bench::Bench;

const KINDS: [&str; 9] =
    ["cantilever", "cable", "pendulum", "mechanism", "contact", "statics", "path", "modes", "buckling"];

/// The commands that are told next work as they stand: check, run, plot.
#[test]
fn every_starting_model_runs_as_it_is_told() {
    for kind in KINDS {
        let bench = Bench::new();
        let made = bench.ancf(&["new", "my.toml", "--kind", kind]);
        assert_eq!((made.code, made.printed.as_str()), (Some(0), ""), "{kind}");
        let next: Vec<&str> = made.said.lines().filter_map(|line| line.strip_prefix("  ancf ")).collect();
        assert_eq!(next.len(), 3, "{}", made.said);
        for line in next {
            let arguments: Vec<&str> = line.split_whitespace().map(|word| word.trim_matches('\'')).collect();
            let ended = bench.ancf(&arguments);
            assert_eq!(ended.code, Some(0), "{kind}: {line}: {}", ended.said);
            assert!(!ended.said.contains("warning"), "{kind}: {line}: {}", ended.said);
        }
        assert!(bench.read("my.toml").contains("docs/model-file.md"), "{kind}: where the keys are explained");
    }
}

/// Physics of two of them: the deflection q L^4/(8 E I) at rest, Euler's critical load.
#[test]
fn starting_models_are_right() {
    let bench = Bench::with_run("cantilever");
    let text = bench.read("out/probes.csv");
    let at = text.lines().next().unwrap().split(',').position(|name| name == "tip.y").unwrap();
    let last: f64 = text.lines().last().unwrap().split(',').nth(at).unwrap().parse().unwrap();
    let (area, inertia) = (std::f64::consts::PI * 1e-4, std::f64::consts::PI * 1e-8 / 4.0);
    let deflection = 7850.0 * 9.81 * area / (8.0 * 2.1e11 * inertia);
    // It still swings a little at the end.
    assert!((last / -deflection - 1.0).abs() < 0.05, "{last} instead of {}", -deflection);
    let bench = Bench::new();
    bench.printed(&["new", "column.toml", "-k", "buckling"]);
    let factors = bench.ancf(&["run", "column.toml", "-o", "out", "--json"]).json();
    let euler = std::f64::consts::PI.powi(2) * 2.1e11 * inertia / 16.0;
    assert!((factors["factor"][0].as_f64().unwrap() / euler - 1.0).abs() < 1e-3, "{factors}");
}

#[test]
fn files_that_are_there_stay_unless_forced() {
    let bench = Bench::new();
    bench.write("model.toml", "mine");
    let refused = bench.ancf(&["new", "model.toml"]);
    assert_eq!(refused.code, Some(2));
    assert_eq!(refused.said, "error: model.toml is there already; --force writes over it\n");
    assert_eq!(bench.read("model.toml"), "mine");
    bench.printed(&["new", "model.toml", "--force"]);
    assert_eq!(bench.read("model.toml"), bench.printed(&["new", "-"]));
    let nowhere = bench.ancf(&["new", "no/such/folder.toml"]);
    assert!(nowhere.code == Some(1) && nowhere.said.starts_with("error: cannot write no/such/folder.toml: "));
}

/// Every command has examples in its help, and the first tour works as it stands.
#[test]
fn help_has_examples_that_work() {
    let bench = Bench::new();
    let help = bench.printed(&["--help"]);
    let commands: Vec<&str> = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ").filter(|line| !line.starts_with(' ')))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|command| *command != "help")
        .collect();
    assert!(commands.len() >= 12, "{commands:?}");
    for command in commands {
        let own = bench.printed(&[command, "--help"]);
        let examples = own.split_once("Examples:\n  ancf ").map(|(_, examples)| examples).unwrap_or_default();
        assert!(format!("  ancf {examples}").contains(&format!("  ancf {command}")), "{command}: {own}");
        assert!(own.lines().all(|line| line.chars().count() <= 100), "{command}: {own}");
    }
    let tour = help.lines().skip_while(|line| *line != "A first tour:").skip(1).take(4);
    for line in tour {
        // Words, up to the gap before what they do.
        let line = line.trim_start().split("   ").next().unwrap();
        bench.printed(&line.split_whitespace().skip(1).collect::<Vec<_>>());
    }
}

#[test]
fn shells_complete() {
    let bench = Bench::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = bench.printed(&["completions", shell]);
        let knows = |word: &str| script.contains(word);
        assert!(
            ["ancf", "resume", "--checkpoint"].into_iter().all(|word| knows(word.trim_start_matches("--")))
        );
        // Two of them complete no values.
        let values = ["cantilever", "buckling"].into_iter().all(knows);
        assert!(values || ["powershell", "elvish"].contains(&shell), "{shell}");
    }
    bench.write("ancf.bash", &bench.printed(&["completions", "bash"]));
    let script =
        "source ./ancf.bash; COMP_WORDS=(ancf res); COMP_CWORD=1; _ancf ancf res ancf; echo ${COMPREPLY[@]}";
    let Ok(done) = Command::new("bash").args(["-c", script]).current_dir(bench.path("")).output() else {
        return;
    };
    assert_eq!(String::from_utf8_lossy(&done.stdout).trim(), "resume");
}

#[test]
fn there_is_a_page_of_each_command() {
    let bench = Bench::new();
    let page = bench.printed(&["man"]);
    assert!(
        page.contains(".TH ancf 1") && page.contains("ancf\\-run(1)") && page.contains("A first tour"),
        "{page}"
    );
    bench.printed(&["man", "pages/man1"]);
    assert_eq!(bench.read("pages/man1/ancf.1"), page);
    let pages = fs::read_dir(bench.path("pages/man1")).unwrap().count();
    assert!(pages >= 13, "{pages}");
    let run = bench.read("pages/man1/ancf-run.1");
    assert!(run.contains("checkpoint") && run.contains("models/elastica.toml"), "{run}");
}
