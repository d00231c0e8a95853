//! Text of the program: plots, colours, characters, scripts of shells.

use super::trial::{Ended, Trial, expect, finish};
use crate::system::shell::Done;

pub(super) fn plot(trial: &Trial<'_>) -> Done {
    let listed = trial.done(&["plot", "cantilever"])?.stdout;
    expect(listed.contains("tip.y"), "the columns", listed)?;
    let plotted = trial.done(&["plot", "cantilever", "tip.y"])?.stdout;
    expect(plotted.lines().count() > 8, "a chart", &plotted)?;
    trial.write("chart.txt", plotted)
}

pub(super) fn plot_files(trial: &Trial<'_>) -> Done {
    for (ending, start) in [("svg", &b"<svg"[..]), ("png", b"\x89PNG"), ("pdf", b"%PDF")] {
        let name = format!("Bild ö.{ending}");
        trial.done(&["plot", "cantilever", "tip.y", "-o", &name])?;
        let bytes = trial.read(&name)?;
        expect(bytes.windows(start.len()).take(200).any(|window| window == start), "a figure", &name)?;
    }
    Ok(())
}

/// Colours are codes of ANSI on request and on terminals, not in files and pipes.
pub(super) fn colours(trial: &Trial<'_>) -> Done {
    let check = |options: &[&str], variable: Option<(&str, &str)>| -> Result<Ended, String> {
        let arguments = [&["check", "falsch für alle.toml"], options].concat();
        let mut command = trial.program.command(&trial.folder, &arguments);
        command.envs(variable);
        finish(command)
    };
    for (options, variable, is_coloured) in [
        (&[][..], None, false),
        (&["--color", "always"], None, true),
        (&["--color", "never"], Some(("FORCE_COLOR", "1")), false),
        (&[], Some(("FORCE_COLOR", "1")), true),
        (&[], Some(("NO_COLOR", "1")), false),
    ] {
        let ended = check(options, variable)?;
        let found = ended.stderr.contains('\u{1b}');
        expect(found == is_coloured, &format!("colours: {is_coloured} by {options:?} {variable:?}"), ended)?;
    }
    Ok(())
}

/// Text is UTF-8 in pipes and files. Lines end with LF.
pub(super) fn unicode(trial: &Trial<'_>) -> Done {
    let listed = trial.done(&["check", "Träger Größe 数.toml"])?;
    let text = listed.stdout + &listed.stderr;
    expect(!text.contains('\u{fffd}') && !text.contains('\r'), "UTF-8", &text)?;
    // The chart has line characters outside of ASCII.
    let chart = trial.text("chart.txt")?;
    expect(!chart.is_ascii() && !chart.contains('\r'), "line characters", chart)
}

pub(super) fn completions(trial: &Trial<'_>) -> Done {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = trial.done(&["completions", shell])?.stdout;
        expect(script.contains("paraview"), "all commands", &script)?;
        trial.write(&format!("completions.{shell}"), script)?;
    }
    Ok(())
}

pub(super) fn man(trial: &Trial<'_>) -> Done {
    trial.done(&["man", "Handbuch ü"])?;
    let page = trial.text("Handbuch ü/ancf-run.1")?;
    expect(page.contains(".TH") && !page.contains('\r'), "a manual page", page)
}
