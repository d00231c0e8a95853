use std::path::PathBuf;

use toml::Value;

/// Model of a study without the values of a case.
#[derive(Clone, Debug)]
pub struct BaseModel {
    /// Data of the model file.
    pub data: Value,
    /// Folder of the model file, to which paths of mesh files are relative.
    pub folder: PathBuf,
}
