use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::Finding;
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{TimeFunction, region_of_shell, shell_body};
use crate::units::Scaled;

/// Force per area of a shell, of constant direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct SurfaceForce {
    /// Name of the shell.
    pub body: String,
    /// Force per undeformed area in the global frame, force/length².
    #[unit(force / length^2)]
    pub force: [f64; 3],
    /// Name of a group of elements of a shear-deformable shell on which the load acts; the whole shell by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for SurfaceForce {
    fn noun(&self) -> &'static str {
        "force per area"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let function = builder.function(&self.time);
        if let Some((mesh, shell)) = builder.shear_shell(&self.body) {
            for element in shell.region(self.region.as_deref()).unwrap_or_default() {
                builder.force(mesh.area_marker(element), self.force, function.clone());
            }
            return;
        }
        let Some(mesh) = builder.shell(&self.body) else { return };
        for marker in mesh.area_markers() {
            builder.force(marker, self.force, function.clone());
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

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let region = region_of_shell(path, self.region.as_deref(), context.body(&self.body));
        shell_body(path, context.body(&self.body)).or(region).into_iter().collect()
    }
}
