use std::borrow::Cow;

use ancf_mechanics::shells::Face;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Nodes of an element of a mesh: four of a quadrilateral, or three of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ElementNodes {
    /// Quadrilateral.
    Quad([u32; 4]),
    /// Triangle.
    Triangle([u32; 3]),
}

impl ElementNodes {
    /// Nodes in their order around the element.
    pub fn nodes(&self) -> &[u32] {
        match self {
            Self::Quad(nodes) => nodes,
            Self::Triangle(nodes) => nodes,
        }
    }

    /// Reverses the order of the nodes, and thus the direction of the normal.
    pub fn reverse(&mut self) {
        match self {
            Self::Quad(nodes) => nodes.reverse(),
            Self::Triangle(nodes) => nodes.reverse(),
        }
    }

    /// The element in the theory.
    pub fn face(&self) -> Face {
        match self {
            Self::Quad(nodes) => Face::Quad(nodes.map(|node| node as usize)),
            Self::Triangle(nodes) => Face::Triangle(nodes.map(|node| node as usize)),
        }
    }
}

impl JsonSchema for ElementNodes {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "ElementNodes".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "array",
            "items": generator.subschema_for::<u32>(),
            "minItems": 3,
            "maxItems": 4,
        })
    }
}
