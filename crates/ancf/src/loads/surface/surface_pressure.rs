use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::Finding;
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{TimeFunction, region_of_shell, shell_body};
use crate::units::Scaled;

/// Pressure on a shell, a load that follows its normal and its area.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct SurfacePressure {
    /// Name of the shell.
    pub body: String,
    /// Force per deformed area along the normal, which is that of u and v, or of the order of the nodes of elements, by the right-hand rule; force/length². Negative values act
    /// against the normal.
    #[unit(force / length^2)]
    pub pressure: f64,
    /// Name of a group of elements of a shear-deformable shell on which the load acts; the whole shell by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for SurfacePressure {
    fn noun(&self) -> &'static str {
        "pressure"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let function = builder.function(&self.time);
        for patch in builder.patches(&self.body, self.region.as_deref(), Vector3::zeros()) {
            builder.add_boxed(patch.pressure(self.pressure, &function));
        }
    }

    fn bodies(&self) -> Vec<(String, &str)> {
        vec![("body".into(), &self.body)]
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    fn is_follower(&self) -> bool {
        true
    }

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let region = region_of_shell(path, self.region.as_deref(), context.body(&self.body));
        shell_body(path, context.body(&self.body)).or(region).into_iter().collect()
    }
}
