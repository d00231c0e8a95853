use ancf_mechanics::functions::ForceFunction;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{LoadBuilder, LoadKind};
use crate::model::{Place, TimeMode};
use crate::units::{Scaled, Scales};

/// Force at a point, computed by a function of time, position and velocity of the point.
///
/// The calling program supplies the function; the command line has none. In statics the velocity is 0 and the time is 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct ExternalLoad {
    /// Point of application.
    pub on: Place,
    /// Name by which the program supplies the function.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Units of length, time and force of the model, measured in units of the function; equal by default.
    #[serde(default = "Scales::unit_scales")]
    pub units: Scales,
    /// The supplied function ([`Model::supply_force`](crate::model::Model::supply_force)).
    #[serde(skip)]
    #[unit(none)]
    #[schemars(skip)]
    pub supplied: Option<ForceFunction>,
}

impl ExternalLoad {
    /// Supplied function in the units of the model, for an analysis.
    pub(crate) fn function(&self, time_mode: TimeMode) -> Option<ForceFunction> {
        let own = self.supplied.as_ref()?;
        let own = match time_mode {
            TimeMode::AsGiven => own.clone(),
            TimeMode::AtStart | TimeMode::Zero => own.frozen_at(0.0),
            TimeMode::One => own.frozen_at(1.0),
        };
        Some(own.in_units(self.units.length, self.units.time, self.units.force))
    }
}

impl LoadKind for ExternalLoad {
    fn noun(&self) -> &'static str {
        "external force"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        if let Some(function) = self.function(builder.time_mode()) {
            builder.external_force(&self.on, function);
        }
    }

    fn on(&self) -> Option<&Place> {
        Some(&self.on)
    }

    fn name(&self) -> Option<&str> {
        Some(&self.name)
    }
}
