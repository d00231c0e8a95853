//! The examples in C and C++ are compiled against the shared library and check their results.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// Folder with the shared library of these tests.
fn libraries() -> PathBuf {
    let own = std::env::current_exe().expect("the path of the tests");
    own.parent().expect("the folder of the tests").to_owned()
}

/// Compiles a program and returns its path.
fn compiled(folder: &TempDir, compiler: &str, standard: &str, source: &Path) -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let libraries = libraries();
    let library = libraries.join(format!("{DLL_PREFIX}ancf_c{DLL_SUFFIX}"));
    assert!(library.exists(), "{} is missing", library.display());
    let program = folder.path().join("program");
    let mut command = Command::new(compiler);
    command.args([standard, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1"]);
    command.arg("-I").arg(own.join("include")).arg(source).arg("-o").arg(&program);
    command.arg(&library).arg(format!("-Wl,-rpath,{}", libraries.display())).arg("-lm");
    let output = command.output().expect("the compiler runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    program
}

fn run(compiler: &str, standard: &str, source: &str) {
    let folder = TempDir::new().expect("a temporary folder");
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let program = compiled(&folder, compiler, standard, &examples.join(source));
    let output = Command::new(program).arg(&examples).output().expect("the program runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
}

#[test]
#[cfg(unix)]
fn explicit_coupling_in_c_has_the_order_1() {
    run("cc", "-std=c99", "coupled.c");
}

#[test]
#[cfg(unix)]
fn implicit_coupling_in_cpp_has_the_order_2() {
    run("c++", "-std=c++17", "coupled.cpp");
}
