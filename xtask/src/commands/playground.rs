//! The playground: solver, editor and viewer as a static page.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::viewer;
use crate::system::debian;
use crate::system::shell::{Done, cargo, root, run, say};

/// Target of the compiler.
const TARGET: &str = "wasm32-unknown-unknown";
/// Packages of Debian with a compiler and the source of its standard library, for machines whose rustup has no access to the
/// target.
const PACKAGES: [&str; 2] = ["rustc-web", "rust-web-src"];

/// Builds the page into `target/playground`.
pub(crate) fn build() -> Done {
    let module = compile()?;
    let bindings = root().join("target/playground-bindings");
    let [from, to] = [&module, &bindings].map(|path| path.display().to_string());
    let writer = ["run", "--package", "xtask", "--features", "bindings", "--example", "bindings", "--"];
    cargo("bindings", &[&writer[..], &[&from, &to]].concat(), &[])?;
    let out = root().join("target/playground");
    viewer::playground(&out, &bindings)?;
    say(&format!("the playground is in {}; serve the folder by any web server", out.display()));
    Ok(())
}

/// Compiles the module and returns its path.
fn compile() -> Result<PathBuf, String> {
    let arguments = ["build", "--release", "--package", "ancf-web", "--target", TARGET];
    say(&format!("\n== module: cargo {}", arguments.join(" ")));
    let (mut command, folder) = if has_target() {
        (Command::new(env!("CARGO")), root().join("target"))
    } else {
        (by_debian()?, root().join("target/debian"))
    };
    command.args(arguments).args(small());
    command.arg("--target-dir").arg(&folder).current_dir(root());
    command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128");
    run("module", &mut command)?;
    Ok(folder.join(TARGET).join("release/ancf_web.wasm"))
}

/// Optimises crates without hot loops for size, and all crates together: the module is transferred.
fn small() -> impl Iterator<Item = String> {
    let own = ["ancf", "ancf-report", "ancf-surface", "ancf-web"];
    let formats =
        ["csv", "gltf-json", "nom", "postcard", "quick-xml", "roxmltree", "schemars", "serde_json", "stl_io"];
    let more = [
        "base64",
        "csv-core",
        "flate2",
        "lz4_flex",
        "memchr",
        "miniz_oxide",
        "rayon-core",
        "sha2",
        "toml",
        "toml_datetime",
        "toml_edit",
        "toml_parser",
        "toml_writer",
        "vtkio",
        "winnow",
        "zmij",
    ];
    let option = |name| format!("profile.release.package.{name}.opt-level=\"s\"");
    let together = ["profile.release.lto=\"fat\"", "profile.release.codegen-units=1"].map(str::to_owned);
    let options = own.into_iter().chain(formats).chain(more).map(option).chain(together);
    options.flat_map(|option| ["--config".to_owned(), option])
}

/// Installs the target by rustup, if possible.
fn has_target() -> bool {
    let added = Command::new("rustup").args(["target", "add", TARGET]).status();
    added.is_ok_and(|status| status.success())
}

/// Returns the call of Debian's compiler, which builds its standard library too, with the linker of the toolchain.
fn by_debian() -> Result<Command, String> {
    let missing = || format!("the target {TARGET} is missing; run: rustup target add {TARGET}");
    if !Path::new("/usr/lib/rustlib/src/rust/library").exists()
        && !PACKAGES.iter().all(|p| debian::install(p))
    {
        return Err(missing());
    }
    let mut command = Command::new("/usr/bin/cargo");
    command.args(["-Z", "build-std=std,panic_abort"]);
    command.env("RUSTC", "/usr/bin/rustc").env("RUSTC_BOOTSTRAP", "1").env_remove("RUSTUP_TOOLCHAIN");
    command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker().ok_or_else(missing)?);
    Ok(command)
}

/// Linker of the toolchain that runs this program.
fn linker() -> Option<PathBuf> {
    let output = Command::new("rustc").args(["--print", "sysroot"]).output().ok()?;
    let sysroot = PathBuf::from(String::from_utf8(output.stdout).ok()?.trim());
    let host = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    Some(sysroot.join("lib/rustlib").join(host).join("bin/rust-lld")).filter(|linker| linker.exists())
}
