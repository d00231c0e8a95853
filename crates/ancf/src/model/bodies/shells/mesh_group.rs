use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Named part of a mesh: nodes, edges or elements, by their numbers from 0. One node is a point, elements are a region.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct MeshGroup {
    /// Nodes.
    #[unit(none)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub nodes: Vec<u32>,
    /// Chains of nodes along edges of elements. A closed chain ends with its first node.
    #[unit(none)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub edges: Vec<Vec<u32>>,
    /// Elements.
    #[unit(none)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub elements: Vec<u32>,
}
