use ancf_mechanics::shells::ShellMesh;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::edge_name::EdgeName;
use crate::units::Scaled;

/// Point of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Name of the body.
    pub body: String,
    /// Position on the axis, or on a rigid body.
    pub at: At,
    /// Rigid arm from this position, fixed to the section, in the global frame at the start, length; none by default.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[unit(length)]
    pub offset: [f64; 3],
}

fn is_zero(offset: &[f64; 3]) -> bool {
    *offset == [0.0; 3]
}

impl Place {
    /// Place without an arm.
    pub fn new(body: &str, at: At) -> Self {
        Self { body: body.into(), at, offset: [0.0; 3] }
    }
}

/// Position on a body.
///
/// On a beam or a cable: `"start"`, `"center"`, `"end"` or the arc length from the start. On a rigid body: `"center"` or a
/// point. On a thin shell: `[u, v]`, or an edge as the end `a` of a support. On a shear-deformable shell: a point of its middle
/// surface, a node, a named point, or an edge as the end `a` of a support.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(untagged)]
pub enum At {
    /// Named position.
    Named(NamedPosition),
    /// Arc length from the start in the undeformed state, length.
    Length(
        #[unit(length)]
        #[schemars(extend("minimum" = 0))]
        f64,
    ),
    /// Point of a rigid body, or of the middle surface of a shear-deformable shell, in the global frame at the start, length.
    Point(#[unit(length)] [f64; 3]),
    /// Parameters u and v of a point of a shell, from 0 to 1.
    Surface(
        #[unit(none)]
        #[schemars(inner(range(min = 0, max = 1)))]
        [f64; 2],
    ),
    /// Edge of a shell.
    Edge(EdgePlace),
    /// Node of a mesh.
    Node(NodePlace),
    /// Named point of a mesh.
    NamedPoint(PointPlace),
}

/// Node of a mesh as a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct NodePlace {
    /// Number of the node, from 0.
    pub node: u32,
}

/// Named point of a mesh as a place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct PointPlace {
    /// Name of a group of one node.
    pub point: String,
}

/// Edge of a shell as a place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct EdgePlace {
    /// Name of the edge.
    pub edge: EdgeName,
}

impl At {
    /// Parameters (u, v) on a shell: of a point, of the middle, or of the middle of an edge.
    pub(crate) fn on_surface(&self) -> Option<[f64; 2]> {
        match self {
            Self::Named(NamedPosition::Center) => Some([0.5, 0.5]),
            Self::Surface(at) => Some(*at),
            Self::Edge(EdgePlace { edge: EdgeName::Named(_) }) => None,
            Self::Edge(EdgePlace { edge }) => Some(ShellMesh::edge_middle(edge.edge())),
            Self::Named(_) | Self::Length(_) | Self::Point(_) | Self::Node(_) | Self::NamedPoint(_) => None,
        }
    }
}

/// Named positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum NamedPosition {
    /// Start of the axis.
    Start,
    /// Middle of the axis, or centre of mass of a rigid body.
    Center,
    /// End of the axis.
    End,
}
