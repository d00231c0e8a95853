use ancf_mechanics::shells::ShellEdge;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Edge of a shell: one of four of a thin shell, or the name of an edge in the mesh of a shear-deformable shell.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum EdgeName {
    /// Edge u = 0.
    UStart,
    /// Edge u = 1.
    UEnd,
    /// Edge v = 0.
    VStart,
    /// Edge v = 1.
    VEnd,
    /// Name of a group of edges of a mesh.
    #[serde(untagged)]
    Named(String),
}

impl EdgeName {
    /// Edge of the patch of a thin shell. A name is rejected by the checks.
    pub(crate) const fn edge(&self) -> ShellEdge {
        ShellEdge {
            along_v: matches!(self, Self::UStart | Self::UEnd),
            at_end: matches!(self, Self::UEnd | Self::VEnd),
        }
    }

    /// Name in a model file.
    pub fn name(&self) -> &str {
        match self {
            Self::UStart => "u_start",
            Self::UEnd => "u_end",
            Self::VStart => "v_start",
            Self::VEnd => "v_end",
            Self::Named(name) => name,
        }
    }
}
