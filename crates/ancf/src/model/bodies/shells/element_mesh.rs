use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::element_nodes::ElementNodes;
use super::mesh_group::MeshGroup;
use crate::units::Scaled;

/// Mesh of quadrilaterals and triangles: lists of nodes and elements, counted from 0, or a file with them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct ElementMesh {
    /// Path of a mesh file of Gmsh (.msh, version 2.2 or 4.1, text) or VTK (.vtk, .vtu, .vtp), relative to the folder of the model file,
    /// instead of lists.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Length of the unit of the file: 0.001 for millimetres in a model in metres, length; 1 by default.
    #[unit(length)]
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub scale: Option<f64>,
    /// Nodes, length.
    #[unit(length)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub nodes: Vec<[f64; 3]>,
    /// Elements: numbers of four or three nodes each, counter-clockwise seen from the side of the normal.
    #[unit(none)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub elements: Vec<ElementNodes>,
    /// Directions of the directors at all nodes; by default from the normals of the elements.
    #[unit(none)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub directors: Vec<[f64; 3]>,
    /// Named points, edges and regions. Those of a file are its physical groups, or the numbers of its arrays of integers.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub groups: BTreeMap<String, MeshGroup>,
}
