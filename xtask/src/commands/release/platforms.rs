//! Programs for other systems than this one: Windows in Wine, static Linux, ARM in an emulator.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::packages::program::{self, ProgramArchive};
use crate::packages::release::{Release, create};
use crate::packages::{build, source};
use crate::system::debian;
use crate::system::shell::{Done, root, run, say};
use crate::trials::{self, Program, wine};

/// Targets of the compiler.
const WINDOWS: &str = "x86_64-pc-windows-gnu";
const MUSL: &str = "x86_64-unknown-linux-musl";
const ARM: &str = "aarch64-unknown-linux-gnu";

/// `cargo xtask windows [--profile NAME]`.
pub(crate) fn windows(options: &[String]) -> Done {
    try_windows(&Release::new(&profile(options)?)?)
}

/// `cargo xtask musl [--profile NAME]`.
pub(crate) fn musl(options: &[String]) -> Done {
    try_musl(&Release::new(&profile(options)?)?)
}

/// Factor of the durations of motions in quick trials.
const QUICK: f64 = 0.05;

/// `cargo xtask try [--quick] FILE [FOLDER]`: tries a program that exists, one of Windows in Wine. Results are compared with those of an
/// earlier trial in a folder.
pub(crate) fn try_file(options: &[String]) -> Done {
    let (pace, options) = match options {
        [first, rest @ ..] if first == "--quick" => (QUICK, rest),
        all => (1.0, all),
    };
    let (file, reference) = match options {
        [file] => (file, None),
        [file, folder] => (file, Some(Path::new(folder))),
        _ => return Err("expected the path of a program".to_owned()),
    };
    let file = Path::new(file).canonicalize().map_err(|error| format!("{file}: {error}"))?;
    let is_windows = file.extension().is_some_and(|ending| ending == "exe");
    let place =
        root().join("target/packages/work/trials").join(if is_windows { "windows file" } else { "file" });
    create(&place)?;
    let mut program = match is_windows {
        true => wine::install().and_then(|()| wine::program(&file, &place))?,
        false => Program::native(&file, &place.join("home")),
    };
    program.pace = pace;
    trials::run(&file.display().to_string(), &program, &place, reference).map(|_| ())
}

fn profile(options: &[String]) -> Result<String, String> {
    match options {
        [] => Ok("dist".to_owned()),
        [option, name] if option == "--profile" => Ok(name.clone()),
        other => Err(format!("expected --profile NAME, found {}", other.join(" "))),
    }
}

/// Builds the archive of the program for this machine and tries it, once in a run. Returns the folder of the results, to which
/// those of other systems are compared.
pub(super) fn native(release: &Release) -> Result<PathBuf, String> {
    static DONE: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    let run = || {
        let host = build::host()?;
        let source = source::unpacked(release)?;
        let built = build::program(release, &source, None)?;
        let archive = program::write(release, &source, &host, &built, &built.program)?;
        try_archive(release, "the program of this system", &archive, None)
    };
    DONE.get_or_init(run).clone()
}

/// Unpacks an archive and tries its program. Returns the folder of the trial.
fn try_archive(
    release: &Release,
    what: &str,
    archive: &ProgramArchive,
    reference: Option<&Path>,
) -> Result<PathBuf, String> {
    let (file, place) = unpack(release, archive)?;
    let program = Program::native(&file, &place.join("home"));
    trials::run(what, &program, &place, reference)
}

/// Unpacks an archive. Returns the program and the folder of its trial.
fn unpack(release: &Release, archive: &ProgramArchive) -> Result<(PathBuf, PathBuf), String> {
    let place = release.work.join("trials").join(&archive.name);
    let unpacked = place.join("unpacked here");
    let file = archive.unpack(&unpacked)?;
    program::check(&unpacked.join(&archive.name))?;
    Ok((file, place))
}

/// Builds the program for Windows and tries it in Wine. Without Wine, a message states what was not tried.
pub(super) fn try_windows(release: &Release) -> Done {
    if let Err(why) = wine::install().and_then(|()| build::install_target(WINDOWS)) {
        say(&format!("Windows was NOT tried: {why}"));
        return Ok(());
    }
    let source = source::unpacked(release)?;
    let reference = native(release)?;
    let built = build::program(release, &source, Some(WINDOWS))?;
    let native = build::program(release, &source, None)?;
    let archive = program::write(release, &source, WINDOWS, &built, &native.program)?;
    let (file, place) = unpack(release, &archive)?;
    let program = wine::program(&file, &place)?;
    trials::run("Windows in Wine", &program, &place, Some(&reference)).map(|_| ())
}

/// Builds a static program for Linux and tries it.
pub(super) fn try_musl(release: &Release) -> Done {
    if let Err(why) = build::install_target(MUSL) {
        say(&format!("the static program was NOT tried: {why}"));
        return Ok(());
    }
    let source = source::unpacked(release)?;
    let reference = native(release)?;
    let mut built = build::program(release, &source, Some(MUSL))?;
    let native = build::program(release, &source, None)?;
    // Other programs load this library. They are linked dynamically, and so must be the library.
    built.library.clone_from(&native.library);
    is_static(&built.program)?;
    let archive = program::write(release, &source, MUSL, &built, &native.program)?;
    try_archive(release, "the static program", &archive, Some(&reference)).map(|_| ())
}

/// Checks that a program requires no shared library.
fn is_static(program: &Path) -> Done {
    let output =
        Command::new("ldd").arg(program).output().map_err(|error| format!("cannot run ldd: {error}"))?;
    let text =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    match text.contains("statically linked") || text.contains("not a dynamic executable") {
        true => Ok(()),
        false => Err(format!("{} requires shared libraries:\n{text}", program.display())),
    }
}

/// Tests that run on ARM: those of the crates with SIMD kernels, and the comparison of kernels with single terms.
const KERNELS: [&[&str]; 2] = [
    &["--package", "ancf-solver", "--package", "ancf-mechanics", "--lib"],
    &["--package", "ancf", "--test", "it", "--", "elements::", "terms::"],
];

/// Tests the kernels on ARM in an emulator: NEON lanes, and the scalar path.
pub(crate) fn arm() -> Done {
    if !cfg!(target_os = "linux") {
        return Err("the emulator of ARM requires Linux".to_owned());
    }
    let packages = [("aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu"), ("qemu-aarch64", "qemu-user")];
    for (program, package) in packages {
        if !debian::has(program) && !debian::install(package) {
            say(&format!("ARM was NOT tried: {program} is missing; package {package}"));
            return Ok(());
        }
    }
    build::install_target(ARM)?;
    for tests in KERNELS {
        say(&format!("\n== kernels on ARM: cargo test --target {ARM} {}, in qemu", tests.join(" ")));
        let mut command = Command::new(env!("CARGO"));
        command.args(["test", "--target", ARM, "--target-dir"]).arg(root().join("target/packages/work/arm"));
        command.args(tests).current_dir(root());
        command.env("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER", "aarch64-linux-gnu-gcc");
        command
            .env("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER", "qemu-aarch64 -L /usr/aarch64-linux-gnu");
        run("kernels on ARM", &mut command)?;
    }
    Ok(())
}
