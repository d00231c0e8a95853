//! Models of the folder `models/` of the repository.

use std::path::Path;

use ancf::Model;

/// A model of `models/`.
pub(crate) fn model(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models").join(name).with_extension("toml");
    Model::read(&path).unwrap_or_else(|errors| {
        panic!("{name}: {:#?}", errors.iter().map(ToString::to_string).collect::<Vec<_>>())
    })
}
