use ancf_mechanics::forces::Moment;
use ancf_mechanics::kinematics::SectionFrame;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::errors::Finding;
use crate::loads::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::model::{EdgeName, TimeFunction, edge_of_shell, shell_body};
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
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for EdgeMoment {
    fn noun(&self) -> &'static str {
        "moment per length of an edge"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let function = builder.function(&self.time);
        let frames: Vec<(SectionFrame, f64)> = match builder.shear_shell(&self.body) {
            Some((mesh, shell)) => {
                let edges = shell.edge_segments(&self.edge).into_iter();
                let points = edges.filter_map(|edge| mesh.edge_points(edge)).flatten();
                points.map(|(at, length)| (mesh.frame(at), length)).collect()
            }
            None => {
                let Some(mesh) = builder.shell(&self.body) else { return };
                let points = mesh.edge_points(self.edge.edge()).into_iter().flatten();
                points.map(|(at, length)| (mesh.frame(at), length)).collect()
            }
        };
        for (frame, length) in frames {
            let moment = Vector3::from(self.moment) * length;
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
        let edge = edge_of_shell(format!("{path}.edge"), &self.edge, context.body(&self.body));
        shell_body(path, context.body(&self.body)).or(edge).into_iter().collect()
    }
}
