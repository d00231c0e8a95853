//! The container file. Containers cannot be built everywhere, so it is read only.

use std::fs;

use crate::system::shell::{Done, root, say};

/// Checks stages, copied files and the version of the compiler in the container file. Builds nothing.
pub(crate) fn check() -> Done {
    let read = |name: &str| fs::read_to_string(root().join(name)).map_err(|error| format!("{name}: {error}"));
    let text = read("Containerfile")?.replace("\\\n", " ");
    let instructions = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let instructions: Vec<Vec<&str>> = instructions.map(|line| line.split_whitespace().collect()).collect();
    let all = |name: &'static str| instructions.iter().filter(move |words| words[0] == name);
    let stages: Vec<&str> = all("FROM").filter_map(|words| words.get(3).copied()).collect();
    if all("FROM").count() != 2 || stages != ["build"] {
        return Err(format!("Containerfile: expected two stages, the first `AS build`, found {stages:?}"));
    }
    for words in all("COPY") {
        let from = words.iter().find_map(|word| word.strip_prefix("--from="));
        match from {
            Some(stage) if stages.contains(&stage) => {}
            Some(stage) => return Err(format!("Containerfile: no stage {stage}")),
            None => {
                let files = words[1..words.len() - 1].iter().filter(|word| !word.starts_with("--"));
                let missing: Vec<_> = files.filter(|file| !root().join(file).exists()).collect();
                if !missing.is_empty() {
                    return Err(format!("Containerfile copies files that do not exist: {missing:?}"));
                }
            }
        }
    }
    let required = toml_version(&read("Cargo.toml")?)?;
    let image = all("FROM").next().map_or("", |words| words[1]);
    let version = image.split(':').nth(1).and_then(|tag| tag.split('-').next()).unwrap_or_default();
    if minor(version) < minor(&required) {
        return Err(format!("Containerfile has Rust {version}, Cargo.toml requires {required}"));
    }
    for name in ["ENTRYPOINT", "USER", "WORKDIR"] {
        if all(name).count() == 0 {
            return Err(format!("Containerfile has no {name}"));
        }
    }
    say("the container file was read; no container was built");
    Ok(())
}

/// Version of the compiler that the workspace requires.
fn toml_version(manifest: &str) -> Result<String, String> {
    let manifest: toml::Table = manifest.parse().map_err(|error| format!("Cargo.toml: {error}"))?;
    let package = manifest.get("workspace").and_then(|workspace| workspace.get("package"));
    let version = package.and_then(|package| package.get("rust-version")).and_then(toml::Value::as_str);
    version.map(str::to_owned).ok_or_else(|| "Cargo.toml has no rust-version".to_owned())
}

fn minor(version: &str) -> Option<u32> {
    version.split('.').nth(1).and_then(|number| number.parse().ok())
}
