//! Colours, and messages of rejected commands.

use crate::folder::{CommandOutput, TestFolder};

fn has_colours(text: &str) -> bool {
    text.contains("\u{1b}[")
}

/// Options, a variable, and true for colours.
type ColourCase<'a> = (&'a [&'a str], Option<(&'a str, &'a str)>, bool);

/// Files and pipes have no colours by default. `--color`, `NO_COLOR` and other variables override this.
#[test]
fn colours_follow_options_and_variables() {
    let folder = TestFolder::with_run("statics");
    folder.write("bad.toml", "gravity = 3\n");
    let cases: [ColourCase<'_>; 8] = [
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
    for (options, variable, expected) in cases {
        for command in commands {
            let arguments = [options, command].concat();
            let output = CommandOutput::new(&folder.command(&arguments).envs(variable).output().unwrap());
            let text = output.printed + &output.messages;
            assert_eq!(has_colours(&text), expected, "{arguments:?} {variable:?}: {text}");
        }
    }
}

#[test]
fn rejected_commands_print_one_line() {
    let folder = TestFolder::with_run("statics");
    let cases: [(&[&str], i32, &str); 8] = [
        (&["run", "no.toml", "-o", "x"], 2, "no.toml: no such file\n"),
        (&["run", "out", "-o", "x"], 2, "out: a directory, not a model file\n"),
        (
            &["run", "model.toml", "-o", "model.toml"],
            2,
            "error: model.toml is a file, expected a folder for the results\n",
        ),
        (&["check", "no.toml"], 2, "no.toml: no such file\n"),
        (&["resume", "nowhere"], 2, "error: nowhere contains no run: there is no model.toml\n"),
        (&["resume", "."], 2, "error: . contains no run: there is a model.toml and no results\n"),
        (&["resume", "out"], 0, "out is finished: there is nothing to do\n"),
        (&["plot", "out", "-o", "tip.svg"], 2, "error: no columns given; `ancf plot DIR` lists them\n"),
    ];
    for (arguments, code, line) in cases {
        let output = folder.ancf(arguments);
        assert_eq!((output.code, output.messages.as_str()), (Some(code), line), "{arguments:?}");
        assert_eq!(output.printed, "", "{arguments:?}");
    }
    assert!(!folder.path("x").exists(), "bad input creates no folder");
    assert!(folder.read("model.toml").starts_with("# "), "a model alone is not a run");
}

/// A folder that cannot be created, not even by root.
#[cfg(target_os = "linux")]
#[test]
fn results_that_cannot_be_written_are_reported() {
    let folder = TestFolder::with_run("statics");
    for place in ["/proc/none", "model.toml/below"] {
        let output = folder.ancf(&["run", "model.toml", "-o", place]);
        assert_eq!(output.code, Some(1), "{}", output.messages);
        let start = format!("error: results could not be written: {place}: ");
        assert!(
            output.messages.starts_with(&start) && output.messages.lines().count() == 1,
            "{}",
            output.messages
        );
    }
    let figure = folder.ancf(&["plot", "out", "tip", "-o", "no/such/folder.svg"]);
    assert!(
        figure.code == Some(1) && figure.messages.starts_with("error: cannot write no/such/folder.svg: ")
    );
}
