use ancf_mechanics::forces::Moment;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::Finding;
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{EdgeName, TimeFunction, shell_body};
use crate::units::Scaled;

/// Moment per length of an edge of a shell, work-conjugate to the rotation of the surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct EdgeMoment {
    /// Name of the shell.
    pub body: String,
    /// Edge.
    pub edge: EdgeName,
    /// Moment per undeformed length in the global frame, of a follower in the undeformed state; force.
    #[unit(force)]
    pub moment: [f64; 3],
    /// True for a load that rotates with the surface.
    #[serde(default)]
    pub follower: bool,
    /// Function of time that multiplies the load. Statics ignores it.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for EdgeMoment {
    fn noun(&self) -> &'static str {
        "moment per length of an edge"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let Some(mesh) = builder.shell(&self.body) else { return };
        let function = builder.function(&self.time);
        for (at, length) in mesh.edge_points(self.edge.edge()).into_iter().flatten() {
            let (frame, moment) = (mesh.frame(at), Vector3::from(self.moment) * length);
            builder.add(match self.follower {
                false => Moment::new(&frame, moment, function.clone()),
                true => Moment::follower(&frame, moment, function.clone()),
            });
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
        self.follower
    }

    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        shell_body(path, context.body(&self.body)).into_iter().collect()
    }
}
