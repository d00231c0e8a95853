use ancf_mechanics::kinematics::Marker;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::Finding;
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{EdgeName, TimeFunction, edge_of_shell, shell_body};
use crate::units::Scaled;

/// Force per length of an edge of a shell, of constant direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct EdgeForce {
    /// Name of the shell.
    pub body: String,
    /// Edge.
    pub edge: EdgeName,
    /// Force per undeformed length in the global frame, force/length.
    #[unit(force / length)]
    pub force: [f64; 3],
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for EdgeForce {
    fn noun(&self) -> &'static str {
        "force per length of an edge"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let function = builder.function(&self.time);
        if let Some((mesh, shell)) = builder.shear_shell(&self.body) {
            for points in
                shell.edge_segments(&self.edge).into_iter().filter_map(|edge| mesh.edge_points(edge))
            {
                let parts = points.map(|(at, length)| (length, mesh.point(at)));
                let marker = Marker::combined(parts.iter().map(|(length, point)| (*length, point)));
                builder.force(marker, self.force, function.clone());
            }
            return;
        }
        let Some(mesh) = builder.shell(&self.body) else { return };
        for points in mesh.edge_points(self.edge.edge()) {
            let parts = points.map(|(at, length)| (length, mesh.point(at)));
            let marker = Marker::combined(parts.iter().map(|(length, point)| (*length, point)));
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
        let edge = edge_of_shell(format!("{path}.edge"), &self.edge, context.body(&self.body));
        shell_body(path, context.body(&self.body)).or(edge).into_iter().collect()
    }
}
