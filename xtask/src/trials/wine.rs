//! Programs of Windows in Wine.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::program::Program;
use crate::system::debian;
use crate::system::shell::{Done, root, run, say};

/// Linker and compiler of programs of Windows.
const COMPILER: &str = "x86_64-w64-mingw32-gcc";

/// Installs compiler and Wine. The error names what is missing.
pub(crate) fn install() -> Done {
    for (program, packages) in [(COMPILER, &["gcc-mingw-w64-x86-64"][..]), ("wine", &["wine64", "wine"])] {
        if !debian::has(program) && !packages.iter().all(|package| debian::install(package)) {
            return Err(format!(
                "{program} is missing and cannot be installed; package: {}",
                packages.join(", ")
            ));
        }
    }
    Ok(())
}

/// Prepares a program of Windows: environment of Wine, helper program, and a library that old versions of Wine lack.
///
/// The helpers are put into `folder`, and the library beside the program.
pub(crate) fn program(file: &Path, folder: &Path) -> Result<Program, String> {
    let console = folder.join("console.exe");
    compile("console.c", &console, &["-municode"])?;
    let prefix = folder.join("wine");
    let program = Program {
        file: file.to_owned(),
        emulator: Some("wine".into()),
        variables: vec![("WINEPREFIX".to_owned(), prefix.into()), ("WINEDEBUG".to_owned(), "-all".into())],
        console: Some(console),
        home: folder.join("home"),
        pace: 1.0,
    };
    std::fs::create_dir_all(&program.home).map_err(|error| format!("{}: {error}", program.home.display()))?;
    let starts = || {
        program
            .command(folder, &["--version"])
            .stdout(Stdio::null())
            .status()
            .is_ok_and(|status| status.success())
    };
    if !starts() {
        say("this Wine has no ProcessPrng: a stand-in for bcryptprimitives.dll is put beside ancf.exe");
        let beside: PathBuf = file.with_file_name("bcryptprimitives.dll");
        compile("random.c", &beside, &["-shared", "-ladvapi32"])?;
        if !starts() {
            return Err(format!("Wine does not run {}", file.display()));
        }
    }
    Ok(program)
}

fn compile(source: &str, to: &Path, options: &[&str]) -> Done {
    let mut command = Command::new(COMPILER);
    command.args(["-O1", "-Wall", "-o"]).arg(to).arg(root().join("xtask/windows").join(source)).args(options);
    run(source, &mut command)
}
