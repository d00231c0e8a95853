//! Colours, and one clear line for what cannot be done.

use crate::bench::{Bench, Ended};

fn has_colours(text: &str) -> bool {
    text.contains("\u{1b}[")
}

/// Options, a variable, and whether there are colours.
type Wish<'a> = (&'a [&'a str], Option<(&'a str, &'a str)>, bool);

/// Into files and pipes there are none unless they are forced; `NO_COLOR` and `--color` have their say.
#[test]
fn colours_are_where_they_are_wanted() {
    let bench = Bench::with_run("statics");
    bench.write("bad.toml", "gravity = 3\n");
    let cases: [Wish<'_>; 8] = [
        (&[], None, false),
        (&["--color", "always"], None, true),
        (&["--color=never"], Some(("FORCE_COLOR", "1")), false),
        (&[], Some(("FORCE_COLOR", "1")), true),
        (&[], Some(("FORCE_COLOR", "0")), false),
        (&[], Some(("CLICOLOR_FORCE", "1")), true),
        (&[], Some(("NO_COLOR", "1")), false),
        (&["--color", "always"], Some(("NO_COLOR", "1")), true),
    ];
    let commands: [&[&str]; 5] = [
        &["--help"],
        &["check", "bad.toml"],
        &["resume", "nowhere"],
        &["plot", "out", "tip"],
        &["run", "model.toml", "-o", "again"],
    ];
    for (wish, variable, wanted) in cases {
        for command in commands {
            let arguments = [wish, command].concat();
            let ended = Ended::of(&bench.command(&arguments).envs(variable).output().unwrap());
            let text = ended.printed + &ended.said;
            assert_eq!(has_colours(&text), wanted, "{arguments:?} {variable:?}: {text}");
        }
    }
}

#[test]
fn what_cannot_be_done_is_one_clear_line() {
    let bench = Bench::with_run("statics");
    let cases: [(&[&str], i32, &str); 8] = [
        (&["run", "no.toml", "-o", "x"], 2, "no.toml: found no such file, wanted a model file\n"),
        (&["run", "out", "-o", "x"], 2, "out: found a directory, wanted a model file\n"),
        (
            &["run", "model.toml", "-o", "model.toml"],
            2,
            "error: model.toml is a file, wanted a folder for the results\n",
        ),
        (&["check", "no.toml"], 2, "no.toml: found no such file, wanted a model file\n"),
        (&["resume", "nowhere"], 2, "error: nowhere holds no run: there is no model.toml\n"),
        (&["resume", "."], 2, "error: . holds no run: there is a model.toml and no results\n"),
        (&["resume", "out"], 0, "out is finished: there is nothing to do\n"),
        (
            &["plot", "out", "-o", "tip.svg"],
            2,
            "error: which column is to be plotted? `ancf plot DIR` lists them\n",
        ),
    ];
    for (arguments, code, line) in cases {
        let ended = bench.ancf(arguments);
        assert_eq!((ended.code, ended.said.as_str()), (Some(code), line), "{arguments:?}");
        assert_eq!(ended.printed, "", "{arguments:?}");
    }
    assert!(!bench.path("x").exists(), "bad input leaves no folder");
    assert!(bench.read("model.toml").starts_with("# "), "a model alone is no run to go on with");
}

/// A folder that cannot be made, for everybody, root too.
#[cfg(target_os = "linux")]
#[test]
fn results_that_cannot_be_written_are_told() {
    let bench = Bench::with_run("statics");
    for folder in ["/proc/none", "model.toml/below"] {
        let ended = bench.ancf(&["run", "model.toml", "-o", folder]);
        assert_eq!(ended.code, Some(1), "{}", ended.said);
        let start = format!("error: results could not be written: {folder}: ");
        assert!(ended.said.starts_with(&start) && ended.said.lines().count() == 1, "{}", ended.said);
    }
    let figure = bench.ancf(&["plot", "out", "tip", "-o", "no/such/folder.svg"]);
    assert!(figure.code == Some(1) && figure.said.starts_with("error: cannot write no/such/folder.svg: "));
}
