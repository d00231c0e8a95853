//! Models of the folder `models/` of the repository.

use std::path::Path;

use ancf::Model;

/// Reads `models/{name}.toml`.
pub(crate) fn model(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models").join(name).with_extension("toml");
    Model::read(&path).unwrap_or_else(|errors| panic!("{name}: {errors}"))
}
