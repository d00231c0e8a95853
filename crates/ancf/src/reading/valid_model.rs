use std::ops::Deref;

use toml::Value;

use crate::errors::ModelErrors;
use crate::model::Model;

/// Model that satisfies the schema and all rules.
///
/// Further steps, such as [`Simulation::of_valid`](crate::Simulation::of_valid), check it no more. The check of a large model takes as
/// long as its assembly. The model cannot be changed; [`into_model`](Self::into_model) returns one that can.
///
/// ```
/// use ancf::Simulation;
/// use ancf::reading::ValidModel;
///
/// let model = ValidModel::parse(
///     r#"
///     bodies = [{ kind = "rigid", name = "box", center = [0, 0, 0], mass = 2, inertia = [1, 1, 1] }]
///     gravity = [0, 0, -9.81]
///     analysis = { kind = "dynamics", duration = 1, step = 0.01 }"#,
/// )?;
/// assert_eq!(model.mass(), 2.0);
/// let simulation = Simulation::of_valid(&model)?;
/// # Ok::<(), ancf::ModelErrors>(())
/// ```
#[derive(Clone, Debug)]
pub struct ValidModel(pub(super) Model);

impl ValidModel {
    /// Checks a model.
    ///
    /// # Errors
    /// All errors of the model, without positions.
    pub fn new(model: Model) -> Result<Self, ModelErrors> {
        model.check()?;
        Ok(Self(model))
    }

    /// Reads the text of a model file, as [`Model::parse`].
    ///
    /// # Errors
    /// All errors of the model, in the order of the text.
    pub fn parse(text: &str) -> Result<Self, ModelErrors> {
        Model::parse(text).map(Self)
    }

    /// Creates a model from data, as [`Model::from_value`].
    ///
    /// # Errors
    /// All errors of the model, without positions.
    pub fn from_value(data: &Value) -> Result<Self, ModelErrors> {
        Model::from_value(data).map(Self)
    }

    /// Returns the model, which can be changed.
    pub fn into_model(self) -> Model {
        self.0
    }
}

impl Deref for ValidModel {
    type Target = Model;

    fn deref(&self) -> &Model {
        &self.0
    }
}
