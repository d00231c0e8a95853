//! Builds of the program and of the library inside FMUs.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::release::Release;
use crate::system::shell::{Done, run, say};

/// Files of a build.
#[derive(Clone, Debug)]
pub(crate) struct Built {
    /// Program `ancf`.
    pub(crate) program: PathBuf,
    /// Library that `ancf fmu` packs. Static programs have none of their own.
    pub(crate) library: Option<PathBuf>,
}

/// Builds the program from a folder of sources, for a target of rustup or for this machine.
pub(crate) fn program(release: &Release, source: &Path, target: Option<&str>) -> Result<Built, String> {
    let target_folder = build_folder(release);
    let is_static = target.is_some_and(|target| target.ends_with("musl"));
    let mut command = Command::new(env!("CARGO"));
    command.args(["build", "--locked", "--package", "ancf-cli", "--profile", &release.profile]);
    if !is_static {
        command.args(["--package", "ancf-fmu"]);
    }
    if let Some(target) = target {
        command.args(["--target", target]);
    }
    command.envs(variables(release, source)).current_dir(source);
    say(&format!("\n== program for {} by profile {}", target.unwrap_or("this machine"), release.profile));
    run("program", &mut command)?;
    let profile = if release.profile == "dev" { "debug" } else { &release.profile };
    let folder = target_folder.join(target.unwrap_or_default()).join(profile);
    let is_windows = target.map_or(cfg!(windows), |target| target.contains("windows"));
    let file = |unix: &str, windows: &str| folder.join(if is_windows { windows } else { unix });
    let library = match env::consts::OS {
        "macos" if target.is_none() => "libancf_fmu.dylib",
        _ => "libancf_fmu.so",
    };
    Ok(Built {
        program: file("ancf", "ancf.exe"),
        library: (!is_static).then(|| file(library, "ancf_fmu.dll")),
    })
}

fn build_folder(release: &Release) -> PathBuf {
    release.work.join("build")
}

/// Variables of all builds: one folder of compiled crates, and messages of failures that name no folder of this machine.
pub(crate) fn variables(release: &Release, source: &Path) -> [(&'static str, OsString); 2] {
    let folder = build_folder(release).into_os_string();
    [("CARGO_TARGET_DIR", folder), ("CARGO_ENCODED_RUSTFLAGS", remapped(source).into())]
}

/// Flags of the compiler that replace folders of this machine in messages.
fn remapped(source: &Path) -> String {
    let home = env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
    let cargo = env::var_os("CARGO_HOME").map_or_else(|| home.join(".cargo"), PathBuf::from);
    let pairs = [(source, "/ancf"), (&cargo, "/cargo")];
    let flags = pairs.map(|(from, to)| format!("--remap-path-prefix={}={to}", from.display()));
    flags.join("\u{1f}")
}

/// Installs a target by rustup.
pub(crate) fn install_target(target: &str) -> Done {
    let installed = Command::new("rustup").args(["target", "list", "--installed"]).output();
    if installed
        .is_ok_and(|output| String::from_utf8_lossy(&output.stdout).lines().any(|line| line == target))
    {
        return Ok(());
    }
    let added = Command::new("rustup").args(["target", "add", target]).output();
    match added {
        Ok(output) if output.status.success() => Ok(()),
        _ => Err(format!("the target {target} is missing and rustup cannot install it")),
    }
}

/// Target of this machine.
pub(crate) fn host() -> Result<String, String> {
    let output =
        Command::new("rustc").arg("-vV").output().map_err(|error| format!("cannot run rustc: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let host = text.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned).ok_or_else(|| "rustc states no host".to_owned())
}
