//! Crates for crates.io: complete manifests, and a publication that is only tried.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::release::Release;
use crate::system::shell::{Done, root, run, say};

/// Limit of crates.io on the size of a crate, in bytes.
const MAX_SIZE: u64 = 10 * 1024 * 1024;
/// Domain that nobody can own (RFC 2606). An address in it is a placeholder.
const RESERVED: &str = ".example/";

/// Packs all crates that are published and compiles each of them from its package, without publishing.
pub(crate) fn publish_dry_run(release: &Release, source: &Path) -> Done {
    check_manifests()?;
    let folder = release.work.join("crates");
    let mut command = Command::new(env!("CARGO"));
    command.args(["publish", "--workspace", "--dry-run", "--locked", "--target-dir"]).arg(&folder);
    // The crates are compiled, not run.
    command.env("CARGO_PROFILE_DEV_DEBUG", "false");
    say("\n== crates: cargo publish --workspace --dry-run");
    run("crates", command.current_dir(source))?;
    for name in published()?.iter().filter_map(|package| package["name"].as_str()) {
        // The location depends on the version of cargo.
        let file = format!("{name}-{}.crate", release.version);
        let places = ["package", "package/tmp-crate", "package/tmp-registry"];
        let place = places.iter().map(|place| folder.join(place).join(&file)).find(|place| place.exists());
        let file = place.ok_or_else(|| format!("cargo left no file {file}"))?;
        let size = std::fs::metadata(&file).map_err(|error| format!("{}: {error}", file.display()))?.len();
        if size > MAX_SIZE {
            return Err(format!("{} has {size} bytes, crates.io accepts {MAX_SIZE}", file.display()));
        }
        super::release::copy(&file, &release.packages.join(file.file_name().unwrap_or_default()))?;
    }
    Ok(())
}

/// Checks that the manifests of published crates state all that crates.io and docs.rs show.
pub(crate) fn check_manifests() -> Done {
    let packages = published()?;
    let mut missing = Vec::new();
    for package in &packages {
        let name = package["name"].as_str().unwrap_or_default();
        for key in ["description", "license", "readme", "repository", "rust_version"] {
            if package[key].as_str().is_none_or(str::is_empty) {
                missing.push(format!("{name}: {key}"));
            }
        }
        for key in ["keywords", "categories"] {
            if package[key].as_array().is_none_or(Vec::is_empty) {
                missing.push(format!("{name}: {key}"));
            }
        }
        if package["metadata"]["docs"]["rs"].is_null() {
            missing.push(format!("{name}: package.metadata.docs.rs"));
        }
        for dependency in package["dependencies"].as_array().into_iter().flatten() {
            let is_versioned = dependency["req"].as_str().is_some_and(|version| version != "*");
            if !is_versioned && dependency["kind"].as_str() != Some("dev") {
                missing.push(format!("{name}: version of {}", dependency["name"]));
            }
        }
    }
    if !missing.is_empty() {
        return Err(format!("manifests of published crates have no\n{}", missing.join("\n")));
    }
    say(&format!("{} crates have complete manifests", packages.len()));
    Ok(())
}

/// Reports a placeholder in the manifests that must be replaced before the first publication.
pub(crate) fn report_placeholders() -> Done {
    let packages = published()?;
    let repository = packages.first().and_then(|package| package["repository"].as_str()).unwrap_or_default();
    if repository.contains(RESERVED) {
        say(&format!(
            "before the first publication: replace the placeholder `repository = \"{repository}\"` in Cargo.toml"
        ));
    }
    Ok(())
}

/// Crates of the workspace that are published.
fn published() -> Result<Vec<Value>, String> {
    let arguments = ["metadata", "--locked", "--no-deps", "--format-version", "1"];
    let output = Command::new(env!("CARGO")).args(arguments).current_dir(root()).output();
    let output = output.map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let metadata: Value =
        serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata: unknown form")?;
    // `publish = false` is an empty list of registries.
    Ok(packages.iter().filter(|package| package["publish"].is_null()).cloned().collect())
}
