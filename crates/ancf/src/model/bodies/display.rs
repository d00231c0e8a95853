use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Shape of a rigid body in pictures, in global coordinates of the initial state. It has no effect on the motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum DisplayShape {
    /// Box.
    Box {
        /// Lengths of the edges, length; along the global axes without a rotation.
        #[unit(length)]
        edges: [f64; 3],
        /// Centre of the box, length; the centre of mass by default.
        #[unit(length)]
        #[serde(default, skip_serializing_if = "Option::is_none")]
        center: Option<[f64; 3]>,
        /// Rotation vector about the centre of the box, in radians. Its length is the angle.
        #[unit(radian)]
        #[serde(default)]
        rotation: [f64; 3],
    },
    /// Cylinder with flat ends.
    Cylinder {
        /// Centre of the first end face, length.
        #[unit(length)]
        from: [f64; 3],
        /// Centre of the second end face, length.
        #[unit(length)]
        to: [f64; 3],
        /// Radius, length.
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
    },
    /// Ball.
    Sphere {
        /// Radius, length.
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// Centre of the ball, length; the centre of mass by default.
        #[unit(length)]
        #[serde(default, skip_serializing_if = "Option::is_none")]
        center: Option<[f64; 3]>,
    },
    /// Triangles of a file.
    Mesh {
        /// Path of an STL file (.stl) or a glTF 2.0 file (.gltf, .glb), relative to the folder of the model file.
        #[schemars(length(min = 1))]
        file: String,
        /// Length of the unit of the file: 0.001 for millimetres in a model in metres, length; 1 by default.
        #[unit(length)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        #[serde(default = "one")]
        scale: f64,
        /// Position of the origin of the file, length.
        #[unit(length)]
        #[serde(default)]
        origin: [f64; 3],
        /// Rotation vector about the origin of the file, in radians. Its length is the angle.
        #[unit(radian)]
        #[serde(default)]
        rotation: [f64; 3],
    },
}

const fn one() -> f64 {
    1.0
}

impl DisplayShape {
    /// True if the ending of a file name is that of a supported format.
    pub fn is_mesh_file(name: &str) -> bool {
        let ending = name.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        ending.is_some_and(|ending| ["stl", "gltf", "glb"].contains(&ending.as_str()))
    }
}
