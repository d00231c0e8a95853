//! Packages of Debian and its derivatives.

use std::process::Command;

use crate::system::shell::say;

/// True if a program is installed.
pub(crate) fn has(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// True if a shared library is installed.
pub(crate) fn has_library(name: &str) -> bool {
    let known = Command::new("/sbin/ldconfig").arg("-p").output();
    known.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).contains(name))
}

/// Installs a package as root or by `sudo` without a password. Returns true on success.
pub(crate) fn install(package: &str) -> bool {
    let run = |program: &str, arguments: &[&str]| {
        say(&format!("\n== {package}: {program} {}", arguments.join(" ")));
        let command = Command::new(program).args(arguments).env("DEBIAN_FRONTEND", "noninteractive").status();
        command.is_ok_and(|status| status.success())
    };
    let install = ["apt-get", "install", "--yes", package];
    let by_sudo = [&["-n"][..], &install].concat();
    if !has("apt-get") {
        return false;
    }
    // Lists that are older than the archive name removed or outdated packages, such as a browser that the tests cannot control.
    let _ = run(install[0], &["update"]);
    run(install[0], &install[1..]) || has("sudo") && run("sudo", &by_sudo)
}
