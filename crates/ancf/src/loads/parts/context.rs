use crate::model::{Body, Material, Section};

/// Properties of the model on which checks and terms of a load depend.
pub trait LoadContext {
    /// Body of a name, with its path in the model.
    fn body(&self, name: &str) -> Option<(String, &Body)>;

    /// Section of a name.
    fn section(&self, name: &str) -> Option<&Section>;

    /// Section of a flexible body at a fraction of its length, from 0 to 1.
    fn section_at(&self, body: &Body, fraction: f64) -> Option<Section>;

    /// Material of a name.
    fn material(&self, name: &str) -> Option<&Material>;

    /// Acceleration of gravity.
    fn gravity(&self) -> [f64; 3];

    /// Characteristic length of the model.
    fn length(&self) -> f64;
}
