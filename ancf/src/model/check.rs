use super::{Model, ModelError};
impl Model {
    /// stub
    pub fn check(&self) -> Result<(), Vec<ModelError>> {
        Ok(())
    }
}
