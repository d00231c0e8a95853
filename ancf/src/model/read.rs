use super::{Model, ModelError};
impl Model {
    /// stub
    pub fn parse(text: &str) -> Result<Self, Vec<ModelError>> {
        toml::from_str(text).map_err(|e| vec![ModelError::new("", e.to_string(), "toml")])
    }
}
/// stub
pub fn schema() {}
