//! Display geometry of a model file.

use std::path::Path;

use ancf::Model;
use ancf::model::ModelErrors;
use ancf::reading::with_places;
use ancf_surface::BodySurfaces;

/// Reads the surfaces of the rigid bodies of a model file with some text. Mesh files are relative to its folder.
///
/// # Errors
/// One error for each mesh file that cannot be read.
pub fn surfaces_of(model: &Model, text: &str, file: &Path) -> Result<BodySurfaces, ModelErrors> {
    let folder = file.parent().unwrap_or(Path::new(""));
    BodySurfaces::read(model, folder).map_err(|errors| with_places(errors, text))
}
