//! The models of `models/`, each with a line of physics: what its comment promises.
#![cfg(test)]

#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "../common/run.rs"]
mod run;

mod machines;
mod ropes;

use std::path::Path;

use ancf::Model;
use run::Run;

/// A model of `models/`.
fn model(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models").join(name).with_extension("toml");
    Model::read(&path).unwrap_or_else(|errors| {
        panic!("{name}: {:#?}", errors.iter().map(ToString::to_string).collect::<Vec<_>>())
    })
}

/// Runs a model of `models/` to its end.
fn run(name: &str) -> Run {
    Run::of(&model(name))
}
